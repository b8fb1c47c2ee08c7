//! Plots of the benches, each as SVG and as PNG.

mod dots;
mod growth;
mod work_precision;

pub use dots::{Dots, Row, dots, named};
pub use growth::{Growing, growth};
pub use work_precision::work_precision;

#[cfg(test)]
mod tests {
    use super::{Dots, Growing, Row, dots, growth, work_precision};
    use crate::precision::{Curve, Kind, Point};
    use std::{env, fs};

    #[test]
    fn a_picture_has_its_words_and_its_ticks() {
        let file = env::temp_dir().join(format!("integrator-dots-{}", std::process::id()));
        let picture = Dots {
            title: "Ratios".to_owned(),
            series: vec!["generated".to_owned()],
            band: [0.9, 1.1],
            rows: vec![Row { name: "pendulum".to_owned(), values: vec![3.2] }],
            ..Dots::default()
        };
        dots(&file, &picture).expect("two files");
        let text = fs::read_to_string(file.with_extension("svg")).expect("text");
        for word in ["Ratios", "generated", "pendulum", "3.20", ">1<", ">2<"] {
            assert!(text.contains(word), "{word} is missing in {text}");
        }
        assert!(fs::metadata(file.with_extension("png")).expect("a picture").len() > 1_000);
        for extension in ["svg", "png"] {
            fs::remove_file(file.with_extension(extension)).expect("a file");
        }
    }

    /// Every curve has a label, even if there are more curves than colours, and curves of other crates are
    /// distinguishable.
    #[test]
    fn curves_of_other_crates_have_distinct_names_and_styles() {
        let file = env::temp_dir().join(format!("integrator-work-{}", std::process::id()));
        let curve = |i: i32| {
            let points = [1.0, 2.0].map(|t| Point { milliseconds: t, energy: 1e-3 / t, global: 1e-3 / t });
            Curve { method: format!("method {i}"), ours: i == 0, points: points.to_vec() }
        };
        work_precision(&file, "Work", &(0..10).map(curve).collect::<Vec<_>>(), Kind::Energy).expect("two files");
        let text = fs::read_to_string(file.with_extension("svg")).expect("text");
        for i in 0..10 {
            assert!(text.contains(&format!(">method {i}<")), "method {i} is missing in {text}");
        }
        let strokes = text.split("stroke=\"").skip(1).filter_map(|rest| Some(rest.split_once('"')?.0));
        let colours: std::collections::BTreeSet<_> = strokes.collect();
        // Eight colours of other crates (the ninth curve reuses one), one of this library, the grid and the axes.
        assert_eq!(colours.len(), 8 + 1 + 2, "{colours:?}");
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
        for word in ["Errors", "pendulum", "solar", "steps", ">10⁵<"] {
            assert!(text.contains(word), "{word} is missing in {text}");
        }
        let [curves, discs, squares] = ["<polyline", "<circle", "<polygon"].map(|shape| text.matches(shape).count());
        assert_eq!((discs, squares), (8, 8), "a marker for every point");
        assert!(curves >= 4, "{curves} lines: a curve and a walk for each problem");
        for extension in ["svg", "png"] {
            fs::remove_file(file.with_extension(extension)).expect("a file");
        }
    }
}
