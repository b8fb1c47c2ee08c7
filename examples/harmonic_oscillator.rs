//! Compares four Euler methods on a linear oscillator with the closed form of N steps.
//!
//! For each method the program prints the state after N steps, its distance from the closed form, and the energy relative to
//! the start. The explicit method gains energy and the implicit one loses it. The symplectic ones, which cost as much as the
//! explicit one, keep it. The distances are rounding errors.
//!
//! A step is a matrix M. Its eigenvalues are r exp(±iθ) with r² = det M and 2 r cos θ = tr M. Diagonalisation gives Mᴺ = rᴺ
//! (cos Nθ + sin Nθ / sin θ · (M/r - cos θ)).

use integrator_core::prelude::*;

const STEPS: u32 = 1_000;
const H: f64 = 0.05;

struct Oscillator {
    mass: f64,
    stiffness: f64,
}

#[hamiltonian(compose = Euler)]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.mass)
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * self.stiffness * q[0].powi(2)
    }
}

type Matrix = [[f64; 2]; 2];

fn times(m: Matrix, [q, p]: [f64; 2]) -> [f64; 2] {
    [m[0][0] * q + m[0][1] * p, m[1][0] * q + m[1][1] * p]
}

/// Returns `Mᴺ z` by the eigenvalues of `M`.
fn closed_form(m: Matrix, z: [f64; 2]) -> [f64; 2] {
    let (half_trace, determinant) = (0.5 * (m[0][0] + m[1][1]), m[0][0] * m[1][1] - m[0][1] * m[1][0]);
    let (r, sine) = (determinant.sqrt(), (determinant - half_trace.powi(2)).sqrt());
    let (sine_n, cosine_n) = (f64::from(STEPS) * sine.atan2(half_trace)).sin_cos();
    let (first, once) = (r.powf(f64::from(STEPS)), times(m, z));
    [0, 1].map(|i| first * (cosine_n * z[i] + sine_n / sine * (once[i] - half_trace * z[i])))
}

fn main() -> Result<(), Error> {
    let system = Oscillator { mass: 2.0, stiffness: 8.0 };
    let start = [1.0, 0.5];
    let energy = |[q, p]: [f64; 2]| system.kinetic([p]) + system.potential([q]);
    let (a, b) = (H / system.mass, H * system.stiffness);

    // (q, p) := (q + a p, p - b q), and the same with the new values on the right-hand side.
    let explicit = [[1.0, a], [-b, 1.0]];
    let implicit = explicit.map(|row| row.map(|entry| entry / (1.0 + a * b)));
    let stepped = |m: Matrix| (0..STEPS).fold(start, |z, _| times(m, z));
    // The generated steppers: kick then drift, and drift then kick.
    let from = Phase::new([start[0]], [start[1]]);
    let (mut kick_drift, mut drift_kick) = (system.run(from, H)?, system.run_with(EulerAdjoint, from, H)?);
    kick_drift.advance(STEPS.into())?;
    drift_kick.advance(STEPS.into())?;
    let pair = |state: Phase<[f64; 1]>| [state.q[0], state.p[0]];

    println!("{:<14} {:>14} {:>14} {:>12} {:>12}", "Euler", "q", "p", "distance", "energy/E0");
    for (name, matrix, end) in [
        ("explicit", explicit, stepped(explicit)),
        ("implicit", implicit, stepped(implicit)),
        ("kick, drift", [[1.0 - a * b, a], [-b, 1.0]], pair(kick_drift.state())),
        ("drift, kick", [[1.0, a], [-b, 1.0 - a * b]], pair(drift_kick.state())),
    ] {
        let exact = closed_form(matrix, start);
        let distance = (end[0] - exact[0]).hypot(end[1] - exact[1]) / exact[0].hypot(exact[1]);
        println!("{name:<14} {:14.6e} {:14.6e} {distance:12.1e} {:12.3e}", end[0], end[1], energy(end) / energy(start));
    }
    Ok(())
}
