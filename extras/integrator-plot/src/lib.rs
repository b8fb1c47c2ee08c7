//! Plots of runs, as SVG and PNG.
//!
//! Each of these functions plots samples of a run in one line: [`energy`] and [`energies`], [`phase`], [`orbit`],
//! [`section`]. [`map`] plots a quantity computed for the points of a plane. Each returns a [`Chart`], to which you can
//! add titles, axes and further series, and which you can save as SVG or PNG.
//!
//! ```
//! use integrator_core::prelude::*;
//! use integrator_plot as plot;
//!
//! struct Pendulum;
//!
//! #[hamiltonian(compose = Yoshida4)]
//! impl Pendulum {
//!     fn kinetic(&self, p: [f64; 1]) -> f64 {
//!         0.5 * p[0] * p[0]
//!     }
//!     fn potential(&self, q: [f64; 1]) -> f64 {
//!         -q[0].cos()
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let run = Pendulum.run(Phase::new([2.0], [0.0]), 0.1)?;
//! let samples = run.samples(1).take(500).collect::<Result<Vec<_>, _>>()?;
//! # let folder = std::env::temp_dir().join(format!("integrator-plot-doc-{}", std::process::id()));
//! # std::fs::create_dir_all(&folder)?;
//! # std::env::set_current_dir(&folder)?;
//! plot::energy(&samples).save("energy.png")?;
//! plot::phase(&samples).title("A swing of two radians").save("phase.svg")?;
//! # std::fs::remove_dir_all(folder)?;
//! # Ok(())
//! # }
//! ```
//!
//! Other charts are built by method calls:
//!
//! ```no_run
//! use integrator_plot::{Axis, Chart, Panels, write};
//! use std::path::Path;
//!
//! let chart = |name: &str, growth: f64| {
//!     let points = (0..100).map(|i| (f64::from(i), growth.powi(i)));
//!     Chart::new(name)
//!         .claim("What the picture shows, in a sentence")
//!         .measured(format!("factor per step: {growth}"))
//!         .along(Axis::linear("step"))
//!         .up(Axis::logarithmic("relative error"))
//!         .line("measured", points)
//! };
//! chart("Growth", 1.1).save("target/growth.png")?;
//! let several = Panels::new("Two of a kind", "One is faster").chart(chart("slow", 1.01)).chart(chart("fast", 1.5));
//! write(Path::new("target/both"), &several)?; // both.svg and both.png
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | module | content |
//! |---|---|
//! | `runs` | pictures of runs, one line each |
//! | `picture` | [`Picture`], and the files written from it |
//! | `chart`, `panels` | curves and points over two axes, and several of these charts in rows |
//! | `series`, `field` | lines, dots, clouds, filled outlines; colours over a plane |
//! | `frame` | two axes in a part of the canvas, for pictures that are not charts |
//! | `axis`, `ticks` | linear, logarithmic and signed logarithmic axes, and their labels |
//! | `labels` | placement of names without overlap |
//! | `path` | curves clipped at the frame, without invisible points |
//! | `cloud` | millions of points as one bitmap, which keeps an SVG small |
//! | `canvas` | shapes in fractions of pixels; `svg` writes them as text, `raster` as pixels, `png` as a file |
//! | `text`, `colour` | fonts and colours |

mod axis;
mod canvas;
mod chart;
mod cloud;
pub mod colour;
mod field;
mod frame;
mod labels;
mod panels;
mod path;
mod picture;
mod png;
mod raster;
mod runs;
mod series;
mod svg;
mod text;
mod ticks;

pub use axis::{Axis, Scale};
pub use canvas::{Canvas, MARKERS, Marker, Place, Stroke};
pub use chart::Chart;
pub use colour::Colour;
pub use frame::{Frame, Margins, Room};
pub use panels::Panels;
pub use picture::{Outcome, Picture, SaveError, head, write};
pub use runs::{energies, energy, map, orbit, phase, phase_of, section, section_of};
pub use series::{DASHES, Mark};
pub use text::{Font, bold, font};

/// The SVG and the PNG of a picture.
#[cfg(test)]
fn drawn(picture: &impl Picture) -> (String, Vec<u8>) {
    let mut canvas = Canvas::new(picture.size()).expect("fonts");
    picture.draw(&mut canvas);
    (canvas.svg(), canvas.png(1))
}

/// The programs of the README, of the page on pictures and of the tutorial.
#[cfg(doctest)]
mod pages {
    #[doc = include_str!("../README.md")]
    struct Readme;
    #[doc = include_str!("../../../docs/pictures.md")]
    struct Pictures;
    #[doc = include_str!("../../../docs/guide/src/first_hamiltonian.md")]
    struct FirstHamiltonian;
}
