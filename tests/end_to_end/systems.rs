//! The systems that tests integrate, each with its equations of motion by hand.

use integrator_core::prelude::*;

pub(crate) struct Pendulum {
    pub(crate) mass: f64,
    pub(crate) length: f64,
    pub(crate) gravity: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl Pendulum {
    pub(crate) fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.mass * self.length.powi(2))
    }
    pub(crate) fn potential(&self, q: [f64; 1]) -> f64 {
        -self.mass * self.gravity * self.length * q[0].cos()
    }
}

/// The galactic potential of Hénon and Heiles.
pub(crate) struct HenonHeiles;

#[hamiltonian]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

pub(crate) struct Kepler {
    pub(crate) mu: f64,
}

#[hamiltonian]
impl Kepler {
    fn kinetic(&self, p: &[f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: &[f64; 2]) -> f64 {
        -self.mu / (q[0].powi(2) + q[1] * q[1]).sqrt()
    }
}

/// A relativistic particle in a quartic well: `T` is not quadratic.
pub(crate) struct Relativistic {
    pub(crate) stiffness: f64,
}

#[hamiltonian]
impl Relativistic {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        (1.0 + p[0] * p[0]).sqrt()
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.stiffness * q[0].powi(4) / 4.0 + q[0].sin()
    }
}

/// Two angles whose momenta are coupled by the mass matrix, as in a double pendulum that is linearised in `T` alone.
pub(crate) struct Coupled {
    pub(crate) coupling: f64,
}

#[hamiltonian]
impl Coupled {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        p[0] * p[0] / 2.0 + p[1] * p[1] + self.coupling * p[0] * p[1]
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -2.0 * q[0].cos() - (q[1] - q[0]).cos()
    }
}

/// A chain of nonlinear springs between walls, with loops and a helper method.
pub(crate) struct Chain {
    pub(crate) alpha: f64,
    pub(crate) mass: [f64; 8],
}

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64; 8]) -> f64 {
        let mut sum = 0.0;
        for i in 0..8 {
            sum += p[i] * p[i] / (2.0 * self.mass[i]);
        }
        sum
    }
    fn potential(&self, q: &[f64; 8]) -> f64 {
        let mut sum = self.spring(q[0]) + self.spring(-q[7]);
        for i in 0..7 {
            sum += self.spring(q[i + 1] - q[i]);
        }
        sum
    }
    fn spring(&self, stretch: f64) -> f64 {
        stretch * stretch / 2.0 + self.alpha * stretch.powi(3) / 3.0 + stretch.powi(4) / 4.0
    }
}

/// Positions and momenta.
pub(crate) type State<const N: usize> = ([f64; N], [f64; N]);

/// A system, where it starts, and how it moves.
pub(crate) struct Problem<H, const N: usize> {
    pub(crate) name: &'static str,
    pub(crate) system: H,
    pub(crate) start: State<N>,
    /// `dq/dt` and `dp/dt`, differentiated by hand.
    pub(crate) motion: fn([f64; N], [f64; N]) -> State<N>,
}

pub(crate) fn pendulum() -> Problem<Pendulum, 1> {
    Problem {
        name: "pendulum",
        system: Pendulum { mass: 1.7, length: 0.6, gravity: 9.81 },
        start: ([2.0], [0.3]),
        motion: |[q], [p]| ([p / (1.7 * 0.36)], [-1.7 * 9.81 * 0.6 * q.sin()]),
    }
}

pub(crate) fn henon_heiles() -> Problem<HenonHeiles, 2> {
    Problem {
        name: "Hénon-Heiles",
        system: HenonHeiles,
        start: ([0.3, -0.2], [0.1, 0.35]),
        motion: |[x, y], p| (p, [-x - 2.0 * x * y, -y - x * x + y * y]),
    }
}

/// Eccentricity 0.6, from the pericentre.
pub(crate) fn kepler() -> Problem<Kepler, 2> {
    Problem {
        name: "Kepler",
        system: Kepler { mu: 1.0 },
        start: ([0.4, 0.0], [0.0, 2.0]),
        motion: |[x, y], p| {
            let cubed = x.hypot(y).powi(3);
            (p, [-x / cubed, -y / cubed])
        },
    }
}

pub(crate) fn relativistic() -> Problem<Relativistic, 1> {
    Problem {
        name: "relativistic",
        system: Relativistic { stiffness: 3.0 },
        start: ([0.8], [-1.1]),
        motion: |[q], [p]| ([p / (1.0 + p * p).sqrt()], [-3.0 * q.powi(3) - q.cos()]),
    }
}

pub(crate) fn coupled() -> Problem<Coupled, 2> {
    Problem {
        name: "coupled",
        system: Coupled { coupling: -0.8 },
        start: ([0.7, -0.4], [0.5, 0.6]),
        motion: |[a, b], [pa, pb]| {
            let pull = (b - a).sin();
            ([pa - 0.8 * pb, 2.0 * pb - 0.8 * pa], [pull - 2.0 * a.sin(), -pull])
        },
    }
}

impl<H, const N: usize> Problem<H, N> {
    /// The states at the [`LOOKS`] times `span`, `2·span`, ..., by the classical Runge-Kutta method with the hand-written derivatives.
    ///
    /// It shares nothing with what it is compared to. A step of 5e-5 leaves errors of the order of 1e-17, fourth powers
    /// of it, and sums are compensated.
    pub(crate) fn reference(&self, span: f64) -> [State<N>; LOOKS] {
        let steps = (span / 5e-5).ceil();
        let h = span / steps;
        let (mut q, mut p) = self.start;
        let (mut carried_q, mut carried_p) = ([0.0; N], [0.0; N]);
        let moved = |from: [f64; N], by: [f64; N], duration: f64| std::array::from_fn(|i| from[i] + duration * by[i]);
        std::array::from_fn(|_| {
            for _ in 0..steps as u64 {
                let (q1, p1) = (self.motion)(q, p);
                let (q2, p2) = (self.motion)(moved(q, q1, h / 2.0), moved(p, p1, h / 2.0));
                let (q3, p3) = (self.motion)(moved(q, q2, h / 2.0), moved(p, p2, h / 2.0));
                let (q4, p4) = (self.motion)(moved(q, q3, h), moved(p, p3, h));
                for i in 0..N {
                    add(&mut q[i], &mut carried_q[i], h / 6.0 * (q1[i] + 2.0 * (q2[i] + q3[i]) + q4[i]));
                    add(&mut p[i], &mut carried_p[i], h / 6.0 * (p1[i] + 2.0 * (p2[i] + p3[i]) + p4[i]));
                }
            }
            (q, p)
        })
    }
}

/// A compensated addition.
fn add(sum: &mut f64, carried: &mut f64, addend: f64) {
    let addend = addend + *carried;
    let before = *sum;
    *sum += addend;
    *carried = addend - (*sum - before);
}

/// At how many times a run is held against its exact states. At a single one the leading term of an error may vanish.
pub(crate) const LOOKS: usize = 4;

/// The largest distance of a run from the exact states, seen every `steps` steps.
pub(crate) fn error<const N: usize>(run: Run<[Compensated<f64>; N]>, steps: u64, exact: &[State<N>; LOOKS]) -> f64 {
    let mut largest = 0.0_f64;
    for (sample, (q, p)) in run.samples(steps).skip(1).zip(exact) {
        let Ok(Sample { state, .. }) = sample else { return f64::INFINITY };
        for (found, expected) in state.q.iter().zip(q).chain(state.p.iter().zip(p)) {
            largest = largest.max((found.value - expected).abs());
        }
    }
    largest
}
