//! A disc of pendulums across the separatrix, its area and its energies.

use integrator_core::prelude::*;
use std::f64::consts::{PI, TAU};

#[derive(Clone, Copy)]
pub(crate) struct Pendulum;

#[hamiltonian(compose = BlanesMoanSrkn6)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

pub(crate) type State = Phase<[f64; 1]>;

/// Centre of the disc, on the separatrix `p = 2 cos(q/2)`, and its radius.
const CENTRE: f64 = -2.0;
pub(crate) const RADIUS: f64 = 0.4;

/// Energy of the separatrix, that of the upper equilibrium. Above it a pendulum rotates.
pub(crate) const SEPARATRIX: f64 = 1.0;

pub(crate) fn energy(state: &State) -> f64 {
    0.5 * state.p[0] * state.p[0] - state.q[0].cos()
}

/// Returns `border` pendulums along the border of the disc, in order, then `inside` pendulums that fill it evenly.
pub(crate) fn disc(border: usize, inside: usize) -> impl Iterator<Item = State> {
    let at = |radius: f64, angle: f64| {
        Phase::new([CENTRE + radius * angle.cos()], [2.0 * (CENTRE / 2.0).cos() + radius * angle.sin()])
    };
    // Successive points are rotated by the golden angle, as the seeds of a sunflower.
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let border = (0..border).map(move |i| at(RADIUS, TAU * i as f64 / border as f64));
    let radius = move |i: usize| RADIUS * ((i as f64 + 0.5) / inside as f64).sqrt();
    border.chain((0..inside).map(move |i| at(radius(i), golden * i as f64)))
}

/// Returns the area enclosed by the closed polygon through these states.
pub(crate) fn area(border: &[State]) -> f64 {
    let next = border.iter().cycle().skip(1);
    border.iter().zip(next).map(|(a, b)| 0.5 * (a.q[0] * b.p[0] - b.q[0] * a.p[0])).sum()
}

/// Returns the number of pendulums that crossed the separatrix. Those that began closer to it than `margin` in energy do
/// not count.
pub(crate) fn changed_sides(starts: &[State], states: &[State], margin: f64) -> usize {
    let above = |state: &State| energy(state) - SEPARATRIX;
    let both = starts.iter().map(above).zip(states.iter().map(above));
    both.filter(|(start, end)| start.abs() > margin && (*start > 0.0) != (*end > 0.0)).count()
}

/// Returns the angle modulo 2π, between -π and π.
pub(crate) fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
