//! Pictures and the page as files.

use crate::{
    claims::Verdict,
    notes::Notes,
    page::{Figure, page},
    pictures::PICTURES,
    study::Study,
};
use std::{
    error::Error,
    fs,
    path::{Path, PathBuf},
};

/// Writes every picture into a folder and the page beside it. Returns where the page is.
pub(crate) fn write(
    folder: &Path,
    study: &Study,
    notes: &Notes,
    verdicts: &[Verdict],
) -> Result<PathBuf, Box<dyn Error>> {
    let mut figures = Vec::new();
    for picture in PICTURES {
        let Some(drawing) = (picture.draw)(study, notes) else { continue };
        let file = folder.join(picture.name);
        drawing.write(&file)?;
        figures.push(Figure { name: picture.name, svg: fs::read_to_string(file.with_extension("svg"))? });
    }
    let html = folder.with_extension("html");
    fs::write(&html, page(study, verdicts, &figures))?;
    Ok(html)
}
