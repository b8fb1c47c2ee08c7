//! The table of an extrapolation: one long step by finer and finer ones, and their extrapolation to step zero.

use crate::{
    errors::Exact,
    problem::{Problem, numbers},
};
use integrator_core::prelude::*;
use integrator_reference::{AnyReference, ForwardEuler, GraggBulirschStoer};

/// Into how many steps of the modified midpoint rule the long one is divided, as Gragg, Bulirsch and Stoer do.
pub(crate) const DIVISIONS: [u32; 4] = [2, 4, 6, 8];

/// Long steps to a period, and by how many halvings they are shortened until the error of the finest midpoint steps is
/// below this share of the orbit: of longer ones, the further terms of the error hide what a column gains.
const COUNT: u32 = 16;
const HALVINGS: u32 = 6;
const LARGEST: f64 = 1e-3;

/// Steps of order ten from which the end of the long step is known.
const REFERENCE: u64 = 64;

/// Errors below this are those of rounding as much as those of the table.
const ROUNDING: f64 = 1e-13;

/// The table of one long step.
#[derive(Clone, Debug)]
pub(crate) struct Extrapolation {
    /// The long step.
    pub(crate) step: f64,
    /// In each row the error of the midpoint steps, then those of what follows from them and from the rows above.
    pub(crate) errors: Vec<Vec<f64>>,
    /// The errors for half of the long step, in the same order.
    pub(crate) halved: Vec<Vec<f64>>,
    /// The difference of the last entry from a step of Gragg, Bulirsch and Stoer.
    pub(crate) corner: f64,
}

impl Extrapolation {
    /// For each column the exponent of the error of its first entry, less the one that it should have: 3, 5, 7, 9. The error is
    /// that of a single step, one power above the order. None where the error is that of rounding.
    pub(crate) fn excess(&self) -> Vec<Option<f64>> {
        let first = |table: &[Vec<f64>], column: usize| table[column][column];
        let exponents = (0..self.errors.len()).map(|column| {
            let (long, half) = (first(&self.errors, column), first(&self.halved, column));
            (half > ROUNDING).then(|| (long / half).log2() - (2 * column + 3) as f64)
        });
        exponents.collect()
    }

    /// The least of these.
    pub(crate) fn least_excess(&self) -> Option<f64> {
        self.excess().into_iter().flatten().reduce(f64::min)
    }

    /// The largest error of a column in units of that of the column before, in the finest row of half of the long step.
    /// None where all errors are those of rounding.
    pub(crate) fn largest_ratio(&self) -> Option<f64> {
        let pairs = self.halved.last()?.windows(2).filter(|pair| pair[0] > ROUNDING);
        pairs.map(|pair| pair[1] / pair[0]).reduce(f64::max)
    }
}

/// Makes the table of a step that resolves the motion; none where a step does not come to an end.
pub(crate) fn extrapolation<H: Hamiltonian>(problem: &Problem<'_, H>, exact: &Exact) -> Option<Extrapolation> {
    let mut step = problem.step_of(COUNT);
    let (mut entries, mut errors) = table(problem, exact, step)?;
    for _ in 0..HALVINGS {
        if errors.last()?[0] < LARGEST {
            break;
        }
        step *= 0.5;
        (entries, errors) = table(problem, exact, step)?;
    }
    let (_, halved) = table(problem, exact, 0.5 * step)?;
    let corner = exact.distance(entries.last()?.last()?, &stepped(problem, GraggBulirschStoer.into(), step)?);
    Some(Extrapolation { step, errors, halved, corner })
}

/// Returns the end of one step of a method from the start.
fn stepped<H: Hamiltonian>(problem: &Problem<'_, H>, method: AnyReference, step: f64) -> Option<Vec<f64>> {
    let mut run = problem.run(method, &problem.start, step).ok()?;
    run.advance(1).ok()?;
    Some(numbers(&run.state()))
}

/// Rows of states, or of their errors.
type Rows<Entry> = Vec<Vec<Entry>>;

/// The entries of the table of a step, and their errors.
fn table<H: Hamiltonian>(problem: &Problem<'_, H>, exact: &Exact, step: f64) -> Option<(Rows<Vec<f64>>, Rows<f64>)> {
    let start = Phase::compensated(problem.start.q.clone(), problem.start.p.clone());
    let mut run = problem.system.run_with(SofroniouSpaletta10, start, step / REFERENCE as f64).ok()?;
    run.advance(REFERENCE).ok()?;
    let end = numbers(&run.state().to_f64());
    let mut rows: Rows<Vec<f64>> = Vec::new();
    for (row, division) in DIVISIONS.iter().enumerate() {
        let mut entries = vec![midpoints(problem, step, *division)?];
        for column in 1..=row {
            let ratio = f64::from(*division) / f64::from(DIVISIONS[row - column]);
            let above = &rows[row - 1][column - 1];
            let entry = entries[column - 1].iter().zip(above);
            entries.push(entry.map(|(finer, coarser)| finer + (finer - coarser) / (ratio * ratio - 1.0)).collect());
        }
        rows.push(entries);
    }
    let errors = rows.iter().map(|row| row.iter().map(|entry| exact.distance(entry, &end)).collect()).collect();
    Some((rows, errors))
}

/// Returns the end of this number of steps of the modified midpoint rule: a step of Euler, then steps across two. Euler
/// steps evaluate the field.
fn midpoints<H: Hamiltonian>(problem: &Problem<'_, H>, step: f64, division: u32) -> Option<Vec<f64>> {
    let h = step / f64::from(division);
    let added = |state: &[f64], number: u32, h: f64| -> Option<Vec<f64>> {
        let run = problem.run(AnyReference::from(ForwardEuler), &problem.state(state), h).ok()?;
        let mut run = run.at_time(f64::from(number) * step / f64::from(division));
        run.advance(1).ok()?;
        Some(numbers(&run.state()).iter().zip(state).map(|(after, before)| after - before).collect())
    };
    let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + b).collect::<Vec<_>>();
    let mut before = numbers(&problem.start);
    let mut here = sum(&before, &added(&before, 0, h)?);
    for number in 1..division {
        let after = sum(&before, &added(&here, number, 2.0 * h)?);
        before = std::mem::replace(&mut here, after);
    }
    Some(here)
}
