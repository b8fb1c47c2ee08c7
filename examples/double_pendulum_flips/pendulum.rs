//! A pendulum of two equal uniform rods. Units: the length and the mass of a rod, and the acceleration of gravity.

use integrator_core::{GaussLegendre, prelude::*};
use std::f64::consts::PI;

/// Two rods, the second of which hangs from the end of the first one.
#[derive(Clone, Copy)]
pub(crate) struct Rods;

/// H in the angles of the rods from the downward vertical. The inverse of the mass matrix depends on the angle between them.
#[hamiltonian(split = none, compose = GaussLegendre<4>)]
impl Rods {
    fn hamiltonian(&self, [a, b]: [f64; 2], [pa, pb]: [f64; 2]) -> f64 {
        let cosine = (a - b).cos();
        let kinetic = 6.0 * (pa * pa - 3.0 * cosine * pa * pb + 4.0 * pb * pb) / (16.0 - 9.0 * cosine * cosine);
        kinetic - 0.5 * (3.0 * a.cos() + b.cos())
    }
}

/// Whether rods that are released at rest have too little energy to flip (Heyl 2008). The lowest way to flip is the second rod above
/// the hanging first one, where `3 cos a + cos b = 2`.
pub(crate) fn cannot_flip([a, b]: [f64; 2]) -> bool {
    3.0 * a.cos() + b.cos() > 2.0
}

/// Returns the angles at the centre of the cells of a row, of `cells` rows with as many columns. Row and column `cells - 1 - i` have
/// the angles of row and column `i` with the other sign.
pub(crate) fn row(row: u32, cells: u32) -> impl Iterator<Item = [f64; 2]> {
    let angle = move |cell: u32| PI * (f64::from(2 * cell + 1) - f64::from(cells)) / f64::from(cells);
    (0..cells).map(move |column| [angle(column), angle(row)])
}

/// The first flips of many pendulums.
pub(crate) struct Flips {
    /// The time of the first flip of each; NaN if there is none.
    pub(crate) times: Vec<f64>,
    /// The largest error of H.
    pub(crate) energy_error: f64,
}

/// Integrates pendulums that are released at rest, each until one of its rods flips or until a time. `goes_on` is called with the time
/// after each unit of time, and ends the integration if it returns false.
///
/// # Errors
/// A step has no solution.
pub(crate) fn flips(
    starts: &[[f64; 2]],
    steps_per_unit: u32,
    until: u32,
    mut goes_on: impl FnMut(u32) -> bool,
) -> Result<Flips, Error> {
    let members = starts.iter().map(|angles| (Rods, Phase::new(*angles, [0.0; 2])));
    let mut pendulums = Ensemble::new(GaussLegendre::<4>, members, 1.0 / f64::from(steps_per_unit))?;
    let energies = pendulums.energies();
    let hangs = |_, state: &Phase<[f64; 2]>| state.q.iter().all(|angle| angle.abs() < PI);
    for unit in 1..=until {
        pendulums.advance_while(u64::from(steps_per_unit), 1, hangs)?;
        if !goes_on(unit) {
            break;
        }
    }
    let time = |(member, state): (usize, Phase<[f64; 2]>)| {
        let steps = pendulums.steps_of(member).filter(|_| !hangs(member, &state));
        steps.map_or(f64::NAN, |steps| steps as f64 / f64::from(steps_per_unit))
    };
    let errors = energies.iter().zip(pendulums.energies()).map(|(before, after)| (after - before).abs());
    Ok(Flips { energy_error: errors.fold(0.0, f64::max), times: pendulums.states().enumerate().map(time).collect() })
}

/// Returns the squared frequencies of the two modes of small swings in closed form.
pub(crate) fn modes() -> [f64; 2] {
    [-1.0, 1.0].map(|sign| 3.0 + sign * 6.0 / 7.0_f64.sqrt())
}

/// Returns the squared frequency of a mode, from ten swings of the rods by a few millionths.
///
/// # Errors
/// A step has no solution.
pub(crate) fn small_swings(square: f64) -> Result<f64, Error> {
    let shape = [0.5 * square, 1.5 - 4.0 / 3.0 * square];
    let run = Rods.run(Phase::new(shape.map(|angle| 1e-6 * angle), [0.0; 2]), 0.1)?;
    let passages = run.crossings(10_000, Direction::Rising, |state, _| state.q[0]).take(11);
    let times: Vec<f64> = passages.map(|passage| Ok(passage?.time)).collect::<Result<_, Error>>()?;
    Ok((20.0 * PI / (times[10] - times[0])).powi(2))
}
