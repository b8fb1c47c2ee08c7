//! Colours of ink, grid and curves.

use plotters::style::RGBColor;

/// Text and axes.
pub const INK: RGBColor = RGBColor(40, 40, 40);
/// Lines of the grid.
pub const PALE: RGBColor = RGBColor(226, 226, 226);
/// What stands back: walks, references, others.
pub const GREY: RGBColor = RGBColor(150, 150, 150);

/// Colours that people with any vision tell apart (Okabe and Ito), without the yellow that white swallows.
pub const COLOURS: [RGBColor; 8] = [
    RGBColor(30, 30, 30),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(213, 94, 0),
    RGBColor(204, 121, 167),
    RGBColor(0, 158, 115),
    RGBColor(0, 114, 178),
    RGBColor(140, 86, 60),
];
