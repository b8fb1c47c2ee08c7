//! A type without the attribute, where a Hamiltonian is needed.

use integrator_core::prelude::*;

struct System;

fn energy_of<H: Hamiltonian>(_: &H) {}

fn main() {
    energy_of(&System);
}
