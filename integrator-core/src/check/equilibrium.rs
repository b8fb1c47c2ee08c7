//! The equilibrium of a harmonic oscillator under a composition with friction and noise, in closed form.

use crate::methods::friction::{FrictionScheme, Letter};
use nalgebra::{Matrix3, Vector3};

/// The distribution of a harmonic oscillator `p²/2m + m ω² q²/2` in equilibrium, at the ends of steps.
///
/// It is normal with the mean zero, as the exact one, for which all three numbers are 1, 0 and 1. Their differences are the bias
/// of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium {
    /// The variance of `q`, over `kT/(m ω²)`.
    pub positions: f64,
    /// The covariance of `q` and `p`, over `kT/ω`.
    pub covariance: f64,
    /// The variance of `p`, over `m kT`.
    pub momenta: f64,
}

/// Computes the equilibrium of a harmonic oscillator under the composition `X`, for a step `h` and a rate of friction `γ`.
///
/// `h_omega` is `h·ω` and `h_gamma` is `h·γ`. Returns `None` if the step has no equilibrium: it is unstable, or there is no
/// friction.
///
/// Each stage maps variances linearly, and noise adds a constant; the equilibrium is the fixed point of a step (Leimkuhler and
/// Matthews 2013, Appl. Math. Res. Express 2013, 34).
///
/// ```
/// use integrator_core::{check::oscillator_equilibrium, prelude::*};
///
/// // Positions have no bias, at any stable step; momenta have one of h²ω²/4.
/// let equilibrium = oscillator_equilibrium::<Baoab>(1.0, 0.1).expect("a stable step");
/// assert!((equilibrium.positions - 1.0).abs() < 1e-12);
/// assert!((equilibrium.momenta - 0.75).abs() < 1e-12);
/// assert!(oscillator_equilibrium::<Baoab>(2.1, 0.1).is_none());
/// ```
#[must_use]
pub fn oscillator_equilibrium<X: FrictionScheme>(h_omega: f64, h_gamma: f64) -> Option<Equilibrium> {
    if !(h_omega > 0.0 && h_omega < X::STABILITY_LIMIT && h_gamma > 0.0) {
        return None;
    }
    // The map of the variances of q and p and of their covariance, and what it adds.
    let (mut map, mut noise) = (Matrix3::identity(), Vector3::zeros());
    for letter in X::LETTERS {
        let (own, added) = match letter {
            Letter::T(share) => {
                let t = share * h_omega;
                (Matrix3::new(1.0, 2.0 * t, t * t, 0.0, 1.0, t, 0.0, 0.0, 1.0), 0.0)
            }
            Letter::V(share) => {
                let t = share * h_omega;
                (Matrix3::new(1.0, 0.0, 0.0, -t, 1.0, 0.0, t * t, -2.0 * t, 1.0), 0.0)
            }
            Letter::O(share) => {
                let left = (-share * h_gamma).exp();
                (Matrix3::from_diagonal(&Vector3::new(1.0, left, left * left)), 1.0 - left * left)
            }
        };
        (map, noise) = (own * map, own * noise + Vector3::new(0.0, 0.0, added));
    }
    let fixed = (Matrix3::identity() - map).lu().solve(&noise)?;
    Some(Equilibrium { positions: fixed[0], covariance: fixed[1], momenta: fixed[2] })
}
