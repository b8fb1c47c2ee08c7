//! Members as columns of numbers: one array for each coordinate and each constant, in the layout of the device.

use integrator_core::{
    __private::{Coords, DeviceText, Precision},
    Phase,
};

/// The numbers of all states: of each part of a number those of all positions, then those of all momenta.
pub(crate) fn columns<C: Coords>(states: &[Phase<C>]) -> Vec<f64> {
    let mut columns = Vec::new();
    for part in 0..C::Leaf::PARTS {
        let mut push = |half: &dyn Fn(&Phase<C>) -> Vec<f64>| {
            let rows: Vec<_> = states.iter().map(half).collect();
            let count = rows.first().map_or(0, Vec::len);
            columns.extend((0..count).flat_map(|coordinate| rows.iter().map(move |row| row[coordinate])));
        };
        push(&|state| state.q.flat().iter().map(|leaf| leaf.parts()[part]).collect());
        push(&|state| state.p.flat().iter().map(|leaf| leaf.parts()[part]).collect());
    }
    columns
}

/// The prepared constants of all members, those of the first constant first.
///
/// # Errors
/// The number of the first member that has a longer list than the text has room for.
pub(crate) fn constants<H: DeviceText>(parameters: &[H::Parameters<f64>]) -> Result<Vec<f64>, usize> {
    let rows: Vec<Vec<f64>> = parameters
        .iter()
        .map(|parameters| {
            let mut numbers = Vec::with_capacity(H::CONSTANTS);
            H::push_constants(parameters, &mut numbers);
            numbers
        })
        .collect();
    match rows.iter().position(|row| row.len() != H::CONSTANTS) {
        Some(member) => Err(member),
        None => Ok((0..H::CONSTANTS).flat_map(|constant| rows.iter().map(move |row| row[constant])).collect()),
    }
}
