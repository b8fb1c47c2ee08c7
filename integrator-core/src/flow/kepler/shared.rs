//! What the solver seldom does, compiled with the library for the numbers of runs and ensembles in double precision.
//!
//! The compiler links a generic function that is never inlined to a copy in the library, if there is one. Else it would be
//! compiled for every system, and it is most of the code of a solver.

use super::{
    OneCopy,
    fall::{End, Fall},
    universal::{Increments, Root, Search},
};
#[cfg(feature = "check")]
use crate::scalar::bounded::Bounded;
use crate::{
    scalar::real::{Kernel, Real},
    state::precision::Precision,
};
use core::hint::black_box;

/// Compiles the functions. Nobody calls it.
pub fn shared() {
    of_vectors::<<f64 as Precision>::Plain>();
    of_vectors::<<f64 as Precision>::Fused>();
    of_vectors::<<f64 as Precision>::Avx512>();
    // The baseline of x86 calls this, too: it has few users.
    ways::<<f64 as Precision>::Plain>();
    #[cfg(feature = "check")]
    {
        of_numbers::<Bounded>();
        ways::<Bounded>();
    }
}

fn of_vectors<R: Real>() {
    of_numbers::<R>();
    of_numbers::<R::Block>();
    of_numbers::<R::Wide>();
}

fn of_numbers<W: Real>() {
    black_box(entered::<W, Search<W>> as fn(Search<W>) -> Root<W>);
    black_box(entered::<W, Fall<W, 2>> as fn(Fall<W, 2>) -> End<W, 2>);
    black_box(entered::<W, Fall<W, 3>> as fn(Fall<W, 3>) -> End<W, 3>);
}

fn ways<W: Real>() {
    black_box(entered::<W, OneCopy<W, 2>> as fn(OneCopy<W, 2>) -> Increments<W, 2>);
    black_box(entered::<W, OneCopy<W, 3>> as fn(OneCopy<W, 3>) -> Increments<W, 3>);
}

fn entered<W: Real, K: Kernel>(kernel: K) -> K::Out {
    W::enter(kernel)
}
