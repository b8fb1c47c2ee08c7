//! What is drawn in a chart.

use crate::{colour::COLOURS, frame::Frame, picture::Outcome};
use plotters::prelude::*;

/// How the points of a series are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A line from point to point.
    Line,
    /// A line with a dot at every point.
    Dotted,
    /// A dot for each.
    Dots,
    /// A pixel for each, of any number of points, as a bitmap.
    Cloud,
    /// The inside of a closed curve.
    Filled,
}

/// Points with a name.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    pub(crate) name: String,
    pub(crate) mark: Mark,
    pub(crate) dashed: bool,
    pub(crate) colour: RGBColor,
    pub(crate) points: Vec<(f64, f64)>,
}

impl Series {
    /// The series that has so many before it, with the colour of its place. Colours come again after the last one; lines
    /// are dashed then.
    pub(crate) fn new(place: usize, name: String, mark: Mark, points: Vec<(f64, f64)>) -> Self {
        let dashed = (place / COLOURS.len()) % 2 == 1;
        Self { name, mark, dashed, colour: COLOURS[place % COLOURS.len()], points }
    }

    /// Draws everything but clouds, which come before the grid.
    pub(crate) fn draw<B: DrawingBackend>(&self, frame: &Frame<'_, B>, width: u32) -> Outcome
    where
        B::ErrorType: 'static,
    {
        let points = || self.points.iter().copied();
        let (line, radius) = (self.colour.stroke_width(width), width as i32 + 1);
        match self.mark {
            Mark::Line => frame.line(points(), line, self.dashed),
            Mark::Dotted => {
                frame.line(points(), line, self.dashed)?;
                frame.dots(points(), radius, self.colour.filled())
            }
            Mark::Dots => frame.dots(points(), radius, self.colour.filled()),
            Mark::Cloud => Ok(()),
            Mark::Filled => {
                frame.fill(points(), self.colour.mix(0.25).filled())?;
                frame.line(points().chain(points().take(1)), self.colour.stroke_width(1), false)
            }
        }
    }
}
