//! Pictures and the files written from them.

use crate::{
    canvas::Canvas,
    text::{bold, font},
};
use std::{
    error::Error,
    fmt, fs, io,
    path::{Path, PathBuf},
};

/// The result of writing a picture.
pub type Outcome = Result<(), Box<dyn Error>>;

/// A drawing on a [`Canvas`].
pub trait Picture {
    /// Returns the width and height in pixels.
    fn size(&self) -> (u32, u32);
    /// Draws onto a canvas of this size.
    fn draw(&self, canvas: &mut Canvas);
}

/// The reason why a picture was not saved.
#[derive(Debug)]
#[non_exhaustive]
pub enum SaveError {
    /// The name of the file ends in neither `.png` nor `.svg`.
    Ending(PathBuf),
    /// The fonts cannot be read.
    Fonts(Box<dyn Error>),
    /// The file or its folder cannot be written.
    Write(PathBuf, io::Error),
}

impl fmt::Display for SaveError {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ending(file) => write!(to, "{}: a picture ends in .png or .svg", file.display()),
            Self::Fonts(error) => write!(to, "the fonts of pictures cannot be read: {error}"),
            Self::Write(file, error) => write!(to, "{} cannot be written: {error}", file.display()),
        }
    }
}

impl Error for SaveError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Ending(_) => None,
            Self::Fonts(error) => Some(error.as_ref()),
            Self::Write(_, error) => Some(error),
        }
    }
}

/// Pixels of a PNG each way for one of the picture, so that it is sharp in print.
const SHARP: u32 = 2;

/// Writes one file, of the kind that its name says.
pub(crate) fn save(file: &Path, picture: &impl Picture) -> Result<(), SaveError> {
    save_magnified(file, picture, SHARP)
}

fn save_magnified(file: &Path, picture: &impl Picture, times: u32) -> Result<(), SaveError> {
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
    let encode: fn(&Canvas, u32) -> Vec<u8> = match ending.as_str() {
        "png" => Canvas::png,
        "svg" => |canvas, _| canvas.svg().into_bytes(),
        _ => return Err(SaveError::Ending(file.to_owned())),
    };
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder).map_err(|error| SaveError::Write(folder.to_owned(), error))?;
    }
    let mut canvas = Canvas::new(picture.size()).map_err(SaveError::Fonts)?;
    picture.draw(&mut canvas);
    fs::write(file, encode(&canvas, times)).map_err(|error| SaveError::Write(file.to_owned(), error))
}

/// Writes `<file>.svg` and `<file>.png`, and creates the folder. The PNG has as many pixels as the picture.
///
/// # Errors
/// A file cannot be written.
pub fn write(file: &Path, picture: &impl Picture) -> Outcome {
    save_magnified(&file.with_extension("svg"), picture, 1)?;
    Ok(save_magnified(&file.with_extension("png"), picture, 1)?)
}

/// Draws the title and below it a claim: the result that the picture shows. Returns the height at which the next item
/// begins.
pub fn head(canvas: &mut Canvas, title: &str, claim: &str) -> f64 {
    let room = f64::from(canvas.size.0) - 48.0;
    let below = canvas.paragraph(title, (24.0, 14.0), room, bold(24.0));
    canvas.paragraph(claim, (24.0, below), room, font(16.0))
}

#[cfg(test)]
mod tests {
    use super::write;
    use crate::Chart;
    use std::{env, fs};

    #[test]
    fn files_are_what_their_names_say() {
        let folder = env::temp_dir().join(format!("integrator-plot-{}", std::process::id()));
        let chart = Chart::new("Line").line("", [(0.0, 0.0), (1.0, 1.0)]);
        write(&folder.join("inside").join("line"), &chart).expect("two files");
        chart.save(folder.join("again.PNG")).expect("a file");
        let read = |name: &str| fs::read(folder.join(name)).expect("a file");
        assert!(read("inside/line.svg").starts_with(b"<svg "));
        // After the signature of a PNG and the name of its first part come width and height.
        let size = |name: &str| {
            [16, 20].map(|at| read(name)[at..at + 4].iter().fold(0, |side, byte| side << 8 | u32::from(*byte)))
        };
        assert!(read("inside/line.png").starts_with(b"\x89PNG"));
        assert_eq!((size("inside/line.png"), size("again.PNG")), ([1000, 640], [2000, 1280]));
        let refused = chart.save(folder.join("line.pdf")).expect_err("a refusal").to_string();
        assert!(refused.ends_with("line.pdf: a picture ends in .png or .svg"), "{refused}");
        let blocked =
            chart.save(folder.join("again.PNG").join("line.png")).expect_err("a file is no folder").to_string();
        assert!(blocked.contains("again.PNG cannot be written: "), "{blocked}");
        fs::remove_dir_all(folder).expect("a folder");
    }
}
