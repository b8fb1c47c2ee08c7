//! The catalogue as a list: every composition that a Hamiltonian admits, one after the other.
//!
//! A composition is a type, and types do not fit into a `Vec`; a [`Visitor`] is a loop body that is generic instead.

use crate::{
    catalogue::*,
    composition::Composition,
    hamiltonian::{Hamiltonian, QuadraticKinetic},
};

/// What is done with each composition that may integrate `H`.
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
pub trait Visitor<H: Hamiltonian> {
    /// Called once with each composition.
    fn visit<X: Composition<H>>(&mut self, composition: X);
}

/// Shows `visitor` the compositions for every `T(p)`.
pub fn visit_general<H: Hamiltonian>(visitor: &mut impl Visitor<H>) {
    macro_rules! visit {
        ($($composition:ident)*) => {$( visitor.visit($composition); )*};
    }
    visit!(Euler EulerAdjoint Verlet VelocityVerlet McLachlanAtela2 McLachlan2 VelocityMcLachlan2);
    visit!(Ruth3 McLachlanAtela3 McLachlan4 McLachlan4S4 Pefrl Vefrl Omelyan4 PositionOmelyan4);
    visit!(BlanesMoan4 BlanesMoan6 Teloy6A Yoshida4 VelocityYoshida4 Suzuki4 McLachlan4Ss5);
    visit!(Yoshida6 KahanLi6 McLachlan6 SofroniouSpaletta6S11 SofroniouSpaletta6S13);
    visit!(SuzukiUmeno8 KahanLi8 McLachlan8 SofroniouSpaletta8 KahanLi10 SofroniouSpaletta10);
    visit!(BlanesCasasMurua6S11 BlanesCasasMurua6S13 BlanesCasasMurua8);
    // Proved for every `T`, though at their best where it is quadratic.
    visit!(McLachlan4Sb3a BlanesMoanSrkn6);
}

/// Shows `visitor` the compositions for quadratic `T`, after those for every `T`.
pub fn visit_quadratic<H: QuadraticKinetic>(visitor: &mut impl Visitor<H>) {
    macro_rules! visit {
        ($($composition:ident)*) => {$( visitor.visit($composition); )*};
    }
    visit_general(visitor);
    visit!(McLachlanAtela4 CalvoSanzSerna4 McLachlanAtela5 Omelyan6 Teloy6B BlanesMoanSrkn11 BlanesMoanSrkn14);
    visit!(BlanesCasasEscorihuela8 Teloy8A Teloy8B Teloy8C);
    // With force gradients.
    visit!(Chin4A Chin4B Chin4C Chin4D Schaefers4 Schaefers6 TakahashiImada4 BlanesCasasRos6);
}
