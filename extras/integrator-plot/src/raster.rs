//! A picture as pixels, with antialiasing: the colour of a shape is weighted by the covered fraction of a pixel.

use crate::{
    canvas::{self, Canvas, Place, Shape},
    colour::Colour,
    text::Font,
};
use zeno::{Cap, Command, Fill, Join, Mask, PathBuilder, Point, Stroke, Style};

/// Returns three bytes for each pixel, row after row, of the canvas enlarged by a factor.
pub(crate) fn pixels(canvas: &Canvas, times: u32) -> Vec<u8> {
    let size = [canvas.size.0, canvas.size.1].map(|length| (length * times) as usize);
    let times = f64::from(times);
    let place = |(x, y): Place| (times * x, times * y);
    let places = |places: &[Place]| places.iter().map(|at| place(*at)).collect::<Vec<_>>();
    let mut sheet = Sheet { size, pixels: vec![255; 3 * size[0] * size[1]] };
    for shape in &canvas.shapes {
        match shape {
            Shape::Line { points, stroke } => sheet.line(&places(points), stroke, times),
            Shape::Filled { corners, colour, opacity } => {
                sheet.cover(&path(&places(corners), true), Fill::NonZero.into(), *colour, *opacity);
            }
            Shape::Disc { centre, radius, colour } => {
                let mut circle = Vec::new();
                circle.add_circle(point(place(*centre)), (times * radius) as f32);
                sheet.cover(&circle, Fill::NonZero.into(), *colour, 1.0);
            }
            Shape::Text { text, at, font } => {
                let larger = Font { size: times * font.size, ..*font };
                let outlines = canvas.typefaces.outlines(text, &larger, place(*at));
                sheet.cover(&outlines, Fill::NonZero.into(), font.colour, 1.0);
            }
            Shape::Begin { .. } | Shape::End => {}
            Shape::Bitmap { at, size, columns, bytes } => sheet.enlarge(place(*at), place(*size), *columns, bytes),
        }
    }
    sheet.pixels
}

fn point((x, y): Place) -> Point {
    Point::new(x as f32, y as f32)
}

fn path(points: &[Place], closed: bool) -> Vec<Command> {
    let begin = points.iter().take(1).map(|place| Command::MoveTo(point(*place)));
    let rest = points.iter().skip(1).map(|place| Command::LineTo(point(*place)));
    begin.chain(rest).chain(closed.then_some(Command::Close)).collect()
}

struct Sheet {
    size: [usize; 2],
    pixels: Vec<u8>,
}

/// The coverage of each pixel of a part of the sheet: 255 for all of it.
struct Cover {
    left: usize,
    top: usize,
    columns: usize,
    covered: Vec<u8>,
}

/// The number of points of a line that are rasterised together: the time for a row grows with the square of the edges
/// that cross it.
const CHUNK: usize = 64;

impl Sheet {
    /// Returns the coverage by a path; `None` where the path lies beyond the sheet.
    fn covered(&self, path: &Vec<Command>, style: Style<'_>) -> Option<Cover> {
        let bounds = zeno::bounds(path, style, None);
        let [width, height] = self.size;
        // The pixels that the path may reach, as far as they are on the sheet.
        let part = |least: f32, most: f32, length: usize| {
            [least.floor().clamp(0.0, length as f32) as usize, most.ceil().clamp(0.0, length as f32) as usize]
        };
        let [left, right] = part(bounds.min.x, bounds.max.x, width);
        let [top, bottom] = part(bounds.min.y, bounds.max.y, height);
        if left >= right || top >= bottom {
            return None;
        }
        let columns = right - left;
        let (covered, _) = Mask::new(path)
            .style(style)
            .offset((-(left as f32), -(top as f32)))
            .size(columns as u32, (bottom - top) as u32)
            .render();
        Some(Cover { left, top, columns, covered })
    }

    /// Lays colour over what a path covers.
    fn cover(&mut self, path: &Vec<Command>, style: Style<'_>, colour: Colour, opacity: f64) {
        if let Some(cover) = self.covered(path, style) {
            self.lay(&cover, colour, opacity);
        }
    }

    /// Draws a line. Its chunks overlap in round ends, and a pixel takes the most that any of them covers of it, so that
    /// nothing is seen of them.
    fn line(&mut self, points: &[Place], stroke: &canvas::Stroke, times: f64) {
        let dashes: Vec<f32> = stroke.dashes.iter().map(|dash| times as f32 * dash).collect();
        let style = |first: bool, last: bool, length: f64| {
            let cap = |outer: bool| if outer { Cap::Butt } else { Cap::Round };
            let caps = if dashes.is_empty() { [cap(first), cap(last)] } else { [Cap::Butt; 2] };
            let mut style = Stroke::new((times * stroke.width) as f32);
            style.join(Join::Round).caps(caps[0], caps[1]).dash(&dashes, length as f32);
            style
        };
        if points.len() <= CHUNK {
            return self.cover(&path(points, false), style(true, true, 0.0).into(), stroke.colour, 1.0);
        }
        let [width, height] = self.size;
        let mut all = Cover { left: 0, top: 0, columns: width, covered: vec![0; width * height] };
        let (mut begin, mut length) = (0, 0.0);
        while begin + 1 < points.len() {
            let end = (begin + CHUNK).min(points.len() - 1);
            let chunk = &points[begin..=end];
            let style = style(begin == 0, end + 1 == points.len(), length);
            if let Some(cover) = self.covered(&path(chunk, false), style.into()) {
                all.most_of(&cover);
            }
            // The phase of the dashes continues from chunk to chunk, modulo their length.
            length += chunk.windows(2).map(|ends| (ends[1].0 - ends[0].0).hypot(ends[1].1 - ends[0].1)).sum::<f64>();
            let period = f64::from(dashes.iter().sum::<f32>());
            if period > 0.0 {
                length %= period;
            }
            begin = end;
        }
        self.lay(&all, stroke.colour, 1.0);
    }

    /// Lays colour over the sheet, as much as is covered of each pixel.
    fn lay(&mut self, cover: &Cover, Colour(red, green, blue): Colour, opacity: f64) {
        let opacity = (256.0 * opacity) as u32;
        for (row, covered) in cover.covered.chunks(cover.columns).enumerate() {
            let begin = 3 * ((cover.top + row) * self.size[0] + cover.left);
            let pixels = self.pixels[begin..begin + 3 * cover.columns].chunks_exact_mut(3);
            for (pixel, covered) in pixels.zip(covered).filter(|(_, covered)| **covered > 0) {
                let share = u32::from(*covered) * opacity;
                for (part, ink) in pixel.iter_mut().zip([red, green, blue]) {
                    // In units of 255 · 256, rounded.
                    let mixed = u32::from(*part) * (65280 - share) + u32::from(ink) * share + 32640;
                    *part = (mixed / 65280) as u8;
                }
            }
        }
    }

    /// Draws a bitmap, each of its pixels as a rectangle.
    fn enlarge(&mut self, (x, y): Place, size: (f64, f64), columns: usize, bytes: &[u8]) {
        let rows = bytes.len() / (3 * columns);
        let [width, height] = self.size;
        let span = |from: f64, length: f64, most: usize| {
            from.round().clamp(0.0, most as f64) as usize..(from + length).round().clamp(0.0, most as f64) as usize
        };
        // The pixel of the bitmap under the middle of one of the sheet.
        let under = |place: usize, from: f64, length: f64, count: usize| {
            ((((place as f64 + 0.5 - from) / length) * count as f64).max(0.0) as usize).min(count - 1)
        };
        for row in span(y, size.1, height) {
            let from = under(row, y, size.1, rows);
            for column in span(x, size.0, width) {
                let pixel = 3 * (from * columns + under(column, x, size.0, columns));
                let to = 3 * (row * width + column);
                self.pixels[to..to + 3].copy_from_slice(&bytes[pixel..pixel + 3]);
            }
        }
    }
}

impl Cover {
    /// The larger of both covers, for every pixel of the other one, which lies within this one.
    fn most_of(&mut self, other: &Cover) {
        for (row, covered) in other.covered.chunks(other.columns).enumerate() {
            let begin = (other.top - self.top + row) * self.columns + other.left - self.left;
            for (here, there) in self.covered[begin..begin + other.columns].iter_mut().zip(covered) {
                *here = (*here).max(*there);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::pixels;
    use crate::{Canvas, Marker, Stroke, bold, colour::Colour, font};

    const BLACK: Colour = Colour(0, 0, 0);

    /// The red of each pixel of a sheet of 20 by 20, white being 255.
    fn drawn(draw: impl FnOnce(&mut Canvas)) -> Vec<u8> {
        let mut canvas = Canvas::new((20, 20)).expect("fonts");
        draw(&mut canvas);
        pixels(&canvas, 1).chunks(3).map(|pixel| pixel[0]).collect()
    }

    #[test]
    fn a_line_that_goes_back_over_itself_has_no_holes() {
        let there_and_back = [(2.5, 2.5), (17.5, 17.5), (2.5, 2.5), (17.5, 17.5)];
        let pixels = drawn(|canvas| canvas.line(there_and_back, Stroke::new(BLACK, 3.0)));
        assert!((3..=16).all(|i| pixels[i * 20 + i] == 0), "{pixels:?}");
        assert_eq!(pixels[2 * 20 + 17], 255);
    }

    #[test]
    fn a_line_between_pixels_covers_a_part_of_each() {
        // From 9.75 to 10.75: three quarters of one row are left white, and a quarter of the next.
        let pixels = drawn(|canvas| canvas.line([(0.0, 10.25), (20.0, 10.25)], Stroke::new(BLACK, 1.0)));
        let column: Vec<u8> = (8..13).map(|row| pixels[row * 20 + 10]).collect();
        assert!(column[0] == 255 && column[3] == 255 && column[4] == 255, "{column:?}");
        assert!(column[1].abs_diff(191) < 4 && column[2].abs_diff(64) < 4, "{column:?}");
    }

    /// A line of many points looks like the same line of two.
    #[test]
    fn chunks_of_a_line_are_not_seen() {
        let stroke = Stroke::new(BLACK, 2.5);
        for stroke in [stroke, stroke.dashed(&[3.0, 2.0])] {
            let ends = [(1.0, 2.0), (19.0, 15.0)];
            let many = (0..=300).map(|i| f64::from(i) / 300.0).map(|part| (1.0 + 18.0 * part, 2.0 + 13.0 * part));
            let (few, many) = (drawn(|canvas| canvas.line(ends, stroke)), drawn(|canvas| canvas.line(many, stroke)));
            let apart = few.iter().zip(&many).map(|(a, b)| a.abs_diff(*b)).max();
            assert!(apart < Some(24), "{apart:?} of {stroke:?}");
        }
    }

    #[test]
    fn letters_stand_on_their_baseline() {
        let pixels = drawn(|canvas| canvas.text("HI", (2.0, 15.0), font(16.0)));
        let dark: Vec<usize> = (0..400).filter(|place| pixels[*place] < 128).collect();
        let rows = dark.iter().map(|place| place / 20);
        // Capitals of the typeface are 0.73 of the size high.
        assert_eq!((rows.clone().min(), rows.max()), (Some(3), Some(14)));
        // Of what does not fit, the rest is not drawn.
        drawn(|canvas| canvas.text("a long text", (10.0, 30.0), bold(20.0)));
    }

    #[test]
    fn a_disc_at_the_border_is_cut_and_one_beyond_is_not_drawn() {
        let pixels = drawn(|canvas| {
            canvas.marker(Marker::Disc, (0.0, 19.0), 4.0, BLACK);
            canvas.marker(Marker::Disc, (1e9, -1e9), 4.0, BLACK);
        });
        assert_eq!((pixels[19 * 20], pixels[10 * 20 + 10]), (0, 255));
        assert_eq!(
            pixels.iter().filter(|red| **red < 255).count(),
            pixels.iter().enumerate().filter(|(i, red)| **red < 255 && i % 20 < 5 && i / 20 > 13).count()
        );
    }

    /// Twice the size is the same picture: the mean of four pixels is one of those before, up to the edges of shapes.
    #[test]
    fn a_magnified_picture_is_the_same_picture() {
        let mut canvas = Canvas::new((20, 20)).expect("fonts");
        canvas.line([(2.0, 3.0), (18.0, 12.0)], Stroke::new(BLACK, 2.0).dashed(&[4.0, 3.0]));
        canvas.text("a", (3.0, 17.0), font(12.0));
        canvas.bitmap((12.0, 13.0), (4.0, 4.0), 1, vec![0, 0, 0]);
        let (once, twice) = (pixels(&canvas, 1), pixels(&canvas, 2));
        assert_eq!(twice.len(), 4 * once.len());
        for (place, red) in once.chunks(3).map(|pixel| pixel[0]).enumerate() {
            let (x, y) = (2 * (place % 20), 2 * (place / 20));
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(dx, dy)| u16::from(twice[3 * ((y + dy) * 40 + x + dx)]));
            assert!((four.iter().sum::<u16>() / 4).abs_diff(red.into()) < 20, "{place}: {four:?} and {red}");
        }
    }

    #[test]
    fn a_bitmap_is_enlarged() {
        let pixels = drawn(|canvas| canvas.bitmap((4.0, 4.0), (8.0, 4.0), 2, vec![0, 0, 0, 90, 90, 90]));
        let row: Vec<u8> = (2..14).map(|column| pixels[5 * 20 + column]).collect();
        assert_eq!(row, [255, 255, 0, 0, 0, 0, 90, 90, 90, 90, 255, 255]);
    }
}
