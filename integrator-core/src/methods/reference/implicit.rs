//! Implicit methods of Runge and Kutta: Newton's iteration with the Hessian of the generated code.

use super::walk::{Place, Recipe};
use crate::{
    error::Unsolved,
    scalar::{
        real::Real,
        tolerance::{largest, ratio},
    },
    trajectory::method::{Described, Facts},
};
use core::{array, ops::Range};
use nalgebra::{DMatrix, DVector};

/// After so many iterations without an end there is none. Newton's iteration doubles the digits with each, so that a
/// handful reaches the rounding from wherever it converges.
const ITERATIONS: u32 = 32;

/// The update at which the iteration has reached the rounding, in ε of the largest coordinate of its kind.
const SETTLED: f64 = 4.0;

/// An update that no longer shrinks is rounding too if it is as small as this, in ε: the equation is then worse
/// conditioned than the state is precise.
const STALLED: f64 = 1e6;

/// Stages `zᵢ = y + h Σ aᵢⱼ f(zⱼ, t + cⱼ h)` of a Runge-Kutta method, which adds `h Σ bᵢ f(zᵢ, t + cᵢ h)`.
struct Tableau<const S: usize> {
    a: [[f64; S]; S],
    b: [f64; S],
    c: [f64; S],
}

/// One stage, at `a h`.
const fn one_stage(a: f64) -> Tableau<1> {
    Tableau { a: [[a]], b: [1.0], c: [a] }
}

/// `√3/6`.
const X: f64 = 0.288_675_134_594_812_9;

/// The abscissas and weights of Gauss with two points.
const GAUSS_4: Tableau<2> = Tableau { a: [[0.25, 0.25 - X], [0.25 + X, 0.25]], b: [0.5; 2], c: [0.5 - X, 0.5 + X] };

/// `√15`.
const Y: f64 = 3.872_983_346_207_417;

/// Those with three points.
const GAUSS_6: Tableau<3> = Tableau {
    a: [
        [5.0 / 36.0, 2.0 / 9.0 - Y / 15.0, 5.0 / 36.0 - Y / 30.0],
        [5.0 / 36.0 + Y / 24.0, 2.0 / 9.0, 5.0 / 36.0 - Y / 24.0],
        [5.0 / 36.0 + Y / 30.0, 2.0 / 9.0 + Y / 15.0, 5.0 / 36.0],
    ],
    b: [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0],
    c: [0.5 - Y / 10.0, 0.5, 0.5 + Y / 10.0],
};

/// What a step adds.
fn increment<R: Real, const S: usize>(tableau: &Tableau<S>, from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
    let Place { field, y, h, epsilon, .. } = *from;
    let Tableau { a, b, c } = tableau;
    let size = y.len();
    let half = size / 2;
    let start = from.derivative();
    let fields = |z: &[Vec<R>; S]| array::from_fn::<_, S, _>(|j| field.derivative(&z[j], from.time + c[j] * h));
    let begin = |i: usize| y.iter().zip(&start).map(|(y, f)| *y + R::of(c[i] * h) * *f).collect();
    let mut z: [Vec<R>; S] = array::from_fn(begin);
    let mut update = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let slopes = fields(&z);
        let residual = |i: usize, k: usize| {
            (0..S).fold(z[i][k] - y[k], |residual, j| residual - R::of(a[i][j] * h) * slopes[j][k])
        };
        let residuals: Vec<R> = (0..S * size).map(|row| residual(row / size, row % size)).collect();
        let mut matrix = DMatrix::identity(S * size, S * size);
        for j in 0..S {
            let values: Vec<f64> = z[j].iter().map(|z| z.lane(0)).collect();
            let jacobian = field.jacobian(&values, from.time + c[j] * h);
            for (i, row) in a.iter().enumerate() {
                let mut block = matrix.view_mut((i * size, j * size), (size, size));
                block -= &jacobian * (row[j] * h);
            }
        }
        let factors = matrix.lu();
        let mut lanes = Vec::with_capacity(R::LANES);
        for lane in 0..R::LANES {
            let residual = DVector::from_iterator(S * size, residuals.iter().map(|r| r.lane(lane)));
            // A matrix that is singular, or no number, leads nowhere: the last update says how far the iteration was.
            let Some(step) = factors.solve(&residual) else { return Err(unsolved(update)) };
            lanes.push(step);
        }
        for (row, z) in z.iter_mut().flatten().enumerate() {
            *z -= R::state(&|lane| lanes[lane][row]);
        }
        let relative = |lane: usize, stage: usize, range: Range<usize>| {
            let moved = largest(range.clone().map(|k| lanes[lane][stage * size + k]));
            // Where the end is zero, the beginning tells what is rounding: they differ by what rounds.
            ratio(moved, largest(range.flat_map(|k| [z[stage][k].lane(lane), y[k].lane(lane)])))
        };
        let stages = (0..R::LANES).flat_map(|lane| (0..S).map(move |stage| (lane, stage)));
        let relative =
            largest(stages.flat_map(|(lane, stage)| [0..half, half..size].map(|range| relative(lane, stage, range))));
        let stalled = relative >= update / 2.0 && relative <= STALLED * epsilon;
        if relative <= SETTLED * epsilon || stalled {
            let slopes = fields(&z);
            let sum = |k: usize| {
                let others = slopes.iter().zip(b).skip(1);
                others.fold(R::of(b[0] * h) * slopes[0][k], |sum, (slope, b)| sum + R::of(b * h) * slope[k])
            };
            return Ok((0..size).map(sum).collect());
        }
        update = relative;
    }
    Err(unsolved(update))
}

fn unsolved(update: f64) -> Unsolved {
    Unsolved::Newton { iterations: ITERATIONS, update }
}

macro_rules! implicit {
    ($($(#[$doc:meta])* $name:ident: order $order:literal, symmetric $symmetric:literal, stages $tableau:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct $name;

        impl Described for $name {
            fn facts(self) -> Facts {
                Facts {
                    name: stringify!($name),
                    order: $order,
                    symmetric: $symmetric,
                    symplectic: $symmetric,
                    stability_limit: Some(f64::INFINITY),
                    roundings: 16,
                    ..Facts::UNCLAIMED
                }
            }
        }

        impl Recipe for $name {
            type Memory<R: Real> = ();

            fn increment<R: Real>(self, _: &mut (), from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
                increment(&$tableau, from)
            }
        }
    )*};
}
implicit! {
    /// The solution of `z = y + h f(z)`. A harmonic oscillator keeps the share `1/(1 + (h·ω)²)` of its energy in each
    /// step. Stable for every step where the motion oscillates.
    BackwardEuler: order 1, symmetric false, stages one_stage(1.0);
    /// `y + h f(z)` at the middle `z = (y + y')/2` of the step. It is symplectic for every Hamiltonian, separable or not,
    /// and conserves every quadratic integral, the energy of a harmonic oscillator among them.
    ImplicitMidpoint: order 2, symmetric true, stages one_stage(0.5);
    /// The method of Gauss with two stages: symplectic for every Hamiltonian, separable or not, like [`ImplicitMidpoint`].
    GaussLegendre4: order 4, symmetric true, stages GAUSS_4;
    /// The method of Gauss with three stages.
    GaussLegendre6: order 6, symmetric true, stages GAUSS_6;
}
