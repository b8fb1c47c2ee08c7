//! Right steppers, on nonlinear problems of every kind, are certified.

use crate::systems::{Driven, HenonHeiles, Kepler, Pendulum, Relativistic, Skewed};
use integrator_core::{
    __private::Composition,
    Euler, EulerAdjoint, Hamiltonian, KahanLi8, Phase, Ruth3, Suzuki4, VelocityVerlet, Verlet, Yoshida4, Yoshida6,
    check::{Certificate, certify},
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
        println!("{certificate}");
        let excess = certificate.observed_order - f64::from(certificate.claimed_order);
        assert!(excess.abs() < 0.2, "{certificate}");
    }
}

#[test]
fn a_pendulum_with_mass_and_length() {
    all_certified(&Pendulum { mass: 2.5, length: 0.4, gravity: 9.81 }, Phase::new([2.0], [0.3]), 0.01);
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

#[test]
fn a_kinetic_energy_that_is_not_diagonal() {
    all_certified(&Skewed {}, Phase::new([0.4, 1.0], [0.2, -0.3]), 0.02);
}

#[test]
fn a_hamiltonian_that_reads_the_time() {
    all_certified(&Driven {}, Phase::new([0.5], [0.0]), 0.02);
}

/// The step that a user asks for may be far from what the problem needs.
#[test]
fn a_step_far_too_fine_and_one_far_too_coarse() {
    let pendulum = Pendulum { mass: 2.0, length: 0.5, gravity: 9.81 };
    let start = Phase::new([2.0], [0.3]);
    for h in [1e-12, 1e-9, 1e-6, 1e-3, -1e-3, 0.1, -0.1] {
        for c in [
            certified(&pendulum, Euler, start, h),
            certified(&pendulum, Verlet, start, h),
            certified(&pendulum, KahanLi8, start, h),
        ] {
            println!("{}", c[0]);
        }
    }
    for h in [1.0, 1e2, 1e6] {
        for order in [
            integrator_core::check::observed_order(&pendulum, Verlet, start, h),
            integrator_core::check::observed_order(&pendulum, KahanLi8, start, h),
        ] {
            println!("{order:?}");
        }
    }
}
