//! Frequency analysis of quasi-periodic motion (NAFF, numerical analysis of fundamental frequencies).
//!
//! | function | result |
//! |---|---|
//! | [`frequencies()`] | samples: their terms with the largest amplitudes |
//! | [`frequencies_with_window()`] | the same, with a chosen order of the Hann window |
//! | [`frequencies_of_run()`] | a run: the terms of an observable |
//! | [`drift()`] | samples: the main frequency, and its change between both halves |
//! | [`frequency_map()`] | an ensemble: main frequencies of all members, and their drift |
//!
//! Samples are those of a complex function at equal intervals of time, `[real, imaginary]`. It is modelled as a sum of
//! terms `a exp(iνt)`, where `t` is the time since the first sample and `ν` is in radians per unit of time. Examples are
//! `[q, p]` of an oscillation, and `[e·cos ϖ, e·sin ϖ]` of an orbit. For a real function, the imaginary part is zero, and each
//! oscillation consists of two terms with the frequencies `±ν`.
//!
//! # Method
//!
//! 1. The samples are multiplied by a Hann window of order `p`, `sin²ᵖ(πn/(N+1))`. A fast Fourier transform finds the peak.
//! 2. Newton's method refines the peak: it finds the zero of the derivative of the transform's modulus. Rounding affects
//!    this zero less than the maximum itself.
//! 3. The found terms are fitted jointly to all samples, by Newton's method on the frequencies and amplitudes. The inner
//!    product has the weights of the window. For fixed frequencies this is the orthogonalisation of Gram and Schmidt.
//! 4. The terms are subtracted from the samples, and the next one is found in the residual.
//!
//! Steps 1, 2 and the orthogonalisation are Laskar's (1990, Icarus 88, 266; 1993, Physica D 67, 257; 2003,
//! arXiv:math/0305364 for windows of order `p`). The joint fit also corrects the frequencies for the side lobes of other terms. A
//! sum of up to ten terms is therefore exact up to rounding.
//!
//! # Limits
//!
//! - Frequencies are between `-π/interval` and `π/interval`; others appear shifted by multiples of `2π/interval`. Choose an
//!   interval shorter than half of the shortest period that matters.
//! - Two terms can be separated if their frequencies differ by at least `(p + 1)·2π/T`, where `T` is the time of all samples.
//! - Terms that were not requested disturb the others by their side lobes. These decrease like the power `2p + 1` of the
//!   distance of the frequencies. High orders suit long series, low orders suit close frequencies.

mod drift;
mod fit;
mod line;
mod map;
mod peak;
mod run;
mod series;
mod term;

pub use drift::{Drift, drift};
pub use line::{Line, frequencies, frequencies_with_window};
pub use map::frequency_map;
pub use run::frequencies_of_run;

#[cfg(test)]
mod tests;
