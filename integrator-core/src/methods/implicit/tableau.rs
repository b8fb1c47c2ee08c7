//! The coefficients of methods of Runge and Kutta.

use crate::trajectory::method::Described;

/// Stages `zᵢ = y + h Σ aᵢⱼ f(zⱼ, t + cⱼ h)` of a Runge-Kutta method, which adds `h Σ bᵢ f(zᵢ, t + cᵢ h)`.
pub struct Tableau<const S: usize> {
    pub(super) a: [[f64; S]; S],
    pub(super) b: [f64; S],
    pub(super) c: [f64; S],
}

/// A method with this number of stages.
pub trait Stages<const S: usize>: Described {
    /// The coefficients of the method.
    const TABLEAU: Tableau<S>;
}

/// One stage, at `a h`.
pub(super) const fn one_stage(a: f64) -> Tableau<1> {
    Tableau { a: [[a]], b: [1.0], c: [a] }
}

/// `√3/6`.
const X: f64 = 0.288_675_134_594_812_9;

/// The abscissas and weights of Gauss with two points.
pub(super) const GAUSS_4: Tableau<2> =
    Tableau { a: [[0.25, 0.25 - X], [0.25 + X, 0.25]], b: [0.5; 2], c: [0.5 - X, 0.5 + X] };

/// `√15`.
const Y: f64 = 3.872_983_346_207_417;

/// The abscissas and weights of Gauss with three points.
pub(super) const GAUSS_6: Tableau<3> = Tableau {
    a: [
        [5.0 / 36.0, 2.0 / 9.0 - Y / 15.0, 5.0 / 36.0 - Y / 30.0],
        [5.0 / 36.0 + Y / 24.0, 2.0 / 9.0, 5.0 / 36.0 - Y / 24.0],
        [5.0 / 36.0 + Y / 30.0, 2.0 / 9.0 + Y / 15.0, 5.0 / 36.0],
    ],
    b: [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0],
    c: [0.5 - Y / 10.0, 0.5, 0.5 + Y / 10.0],
};
