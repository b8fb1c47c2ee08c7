//! Drawing and checking the pictures of examples.

use integrator_plot::{Picture, write};
use std::{env, fs};

/// Draws a picture into two files, checks the PNG, and returns the text of the SVG, which has to contain `words`.
pub(crate) fn drawn(name: &str, picture: &impl Picture, words: &[&str]) -> String {
    let file = env::temp_dir().join(format!("integrator-{name}-{}", std::process::id()));
    write(&file, picture).expect("two files");
    let [svg, png] = ["svg", "png"].map(|extension| file.with_extension(extension));
    let (text, image) = (fs::read_to_string(&svg).expect("text"), fs::read(&png).expect("a picture"));
    // Width and height follow the signature of the PNG and the name of its first chunk.
    let side = |at: usize| image[at..at + 4].iter().fold(0, |side, byte| side << 8 | u32::from(*byte));
    assert_eq!((side(16), side(20)), picture.size(), "the size of {name}");
    assert!(image.len() > 5_000, "{name} has {} bytes", image.len());
    for word in words {
        assert!(text.contains(word), "{name} says nothing of {word}");
    }
    for file in [svg, png] {
        fs::remove_file(file).expect("a file");
    }
    text
}
