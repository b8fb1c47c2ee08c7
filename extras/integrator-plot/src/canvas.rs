//! The shapes of a picture, in pixels and fractions of pixels, from which both file formats are written.

use crate::{
    colour::{Colour, WHITE},
    text::{Font, Typefaces},
};
use std::error::Error;

/// A position in pixels, from the upper left corner.
pub type Place = (f64, f64);

/// The style of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// The colour.
    pub colour: Colour,
    /// The width in pixels.
    pub width: f64,
    /// Alternating lengths of dashes and gaps; empty for a solid line.
    pub dashes: &'static [f32],
}

impl Stroke {
    /// Creates a solid line.
    #[must_use]
    pub const fn new(colour: Colour, width: f64) -> Self {
        Self { colour, width, dashes: &[] }
    }

    /// Sets the lengths of dashes and gaps.
    #[must_use]
    pub const fn dashed(self, dashes: &'static [f32]) -> Self {
        Self { dashes, ..self }
    }
}

/// The marker of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marker {
    /// A filled circle.
    Disc,
    /// A filled square.
    Square,
    /// A square standing on a corner.
    Diamond,
    /// A triangle with a horizontal base.
    Triangle,
    /// A triangle standing on a corner.
    Wedge,
    /// A circle with a white interior.
    Ring,
}

/// All markers, the most distinguishable first.
pub const MARKERS: [Marker; 6] =
    [Marker::Disc, Marker::Square, Marker::Diamond, Marker::Triangle, Marker::Wedge, Marker::Ring];

#[derive(Clone, Debug)]
pub(crate) enum Shape {
    Line {
        points: Vec<Place>,
        stroke: Stroke,
    },
    Filled {
        corners: Vec<Place>,
        colour: Colour,
        opacity: f64,
    },
    Disc {
        centre: Place,
        radius: f64,
        colour: Colour,
    },
    Text {
        text: String,
        at: Place,
        font: Font,
    },
    /// The shapes up to [`Shape::End`] belong to one series, whose name is a tooltip. SVG alone has groups.
    Begin {
        title: String,
        optional: bool,
    },
    End,
    /// Three bytes for each pixel, enlarged to a size in pixels of the picture.
    Bitmap {
        at: Place,
        size: (f64, f64),
        columns: usize,
        bytes: Vec<u8>,
    },
}

/// A white drawing area. Later shapes cover earlier ones; shapes with a non-finite coordinate are left out.
#[derive(Clone, Debug)]
pub struct Canvas {
    pub(crate) size: (u32, u32),
    pub(crate) shapes: Vec<Shape>,
    pub(crate) typefaces: Typefaces,
}

impl Canvas {
    /// Creates a drawing area of this width and height in pixels.
    ///
    /// # Errors
    /// The fonts cannot be read.
    pub fn new(size: (u32, u32)) -> Result<Self, Box<dyn Error>> {
        Ok(Self { size, shapes: Vec::new(), typefaces: Typefaces::new()? })
    }

    /// Draws a line through points.
    pub fn line(&mut self, points: impl IntoIterator<Item = Place>, stroke: Stroke) {
        let points: Vec<Place> = points.into_iter().filter(is_finite).collect();
        if points.len() > 1 {
            self.shapes.push(Shape::Line { points, stroke });
        }
    }

    /// Fills the interior of a closed curve.
    pub fn filled(&mut self, corners: impl IntoIterator<Item = Place>, colour: Colour, opacity: f64) {
        let corners: Vec<Place> = corners.into_iter().filter(is_finite).collect();
        if corners.len() > 2 {
            self.shapes.push(Shape::Filled { corners, colour, opacity });
        }
    }

    /// Fills a rectangle, given by its upper left and its lower right corner.
    pub fn rectangle(&mut self, [from, to]: [Place; 2], colour: Colour, opacity: f64) {
        self.filled([from, (to.0, from.1), to, (from.0, to.1)], colour, opacity);
    }

    /// Groups the shapes that are drawn up to [`Canvas::end`] under a title.
    pub(crate) fn begin(&mut self, title: &str, optional: bool) {
        self.shapes.push(Shape::Begin { title: title.to_owned(), optional });
    }

    /// Ends a group.
    pub(crate) fn end(&mut self) {
        self.shapes.push(Shape::End);
    }

    /// Draws a marker.
    pub fn marker(&mut self, marker: Marker, centre: Place, radius: f64, colour: Colour) {
        if !is_finite(&centre) {
            return;
        }
        let (x, y) = centre;
        // Of about the area of the disc.
        let (half, corner) = (0.89 * radius, 1.25 * radius);
        let mut around = |corners: &[Place]| self.filled(corners.iter().map(|(dx, dy)| (x + dx, y + dy)), colour, 1.0);
        match marker {
            Marker::Disc => self.shapes.push(Shape::Disc { centre, radius, colour }),
            Marker::Square => around(&[(-half, -half), (half, -half), (half, half), (-half, half)]),
            Marker::Diamond => around(&[(0.0, -corner), (corner, 0.0), (0.0, corner), (-corner, 0.0)]),
            Marker::Triangle => {
                around(&[(0.0, -1.3 * radius), (1.2 * radius, 0.8 * radius), (-1.2 * radius, 0.8 * radius)]);
            }
            Marker::Wedge => {
                around(&[(0.0, 1.3 * radius), (1.2 * radius, -0.8 * radius), (-1.2 * radius, -0.8 * radius)]);
            }
            Marker::Ring => {
                self.shapes.push(Shape::Disc { centre, radius: 1.1 * radius, colour });
                self.shapes.push(Shape::Disc { centre, radius: 0.6 * radius, colour: WHITE });
            }
        }
    }

    /// Draws a bitmap with `columns` pixels per row and three bytes per pixel. `at` is its upper left corner, `size`
    /// its size in the picture.
    pub fn bitmap(&mut self, at: Place, size: (f64, f64), columns: usize, bytes: Vec<u8>) {
        if columns > 0 && bytes.len() >= 3 * columns {
            self.shapes.push(Shape::Bitmap { at, size, columns, bytes });
        }
    }

    /// Draws text whose baseline goes through a position.
    pub fn text(&mut self, text: &str, at: Place, font: Font) {
        if !text.is_empty() && is_finite(&at) {
            self.shapes.push(Shape::Text { text: text.to_owned(), at, font });
        }
    }

    /// Returns the width of a line of text in pixels.
    #[must_use]
    pub fn width(&self, text: &str, font: Font) -> f64 {
        self.typefaces.width(text, &font)
    }

    /// Breaks text into lines of at most `at_most` pixels.
    #[must_use]
    pub fn broken(&self, text: &str, font: Font, at_most: f64) -> Vec<String> {
        let mut lines: Vec<String> = Vec::new();
        for word in text.split_whitespace() {
            match lines.last_mut() {
                Some(line) if self.width(&format!("{line} {word}"), font) <= at_most => {
                    line.push(' ');
                    line.push_str(word);
                }
                _ => lines.push(word.to_owned()),
            }
        }
        lines
    }

    /// Draws text in lines of at most `at_most` pixels, from its upper left corner. Returns the height at which the
    /// next item begins.
    pub fn paragraph(&mut self, text: &str, (x, mut y): Place, at_most: f64, font: Font) -> f64 {
        for line in self.broken(text, font, at_most) {
            self.text(&line, (x, y + font.size), font);
            y += 1.32 * font.size;
        }
        y
    }

    /// Returns the picture as SVG.
    #[must_use]
    pub fn svg(&self) -> String {
        crate::svg::text(self)
    }

    /// Returns the picture as PNG, enlarged by an integer factor.
    #[must_use]
    pub fn png(&self, times: u32) -> Vec<u8> {
        let times = times.max(1);
        crate::png::encoded((times * self.size.0, times * self.size.1), &crate::raster::pixels(self, times))
    }
}

fn is_finite((x, y): &Place) -> bool {
    x.is_finite() && y.is_finite()
}

#[cfg(test)]
mod tests {
    use super::Canvas;
    use crate::text::font;

    #[test]
    fn a_paragraph_is_broken_where_it_is_too_long() {
        let canvas = Canvas::new((100, 100)).expect("fonts");
        let lines = canvas.broken("one two three four", font(16.0), 70.0);
        assert_eq!(lines, ["one two", "three", "four"]);
        assert!(lines.iter().all(|line| canvas.width(line, font(16.0)) <= 70.0));
        assert_eq!(canvas.broken("unbreakable", font(16.0), 10.0), ["unbreakable"]);
        assert!(canvas.broken(" ", font(16.0), 10.0).is_empty());
    }
}
