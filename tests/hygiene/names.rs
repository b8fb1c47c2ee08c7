//! The user's own names are those that generated code would like to use.

use integrator_core::prelude::*;

/// A type as generated code calls what it prepares.
#[derive(Clone, Copy)]
pub struct Parameters {
    /// A parameter.
    pub step: f64,
}

/// A type as generated code calls what it computes in.
pub struct Scalar;
/// A type as generated code calls how coordinates are kept.
pub struct Leaf;
/// A type as generated code calls a composition written in place.
pub struct InPlace;
/// A type as the runtime calls a layout.
pub struct Plain(pub Parameters);
/// A trait as the runtime calls what is computed in.
pub trait Real {}
/// A trait as the runtime calls how a coordinate is kept.
pub trait Slot {
    /// A method as a slot has it.
    fn value(&self) -> f64;
    /// Another one.
    fn fma(&mut self, a: f64, b: f64);
}

impl Slot for f64 {
    fn value(&self) -> f64 {
        unreachable!("the user's method")
    }
    fn fma(&mut self, _: f64, _: f64) {
        unreachable!("the user's method")
    }
}

/// A module as generated code calls the runtime.
pub mod runtime {
    /// A constant in it.
    pub const HALF: f64 = 0.5;

    pub use integrator_core::BlanesMoan4 as Inner;
}

/// Constants as type parameters might be called.
pub const R: f64 = 2.0;
/// Another one.
pub const K: f64 = 3.0;
/// A function as generated code calls a local variable.
pub fn step() -> f64 {
    4.0
}

impl Parameters {
    /// A constant of the type.
    pub const WEIGHT: f64 = 0.25;
}

#[hamiltonian(compose = T(1/2) V(1) T(1/2))]
impl Parameters {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        runtime::HALF * p[0] * p[0] / R
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        let motion = self.step;
        let duration = K * motion;
        duration * q[0] * q[0] * Self::WEIGHT
    }
}

#[hamiltonian(compose = T(1/2) V(1) T(1/2))]
impl Scalar {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        let motion = Parameters::WEIGHT;
        2.0 * q[0] * q[0] * motion
    }
}

#[hamiltonian]
impl Plain {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        let mut v = 0.0;
        for lane in 0..1 {
            v += self.0.step * q[lane] * q[lane] / 2.0;
        }
        v
    }
}

/// A system whose inner composition is in that module.
pub struct Nested;

#[hamiltonian(split = well + 2 * runtime::Inner(spring + kinetic))]
impl Nested {
    fn well(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 4.0
    }
    fn spring(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 4.0
    }
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
}

/// Compositions of the user.
pub mod compositions {
    use integrator_core::composition;

    composition! {
        /// A composition whose name is that of one written in place.
        pub struct InPlace: order 1 = V(1) T(1);
    }
}

/// Where a composition is called as one written in place.
pub mod leaf {
    use super::compositions::InPlace;
    use integrator_core::prelude::*;

    /// A system whose composition is called as one written in place.
    pub struct System;

    #[hamiltonian(compose = InPlace)]
    impl System {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0] / 2.0
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            q[0] * q[0] / 2.0
        }
    }
}

/// The frequency of `q'' = -ω² q` shows that every name meant what the user meant.
fn assert_frequency<H: Hamiltonian<Coords = [f64; 1]>>(system: &H, squared: f64) {
    let mut run = system.run(Phase::new([1.0], [0.0]), 1e-4).expect("an admissible start");
    run.advance(10_000).expect("finite");
    // A first-order composition errs by about half a step.
    assert!((run.state().q[0] - squared.sqrt().cos()).abs() < 1e-3, "{run:?}");
}

#[test]
fn every_name_means_what_the_user_meant() {
    assert_frequency(&Parameters { step: 4.0 }, 4.0 * K * 2.0 * Parameters::WEIGHT / R);
    assert_frequency(&Scalar, 1.0);
    assert_frequency(&leaf::System, 1.0);
    assert_frequency(&Nested, 1.0);
    assert_frequency(&Plain(Parameters { step: 2.0 }), 2.0);
    let _ = (InPlace, Leaf);
    assert_eq!(step(), 4.0);
}
