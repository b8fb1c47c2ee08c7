//! The harmonic oscillator `H = p²/2 + q²/2`, on which `N` steps of every method have a closed form.
//!
//! A step is a matrix `M`. Its eigenvalues are `r exp(±iθ)` with `r² = det M` and `2 r cos θ = tr M`, and diagonalising it
//! gives `Mᴺ = rᴺ (cos Nθ + (M/r − cos θ) sin Nθ / sin θ)`.

use crate::systems::Oscillator;
use integrator_core::{
    Method,
    prelude::*,
    reference::{BackwardEuler, ExplicitMidpoint, ForwardEuler, ImplicitMidpoint, RungeKutta4, StaggeredLeapfrog},
};

/// A step as a matrix that acts on `(q, p)`.
type Matrix = [[f64; 2]; 2];

/// The step, and how many are taken.
pub(crate) const H: f64 = 0.05;
pub(crate) const STEPS: u32 = 1_000;
const START: [f64; 2] = [1.0, 0.5];

/// A method with the closed form of its step.
pub(crate) struct ClosedForm {
    pub(crate) name: &'static str,
    pub(crate) matrix: Matrix,
    /// Where the method itself arrives.
    arrives: fn() -> Result<[f64; 2], Error>,
}

fn arrives<M: Method<Oscillator>>(method: M) -> Result<[f64; 2], Error> {
    let mut run = Oscillator.run_with(method, Phase::new([START[0]], [START[1]]), H)?;
    run.advance(STEPS.into())?;
    let state = run.state();
    Ok([state.q[0], state.p[0]])
}

/// The series of the cosine and the sine of `H`, up to the fourth power.
const COSINE: f64 = 1.0 - H * H / 2.0 + H * H * H * H / 24.0;
const SINE: f64 = H - H * H * H / 6.0;

const fn over(divisor: f64, [[a, b], [c, d]]: Matrix) -> Matrix {
    [[a / divisor, b / divisor], [c / divisor, d / divisor]]
}

/// One row for each method.
pub(crate) const CLOSED_FORMS: [ClosedForm; 10] = [
    // z := z + hAz with A = (0 1; −1 0).
    ClosedForm { name: "forward Euler", matrix: [[1.0, H], [-H, 1.0]], arrives: || arrives(ForwardEuler) },
    // z := (1 − hA)⁻¹ z.
    ClosedForm {
        name: "backward Euler",
        matrix: over(1.0 + H * H, [[1.0, H], [-H, 1.0]]),
        arrives: || arrives(BackwardEuler),
    },
    // z := (1 + hA + h²A²/2) z.
    ClosedForm {
        name: "explicit midpoint",
        matrix: [[1.0 - H * H / 2.0, H], [-H, 1.0 - H * H / 2.0]],
        arrives: || arrives(ExplicitMidpoint),
    },
    // z := (1 − hA/2)⁻¹ (1 + hA/2) z.
    ClosedForm {
        name: "implicit midpoint",
        matrix: over(1.0 + H * H / 4.0, [[1.0 - H * H / 4.0, H], [-H, 1.0 - H * H / 4.0]]),
        arrives: || arrives(ImplicitMidpoint),
    },
    // The exponential of hA up to the fourth power.
    ClosedForm { name: "Runge–Kutta 4", matrix: [[COSINE, SINE], [-SINE, COSINE]], arrives: || arrives(RungeKutta4) },
    // p := p − hq, then q := q + hp.
    ClosedForm { name: "symplectic Euler", matrix: [[1.0 - H * H, H], [-H, 1.0]], arrives: || arrives(Euler) },
    // q := q + hp, then p := p − hq.
    ClosedForm {
        name: "adjoint symplectic Euler",
        matrix: [[1.0, H], [-H, 1.0 - H * H]],
        arrives: || arrives(EulerAdjoint),
    },
    ClosedForm {
        name: "Verlet",
        matrix: [[1.0 - H * H / 2.0, H - H * H * H / 4.0], [-H, 1.0 - H * H / 2.0]],
        arrives: || arrives(Verlet),
    },
    ClosedForm {
        name: "velocity Verlet",
        matrix: [[1.0 - H * H / 2.0, H], [-H + H * H * H / 4.0, 1.0 - H * H / 2.0]],
        arrives: || arrives(VelocityVerlet),
    },
    // The leapfrog starts with half a kick and is shown after another one.
    ClosedForm {
        name: "leapfrog",
        matrix: [[1.0 - H * H / 2.0, H], [-H + H * H * H / 4.0, 1.0 - H * H / 2.0]],
        arrives: || arrives(StaggeredLeapfrog),
    },
];

fn times(m: Matrix, [q, p]: [f64; 2]) -> [f64; 2] {
    [m[0][0] * q + m[0][1] * p, m[1][0] * q + m[1][1] * p]
}

impl ClosedForm {
    /// By how much an eigenvalue is longer than one: a step multiplies areas by its square.
    pub(crate) fn growth(&self) -> f64 {
        let m = self.matrix;
        (m[0][0] * m[1][1] - m[0][1] * m[1][0]).sqrt()
    }

    /// `Mᴺ z` from the eigenvalues of `M`.
    fn end(&self) -> [f64; 2] {
        let (m, r) = (self.matrix, self.growth());
        let cosine = 0.5 * (m[0][0] + m[1][1]) / r;
        let sine = (1.0 - cosine * cosine).sqrt();
        let (sine_n, cosine_n) = (f64::from(STEPS) * sine.atan2(cosine)).sin_cos();
        let (size, once) = (r.powf(f64::from(STEPS)), times(m, START));
        [0, 1].map(|i| size * (cosine_n * START[i] + sine_n / sine * (once[i] / r - cosine * START[i])))
    }

    /// How far the method ends from its closed form, in units of that.
    pub(crate) fn distance(&self) -> Result<f64, Error> {
        let (end, exact) = ((self.arrives)()?, self.end());
        Ok((end[0] - exact[0]).hypot(end[1] - exact[1]) / exact[0].hypot(exact[1]))
    }
}
