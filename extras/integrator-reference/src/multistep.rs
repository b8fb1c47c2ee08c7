//! Multistep methods: the field at past steps replaces evaluations within a step.

use crate::{
    runge_kutta::CLASSICAL,
    walk::{Place, Recipe, combined},
};
use integrator_core::{__private::Real, Described, Facts, Unsolved};

/// The number of past steps that the method reads.
const PAST: usize = 3;

/// The Adams–Bashforth formula over four points (Bashforth and Adams 1883), with one evaluation of the field per step.
///
/// The first three steps use the classical Runge–Kutta method. The method stores past derivatives, so a run that
/// continues from the state of another one starts again.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AdamsBashforth4;

/// The Adams–Bashforth predictor and the Adams–Moulton corrector over four points (Moulton 1926), with one correction
/// (PECE).
///
/// Each step predicts, evaluates, corrects and evaluates. The start and the stored derivatives are those of
/// [`AdamsBashforth4`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AdamsBashforthMoulton4;

/// [`AdamsBashforthMoulton4`] without the last evaluation (PEC): one evaluation per step, less accurate and less
/// stable.
///
/// Later steps use the field at the predicted state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AdamsBashforthMoulton4Pec;

macro_rules! described {
    ($($method:ident $forces:literal;)*) => {
        $(impl Described for $method {
            fn facts(self) -> Facts {
                facts! { name: stringify!($method), order: 4, forces: Some($forces), roundings: 4 }
            }
        })*
    };
}
described! {
    AdamsBashforth4 1;
    AdamsBashforthMoulton4 2;
    AdamsBashforthMoulton4Pec 1;
}

/// The field at the beginning of the last steps, the latest one first.
type Past<R> = Vec<Vec<R>>;

/// Returns the increment by Adams and Bashforth, over the field here and at the past steps.
fn predictor<R: Real>(h: f64, slope: &[R], [first, second, third]: [&[R]; PAST]) -> Vec<R> {
    combined(h / 24.0, &[(55.0, slope), (-59.0, first), (37.0, second), (-9.0, third)])
}

/// Returns the increment by Adams and Moulton, with the field ahead.
fn corrector<R: Real>(h: f64, ahead: &[R], slope: &[R], [first, second, _]: [&[R]; PAST]) -> Vec<R> {
    combined(h / 24.0, &[(9.0, ahead), (19.0, slope), (-5.0, first), (1.0, second)])
}

/// One more step is past.
fn remember<R>(past: &mut Past<R>, slope: Vec<R>) {
    past.insert(0, slope);
    past.truncate(PAST);
}

impl Recipe for AdamsBashforth4 {
    type Memory<R: Real> = Past<R>;

    fn increment<R: Real>(self, past: &mut Past<R>, from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
        let slope = from.derivative();
        let increment = match &past[..] {
            [first, second, third] => predictor(from.h, &slope, [first, second, third]),
            _ => CLASSICAL.increment(from),
        };
        remember(past, slope);
        Ok(increment)
    }
}

impl Recipe for AdamsBashforthMoulton4 {
    type Memory<R: Real> = Past<R>;

    fn increment<R: Real>(self, past: &mut Past<R>, from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
        let slope = from.derivative();
        let increment = match &past[..] {
            [first, second, third] => {
                let past: [&[R]; PAST] = [first, second, third];
                let predicted = from.moved(&predictor(from.h, &slope, past));
                let ahead = from.field.derivative(&predicted, from.time + from.h);
                corrector(from.h, &ahead, &slope, past)
            }
            _ => CLASSICAL.increment(from),
        };
        remember(past, slope);
        Ok(increment)
    }
}

impl Recipe for AdamsBashforthMoulton4Pec {
    /// Here the first one is the field at the beginning of this step, where it was predicted.
    type Memory<R: Real> = Past<R>;

    fn increment<R: Real>(self, past: &mut Past<R>, from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
        let Place { field, time, h, .. } = *from;
        if past.is_empty() {
            past.push(from.derivative());
        }
        let (increment, ahead) = match &past[..] {
            [slope, first, second, third] => {
                let past: [&[R]; PAST] = [first, second, third];
                let predicted = from.moved(&predictor(h, slope, past));
                let ahead = field.derivative(&predicted, time + h);
                (corrector(h, &ahead, slope, past), ahead)
            }
            _ => {
                let increment = CLASSICAL.increment(from);
                let ahead = field.derivative(&from.moved(&increment), time + h);
                (increment, ahead)
            }
        };
        past.insert(0, ahead);
        past.truncate(PAST + 1);
        Ok(increment)
    }
}
