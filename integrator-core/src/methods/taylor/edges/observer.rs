//! The observer of conditions: generated code shows it every condition that it evaluates.
//!
//! At the beginning of a step it records which side of each edge the motion is on. From then on it answers with these
//! sides, whatever the state, so that the code evaluates the same conditions in the same order.

use super::Enclosure;
use crate::scalar::{
    interval::Interval,
    real::{Mask, Real},
};
use alloc::vec::Vec;

/// The functions that return whole numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// The largest whole number that is not above.
    Floor,
    /// The least whole number that is not below.
    Ceil,
    /// The whole number towards zero.
    Trunc,
    /// The nearest whole number.
    Round,
}

/// An observer of the conditions that generated code evaluates.
pub trait Watch<R: Real> {
    /// The next comparison is one of the time and of parameters alone.
    fn of_time(&mut self);
    /// The condition `a < b`.
    fn less(&mut self, a: R, b: R) -> R::Mask;
    /// The condition `a <= b`.
    fn less_or_equal(&mut self, a: R, b: R) -> R::Mask;
    /// The condition `a == b`.
    fn equal(&mut self, a: R, b: R) -> R::Mask;
    /// A function that jumps from a whole number to the next one.
    fn level(&mut self, x: R, level: Level);
    /// The radicand of a root, a sum of squares: the root has a kink where it is zero.
    fn root(&mut self, radicand: R);
}

/// A quantity that stays positive as long as the motion stays on its side of an edge, with its derivative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Margin {
    pub(super) value: Interval,
    pub(super) rate: Interval,
    pub(super) kind: MarginKind,
    /// Whether the quantity depends on the time alone.
    pub(super) is_of_time: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MarginKind {
    /// The difference of two values that are compared.
    Side,
    /// The radicand of a root.
    Radicand,
}

impl Margin {
    fn of(value: Enclosure, kind: MarginKind) -> Self {
        let interval = |low: usize| Interval::new(value.lane(low), value.lane(low + 2));
        Self { value: interval(0), rate: interval(1), kind, is_of_time: false }
    }
    fn negated(self) -> Self {
        Self { value: -self.value, rate: -self.rate, ..self }
    }
}

/// Records sides and margins.
#[derive(Default)]
pub(super) struct Observer {
    /// Whether each condition held at the beginning, and the whole numbers there.
    sides: Vec<f64>,
    /// The number of conditions that were evaluated before the present one; `None` while sides are recorded.
    next: Option<usize>,
    pub(super) margins: Vec<Margin>,
    /// Whether the next comparison is one of the time alone.
    is_of_time: bool,
}

impl Observer {
    /// Begins another evaluation, of the sides that the first one recorded.
    pub(super) fn restart(&mut self) {
        self.next = Some(0);
        self.margins.clear();
    }

    /// The side of the present condition: the recorded one, or else this one.
    fn side(&mut self, now: f64) -> f64 {
        match &mut self.next {
            None => {
                self.sides.push(now);
                now
            }
            Some(next) => {
                *next += 1;
                self.sides.get(*next - 1).copied().unwrap_or(now)
            }
        }
    }

    fn compared(&mut self, [a, b]: [Enclosure; 2], holds: impl Fn(f64) -> bool) -> <Enclosure as Real>::Mask {
        let is_of_time = core::mem::take(&mut self.is_of_time);
        let margin = Margin { is_of_time, ..Margin::of(b - a, MarginKind::Side) };
        let holds = self.side(f64::from(u8::from(holds(margin.value.middle())))) > 0.0;
        self.margins.push(if holds { margin } else { margin.negated() });
        Mask::of(holds)
    }
}

impl Watch<Enclosure> for Observer {
    fn of_time(&mut self) {
        self.is_of_time = true;
    }
    fn less(&mut self, a: Enclosure, b: Enclosure) -> <Enclosure as Real>::Mask {
        self.compared([a, b], |difference| difference > 0.0)
    }
    fn less_or_equal(&mut self, a: Enclosure, b: Enclosure) -> <Enclosure as Real>::Mask {
        self.compared([a, b], |difference| difference >= 0.0)
    }
    /// Where two values are different, they may be equal for an instant, which no integral notices.
    fn equal(&mut self, a: Enclosure, b: Enclosure) -> <Enclosure as Real>::Mask {
        let is_of_time = core::mem::take(&mut self.is_of_time);
        let margin = Margin { is_of_time, ..Margin::of(-Real::abs(b - a), MarginKind::Side) };
        let holds = self.side(f64::from(u8::from(margin.value.middle() == 0.0))) > 0.0;
        if holds {
            self.margins.push(margin);
        }
        Mask::of(holds)
    }
    fn level(&mut self, x: Enclosure, level: Level) {
        let is_of_time = core::mem::take(&mut self.is_of_time);
        let middle = Margin::of(x, MarginKind::Side).value.middle();
        let whole = self.side(match level {
            Level::Floor => Real::floor(middle),
            Level::Ceil => Real::ceil(middle),
            Level::Trunc => Real::trunc(middle),
            Level::Round => Real::round(middle),
        });
        let [below, above] = match level {
            Level::Floor => [0.0, 1.0],
            Level::Ceil => [-1.0, 0.0],
            Level::Trunc if whole > 0.0 => [0.0, 1.0],
            Level::Trunc if whole < 0.0 => [-1.0, 0.0],
            Level::Trunc => [-1.0, 1.0],
            Level::Round => [-0.5, 0.5],
        };
        for margin in [x - Enclosure::of(whole + below), Enclosure::of(whole + above) - x] {
            self.margins.push(Margin { is_of_time, ..Margin::of(margin, MarginKind::Side) });
        }
    }
    fn root(&mut self, radicand: Enclosure) {
        self.margins.push(Margin::of(radicand, MarginKind::Radicand));
    }
}
