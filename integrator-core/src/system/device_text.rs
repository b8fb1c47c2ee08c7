//! Flows as text for devices: C++, which CUDA compiles.

use crate::system::{System, shared_table::SharedTable};
use alloc::vec::Vec;

/// A stage of a composition as devices read it.
pub type StageRow = [f64; 7];

/// A Hamiltonian whose flows are also text for devices. Written by `#[hamiltonian(gpu)]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no device code",
    label = "generated without `gpu`",
    note = "write `#[hamiltonian(gpu)]` to generate it"
)]
pub trait DeviceText: System {
    /// The struct `System`: the shape of the state, its prepared constants, and its flows.
    const TEXT: &'static str;
    /// The number of prepared constants, counted as single numbers.
    const CONSTANTS: usize;

    /// Adds the prepared constants of one member to a list, in the order in which the text reads them: as many as
    /// [`DeviceText::CONSTANTS`], or more, where one of its lists is longer than the text has room for.
    fn push_constants(parameters: &Self::Parameters<f64>, numbers: &mut Vec<f64>);
    /// Adds the stages of all inner compositions, the outermost first.
    fn push_inner_stages(_rows: &mut Vec<StageRow>) {}
}

/// A prepared number, or a table of prepared numbers.
pub trait Pushed {
    /// Adds the value to a list. A table is padded with zeros up to these lengths, from the outermost level on.
    fn push_to(&self, lengths: &[usize], numbers: &mut Vec<f64>);
}

impl Pushed for f64 {
    fn push_to(&self, _lengths: &[usize], numbers: &mut Vec<f64>) {
        numbers.push(*self);
    }
}

/// An integer; below 2^53 it stays what it is.
impl Pushed for usize {
    fn push_to(&self, _lengths: &[usize], numbers: &mut Vec<f64>) {
        numbers.push(*self as f64);
    }
}

impl<T: Pushed, const N: usize> Pushed for [T; N] {
    fn push_to(&self, lengths: &[usize], numbers: &mut Vec<f64>) {
        push_elements(self, lengths, numbers);
    }
}

impl<T: Pushed> Pushed for SharedTable<T> {
    fn push_to(&self, lengths: &[usize], numbers: &mut Vec<f64>) {
        push_elements(self, lengths, numbers);
    }
}

/// Adds the elements of a table, and zeros for those that are missing.
fn push_elements<T: Pushed>(elements: &[T], lengths: &[usize], numbers: &mut Vec<f64>) {
    let (length, inner) = lengths.split_first().map_or((0, lengths), |(length, inner)| (*length, inner));
    elements.iter().for_each(|element| element.push_to(inner, numbers));
    let missing = length.saturating_sub(elements.len()) * inner.iter().product::<usize>();
    numbers.resize(numbers.len() + missing, 0.0);
}

/// Adds a prepared constant to a list.
pub fn push_constants(constant: &impl Pushed, numbers: &mut Vec<f64>) {
    constant.push_to(&[], numbers);
}

/// Adds a table whose lengths are known at run time, and may be these at most: with more of them, the list gets too long.
pub fn push_lists(constant: &impl Pushed, lengths: &[usize], numbers: &mut Vec<f64>) {
    constant.push_to(lengths, numbers);
}
