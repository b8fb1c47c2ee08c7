//! Points by the million as one bitmap: a pixel takes the colours of all points on it, the more of them the deeper.

use plotters::style::RGBColor;

/// How much of its colour the first point on a pixel leaves there. Each further point covers as much of what is left
/// white, so that densities up to some ten points per pixel can be told apart.
const COVER: f64 = 0.45;

/// A sheet of pixels, white at first.
pub(crate) struct Cloud {
    size: (u32, u32),
    pixels: Vec<[f32; 3]>,
}

impl Cloud {
    pub(crate) fn new(size: (u32, u32)) -> Self {
        Self { size, pixels: vec![[255.0; 3]; (size.0 * size.1) as usize] }
    }

    /// A point at a pixel; nothing where it lies beyond the sheet.
    pub(crate) fn point(&mut self, x: f64, y: f64, RGBColor(red, green, blue): RGBColor) {
        let (width, height) = self.size;
        if !(x >= 0.0 && y >= 0.0 && x < f64::from(width) && y < f64::from(height)) {
            return;
        }
        let pixel = &mut self.pixels[y as usize * width as usize + x as usize];
        for (part, ink) in pixel.iter_mut().zip([red, green, blue]) {
            *part += COVER as f32 * (f32::from(ink) - *part);
        }
    }

    /// The size, and three bytes per pixel.
    pub(crate) fn into_bytes(self) -> ((u32, u32), Vec<u8>) {
        (self.size, self.pixels.into_iter().flatten().map(|part| part.round() as u8).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::Cloud;
    use plotters::style::RGBColor;

    #[test]
    fn points_deepen_the_colour_of_their_pixel_alone() {
        let mut cloud = Cloud::new((3, 2));
        let ink = RGBColor(0, 0, 0);
        cloud.point(1.5, 0.5, ink);
        cloud.point(2.0, 1.0, ink);
        cloud.point(2.9, 1.9, ink);
        for (x, y) in [(-0.1, 0.0), (3.0, 0.0), (0.0, 2.0), (f64::NAN, 0.0)] {
            cloud.point(x, y, ink);
        }
        let (size, bytes) = cloud.into_bytes();
        let grey: Vec<u8> = bytes.chunks(3).map(|pixel| pixel[0]).collect();
        assert_eq!(size, (3, 2));
        assert_eq!((grey[0], grey[2], grey[3], grey[4]), (255, 255, 255, 255));
        assert!(grey[5] < grey[1] && grey[1] < 255, "{grey:?}");
    }
}
