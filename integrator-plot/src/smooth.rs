//! Lines and dots of a bitmap with smooth edges.
//!
//! The backend of plotters fills the outline of a wide line in one piece, which leaves holes where the line crosses itself,
//! and dots are stairs. Here every pixel takes as much colour as the line or the dot covers of it.

use plotters_backend::{BackendColor, BackendCoord, BackendStyle, DrawingBackend, DrawingErrorKind};

/// A bitmap whose lines and dots are drawn here, and everything else there.
pub(crate) struct Smooth<B>(pub(crate) B);

type Drawn<B> = Result<(), DrawingErrorKind<<B as DrawingBackend>::ErrorType>>;

impl<B: DrawingBackend> Smooth<B> {
    /// Everything that is nearer to a segment than the radius.
    fn capsule(&mut self, [from, to]: [BackendCoord; 2], radius: f64, colour: BackendColor) -> Drawn<B> {
        let (width, height) = self.0.get_size();
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
                    self.0.draw_pixel((x, y), colour.mix(covered))?;
                }
            }
        }
        Ok(())
    }
}

impl<B: DrawingBackend> DrawingBackend for Smooth<B> {
    type ErrorType = B::ErrorType;

    fn get_size(&self) -> (u32, u32) {
        self.0.get_size()
    }
    fn ensure_prepared(&mut self) -> Drawn<B> {
        self.0.ensure_prepared()
    }
    fn present(&mut self) -> Drawn<B> {
        self.0.present()
    }
    fn draw_pixel(&mut self, point: BackendCoord, colour: BackendColor) -> Drawn<B> {
        self.0.draw_pixel(point, colour)
    }
    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn<B> {
        self.0.draw_line(from, to, style)
    }
    fn draw_rect<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S, fill: bool) -> Drawn<B> {
        self.0.draw_rect(from, to, style, fill)
    }
    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Drawn<B> {
        let path: Vec<_> = path.into_iter().collect();
        // Lines of one pixel are axes and grids, which are as sharp as they can be.
        if style.stroke_width() <= 1 {
            return self.0.draw_path(path, style);
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
        self.0.draw_circle(centre, radius, style, fill)
    }
    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Drawn<B> {
        self.0.fill_polygon(corners, style)
    }
    fn blit_bitmap(&mut self, at: BackendCoord, size: (u32, u32), bytes: &[u8]) -> Drawn<B> {
        self.0.blit_bitmap(at, size, bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::Smooth;
    use plotters::prelude::*;

    /// The red of each pixel, white being 255.
    fn drawn(draw: impl FnOnce(&mut Smooth<BitMapBackend<'_>>)) -> Vec<u8> {
        let mut bytes = vec![255; 20 * 20 * 3];
        draw(&mut Smooth(BitMapBackend::with_buffer(&mut bytes, (20, 20))));
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
    fn a_dot_at_the_border_is_cut() {
        let pixels = drawn(|bitmap| bitmap.draw_circle((0, 19), 4, &BLACK.filled(), true).expect("a dot"));
        assert_eq!((pixels[19 * 20], pixels[10 * 20 + 10]), (0, 255));
    }
}
