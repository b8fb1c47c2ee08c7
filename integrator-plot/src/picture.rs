//! What is written as two files.

use crate::{
    smooth::Smooth,
    text::{bold, font, paragraph},
};
use plotters::{
    coord::Shift,
    prelude::*,
    style::{FontStyle, register_font},
};
use std::{error::Error, fs, path::Path};

/// Nothing, or why there is no picture.
pub type Outcome = Result<(), Box<dyn Error>>;

/// A part of a picture, in pixels.
pub type Area<B> = DrawingArea<B, Shift>;

/// What is drawn onto either kind of file.
pub trait Picture {
    /// Width and height in pixels.
    fn size(&self) -> (u32, u32);
    /// Draws onto an area of this size.
    ///
    /// # Errors
    /// What the file says.
    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Outcome
    where
        B::ErrorType: 'static;
}

/// Writes `<file>.svg` and `<file>.png`, and the folder if there is none.
///
/// # Errors
/// If a file cannot be written.
pub fn write(file: &Path, picture: &impl Picture) -> Outcome {
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder)?;
    }
    for (style, font) in [(FontStyle::Normal, dejavu::sans::regular()), (FontStyle::Bold, dejavu::sans::bold())] {
        register_font("sans-serif", style, font).map_err(|_| "a font that cannot be read")?;
    }
    let (svg, png) = (file.with_extension("svg"), file.with_extension("png"));
    let area = SVGBackend::new(&svg, picture.size()).into_drawing_area();
    picture.draw(&area)?;
    area.present()?;
    drop(area);
    let area = Smooth::new(BitMapBackend::new(&png, picture.size()))?.into_drawing_area();
    picture.draw(&area)?;
    Ok(area.present()?)
}

/// A white sheet with the title, and under it a claim: what is better, or what there is to see. Returns the height.
///
/// # Errors
/// What the file says.
pub fn head<B: DrawingBackend>(area: &Area<B>, title: &str, claim: &str) -> Result<i32, Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    area.fill(&WHITE)?;
    let room = area.dim_in_pixel().0 as i32 - 48;
    let below = paragraph(area, title, &bold(24), [24, 16], [room, 32])?;
    paragraph(area, claim, &font(16), [24, below], [room, 21])
}
