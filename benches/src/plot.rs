//! Plots of the benches, each as SVG and as PNG.

mod dots;
mod growth;
mod work_precision;

pub use dots::{Dots, Row, dots, named};
pub use growth::{Growing, growth};
pub use work_precision::work_precision;
