//! Multistep methods: the field at past steps stands in for evaluations inside of this one.

use super::{
    runge_kutta::CLASSICAL,
    walk::{Place, Recipe, combined},
};
use crate::{
    error::Unsolved,
    scalar::real::Real,
    trajectory::method::{Described, Facts},
};

/// How many steps back the method looks.
const PAST: usize = 3;

/// The predictor of Adams and Bashforth over four points, and the corrector of Adams and Moulton that reads what was
/// predicted, once (Bashforth and Adams 1883, Moulton 1926). The first three steps are those of the classical
/// Runge–Kutta method. It remembers, so that a run that goes on from a state of another begins anew.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AdamsBashforthMoulton4;

impl Described for AdamsBashforthMoulton4 {
    fn facts(self) -> Facts {
        Facts { name: "AdamsBashforthMoulton4", order: 4, forces: Some(2), roundings: 4, ..Facts::UNCLAIMED }
    }
}

impl Recipe for AdamsBashforthMoulton4 {
    /// The field at the beginning of the last steps, the latest one first.
    type Memory<R: Real> = Vec<Vec<R>>;

    fn increment<R: Real>(self, past: &mut Vec<Vec<R>>, from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
        let slope = from.derivative();
        let increment = match &past[..] {
            [first, second, third] => {
                let scale = from.h / 24.0;
                let terms: [(f64, &[R]); 4] = [(55.0, &slope), (-59.0, first), (37.0, second), (-9.0, third)];
                let predicted = from.moved(&combined(scale, &terms));
                let ahead = from.field.derivative(&predicted, from.time + from.h);
                combined(scale, &[(9.0, &ahead), (19.0, &slope), (-5.0, first), (1.0, second)])
            }
            _ => CLASSICAL.increment(from),
        };
        past.insert(0, slope);
        past.truncate(PAST);
        Ok(increment)
    }
}
