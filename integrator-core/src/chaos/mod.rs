//! Whether an orbit is regular or chaotic, and how fast its neighbours leave it.
//!
//! In: a system, a method that carries deviation vectors (for spectra and maps a composition or an implicit method), a start, a
//! step. Out: exponents and indicators of the orbit, by
//! the derivative of the very steps that a run takes ([`Tangent`](crate::Tangent)), with no finite difference but for flows that users wrote.
//! Always true: the orbit has the bits of the run without vectors; what is measured is told with its uncertainty or with
//! the reason of the verdict.
//!
//! | ask | for |
//! |---|---|
//! | [`indicators()`] | one orbit: the largest exponent, MEGNO, FLI, SALI, GALI, and a verdict |
//! | [`lyapunov_spectrum()`] | all exponents of one orbit |
//! | [`map()`] | one indicator of many orbits, in lanes and on threads |
//! | [`map_while()`] | the same, and which orbits were ejected or lost |
//! | [`monodromy()`](crate::check::monodromy) | a periodic orbit: multipliers and stability |
//!
//! Lengths of vectors are Euclidean over all coordinates in the units of the system. Another choice of units changes
//! what indicators show after a short time, and no exponent.

mod growth;
mod indicators;
mod map;
mod spectrum;

pub use indicators::{Indicators, Verdict, indicators};
pub use map::{End, Indicator, Mapped, map, map_while};
pub use spectrum::{Spectrum, lyapunov_spectrum};
