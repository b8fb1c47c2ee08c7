//! Fonts: widths of text, and outlines of letters.

use crate::colour::{Colour, INK};
use std::error::Error;
use ttf_parser::{Face, GlyphId, OutlineBuilder};
use zeno::Command;

/// The position of a text in relation to its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Begin,
    Middle,
    End,
}

/// A font with its size, its colour and the alignment of the text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Font {
    pub(crate) size: f64,
    pub(crate) bold: bool,
    pub(crate) colour: Colour,
    pub(crate) anchor: Anchor,
    pub(crate) upright: bool,
}

/// Returns the regular font of a size, in [`INK`].
#[must_use]
pub const fn font(size: f64) -> Font {
    Font { size, bold: false, colour: INK, anchor: Anchor::Begin, upright: false }
}

/// Returns the bold font of a size, in [`INK`].
#[must_use]
pub const fn bold(size: f64) -> Font {
    Font { bold: true, ..font(size) }
}

impl Font {
    /// Sets the colour.
    #[must_use]
    pub const fn coloured(self, colour: Colour) -> Self {
        Self { colour, ..self }
    }

    /// Centres the text at its position.
    #[must_use]
    pub const fn centred(self) -> Self {
        Self { anchor: Anchor::Middle, ..self }
    }

    /// Ends the text at its position.
    #[must_use]
    pub const fn ending(self) -> Self {
        Self { anchor: Anchor::End, ..self }
    }

    /// Rotates the text so that it runs upwards.
    #[must_use]
    pub const fn upwards(self) -> Self {
        Self { upright: true, ..self }
    }
}

/// The two typefaces of all pictures.
#[derive(Clone, Debug)]
pub(crate) struct Typefaces {
    regular: Face<'static>,
    bold: Face<'static>,
}

impl Typefaces {
    /// # Errors
    /// Fonts that are no fonts.
    pub(crate) fn new() -> Result<Self, Box<dyn Error>> {
        let face = |bytes| Face::parse(bytes, 0);
        Ok(Self { regular: face(dejavu::sans::regular())?, bold: face(dejavu::sans::bold())? })
    }

    fn face(&self, font: &Font) -> &Face<'static> {
        if font.bold { &self.bold } else { &self.regular }
    }

    /// Returns the width of a line of text, in pixels.
    pub(crate) fn width(&self, text: &str, font: &Font) -> f64 {
        self.letters(text, font).last().map_or(0.0, |(_, begin, advance)| begin + advance)
    }

    /// Each letter, with where it begins and how far the next one is, in pixels.
    fn letters(&self, text: &str, font: &Font) -> impl Iterator<Item = (GlyphId, f64, f64)> {
        let face = self.face(font);
        let pixels = font.size / f64::from(face.units_per_em());
        let kerning = face.tables().kern.and_then(|table| table.subtables.into_iter().next());
        let (mut x, mut before) = (0.0, None);
        text.chars().map(move |letter| {
            // Letters that the typeface lacks are drawn as its sign for them.
            let glyph = face.glyph_index(letter).unwrap_or_default();
            let closer = before.zip(kerning.as_ref()).and_then(|(before, table)| table.glyphs_kerning(before, glyph));
            let begin = x + f64::from(closer.unwrap_or(0)) * pixels;
            let advance = f64::from(face.glyph_hor_advance(glyph).unwrap_or(0)) * pixels;
            (x, before) = (begin + advance, Some(glyph));
            (glyph, begin, advance)
        })
    }

    /// The outlines of a text whose baseline goes through a place.
    pub(crate) fn outlines(&self, text: &str, font: &Font, at: (f64, f64)) -> Vec<Command> {
        let face = self.face(font);
        let pixels = font.size / f64::from(face.units_per_em());
        let shift = match font.anchor {
            Anchor::Begin => 0.0,
            Anchor::Middle => -0.5 * self.width(text, font),
            Anchor::End => -self.width(text, font),
        };
        let mut outline = Outline { commands: Vec::new(), pixels, at, along: 0.0, upright: font.upright };
        for (glyph, begin, _) in self.letters(text, font) {
            outline.along = begin + shift;
            face.outline_glyph(glyph, &mut outline);
        }
        outline.commands
    }
}

/// Collects outlines in pixels.
struct Outline {
    commands: Vec<Command>,
    pixels: f64,
    at: (f64, f64),
    along: f64,
    upright: bool,
}

impl Outline {
    fn place(&self, x: f32, y: f32) -> zeno::Point {
        let (along, up) = (self.along + f64::from(x) * self.pixels, f64::from(y) * self.pixels);
        let (x, y) = if self.upright { (-up, -along) } else { (along, -up) };
        zeno::Point::new((self.at.0 + x) as f32, (self.at.1 + y) as f32)
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.commands.push(Command::MoveTo(self.place(x, y)));
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.commands.push(Command::LineTo(self.place(x, y)));
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.commands.push(Command::QuadTo(self.place(x1, y1), self.place(x, y)));
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.commands.push(Command::CurveTo(self.place(x1, y1), self.place(x2, y2), self.place(x, y)));
    }
    fn close(&mut self) {
        self.commands.push(Command::Close);
    }
}

#[cfg(test)]
mod tests {
    use super::{Typefaces, bold, font};

    #[test]
    fn widths_grow_with_size_weight_and_length() {
        let faces = Typefaces::new().expect("fonts");
        let width = |text, font| faces.width(text, &font);
        assert!((width("energy", font(20.0)) - 2.0 * width("energy", font(10.0))).abs() < 1e-9);
        assert!(width("energy", bold(10.0)) > width("energy", font(10.0)));
        assert_eq!(width("", font(10.0)), 0.0);
        // Of the letters of "AV" the second one reaches below the first.
        assert!(width("AV", font(100.0)) < width("A", font(100.0)) + width("V", font(100.0)));
    }
}
