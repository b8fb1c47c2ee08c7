//! Ratios as dots in rows, on a logarithmic axis.

use integrator_plot::{
    Area, Outcome, Picture, bold,
    colour::{COLOURS, INK, PALE},
    font, head,
    plotters::prelude::*,
    write,
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

const TOP: i32 = 118;
const ROW: i32 = 26;
const NAMES: i32 = 340;
const WIDTH: i32 = 1100;
const MARGIN: i32 = 70;
/// The colours of the series: the first is what the picture is about.
const SERIES: [RGBColor; 3] = [COLOURS[6], RGBColor(160, 160, 160), COLOURS[3]];
/// Numbers that an axis may show.
const TICKS: [f64; 19] =
    [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 0.8, 0.9, 1.0, 1.1, 1.2, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0];

impl Dots {
    fn numbers(&self) -> impl Iterator<Item = f64> {
        let values = self.rows.iter().flat_map(|row| &row.values).copied();
        values.chain(self.asked).chain([1.0]).filter(|value| value.is_finite() && *value > 0.0)
    }

    /// Where a number lies along the axis.
    fn scale(&self) -> impl Fn(f64) -> i32 {
        let least = self.numbers().fold(f64::INFINITY, f64::min).ln() - 0.05;
        let most = self.numbers().fold(0.0, f64::max).ln() + 0.05;
        move |value| NAMES + (f64::from(WIDTH - NAMES - MARGIN) * (value.ln() - least) / (most - least)) as i32
    }
}

impl Picture for Dots {
    fn size(&self) -> (u32, u32) {
        (WIDTH as u32, (TOP + ROW * self.rows.len() as i32 + 70) as u32)
    }

    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Outcome
    where
        B::ErrorType: 'static,
    {
        head(area, &self.title, &self.better)?;
        let (font, small) = (font(15), font(14));
        let mut x = NAMES;
        for (name, colour) in self.series.iter().zip(SERIES) {
            area.draw(&Circle::new((x, 88), 6, colour.filled()))?;
            area.draw_text(name, &font, (x + 12, 82))?;
            x += 60 + 8 * name.chars().count() as i32;
        }

        let scale = self.scale();
        let bottom = TOP + ROW * self.rows.len() as i32;
        let [from, to] = self.asked.map(&scale);
        area.draw(&Rectangle::new([(from, TOP), (to, bottom)], COLOURS[5].mix(0.15).filled()))?;
        let (least, most) =
            (scale(self.numbers().fold(f64::INFINITY, f64::min)), scale(self.numbers().fold(0.0, f64::max)));
        let mut last = None;
        let mut ticks: Vec<f64> = TICKS.into_iter().filter(|tick| (least..=most).contains(&scale(*tick))).collect();
        // One comes first, so that it keeps its label where the axis is crowded.
        ticks.retain(|&tick| tick == 1.0 || (scale(tick) - scale(1.0)).abs() > 34);
        for tick in ticks {
            let x = scale(tick);
            let style = if tick == 1.0 { INK.stroke_width(2) } else { PALE.stroke_width(1) };
            area.draw(&PathElement::new([(x, TOP), (x, bottom)], style))?;
            if last.is_none_or(|last| x - last > 34) {
                let text = format!("{tick}");
                area.draw_text(&text, &small, (x - 4 * text.len() as i32, bottom + 8))?;
                last = Some(x);
            }
        }
        for (i, row) in self.rows.iter().enumerate() {
            let y = TOP + ROW * i as i32 + ROW / 2;
            area.draw(&PathElement::new([(NAMES, y), (WIDTH - MARGIN, y)], PALE.stroke_width(1)))?;
            area.draw_text(&row.name, &font, (24, y - 7))?;
            for (value, colour) in row.values.iter().zip(SERIES).rev().filter(|(value, _)| value.is_finite()) {
                area.draw(&Circle::new((scale(*value), y), 6, colour.filled()))?;
            }
            if let Some(first) = row.values.first().filter(|value| value.is_finite()) {
                area.draw_text(&format!("{first:.2}"), &small, (WIDTH - MARGIN + 14, y - 7))?;
            }
        }
        area.draw_text(&self.axis, &bold(15), (NAMES, bottom + 34))?;
        Ok(())
    }
}
