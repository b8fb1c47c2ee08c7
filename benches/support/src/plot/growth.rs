//! Errors that grow with the number of steps, beside a random walk.

use super::{COLOURS, FONT, Outcome, Picture, axes, head, range, write};
use plotters::{coord::Shift, prelude::*, style::FontStyle};
use std::path::Path;

/// A problem, the exponent of its growth, and its errors after so many steps.
#[derive(Clone, Debug)]
pub struct Growing {
    /// What it is about, with whatever was fitted.
    pub name: String,
    /// Steps and errors, both positive.
    pub points: Vec<(f64, f64)>,
}

/// Draws `<file>.svg` and `<file>.png`. A grey line through the middle of each problem has the slope of a random walk.
///
/// # Errors
/// If a file cannot be written.
pub fn growth(file: &Path, title: &str, problems: &[Growing]) -> Outcome {
    write(file, &Growth { title, problems })
}

struct Growth<'p> {
    title: &'p str,
    problems: &'p [Growing],
}

/// Decades on the right for the names.
const ROOM: f64 = 0.9;

impl Growing {
    fn logarithms(&self) -> Vec<(f64, f64)> {
        self.points.iter().map(|(steps, error)| (steps.log10(), error.log10())).collect()
    }

    /// A line of slope one half with the mean of the points.
    fn walk(&self) -> Vec<(f64, f64)> {
        let points = self.logarithms();
        let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / points.len() as f64;
        let (x, y) = (mean(|point| point.0), mean(|point| point.1));
        points.iter().map(|point| (point.0, y + (point.0 - x) / 2.0)).collect()
    }
}

impl Picture for Growth<'_> {
    fn size(&self) -> (u32, u32) {
        (1000, 700)
    }

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Outcome
    where
        B::ErrorType: 'static,
    {
        head(area, self.title, "Grey: a random walk, which grows like the root of the number of steps")?;
        let all: Vec<(f64, f64)> = self.problems.iter().flat_map(Growing::logarithms).collect();
        let steps = range(all.iter().map(|point| point.0), 0.2, ROOM);
        let errors = range(all.iter().map(|point| point.1), 0.2, 0.2);
        let mut chart = axes(area, [steps, errors], 24, ["steps", "root mean square of the energy error"])?;
        for (problem, colour) in self.problems.iter().zip(COLOURS.iter().skip(1)) {
            chart.draw_series(LineSeries::new(problem.walk(), RGBColor(150, 150, 150).stroke_width(1)))?;
            let points = problem.logarithms();
            chart.draw_series(LineSeries::new(points.iter().copied(), colour.stroke_width(3)))?;
            chart.draw_series(points.iter().map(|point| Circle::new(*point, 4, colour.filled())))?;
            if let Some(last) = points.last() {
                let font = (FONT, 16, FontStyle::Bold).into_font().color(colour);
                chart.draw_series([EmptyElement::at(*last) + Text::new(problem.name.clone(), (12, -8), font)])?;
            }
        }
        Ok(())
    }
}
