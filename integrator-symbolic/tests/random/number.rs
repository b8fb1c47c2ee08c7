//! Numbers of the interpreter: a value, its derivatives by every coordinate, and bounds of both.
//!
//! Derivatives are carried forward by the chain rule, beside the user's own text; nothing here knows the generator's.

use crate::bounded::{Bounded, ELEMENTARY};

/// Which type a number has in the text: plain `f64`, or what flows are generic over. Two of them do not mix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Plain,
    Scalar,
    Wide,
}

/// A number; a list of derivatives that is empty stands for zeros.
#[derive(Clone, Debug)]
pub(crate) struct Number {
    pub(crate) main: Bounded,
    pub(crate) tangents: Vec<Bounded>,
    pub(crate) kind: Kind,
    /// Whether it is one where a condition on no numbers holds, and zero where it does not.
    pub(crate) is_flag: bool,
}

const ZERO: Bounded = Bounded { value: 0.0, error: 0.0 };

/// A slope times a derivative: that of a constant stays zero, however steep a function of it is. What is zero because
/// of a factor is not that of a constant.
fn chained(slope: Bounded, tangent: Bounded) -> Bounded {
    match (tangent.is_zero(), slope.is_zero()) {
        (true, _) => ZERO,
        (false, true) => Bounded { value: 0.0, error: f64::MIN_POSITIVE },
        (false, false) => slope * tangent,
    }
}

impl Number {
    pub(crate) fn plain(value: f64) -> Self {
        Self { main: value.into(), tangents: Vec::new(), kind: Kind::Plain, is_flag: false }
    }

    pub(crate) fn of_kind(self, kind: Kind) -> Self {
        Self { kind, ..self }
    }

    /// A coordinate with the derivative one by itself.
    pub(crate) fn coordinate(value: f64, place: usize, count: usize) -> Self {
        let tangents = (0..count).map(|other| f64::from(u8::from(other == place)).into()).collect();
        Self { tangents, ..Self::plain(value) }
    }

    pub(crate) fn tangent(&self, place: usize) -> Bounded {
        self.tangents.get(place).copied().unwrap_or(ZERO)
    }

    /// A result with derivatives built from those of the operands.
    fn with(
        &self,
        main: Bounded,
        others: &[&Number],
        tangent: impl Fn(&dyn Fn(&Number) -> Bounded) -> Bounded,
    ) -> Self {
        let count = others.iter().map(|other| other.tangents.len()).fold(self.tangents.len(), usize::max);
        let tangents = (0..count).map(|place| tangent(&|number: &Number| number.tangent(place))).collect();
        Self { main, tangents, kind: self.kind, is_flag: false }
    }

    fn along(&self, main: Bounded, slope: Bounded) -> Self {
        self.with(main, &[], |of| chained(slope, of(self)))
    }

    pub(crate) fn neg(&self) -> Self {
        self.with(-self.main, &[], |of| -of(self))
    }

    pub(crate) fn add(&self, other: &Self) -> Self {
        self.with(self.main + other.main, &[other], |of| of(self) + of(other))
    }

    pub(crate) fn sub(&self, other: &Self) -> Self {
        self.with(self.main - other.main, &[other], |of| of(self) - of(other))
    }

    pub(crate) fn mul(&self, other: &Self) -> Self {
        let main = self.main * other.main;
        self.with(main, &[other], |of| chained(other.main, of(self)) + chained(self.main, of(other)))
    }

    /// `self * b + c`, rounded once; the bound is that of two roundings.
    pub(crate) fn fma(&self, b: &Self, c: &Self) -> Self {
        let apart = self.mul(b).add(c);
        Self { main: Bounded { value: self.main.value.mul_add(b.main.value, c.main.value), ..apart.main }, ..apart }
    }

    pub(crate) fn div(&self, other: &Self) -> Self {
        let main = self.main / other.main;
        self.with(main, &[other], |of| {
            let numerator = of(self) - chained(main, of(other));
            if numerator.is_zero() { ZERO } else { numerator / other.main }
        })
    }

    pub(crate) fn rem(&self, other: &Self) -> Self {
        let iterations = (self.main.value / other.main.value).trunc();
        let reduced = self.main - Bounded::from(iterations) * other.main;
        let main = Bounded { value: self.main.value % other.main.value, ..reduced };
        self.with(main, &[other], |of| of(self) - chained(iterations.into(), of(other)))
    }

    /// The absolute value; where the sign is not known, nor is the derivative.
    pub(crate) fn abs(&self) -> Self {
        let (sign, unknown) = (self.main.value.signum(), self.main.is_near(ZERO) || self.main.value == 0.0);
        self.with(self.main.abs(), &[], |of| {
            let tangent = of(self);
            let error = tangent.error + if unknown { 2.0 * tangent.value.abs() } else { 0.0 };
            Bounded { value: sign * tangent.value, error }
        })
    }

    /// The smaller or the larger of two; where it is not known which, the derivative is that of either.
    pub(crate) fn extreme(&self, other: &Self, value: fn(f64, f64) -> f64) -> Self {
        let (a, b) = (self.main, other.main);
        let chosen = value(a.value, b.value);
        let first = chosen == a.value || b.value.is_nan();
        let error = if a.is_near(b) {
            a.error.max(b.error)
        } else if first {
            a.error
        } else {
            b.error
        };
        let unknown = a.is_near(b) || a.value == b.value;
        self.with(Bounded { value: chosen, error }, &[other], |of| {
            let (kept, left) = if first { (of(self), of(other)) } else { (of(other), of(self)) };
            let apart = if unknown { (kept.value - left.value).abs() + left.error } else { 0.0 };
            Bounded { error: kept.error + apart, ..kept }
        })
    }

    pub(crate) fn powi(&self, exponent: i32) -> Self {
        let slope = match exponent {
            0 => ZERO,
            _ => self.main.powi(exponent - 1) * f64::from(exponent).into(),
        };
        self.along(self.main.powi(exponent), slope)
    }

    pub(crate) fn powf(&self, exponent: &Self) -> Self {
        let main = self.main.powf(exponent.main);
        let one = Bounded::from(1.0);
        let by_base = self.main.powf(exponent.main - one) * exponent.main;
        let by_exponent = main * self.main.ln();
        self.with(main, &[exponent], |of| chained(by_base, of(self)) + chained(by_exponent, of(exponent)))
    }

    pub(crate) fn hypot(&self, other: &Self) -> Self {
        let root = self.mul(self).add(&other.mul(other)).function("sqrt").unwrap_or_else(|| self.clone());
        let value = self.main.value.hypot(other.main.value);
        Self { main: Bounded { value, ..root.main }, ..root }
    }

    pub(crate) fn atan2(&self, other: &Self) -> Self {
        let (y, x) = (self.main, other.main);
        let square = x.square() + y.square();
        // The angle moves by no more than the displacement over the distance.
        let moved = Bounded { value: 0.0, error: x.error + y.error } / square.sqrt();
        let value = y.value.atan2(x.value);
        let crossing = x.value <= x.error && y.is_near(ZERO);
        let error = if crossing { f64::INFINITY } else { moved.error + 4.0 * f64::EPSILON };
        self.with(Bounded { value, error }, &[other], |of| {
            let numerator = chained(x, of(self)) - chained(y, of(other));
            if numerator.is_zero() { ZERO } else { numerator / square }
        })
    }

    /// A piecewise constant function, which has to be told from afar on which piece it is.
    fn step(&self, value: fn(f64) -> f64) -> Self {
        let Bounded { value: x, error } = self.main;
        let known = error == 0.0 || value(x - error) == value(x + error);
        let main = Bounded { value: value(x), error: if known { 0.0 } else { f64::INFINITY } };
        Self { main, tangents: Vec::new(), kind: self.kind, is_flag: false }
    }

    /// An elementary function of one argument; `fast_` ones are within four units in the last place, which all are
    /// here.
    pub(crate) fn function(&self, name: &str) -> Option<Self> {
        let name = name.strip_prefix("fast_").unwrap_or(name);
        if let Some(row) = ELEMENTARY.iter().find(|row| row.name == name) {
            let (main, slope) = self.main.apply(row);
            return Some(self.along(main, slope));
        }
        Some(match name {
            "abs" => self.abs(),
            "signum" => self.step(f64::signum),
            "floor" => self.step(f64::floor),
            "ceil" => self.step(f64::ceil),
            "round" => self.step(f64::round),
            "round_ties_even" => self.step(f64::round_ties_even),
            "trunc" => self.step(f64::trunc),
            "fract" => self.sub(&self.step(f64::trunc)),
            _ => return None,
        })
    }
}
