//! Errors that grow with the number of steps, beside a random walk.

use integrator_plot::{
    Area, Axis, Frame, Margins, Outcome, Picture, bold,
    colour::{COLOURS, GREY},
    head,
    plotters::prelude::*,
    write,
};
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

/// Pixels for a letter of the names, which stand on the right.
const LETTER: i32 = 10;

impl Growing {
    /// A line of slope one half through the mean of the points.
    fn walk(&self) -> Vec<(f64, f64)> {
        let logarithms = || self.points.iter().map(|(steps, error)| (steps.log10(), error.log10()));
        let count = self.points.len() as f64;
        let (x, y) = logarithms().fold((0.0, 0.0), |(x, y), point| (x + point.0 / count, y + point.1 / count));
        self.points.iter().map(|(steps, _)| (*steps, 10.0_f64.powf(y + (steps.log10() - x) / 2.0))).collect()
    }
}

impl Picture for Growth<'_> {
    fn size(&self) -> (u32, u32) {
        (1000, 700)
    }

    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Outcome
    where
        B::ErrorType: 'static,
    {
        let claim = "Grey: a random walk, which grows like the root of the number of steps";
        let below = head(area, self.title, claim)?;
        let points = || self.problems.iter().flat_map(|problem| &problem.points);
        let longest = self.problems.iter().map(|problem| problem.name.chars().count()).max().unwrap_or(0);
        let [along, up] = ["steps", "root mean square of the energy error"].map(Axis::logarithmic);
        let scales = [along.fit(points().map(|point| point.0)), up.fit(points().map(|point| point.1))];
        let frame = Frame::new(area, Margins { top: below + 12, right: LETTER * longest as i32, text: 16 }, scales)?;
        frame.grid()?;
        for (problem, colour) in self.problems.iter().zip(COLOURS.iter().skip(1)) {
            frame.line(problem.walk(), GREY, false)?;
            let points = || problem.points.iter().copied();
            frame.line(points(), colour.stroke_width(3), false)?;
            frame.dots(points(), 4, colour.filled())?;
            if let Some(last) = problem.points.last() {
                frame.text(*last, (12, -8), &problem.name, &bold(16).color(colour))?;
            }
        }
        frame.axes(["steps", "root mean square of the energy error"])
    }
}
