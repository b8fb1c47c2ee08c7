//! Lyapunov exponents and chaos indicators.
//!
//! | function | result |
//! |---|---|
//! | [`indicators()`] | one orbit: largest exponent, MEGNO, FLI, SALI, GALI, and a verdict |
//! | [`megno()`] | one orbit: those of one deviation vector, without SALI and GALI |
//! | [`lyapunov_spectrum()`] | one orbit: all exponents |
//! | [`map()`] | many orbits: one indicator each, in SIMD lanes and on all cores |
//! | [`map_while()`] | many orbits: one indicator each, and which orbits were ejected or failed |
//! | [`frequencies`] (feature `frequencies`) | one orbit or many: fundamental frequencies, and their drift |
//! | [`monodromy()`](crate::check::monodromy) | a periodic orbit: multipliers and stability |
//!
//! Deviation vectors are multiplied by the exact derivative of each step ([`Tangent`](crate::Tangent)). Only flows that users
//! wrote are differentiated by finite differences. The orbit is bitwise identical to that of a run without vectors.
//!
//! Spectra and maps require a composition or an implicit method; indicators accept every method with deviation vectors.
//!
//! Lengths of vectors are Euclidean norms over all coordinates. The unit of positions is a power of two, chosen for each
//! orbit so that its first step mixes positions and momenta equally. Indicators therefore do not depend on the units of the
//! system.
//!
#![cfg_attr(feature = "frequencies", doc = "[`frequencies`]: mod@frequencies")]
#![cfg_attr(not(feature = "frequencies"), doc = "[`frequencies`]: crate#features")]

#[cfg(feature = "frequencies")]
pub mod frequencies;
mod growth;
mod indicators;
mod map;
mod spectrum;

#[cfg(feature = "frequencies")]
pub use frequencies::{Drift, Line, drift, frequencies, frequencies_of_run, frequencies_with_window, frequency_map};
pub use indicators::{Indicators, Megno, Verdict, indicators, megno};
pub use map::{End, Indicator, Mapped, map, map_while};
pub use spectrum::{Spectrum, lyapunov_spectrum};
