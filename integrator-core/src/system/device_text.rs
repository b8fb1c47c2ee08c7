//! Flows as text for devices: C++, which CUDA compiles.

use crate::hamiltonian::Hamiltonian;
use alloc::vec::Vec;

/// A Hamiltonian whose flows are also text for devices. Written by `#[hamiltonian(gpu)]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no text for devices",
    label = "its flows were written for processors alone",
    note = "ask for it at the annotation: `#[hamiltonian(gpu)]`"
)]
pub trait DeviceText: Hamiltonian {
    /// The struct `System`: the shape of the state, its prepared constants, and its flows.
    const TEXT: &'static str;
    /// How many numbers the prepared constants are.
    const CONSTANTS: usize;

    /// Adds the prepared constants of one member to a list, in the order in which the text reads them.
    fn push_constants(parameters: &Self::Parameters<f64>, numbers: &mut Vec<f64>);
}

/// A prepared number, or a table of prepared numbers.
pub trait Pushed {
    /// Adds it to a list.
    fn push_to(&self, numbers: &mut Vec<f64>);
}

impl Pushed for f64 {
    fn push_to(&self, numbers: &mut Vec<f64>) {
        numbers.push(*self);
    }
}

impl<T: Pushed, const N: usize> Pushed for [T; N] {
    fn push_to(&self, numbers: &mut Vec<f64>) {
        self.iter().for_each(|element| element.push_to(numbers));
    }
}

/// Adds a prepared constant to a list.
pub fn push_constants(constant: &impl Pushed, numbers: &mut Vec<f64>) {
    constant.push_to(numbers);
}
