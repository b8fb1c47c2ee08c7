//! Hamiltonians that are split into other parts than `T(p)` and `V(q)`, written by hand, right ones and wrong ones.

use integrator_core::{__private::*, Phase, Verlet};

/// What is wrong with a flow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Fault {
    None,
    /// The oscillator shrinks a little, in positions and momenta.
    Damped,
    /// The oscillator turns too fast, on the right ellipses.
    Faster,
    /// The oscillator turns too fast by this much of itself.
    FasterBy(f64),
    /// The oscillator turns by twice the angle whose tangent is half of the right one, as the Boris rotation does.
    HalfAngle,
    /// The oscillator turns a little farther, forwards and backwards.
    Late,
    /// The oscillator goes on circles where these are ellipses.
    Unscaled,
    /// The kick is a millionth too strong.
    Stronger,
    /// The kick is too strong by this much of itself.
    StrongerBy(f64),
    /// The oscillator leads nowhere.
    Undefined,
    /// The force in the field of H is a thousandth too strong, so that it is that of another H.
    FieldOfAnother,
    /// The field of H has a friction, so that it is that of none.
    FieldOfNone,
}

/// `H = (p²/m + m ω² q²)/2 + q⁴/4`, an oscillator and the rest.
#[derive(Clone)]
pub(crate) struct Anharmonic {
    pub(crate) mass: f64,
    pub(crate) frequency: f64,
    pub(crate) fault: Fault,
}

impl Anharmonic {
    /// The angle by which the oscillator turns.
    fn angle(&self, duration: f64) -> f64 {
        let angle = self.frequency * duration;
        match self.fault {
            Fault::Faster => 1.000_001 * angle,
            Fault::FasterBy(part) => angle + part * angle,
            Fault::HalfAngle => 2.0 * (angle / 2.0).atan(),
            Fault::Late => angle + 1e-6 * angle * angle,
            Fault::Undefined => f64::NAN,
            _ => angle,
        }
    }

    fn oscillator<R: Real>(&self, q: R, p: R) -> R {
        let Self { mass, frequency, .. } = self;
        R::of(0.5) * (p * p / R::of(*mass) + R::of(mass * frequency * frequency) * q * q)
    }
}

/// Writes what the systems have in common.
macro_rules! parts_by_hand {
    ($name:ident: [f64; $n:literal], $($part:literal)+; $($items:item)*) => {
        impl<R: Real> Prepared<R> for $name {
            type Single = Self;
            fn gather(members: &[&Self]) -> Self {
                members[0].clone()
            }
        }

        impl Hamiltonian for $name {
            type Compose = Verlet;
        }

        impl ParameterDerivatives for $name {}

        impl System for $name {
            type Coords = [f64; $n];
            type Parameters<R: Real> = Self;
            type Motion<R: Real, K: Precision> = Plain<R, Shaped<Self, K>, Self>;
            const PARTS: &'static [&'static str] = &[$($part),+];
            const SEPARABLE: bool = false;
            const AUTONOMOUS: bool = true;

            fn parameters(&self, _length: usize) -> Self {
                self.clone()
            }
            fn stated(&self, q: &Self::Coords, p: &Self::Coords, time: f64) -> StatedEnergy {
                let state = Phase::new(*q, *p);
                let motion = Self::Motion::<f64, f64>::load(&[self], &[&state]);
                let kinetic = Self::kinetic::<f64, f64>(&motion, time);
                StatedEnergy::Separate { kinetic, potential: Self::potential::<f64, f64>(&motion, time) }
            }
            $($items)*
        }
    };
}

parts_by_hand! {
    Anharmonic: [f64; 1], "oscillator" "rest";

    fn drift<R: Real, K: Precision>(m: &mut Self::Motion<R, K>, d: f64, _t: f64) {
        let Self { mass, frequency, fault } = m.parameters;
        let (sine, cosine) = m.parameters.angle(d).sin_cos();
        let scale = if fault == Fault::Unscaled { mass } else { mass * frequency };
        let loss = if fault == Fault::Damped { (-1e-6 * d).exp() } else { 1.0 };
        let (q, p) = (m.q[0].value(), m.p[0].value());
        let (to_q, to_p) = (R::of(cosine) * q + R::of(sine / scale) * p, R::of(cosine) * p - R::of(sine * scale) * q);
        m.q[0].fma(R::of(1.0), R::of(loss) * to_q - q);
        m.p[0].fma(R::of(1.0), R::of(loss) * to_p - p);
    }
    fn kick<R: Real, K: Precision>(m: &mut Self::Motion<R, K>, d: f64, _t: f64) {
        let strength = match m.parameters.fault {
            Fault::Stronger => 1.000_001,
            Fault::StrongerBy(part) => 1.0 + part,
            _ => 1.0,
        };
        let q = m.q[0].value();
        m.p[0].fma(R::of(-strength * d), q * q * q);
    }
    fn along_field<R: Real, K: Precision>(at: ReadBy<'_, Self, R, K>, to: MovedBy<'_, Self, R, K>, d: f64, _t: f64) {
        let Self { mass, frequency, fault } = *at.parameters;
        let strength = if fault == Fault::FieldOfAnother { 1.001 } else { 1.0 };
        let friction = if fault == Fault::FieldOfNone { 1e-3 } else { 0.0 };
        let (q, p) = (at.q[0].value(), at.p[0].value());
        to.q[0].fma(R::of(d / mass), p);
        to.p[0].fma(R::of(-strength * d), R::of(mass * frequency * frequency) * q + q * q * q);
        to.p[0].fma(R::of(-friction * d), p);
    }
    fn kinetic<R: Real, K: Precision>(m: &Self::Motion<R, K>, _t: f64) -> R {
        m.parameters.oscillator(m.q[0].value(), m.p[0].value())
    }
    fn potential<R: Real, K: Precision>(m: &Self::Motion<R, K>, _t: f64) -> R {
        let q = m.q[0].value();
        R::of(0.25) * q * q * q * q
    }
}

/// `H = |p|²/2 + Ω (x p_y - y p_x) + 1/(1 + |q|²)` in three parts. The turn goes at another `rate` than is `stated`.
#[derive(Clone)]
pub(crate) struct Turning {
    pub(crate) rate: f64,
    pub(crate) stated: f64,
}

parts_by_hand! {
    Turning: [f64; 2], "motion" "turn" "hill";

    fn drift<R: Real, K: Precision>(m: &mut Self::Motion<R, K>, d: f64, _t: f64) {
        m.q[0].fma(R::of(d), m.p[0].value());
        m.q[1].fma(R::of(d), m.p[1].value());
    }
    fn middle<R: Real, K: Precision>(m: &mut Self::Motion<R, K>, d: f64, _t: f64, _backwards: bool) {
        let (sine, cosine) = (m.parameters.rate * d).sin_cos();
        for [x, y] in [&mut m.q, &mut m.p] {
            let (before, beside) = (x.value(), y.value());
            x.fma(R::of(1.0), R::of(cosine) * before - R::of(sine) * beside - before);
            y.fma(R::of(1.0), R::of(cosine) * beside + R::of(sine) * before - beside);
        }
    }
    fn kick<R: Real, K: Precision>(m: &mut Self::Motion<R, K>, d: f64, _t: f64) {
        let (x, y) = (m.q[0].value(), m.q[1].value());
        let hill = R::of(1.0) + x * x + y * y;
        let push = R::of(2.0 * d) / (hill * hill);
        m.p[0].fma(push, x);
        m.p[1].fma(push, y);
    }
    fn kinetic<R: Real, K: Precision>(m: &Self::Motion<R, K>, _t: f64) -> R {
        R::of(0.5) * (m.p[0].value() * m.p[0].value() + m.p[1].value() * m.p[1].value())
    }
    fn potential<R: Real, K: Precision>(m: &Self::Motion<R, K>, _t: f64) -> R {
        let ([x, y], [px, py]) = ([0, 1].map(|i| m.q[i].value()), [0, 1].map(|i| m.p[i].value()));
        R::of(m.parameters.stated) * (x * py - y * px) + R::of(1.0) / (R::of(1.0) + x * x + y * y)
    }
}
