//! The systems of `systems.py`, as their users would write them.

use crate::recurrences::judge;
use integrator_core::prelude::*;

/// Declares a system and a test for every row: the name, the shape of the coordinates, and the bodies of `kinetic` and
/// `potential`. Names that rows mention are given once, in front.
macro_rules! rows {
    (
        ($self:ident, $q:ident, $p:ident, $t:ident)
        $($name:ident [$($shape:tt)*] { $($kinetic:tt)* } { $($potential:tt)* })*
    ) => {
        /// The names of the rows.
        pub(crate) const ROWS: &[&str] = &[$(stringify!($name)),*];

        $(mod $name {
            use super::*;

            #[allow(dead_code, reason = "a row reads what it needs")]
            pub(crate) struct System {
                exponent: f64,
                rate: f64,
                mass: f64,
            }

            #[hamiltonian(taylor)]
            #[allow(unused_variables, clippy::all, reason = "a row shows one construct, and reads what it needs")]
            impl System {
                fn kinetic(&$self, $p: $($shape)*, $t: f64) -> f64 {
                    $($kinetic)*
                }
                fn potential(&$self, $q: $($shape)*, $t: f64) -> f64 {
                    $($potential)*
                }
            }

            #[test]
            fn coefficients_are_those_of_the_reference() {
                judge(stringify!($name), &System { exponent: -1.375, rate: 1.5, mass: 1.0 });
            }
        })*
    };
}

rows! {
    (self, q, p, t)

    // Elementary functions
    sin [[f64; 1]] { p[0] * p[0] / 2.0 } { 1.5 * q[0].sin() }
    cos [[f64; 1]] { p[0] * p[0] / 2.0 } { -q[0].cos() }
    tan [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].tan() }
    asin [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].asin() }
    acos [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].acos() }
    atan [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].atan() }
    sinh [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].sinh() }
    cosh [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].cosh() }
    tanh [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].tanh() }
    asinh [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].asinh() }
    acosh [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].acosh() }
    atanh [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].atanh() }
    exp [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].exp() - q[0] }
    exp2 [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].exp2() }
    exp_m1 [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].exp_m1() }
    ln [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].ln() }
    ln_1p [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].ln_1p() }
    log2 [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].log2() }
    log10 [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].log10() }
    cbrt [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].cbrt() }
    cbrt_of_negative [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].cbrt() }
    abs [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].abs() * q[0].powi(2) }
    min [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } { q[0].sin().min(q[1] * q[1]) }
    max [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } { q[0].sin().max(q[1] * q[1]) * q[0] }
    signum [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } { q[0].signum() * q[0].powi(2) * q[1] }
    floor [[f64; 1]] { p[0] * p[0] / 2.0 } { (q[0] - q[0].floor()).powi(3) }
    ceil [[f64; 1]] { p[0] * p[0] / 2.0 } { (q[0] - q[0].ceil()).powi(3) }
    trunc [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].trunc() * q[0].powi(2) }
    round [[f64; 1]] { p[0] * p[0] / 2.0 } { (q[0] - 2.0 * (q[0] / 2.0).round()).powi(4) }
    remainder [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } { (q[0] % q[1]).powi(3) }
    powf [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].powf(1.25) }
    powf_of_parameter [[f64; 1]] { p[0] * p[0] / 2.0 } { (q[0] * q[0] + 1.0).powf(self.exponent) }
    powf_of_both [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } { q[0].powf(q[1]) }
    atan2 [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } { q[1].atan2(q[0]) * q[0] }
    hypot [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } { q[0].hypot(q[1]) }

    // Powers and quotients
    sqrt [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].sqrt() }
    recip [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].recip() }
    square [[f64; 1]] { p[0] * p[0] / 2.0 } { 2.0 * q[0].powi(2) }
    cube [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].powi(3) }
    cube_at_zero [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].powi(3) }
    fourth [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].powi(4) / 4.0 - q[0] * q[0] / 2.0 }
    fourth_at_zero [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].powi(4) }
    seventh [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].powi(7) }
    seventh_at_zero [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].powi(7) }
    inverse_square [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0].powi(-2) }
    inverse_sixth [[f64; 1]] { p[0] * p[0] / 2.0 } { let s = q[0].powi(-6); s * s - 2.0 * s }
    three_halves [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0] * q[0].sqrt() }
    inverse_root [[f64; 1]] { p[0] * p[0] / 2.0 } { 1.0 / q[0].sqrt() }
    kepler [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } { -1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() }
    henon_heiles [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } {
        let [x, y] = q;
        (x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
    }
    quotient [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } { q[0].sin() / (2.0 + q[1]) }
    quotient_of_negative [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } { -q[0] / -(2.0 + q[0] * q[1]) }
    products [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } {
        let [x, y] = q;
        -x * (-y) * (x - y) * (x + 2.0 * y)
    }
    rational [[f64; 1]] { p[0] * p[0] / 2.0 } { (1.0 + q[0]) / (1.0 + q[0] * q[0]) }
    nested [[f64; 1]] { p[0] * p[0] / 2.0 } { (-(1.0 + q[0] * q[0]).sqrt().sin() / 2.0).exp() }
    sine_and_cosine [[f64; 1]] { p[0] * p[0] / 2.0 } { let (s, c) = q[0].sin_cos(); s * c + s }
    cancelling [[f64; 1]] { p[0] * p[0] / 2.0 } { (2.0 * q[0]).cosh() - 2.0 * q[0].sinh().powi(2) + q[0] * q[0] }

    // Branches
    branch_taken [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } {
        let mut sum = q[0] * q[0];
        if q[0] * q[0] + q[1] * q[1] < 1.0 {
            sum += q[0].sin() * q[1];
        }
        sum
    }
    branch_left [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } {
        q[0] * q[0] + if q[0] * q[0] + q[1] * q[1] < 1.0 { q[0].sin() * q[1] } else { (q[0] + q[1]).cos() }
    }
    clamped [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } { q[0] * q[1].clamp(-0.5, 0.5) + q[0] * q[0].clamp(-1.0, 1.0) }

    // Kinetic energies
    relativistic [[f64; 1]] { (1.0 + p[0] * p[0]).sqrt() } { -q[0].cos() }
    exponential_momenta [[f64; 1]] { p[0].cosh() + p[0].powi(4) / 4.0 } { (1.0 + q[0] * q[0]).ln() }
    coupled_momenta [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 + p[0] * p[1] / 4.0 + (p[0] - p[1]).powi(4) } {
        q[0] * q[0] * q[1]
    }

    // Time
    driven [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0] * (self.rate * t).sin() + t * t * q[0].cos() }
    driven_from_zero [[f64; 1]] { p[0] * p[0] / 2.0 } { q[0] * q[0] * t.powi(3) - q[0] * t }
    growing_mass [[f64; 1]] { p[0] * p[0] / (2.0 * (self.mass + t)) } { -(q[0] - t).cos() * (-t / 2.0).exp() }
    switched [[f64; 1]] { p[0] * p[0] / 2.0 } { if t < 0.5 { t * q[0].powi(3) } else { q[0] } }

    // Sums over as many coordinates as the start has
    springs [&[f64]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let mut sum = 0.0;
        for i in 1..q.len() {
            let r = q[i] - q[i - 1];
            sum += r * r / 2.0 + r.powi(4) / 4.0 + r.exp() / 8.0;
        }
        sum
    }

    // Lines of sites that fill vectors
    line_between_walls [[f64; 16]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let bond = |r: f64| r * r / 2.0 - r.powi(3) / 4.0 + r.powi(4) / 4.0;
        let mut sum = bond(q[0]) + bond(-q[15]);
        for i in 1..16 {
            sum += bond(q[i] - q[i - 1]);
        }
        sum
    }
    line_with_ends [[f64; 8]] { let mut t = 0.0; for i in 0..8 { t += p[i] * p[i] / (2.0 + i as f64 / 4.0); } t } {
        let mut sum = 0.0;
        for i in 0..8 {
            sum -= q[i].cos();
        }
        for i in 0..7 {
            let r = q[i + 1] - q[i];
            sum += r * r / 2.0 - r.powi(3) / 4.0 + r.powi(4) / 4.0;
        }
        sum
    }
    line_from_a_wall [[f64; 8]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let mut sum = q[0].exp();
        for i in 1..8 {
            sum += (q[i] - q[i - 1]).exp();
        }
        sum
    }
    line_to_a_wall [[f64; 8]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let mut sum = (1.0 + q[7] * q[7]).sqrt();
        for i in 0..7 {
            sum += (1.0 + (q[i + 1] - q[i]).powi(2)).sqrt();
        }
        sum
    }
    ring [[f64; 16]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let mut sum = 0.0;
        for i in 0..16 {
            sum += t * (q[(i + 1) % 16] - q[i]).powi(4) + q[i].powi(4) / 4.0 - q[i] * q[i] / 2.0;
        }
        sum
    }

    // Sums over pairs and within sums
    pairs [&[[f64; 2]]] { p.iter().map(|p| (p[0] * p[0] + p[1] * p[1]) / 2.0).sum() } {
        let mut sum = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                sum -= 1.0 / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2)).sqrt();
            }
        }
        sum
    }
    pairs_within [&[[f64; 2]]] { p.iter().map(|p| (p[0] * p[0] + p[1] * p[1]) / 2.0).sum() } {
        let mut sum = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let s = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);
                if s < 2.0 {
                    sum += (s - 2.0).powi(2) * (-s).exp();
                }
            }
        }
        sum
    }
    mean_field [&[f64]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let (mut along, mut across) = (0.0, 0.0);
        for i in 0..q.len() {
            along += q[i].cos();
            across += q[i].sin();
        }
        -(along * along + across * across).sqrt()
    }
    sums_within_sums [&[f64]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let mut sum = 0.0;
        for i in 0..q.len() {
            let mut inner = 0.0;
            for j in 0..q.len() {
                inner += (q[i] - q[j]).sin();
            }
            sum += inner * inner * q[i];
        }
        sum
    }
    hoisted [&[f64]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let mut sum = 0.0;
        for i in 0..q.len() {
            for j in 0..q.len() {
                sum += q[j].sin() * (q[i] - q[j]).powi(2) * q[i].exp();
            }
        }
        sum
    }
    in_either_branch [[f64; 2]] { (p[0] * p[0] + p[1] * p[1]) / 2.0 } {
        let [x, y] = q;
        if x < y { (x * y).sin() } else { (x * y).cos() + (x + y).powi(2) * if x > 0.5 { (x * y).tan() } else { y } }
    }
    product_of_sums [&[f64]] {
        let total: f64 = p.iter().sum();
        p.iter().map(|p| p * p / 2.0).sum::<f64>() + total * total / 8.0
    } {
        let squares: f64 = q.iter().map(|q| q * q).sum();
        let exponentials: f64 = q.iter().map(|q| q.exp()).sum();
        squares * exponentials
    }

    // Iterations side by side: more than eight, with numbers and conditions of their own
    turns_of_their_own [&[f64]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let mut sum = 0.0;
        for i in 0..q.len() {
            sum += (i + 1) as f64 * q[i].powi(2) * (q[i] + t).sin();
        }
        for i in 0..q.len() {
            for j in 0..q.len() {
                if i != j {
                    sum += (-(q[i] - q[j]).powi(2)).exp() / (i + 2) as f64 / 8.0;
                }
            }
        }
        sum
    }
    ring_of_points [&[[f64; 2]]] { p.iter().map(|p| (p[0] * p[0] + p[1] * p[1]) / 2.0).sum() } {
        let (n, mut sum) = (q.len(), 0.0);
        for i in 0..n {
            for d in 0..2 {
                sum += q[i][d] * q[i][d] / 2.0;
            }
            let (a, b) = (q[i], q[(i + 1) % n]);
            sum += (a[0] * b[1] - a[1] * b[0]) / -(2.0 + a[0] * a[0] + b[1] * b[1]);
        }
        sum
    }
    walls_that_move [&[f64]] {
        let mut sum = 0.0;
        for i in 0..p.len() {
            sum += p[i] * p[i] / (2.0 * (i + 1) as f64);
        }
        sum
    } {
        let mut sum = (q[0] - (2.0 * t).sin()).powi(4) / 4.0 + t * q[q.len() - 1].cos();
        for i in 1..q.len() {
            let r = q[i] - q[i - 1];
            sum += r * r / 2.0 + r * r * r / 4.0;
        }
        sum
    }
    linear_loops [&[f64]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let mut sum = 0.0;
        for i in 0..q.len() {
            sum += (i + 1) as f64 * q[i] / 8.0;
        }
        for i in 0..q.len() {
            sum += q[i] * q[i] / 2.0;
        }
        for i in 1..q.len() {
            sum += (q[i] - q[i - 1]).powi(4);
        }
        sum
    }
    sum_times_products [&[f64]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let (mut sum, mut products) = (0.0, 0.0);
        for i in 0..q.len() {
            sum += q[i];
        }
        for i in 1..q.len() {
            for _ in 0..3 {
                products += q[0] * q[i];
            }
        }
        sum * products / 8.0
    }
    products_in_any_order [[f64; 2]] { p[0] * p[0] / 2.0 + p[1] * p[1] / 2.0 } {
        let [x, y] = q;
        let cubes = self.rate * x * x * x - y * y * self.rate * y / 3.0 + x * self.rate * y * x;
        cubes + x * y * self.rate * (y * x) * y + (y - x) * (x - y) * (y - x) * (x - y) + x.powi(7) / 8.0
    }
    lattice [[f64; 20]] { p.iter().map(|p| p * p / 2.0).sum() } {
        let mut sum = q[7] * q[19].sin();
        for i in 0..4 {
            for j in 0..5 {
                sum += (j + 1) as f64 * q[5 * i + j].cos();
            }
        }
        for i in 0..4 {
            for j in 1..5 {
                sum -= (q[5 * i + j] - q[5 * i + j - 1]).cos();
            }
        }
        for i in 1..4 {
            for j in 0..5 {
                sum -= (q[5 * i + j] - q[5 * i + j - 5]).cos() / 2.0;
            }
        }
        sum
    }
}
