//! Pictures for examples and benches, each as SVG and as PNG. For the eye alone: nothing in `integrator-core` knows of it.
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
//! write(Path::new("target/growth"), &chart("Growth", 1.1))?; // growth.svg and growth.png
//! let several = Panels::new("Two of a kind", "One is faster").chart(chart("slow", 1.01)).chart(chart("fast", 1.5));
//! write(Path::new("target/both"), &several)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | module | holds |
//! |---|---|
//! | `picture` | what is written as two files: anything that is a [`Picture`] |
//! | `chart`, `panels` | curves and points over two axes, and several of these charts in rows |
//! | `series` | what is drawn in a chart: lines, dots, clouds, filled outlines |
//! | `frame` | two axes on an area, and what is drawn between them; for pictures that are no charts |
//! | `axis`, `ticks` | linear and logarithmic axes, the numbers along them |
//! | `path` | curves cut at the border and without points that no pixel shows |
//! | `cloud` | points by the million as one bitmap, so that an SVG stays small |
//! | `smooth` | lines, dots and letters of the PNG with smooth edges |
//! | `text`, `colour` | lines of text that are broken where they are too long; colours |

mod axis;
mod chart;
mod cloud;
pub mod colour;
mod frame;
mod panels;
mod path;
mod picture;
mod series;
mod smooth;
mod text;
mod ticks;

pub use axis::{Axis, Scale};
pub use chart::Chart;
pub use frame::{Frame, Margins};
pub use panels::Panels;
pub use picture::{Area, Outcome, Picture, head, write};
pub use plotters;
pub use series::Mark;
pub use text::{bold, font};
