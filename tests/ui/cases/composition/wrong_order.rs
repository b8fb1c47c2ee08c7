//! A declared order that does not hold.

use integrator_core::prelude::*;

composition! {
    /// Not of order 4.
    pub struct Mine: order 4 = T(1/2) V(1) T(1/2);
}

fn main() {
    let _ = Mine;
}
