//! Explicit Runge–Kutta methods with a fixed step, each a table of coefficients.

use crate::walk::{Place, Recipe, combined};
use integrator_core::{__private::Real, Described, Facts, Unsolved};

/// Coefficients after Butcher: stage `i` is the field at `y + h Σ a[i][j] kⱼ` and time `t + h c[i]`, and the step adds
/// `h Σ b[i] kᵢ`.
pub(crate) struct Tableau {
    a: &'static [&'static [f64]],
    b: &'static [f64],
    c: &'static [f64],
}

/// The classical method of Kutta (1901), which also starts multistep methods.
pub(crate) const CLASSICAL: Tableau = Tableau {
    a: &[&[], &[0.5], &[0.0, 0.5], &[0.0, 0.0, 1.0]],
    b: &[1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
    c: &[0.0, 0.5, 0.5, 1.0],
};

impl Tableau {
    /// Returns the increment of a step.
    pub(crate) fn increment<R: Real>(&self, from: &Place<'_, R>) -> Vec<R> {
        let mut stages: Vec<Vec<R>> = Vec::with_capacity(self.b.len());
        let weighted = |weights: &[f64], stages: &[Vec<R>]| {
            let terms: Vec<_> = weights.iter().zip(stages).map(|(weight, stage)| (*weight, &stage[..])).collect();
            combined(from.h, &terms)
        };
        for (row, time) in self.a.iter().zip(self.c) {
            let y = if row.is_empty() { from.y.to_vec() } else { from.moved(&weighted(row, &stages)) };
            stages.push(from.field.derivative(&y, from.time + time * from.h));
        }
        weighted(self.b, &stages)
    }
}

macro_rules! runge_kutta {
    ($($(#[$doc:meta])* $name:ident: order $order:literal, stable $stable:expr, $tableau:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct $name;

        impl Described for $name {
            fn facts(self) -> Facts {
                const TABLEAU: Tableau = $tableau;
                let forces = TABLEAU.b.len();
                facts! {
                    name: stringify!($name),
                    order: $order,
                    forces: Some(forces),
                    stability_limit: Some($stable),
                    roundings: 2 * forces }
            }
        }

        impl Recipe for $name {
            type Memory<R: Real> = ();

            fn increment<R: Real>(self, _: &mut (), from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
                const TABLEAU: Tableau = $tableau;
                Ok(TABLEAU.increment(from))
            }
        }
    )*};
}
runge_kutta! {
    /// Euler's method (1768): `y + h f(y)`. The energy of a harmonic oscillator grows by the factor `1 + (h·ω)²` in
    /// each step, for every step size.
    ForwardEuler: order 1, stable 0.0, Tableau { a: &[&[]], b: &[1.0], c: &[0.0] };
    /// The explicit midpoint method, `y + h f(y + h/2 f(y))` (Runge 1895). The energy of a harmonic oscillator grows by
    /// the factor `1 + (h·ω)⁴/4` in each step.
    ExplicitMidpoint: order 2, stable 0.0, Tableau { a: &[&[], &[0.5]], b: &[0.0, 1.0], c: &[0.0, 0.5] };
    /// The classical method of order 4 (Kutta 1901). It is stable for a harmonic oscillator up to `h·ω = √8`. There it
    /// loses energy: the factor is `1 - (h·ω)⁶/72 + (h·ω)⁸/576` in each step.
    RungeKutta4: order 4, stable 2.0 * std::f64::consts::SQRT_2, CLASSICAL;
}
