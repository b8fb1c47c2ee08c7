//! Two axes in a part of the canvas, and the items drawn between them.

use crate::{
    axis::Scale,
    canvas::{Canvas, Marker, Place, Stroke},
    cloud::Cloud,
    colour::{Colour, INK, PALE},
    labels::apart,
    path::{Border, pieces},
    text::{Font, bold, font},
};

/// The margins around the axes and their labels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margins {
    /// The margin above the axes.
    pub top: f64,
    /// The margin on the right.
    pub right: f64,
    /// The size of labels, which determines the margins on the left and below.
    pub text: f64,
}

/// A rectangle of the canvas: left, top, right, bottom.
pub type Room = [f64; 4];

/// A rectangle with a scale along each side. Coordinates are those of the scales, linear or logarithmic.
pub struct Frame<'c> {
    canvas: &'c mut Canvas,
    room: Room,
    margins: Margins,
    scales: [Scale; 2],
    border: Border,
    labels: [Vec<(f64, String)>; 2],
}

impl<'c> Frame<'c> {
    /// Finds the position of axes and labels within a part of the canvas; draws nothing.
    pub fn new(canvas: &'c mut Canvas, room: Room, margins: Margins, scales: [Scale; 2]) -> Self {
        let (size, style) = (margins.text, font(margins.text));
        let (top, bottom) = (room[1] + margins.top, room[3] - 4.0 * size);
        let up = scales[1].labels(((bottom - top) / (2.5 * size)).max(2.0) as usize);
        let widest = up.iter().map(|(_, label)| canvas.width(label, style)).fold(0.0, f64::max);
        // The name of the axis stands upright on the left of the labels. Whole pixels keep the axes sharp.
        let border = [room[0] + widest + 2.0 * size + 18.0, top, room[2] - margins.right - size, bottom];
        let border = border.map(|side| side.round() + 0.5);
        // As many labels as have room beside each other.
        let length = border[2] - border[0];
        let mut at_most = (length / (3.0 * size)).max(2.0) as usize;
        let along = loop {
            let labels = scales[0].labels(at_most);
            let taken: f64 = labels.iter().map(|(_, label)| canvas.width(label, style) + size).sum();
            if taken < length || at_most <= 2 {
                break labels;
            }
            at_most -= 1;
        };
        Self { canvas, room, margins, scales, border, labels: [along, up] }
    }

    /// Returns the same frame with one scale extended, so that equal differences have equal lengths along both axes.
    #[must_use]
    pub fn with_equal_units(self) -> Self {
        let [left, top, right, bottom] = self.border;
        let [x, y] = self.scales;
        let units = [(x.most - x.least) / (right - left), (y.most - y.least) / (bottom - top)];
        let scales = if units[0] < units[1] {
            [x.stretched(units[1] / units[0]), y]
        } else {
            [x, y.stretched(units[0] / units[1])]
        };
        Self::new(self.canvas, self.room, self.margins, scales)
    }

    /// Draws grid lines at the labels.
    pub fn grid(&mut self) {
        let [left, top, right, bottom] = self.border;
        for i in 0..self.labels[0].len() {
            let x = self.across(self.labels[0][i].0);
            self.canvas.line([(x, top), (x, bottom)], Stroke::new(PALE, 1.0));
        }
        for i in 0..self.labels[1].len() {
            let y = self.down(self.labels[1][i].0);
            self.canvas.line([(left, y), (right, y)], Stroke::new(PALE, 1.0));
        }
    }

    /// Draws the axes with labels and names.
    pub fn axes(&mut self, [along, up]: [&str; 2]) {
        let [left, top, right, bottom] = self.border;
        let (size, style, ink) = (self.margins.text, font(self.margins.text), Stroke::new(INK, 1.0));
        self.canvas.line([(left, top), (left, bottom), (right, bottom)], ink);
        for (part, label) in self.labels[0].clone() {
            let x = self.across(part);
            self.canvas.line([(x, bottom), (x, bottom + 4.0)], ink);
            self.canvas.text(&label, (x, bottom + 7.0 + size), style.centred());
        }
        for (part, label) in self.labels[1].clone() {
            let y = self.down(part);
            self.canvas.line([(left - 4.0, y), (left, y)], ink);
            self.canvas.text(&label, (left - 8.0, y + 0.36 * size), style.ending());
        }
        self.canvas.text(along, (0.5 * (left + right), bottom + 14.0 + 2.3 * size), style.centred());
        let middle = (self.room[0] + 8.0 + size, 0.5 * (top + bottom));
        self.canvas.text(up, middle, style.centred().upwards());
    }

    /// Draws a curve, clipped at the frame.
    pub fn line(&mut self, points: impl IntoIterator<Item = (f64, f64)>, stroke: Stroke) {
        for piece in pieces(points.into_iter().map(|point| self.place(point)), self.border) {
            self.canvas.line(piece, stroke);
        }
    }

    /// Draws markers; those outside of the frame are left out.
    pub fn markers(
        &mut self,
        points: impl IntoIterator<Item = (f64, f64)>,
        marker: Marker,
        radius: f64,
        colour: Colour,
    ) {
        for point in points {
            if let Some(place) = self.visible(point) {
                self.canvas.marker(marker, place, radius, colour);
            }
        }
    }

    /// Fills the interior of a closed curve. Points outside of the frame are moved to its border.
    pub fn fill(&mut self, points: impl IntoIterator<Item = (f64, f64)>, colour: Colour, opacity: f64) {
        let [left, top, right, bottom] = self.border;
        let pressed = |(x, y): Place| (x.clamp(left, right), y.clamp(top, bottom));
        let outline: Vec<_> = points.into_iter().filter_map(|point| self.place(point)).map(pressed).collect();
        self.canvas.filled(outline, colour, opacity);
    }

    /// Groups what is drawn up to [`Frame::end`].
    pub(crate) fn begin(&mut self, title: &str, optional: bool) {
        self.canvas.begin(title, optional);
    }

    /// Ends a group.
    pub(crate) fn end(&mut self) {
        self.canvas.end();
    }

    /// Draws text at an offset in pixels from a point.
    pub fn text(&mut self, point: (f64, f64), (right, down): Place, text: &str, font: Font) {
        if let Some((x, y)) = self.visible(point) {
            self.canvas.text(text, (x + right, y + down), font);
        }
    }

    /// Draws names to the right of the frame, each as close as possible to the height of its point and without overlap.
    /// A thin line connects name and point.
    pub fn names(&mut self, names: &[((f64, f64), &str, Colour)]) {
        let (size, right) = (self.margins.text, self.border[2]);
        let mut visible: Vec<_> =
            names.iter().filter_map(|(point, name, colour)| Some((self.visible(*point)?, *name, *colour))).collect();
        visible.sort_by(|a, b| a.0.1.total_cmp(&b.0.1));
        let wanted: Vec<f64> = visible.iter().map(|(place, ..)| place.1).collect();
        let heights = apart(&wanted, 1.3 * size, [self.border[1], self.border[3]]);
        for ((place, name, colour), height) in visible.into_iter().zip(heights) {
            // A long way to a curve that ended early is not to be taken for one.
            let far = right - place.0 > 0.1 * (right - self.border[0]);
            let thin = Stroke::new(if far { PALE } else { colour }, 0.75);
            self.canvas.line([(place.0 + 6.0, place.1), (right + 2.0, height), (right + 8.0, height)], thin);
            self.canvas.text(name, (right + 12.0, height + 0.36 * size), bold(size).coloured(colour));
        }
    }

    /// Draws clouds of points as one bitmap. The bitmap covers everything drawn before, so draw it first.
    pub fn clouds(&mut self, clouds: &[(&[(f64, f64)], Colour)]) {
        let [left, top, right, bottom] = self.border;
        let size = ((right - left).max(1.0) as u32, (bottom - top).max(1.0) as u32);
        let mut sheet = Cloud::new(size, clouds.iter().map(|(points, _)| points.len()).sum());
        for &(points, colour) in clouds {
            for (x, y) in points.iter().filter_map(|point| self.place(*point)) {
                sheet.point(x - left, y - top, colour);
            }
        }
        self.canvas.bitmap((left, top), (f64::from(size.0), f64::from(size.1)), size.0 as usize, sheet.into_bytes());
    }

    /// A bitmap of this number of columns that fills the rectangle between two points. It covers what was drawn before.
    pub(crate) fn bitmap(&mut self, [from, to]: [(f64, f64); 2], columns: usize, bytes: Vec<u8>) {
        if let Some((from, to)) = self.place(from).zip(self.place(to)) {
            let corner = (from.0.min(to.0), from.1.min(to.1));
            self.canvas.bitmap(corner, ((to.0 - from.0).abs(), (to.1 - from.1).abs()), columns, bytes);
        }
    }

    /// Left, top, right and bottom of what lies between the axes.
    pub(crate) fn border(&self) -> Border {
        self.border
    }

    /// Returns the place of a point, inside or not; `None` where its coordinates have no place on a scale.
    fn place(&self, (x, y): (f64, f64)) -> Option<Place> {
        let [left, top, right, bottom] = self.border;
        let (along, up) = self.scales[0].part(x).zip(self.scales[1].part(y))?;
        Some((left + along * (right - left), bottom + up * (top - bottom)))
    }

    /// Returns the place of a point inside the border.
    fn visible(&self, point: (f64, f64)) -> Option<Place> {
        let [left, top, right, bottom] = self.border;
        let (x, y) = self.place(point)?;
        ((left..=right).contains(&x) && (top..=bottom).contains(&y)).then_some((x, y))
    }

    /// Ticks lie in the middle of pixels, so that they are sharp.
    fn across(&self, part: f64) -> f64 {
        (self.border[0] + part * (self.border[2] - self.border[0])).floor() + 0.5
    }

    fn down(&self, part: f64) -> f64 {
        (self.border[3] - part * (self.border[3] - self.border[1])).floor() + 0.5
    }
}
