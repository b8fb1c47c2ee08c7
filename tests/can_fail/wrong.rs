//! Wrong steppers are refused, each by the checks that can see its mistake.

use crate::{
    schemes::{EulerThatClaims2, EulerThatClaimsSymmetry, Late, Lopsided, Strong, Unmerged},
    systems::{Braked, Driven, Explicit, Hurried, Kinked, Miscounted, Pendulum, Repelled, Ring, Undefined},
};
use integrator_core::{
    __private::Composition,
    Error, Euler, Hamiltonian, KahanLi8, Phase, Verlet, Yoshida4,
    check::{self, CertifyError, CheckError, Course, Shortfall, certify},
    hamiltonian,
};

const PENDULUM: Pendulum = Pendulum { mass: 2.0, length: 0.5, gravity: 9.81 };

/// What a wrong stepper is refused for.
fn shortfalls<H, X, const N: usize>(system: &H, composition: X, start: Phase<[f64; N]>, h: f64) -> Vec<Shortfall>
where
    H: Hamiltonian<Coords = [f64; N]>,
    X: Composition<H>,
{
    match certify::<H, X, f64>(system, composition, start, h) {
        Ok(certificate) => panic!("certified: {certificate}"),
        Err(CertifyError::Refused { shortfalls, .. }) => shortfalls,
        Err(error) => panic!("{error}"),
    }
}

macro_rules! assert_among {
    ($shortfalls:expr, $($kind:pat),+) => {{
        let shortfalls = &$shortfalls;
        $(
            let found = shortfalls.iter().any(|shortfall| matches!(shortfall, $kind));
            assert!(found, "{} is not among {shortfalls:?}", stringify!($kind));
        )+
    }};
}

#[test]
fn explicit_euler() {
    let start = Phase::new([2.0], [0.0]);
    let shortfalls = shortfalls(&Explicit {}, Euler, start, 0.01);
    assert_among!(shortfalls, Shortfall::Symplecticity { .. }, Shortfall::EnergyDrift(_));
}

#[test]
fn a_sign_error_in_the_kick() {
    let shortfalls = shortfalls(&Repelled {}, Verlet, Phase::new([2.0], [0.0]), 0.01);
    assert_among!(shortfalls, Shortfall::EnergyLost(_), Shortfall::Gradient { .. });
}

#[test]
fn a_wrong_factor_in_one_component_of_a_gradient() {
    let shortfalls = shortfalls(&Miscounted {}, Yoshida4, Phase::new([0.1, -0.2], [0.3, 0.25]), 0.05);
    assert_among!(shortfalls, Shortfall::Symplecticity { .. }, Shortfall::Gradient { .. });
}

#[test]
fn an_order_1_scheme_that_claims_2() {
    let shortfalls = shortfalls(&PENDULUM, EulerThatClaims2, Phase::new([2.0], [0.3]), 0.01);
    assert!(matches!(shortfalls[..], [Shortfall::Order { claimed: 2, observed }] if 0.9 < observed && observed < 1.1));
    let text = shortfalls[0].to_string();
    assert!(text.starts_with("observed order 1.00 falls short of the claimed order 2\nhelp: "), "{text}");
}

#[test]
fn an_asymmetric_scheme_that_claims_symmetry() {
    let start = Phase::new([2.0], [0.3]);
    // At a step of a millionth the error itself is small beside the rounding: the check must not depend on it.
    for h in [0.01, 1e-6] {
        let euler = shortfalls(&PENDULUM, EulerThatClaimsSymmetry, start, h);
        assert!(matches!(euler[..], [Shortfall::Reversibility { .. }]), "{euler:?}");
        let lopsided = shortfalls(&PENDULUM, Lopsided, start, h);
        assert!(matches!(lopsided[..], [Shortfall::Reversibility { .. }]), "{lopsided:?}");
    }
}

#[test]
fn a_time_that_runs_twice_as_fast() {
    let shortfalls = shortfalls(&Hurried {}, Verlet, Phase::new([0.5], [0.0]), 0.02);
    assert_among!(shortfalls, Shortfall::Gradient { .. });
}

#[test]
fn a_time_that_is_read_late() {
    let shortfalls = shortfalls(&Driven {}, Late, Phase::new([0.5], [0.0]), 0.02);
    assert_among!(shortfalls, Shortfall::Order { .. }, Shortfall::Reversibility { .. });
}

#[test]
fn a_scheme_that_converges_to_another_motion() {
    let shortfalls = shortfalls(&PENDULUM, Strong, Phase::new([2.0], [0.3]), 0.01);
    assert_among!(shortfalls, Shortfall::Order { .. });
}

#[test]
fn another_motion_is_far_from_the_exact_one_whatever_the_step() {
    let distance = |h: f64| {
        let measured = check::global_error(&PENDULUM, Strong, Phase::new([2.0], [0.3]), h, (2.0 / h) as u64);
        measured.expect("a reference").distance
    };
    let [coarse, fine] = [0.01, 0.0005].map(distance);
    assert!(fine > 0.9 * coarse && fine > 1e-3, "{coarse} and {fine}");
}

#[test]
fn a_motion_without_a_reference_solution_is_reported() {
    // A thousand periods by flows alone.
    let measured = check::global_error(&PENDULUM, Verlet, Phase::new([2.0], [0.3]), 0.01, 200_000);
    assert!(matches!(measured, Err(CheckError::NoReference { span: 2e3, .. })), "{measured:?}");
}

#[test]
fn a_drift_lost_between_steps() {
    let shortfalls = shortfalls(&PENDULUM, Unmerged, Phase::new([2.0], [0.3]), 0.01);
    assert_among!(shortfalls, Shortfall::Order { .. });
}

#[test]
fn friction() {
    let shortfalls = shortfalls(&Braked {}, KahanLi8, Phase::new([2.0], [0.0]), 0.05);
    assert_among!(shortfalls, Shortfall::Symplecticity { .. }, Shortfall::EnergyDrift(_));
}

/// What goes wrong a little in each step goes wrong in proportion to the time.
#[test]
fn a_drift_is_distinguished_from_an_oscillation() {
    let start = Phase::new([2.0], [0.0]);
    let course = |drift: Result<check::EnergyDrift, CheckError>| drift.expect("finite").course;
    assert_eq!(course(check::energy_drift(&Braked {}, KahanLi8, start, 0.05, 1024)), Course::Drift);
    assert_eq!(course(check::energy_drift(&Explicit {}, Euler, start, 0.01, 1024)), Course::Drift);
    assert_eq!(course(check::energy_drift(&PENDULUM, Verlet, start, 0.01, 1024)), Course::Bounded);
    assert_eq!(course(check::energy_drift(&PENDULUM, Euler, start, 0.01, 1024)), Course::Bounded);
}

/// The defect of a right stepper grows with the number of its roundings, and that of a wrong one with the steps.
#[test]
fn many_steps_stay_symplectic_up_to_their_roundings() {
    let start = Phase::new([1e-3], [0.0]);
    for steps in [1, 8, 64, 512, 4096] {
        // Tangents of so small a swing are not stretched; 3 flows to a step of Verlet round 4 numbers each.
        let right = check::symplectic_defect_after(&PENDULUM, Verlet, start, 0.01, steps).expect("a defect");
        assert!(right <= 12.0 * steps as f64 * f64::EPSILON, "{right:e} after {steps} steps");
        let wrong = check::symplectic_defect_after(&Braked {}, Verlet, start, 0.01, steps).expect("a defect");
        // Friction shrinks every area by 1e-3 per unit of time.
        let lost = 1.0 - (-1e-5 * steps as f64).exp();
        assert!((wrong / lost - 1.0).abs() < 1e-3, "{wrong:e} after {steps} steps");
    }
}

#[test]
fn an_energy_that_is_nan() {
    let shortfalls = shortfalls(&Undefined {}, Verlet, Phase::new([1.0], [0.0]), 0.01);
    assert_among!(shortfalls, Shortfall::Unmeasured { .. });
}

#[test]
fn a_start_at_rest_measures_nothing_and_certifies_nothing() {
    let shortfalls = shortfalls(&PENDULUM, Verlet, Phase::new([0.0], [0.0]), 0.01);
    assert!(matches!(
        shortfalls[..],
        [Shortfall::Unmeasured { check: "the order", reason: CheckError::TooFewPoints { .. } }]
    ));
}

#[test]
fn steps_that_are_exact_show_no_order() {
    struct Free;

    #[hamiltonian]
    impl Free {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0] / 2.0
        }
        fn potential(&self, _: [f64; 1]) -> f64 {
            0.0
        }
    }
    for start in [Phase::new([0.5], [0.25]), Phase::new([0.3], [0.1])] {
        let shortfalls = shortfalls(&Free, Yoshida4, start, 0.1);
        assert!(
            matches!(shortfalls[..], [Shortfall::Unmeasured { reason: CheckError::TooFewPoints { found: 0, .. }, .. }]),
            "{shortfalls:?}"
        );
    }
}

#[test]
fn a_kink_has_no_gradient() {
    let at_the_kink = check::gradient_error(&Kinked {}, Phase::new([0.0], [0.5]), 0.0);
    assert!(matches!(at_the_kink, Err(CheckError::NotDifferentiable { energy: "V", index: 0, .. })), "{at_the_kink:?}");
    assert_eq!(check::gradient_error(&Kinked {}, Phase::new([0.25], [0.5]), 0.0), Ok(0.0));
}

#[test]
fn a_refusal_reads_well() {
    let error = certify(&PENDULUM, EulerThatClaims2, Phase::new([2.0], [0.3]), 0.01).expect_err("a refusal");
    let text = error.to_string();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "no certificate for can_fail::systems::Pendulum:");
    assert_eq!(lines[1], "  observed order 1.00 falls short of the claimed order 2");
    assert!(lines[2].starts_with("    help: ") && lines[3].starts_with("    note: "), "{text}");
    assert_eq!(lines[4], "measured: EulerThatClaims2 on can_fail::systems::Pendulum, h = 0.01");
}

#[test]
fn bad_input_is_an_error_of_every_check() {
    let start = Phase::new([2.0], [0.3]);
    let kept = |error: CheckError| matches!(error, CheckError::Run(Error::Step { .. } | Error::Start { .. }));
    for (start, h) in [
        (start, 0.0),
        (start, f64::NAN),
        (start, f64::INFINITY),
        (Phase::new([f64::NAN], [0.3]), 0.01),
        (Phase::new([2.0], [f64::INFINITY]), 0.01),
    ] {
        assert!(check::symplectic_defect(&PENDULUM, Verlet, start, h).is_err_and(kept));
        assert!(check::observed_order(&PENDULUM, Verlet, start, h).is_err_and(kept));
        assert!(check::reversibility(&PENDULUM, Verlet, start, h, 16).is_err_and(kept));
        assert!(check::energy_drift(&PENDULUM, Verlet, start, h, 1024).is_err_and(kept));
        assert!(check::global_error(&PENDULUM, Verlet, start, h, 1024).is_err_and(kept));
        assert!(matches!(certify(&PENDULUM, Verlet, start, h), Err(CertifyError::Run(_))));
    }
    assert!(check::gradient_error(&PENDULUM, Phase::new([f64::NAN], [0.3]), 0.0).is_err_and(kept));
    assert_eq!(
        check::gradient_error(&PENDULUM, start, f64::INFINITY),
        Err(CheckError::Run(Error::Time { time: f64::INFINITY }))
    );
    assert_eq!(
        check::energy_drift(&PENDULUM, Verlet, start, 0.01, 3),
        Err(CheckError::TooFewSteps { steps: 3, needed: 64 })
    );
    assert_eq!(check::energy_drift(&Driven {}, Verlet, start, 0.01, 1024), Err(CheckError::NotAutonomous));
    assert_eq!(
        check::global_error(&PENDULUM, Verlet, start, 0.01, 0),
        Err(CheckError::TooFewSteps { steps: 0, needed: 1 })
    );
}

#[test]
fn an_edge_in_time_inside_of_a_step() {
    let shortfalls = shortfalls(&Ring { cell: 1.02 }, Yoshida4, Phase::new([1.0], [0.3]), 0.125);
    let [Shortfall::Unmeasured { check: "the order", reason: CheckError::EdgeInside { time, .. } }] = shortfalls[..]
    else {
        panic!("{shortfalls:?}");
    };
    assert_eq!(time, 0.255, "a quarter of the cell, rounded like the formula");
    // In the first half of the first step, and in the middle of a step backwards, between two roundings of this middle.
    for (cell, begin, h, edge) in [(4e5, 99_999.95, 0.125, 1e5), (4.1, 2.05, -0.05, 1.025)] {
        let outcome = certify::<_, _, f64>(&Ring { cell }, Yoshida4, Phase::new([1.0], [0.3]).at_time(begin), h);
        let Err(CertifyError::Refused { shortfalls, .. }) = outcome else { panic!("certified: {outcome:?}") };
        let found = |shortfall: &Shortfall| matches!(shortfall, Shortfall::Unmeasured { reason: CheckError::EdgeInside { time, .. }, .. } if (time - edge).abs() < 1e-9);
        assert!(shortfalls.iter().any(found), "{shortfalls:?}");
    }
}
