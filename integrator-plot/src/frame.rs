//! Two axes on an area, and what is drawn between them.

use crate::{
    axis::Scale,
    cloud::Cloud,
    colour::{INK, PALE},
    path::{Border, pieces},
    picture::{Area, Outcome},
    text::{centred, font, width},
};
use plotters::{element::DashedPathElement, prelude::*, style::FontTransform};
use std::error::Error;

/// What is left free around the axes and their labels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Margins {
    /// Above the axes.
    pub top: i32,
    /// On the right.
    pub right: i32,
    /// The size of labels, by which the room on the left and below is measured.
    pub text: u32,
}

/// A rectangle with a scale along each side. Its coordinates are those of the scales, logarithmic or not.
pub struct Frame<'a, B: DrawingBackend> {
    area: &'a Area<B>,
    scales: [Scale; 2],
    /// Left, top, right, bottom.
    border: [i32; 4],
    labels: [Vec<(f64, String)>; 2],
    text: u32,
}

impl<'a, B: DrawingBackend> Frame<'a, B>
where
    B::ErrorType: 'static,
{
    /// Finds the place for axes and labels; draws nothing.
    ///
    /// # Errors
    /// A font that cannot be measured.
    pub fn new(area: &'a Area<B>, margins: Margins, scales: [Scale; 2]) -> Result<Self, Box<dyn Error>> {
        let (across, down) = area.dim_in_pixel();
        let (size, style) = (margins.text as i32, font(margins.text));
        let bottom = down as i32 - 4 * size;
        let up = scales[1].labels(((bottom - margins.top) / (3 * size)).max(2) as usize);
        let mut widest = 0;
        for (_, label) in &up {
            widest = widest.max(width(area, label, &style)?);
        }
        // The name of the axis stands upright on the left of the labels.
        let border = [widest + 2 * size + 18, margins.top, across as i32 - margins.right - size, bottom];
        // As many labels as have room beside each other.
        let length = border[2] - border[0];
        let mut at_most = (length / (3 * size)).max(2) as usize;
        let along = loop {
            let labels = scales[0].labels(at_most);
            let mut taken = 0;
            for (_, label) in &labels {
                taken += width(area, label, &style)? + size;
            }
            if taken < length || at_most <= 2 {
                break labels;
            }
            at_most -= 1;
        };
        Ok(Self { area, scales, border, labels: [along, up], text: margins.text })
    }

    /// The size in pixels of what lies between the axes.
    pub fn size(&self) -> (u32, u32) {
        let [left, top, right, bottom] = self.border;
        ((right - left).max(1) as u32, (bottom - top).max(1) as u32)
    }

    /// The same place with a scale stretched, so that equal differences are equally long along both axes.
    ///
    /// # Errors
    /// A font that cannot be measured.
    pub fn with_equal_units(self, margins: Margins) -> Result<Self, Box<dyn Error>> {
        let (across, down) = self.size();
        let units = [(0, across), (1, down)].map(|(i, pixels)| {
            let scale = &self.scales[i];
            (scale.most - scale.least) / f64::from(pixels)
        });
        let [x, y] = self.scales;
        let scales = if units[0] < units[1] {
            [x.stretched(units[1] / units[0]), y]
        } else {
            [x, y.stretched(units[0] / units[1])]
        };
        Self::new(self.area, margins, scales)
    }

    /// Lines of the grid through the labels.
    ///
    /// # Errors
    /// What the file says.
    pub fn grid(&self) -> Outcome {
        let [left, top, right, bottom] = self.border;
        for (part, _) in &self.labels[0] {
            let x = self.across(*part);
            self.area.draw(&PathElement::new([(x, top), (x, bottom)], PALE))?;
        }
        for (part, _) in &self.labels[1] {
            let y = self.down(*part);
            self.area.draw(&PathElement::new([(left, y), (right, y)], PALE))?;
        }
        Ok(())
    }

    /// The axes with labels and names.
    ///
    /// # Errors
    /// What the file says.
    pub fn axes(&self, [along, up]: [&str; 2]) -> Outcome {
        let [left, top, right, bottom] = self.border;
        let (size, style) = (self.text as i32, font(self.text));
        let corners = [(left, top), (left, bottom), (right, bottom)];
        self.area.draw(&PathElement::new(corners, INK))?;
        for (part, label) in &self.labels[0] {
            let x = self.across(*part);
            self.area.draw(&PathElement::new([(x, bottom), (x, bottom + 4)], INK))?;
            centred(self.area, label, &style, (x, bottom + 7))?;
        }
        for (part, label) in &self.labels[1] {
            let y = self.down(*part);
            self.area.draw(&PathElement::new([(left - 4, y), (left, y)], INK))?;
            self.area.draw_text(label, &style, (left - 7 - width(self.area, label, &style)?, y + 2 - size / 2))?;
        }
        centred(self.area, along, &style, ((left + right) / 2, bottom + 12 + size + size / 2))?;
        let upright = style.transform(FontTransform::Rotate270);
        let middle = (top + bottom) / 2 + width(self.area, up, &font(self.text))? / 2;
        Ok(self.area.draw_text(up, &upright, (8, middle))?)
    }

    /// A curve, cut at the border; dashed if it is asked for.
    ///
    /// # Errors
    /// What the file says.
    pub fn line(
        &self,
        points: impl IntoIterator<Item = (f64, f64)>,
        style: impl Into<ShapeStyle>,
        dashed: bool,
    ) -> Outcome {
        let style = style.into();
        for piece in pieces(points.into_iter().map(|point| self.place(point)), self.edges()) {
            if dashed {
                self.area.draw(&DashedPathElement::new(piece, 7, 5, style))?;
            } else {
                self.area.draw(&PathElement::new(piece, style))?;
            }
        }
        Ok(())
    }

    /// Dots, those beyond the border left out.
    ///
    /// # Errors
    /// What the file says.
    pub fn dots(
        &self,
        points: impl IntoIterator<Item = (f64, f64)>,
        radius: i32,
        style: impl Into<ShapeStyle>,
    ) -> Outcome {
        let style = style.into();
        for pixel in points.into_iter().filter_map(|point| self.pixel(point)) {
            self.area.draw(&Circle::new(pixel, radius, style))?;
        }
        Ok(())
    }

    /// The inside of a closed curve. What leaves the border is pressed against it.
    ///
    /// # Errors
    /// What the file says.
    pub fn fill(&self, points: impl IntoIterator<Item = (f64, f64)>, style: impl Into<ShapeStyle>) -> Outcome {
        let [left, top, right, bottom] = self.edges();
        let pressed = |(x, y): (f64, f64)| (x.clamp(left, right) as i32, y.clamp(top, bottom) as i32);
        let outline: Vec<_> = points.into_iter().filter_map(|point| self.place(point)).map(pressed).collect();
        Ok(self.area.draw(&Polygon::new(outline, style))?)
    }

    /// Text beside a point, so many pixels away from it.
    ///
    /// # Errors
    /// What the file says.
    pub fn text(&self, point: (f64, f64), (right, down): (i32, i32), text: &str, style: &TextStyle<'_>) -> Outcome {
        if let Some((x, y)) = self.pixel(point) {
            self.area.draw_text(text, style, (x + right, y + down))?;
        }
        Ok(())
    }

    /// Clouds of points as one bitmap. It covers what was drawn before, hence it comes first.
    ///
    /// # Errors
    /// What the file says.
    pub fn clouds(&self, clouds: &[(&[(f64, f64)], RGBColor)]) -> Outcome {
        let [left, top, ..] = self.edges();
        let mut sheet = Cloud::new(self.size(), clouds.iter().map(|(points, _)| points.len()).sum());
        for &(points, colour) in clouds {
            for (x, y) in points.iter().filter_map(|point| self.place(*point)) {
                sheet.point(x - left, y - top, colour);
            }
        }
        let (size, bytes) = sheet.into_bytes();
        let bitmap: BitMapElement<'_, _> =
            BitMapElement::with_owned_buffer((self.border[0], self.border[1]), size, bytes)
                .ok_or("a bitmap without its pixels")?;
        Ok(self.area.draw(&bitmap)?)
    }

    /// Where a point lies, inside or not; `None` where its coordinates have no place on a scale.
    fn place(&self, (x, y): (f64, f64)) -> Option<(f64, f64)> {
        let [left, top, right, bottom] = self.edges();
        let (along, up) = self.scales[0].part(x).zip(self.scales[1].part(y))?;
        Some((left + along * (right - left), bottom + up * (top - bottom)))
    }

    /// The pixel of a point inside the border.
    fn pixel(&self, point: (f64, f64)) -> Option<(i32, i32)> {
        let [left, top, right, bottom] = self.edges();
        let (x, y) = self.place(point)?;
        let inside = (left..=right).contains(&x) && (top..=bottom).contains(&y);
        inside.then_some((x.round() as i32, y.round() as i32))
    }

    fn edges(&self) -> Border {
        self.border.map(f64::from)
    }

    fn across(&self, part: f64) -> i32 {
        self.border[0] + (part * f64::from(self.border[2] - self.border[0])).round() as i32
    }

    fn down(&self, part: f64) -> i32 {
        self.border[3] - (part * f64::from(self.border[3] - self.border[1])).round() as i32
    }
}
