//! What goes wrong somewhere along the orbit is found there, and what is only hard to follow is not taken for it.

use crate::systems::{Driven, Expanding, HenonHeiles, Kepler, Pendulum, Relativistic, Rough, Skewed, Undefined};
use integrator_core::{
    __private::Composition,
    Error, Hamiltonian, KahanLi8, Phase, Verlet, Yoshida4,
    check::{
        self, Certificate, CertifyError, CheckError, Shortfall, certify, choose, energy_drift, global_error,
        observed_order, poisson_bracket, reversibility, stability, symplectic_defect, symplectic_defect_after,
    },
};

const ROUGH: Rough = Rough { kink: 0.0, jump: 0.0, at: 0.0 };

/// What is certified, or not, with its words.
fn outcome<H, X, const N: usize>(
    system: &H,
    composition: X,
    start: Phase<[f64; N]>,
    h: f64,
) -> Result<Certificate, (Vec<Shortfall>, String)>
where
    H: Hamiltonian<Coords = [f64; N]>,
    X: Composition<H>,
{
    certify::<H, X, f64>(system, composition, start, h).map_err(|error| match &error {
        CertifyError::Refused { shortfalls, .. } => (shortfalls.clone(), error.to_string()),
        _ => panic!("{error}"),
    })
}

/// A kink is met within a quarter of a period or later. However the step divides the time until then, the order is
/// lost, and not before.
#[test]
fn a_kink_on_the_orbit_is_found_where_it_is() {
    for (kink, at) in [(1.0, 0.0), (1e-3, 0.0), (1.0, 0.77), (-0.2, -0.5)] {
        // From rest at 1 about the centre -k: the kink is where 1 + k turns into a + k.
        let met = f64::acos((at + kink) / (1.0 + kink));
        for h in [1e-5, 1e-3, 0.02, 0.1] {
            let system = Rough { kink, at, ..ROUGH };
            let start = Phase::new([1.0], [0.0]);
            for refused in [outcome(&system, Yoshida4, start, h), outcome(&system, KahanLi8, start, h)] {
                let Err((shortfalls, text)) = refused else { panic!("kink {kink} at {at}, h = {h}: {refused:?}") };
                let time = shortfalls.iter().find_map(|shortfall| match shortfall {
                    Shortfall::OrderLost { time, .. } => Some(*time),
                    _ => None,
                });
                assert!(time.is_none_or(|time| time > met - 0.01), "{met}: {text}");
                assert!(!text.contains("NaN"), "{text}");
            }
        }
    }
}

#[test]
fn a_low_order_fails_certification_at_a_kink_too() {
    for h in [1e-3, 0.02] {
        for kink in [1.0, 0.1] {
            let refused = outcome(&Rough { kink, ..ROUGH }, Verlet, Phase::new([1.0], [0.0]), h);
            assert!(refused.is_err(), "h = {h}: {refused:?}");
        }
    }
}

/// The force of a potential that jumps is that of a smooth one, which every composition follows with its order.
#[test]
fn a_jump_of_the_potential_is_an_energy_that_does_not_shrink() {
    for h in [1e-3, 0.02] {
        let (system, start) = (Rough { jump: 0.1, at: -0.3, ..ROUGH }, Phase::new([1.0], [0.0]));
        for refused in [outcome(&system, Verlet, start, h), outcome(&system, KahanLi8, start, h)] {
            let Err((shortfalls, text)) = refused else { panic!("h = {h}: {refused:?}") };
            let explained = |shortfall: &Shortfall| !matches!(shortfall, Shortfall::EnergyNotExplained { .. });
            assert!(!shortfalls.iter().all(explained), "{text}");
            assert!(
                text.contains(
                    "the energy deviates by 2.0e-1 of the kinetic energy (or that of the first part) in steps of"
                ),
                "{text}"
            );
        }
    }
}

#[test]
fn a_comet_in_steps_too_long_for_it_is_another_one() {
    let (e, comet) = (0.99_f64, Kepler { mass: 1.0, attraction: 1.0 });
    let far = Phase::new([1.0 + e, 0.0], [0.0, ((1.0 - e) / (1.0 + e)).sqrt()]);
    let near = Phase::new([1.0 - e, 0.0], [0.0, ((1.0 + e) / (1.0 - e)).sqrt()]);
    for (start, h) in [(far, 0.005), (near, 0.01)] {
        assert!(outcome(&comet, Verlet, start, h).is_err());
        assert!(outcome(&comet, Yoshida4, start, h).is_err());
        assert!(outcome(&comet, KahanLi8, start, h).is_err());
    }
    let certified = outcome(&comet, Yoshida4, near, 1e-5);
    assert!(certified.is_ok(), "{certified:?}");
}

/// Smooth motions, easy and hard ones, in steps from far too fine to as coarse as they bear.
#[test]
fn smooth_motions_are_certified() {
    fn all<H: Hamiltonian<Coords = [f64; N]>, const N: usize>(system: &H, start: Phase<[f64; N]>, steps: &[f64]) {
        for &h in steps {
            for certified in [
                outcome(system, Verlet, start, h),
                outcome(system, Yoshida4, start, h),
                outcome(system, KahanLi8, start, h),
            ] {
                let (_, text) = certified.err().unwrap_or_default();
                assert!(text.is_empty(), "h = {h}: {text}");
            }
        }
    }
    let pendulum = Pendulum { mass: 1.0, length: 1.0, gravity: 1.0 };
    all(&pendulum, Phase::new([2.0], [0.0]), &[1e-9, 1e-4, 0.01]);
    all(&pendulum, Phase::new([0.0], [2.5]), &[0.3]);
    all(&pendulum, Phase::new([0.0], [1.999_999_9]), &[0.05]);
    all(&HenonHeiles {}, Phase::new([0.1, -0.2], [0.3, 0.25]), &[0.2]);
    // Chaotic.
    all(&HenonHeiles {}, Phase::new([0.0, -0.15], [0.54, 0.1]), &[0.05]);
    let kepler = Kepler { mass: 1.0, attraction: 1.0 };
    for e in [0.0_f64, 0.5, 0.9] {
        let far = Phase::new([1.0 + e, 0.0], [0.0, ((1.0 - e) / (1.0 + e)).sqrt()]);
        let near = Phase::new([1.0 - e, 0.0], [0.0, ((1.0 + e) / (1.0 - e)).sqrt()]);
        for start in [far, near] {
            all(&kepler, start, &[1e-3]);
        }
    }
    all(&Relativistic {}, Phase::new([1.5], [0.5]), &[0.1]);
    all(&Skewed {}, Phase::new([0.4, 1.0], [0.2, -0.3]), &[0.1]);
    all(&Driven {}, Phase::new([0.5], [0.0]), &[0.1]);
}

/// What ends the run comes first, once, and no NaN is shown.
#[test]
fn a_refusal_leads_with_its_cause() {
    // It leans to the left before it has moved for long.
    let Err((shortfalls, text)) = outcome(&Undefined {}, Verlet, Phase::new([1.0], [0.0]), 0.01) else {
        panic!("certified")
    };
    assert!(matches!(shortfalls[0], Shortfall::Unmeasured { reason: CheckError::Run(_), .. }), "{text}");
    assert!(text.lines().nth(1).is_some_and(|line| line.contains(" could not be measured: ")), "{text}");
    assert!(!text.contains("NaN,") && !text.contains("NaN (") && !text.contains("NaN exceeds"), "{text}");
}

/// A motion that does not exist at time 0 is measured where it does, by every check.
#[test]
fn a_start_includes_its_time() {
    let (system, start, h) = (Expanding {}, Phase::new([1.0], [0.2]), 0.01);
    let refused = certify::<_, _, f64>(&system, Yoshida4, start, h).expect_err("no motion");
    assert!(matches!(refused, CertifyError::Run(Error::Energy { time: 0.0, .. })), "{refused}");
    assert_eq!(refused.to_string().lines().count(), 2, "an error and its remedy: {refused}");

    let later = start.at_time(1.5);
    let certificate = certify::<_, _, f64>(&system, Yoshida4, later, h).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(certificate.time, 1.5);
    assert!(certificate.to_string().contains("h = 0.01, from t = 1.5\n"), "{certificate}");
    let order = observed_order::<_, _, f64>(&system, KahanLi8, later, h).expect("an order");
    assert!((order.slope - 8.0).abs() < 0.2, "{order:?}");
    assert!(symplectic_defect::<_, _, f64>(&system, Yoshida4, later, h).is_ok_and(|defect| defect < 1e-14));
    assert!(symplectic_defect_after::<_, _, f64>(&system, Yoshida4, later, h, 9).is_ok_and(|defect| defect < 1e-13));
    assert!(poisson_bracket::<_, _, f64>(&system, Yoshida4, later, h, 0).is_ok_and(|one| (one - 1.0).abs() < 1e-14));
    assert!(reversibility::<_, _, f64>(&system, Yoshida4, later, h, 64).is_ok_and(|distance| distance < 1e-13));
    assert!(stability::<_, _, f64>(&system, Yoshida4, later, h).is_ok_and(|found| found.time >= 1.5));
    let error = global_error::<_, _, f64>(&system, KahanLi8, later, h, 64).expect("a reference");
    assert!(error.distance < 1e-12, "{error:?}");
    let ranking = choose::<_, f64>(&system, later, 2.0, check::Goal::Trajectory(1e-3));
    assert!(ranking.as_ref().is_ok_and(|ranking| ranking.best().error <= 1e-3), "{ranking:?}");

    // Where H does not read the time, none makes a difference.
    let (kepler, start) = (Kepler { mass: 1.0, attraction: 1.0 }, Phase::new([1.0, 0.0], [0.0, 1.1]));
    let drift = |time: f64| energy_drift::<_, _, f64>(&kepler, Verlet, start.at_time(time), 0.01, 1024).expect("a run");
    assert_eq!(drift(0.0), energy_drift::<_, _, f64>(&kepler, Verlet, start, 0.01, 1024).expect("a run"));
    assert_eq!(drift(4096.0).deviation, drift(0.0).deviation);
    let nowhen = certify::<_, _, f64>(&kepler, Verlet, start.at_time(f64::NAN), 0.01);
    assert!(matches!(nowhen, Err(CertifyError::Run(Error::Time { .. }))), "{nowhen:?}");
}
