//! Right steppers, on nonlinear problems of every kind, are certified.

use crate::systems::{Driven, HenonHeiles, Kepler, Pendulum, Relativistic, Ring, Skewed};
use integrator_core::{
    __private::Composition,
    CalvoSanzSerna4, Chin4A, Euler, EulerAdjoint, Hamiltonian, KahanLi8, Phase, Ruth3, Suzuki4, TakahashiImada4,
    VelocityVerlet, Verlet, Yoshida4, Yoshida6,
    check::{Certificate, certify, observed_order, symplectic_defect_after},
};

/// Certifies one composition, from a plain and from a compensated start.
fn certified<H, X, const N: usize>(system: &H, composition: X, start: Phase<[f64; N]>, h: f64) -> [Certificate; 2]
where
    H: Hamiltonian<Coords = [f64; N]>,
    X: Composition<H>,
{
    let plain = certify::<H, X, f64>(system, composition, start, h);
    let compensated = Phase::compensated(start.q, start.p);
    let compensated = certify::<H, X, integrator_core::Compensated<f64>>(system, composition, compensated, h);
    [plain, compensated].map(|outcome| outcome.unwrap_or_else(|error| panic!("{error}")))
}

/// Certifies all compositions.
fn all_certified<H: Hamiltonian<Coords = [f64; N]>, const N: usize>(system: &H, start: Phase<[f64; N]>, h: f64) {
    let certificates = [
        certified(system, Euler, start, h),
        certified(system, EulerAdjoint, start, h),
        certified(system, Verlet, start, h),
        certified(system, VelocityVerlet, start, h),
        certified(system, Ruth3, start, h),
        certified(system, Yoshida4, start, h),
        certified(system, Suzuki4, start, h),
        certified(system, Yoshida6, start, h),
        certified(system, KahanLi8, start, h),
    ];
    for certificate in certificates.iter().flatten() {
        let excess = certificate.observed_order - f64::from(certificate.claimed_order);
        assert!(excess.abs() < 0.2, "{certificate}");
    }
}

#[test]
fn a_pendulum_with_mass_and_length() {
    all_certified(&Pendulum { mass: 2.5, length: 0.4, gravity: 9.81 }, Phase::new([2.0], [0.3]), 0.01);
}

/// Of each class that needs a quadratic `T` the cheapest one: Nyström, with force gradients, and processed.
#[test]
fn compositions_for_a_quadratic_kinetic_energy() {
    let start = Phase::new([0.1, -0.2], [0.3, 0.25]);
    let certificates = [
        certified(&HenonHeiles {}, CalvoSanzSerna4, start, 0.05),
        certified(&HenonHeiles {}, Chin4A, start, 0.05),
        certified(&HenonHeiles {}, TakahashiImada4, start, 0.05),
    ];
    for certificate in certificates.iter().flatten() {
        let excess = certificate.observed_order - f64::from(certificate.claimed_order);
        assert!(excess.abs() < 0.2, "{certificate}");
    }
}

#[test]
fn henon_heiles() {
    all_certified(&HenonHeiles {}, Phase::new([0.1, -0.2], [0.3, 0.25]), 0.05);
}

#[test]
fn kepler() {
    all_certified(&Kepler { mass: 0.5, attraction: 2.0 }, Phase::new([1.0, 0.0], [0.0, 0.8]), 0.01);
}

#[test]
fn a_kinetic_energy_that_is_not_quadratic() {
    all_certified(&Relativistic {}, Phase::new([1.5], [0.5]), 0.02);
}

/// As fast as light nearly everywhere, and turned back within a hundredth or a thousandth of that time: steps that follow such
/// a motion to a tenth show no order of theirs. It is looked for in shorter ones, down to the user's.
#[test]
fn a_motion_that_turns_within_a_thousandth_of_its_time() {
    for (start, h) in [(3.0, 0.1), (5.0, 0.02), (5.0, 0.001), (10.0, 0.005)] {
        certified(&Relativistic {}, KahanLi8, Phase::new([start], [0.0]), h);
    }
    for start in [3.0, 5.0] {
        certified(&Relativistic {}, Yoshida4, Phase::new([start], [0.0]), 0.02);
        certified(&Relativistic {}, Verlet, Phase::new([start], [0.0]), 0.02);
    }
    // What is too fast for these steps is to be followed by shorter ones.
    for (start, h) in [(30.0, 0.02), (10.0, 0.05)] {
        let refused = certify(&Relativistic {}, KahanLi8, Phase::new([start], [0.0]), h);
        let text = refused.expect_err("far too long a step").to_string();
        assert!(text.contains("use a smaller step"), "{text}");
    }
}

/// Neighbours part by more than any number at such a step: it is refused for what it does, and not for a bound that is no number.
#[test]
fn a_step_of_a_million_swings() {
    let pendulum = Pendulum { mass: 1.0, length: 1.0, gravity: 1.0 };
    let refused = certify(&pendulum, Yoshida4, Phase::new([1.0], [0.0]), 1e6);
    let text = refused.expect_err("far too long a step").to_string();
    assert!(text.contains("use a smaller step") && !text.contains("NaN"), "{text}");
}

#[test]
fn a_kinetic_energy_that_is_not_diagonal() {
    all_certified(&Skewed {}, Phase::new([0.4, 1.0], [0.2, -0.3]), 0.02);
}

#[test]
fn a_hamiltonian_that_reads_the_time() {
    all_certified(&Driven {}, Phase::new([0.5], [0.0]), 0.02);
}

#[test]
fn a_body_that_falls_from_far_away() {
    let eccentricity: f64 = 0.9;
    let momentum = ((1.0 - eccentricity) / (1.0 + eccentricity)).sqrt();
    let start = Phase::new([1.0 + eccentricity, 0.0], [0.0, momentum]);
    certified(&Kepler { mass: 1.0, attraction: 1.0 }, KahanLi8, start, 1e-3);
}

#[test]
fn units_as_small_and_as_large_as_they_come() {
    let kepler = |mass: f64, attraction: f64, h| {
        // The momentum is that of a circular orbit of radius one, and a little more.
        let momentum = 1.1 * (mass * attraction).sqrt();
        certified(&Kepler { mass, attraction }, Yoshida4, Phase::new([1.0, 0.0], [0.0, momentum]), h);
    };
    kepler(1e20, 1e40, 1e-12);
    kepler(1e-20, 1e-100, 1e38);
    kepler(1e-9, 1.0, 1e-6);
}

/// The step that a user asks for may be far from what the problem needs.
#[test]
fn a_step_far_too_fine_or_backwards() {
    let pendulum = Pendulum { mass: 2.0, length: 0.5, gravity: 9.81 };
    let start = Phase::new([2.0], [0.3]);
    for h in [1e-12, 1e-9, 1e-6, -1e-3, -0.1] {
        certified(&pendulum, Euler, start, h);
        certified(&pendulum, Verlet, start, h);
        certified(&pendulum, KahanLi8, start, h);
    }
}

#[test]
fn a_step_far_too_coarse_still_shows_the_order() {
    let pendulum = Pendulum { mass: 2.0, length: 0.5, gravity: 9.81 };
    let start = Phase::new([2.0], [0.3]);
    for h in [1.0, 1e3, 1e9] {
        for (order, claimed) in
            [(observed_order(&pendulum, Verlet, start, h), 2.0), (observed_order(&pendulum, KahanLi8, start, h), 8.0)]
        {
            let order = order.unwrap_or_else(|error| panic!("{error}"));
            assert!((order.slope - claimed).abs() < 0.1, "{order:?}");
        }
    }
}

#[test]
fn single_precision() {
    let start = Phase::new([0.7_f32, 0.0], [0.0, 1.2]);
    let kepler = Kepler { mass: 1.0, attraction: 1.0 };
    let certificate = certify(&kepler, Yoshida4, start, 0.01).unwrap_or_else(|error| panic!("{error}"));
    // The run rounds to single precision; the flows are proved beyond it.
    assert!(certificate.reversibility > 1e-9, "{certificate}");
    assert!(certificate.symplectic_defect < 1e-14, "{certificate}");
}

#[test]
fn a_certificate_reads_well() {
    let pendulum = Pendulum { mass: 2.0, length: 0.5, gravity: 9.81 };
    let certificate = certify(&pendulum, Verlet, Phase::new([2.0], [0.3]), 0.01).expect("a certificate");
    let text = certificate.to_string();
    for line in [
        "Verlet on can_fail::systems::Pendulum, h = 0.01",
        "  symplectic defect  ",
        "  observed order     2.00 (claimed 2; ",
        "  reversibility      ",
        "  energy drift       bounded: ",
        "  gradient error     ",
        "  stability          h·ω is at most ",
    ] {
        assert!(text.lines().any(|present| present.starts_with(line)), "{line:?} is not in\n{text}");
    }
}

#[test]
fn many_steps_in_a_row_stay_symplectic() {
    let henon_heiles = HenonHeiles {};
    let start = Phase::new([0.1, -0.2], [0.3, 0.25]);
    let defect = symplectic_defect_after(&henon_heiles, Yoshida4, start, 0.05, 1000).expect("a defect");
    // Regular motion stretches tangents in proportion to time, 50 here, and the form by its square; each of the 7000
    // flows rounds.
    assert!(defect < 7000.0 * 2500.0 * f64::EPSILON, "{defect:e}");
}

/// Edges lie where steps end, two of which fit into a magnet: kicks at the ends of steps belong to either side, and stages
/// that read the clock outside of their step go on with its formula.
#[test]
fn magnets_of_a_ring() {
    let (ring, start, h) = (Ring { cell: 1.0 }, Phase::new([1.0], [0.3]), 0.125);
    all_certified(&ring, start, h);
    for certificate in
        [certified(&ring, CalvoSanzSerna4, start, h), certified(&ring, TakahashiImada4, start, h)].iter().flatten()
    {
        assert!((certificate.observed_order - 4.0).abs() < 0.2, "{certificate}");
    }
}
