//! A declared symmetry that does not hold.

use integrator_core::prelude::*;

composition! {
    /// Not symmetric.
    pub struct Mine: order 1, symmetric = V(1) T(1);
}

fn main() {
    let _ = Mine;
}
