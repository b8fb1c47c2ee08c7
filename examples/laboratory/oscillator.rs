//! The harmonic oscillator `H = p²/2 + q²/2`, on which `n` steps of every method have a closed form.
//!
//! A step is a matrix `M`. Its eigenvalues are `r exp(±iθ)` with `r² = det M` and `2 r cos θ = tr M`, and diagonalising it
//! gives `Mⁿ = rⁿ (cos nθ + (M/r − cos θ) sin nθ / sin θ)`.

use crate::systems::Oscillator;
use integrator_core::{Method, prelude::*};
use integrator_laboratory::{Verdict, colour};
use integrator_plot::{Axis, Chart, Mark, colour::INK};
use integrator_reference::{
    BackwardEuler, ExplicitMidpoint, ForwardEuler, ImplicitMidpoint, RungeKutta4, StaggeredLeapfrog,
};

/// A step as a matrix that acts on `(q, p)`.
type Matrix = [[f64; 2]; 2];

/// Step and number of steps.
pub(crate) const H: f64 = 0.05;
pub(crate) const STEPS: u32 = 1_000;
const START: [f64; 2] = [1.0, 0.5];

/// A method with the closed form of its step.
pub(crate) struct ClosedForm {
    pub(crate) name: &'static str,
    pub(crate) matrix: Matrix,
    /// Final state by the method.
    arrives: fn(u32) -> Result<[f64; 2], Error>,
}

fn arrives<M: Method<Oscillator>>(method: M, steps: u32) -> Result<[f64; 2], Error> {
    let mut run = Oscillator.run_with(method, Phase::new([START[0]], [START[1]]), H)?;
    run.advance(steps.into())?;
    let state = run.state();
    Ok([state.q[0], state.p[0]])
}

/// Taylor series of cosine and sine of `H` up to the fourth power.
const COSINE: f64 = 1.0 - H * H / 2.0 + H * H * H * H / 24.0;
const SINE: f64 = H - H * H * H / 6.0;

const fn over(divisor: f64, [[a, b], [c, d]]: Matrix) -> Matrix {
    [[a / divisor, b / divisor], [c / divisor, d / divisor]]
}

/// Returns a row for each method.
pub(crate) const CLOSED_FORMS: [ClosedForm; 10] = [
    // z := z + hAz with A = (0 1; −1 0).
    ClosedForm { name: "forward Euler", matrix: [[1.0, H], [-H, 1.0]], arrives: |steps| arrives(ForwardEuler, steps) },
    // z := (1 − hA)⁻¹ z.
    ClosedForm {
        name: "backward Euler",
        matrix: over(1.0 + H * H, [[1.0, H], [-H, 1.0]]),
        arrives: |steps| arrives(BackwardEuler, steps),
    },
    // z := (1 + hA + h²A²/2) z.
    ClosedForm {
        name: "explicit midpoint",
        matrix: [[1.0 - H * H / 2.0, H], [-H, 1.0 - H * H / 2.0]],
        arrives: |steps| arrives(ExplicitMidpoint, steps),
    },
    // z := (1 − hA/2)⁻¹ (1 + hA/2) z.
    ClosedForm {
        name: "implicit midpoint",
        matrix: over(1.0 + H * H / 4.0, [[1.0 - H * H / 4.0, H], [-H, 1.0 - H * H / 4.0]]),
        arrives: |steps| arrives(ImplicitMidpoint, steps),
    },
    // The exponential of hA up to the fourth power.
    ClosedForm {
        name: "Runge–Kutta 4",
        matrix: [[COSINE, SINE], [-SINE, COSINE]],
        arrives: |steps| arrives(RungeKutta4, steps),
    },
    // p := p − hq, then q := q + hp.
    ClosedForm {
        name: "symplectic Euler",
        matrix: [[1.0 - H * H, H], [-H, 1.0]],
        arrives: |steps| arrives(Euler, steps),
    },
    // q := q + hp, then p := p − hq.
    ClosedForm {
        name: "adjoint symplectic Euler",
        matrix: [[1.0, H], [-H, 1.0 - H * H]],
        arrives: |steps| arrives(EulerAdjoint, steps),
    },
    ClosedForm {
        name: "Verlet",
        matrix: [[1.0 - H * H / 2.0, H - H * H * H / 4.0], [-H, 1.0 - H * H / 2.0]],
        arrives: |steps| arrives(Verlet, steps),
    },
    ClosedForm {
        name: "velocity Verlet",
        matrix: [[1.0 - H * H / 2.0, H], [-H + H * H * H / 4.0, 1.0 - H * H / 2.0]],
        arrives: |steps| arrives(VelocityVerlet, steps),
    },
    // The leapfrog starts with half a kick, and half a kick completes its last step.
    ClosedForm {
        name: "leapfrog",
        matrix: [[1.0 - H * H / 2.0, H], [-H + H * H * H / 4.0, 1.0 - H * H / 2.0]],
        arrives: |steps| arrives(StaggeredLeapfrog, steps),
    },
];

fn times(m: Matrix, [q, p]: [f64; 2]) -> [f64; 2] {
    [m[0][0] * q + m[0][1] * p, m[1][0] * q + m[1][1] * p]
}

impl ClosedForm {
    /// Returns the modulus of an eigenvalue minus one. A step multiplies areas by the square of the modulus.
    pub(crate) fn growth(&self) -> f64 {
        let m = self.matrix;
        (m[0][0] * m[1][1] - m[0][1] * m[1][0]).sqrt()
    }

    /// Returns `Mⁿ z` by the eigenvalues of `M`.
    fn after(&self, steps: u32) -> [f64; 2] {
        let (m, r) = (self.matrix, self.growth());
        let cosine = 0.5 * (m[0][0] + m[1][1]) / r;
        let sine = (1.0 - cosine * cosine).sqrt();
        let (sine_n, cosine_n) = (f64::from(steps) * sine.atan2(cosine)).sin_cos();
        let (size, once) = (r.powf(f64::from(steps)), times(m, START));
        [0, 1].map(|i| size * (cosine_n * START[i] + sine_n / sine * (once[i] / r - cosine * START[i])))
    }

    /// Returns the relative distance of the method from its closed form.
    pub(crate) fn distance(&self) -> Result<f64, Error> {
        let (end, exact) = ((self.arrives)(STEPS)?, self.after(STEPS));
        Ok((end[0] - exact[0]).hypot(end[1] - exact[1]) / exact[0].hypot(exact[1]))
    }
}

/// The distance from a closed form: each step rounds a few times, and the oscillator adds these roundings up, at worst in
/// the same sense; in the closed form the roundings of `r` and of the angle are multiplied by the number of steps.
pub(crate) const CLOSED: f64 = STEPS as f64 * 16.0 * f64::EPSILON;

/// Returns the claims about the oscillator.
pub(crate) fn claims() -> Result<Vec<Verdict>, Error> {
    let mut farthest = 0.0_f64;
    for form in &CLOSED_FORMS {
        farthest = farthest.max(form.distance()?);
    }
    let closed =
        "Every method ends where its diagonalised matrix says, after a thousand steps: the largest relative distance";
    let verlet = "Verlet is stable on the oscillator up to a step of 2/ω: the longest step with which the energy stays";
    let yoshida =
        "Yoshida's triple jump is stable up to a shorter step, since one of its steps goes back: the longest one";
    let claims = vec![
        Verdict::new("oscillator_closed_forms", closed, [0.0, CLOSED], Some(farthest)),
        Verdict::new("verlet_stability_limit", verlet, [1.999, 2.001], Some(longest(Verlet))),
        Verdict::new("yoshida4_stability_limit", yoshida, [1.5, 1.7], Some(longest(Yoshida4))),
    ];
    Ok(claims.into_iter().map(|claim| claim.shown_in("closed_forms")).collect())
}

/// Returns the longest stable step to a thousandth. A longer step multiplies the energy by a constant factor, some ten per
/// cent at a thousandth beyond the limit.
fn longest<M: Method<Oscillator>>(method: M) -> f64 {
    let stays = |h: f64| {
        let Ok(mut run) = Oscillator.run_with(method, Phase::new([1.0], [0.0]), h) else { return false };
        run.advance(4_000).is_ok() && run.energy() < 1e6
    };
    let (mut short, mut long) = (1.0, 4.0);
    while long - short > 1e-5 {
        let middle = 0.5 * (short + long);
        if stays(middle) { short = middle } else { long = middle }
    }
    short
}

/// Draws the energy and its closed form, for methods that gain or lose energy.
pub(crate) fn picture() -> Result<Chart, Error> {
    const SHOWN: [(&str, &str); 3] = [("forward Euler", "gains"), ("backward Euler", "loses"), ("Verlet", "keeps")];
    let chart = Chart::new("Harmonic oscillator: computed and closed form")
        .claim("Lines: the energy by the closed form rⁿ exp(±inθ), from the eigenvalues of the matrix of a step. Dots: computed.")
        .measured(format!("step {H}"))
        .along(Axis::linear("steps"))
        .up(Axis::logarithmic("energy"))
        .sized(1000, 560);
    SHOWN.into_iter().try_fold(chart, |chart, (name, does)| {
        let Some(form) = CLOSED_FORMS.iter().find(|form| form.name == name) else { return Ok(chart) };
        let energy = |[q, p]: [f64; 2]| 0.5 * (q * q + p * p);
        let line = (0..=STEPS).map(|n| (f64::from(n), energy(form.after(n))));
        let computed = (0..=STEPS).step_by(50).map(|n| Ok((f64::from(n), energy((form.arrives)(n)?))));
        let computed = computed.collect::<Result<Vec<_>, Error>>()?;
        let ink = colour(name).unwrap_or(INK);
        let chart = chart.line(format!("{name} {does}"), line.collect::<Vec<_>>()).coloured(ink).wide(1.5);
        Ok(chart.series(Mark::Dots, "", computed).coloured(ink))
    })
}
