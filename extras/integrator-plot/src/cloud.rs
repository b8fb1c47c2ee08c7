//! Millions of points as one bitmap: a pixel mixes the colours of its points, and more points give a deeper colour.

use crate::colour::Colour;

/// The share of its colour that the first point on a pixel leaves there. Each further point covers this share of what
/// is still white, so that densities up to some ten points per pixel can be distinguished.
const COVER: f64 = 0.45;

/// Where there are fewer points than one for this number of pixels, a point takes two pixels each way, so that it is
/// seen.
const SPARSE: usize = 15;

/// A sheet of pixels, white at first.
pub(crate) struct Cloud {
    size: (u32, u32),
    /// The number of pixels of a point, along and down.
    point: usize,
    pixels: Vec<[f32; 3]>,
}

impl Cloud {
    /// A sheet for this number of points.
    pub(crate) fn new(size: (u32, u32), points: usize) -> Self {
        let pixels = (size.0 * size.1) as usize;
        Self { size, point: if SPARSE * points < pixels { 2 } else { 1 }, pixels: vec![[255.0; 3]; pixels] }
    }

    /// A point at a pixel; nothing where it lies beyond the sheet.
    pub(crate) fn point(&mut self, x: f64, y: f64, Colour(red, green, blue): Colour) {
        let (width, height) = self.size;
        if !(x >= 0.0 && y >= 0.0 && x < f64::from(width) && y < f64::from(height)) {
            return;
        }
        let [width, height] = [width, height].map(|length| length as usize);
        for row in (y as usize..height).take(self.point) {
            for column in (x as usize..width).take(self.point) {
                for (part, ink) in self.pixels[row * width + column].iter_mut().zip([red, green, blue]) {
                    *part += COVER as f32 * (f32::from(ink) - *part);
                }
            }
        }
    }

    /// Three bytes per pixel.
    pub(crate) fn into_bytes(self) -> Vec<u8> {
        self.pixels.into_iter().flatten().map(|part| part.round() as u8).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Cloud;
    use crate::colour::Colour;

    #[test]
    fn points_deepen_the_colour_of_their_pixel_alone() {
        let mut cloud = Cloud::new((3, 2), 3);
        let ink = Colour(0, 0, 0);
        cloud.point(1.5, 0.5, ink);
        cloud.point(2.0, 1.0, ink);
        cloud.point(2.9, 1.9, ink);
        for (x, y) in [(-0.1, 0.0), (3.0, 0.0), (0.0, 2.0), (f64::NAN, 0.0)] {
            cloud.point(x, y, ink);
        }
        let (size, bytes) = (cloud.size, cloud.into_bytes());
        let grey: Vec<u8> = bytes.chunks(3).map(|pixel| pixel[0]).collect();
        assert_eq!(size, (3, 2));
        assert_eq!((grey[0], grey[2], grey[3], grey[4]), (255, 255, 255, 255));
        assert!(grey[5] < grey[1] && grey[1] < 255, "{grey:?}");
    }

    #[test]
    fn a_lonely_point_is_larger_and_stays_on_the_sheet() {
        let mut cloud = Cloud::new((10, 10), 2);
        cloud.point(3.0, 3.0, Colour(0, 0, 0));
        cloud.point(9.5, 9.5, Colour(0, 0, 0));
        let bytes = cloud.into_bytes();
        assert_eq!(bytes.iter().filter(|byte| **byte < 255).count(), 3 * (4 + 1));
    }
}
