//! Methods as values of one type, so that the code of a system is compiled once for all of them.

use crate::{
    AdamsBashforth4, AdamsBashforthMoulton4, AdamsBashforthMoulton4Pec, Bdf, DormandPrince5, DormandPrince8,
    ExplicitMidpoint, ForwardEuler, GraggBulirschStoer, RungeKutta4, StaggeredLeapfrog,
    walk::{Place, Recipe},
};
use integrator_core::{__private::Real, Described, Error, Facts, Unsolved};

macro_rules! any {
    ($($method:ident)*) => {
        /// A method of this module as a value, chosen at run time.
        ///
        /// It includes all methods for arbitrary Hamiltonians, except the implicit ones. A list of such values compiles
        /// several times faster than the separate types. Runs are bitwise identical to those of the method itself.
        ///
        /// ```
        /// use integrator_core::prelude::*;
        /// use integrator_reference::{AnyReference, ForwardEuler, RungeKutta4};
        ///
        /// struct Oscillator;
        ///
        /// #[hamiltonian]
        /// impl Oscillator {
        ///     fn kinetic(&self, p: [f64; 1]) -> f64 {
        ///         0.5 * p[0] * p[0]
        ///     }
        ///     fn potential(&self, q: [f64; 1]) -> f64 {
        ///         0.5 * q[0] * q[0]
        ///     }
        /// }
        ///
        /// for method in [AnyReference::from(ForwardEuler), RungeKutta4.into()] {
        ///     let mut run = Oscillator.run_with(method, Phase::new([1.0], [0.0]), 0.1)?;
        ///     run.advance(100)?;
        ///     println!("{}", run.energy());
        /// }
        /// # Ok::<(), Error>(())
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum AnyReference {
            $(#[doc = concat!("[`", stringify!($method), "`]")] $method($method),)*
        }

        $(impl From<$method> for AnyReference {
            fn from(method: $method) -> Self {
                Self::$method(method)
            }
        })*

        impl Described for AnyReference {
            fn facts(self) -> Facts {
                match self {
                    $(Self::$method(method) => method.facts(),)*
                }
            }
            fn admissible(self) -> Result<(), Error> {
                match self {
                    $(Self::$method(method) => method.admissible(),)*
                }
            }
        }

        /// The memory of a method from step to step.
        #[derive(Clone, Default)]
        pub enum Memory<R: Real> {
            /// No memory before the first step.
            #[default]
            Empty,
            $(#[doc = "That of this method."] $method(<$method as Recipe>::Memory<R>),)*
        }

        impl Recipe for AnyReference {
            type Memory<R: Real> = Memory<R>;

            fn increment<R: Real>(self, memory: &mut Memory<R>, from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
                match self {
                    $(Self::$method(method) => {
                        let mut own = match std::mem::take(memory) {
                            Memory::$method(own) => own,
                            _ => Default::default(),
                        };
                        let increment = method.increment(&mut own, from);
                        *memory = Memory::$method(own);
                        increment
                    })*
                }
            }
        }
    };
}
any! {
    ForwardEuler StaggeredLeapfrog ExplicitMidpoint RungeKutta4 AdamsBashforth4 AdamsBashforthMoulton4 AdamsBashforthMoulton4Pec
    GraggBulirschStoer DormandPrince5 DormandPrince8 Bdf
}
