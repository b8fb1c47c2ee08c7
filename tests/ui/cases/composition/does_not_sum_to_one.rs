//! Coefficients that do not make a step.

use integrator_core::prelude::*;

composition! {
    /// Five sixths of a step.
    pub struct Mine = V(1/2) T(1) V(1/3);
}

fn main() {
    let _ = Mine;
}
