//! Methods on the oscillator, where a step is a matrix: its eigenvalues as measured, and in closed form.
//!
//! `z' = Az` has the eigenvalues `±iω`. A Runge–Kutta method multiplies an eigenvector by its stability function `R(±ihω)`. The matrix
//! of a composition has determinant 1 and the eigenvalues `exp(±iθ)` with `2 cos θ` its trace. See Hairer, Lubich and Wanner,
//! Geometric Numerical Integration (2006), sections I.1 and VI.4.

use crate::{models::Oscillator, roots::Complex};
use integrator_core::{Method, prelude::*};
use integrator_reference::{
    AnyReference, BackwardEuler, ExplicitMidpoint, ForwardEuler, GaussLegendre4, GaussLegendre6, GraggBulirschStoer,
    ImplicitMidpoint, RungeKutta4, StaggeredLeapfrog,
};
use nalgebra::ComplexField;

/// The matrix of a step, or of several.
type Matrix = [[f64; 2]; 2];

/// A method on the oscillator.
#[derive(Clone, Debug)]
pub(crate) struct Map {
    pub(crate) name: &'static str,
    pub(crate) symplectic: bool,
    /// Steps `hω`, and the eigenvalue in the upper half plane.
    pub(crate) measured: Vec<(f64, Complex)>,
    /// The eigenvalue in closed form.
    pub(crate) formula: Option<fn(f64) -> Complex>,
}

/// All methods whose step is a linear map of the state.
#[derive(Clone, Debug)]
pub(crate) struct Linear {
    pub(crate) maps: Vec<Map>,
}

/// The steps `hω` are these parts of one: below the limits of stability of all compositions.
const STEPS: std::ops::RangeInclusive<u32> = 1..=15;
const PART: f64 = 0.1;
/// The longest one.
pub(crate) const LONGEST: f64 = 1.5;
/// The step from which the loss of Runge–Kutta 4 is large against rounding.
const LOSING: f64 = 0.5;

impl Map {
    /// The largest distance of the eigenvalues from the closed form, where there is one.
    pub(crate) fn off(&self) -> Option<f64> {
        let formula = self.formula?;
        Some(self.measured.iter().map(|(x, value)| (value - formula(*x)).modulus()).fold(0.0, f64::max))
    }

    /// The largest distance of the eigenvalues from the unit circle.
    pub(crate) fn off_circle(&self) -> f64 {
        self.measured.iter().map(|(_, value)| (value.modulus() - 1.0).abs()).fold(0.0, f64::max)
    }
}

impl Linear {
    /// The largest distance of eigenvalues from their closed form.
    pub(crate) fn off(&self) -> f64 {
        self.maps.iter().filter_map(Map::off).fold(0.0, f64::max)
    }

    /// The largest distance from the unit circle of a symplectic method.
    pub(crate) fn off_circle(&self) -> f64 {
        self.maps.iter().filter(|map| map.symplectic).map(Map::off_circle).fold(0.0, f64::max)
    }

    /// The largest relative difference of the loss `1 − |λ|²` of Runge–Kutta 4 from `h⁶/72 − h⁸/576`.
    pub(crate) fn loss_off(&self) -> Option<f64> {
        let map = self.maps.iter().find(|map| map.name == "Runge–Kutta 4")?;
        let steps = map.measured.iter().filter(|(x, _)| *x >= LOSING);
        let off = steps.map(|(x, value)| {
            let loss = x.powi(6) / 72.0 - x.powi(8) / 576.0;
            ((1.0 - value.modulus_squared()) / loss - 1.0).abs()
        });
        off.reduce(f64::max)
    }
}

/// Powers of a step by Horner's rule: `1 + z (1 + z/2 (1 + ...))` for the factors 1, 1/2, ...
fn series(z: Complex, factors: &[f64]) -> Complex {
    factors.iter().rev().fold(Complex::ONE, |sum, factor| sum * z * *factor + 1.0)
}

/// A diagonal Padé approximation: `N(z) / N(−z)`.
fn quotient(x: f64, factors: &[f64]) -> Complex {
    series(Complex::new(0.0, x), factors) / series(Complex::new(0.0, -x), factors)
}

/// The eigenvalue `exp(iθ)` with this half trace.
fn of_trace(cosine: f64) -> Complex {
    Complex::new(cosine, (1.0 - cosine * cosine).max(0.0).sqrt())
}

fn verlet(x: f64) -> Matrix {
    let cosine = 1.0 - 0.5 * x * x;
    [[cosine, x - 0.25 * x.powi(3)], [-x, cosine]]
}

fn product(a: Matrix, b: Matrix) -> Matrix {
    [0, 1].map(|i| [0, 1].map(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}

fn yoshida(x: f64) -> Complex {
    let outer = 1.0 / (2.0 - 2.0_f64.cbrt());
    let [outer, inner] = [outer, 1.0 - 2.0 * outer].map(|part| verlet(part * x));
    let [[a, _], [_, d]] = product(product(outer, inner), outer);
    of_trace(0.5 * (a + d))
}

/// The eigenvalue of a step in the upper half plane.
fn eigenvalue<M: Method<Oscillator>>(method: M, x: f64) -> Option<Complex> {
    let column = |q: f64, p: f64| {
        let mut run = Oscillator.run_with(method, Phase::new([q], [p]), x).ok()?;
        run.advance(1).ok()?;
        let state = run.state();
        Some([state.q[0], state.p[0]])
    };
    let ([a, c], [b, d]) = (column(1.0, 0.0)?, column(0.0, 1.0)?);
    // The root of (tr/2)² − det without a difference of numbers that are nearly equal.
    let turn = -(0.25 * (a - d).powi(2) + b * c);
    Some(Complex::new(0.5 * (a + d), turn.max(0.0).sqrt()))
}

fn map<M: Method<Oscillator>>(name: &'static str, method: M, formula: Option<fn(f64) -> Complex>) -> Option<Map> {
    let steps = STEPS.map(|step| PART * f64::from(step));
    let measured = steps.map(|x| Some((x, eigenvalue(method, x)?))).collect::<Option<_>>()?;
    Some(Map { name, symplectic: method.facts().symplectic, measured, formula })
}

/// Measures all methods; none where a step has no end.
pub(crate) fn linear() -> Option<Linear> {
    let maps = [
        map("forward Euler", AnyReference::from(ForwardEuler), Some(|x| Complex::new(1.0, x))),
        map("backward Euler", BackwardEuler, Some(|x| Complex::ONE / Complex::new(1.0, -x))),
        map("symplectic Euler", Euler, Some(|x| of_trace(1.0 - 0.5 * x * x))),
        map("leapfrog", AnyReference::from(StaggeredLeapfrog), Some(|x| of_trace(1.0 - 0.5 * x * x))),
        map("Verlet", Verlet, Some(|x| of_trace(1.0 - 0.5 * x * x))),
        map(
            "explicit midpoint",
            AnyReference::from(ExplicitMidpoint),
            Some(|x| series(Complex::new(0.0, x), &[1.0, 0.5])),
        ),
        map("implicit midpoint", ImplicitMidpoint, Some(|x| quotient(x, &[0.5]))),
        map("Gauss–Legendre 4", GaussLegendre4, Some(|x| quotient(x, &[0.5, 1.0 / 6.0]))),
        map("Gauss–Legendre 6", GaussLegendre6, Some(|x| quotient(x, &[0.5, 0.2, 1.0 / 12.0]))),
        map(
            "Runge–Kutta 4",
            AnyReference::from(RungeKutta4),
            Some(|x| series(Complex::new(0.0, x), &[1.0, 0.5, 1.0 / 3.0, 0.25])),
        ),
        map("Gragg–Bulirsch–Stoer", AnyReference::from(GraggBulirschStoer), None),
        map("Yoshida 4", Yoshida4, Some(yoshida)),
        map("Blanes–Moan 6", BlanesMoan6, None),
        map("Kahan–Li 8", KahanLi8, None),
        map("Chin 4A", Chin4A, None),
    ];
    Some(Linear { maps: maps.into_iter().collect::<Option<_>>()? })
}
