//! The attribute on something else.

use integrator_core::prelude::*;

#[hamiltonian]
struct System;

fn main() {
    let _ = System;
}
