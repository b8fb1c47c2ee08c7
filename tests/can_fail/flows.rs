//! Flows of parts that are no shears: what is wrong with one is told by its name and by the law that it breaks.

use crate::parts::{Anharmonic, Fault, Turning};
use integrator_core::{
    GaussLegendre4, KahanLi8, Phase, Verlet, Yoshida4,
    check::{self, CertifyError, CheckError, FlowErrors, FlowLaw, Goal, Shortfall, certify},
};

const START: Phase<[f64; 1]> = Phase { q: [0.8], p: [0.3] };

/// The parts and laws that a certificate is refused for.
fn broken(fault: Fault) -> Vec<(String, FlowLaw)> {
    let system = Anharmonic { mass: 2.0, frequency: 3.0, fault };
    match certify::<_, _, f64>(&system, Verlet, START, 0.05) {
        Ok(certificate) => panic!("certified: {certificate}"),
        Err(CertifyError::Refused { shortfalls, .. }) => {
            let laws = shortfalls.into_iter().filter_map(|shortfall| match shortfall {
                Shortfall::Flow { part, law, .. } => Some((part, law)),
                _ => None,
            });
            laws.collect()
        }
        Err(error) => panic!("{error}"),
    }
}

#[test]
fn right_flows_are_certified() {
    let system = Anharmonic { mass: 2.0, frequency: 3.0, fault: Fault::None };
    let certificates = [
        certify::<_, _, f64>(&system, Verlet, START, 0.05),
        certify::<_, _, f64>(&system, Yoshida4, START, 0.05),
        certify::<_, _, f64>(&system, Verlet, START, -1.7),
    ];
    for certificate in certificates {
        let certificate = certificate.unwrap_or_else(|error| panic!("{error}"));
        let FlowErrors { symplecticity, inverse, addition, energy, generator, .. } =
            certificate.flows.expect("parts that are no T and V");
        for error in [symplecticity, inverse, addition, energy, generator] {
            assert!((0.0..0.25).contains(&error), "{certificate}");
        }
        assert!(certificate.gradient_error.is_nan() && certificate.stability.is_none(), "{certificate}");
        assert!(certificate.to_string().contains("flows of the parts"), "{certificate}");
    }
}

/// Each of the faults, with all laws that it breaks and no other.
#[test]
fn each_law_can_be_broken() {
    use FlowLaw::{Addition, Energy, Generator, Inverse, Symplecticity};
    let table: [(Fault, &str, &[FlowLaw]); 6] = [
        (Fault::Damped, "oscillator", &[Symplecticity, Energy, Generator]),
        (Fault::Faster, "oscillator", &[Generator]),
        (Fault::HalfAngle, "oscillator", &[Addition]),
        (Fault::Late, "oscillator", &[Inverse, Addition]),
        (Fault::Unscaled, "oscillator", &[Energy, Generator]),
        (Fault::Stronger, "rest", &[Generator]),
    ];
    for (fault, part, laws) in table {
        let mut found = broken(fault);
        found.sort_by_key(|(_, law)| *law as u8);
        let mut expected: Vec<_> = laws.iter().map(|law| (part.to_owned(), *law)).collect();
        expected.sort_by_key(|(_, law)| *law as u8);
        assert_eq!(found, expected, "{fault:?}");
    }
}

/// Until rounding hides it: `course.rs` allows for eight times some roundings of 64 ε each, which is 1e-12 for numbers near one.
#[test]
fn a_flow_that_is_wrong_by_little_is_refused() {
    for part in [1e-7, 1e-8, 1e-9, 1e-10, 1e-11] {
        for (fault, name) in [
            (Fault::FasterBy(part), "oscillator"),
            (Fault::FasterBy(-part), "oscillator"),
            (Fault::StrongerBy(part), "rest"),
        ] {
            assert_eq!(broken(fault), [(name.to_owned(), FlowLaw::Generator)], "{fault:?}");
        }
    }
}

/// Methods that take the whole field of H are held against its energy, too.
#[test]
fn a_field_of_another_hamiltonian_or_of_none_is_refused() {
    let certified = |fault| {
        let system = Anharmonic { mass: 2.0, frequency: 3.0, fault };
        certify::<_, _, f64>(&system, GaussLegendre4, START, 0.05)
    };
    let right = certified(Fault::None);
    assert!(right.is_ok(), "{}", right.expect_err("a refusal"));
    let shortfalls = |fault| match certified(fault) {
        Ok(certificate) => panic!("{fault:?} is certified: {certificate}"),
        Err(CertifyError::Refused { shortfalls, .. }) => shortfalls,
        Err(error) => panic!("{error}"),
    };
    let found = shortfalls(Fault::FieldOfAnother);
    assert!(matches!(found[..], [Shortfall::Order { .. }]), "{found:?}");
    let found = shortfalls(Fault::FieldOfNone);
    assert!(
        matches!(found[..], [Shortfall::Symplecticity { .. }, Shortfall::Order { .. }, Shortfall::EnergyDrift(_)]),
        "{found:?}"
    );
}

#[test]
fn a_broken_law_reads_well() {
    let system = Anharmonic { mass: 2.0, frequency: 3.0, fault: Fault::HalfAngle };
    let error = certify::<_, _, f64>(&system, Verlet, START, 0.05).expect_err("a refusal");
    let text = error.to_string();
    let line = text.lines().nth(1).expect("a line");
    assert!(
        line.starts_with("  the flow of `oscillator` does not add up: two flows in sequence differ from one flow"),
        "{text}"
    );
}

#[test]
fn a_flow_that_is_not_finite_is_reported() {
    let system = Anharmonic { mass: 2.0, frequency: 3.0, fault: Fault::Undefined };
    let Err(CertifyError::Refused { shortfalls, .. }) = certify::<_, _, f64>(&system, Verlet, START, 0.05) else {
        panic!("neither certified nor refused");
    };
    assert!(shortfalls.iter().all(|shortfall| matches!(shortfall, Shortfall::Unmeasured { .. })), "{shortfalls:?}");
    assert!(check::gradient_error::<_, f64>(&system, START, 0.0).is_err());
}

/// The middle flows share an energy with the last one, and are held against it together.
#[test]
fn three_parts_lead_where_their_energies_drive() {
    let start = Phase { q: [0.8, -0.2], p: [0.3, 0.5] };
    let error = |rate| check::gradient_error::<_, f64>(&Turning { rate, stated: 0.7 }, start, 0.0).expect("finite");
    assert!(error(0.7) < 1e-8, "{}", error(0.7));
    assert!(error(0.71) > 1e-3, "{}", error(0.71));
}

#[test]
fn checks_for_separable_systems_are_refused() {
    let system = Anharmonic { mass: 2.0, frequency: 3.0, fault: Fault::None };
    let refused = check::stability::<_, _, f64>(&system, Verlet, START, 0.05);
    assert!(matches!(refused, Err(CheckError::NotSeparable { .. })), "{refused:?}");
}

/// The unit of the energy is that of a kinetic energy, whichever part comes first.
#[test]
fn the_energy_is_measured_in_units_of_motion() {
    let system = Anharmonic { mass: 2.0, frequency: 3.0, fault: Fault::None };
    let drift = check::energy_drift::<_, _, f64>(&system, KahanLi8, START, 0.05, 256).expect("finite");
    assert!(drift.is_bounded() && (0.1..0.9).contains(&drift.mean_kinetic), "{drift:?}");
    let ranking = check::choose::<_, f64>(&system, START, 10.0, Goal::Energy(1e-8)).expect("a ranking");
    assert!(!ranking.choices().is_empty());
}

/// Messages have the names of the parts.
#[test]
fn an_energy_that_is_not_finite_has_the_name_of_its_part() {
    use integrator_core::{Error, Hamiltonian};
    let system = Anharmonic { mass: 0.0, frequency: 3.0, fault: Fault::None };
    let refused = system.run(START, 0.05);
    assert!(matches!(refused, Err(Error::Energy { function: "oscillator", .. })), "{:?}", refused.err());
}

/// The angle by which a flow turns, by the right one.
type Angle = fn(f64) -> f64;

/// An oscillator and the rest, whose first flow the user wrote: right ones and wrong ones, by the angle and the scale of
/// the ellipse.
#[derive(Clone)]
struct Own {
    angle: Angle,
    scale: f64,
}

#[integrator_core::hamiltonian(split = oscillator + rest, compose = Yoshida4)]
impl Own {
    fn oscillator(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        q.iter().zip(p).map(|(q, p)| (0.5 * p * p + 2.0 * q * q).cosh()).sum()
    }
    fn rest(&self, q: [f64; 2]) -> f64 {
        0.25 * (q[0] * q[0] * q[1] * q[1]).sin()
    }
    /// The oscillator of a pair has the frequency of its energy's slope, which stays.
    #[flow(oscillator)]
    fn turn(&self, q: &mut [f64; 2], p: &mut [f64; 2], duration: f64) {
        for (q, p) in q.iter_mut().zip(p) {
            let frequency = 2.0 * (0.5 * *p * *p + 2.0 * *q * *q).sinh();
            let (sine, cosine) = (self.angle)(frequency * duration).sin_cos();
            (*q, *p) = (cosine * *q + sine * *p / self.scale, cosine * *p - sine * self.scale * *q);
        }
    }
}

#[test]
fn flows_of_the_user_are_measured() {
    let start = Phase { q: [0.4, -0.2], p: [0.3, 0.5] };
    let outcome = |angle, scale| certify::<_, _, f64>(&Own { angle, scale }, Yoshida4, start, 0.05);
    outcome(|angle| angle, 2.0).unwrap_or_else(|error| panic!("{error}"));
    let wrong: [(Angle, f64, FlowLaw); 4] = [
        (|angle| 1.000_001 * angle, 2.0, FlowLaw::Generator),
        (|angle| 2.0 * (angle / 2.0).atan(), 2.0, FlowLaw::Addition),
        (|angle| angle + 1e-6 * angle * angle, 2.0, FlowLaw::Inverse),
        (|angle| angle, 2.000_001, FlowLaw::Energy),
    ];
    for (angle, scale, expected) in wrong {
        let Err(CertifyError::Refused { shortfalls, .. }) = outcome(angle, scale) else {
            panic!("{expected:?} passes")
        };
        let found = shortfalls.iter().any(|shortfall| {
            matches!(shortfall, Shortfall::Flow { part, law, .. } if part == "oscillator" && *law == expected)
        });
        assert!(found, "{expected:?} is not among {shortfalls:?}");
    }
}

/// A flow of the user on a body so light that its momenta are a millionth of its positions.
#[derive(Clone)]
struct Light;

#[integrator_core::hamiltonian(split = oscillator + rest, compose = Yoshida4)]
impl Light {
    fn oscillator(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        1e-6 * (0.5 * (1e6 * p[0]).powi(2) + 2.0 * q[0].powi(2)).cosh()
    }
    fn rest(&self, q: [f64; 1]) -> f64 {
        1e-7 * q[0].sin()
    }
    #[flow(oscillator)]
    fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {
        let speed = 1e6 * p[0];
        let (sine, cosine) = (2.0 * (0.5 * speed * speed + 2.0 * q[0] * q[0]).sinh() * duration).sin_cos();
        (q[0], p[0]) = (cosine * q[0] + sine * speed / 2.0, 1e-6 * (cosine * speed - 2.0 * sine * q[0]));
    }
}

#[test]
fn units_do_not_decide_on_flows_of_the_user() {
    let outcome = certify::<_, _, f64>(&Light, Yoshida4, Phase { q: [0.4], p: [3e-7] }, 0.05);
    outcome.unwrap_or_else(|error| panic!("{error}"));
}
