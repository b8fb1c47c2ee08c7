//! The loop over the catalogue: every composition that can integrate a Hamiltonian.
//!
//! A composition is a type, and types cannot be elements of a `Vec`; a [`Visitor`] is a generic loop body instead.

use crate::{
    composition::{Composition, catalogue::*, catalogue_list::for_each_composition},
    system::{QuadraticKinetic, System},
};

/// A visitor of the compositions that can integrate `H`.
///
/// ```
/// use integrator_core::{Visitor, prelude::*};
///
/// struct Names(Vec<&'static str>);
///
/// impl<H: Hamiltonian> Visitor<H> for Names {
///     fn visit<X: Composition<H>>(&mut self, _: X) {
///         self.0.push(X::NAME);
///     }
/// }
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
/// let mut names = Names(Vec::new());
/// Oscillator::visit_compositions(&mut names);
/// assert!(names.0.contains(&"Verlet") && names.0.contains(&"BlanesMoanSrkn11"));
/// ```
pub trait Visitor<H: System> {
    /// Called once with each composition.
    fn visit<X: Composition<H>>(&mut self, composition: X);

    /// Called once before compositions with force gradients, if they can integrate `H`.
    fn admit_gradients(&mut self)
    where
        H: QuadraticKinetic,
    {
    }
}

/// Visits the compositions for every `T(p)`.
pub fn visit_general<H: System>(visitor: &mut impl Visitor<H>) {
    macro_rules! visit {
        ($($composition:ident)*) => {$( visitor.visit($composition); )*};
    }
    visit_many_parts(visitor);
    for_each_composition!(processed: visit!);
}

/// Visits the compositions for any number of parts: those for every `T(p)` that have no processor.
pub fn visit_many_parts<H: System>(visitor: &mut impl Visitor<H>) {
    macro_rules! visit {
        ($($composition:ident)*) => {$( visitor.visit($composition); )*};
    }
    for_each_composition!(unprocessed: visit!);
}

/// Visits the compositions that keep their orders if the second of two parts is itself a symmetric pair.
pub fn visit_pairs<H: System>(visitor: &mut impl Visitor<H>) {
    macro_rules! visit {
        ($($composition:ident)*) => {$( visitor.visit($composition); )*};
    }
    for_each_composition!(pairs: visit!);
}

/// Visits the compositions for two parts with inner steps in the second: those without a processor.
pub fn visit_nested<H: System>(visitor: &mut impl Visitor<H>) {
    macro_rules! visit {
        ($($composition:ident)*) => {$( visitor.visit($composition); )*};
    }
    visit_many_parts(visitor);
    for_each_composition!(near_integrable_unprocessed: visit!);
}

/// Visits the compositions for every `T(p)`, then those for a small second part: for two named parts.
pub fn visit_two_parts<H: System>(visitor: &mut impl Visitor<H>) {
    macro_rules! visit {
        ($($composition:ident)*) => {$( visitor.visit($composition); )*};
    }
    visit_general(visitor);
    for_each_composition!(near_integrable_general: visit!);
}

/// Visits the compositions of [`visit_two_parts`], then those for a first part that is quadratic in `p`.
pub fn visit_two_parts_quadratic<H: QuadraticKinetic>(visitor: &mut impl Visitor<H>) {
    macro_rules! visit {
        ($($composition:ident)*) => {$( visitor.visit($composition); )*};
    }
    visit_two_parts(visitor);
    visitor.admit_gradients();
    for_each_composition!(quadratic: visit!);
    for_each_composition!(near_integrable_quadratic: visit!);
}

/// Visits the compositions for every `T(p)`, then those for quadratic `T`.
pub fn visit_quadratic<H: QuadraticKinetic>(visitor: &mut impl Visitor<H>) {
    macro_rules! visit {
        ($($composition:ident)*) => {$( visitor.visit($composition); )*};
    }
    visit_general(visitor);
    visitor.admit_gradients();
    for_each_composition!(quadratic: visit!);
}
