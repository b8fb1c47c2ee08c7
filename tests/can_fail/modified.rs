//! What Verlet conserves to higher orders is conserved by Verlet, and by nothing that is a little different.

use crate::{
    schemes::{EulerThatClaims2, Lopsided, Strong, Swapped, Unmerged},
    systems::{Bent, HenonHeiles, Miscounted},
};
use integrator_core::{
    __private::{Composition, QuadraticKinetic},
    Phase, VelocityVerlet, Verlet,
    check::{CheckError, Shadow, Shadowed, shadow},
};

fn measured<H, X>(system: &H, composition: X) -> Shadow
where
    H: QuadraticKinetic<Coords = [f64; 2]>,
    X: Composition<H> + Shadowed,
{
    let start = Phase::new([0.1, -0.2], [0.3, 0.25]);
    shadow::<H, X, f64>(system, composition, start, 0.05).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn verlet_conserves_its_modified_hamiltonian() {
    for shadow in [measured(&HenonHeiles {}, Verlet), measured(&HenonHeiles {}, VelocityVerlet)] {
        assert!(shadow.is_conserved(), "{shadow:?}");
        for (power, exact) in shadow.powers.iter().zip([2.0, 4.0, 6.0]) {
            assert!((power - exact).abs() < 0.2, "{shadow:?}");
        }
    }
}

/// What is wrong, and the first power that tells: counted from 0, for `H` itself.
#[test]
fn what_is_a_little_wrong_conserves_something_else() {
    let table = [
        ("a force too strong by a thousandth", measured(&HenonHeiles {}, Strong), 0),
        ("half a drift too few", measured(&HenonHeiles {}, Unmerged), 0),
        ("drifts of a quarter and three quarters", measured(&HenonHeiles {}, Lopsided), 0),
        ("order 1", measured(&HenonHeiles {}, EulerThatClaims2), 0),
        ("the terms of the other Verlet", measured(&HenonHeiles {}, Swapped), 1),
        ("a wrong factor in the gradient", measured(&Miscounted {}, Verlet), 0),
        ("a wrong factor in the Hessian", measured(&Bent {}, Verlet), 1),
    ];
    for (mistake, shadow, tells) in table {
        assert!(!shadow.is_conserved(), "{mistake}: {shadow:?}");
        let first = shadow.powers.iter().zip([2.0, 4.0, 6.0]).position(|(power, exact)| *power < exact - 0.5);
        assert_eq!(first, Some(tells), "{mistake}: {shadow:?}");
    }
}

#[test]
fn a_start_at_rest_measures_nothing() {
    let nothing = shadow(&HenonHeiles {}, Verlet, Phase::new([0.0, 0.0], [0.0, 0.0]), 0.05);
    assert!(matches!(nothing, Err(CheckError::TooFewPoints { .. })), "{nothing:?}");
}
