//! A picture as SVG.

use crate::{
    canvas::{Canvas, Place, Shape, Stroke},
    png,
    text::{Anchor, Font},
};
use std::fmt::Write;

/// The families that are requested: that of the PNG, then one of the same widths, then any.
const FAMILIES: &str = "DejaVu Sans, Verdana, sans-serif";

/// The text of the file.
pub(crate) fn text(canvas: &Canvas) -> String {
    let (width, height) = canvas.size;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"{FAMILIES}\" stroke-linejoin=\"round\">\n<rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n"
    );
    for shape in &canvas.shapes {
        // Text in memory takes whatever is written.
        let _ = element(&mut svg, shape);
    }
    svg.push_str("</svg>\n");
    svg
}

fn element(svg: &mut String, shape: &Shape) -> std::fmt::Result {
    match shape {
        Shape::Line { points, stroke } => {
            let Stroke { colour, width, dashes } = stroke;
            write!(svg, "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\"", colour.hexadecimal())?;
            if !dashes.is_empty() {
                let lengths: Vec<String> = dashes.iter().map(f32::to_string).collect();
                write!(svg, " stroke-dasharray=\"{}\"", lengths.join(" "))?;
            }
            writeln!(svg, " points=\"{}\"/>", Points(points))
        }
        Shape::Filled { corners, colour, opacity } => {
            write!(svg, "<polygon fill=\"{}\"", colour.hexadecimal())?;
            if *opacity < 1.0 {
                write!(svg, " fill-opacity=\"{opacity}\"")?;
            }
            writeln!(svg, " points=\"{}\"/>", Points(corners))
        }
        Shape::Disc { centre, radius, colour } => {
            let (x, y) = (Rounded(centre.0), Rounded(centre.1));
            writeln!(
                svg,
                "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\" fill=\"{}\"/>",
                Rounded(*radius),
                colour.hexadecimal()
            )
        }
        Shape::Begin { title, optional } => {
            let class = if *optional { " class=\"more\"" } else { "" };
            writeln!(svg, "<g{class}><title>{}</title>", escaped(title))
        }
        Shape::End => writeln!(svg, "</g>"),
        Shape::Text { text, at, font } => written(svg, text, *at, font),
        Shape::Bitmap { at, size, columns, bytes } => {
            let rows = bytes.len() / (3 * columns);
            let image = png::encoded((*columns as u32, rows as u32), bytes);
            writeln!(
                svg,
                "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
                 style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{}\"/>",
                Rounded(at.0),
                Rounded(at.1),
                Rounded(size.0),
                Rounded(size.1),
                base64(&image)
            )
        }
    }
}

fn written(svg: &mut String, text: &str, at: Place, font: &Font) -> std::fmt::Result {
    let (x, y) = (Rounded(at.0), Rounded(at.1));
    write!(svg, "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" fill=\"{}\"", font.size, font.colour.hexadecimal())?;
    if font.bold {
        svg.push_str(" font-weight=\"bold\"");
    }
    match font.anchor {
        Anchor::Begin => {}
        Anchor::Middle => svg.push_str(" text-anchor=\"middle\""),
        Anchor::End => svg.push_str(" text-anchor=\"end\""),
    }
    if font.upright {
        write!(svg, " transform=\"rotate(-90 {x} {y})\"")?;
    }
    writeln!(svg, ">{}</text>", escaped(text))
}

/// Text in which no character means anything to XML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// A coordinate to a hundredth of a pixel.
struct Rounded(f64);

impl std::fmt::Display for Rounded {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let hundredths = (100.0 * self.0).round() / 100.0;
        write!(to, "{}", if hundredths == 0.0 { 0.0 } else { hundredths })
    }
}

struct Points<'p>(&'p [Place]);

impl std::fmt::Display for Points<'_> {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (i, (x, y)) in self.0.iter().enumerate() {
            let space = if i == 0 { "" } else { " " };
            write!(to, "{space}{},{}", Rounded(*x), Rounded(*y))?;
        }
        Ok(())
    }
}

/// Bytes as text: each three of them as four letters, of six bits each.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let bits = chunk.iter().enumerate().fold(0_u32, |bits, (i, byte)| bits | u32::from(*byte) << (16 - 8 * i));
        for i in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * i) & 63) as usize];
            text.push(if i <= chunk.len() { char::from(letter) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::base64;
    use crate::{Canvas, Stroke, colour::INK, font};

    #[test]
    fn base64_is_that_of_the_standard() {
        // The test vectors of RFC 4648.
        let vectors =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("foobar", "Zm9vYmFy")];
        for (bytes, text) in vectors {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }

    #[test]
    fn places_are_parts_of_pixels_and_texts_are_escaped() {
        let mut canvas = Canvas::new((10, 10)).expect("fonts");
        canvas.line([(1.2345, -0.001), (f64::NAN, 1.0), (3.5, 4.0)], Stroke::new(INK, 1.5).dashed(&[3.0, 2.0]));
        canvas.text("a < b & c", (1.0, 2.0), font(12.0).upwards());
        let svg = canvas.svg();
        for part in
            ["points=\"1.23,0 3.5,4\"", "stroke-dasharray=\"3 2\"", ">a &lt; b &amp; c</text>", "rotate(-90 1 2)"]
        {
            assert!(svg.contains(part), "{part} is missing in {svg}");
        }
    }
}
