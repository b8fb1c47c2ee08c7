//! Pictures, each as SVG and as PNG. Axes are logarithmic: coordinates are decimal logarithms.

mod dots;
mod growth;
mod work_precision;

pub use dots::{Dots, Row, dots};
pub use growth::{Growing, growth};
pub use work_precision::work_precision;

use plotters::{
    coord::{Shift, types::RangedCoordf64},
    prelude::*,
    style::{FontStyle, register_font},
};
use std::{error::Error, fs, ops::Range, path::Path};

const FONT: &str = "sans-serif";
const INK: RGBColor = RGBColor(40, 40, 40);
const PALE: RGBColor = RGBColor(226, 226, 226);

/// Colours that people with any vision tell apart (Okabe and Ito), without the yellow that white swallows.
const COLOURS: [RGBColor; 8] = [
    RGBColor(30, 30, 30),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(213, 94, 0),
    RGBColor(204, 121, 167),
    RGBColor(0, 158, 115),
    RGBColor(0, 114, 178),
    RGBColor(140, 86, 60),
];

type Outcome = Result<(), Box<dyn Error>>;

/// What is drawn onto either kind of file.
trait Picture {
    fn size(&self) -> (u32, u32);
    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Outcome
    where
        B::ErrorType: 'static;
}

/// Writes `<file>.svg` and `<file>.png`.
fn write(file: &Path, picture: &impl Picture) -> Outcome {
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder)?;
    }
    for (style, font) in [(FontStyle::Normal, dejavu::sans::regular()), (FontStyle::Bold, dejavu::sans::bold())] {
        register_font(FONT, style, font).map_err(|_| "a font that cannot be read")?;
    }
    let (svg, png) = (file.with_extension("svg"), file.with_extension("png"));
    let area = SVGBackend::new(&svg, picture.size()).into_drawing_area();
    picture.draw(&area)?;
    area.present()?;
    drop(area);
    let area = BitMapBackend::new(&png, picture.size()).into_drawing_area();
    picture.draw(&area)?;
    Ok(area.present()?)
}

/// The title, and under it what is better.
fn head<B: DrawingBackend>(area: &DrawingArea<B, Shift>, title: &str, better: &str) -> Outcome
where
    B::ErrorType: 'static,
{
    area.fill(&WHITE)?;
    area.draw_text(title, &(FONT, 24, FontStyle::Bold).into_font().color(&INK), (24, 16))?;
    area.draw_text(better, &(FONT, 16).into_font().color(&INK.mix(0.75)), (24, 48))?;
    Ok(())
}

/// Two logarithmic axes, drawn and named.
type Chart<'a, B> = ChartContext<'a, B, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// The least and the greatest of some coordinates, with room before and behind.
fn range(coordinates: impl Iterator<Item = f64>, before: f64, behind: f64) -> Range<f64> {
    let (least, most) =
        coordinates.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)));
    least - before..most + behind
}

/// The axes of these ranges, under the head, with so many pixels free on the right.
fn axes<'a, B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    [x, y]: [Range<f64>; 2],
    right: i32,
    [along, up]: [&str; 2],
) -> Result<Chart<'a, B>, Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    // At most a label for every power of ten, so that there are none between them.
    let [decades_along, decades_up] = [&x, &y].map(|range| (range.end - range.start) as usize + 1);
    let mut chart = ChartBuilder::on(area)
        .margin_top(84)
        .margin_right(right)
        .margin_left(12)
        .margin_bottom(10)
        .x_label_area_size(56)
        .y_label_area_size(84)
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .x_labels(decades_along)
        .y_labels(decades_up)
        .x_label_formatter(&|x| power(*x))
        .y_label_formatter(&|y| power(*y))
        .x_desc(along)
        .y_desc(up)
        .axis_desc_style((FONT, 17).into_font().color(&INK))
        .label_style((FONT, 16).into_font().color(&INK))
        .bold_line_style(PALE)
        .light_line_style(WHITE)
        .axis_style(INK)
        .draw()?;
    Ok(chart)
}

/// A power of ten: as a number while that is short, else with an exponent.
fn power(logarithm: f64) -> String {
    let exponent = logarithm.round();
    if (logarithm - exponent).abs() > 1e-6 {
        return String::new();
    }
    match exponent as i32 {
        exponent @ 0..=4 => format!("{}", 10_u32.pow(exponent.unsigned_abs())),
        exponent @ -3..=-1 => format!("{:.*}", exponent.unsigned_abs() as usize, 10.0_f64.powi(exponent)),
        exponent => {
            let superscript = |digit: char| match digit {
                '-' => '⁻',
                '1' => '¹',
                '2' => '²',
                '3' => '³',
                '0' => '⁰',
                digit => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
            };
            format!("10{}", exponent.to_string().chars().map(superscript).collect::<String>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Dots, Growing, Row, dots, growth, power};
    use std::{env, fs};

    #[test]
    fn powers_are_short() {
        let cases = [(-12.0, "10⁻¹²"), (-2.0, "0.01"), (0.0, "1"), (3.0, "1000"), (7.0, "10⁷"), (0.5, "")];
        for (logarithm, text) in cases {
            assert_eq!(power(logarithm), text);
        }
    }

    #[test]
    fn a_picture_has_its_words_and_its_ticks() {
        let file = env::temp_dir().join(format!("integrator-dots-{}", std::process::id()));
        let picture = Dots {
            title: "Ratios".to_owned(),
            series: vec!["generated".to_owned()],
            asked: [0.9, 1.1],
            rows: vec![Row { name: "pendulum".to_owned(), values: vec![3.2] }],
            ..Dots::default()
        };
        dots(&file, &picture).expect("two files");
        let text = fs::read_to_string(file.with_extension("svg")).expect("text");
        for word in ["Ratios", "generated", "pendulum", "3.20", "\n1\n", "\n2\n"] {
            assert!(text.contains(word), "{word} is missing in {text}");
        }
        assert!(fs::metadata(file.with_extension("png")).expect("a picture").len() > 1_000);
        for extension in ["svg", "png"] {
            fs::remove_file(file.with_extension(extension)).expect("a file");
        }
    }

    #[test]
    fn a_growth_has_a_curve_and_a_walk_for_each_problem() {
        let file = env::temp_dir().join(format!("integrator-growth-{}", std::process::id()));
        let problem = |name: &str, size: f64| {
            let points = (0..8).map(|i| (10.0_f64.powi(i), size * 3.0_f64.powi(i))).collect();
            Growing { name: name.to_owned(), points }
        };
        growth(&file, "Errors", &[problem("pendulum", 1e-16), problem("solar", 1e-15)]).expect("two files");
        let text = fs::read_to_string(file.with_extension("svg")).expect("text");
        for word in ["Errors", "pendulum", "solar", "steps", "\n10⁵\n"] {
            assert!(text.contains(word), "{word} is missing in {text}");
        }
        let (curves, points) = (text.matches("<polyline").count(), text.matches("<circle").count());
        assert_eq!(points, 16, "a dot for every look");
        assert!(curves >= 4, "{curves} lines: a curve and a walk for each problem");
        for extension in ["svg", "png"] {
            fs::remove_file(file.with_extension(extension)).expect("a file");
        }
    }
}
