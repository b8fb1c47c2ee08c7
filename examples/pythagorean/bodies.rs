//! The three bodies, where they end, and how near they come.

use integrator_core::prelude::*;

pub(crate) const MASSES: [f64; 3] = [3.0, 4.0, 5.0];

/// Positions or momenta, `[body][axis]`, with compensation of rounding errors.
pub(crate) type Compensation = [[Compensated<f64>; 2]; 3];

pub(crate) struct Pythagorean;

#[hamiltonian]
impl Pythagorean {
    /// `Σ |pᵢ|² / 2mᵢ`
    fn kinetic(&self, p: &[[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * MASSES[i])).sum()
    }

    /// `-Σ mᵢ mⱼ / |qᵢ - qⱼ|` over all pairs
    fn potential(&self, q: &[[f64; 2]; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let [x, y] = [q[i][0] - q[j][0], q[i][1] - q[j][1]];
                energy -= MASSES[i] * MASSES[j] / (x * x + y * y).sqrt();
            }
        }
        energy
    }
}

/// Returns a run from rest. Each body is opposite to the side whose length is its mass, and the centre of mass is at the
/// origin.
pub(crate) fn run(h: f64) -> Result<Run<Compensation>, Error> {
    let start = Phase::compensated([[1.0, 3.0], [-2.0, -1.0], [1.0, -1.0]], [[0.0; 2]; 3]);
    Pythagorean.run_with(Logarithmic(SofroniouSpaletta10), start, h)
}

/// Returns the run at t = 70 and its energy change.
pub(crate) fn end(h: f64) -> Result<(Run<Compensation>, f64), Error> {
    let mut run = run(h)?;
    let energy = run.energy();
    run.advance_to(70.0)?;
    let change = run.energy() / energy - 1.0;
    Ok((run, change))
}

/// Returns the distance between two bodies.
pub(crate) fn distance(q: &Compensation, a: usize, b: usize) -> f64 {
    f64::hypot(q[a][0].value - q[b][0].value, q[a][1].value - q[b][1].value)
}

/// Returns the smallest distance of two bodies at the end of a step until t = 70, and its time.
pub(crate) fn closest_approach(h: f64) -> Result<(f64, f64), Error> {
    let mut closest = (f64::INFINITY, 0.0);
    for sample in run(h)?.samples(1) {
        let sample = sample?;
        if sample.time > 70.0 {
            break;
        }
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let distance = distance(&sample.state.q, a, b);
            if distance < closest.0 {
                closest = (distance, sample.time);
            }
        }
    }
    Ok(closest)
}
