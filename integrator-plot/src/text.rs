//! Fonts, and lines of text that are broken where they are too long.

use crate::{
    colour::INK,
    picture::{Area, Outcome},
};
use plotters::{prelude::*, style::FontStyle};
use std::error::Error;

/// The name that both files know the font by.
const FONT: &str = "sans-serif";

/// The font in a size, in ink.
#[must_use]
pub fn font(size: u32) -> TextStyle<'static> {
    (FONT, size).into_font().color(&INK)
}

/// The bold font in a size, in ink.
#[must_use]
pub fn bold(size: u32) -> TextStyle<'static> {
    (FONT, size, FontStyle::Bold).into_font().color(&INK)
}

/// How many pixels a line of text is wide.
pub(crate) fn width<B: DrawingBackend>(area: &Area<B>, text: &str, style: &TextStyle<'_>) -> Result<i32, Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    Ok(area.estimate_text_size(text, style)?.0 as i32)
}

/// Draws text from a place on, in lines of at most so many pixels. Returns where the next line would begin.
pub(crate) fn paragraph<B: DrawingBackend>(
    area: &Area<B>,
    text: &str,
    style: &TextStyle<'_>,
    [x, mut y]: [i32; 2],
    [at_most, leading]: [i32; 2],
) -> Result<i32, Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    let mut line = String::new();
    for word in text.split_whitespace() {
        let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
        if !line.is_empty() && width(area, &longer, style)? > at_most {
            area.draw_text(&line, style, (x, y))?;
            y += leading;
            line = word.to_owned();
        } else {
            line = longer;
        }
    }
    if !line.is_empty() {
        area.draw_text(&line, style, (x, y))?;
        y += leading;
    }
    Ok(y)
}

/// Draws text whose middle lies at a place along the horizontal.
pub(crate) fn centred<B: DrawingBackend>(
    area: &Area<B>,
    text: &str,
    style: &TextStyle<'_>,
    (x, y): (i32, i32),
) -> Outcome
where
    B::ErrorType: 'static,
{
    Ok(area.draw_text(text, style, (x - width(area, text, style)? / 2, y))?)
}
