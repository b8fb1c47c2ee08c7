//! Hamiltonians written by hand, right ones and wrong ones, in the plainest layout.

use integrator_core::{__private::*, Phase, Verlet};

/// Writes what all hand-written systems have in common. Parameters are the system itself; a motion `m` keeps its slots
/// `m.q` and `m.p` in the user's own shape; a flow is applied for a time `d` and reads the time `t`.
macro_rules! by_hand {
    (
        $(#[$attribute:meta])*
        $name:ident { $($parameter:ident),* }: [f64; $n:literal], autonomous = $autonomous:literal;
        drift($dm:ident, $dd:ident, $dt:ident) $drift:block
        kick($km:ident, $kd:ident, $kt:ident) $kick:block
        kinetic($tm:ident, $tt:ident) $kinetic:block
        potential($vm:ident, $vt:ident) $potential:block
        $(stated_potential($sq:ident) $stated:block)?
        $(stated_whole($wq:ident, $wp:ident) $whole:block)?
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Default)]
        pub(crate) struct $name { $(pub(crate) $parameter: f64),* }

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
            const AUTONOMOUS: bool = $autonomous;

            fn parameters(&self, _length: usize) -> Self {
                self.clone()
            }
            fn drift<R: Real, K: Precision>($dm: &mut Self::Motion<R, K>, $dd: f64, $dt: f64) $drift
            fn kick<R: Real, K: Precision>($km: &mut Self::Motion<R, K>, $kd: f64, $kt: f64) $kick
            fn kinetic<R: Real, K: Precision>($tm: &Self::Motion<R, K>, $tt: f64) -> R $kinetic
            fn potential<R: Real, K: Precision>($vm: &Self::Motion<R, K>, $vt: f64) -> R $potential
            fn stated(&self, q: &Self::Coords, p: &Self::Coords, time: f64) -> StatedEnergy {
                let kinetic = Self::kinetic::<f64, f64>(&at(self, p), time);
                let potential = Self::potential::<f64, f64>(&at(self, q), time);
                $(let $sq = q; let potential = { let _ = potential; $stated };)?
                $(let ($wq, $wp) = (q, p); return { let _ = (kinetic, potential); StatedEnergy::Whole($whole) };)?
                #[allow(unreachable_code, reason = "behind the one that states all of H")]
                StatedEnergy::Separate { kinetic, potential }
            }
        }
    };
}

/// A motion whose positions and momenta are the same.
fn at<H: Hamiltonian<Parameters<f64> = H>>(system: &H, coordinates: &H::Coords) -> H::Motion<f64, f64> {
    let state = Phase::new(coordinates.clone(), coordinates.clone());
    H::Motion::load(&[system], &[&state])
}

by_hand! {
    /// `T = p²/(2 m l²)`, `V = -m g l cos q`.
    Pendulum { mass, length, gravity }: [f64; 1], autonomous = true;
    drift(m, d, _t) {
        let inertia = m.parameters.mass * m.parameters.length.powi(2);
        m.q[0].fma(R::of(d / inertia), m.p[0].value());
    }
    kick(m, d, _t) {
        let torque = m.parameters.mass * m.parameters.gravity * m.parameters.length;
        m.p[0].fma(R::of(-d * torque), m.q[0].value().sin());
    }
    kinetic(m, _t) {
        let inertia = m.parameters.mass * m.parameters.length.powi(2);
        m.p[0].value() * m.p[0].value() / R::of(2.0 * inertia)
    }
    potential(m, _t) {
        let torque = m.parameters.mass * m.parameters.gravity * m.parameters.length;
        -(R::of(torque) * m.q[0].value().cos())
    }
}

by_hand! {
    /// `T = |p|²/2`, `V = |q|²/2 + x²y - y³/3`.
    HenonHeiles {}: [f64; 2], autonomous = true;
    drift(m, d, _t) {
        m.q[0].fma(R::of(d), m.p[0].value());
        m.q[1].fma(R::of(d), m.p[1].value());
    }
    kick(m, d, _t) {
        let (x, y) = (m.q[0].value(), m.q[1].value());
        m.p[0].fma(R::of(-d), x + R::of(2.0) * x * y);
        m.p[1].fma(R::of(-d), y + x * x - y * y);
    }
    kinetic(m, _t) { R::of(0.5) * (m.p[0].value() * m.p[0].value() + m.p[1].value() * m.p[1].value()) }
    potential(m, _t) {
        let (x, y) = (m.q[0].value(), m.q[1].value());
        R::of(0.5) * (x * x + y * y) + x * x * y - y * y * y / R::of(3.0)
    }
}

by_hand! {
    /// `T = |p|²/(2 m)`, `V = -k/|q|`.
    Kepler { mass, attraction }: [f64; 2], autonomous = true;
    drift(m, d, _t) {
        let s = R::of(d / m.parameters.mass);
        m.q[0].fma(s, m.p[0].value());
        m.q[1].fma(s, m.p[1].value());
    }
    kick(m, d, _t) {
        let (x, y) = (m.q[0].value(), m.q[1].value());
        let squared = x * x + y * y;
        let s = R::of(-d * m.parameters.attraction) / (squared * squared.sqrt());
        m.p[0].fma(s, x);
        m.p[1].fma(s, y);
    }
    kinetic(m, _t) {
        (m.p[0].value() * m.p[0].value() + m.p[1].value() * m.p[1].value()) / R::of(2.0 * m.parameters.mass)
    }
    potential(m, _t) { -(R::of(m.parameters.attraction) / m.q[0].value().hypot(m.q[1].value())) }
}

by_hand! {
    /// `T = sqrt(1 + p²)`, `V = q⁴/4`.
    Relativistic {}: [f64; 1], autonomous = true;
    drift(m, d, _t) {
        let p = m.p[0].value();
        m.q[0].fma(R::of(d), p / (R::of(1.0) + p * p).sqrt());
    }
    kick(m, d, _t) {
        let q = m.q[0].value();
        m.p[0].fma(R::of(-d), q * q * q);
    }
    kinetic(m, _t) { (R::of(1.0) + m.p[0].value() * m.p[0].value()).sqrt() }
    potential(m, _t) { R::of(0.25) * m.q[0].value().powf(R::of(4.0)) }
}

by_hand! {
    /// `T = p₀² + p₀ p₁ + p₁²`, `V = cosh q₀ - cos q₁ + q₀ q₁/4`.
    Skewed {}: [f64; 2], autonomous = true;
    drift(m, d, _t) {
        let (a, b) = (m.p[0].value(), m.p[1].value());
        m.q[0].fma(R::of(d), a + a + b);
        m.q[1].fma(R::of(d), a + b + b);
    }
    kick(m, d, _t) {
        let (a, b) = (m.q[0].value(), m.q[1].value());
        m.p[0].fma(R::of(-d), a.sinh() + R::of(0.25) * b);
        m.p[1].fma(R::of(-d), b.sin() + R::of(0.25) * a);
    }
    kinetic(m, _t) {
        let (a, b) = (m.p[0].value(), m.p[1].value());
        a * a + a * b + b * b
    }
    potential(m, _t) {
        let (a, b) = (m.q[0].value(), m.q[1].value());
        a.cosh() - b.cos() + R::of(0.25) * a * b
    }
}

by_hand! {
    /// `T = p²/2 (1 + sin(t)/4)`, `V = -cos q - q cos(2t)/2`.
    Driven {}: [f64; 1], autonomous = false;
    drift(m, d, t) { m.q[0].fma(R::of(d * (1.0 + 0.25 * t.sin())), m.p[0].value()); }
    kick(m, d, t) { m.p[0].fma(R::of(-d), m.q[0].value().sin() - R::of(0.5 * (2.0 * t).cos())); }
    kinetic(m, t) { R::of(0.5 * (1.0 + 0.25 * t.sin())) * m.p[0].value() * m.p[0].value() }
    potential(m, t) { -(m.q[0].value().cos() + R::of(0.5 * (2.0 * t).cos()) * m.q[0].value()) }
}

by_hand! {
    /// WRONG: explicit Euler. The drift of `kick, drift` goes with the momentum from before the kick.
    Explicit {}: [f64; 1], autonomous = true;
    drift(m, d, _t) {
        let before = m.p[0].value() + R::of(d) * m.q[0].value().sin();
        m.q[0].fma(R::of(d), before);
    }
    kick(m, d, _t) { m.p[0].fma(R::of(-d), m.q[0].value().sin()); }
    kinetic(m, _t) { R::of(0.5) * m.p[0].value() * m.p[0].value() }
    potential(m, _t) { -m.q[0].value().cos() }
}

by_hand! {
    /// WRONG: the kick goes up the potential. This is another Hamiltonian, and its flows are as symplectic as any.
    Repelled {}: [f64; 1], autonomous = true;
    drift(m, d, _t) { m.q[0].fma(R::of(d), m.p[0].value()); }
    kick(m, d, _t) { m.p[0].fma(R::of(d), m.q[0].value().sin()); }
    kinetic(m, _t) { R::of(0.5) * m.p[0].value() * m.p[0].value() }
    potential(m, _t) { -m.q[0].value().cos() }
}

by_hand! {
    /// WRONG: Hénon–Heiles with `xy` for `2xy` in the first component of the gradient.
    Miscounted {}: [f64; 2], autonomous = true;
    drift(m, d, _t) {
        m.q[0].fma(R::of(d), m.p[0].value());
        m.q[1].fma(R::of(d), m.p[1].value());
    }
    kick(m, d, _t) {
        let (x, y) = (m.q[0].value(), m.q[1].value());
        m.p[0].fma(R::of(-d), x + x * y);
        m.p[1].fma(R::of(-d), y + x * x - y * y);
    }
    kinetic(m, _t) { R::of(0.5) * (m.p[0].value() * m.p[0].value() + m.p[1].value() * m.p[1].value()) }
    potential(m, _t) {
        let (x, y) = (m.q[0].value(), m.q[1].value());
        R::of(0.5) * (x * x + y * y) + x * x * y - y * y * y / R::of(3.0)
    }
}

by_hand! {
    /// WRONG: the kick of a driven pendulum reads the time twice as fast as it runs.
    Hurried {}: [f64; 1], autonomous = false;
    drift(m, d, _t) { m.q[0].fma(R::of(d), m.p[0].value()); }
    kick(m, d, t) { m.p[0].fma(R::of(-d), m.q[0].value().sin() - R::of(0.5 * (2.0 * t).cos())); }
    kinetic(m, _t) { R::of(0.5) * m.p[0].value() * m.p[0].value() }
    potential(m, t) { -(m.q[0].value().cos() + R::of(0.5 * t.cos()) * m.q[0].value()) }
}

by_hand! {
    /// WRONG: friction. The kick takes a little of the momentum away.
    Braked {}: [f64; 1], autonomous = true;
    drift(m, d, _t) { m.q[0].fma(R::of(d), m.p[0].value()); }
    kick(m, d, _t) {
        let p = m.p[0].value();
        m.p[0].fma(R::of(-d), m.q[0].value().sin() + R::of(1e-3) * p);
    }
    kinetic(m, _t) { R::of(0.5) * m.p[0].value() * m.p[0].value() }
    potential(m, _t) { -m.q[0].value().cos() }
}

by_hand! {
    /// WRONG: `q.iter().fold(0.0, |s, x| s * s + x * x)`, read as a sum by energy and forces alike.
    Misread {}: [f64; 2], autonomous = true;
    drift(m, d, _t) {
        m.q[0].fma(R::of(d), m.p[0].value());
        m.q[1].fma(R::of(d), m.p[1].value());
    }
    kick(m, d, _t) {
        m.p[0].fma(R::of(-2.0 * d), m.q[0].value());
        m.p[1].fma(R::of(-2.0 * d), m.q[1].value());
    }
    kinetic(m, _t) { R::of(0.5) * (m.p[0].value() * m.p[0].value() + m.p[1].value() * m.p[1].value()) }
    potential(m, _t) { m.q[0].value() * m.q[0].value() + m.q[1].value() * m.q[1].value() }
    stated_potential(q) { q.iter().fold(0.0, |s, x| s * s + x * x) }
}

by_hand! {
    /// WRONG: a Hamiltonian in one function, `p²/2 + q² + 1`, whose one is lost.
    MisreadWhole {}: [f64; 1], autonomous = true;
    drift(m, d, _t) { m.q[0].fma(R::of(d), m.p[0].value()); }
    kick(m, d, _t) { m.p[0].fma(R::of(-2.0 * d), m.q[0].value()); }
    kinetic(m, _t) { R::of(0.5) * m.p[0].value() * m.p[0].value() }
    potential(m, _t) { m.q[0].value() * m.q[0].value() }
    stated_whole(q, p) { 0.5 * p[0] * p[0] + q[0] * q[0] + 1.0 }
}

by_hand! {
    /// WRONG: not a number as soon as the pendulum leans to the left.
    Undefined {}: [f64; 1], autonomous = true;
    drift(m, d, _t) { m.q[0].fma(R::of(d), m.p[0].value()); }
    kick(m, d, _t) { m.p[0].fma(R::of(-d), m.q[0].value().sqrt()); }
    kinetic(m, _t) { R::of(0.5) * m.p[0].value() * m.p[0].value() }
    potential(m, _t) { R::of(2.0 / 3.0) * m.q[0].value().powf(R::of(1.5)) }
}

by_hand! {
    /// WRONG: `V = |q|` has no gradient at the origin.
    Kinked {}: [f64; 1], autonomous = true;
    drift(m, d, _t) { m.q[0].fma(R::of(d), m.p[0].value()); }
    kick(m, d, _t) { m.p[0].fma(R::of(-d), m.q[0].value().signum()); }
    kinetic(m, _t) { R::of(0.5) * m.p[0].value() * m.p[0].value() }
    potential(m, _t) { m.q[0].value().abs() }
}

/// Writes the second derivatives of a system with unit masses: the Hessian of `V` times momenta, at positions.
macro_rules! quadratic_by_hand {
    ($(#[$attribute:meta])* $name:ident, hessian($q:ident, $u:ident) $hessian:block) => {
        $(#[$attribute])*
        impl QuadraticKinetic for $name {
            fn hessian<R: Real>(motion: &mut Self::Motion<R, f64>, _time: f64) {
                let ($q, $u) = (motion.q, motion.p);
                motion.p = $hessian;
            }
            fn gradient_kick<R: Real, K: Precision>(
                motion: &mut Self::Motion<R, K>,
                duration: f64,
                gradient: f64,
                time: f64,
            ) {
                let mut bent = motion.at_rest();
                Self::kick::<R, f64>(&mut bent, -1.0, time);
                Self::hessian::<R>(&mut bent, time);
                Self::kick::<R, K>(motion, duration, time);
                motion.push(R::of(-2.0 * gradient), &bent);
            }
        }
    };
}

quadratic_by_hand! {
    HenonHeiles, hessian(q, u) {
        let ([x, y], [a, b], one, two) = (q, u, R::of(1.0), R::of(2.0));
        [(one + two * y) * a + two * x * b, two * x * a + (one - two * y) * b]
    }
}

quadratic_by_hand! {
    /// That of the right gradient.
    Miscounted, hessian(q, u) {
        let ([x, y], [a, b], one, two) = (q, u, R::of(1.0), R::of(2.0));
        [(one + two * y) * a + two * x * b, two * x * a + (one - two * y) * b]
    }
}

by_hand! {
    /// `T = |p|²/2`, `V = |q|²/2 + x²y - y³/3`, once more.
    Bent {}: [f64; 2], autonomous = true;
    drift(m, d, _t) {
        m.q[0].fma(R::of(d), m.p[0].value());
        m.q[1].fma(R::of(d), m.p[1].value());
    }
    kick(m, d, _t) {
        let (x, y) = (m.q[0].value(), m.q[1].value());
        m.p[0].fma(R::of(-d), x + R::of(2.0) * x * y);
        m.p[1].fma(R::of(-d), y + x * x - y * y);
    }
    kinetic(m, _t) { R::of(0.5) * (m.p[0].value() * m.p[0].value() + m.p[1].value() * m.p[1].value()) }
    potential(m, _t) {
        let (x, y) = (m.q[0].value(), m.q[1].value());
        R::of(0.5) * (x * x + y * y) + x * x * y - y * y * y / R::of(3.0)
    }
}

quadratic_by_hand! {
    /// WRONG: the mixed derivative has lost its factor 2.
    Bent, hessian(q, u) {
        let ([x, y], [a, b], one, two) = (q, u, R::of(1.0), R::of(2.0));
        [(one + two * y) * a + x * b, x * a + (one - two * y) * b]
    }
}

/// Magnets of a ring that focus and defocus in turns, a quarter of a cell each, from the formula that users write.
pub(crate) struct Ring {
    pub(crate) cell: f64,
}

#[integrator_core::hamiltonian]
impl Ring {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        let place = t % self.cell;
        let strength = if place < 0.25 * self.cell {
            2.0
        } else if place >= 0.5 * self.cell && place < 0.75 * self.cell {
            -2.0
        } else {
            0.0
        };
        strength * q[0] * q[0] / 2.0 + 0.1 * q[0].powi(4)
    }
}

by_hand! {
    /// WRONG for a composition of order 2 and above: `V = q²/2 + k |q - a|` has no second derivative at `a`, and
    /// `j θ(q - a)` jumps there, of which the force knows nothing.
    Rough { kink, jump, at }: [f64; 1], autonomous = true;
    drift(m, d, _t) { m.q[0].fma(R::of(d), m.p[0].value()); }
    kick(m, d, _t) {
        let (q, kink) = (m.q[0].value(), R::of(m.parameters.kink));
        m.p[0].fma(R::of(-d), q + kink * (q - R::of(m.parameters.at)).signum());
    }
    kinetic(m, _t) { R::of(0.5) * m.p[0].value() * m.p[0].value() }
    potential(m, _t) {
        let q = m.q[0].value();
        let beyond = q - R::of(m.parameters.at);
        let jump = R::of(0.5 * m.parameters.jump) * (R::of(1.0) + beyond.signum());
        R::of(0.5) * q * q + R::of(m.parameters.kink) * beyond.abs() + jump
    }
}

by_hand! {
    /// `T = p²/(2 t²)`, `V = -t cos q`: a motion from some time on. At time 0 there is none.
    Expanding {}: [f64; 1], autonomous = false;
    drift(m, d, t) { m.q[0].fma(R::of(d / (t * t)), m.p[0].value()); }
    kick(m, d, t) { m.p[0].fma(R::of(-d * t), m.q[0].value().sin()); }
    kinetic(m, t) { R::of(0.5 / (t * t)) * m.p[0].value() * m.p[0].value() }
    potential(m, t) { -(R::of(t) * m.q[0].value().cos()) }
}
