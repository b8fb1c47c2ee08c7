//! The quantities that symplectic steps conserve: levels of the modified Hamiltonian under an orbit, and its change for
//! a sequence of steps.

use crate::{
    errors::Exact,
    plan::Plan,
    problem::{Problem, steps_per_period},
    rows::Row,
};
use integrator_core::{
    Composition, Coords,
    check::{ModifiedHamiltonian, shadow},
    prelude::*,
};

/// The measurements of the modified Hamiltonian of a composition.
#[derive(Clone, Debug)]
pub(crate) struct Modified {
    pub(crate) row: Row,
    /// The powers of the step by which `H`, and `H` with one term after the other, are off.
    pub(crate) powers: Vec<i32>,
    /// Steps, and the largest changes of these energies in a few periods, in units of the largest kinetic energy.
    pub(crate) changes: Vec<(f64, Vec<f64>)>,
    /// The excess of the measured powers over `powers`, at least; `None` where they cannot be measured.
    pub(crate) excess: Option<f64>,
    /// The levels in the plane of a system of one degree of freedom.
    pub(crate) levels: Option<Levels>,
}

/// An orbit in long steps, and the levels through its start.
#[derive(Clone, Debug)]
pub(crate) struct Levels {
    /// Steps to a period, and a fraction.
    pub(crate) count: u32,
    pub(crate) orbit: Vec<(f64, f64)>,
    /// The levels of `H`, and of the modified Hamiltonian: curves that are separated by NaN.
    pub(crate) of: [Vec<(f64, f64)>; 2],
}

/// Steps to a period, from long to short ones.
const COUNTS: [u32; 8] = [8, 12, 16, 24, 34, 48, 68, 96];
/// The duration of the orbit, in periods.
const PERIODS: f64 = 2.0;
/// The series is of use where the modified Hamiltonian changes by no more than this part of what `H` does.
const USEFUL: f64 = 0.1;

/// Measures a composition; none where the energy is not conserved, or `H` is split into other parts than `T(p)` and `V(q)`.
pub(crate) fn modified<H: Hamiltonian, X: Composition<H>>(
    row: Row,
    composition: X,
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
) -> Option<Modified> {
    let Problem { system, start, step, .. } = problem;
    let of_step = |h: f64| ModifiedHamiltonian::new(*system, composition, start, h).ok();
    let series = of_step(*step)?.series().clone();
    let powers = (0..=series.powers().len()).map(|count| series.off_by(count)).collect();
    let orbit = |count: u32| {
        let run = problem.run(composition, start, problem.step_of(count)).ok()?;
        let samples =
            run.samples(1).take((PERIODS * f64::from(problem.cycles()) * steps_per_period(count)) as usize + 1);
        Some(samples.map_while(Result::ok).map(|sample| sample.state).collect::<Vec<_>>())
    };
    let changes: Vec<_> = COUNTS
        .into_iter()
        .filter_map(|count| {
            let h = problem.step_of(count);
            Some((count, h, largest_changes(&of_step(h)?, &orbit(count)?, exact.motion)))
        })
        .collect();
    let coarsest = changes.iter().find(|(_, _, changes)| changes.last() < Some(&(USEFUL * changes[0])));
    let levels = coarsest
        .filter(|_| problem.freedom() == 1)
        .and_then(|(count, h, _)| Some(levels(*count, &of_step(*h)?, &orbit(*count)?, plan.outline / 2)));
    let excess = shadow::<H, X, f64>(*system, composition, start.clone(), *step).ok().map(|shadow| {
        let excess = shadow.powers.iter().map(|power| power.measured - f64::from(power.exact));
        excess.fold(f64::INFINITY, f64::min)
    });
    let changes = changes.into_iter().map(|(_, h, changes)| (h, changes)).collect();
    Some(Modified { row, powers, changes, excess, levels })
}

/// The largest changes of `H` and of its modifications in this unit.
fn largest_changes<C: Coords<Leaf = f64>>(
    modified: &ModifiedHamiltonian<'_, C>,
    orbit: &[Phase<C>],
    unit: f64,
) -> Vec<f64> {
    let energies: Vec<Vec<f64>> = orbit.iter().map(|state| modified.energies(state)).collect();
    let first = &energies[0];
    (0..first.len())
        .map(|index| {
            let changes = energies.iter().map(|energies| (energies[index] - first[index]).abs() / unit);
            changes.fold(f64::EPSILON, |most, change| if change <= most { most } else { change })
        })
        .collect()
}

/// The distance by which the plane extends beyond the orbit, on either side, in units of the orbit.
const ROOM: f64 = 0.3;

/// The levels in the plane of the only position and its momentum.
fn levels<C: Coords<Leaf = f64>>(
    count: u32,
    modified: &ModifiedHamiltonian<'_, C>,
    orbit: &[Phase<C>],
    cells: usize,
) -> Levels {
    let points: Vec<(f64, f64)> = orbit.iter().map(|state| (state.q.flat()[0], state.p.flat()[0])).collect();
    let ends = |of: fn(&(f64, f64)) -> f64| {
        let numbers = || points.iter().map(of);
        let (least, most) = (numbers().fold(f64::INFINITY, f64::min), numbers().fold(f64::NEG_INFINITY, f64::max));
        let room = ROOM * (most - least);
        [least - room, most + room]
    };
    let first = modified.energies(&orbit[0]);
    let energies = |(q, p): (f64, f64)| {
        let mut at = orbit[0].clone();
        at.q.flat_mut()[0] = q;
        at.p.flat_mut()[0] = p;
        let energies = modified.energies(&at);
        [energies[0] - first[0], energies[energies.len() - 1] - first[first.len() - 1]]
    };
    let of = zeros(&energies, [ends(|point| point.0), ends(|point| point.1)], cells);
    Levels { count, orbit: points, of }
}

/// Finds the zeros of two functions: on a grid, by straight lines within its cells.
fn zeros(function: &dyn Fn((f64, f64)) -> [f64; 2], [x, y]: [[f64; 2]; 2], cells: usize) -> [Vec<(f64, f64)>; 2] {
    let part = |[least, most]: [f64; 2], index: usize| least + (most - least) * index as f64 / cells as f64;
    let place = |column: usize, row: usize| (part(x, column), part(y, row));
    let values: Vec<Vec<[f64; 2]>> =
        (0..=cells).map(|row| (0..=cells).map(|column| function(place(column, row))).collect()).collect();
    [0, 1].map(|which| {
        let mut curve = Vec::new();
        for (row, column) in (0..cells).flat_map(|row| (0..cells).map(move |column| (row, column))) {
            let around = [(column, row), (column + 1, row), (column + 1, row + 1), (column, row + 1)];
            let corner = |index: usize| {
                let (column, row) = around[index % 4];
                (place(column, row), values[row][column][which])
            };
            let crossings: Vec<(f64, f64)> = (0..4)
                .filter_map(|edge| {
                    let ((from, before), (to, after)) = (corner(edge), corner(edge + 1));
                    let share = before / (before - after);
                    let crosses = (before < 0.0) != (after < 0.0);
                    crosses.then_some((from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1)))
                })
                .collect();
            for ends in crossings.chunks_exact(2) {
                curve.extend_from_slice(ends);
                curve.push((f64::NAN, f64::NAN));
            }
        }
        curve
    })
}

#[cfg(test)]
mod tests {
    use super::zeros;

    #[test]
    fn levels_lie_where_functions_are_zero() {
        let [circle, line] = zeros(&|(x, y)| [x * x + y * y - 1.0, x - y + 0.3], [[-1.5, 1.5], [-1.2, 1.2]], 40);
        let points =
            |curve: &[(f64, f64)]| curve.iter().filter(|point| point.0.is_finite()).copied().collect::<Vec<_>>();
        let (circle, line) = (points(&circle), points(&line));
        // A chord over a cell of 0.075 by 0.06 misses a circle by an eighth of its square.
        assert!(circle.len() > 100 && circle.iter().all(|(x, y)| (x.hypot(*y) - 1.0).abs() < 0.00125));
        assert!(line.len() > 40 && line.iter().all(|(x, y)| (x - y + 0.3).abs() < 1e-14));
    }
}
