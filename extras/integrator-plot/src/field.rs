//! A quantity over a plane, as colours.

use crate::{
    axis::{Axis, Scale},
    canvas::{Canvas, Stroke},
    colour::{INK, WHITE, of_share},
    frame::Frame,
    path::Border,
    text::font,
};

/// Numbers at the middles of equal cells between two corners.
#[derive(Clone, Debug)]
pub(crate) struct Field {
    /// The lower left and the upper right corner.
    pub(crate) corners: [(f64, f64); 2],
    pub(crate) columns: usize,
    /// Row after row, from the lowest one up.
    pub(crate) values: Vec<f64>,
    /// The axis of the quantity that colours show.
    pub(crate) axis: Axis,
}

/// The width of the bar beside the field that says what its colours mean, and the gap before it.
const BAR: [f64; 2] = [18.0, 22.0];
/// Shades of the bar.
const SHADES: usize = 256;

impl Field {
    /// Returns the scale from the least to the greatest number, without room around.
    fn scale(&self) -> Scale {
        let numbers = || self.values.iter().copied().filter(|value| value.is_finite());
        let fitted = self.axis.fit(numbers());
        let [least, most] = [numbers().fold(f64::INFINITY, f64::min), numbers().fold(f64::NEG_INFINITY, f64::max)];
        let tight = self.axis.clone().between(least, most).fit([]);
        let has_length = self.axis.ends.is_none() && tight.most - tight.least > 0.0;
        if has_length && (tight.most - tight.least).is_finite() { tight } else { fitted }
    }

    /// The room on the right for the bar with its labels.
    pub(crate) fn width(&self, canvas: &Canvas, text: f64) -> f64 {
        let labels = self.scale().labels(8);
        let widest = labels.iter().map(|(_, label)| canvas.width(label, font(text))).fold(0.0, f64::max);
        BAR[0] + BAR[1] + widest + 14.0 + 1.6 * text
    }

    /// Draws the cells. Those without a number stay white.
    pub(crate) fn draw(&self, frame: &mut Frame<'_>) {
        let scale = self.scale();
        let colour = |value: &f64| scale.part(*value).map_or(WHITE, of_share);
        let rows = self.values.chunks_exact(self.columns).rev();
        let bytes = rows.flatten().map(colour).flat_map(|colour| [colour.0, colour.1, colour.2]).collect();
        frame.bitmap(self.corners, self.columns, bytes);
    }

    /// Draws the bar on the right of the field.
    pub(crate) fn bar(&self, canvas: &mut Canvas, [_, top, right, bottom]: Border, text: f64) {
        let (left, style, ink) = (right + BAR[1], font(text), Stroke::new(INK, 1.0));
        let shades = (0..SHADES).rev().map(|i| of_share(i as f64 / (SHADES - 1) as f64));
        let bytes = shades.flat_map(|colour| [colour.0, colour.1, colour.2]).collect();
        canvas.bitmap((left, top), (BAR[0], bottom - top), 1, bytes);
        let scale = self.scale();
        let mut widest: f64 = 0.0;
        for (part, label) in scale.labels(((bottom - top) / (2.5 * text)).max(2.0) as usize) {
            let y = (bottom - part * (bottom - top)).floor() + 0.5;
            canvas.line([(left + BAR[0], y), (left + BAR[0] + 4.0, y)], ink);
            canvas.text(&label, (left + BAR[0] + 8.0, y + 0.36 * text), style);
            widest = widest.max(canvas.width(&label, style));
        }
        let beside = (left + BAR[0] + 14.0 + widest + text, 0.5 * (top + bottom));
        canvas.text(&self.axis.name, beside, style.centred().upwards());
    }
}
