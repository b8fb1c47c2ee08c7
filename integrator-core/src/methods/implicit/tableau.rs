//! The coefficients of methods of Runge and Kutta.
//!
//! In the form `Z_i = y + Σ μ_ij L_j`, `L_i = h b_i f(Z_i)`, `y' = y + Σ L_i` with `μ_ij = a_ij / b_j`, a method is symplectic if
//! `μ_ij + μ_ji = 1` (Sanz-Serna 1988, BIT 28, 877; Antoñana, Makazaga and Murua 2017, Numerical Algorithms 76, 861). The
//! coefficients of Gauss are rounded so that this holds without an error.

use crate::trajectory::method::Described;

/// The coefficients of a method of Gauss and Legendre, to 34 digits.
pub(super) struct Coefficients<'c> {
    pub(super) nodes: &'c [f64],
    pub(super) weights: &'c [f64],
    /// The numbers `μ_ij` with `j > i`, row by row.
    pub(super) above: &'c [f64],
}

/// The coefficients of a method of Runge and Kutta.
pub struct Tableau<const S: usize> {
    pub(super) mu: [[f64; S]; S],
    pub(super) b: [f64; S],
    pub(super) c: [f64; S],
}

impl<const S: usize> Tableau<S> {
    /// The coefficient of the field at stage `j` in stage `i`.
    #[cfg(feature = "check")]
    pub(super) fn a(&self, i: usize, j: usize) -> f64 {
        self.mu[i][j] * self.b[j]
    }
}

/// A method with this number of stages.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has {S} stages",
    label = "a Gauss-Legendre method has 1 to 8 stages",
    note = "its order is twice the number of stages: `GaussLegendre::<8>` has order 16"
)]
pub trait Stages<const S: usize>: Described {
    /// The coefficients of the method.
    const TABLEAU: Tableau<S>;
}

/// The method of Gauss and Legendre with these coefficients.
pub(super) const fn gauss_legendre<const S: usize>(of: &Coefficients<'_>) -> Tableau<S> {
    let (mut mu, mut b, mut c) = ([[0.5; S]; S], [0.0; S], [0.0; S]);
    let (mut i, mut next) = (0, 0);
    while i < S {
        (b[i], c[i]) = (of.weights[i], of.nodes[i]);
        let mut j = i + 1;
        while j < S {
            // Of the two, the larger one is rounded. It is at least a half, and at most two: its difference from 1 is exact.
            let one = of.above[next];
            if one < 0.5 {
                mu[j][i] = 1.0 - one;
                mu[i][j] = 1.0 - mu[j][i];
            } else {
                mu[i][j] = one;
                mu[j][i] = 1.0 - one;
            }
            next += 1;
            j += 1;
        }
        i += 1;
    }
    Tableau { mu, b, c }
}

/// The implicit method of Euler.
pub(super) const EULER: Tableau<1> = Tableau { mu: [[1.0]], b: [1.0], c: [1.0] };

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::implicit::gauss_legendre::GaussLegendre;

    /// Calls a function with the coefficients of all methods.
    macro_rules! for_each {
        ($check:ident) => {
            $check(&<GaussLegendre<1> as Stages<1>>::TABLEAU);
            $check(&<GaussLegendre<2> as Stages<2>>::TABLEAU);
            $check(&<GaussLegendre<3> as Stages<3>>::TABLEAU);
            $check(&<GaussLegendre<4> as Stages<4>>::TABLEAU);
            $check(&<GaussLegendre<5> as Stages<5>>::TABLEAU);
            $check(&<GaussLegendre<6> as Stages<6>>::TABLEAU);
            $check(&<GaussLegendre<7> as Stages<7>>::TABLEAU);
            $check(&<GaussLegendre<8> as Stages<8>>::TABLEAU);
        };
    }

    /// Whether the sum of two numbers is 1, without rounding.
    fn add_up(one: f64, other: f64) -> bool {
        crate::scalar::exact::two_sum(one, other) == [1.0, 0.0]
    }

    #[test]
    fn steps_are_symplectic_and_symmetric_to_the_bit() {
        fn check<const S: usize>(Tableau { mu, b, c }: &Tableau<S>) {
            for i in 0..S {
                assert_eq!(b[i], b[S - 1 - i]);
                assert!((c[i] + c[S - 1 - i] - 1.0).abs() <= f64::EPSILON / 2.0);
                for j in 0..S {
                    assert!(add_up(mu[i][j], mu[j][i]), "{S} stages: {i}, {j}");
                    assert_eq!(mu[S - 1 - i][S - 1 - j], mu[j][i], "{S} stages: {i}, {j}");
                }
            }
        }
        for_each!(check);
        // The check can fail: the usual coefficients are rounded one by one.
        let b = [5.0 / 18.0, 4.0 / 9.0];
        let [above, below] = [2.0 / 9.0 - 15.0_f64.sqrt() / 15.0, 5.0 / 36.0 + 15.0_f64.sqrt() / 24.0];
        assert!(!add_up(above / b[1], below / b[0]));
    }

    #[test]
    fn the_order_is_twice_the_number_of_stages() {
        fn check<const S: usize>(tableau: &Tableau<S>) {
            let Tableau { mu, b, c } = tableau;
            // Nodes, weights and μ are rounded once each, and powers multiply the error of a node by at most 2 S; sums have S
            // terms of at most one.
            let rounding = 4.0 * (S * S) as f64 * f64::EPSILON;
            for k in 1..=2 * S {
                let sum: f64 = (0..S).map(|i| b[i] * c[i].powi(k as i32 - 1)).sum();
                assert!((sum - 1.0 / k as f64).abs() < rounding, "{S} stages, quadrature of order {k}: {sum}");
            }
            for k in 1..=S {
                for i in 0..S {
                    let sum: f64 = (0..S).map(|j| mu[i][j] * b[j] * c[j].powi(k as i32 - 1)).sum();
                    let exact = c[i].powi(k as i32) / k as f64;
                    assert!((sum - exact).abs() < rounding, "{S} stages, collocation of order {k}: {sum}, {exact}");
                }
            }
            // By B(2 S) and C(S), and D(S) from these and symplecticity, the order is 2 S (Hairer, Lubich, Wanner, II.1.4).
            let beyond: f64 = (0..S).map(|i| b[i] * c[i].powi(2 * S as i32)).sum();
            assert!((beyond - 1.0 / (2 * S + 1) as f64).abs() > 100.0 * rounding || S > 5, "{S} stages: {beyond}");
        }
        for_each!(check);
    }
}
