//! Ratios as dots in rows, on a logarithmic axis.

use integrator_plot::{
    Canvas, Colour, Marker, Outcome, Picture, Stroke, bold,
    colour::{COLOURS, INK, PALE},
    font, head, write,
};
use std::path::Path;

/// A plot of ratios.
#[derive(Clone, Debug, Default)]
pub struct Dots {
    /// Title of the plot.
    pub title: String,
    /// Line below the title that says which direction is better.
    pub better: String,
    /// Name of the horizontal axis.
    pub axis: String,
    /// Names of the dots of a row, for the legend.
    pub series: Vec<String>,
    /// Ends of the tinted band of ratios.
    pub band: [f64; 2],
    /// Rows from top to bottom.
    pub rows: Vec<Row>,
}

/// A row of dots.
#[derive(Clone, Debug)]
pub struct Row {
    /// Name of the row.
    pub name: String,
    /// One ratio per series; NaN draws no dot.
    pub values: Vec<f64>,
}

/// Scenes and compositions as named in the tables of the benches, and their labels in plots.
const NAMES_OF: [(&str, &str); 36] = [
    ("henon", "Hénon–Heiles"),
    ("henon_carried", "Hénon–Heiles, compensated"),
    ("henon_64", "Hénon–Heiles, 64 members"),
    ("henon_f32", "Hénon–Heiles, f32"),
    ("henon_parts", "Hénon–Heiles, quadratic + rest"),
    ("kepler", "Kepler"),
    ("kepler_64", "Kepler, 64 members"),
    ("kepler_f32", "Kepler, f32"),
    ("kepler_part", "Kepler part"),
    ("pendulum_fast", "pendulum, fast functions"),
    ("pendulum_f32", "pendulum, f32"),
    ("solar", "outer planets"),
    ("solar_carried", "outer planets, compensated"),
    ("fput", "FPUT-32"),
    ("fput_carried", "FPUT-32, compensated"),
    ("fput_1e4", "FPUT, 10⁴ sites"),
    ("fput_1e5", "FPUT, 10⁵ sites"),
    ("fput_1e6", "FPUT, 10⁶ sites"),
    ("fput_1e7", "FPUT, 10⁷ sites"),
    ("toda_1e4", "Toda, 10⁴ sites"),
    ("sine_gordon_1e4", "sine-Gordon, 10⁴ sites"),
    ("phi4_1e4", "φ⁴ chain, 10⁴ sites"),
    ("phi4_2d", "φ⁴, 256 × 256"),
    ("phi4_2d_2e6", "φ⁴, 256 × 8192"),
    ("phi4_4096x4096", "φ⁴, 4096 × 4096"),
    ("phi4_128x128x128", "φ⁴, 128 × 128 × 128"),
    ("nbody_100", "100 bodies"),
    ("nbody_1000", "1,000 bodies"),
    ("nbody_10000", "10,000 bodies"),
    ("argon_376", "argon, 376 atoms"),
    ("verlet", "Verlet"),
    ("yoshida4", "Yoshida4"),
    ("kahanli8", "KahanLi8"),
    ("sofroniouspaletta10", "SofroniouSpaletta10"),
    ("teloy8c", "Teloy8C"),
    ("aba864", "Aba864"),
];

/// Returns the label of a scene or composition in plots; by default its name.
#[must_use]
pub fn named(key: &str) -> &str {
    NAMES_OF.iter().find(|(known, _)| *known == key).map_or(key, |(_, name)| name)
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
/// Colours and markers of the series; the first series is the subject of the picture.
const SERIES: [(Colour, Marker); 3] =
    [(COLOURS[6], Marker::Disc), (Colour(130, 130, 130), Marker::Diamond), (COLOURS[3], Marker::Square)];
/// Numbers that an axis may show.
const TICKS: [f64; 19] =
    [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 0.8, 0.9, 1.0, 1.1, 1.2, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0];

impl Dots {
    fn numbers(&self) -> impl Iterator<Item = f64> {
        let values = self.rows.iter().flat_map(|row| &row.values).copied();
        values.chain(self.band).chain([1.0]).filter(|value| value.is_finite() && *value > 0.0)
    }

    /// Returns the function from numbers to positions along the axis.
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
        for (name, (colour, marker)) in self.series.iter().zip(SERIES) {
            canvas.marker(marker, (x, 88.0), 6.0, colour);
            canvas.text(name, (x + 12.0, 93.5), font);
            x += 50.0 + canvas.width(name, font);
        }

        let scale = self.scale();
        let bottom = TOP + ROW * self.rows.len() as f64;
        let [from, to] = self.band.map(&scale);
        canvas.rectangle([(from, TOP), (to, bottom)], COLOURS[5], 0.15);
        let (least, most) =
            (scale(self.numbers().fold(f64::INFINITY, f64::min)), scale(self.numbers().fold(0.0, f64::max)));
        let mut free = f64::NEG_INFINITY;
        let mut ticks: Vec<f64> = TICKS.into_iter().filter(|tick| (least..=most).contains(&scale(*tick))).collect();
        // The tick at 1 comes first, so that it keeps its label on a crowded axis.
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
            for (value, (colour, marker)) in row.values.iter().zip(SERIES).rev().filter(|(value, _)| value.is_finite())
            {
                canvas.marker(marker, (scale(*value), y), 6.0, colour);
            }
            if let Some(first) = row.values.first().filter(|value| value.is_finite()) {
                canvas.text(&format!("{first:.2}"), (WIDTH - MARGIN + 14.0, y + 5.0), small);
            }
        }
        canvas.text(&self.axis, (NAMES, bottom + 48.0), bold(15.0));
    }
}
