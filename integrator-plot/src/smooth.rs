//! Lines, dots and letters of a bitmap with smooth edges.
//!
//! The backend of plotters fills the outline of a wide line in one piece, which leaves holes where the line crosses itself,
//! dots are stairs, and letters begin at whole pixels without the space that belongs before them. Here every pixel takes as
//! much colour as is covered of it.

use ab_glyph::{Font, FontRef, InvalidFont, ScaleFont, point};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontStyle,
};

/// A bitmap whose lines, dots and letters are drawn here, and everything else there.
pub(crate) struct Smooth<B> {
    bitmap: B,
    regular: FontRef<'static>,
    bold: FontRef<'static>,
}

/// Where letters stand below the upper end of a text, in units of its size: where an SVG has them, 0.76 of an em below,
/// with 1.24 times an em for the size.
const BASELINE: f32 = 0.76 / 1.24;

type Drawn<B> = Result<(), DrawingErrorKind<<B as DrawingBackend>::ErrorType>>;

impl<B> Smooth<B> {
    /// # Errors
    /// Fonts that are no fonts.
    pub(crate) fn new(bitmap: B) -> Result<Self, InvalidFont> {
        let [regular, bold] = [dejavu::sans::regular(), dejavu::sans::bold()].map(FontRef::try_from_slice);
        Ok(Self { bitmap, regular: regular?, bold: bold? })
    }
}

impl<B: DrawingBackend> Smooth<B> {
    /// Everything that is nearer to a segment than the radius.
    fn capsule(&mut self, [from, to]: [BackendCoord; 2], radius: f64, colour: BackendColor) -> Drawn<B> {
        let (width, height) = self.bitmap.get_size();
        let reach = radius.ceil() as i32 + 1;
        let columns = (from.0.min(to.0) - reach).max(0)..=(from.0.max(to.0) + reach).min(width as i32 - 1);
        let rows = (from.1.min(to.1) - reach).max(0)..=(from.1.max(to.1) + reach).min(height as i32 - 1);
        let (dx, dy) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
        let length_squared = dx * dx + dy * dy;
        for y in rows {
            for x in columns.clone() {
                let (px, py) = (f64::from(x - from.0), f64::from(y - from.1));
                let along = if length_squared > 0.0 { (px * dx + py * dy) / length_squared } else { 0.0 };
                let along = along.clamp(0.0, 1.0);
                let covered = (radius + 0.5 - (px - along * dx).hypot(py - along * dy)).clamp(0.0, 1.0);
                if covered > 0.0 {
                    self.bitmap.draw_pixel((x, y), colour.mix(covered))?;
                }
            }
        }
        Ok(())
    }
}

impl<B: DrawingBackend> DrawingBackend for Smooth<B> {
    type ErrorType = B::ErrorType;

    fn get_size(&self) -> (u32, u32) {
        self.bitmap.get_size()
    }
    fn ensure_prepared(&mut self) -> Drawn<B> {
        self.bitmap.ensure_prepared()
    }
    fn present(&mut self) -> Drawn<B> {
        self.bitmap.present()
    }
    fn draw_pixel(&mut self, point: BackendCoord, colour: BackendColor) -> Drawn<B> {
        self.bitmap.draw_pixel(point, colour)
    }
    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn<B> {
        self.bitmap.draw_line(from, to, style)
    }
    fn draw_rect<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S, fill: bool) -> Drawn<B> {
        self.bitmap.draw_rect(from, to, style, fill)
    }
    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Drawn<B> {
        let path: Vec<_> = path.into_iter().collect();
        // Lines of one pixel are axes and grids, which are as sharp as they can be.
        if style.stroke_width() <= 1 {
            return self.bitmap.draw_path(path, style);
        }
        for ends in path.windows(2) {
            self.capsule([ends[0], ends[1]], 0.5 * f64::from(style.stroke_width()), style.color())?;
        }
        Ok(())
    }
    fn draw_circle<S: BackendStyle>(&mut self, centre: BackendCoord, radius: u32, style: &S, fill: bool) -> Drawn<B> {
        if fill {
            return self.capsule([centre, centre], f64::from(radius), style.color());
        }
        self.bitmap.draw_circle(centre, radius, style, fill)
    }
    /// Texts are anchored at their upper left corner.
    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Drawn<B> {
        let font = if matches!(style.style(), FontStyle::Bold) { &self.bold } else { &self.regular };
        let size = style.size() as f32;
        let (font, turn, colour) = (font.as_scaled(size), style.transform(), style.color());
        let (mut x, mut before) = (0.0, None);
        let mut covered = Vec::new();
        for letter in text.chars() {
            let glyph = font.glyph_id(letter);
            x += before.map_or(0.0, |before| font.kern(before, glyph));
            if let Some(outline) = font.outline_glyph(glyph.with_scale_and_position(size, point(x, BASELINE * size))) {
                let corner = outline.px_bounds().min;
                outline.draw(|column, row, part| {
                    let (x, y) = turn.transform(corner.x as i32 + column as i32, corner.y as i32 + row as i32);
                    covered.push(((at.0 + x, at.1 + y), part));
                });
            }
            x += font.h_advance(glyph);
            before = Some(glyph);
        }
        let (width, height) = self.bitmap.get_size();
        for ((x, y), part) in covered {
            if (0..width as i32).contains(&x) && (0..height as i32).contains(&y) && part > 0.0 {
                self.bitmap.draw_pixel((x, y), colour.mix(part.min(1.0).into()))?;
            }
        }
        Ok(())
    }
    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Drawn<B> {
        self.bitmap.fill_polygon(corners, style)
    }
    fn blit_bitmap(&mut self, at: BackendCoord, size: (u32, u32), bytes: &[u8]) -> Drawn<B> {
        self.bitmap.blit_bitmap(at, size, bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::Smooth;
    use plotters::prelude::*;

    /// The red of each pixel, white being 255.
    fn drawn(draw: impl FnOnce(&mut Smooth<BitMapBackend<'_>>)) -> Vec<u8> {
        let mut bytes = vec![255; 20 * 20 * 3];
        draw(&mut Smooth::new(BitMapBackend::with_buffer(&mut bytes, (20, 20))).expect("fonts"));
        bytes.chunks(3).map(|pixel| pixel[0]).collect()
    }

    #[test]
    fn a_line_that_goes_back_over_itself_has_no_holes() {
        let pixels = drawn(|bitmap| {
            let there_and_back = [(2, 2), (17, 17), (2, 2), (17, 17)];
            bitmap.draw_path(there_and_back, &BLACK.stroke_width(3)).expect("a line");
        });
        assert!((2..=17).all(|i| pixels[i * 20 + i] == 0), "{pixels:?}");
        assert_eq!(pixels[2 * 20 + 17], 255);
    }

    #[test]
    fn letters_stand_between_their_upper_end_and_their_baseline() {
        let pixels = drawn(|bitmap| bitmap.draw_text("HI", &crate::font(16), (2, 3)).expect("a text"));
        let dark: Vec<usize> = (0..400).filter(|place| pixels[*place] < 128).collect();
        let rows = dark.iter().map(|place| place / 20);
        // The baseline is 16 · 0.76 / 1.24 = 9.8 below the upper end, and capitals are 10 high.
        assert_eq!((rows.clone().min(), rows.max()), (Some(3), Some(12)));
        assert!(dark.iter().all(|place| (2..18).contains(&(place % 20))), "{dark:?}");
        // Of what does not fit, the rest is not drawn.
        drawn(|bitmap| bitmap.draw_text("a long text", &crate::bold(20), (10, 10)).expect("a part of it"));
    }

    #[test]
    fn a_dot_at_the_border_is_cut() {
        let pixels = drawn(|bitmap| bitmap.draw_circle((0, 19), 4, &BLACK.filled(), true).expect("a dot"));
        assert_eq!((pixels[19 * 20], pixels[10 * 20 + 10]), (0, 255));
    }
}
