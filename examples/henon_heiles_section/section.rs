//! The Hénon–Heiles system (1964), its Poincaré section, and a test for regular orbits.

use integrator_core::prelude::*;

/// A star in a galaxy, in the meridian plane that rotates with it.
#[derive(Clone, Copy)]
pub(crate) struct HenonHeiles;

#[hamiltonian(compose = BlanesMoanSrkn11)]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

const STEP: f64 = 0.25;

/// Initial distance of the neighbouring orbit.
const APART: f64 = 1e-10;
/// Growth of the distance from which an orbit counts as chaotic. It grows linearly for regular orbits and exponentially for
/// chaotic ones.
const PARTED: f64 = 1e6;

/// Returns `p_x²` at `x = 0` for given `y`, `p_y` and energy. Negative where the energy allows no orbit.
fn square_across(energy: f64, y: f64, py: f64) -> f64 {
    2.0 * energy - py * py - y * y + 2.0 / 3.0 * y.powi(3)
}

/// Returns the border of the section: points `(y, p_y)` with `p_x = 0`.
pub(crate) fn border(energy: f64) -> Vec<(f64, f64)> {
    let upper: Vec<_> = (-1000..=1000)
        .map(|i| f64::from(i) / 1000.0)
        .filter_map(|y| {
            let square = square_across(energy, y, 0.0);
            (square >= 0.0).then(|| (y, square.sqrt()))
        })
        .collect();
    let lower = upper.iter().rev().map(|(y, py)| (*y, -py));
    upper.iter().copied().chain(lower).chain(upper.first().copied()).collect()
}

/// Returns initial points on the section: those of a grid of `side` × `side` that the energy allows.
pub(crate) fn starts(energy: f64, side: u32) -> Vec<(f64, f64)> {
    let half = (2.0 * energy).sqrt();
    // Centres of cells. In y, the section extends farther up than down, to 1 at the escape energy.
    let place = |i: u32, least: f64, most: f64| least + (most - least) * (f64::from(i) + 0.5) / f64::from(side);
    let all = (0..side).flat_map(|i| (0..side).map(move |j| (place(i, -half, 1.75 * half), place(j, -half, half))));
    all.filter(|(y, py)| *y < 1.0 && square_across(energy, *y, *py) > 1e-6).collect()
}

/// The crossings of one orbit.
pub(crate) struct Orbit {
    /// `(y, p_y)` at every crossing of `x = 0` with `p_x > 0`.
    pub(crate) points: Vec<(f64, f64)>,
    pub(crate) regular: bool,
    /// Largest relative energy change.
    pub(crate) energy_error: f64,
}

/// Returns the crossings of the orbit through a point of the section, without this point.
fn passages(
    energy: f64,
    (y, py): (f64, f64),
    count: usize,
) -> Result<impl Iterator<Item = Result<Sample<[f64; 2]>, Error>>, Error> {
    let px = square_across(energy, y, py).max(0.0).sqrt();
    // A period takes 6 to 20 units of time; longer periods give fewer points.
    let steps = count as u64 * (25.0 / STEP) as u64;
    let run = HenonHeiles.run(Phase::new([0.0, y], [px, py]), STEP)?;
    Ok(run.crossings(steps, Direction::Rising, |state, _| state.q[0]).take(count))
}

/// Integrates the orbit through a point of the section, and a neighbouring orbit.
pub(crate) fn orbit(energy: f64, start: (f64, f64), count: usize) -> Result<Orbit, Error> {
    let beside = (start.0 + APART, start.1);
    let (mut points, mut apart, mut energy_error) = (vec![start], 0.0_f64, 0.0_f64);
    for (passage, other) in passages(energy, start, count)?.zip(passages(energy, beside, count)?) {
        let (passage, other) = (passage?, other?);
        let [at, there] = [&passage, &other].map(|sample| (sample.state.q[1], sample.state.p[1]));
        points.push(at);
        apart = apart.max((at.0 - there.0).hypot(at.1 - there.1));
        energy_error = energy_error.max((passage.energy() / energy - 1.0).abs());
    }
    Ok(Orbit { points, regular: apart < PARTED * APART, energy_error })
}
