//! Ratios as dots in rows, on a logarithmic axis.

use integrator_plot::{
    Canvas, Colour, Marker, Outcome, Picture, Stroke, bold,
    colour::{COLOURS, INK, PALE},
    font, head, write,
};
use std::path::Path;

/// A picture of ratios.
#[derive(Clone, Debug, Default)]
pub struct Dots {
    /// What is shown.
    pub title: String,
    /// What is better.
    pub better: String,
    /// What stands along the axis.
    pub axis: String,
    /// What each dot of a row is.
    pub series: Vec<String>,
    /// From here to there all is well: the band is tinted.
    pub asked: [f64; 2],
    /// From top to bottom.
    pub rows: Vec<Row>,
}

/// A row of dots.
#[derive(Clone, Debug)]
pub struct Row {
    /// What it is about.
    pub name: String,
    /// One number per series; none is drawn where it is NaN.
    pub values: Vec<f64>,
}

/// Draws `<file>.svg` and `<file>.png`.
///
/// # Errors
/// If a file cannot be written.
pub fn dots(file: &Path, dots: &Dots) -> Outcome {
    write(file, dots)
}

const TOP: f64 = 118.0;
const ROW: f64 = 26.0;
const NAMES: f64 = 340.0;
const WIDTH: f64 = 1100.0;
const MARGIN: f64 = 70.0;
/// The colours of the series: the first is what the picture is about.
const SERIES: [Colour; 3] = [COLOURS[6], Colour(160, 160, 160), COLOURS[3]];
/// Numbers that an axis may show.
const TICKS: [f64; 19] =
    [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 0.8, 0.9, 1.0, 1.1, 1.2, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0];

impl Dots {
    fn numbers(&self) -> impl Iterator<Item = f64> {
        let values = self.rows.iter().flat_map(|row| &row.values).copied();
        values.chain(self.asked).chain([1.0]).filter(|value| value.is_finite() && *value > 0.0)
    }

    /// Where a number lies along the axis.
    fn scale(&self) -> impl Fn(f64) -> f64 {
        let least = self.numbers().fold(f64::INFINITY, f64::min).ln() - 0.05;
        let most = self.numbers().fold(0.0, f64::max).ln() + 0.05;
        move |value| NAMES + (WIDTH - NAMES - MARGIN) * (value.ln() - least) / (most - least)
    }
}

impl Picture for Dots {
    fn size(&self) -> (u32, u32) {
        (WIDTH as u32, (TOP + ROW * self.rows.len() as f64) as u32 + 70)
    }

    fn draw(&self, canvas: &mut Canvas) {
        head(canvas, &self.title, &self.better);
        let (font, small) = (font(15.0), font(14.0));
        let mut x = NAMES;
        for (name, colour) in self.series.iter().zip(SERIES) {
            canvas.marker(Marker::Disc, (x, 88.0), 6.0, colour);
            canvas.text(name, (x + 12.0, 93.5), font);
            x += 50.0 + canvas.width(name, font);
        }

        let scale = self.scale();
        let bottom = TOP + ROW * self.rows.len() as f64;
        let [from, to] = self.asked.map(&scale);
        canvas.rectangle([(from, TOP), (to, bottom)], COLOURS[5], 0.15);
        let (least, most) =
            (scale(self.numbers().fold(f64::INFINITY, f64::min)), scale(self.numbers().fold(0.0, f64::max)));
        let mut free = f64::NEG_INFINITY;
        let mut ticks: Vec<f64> = TICKS.into_iter().filter(|tick| (least..=most).contains(&scale(*tick))).collect();
        // One comes first, so that it keeps its label where the axis is crowded.
        ticks.retain(|&tick| tick == 1.0 || (scale(tick) - scale(1.0)).abs() > 34.0);
        for tick in ticks {
            let x = scale(tick).floor() + 0.5;
            let (colour, width) = if tick == 1.0 { (INK, 2.0) } else { (PALE, 1.0) };
            canvas.line([(x, TOP), (x, bottom)], Stroke::new(colour, width));
            let text = format!("{tick}");
            let half = 0.5 * canvas.width(&text, small);
            if x - half > free {
                canvas.text(&text, (x, bottom + 21.0), small.centred());
                free = x + half + 6.0;
            }
        }
        for (i, row) in self.rows.iter().enumerate() {
            let y = TOP + ROW * (i as f64 + 0.5);
            canvas.line([(NAMES, y), (WIDTH - MARGIN, y)].map(|(x, y)| (x, y.floor() + 0.5)), Stroke::new(PALE, 1.0));
            canvas.text(&row.name, (24.0, y + 5.5), font);
            for (value, colour) in row.values.iter().zip(SERIES).rev().filter(|(value, _)| value.is_finite()) {
                canvas.marker(Marker::Disc, (scale(*value), y), 6.0, colour);
            }
            if let Some(first) = row.values.first().filter(|value| value.is_finite()) {
                canvas.text(&format!("{first:.2}"), (WIDTH - MARGIN + 14.0, y + 5.0), small);
            }
        }
        canvas.text(&self.axis, (NAMES, bottom + 48.0), bold(15.0));
    }
}
