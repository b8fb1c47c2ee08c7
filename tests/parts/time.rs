//! More than two parts that read the time: each flow reads it where the composition has come to.

use crate::many_parts::{TIME, classical, slope_of};
use integrator_core::{__private::Scheme, Composition, Hamiltonian, Phase, prelude::*};

/// Parts that all read the time, split in one way or another.
macro_rules! driven {
    ($name:ident: $($split:tt)*) => {
        struct $name;

        #[hamiltonian(split = $($split)*)]
        impl $name {
            fn motion(&self, p: [f64; 2], t: f64) -> f64 {
                (1.0 + 0.3 * t.sin()) * (p[0] * p[0] + p[1] * p[1]) / 2.0
            }
            fn twist(&self, q: [f64; 2], p: [f64; 2], t: f64) -> f64 {
                (2.0 * t).cos() * q[0] * q[0] * p[1] / 2.0
            }
            fn potential(&self, q: [f64; 2], t: f64) -> f64 {
                (q[0] - t).cos() + q[0] * q[0] * q[1] + q[1] * q[1] / 2.0
            }
        }
    };
}

driven!(Three: motion + twist + potential);
driven!(Paired: motion + (twist + potential));

/// The same H with inner steps within inner steps.
struct Nested;

#[hamiltonian(split = twist + 2 * Yoshida4(pull + 3 * BlanesMoan4(rest + motion)))]
impl Nested {
    fn twist(&self, q: [f64; 2], p: [f64; 2], t: f64) -> f64 {
        (2.0 * t).cos() * q[0] * q[0] * p[1] / 2.0
    }
    fn pull(&self, q: [f64; 2], t: f64) -> f64 {
        (q[0] - t).cos()
    }
    fn rest(&self, q: [f64; 2]) -> f64 {
        q[0] * q[0] * q[1] + q[1] * q[1] / 2.0
    }
    fn motion(&self, p: [f64; 2], t: f64) -> f64 {
        (1.0 + 0.3 * t.sin()) * (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
}

fn start() -> Phase<[f64; 2]> {
    Phase { q: [0.4, -0.3], p: [0.2, 0.5] }
}

fn numbers(Phase { q: [x, y], p: [u, v] }: Phase<[f64; 2]>) -> [f64; 4] {
    [x, y, u, v]
}

fn field([x, y, u, v]: [f64; 4], t: f64) -> [f64; 4] {
    let (mass, turn) = (1.0 + 0.3 * t.sin(), (2.0 * t).cos());
    [mass * u, mass * v + turn * x * x / 2.0, (x - t).sin() - 2.0 * x * y - turn * x * v, -x * x - y]
}

/// The order of the generated flows by the slope of their errors.
fn slope<H: Hamiltonian<Coords = [f64; 2]>, X: Composition<H>>(system: &H, composition: X) -> f64 {
    slope_of(X::NAME, classical(numbers(start()), field), |steps| {
        let mut run = system.run_with(composition, start(), TIME / f64::from(steps)).expect("a start");
        run.advance(u64::from(steps)).expect("finite");
        numbers(run.state())
    })
}

#[test]
fn parts_that_read_the_time_keep_the_order() {
    macro_rules! slopes {
        ($system:ident: $($composition:ident)*) => {$(
            let (found, order) = (slope(&$system, $composition), f64::from($composition::ORDER));
            let name = $composition::NAME;
            assert!(found > order - 0.4, "{name} on {} has order {found}, not {order}", stringify!($system));
        )*};
    }
    slopes!(Three: Euler EulerAdjoint Verlet VelocityVerlet Ruth3 Yoshida4 VelocityYoshida4 KahanLi8);
    slopes!(Paired: Euler Verlet Saba4 Abah864 Yoshida4 KahanLi8);
    slopes!(Nested: Euler Verlet Saba4 Abah864 Yoshida4);
}
