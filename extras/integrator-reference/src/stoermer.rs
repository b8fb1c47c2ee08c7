//! Multistep methods for the second-order equation `q'' = a(q)`, for `T` quadratic in `p`. Forces at past positions
//! replace evaluations within a step, and no velocity is needed.
//!
//! The textbook differences `q[n+1] - q[n]` are drifts by momenta between positions, since `T'` is affine in `p`:
//! `π[n+1] = π[n] + h Σ bᵢ F[n-i]`, `q[n+1] = q[n] + h T'(π[n+1])`. No mass is needed, and rounding errors of
//! differences are not summed twice. With one force in the sum this is the leapfrog.

use crate::{
    runge_kutta::CLASSICAL,
    walk::{Place, Recipe, combined},
};
use integrator_core::{__private::Real, Described, Facts, Unsolved};

/// The number of forces that a step reads.
const FORCES: usize = 4;

/// Störmer's formula over four positions (Störmer 1907), with one force evaluation per step.
///
/// The formula is `q[n+1] - 2 q[n] + q[n-1] = h²/12 (14 a[n] - 5 a[n-1] + 4 a[n-2] - a[n-3])`. The first three steps
/// use the classical Runge–Kutta method. The method stores past accelerations, so a run that continues from the state
/// of another one starts again.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stoermer4;

/// Störmer's formula as a predictor, and Cowell's corrector (Cowell and Crommelin 1910), with one correction (PECE).
///
/// The corrector is `h²/12 (a[n+1] + 10 a[n] + a[n-1])`, where `a[n+1]` is the acceleration at the predicted position.
/// Each step predicts, evaluates, corrects and evaluates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StoermerCowell4;

/// `π[n+1] - π[n]` in units of `h/12`, over the forces here and at past positions.
const STOERMER: [f64; FORCES] = [14.0, -5.0, 4.0, -1.0];

/// The weights of Cowell's corrector, over the force ahead and those here and before.
const COWELL: [f64; 3] = [1.0, 10.0, 1.0];

/// `p[n] - π[n]` in units of `h/360`, over the forces here and at past positions: `h (1/2 - ∇/6 - ∇²/24 - ∇³/45) F[n]`, which is what
/// the difference of two positions lacks of the velocity at the second one.
const SHOWN: [f64; FORCES] = [97.0, 114.0, -39.0, 8.0];

/// The memory of the method from step to step.
#[derive(Clone)]
pub struct Memory<R> {
    /// Forces at the latest positions, the latest one first.
    forces: Vec<Vec<R>>,
    /// The momenta that led to the latest positions, once there are enough forces.
    between: Option<Vec<R>>,
}

impl<R> Default for Memory<R> {
    fn default() -> Self {
        Self { forces: Vec::new(), between: None }
    }
}

impl<R> Memory<R> {
    fn remember(&mut self, force: Vec<R>) {
        self.forces.insert(0, force);
        self.forces.truncate(FORCES);
    }
}

/// A sum over forces, in units of a fraction of the step.
fn weighted<R: Real>(unit: f64, weights: &[f64], forces: &[Vec<R>]) -> Vec<R> {
    let terms: Vec<_> = weights.iter().zip(forces).map(|(weight, force)| (*weight, &force[..])).collect();
    combined(unit, &terms)
}

fn sum<R: Real>(a: &[R], b: &[R]) -> Vec<R> {
    a.iter().zip(b).map(|(a, b)| *a + *b).collect()
}

/// A step; `corrected` says whether what was predicted is.
fn increment<R: Real>(memory: &mut Memory<R>, from: &Place<'_, R>, corrected: bool) -> Vec<R> {
    let Place { field, y, time, h, .. } = *from;
    let (q, p) = y.split_at(y.len() / 2);
    if memory.forces.is_empty() {
        memory.remember(field.force(y, time));
    }
    let (increment, between) = if memory.forces.len() < FORCES {
        (CLASSICAL.increment(from), None)
    } else {
        let between = memory.between.take().unwrap_or_else(|| {
            let back = weighted(-h / 360.0, &SHOWN, &memory.forces);
            sum(p, &back)
        });
        // What momenta between positions move these by.
        let drift = |between: &[R]| -> Vec<R> {
            field.velocity(&[q, between].concat(), time).into_iter().map(|velocity| R::of(h) * velocity).collect()
        };
        let predicted = sum(&between, &weighted(h / 12.0, &STOERMER, &memory.forces));
        let ahead = if corrected {
            let end = [sum(q, &drift(&predicted)), predicted].concat();
            let forces = [&[field.force(&end, time + h)], &memory.forces[..2]].concat();
            sum(&between, &weighted(h / 12.0, &COWELL, &forces))
        } else {
            predicted
        };
        (drift(&ahead), Some(ahead))
    };
    // Momenta are not read by the force, so that those at the beginning of the step will do.
    let end: Vec<R> = sum(q, &increment).into_iter().chain(p.iter().copied()).collect();
    memory.remember(field.force(&end, time + h));
    let Some(between) = between else { return increment };
    let shown = sum(&between, &weighted(h / 360.0, &SHOWN, &memory.forces));
    memory.between = Some(between);
    increment.into_iter().chain(shown.iter().zip(p).map(|(shown, p)| *shown - *p)).collect()
}

macro_rules! methods {
    ($($method:ident: forces $forces:literal, corrected $corrected:literal;)*) => {$(
        impl Described for $method {
            fn facts(self) -> Facts {
                facts! { name: stringify!($method), order: 4, forces: Some($forces), roundings: 4 }
            }
        }

        impl Recipe for $method {
            type Memory<R: Real> = Memory<R>;

            fn increment<R: Real>(self, memory: &mut Memory<R>, from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
                Ok(increment(memory, from, $corrected))
            }
        }
    )*};
}
methods! {
    Stoermer4: forces 1, corrected false;
    StoermerCowell4: forces 2, corrected true;
}
