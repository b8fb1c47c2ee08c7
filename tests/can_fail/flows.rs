//! Flows of parts that are no shears: what is wrong with one is told by its name and by the law that it breaks.

use crate::parts::{Anharmonic, Fault, Turning};
use integrator_core::{
    KahanLi8, Phase, Verlet, Yoshida4,
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

#[test]
fn a_broken_law_reads_well() {
    let system = Anharmonic { mass: 2.0, frequency: 3.0, fault: Fault::HalfAngle };
    let error = certify::<_, _, f64>(&system, Verlet, START, 0.05).expect_err("a refusal");
    let text = error.to_string();
    let line = text.lines().nth(1).expect("a line");
    assert!(line.starts_with("  the flow of `oscillator` does not add up: in two pieces it leads elsewhere"), "{text}");
}

#[test]
fn a_flow_that_is_not_finite_is_told() {
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
fn what_belongs_to_kinetic_and_potential_energy_is_refused() {
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
