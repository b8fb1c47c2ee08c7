//! What Verlet conserves to higher orders is conserved by Verlet, and by nothing that is a little different.

use crate::{
    schemes::{EulerThatClaims2, LongByFourthPowers, LongBySquares, Lopsided, Strong, Unmerged},
    systems::{Bent, HenonHeiles, Miscounted},
};
use integrator_core::{
    __private::Composition,
    check::{CheckError, ModifiedHamiltonian, Shadow, shadow},
    prelude::*,
};

struct Oscillator;

#[hamiltonian]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0]
    }
}

struct Relativistic;

#[hamiltonian]
impl Relativistic {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (1.0 + px * px + py * py).sqrt()
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + 2.0 * y * y) - x * x * y
    }
}

/// The step of an oscillator is a matrix `M` with the trace `2 cos θ`, and `M = exp(h JA)` has the solution
/// `JA = (M − cos θ) θ/(h sin θ)`: the modified Hamiltonian is `½ zᵀAz`.
#[test]
fn an_oscillator_has_closed_forms() {
    type Form = fn(f64, [f64; 2]) -> f64;
    let euler: Form = |h, [q, p]| q * q + p * p - h * q * p;
    let verlet: Form = |h, [q, p]| q * q + (1.0 - h * h / 4.0) * p * p;
    let velocity_verlet: Form = |h, [q, p]| (1.0 - h * h / 4.0) * q * q + p * p;
    let at = Phase::new([0.7], [0.4]);
    let distance = |modified: &ModifiedHamiltonian<'_, [f64; 1]>, form: Form| {
        let h = modified.step();
        let angle = (1.0 - h * h / 2.0).acos();
        (modified.energy(&at) - angle / (2.0 * angle.sin()) * form(h, [0.7, 0.4])).abs()
    };
    macro_rules! shrinks {
        ($composition:ident, $form:ident, $power:literal) => {
            let [coarse, fine] = [0.2, 0.1].map(|h| {
                let modified = ModifiedHamiltonian::new(&Oscillator, $composition, &at, h).expect("of T(p) + V(q)");
                distance(&modified, $form)
            });
            let power = (coarse / fine).log2();
            assert!((power - $power).abs() < 0.1, "{}: {coarse:e} {fine:e}", stringify!($composition));
        };
    }
    shrinks!(Euler, euler, 5.0);
    shrinks!(Verlet, verlet, 6.0);
    shrinks!(VelocityVerlet, velocity_verlet, 6.0);
    // With the term of h alone it is one of these, but for a factor.
    let exact = shadow(&Oscillator, Euler, at, 0.1).expect("a span");
    let measured: Vec<f64> = exact.powers.iter().map(|power| power.measured).collect();
    assert!(exact.is_conserved() && measured[1] == f64::INFINITY && measured[2].is_finite(), "{exact}");
    assert!(exact.to_string().contains("with the terms below h^2 is conserved to the rounding"), "{exact}");
}

#[test]
fn modified_hamiltonians_are_sums_that_print() {
    let at = Phase::new([0.7], [0.4]);
    let modified = ModifiedHamiltonian::new(&Oscillator, Verlet, &at, 0.1).expect("of T(p) + V(q)");
    assert!(modified.to_string().starts_with("T + V − 1/24·h²·{{V, T}, T} − 1/12·h²·{{V, T}, V} + "), "{modified}");
    assert_eq!(modified.series().powers(), [2, 4]);
    let energies = modified.energies(&at);
    // −p²/24 + q²/12
    let second = 0.01 * (0.49 / 12.0 - 0.16 / 24.0);
    assert!((energies[1] - energies[0] - second).abs() < 1e-16, "{energies:?}");
}

/// Without a formula of its fifth derivative.
#[test]
fn stated_derivatives_end_somewhere() {
    #[derive(Clone)]
    struct Tabulated;

    #[hamiltonian]
    impl Tabulated {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            0.5 * p[0] * p[0]
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            self.well(q[0])
        }
        #[derivative(slope)]
        fn well(&self, x: f64) -> f64 {
            -x.cos()
        }
        #[derivative(bend)]
        fn slope(&self, x: f64) -> f64 {
            x.sin()
        }
        fn bend(&self, x: f64) -> f64 {
            x.cos()
        }
    }

    let unknown = shadow(&Tabulated, Verlet, Phase::new([1.0], [0.0]), 0.1);
    assert!(matches!(unknown, Err(CheckError::NotFinite { .. })), "{unknown:?}");
}

fn measured<H, X>(system: &H, composition: X) -> Shadow
where
    H: Hamiltonian<Coords = [f64; 2]>,
    X: Composition<H>,
{
    let start = Phase::new([0.1, -0.2], [0.3, 0.25]);
    shadow::<H, X, f64>(system, composition, start, 0.05).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn compositions_conserve_their_modified_hamiltonians() {
    let table: [(Shadow, &[i32]); 9] = [
        (measured(&HenonHeiles {}, Euler), &[1, 2, 3, 4, 5]),
        (measured(&HenonHeiles {}, Verlet), &[2, 4, 6]),
        (measured(&HenonHeiles {}, VelocityVerlet), &[2, 4, 6]),
        (measured(&HenonHeiles {}, Ruth3), &[3, 4, 5]),
        (measured(&HenonHeiles {}, Yoshida4), &[4, 6]),
        (measured(&HenonHeiles {}, Chin4A), &[4, 6]),
        (measured(&HenonHeiles {}, KahanLi8), &[8]),
        (measured(&Relativistic, Verlet), &[2, 4, 6]),
        (measured(&Relativistic, Yoshida4), &[4, 6]),
    ];
    for (shadow, exact) in table {
        assert!(shadow.is_conserved(), "{shadow}");
        assert_eq!(shadow.powers.iter().map(|power| power.exact).collect::<Vec<_>>(), exact);
        for power in &shadow.powers {
            assert!((power.measured - f64::from(power.exact)).abs() < 0.2, "{shadow}");
        }
    }
}

/// What is wrong, and the first power that tells: counted from 0, for `H` itself.
#[test]
fn a_slightly_wrong_stepper_conserves_another_energy() {
    let table = [
        ("a force too strong by a thousandth", measured(&HenonHeiles {}, Strong), 0),
        ("half a drift too few", measured(&HenonHeiles {}, Unmerged), 0),
        ("drifts of a quarter and three quarters", measured(&HenonHeiles {}, Lopsided), 1),
        ("order 1", measured(&HenonHeiles {}, EulerThatClaims2), 0),
        ("kicks longer by squares", measured(&HenonHeiles {}, LongBySquares), 1),
        ("kicks longer by fourth powers", measured(&HenonHeiles {}, LongByFourthPowers), 2),
        ("a wrong factor in the gradient", measured(&Miscounted {}, Verlet), 0),
        ("a wrong factor in the Hessian", measured(&Bent {}, Chin4A), 0),
    ];
    for (mistake, shadow, tells) in table {
        assert!(!shadow.is_conserved(), "{mistake}: {shadow}");
        let first = shadow.powers.iter().position(|power| power.measured < f64::from(power.exact) - 0.5);
        assert_eq!(first, Some(tells), "{mistake}: {shadow}");
    }
}

#[test]
fn a_start_at_rest_measures_nothing() {
    let nothing = shadow(&HenonHeiles {}, Verlet, Phase::new([0.0, 0.0], [0.0, 0.0]), 0.05);
    assert!(matches!(nothing, Err(CheckError::TooFewPoints { .. })), "{nothing:?}");
}
