//! Implicit methods of one stage: Newton's iteration with the Hessian of the generated code.

use super::walk::{Place, Recipe};
use crate::{
    error::Unsolved,
    scalar::{
        real::Real,
        tolerance::{largest, ratio},
    },
    trajectory::method::{Described, Facts},
};
use nalgebra::{DMatrix, DVector};

/// After so many iterations without an end there is none. Newton's iteration doubles the digits with each, so that a
/// handful reaches the rounding from wherever it converges.
const ITERATIONS: u32 = 32;

/// The update at which the iteration has reached the rounding, in ε of the largest coordinate of its kind.
const SETTLED: f64 = 4.0;

/// An update that no longer shrinks is rounding too if it is as small as this, in ε: the equation is then worse
/// conditioned than the state is precise.
const STALLED: f64 = 1e6;

/// What a step adds that takes the field at the stage `z = y + a h f(z, t + a h)`.
fn increment<R: Real>(a: f64, from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
    let Place { field, y, h, epsilon, .. } = *from;
    let time = from.time + a * h;
    let scaled = R::of(a * h);
    let half = y.len() / 2;
    let mut z: Vec<R> = y.iter().zip(from.derivative()).map(|(y, f)| *y + scaled * f).collect();
    let mut update = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let residual: Vec<R> =
            z.iter().zip(y).zip(field.derivative(&z, time)).map(|((z, y), f)| *z - *y - scaled * f).collect();
        let values: Vec<f64> = z.iter().map(|z| z.lane(0)).collect();
        let matrix = DMatrix::identity(z.len(), z.len()) - field.jacobian(&values, time) * (a * h);
        let factors = matrix.lu();
        let mut lanes = Vec::with_capacity(R::LANES);
        for lane in 0..R::LANES {
            let residual = DVector::from_iterator(z.len(), residual.iter().map(|r| r.lane(lane)));
            // A matrix that is singular, or no number, leads nowhere: the last update says how far the iteration was.
            let Some(step) = factors.solve(&residual) else { return Err(unsolved(update)) };
            lanes.push(step);
        }
        for (i, z) in z.iter_mut().enumerate() {
            *z -= R::state(&|lane| lanes[lane][i]);
        }
        let relative = largest(lanes.iter().enumerate().flat_map(|(lane, step)| {
            [0..half, half..z.len()].map(|range| {
                let moved = largest(range.clone().map(|i| step[i]));
                // Where the end is zero, the beginning tells what is rounding: they differ by what rounds.
                ratio(moved, largest(range.flat_map(|i| [z[i].lane(lane), y[i].lane(lane)])))
            })
        }));
        let stalled = relative >= update / 2.0 && relative <= STALLED * epsilon;
        if relative <= SETTLED * epsilon || stalled {
            let slope = field.derivative(&z, time);
            return Ok(slope.into_iter().map(|f| R::of(h) * f).collect());
        }
        update = relative;
    }
    Err(unsolved(update))
}

fn unsolved(update: f64) -> Unsolved {
    Unsolved::Newton { iterations: ITERATIONS, update }
}

macro_rules! implicit {
    ($($(#[$doc:meta])* $name:ident: order $order:literal, symmetric $symmetric:literal, stage $a:literal;)*) => {$(
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
                increment($a, from)
            }
        }
    )*};
}
implicit! {
    /// The solution of `z = y + h f(z)`. A harmonic oscillator keeps the share `1/(1 + (h·ω)²)` of its energy in each
    /// step. Stable for every step where the motion oscillates.
    BackwardEuler: order 1, symmetric false, stage 1.0;
    /// `y + h f(z)` at the middle `z = (y + y')/2` of the step. It is symplectic for every Hamiltonian, separable or not,
    /// and conserves every quadratic integral, the energy of a harmonic oscillator among them.
    ImplicitMidpoint: order 2, symmetric true, stage 0.5;
}
