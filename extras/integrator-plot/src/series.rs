//! The series of a chart.

use crate::{
    canvas::{Canvas, Marker, Place, Stroke},
    colour::{COLOURS, Colour},
    frame::Frame,
};

/// The style in which the points of a series are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A line from point to point.
    Line,
    /// A line with a marker at every point.
    Dotted,
    /// A marker at every point.
    Dots,
    /// One pixel per point, as a bitmap, for any number of points.
    Cloud,
    /// The filled interior of a closed curve.
    Filled,
}

/// Points with a name.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    pub(crate) name: String,
    pub(crate) mark: Mark,
    pub(crate) marker: Marker,
    pub(crate) dashes: &'static [f32],
    /// Whether a page may hide the series at first.
    pub(crate) optional: bool,
    pub(crate) width: f64,
    pub(crate) colour: Colour,
    pub(crate) points: Vec<(f64, f64)>,
}

/// Lengths of dashes and of the gaps between them, in pixels.
pub const DASHES: &[f32] = &[7.0, 4.0];

/// The dashes of lines whose colours repeat those of earlier ones: solid lines first, and four times as many lines as colours.
const PATTERNS: [&[f32]; 4] = [&[], DASHES, &[2.0, 3.0], &[9.0, 3.0, 2.0, 3.0]];

impl Series {
    /// The series with this index, with the colour of its place. Colours come again after the last one; lines
    /// have other dashes then.
    pub(crate) fn new(place: usize, name: String, mark: Mark, points: Vec<(f64, f64)>) -> Self {
        let dashes = PATTERNS[(place / COLOURS.len()) % PATTERNS.len()];
        let colour = COLOURS[place % COLOURS.len()];
        Self { name, mark, marker: Marker::Disc, dashes, optional: false, width: 2.0, colour, points }
    }

    fn stroke(&self, width: f64) -> Stroke {
        Stroke::new(self.colour, width).dashed(self.dashes)
    }

    /// Draws everything but clouds, which come before the grid.
    pub(crate) fn draw(&self, frame: &mut Frame<'_>) {
        let points = || self.points.iter().copied();
        let radius = self.width + 1.0;
        match self.mark {
            Mark::Line => frame.line(points(), self.stroke(self.width)),
            Mark::Dotted => {
                frame.line(points(), self.stroke(self.width));
                frame.markers(points(), self.marker, radius, self.colour);
            }
            Mark::Dots => frame.markers(points(), self.marker, radius, self.colour),
            Mark::Cloud => {}
            Mark::Filled => {
                frame.fill(points(), self.colour, 0.25);
                frame.line(points().chain(points().take(1)), Stroke::new(self.colour, 1.0));
            }
        }
    }

    /// Draws what stands for the series in a legend, thirty pixels wide.
    pub(crate) fn sign(&self, canvas: &mut Canvas, (x, y): Place) {
        let line = [(x, y), (x + 30.0, y)];
        match self.mark {
            Mark::Line => canvas.line(line, self.stroke(self.width + 0.5)),
            Mark::Dotted => {
                canvas.line(line, self.stroke(self.width));
                canvas.marker(self.marker, (x + 15.0, y), self.width + 2.0, self.colour);
            }
            Mark::Dots => canvas.marker(self.marker, (x + 15.0, y), self.width + 2.0, self.colour),
            Mark::Cloud | Mark::Filled => canvas.rectangle([(x + 8.0, y - 7.0), (x + 22.0, y + 7.0)], self.colour, 1.0),
        }
    }
}
