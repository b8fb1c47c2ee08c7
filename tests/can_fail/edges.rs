//! Motions at the edge of what can be measured: what is right is certified there, and what is wrong has one reason.

use crate::schemes::{EulerThatClaims2, Strong};
use integrator_core::{
    check::{CertifyError, CheckError, Shortfall, gradient_error},
    prelude::*,
};

/// Potentials in one dimension, by number.
struct Well {
    kind: i32,
    offset: f64,
}

#[hamiltonian]
impl Well {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        let (a, b) = (-0.5 * ((x - 2.0) / 0.6).powi(2), -0.5 * ((x + 2.0) / 0.6).powi(2));
        match self.kind {
            0 => x.tanh().powi(2),
            1 => x.tanh(),
            2 => -(-x * x).exp(),
            3 => 1.0 / (1.0 + x * x),
            4 => 1.0 / (1.0 + x.exp()),
            5 => self.offset - x.cos(),
            6 => self.offset + x * x / 2.0,
            8 => x * x / 2.0 + (x - 0.3).abs().powi(3),
            _ => 3.0 * (x - 2.0).powi(2) - (a.max(b) + ((a - a.max(b)).exp() + (b - a.max(b)).exp()).ln()),
        }
    }
}

/// Where a force is far smaller than the terms that it is made of, rounding explains what it lacks.
#[test]
fn forces_that_fall_off_are_certified() {
    let starts = [[0.1, 3.0], [-3.0, 2.5], [0.1, 2.7], [0.1, 3.0], [-3.0, 2.5]];
    for (kind, [q, p]) in (0..).zip(starts) {
        let well = Well { kind, offset: 0.0 };
        let start = Phase::new([q], [p]);
        // Slow enough that 8192 steps stay below 709, where `exp` overflows.
        for outcome in [certify(&well, Verlet, start, 0.02), certify(&well, Yoshida4, start, 0.02)] {
            let certificate = outcome.unwrap_or_else(|error| panic!("{kind}: {error}"));
            assert!(!certificate.stability.expect("T and V").turn.is_nan(), "{certificate}");
        }
    }
}

/// Verdicts depend neither on the zero of the energy, nor on the amplitude, nor on the direction of time, for what is right
/// and for what is wrong.
#[test]
fn verdicts_are_the_same_at_any_zero_and_amplitude() {
    for (offset, angle) in [(0.0, 1.0), (10.8, 1.0), (1e6, 1.0), (1e12, 1.0), (0.0, 1e-8), (10.8, 1e-8)] {
        let (well, start) = (Well { kind: 5, offset }, Phase::new([angle], [0.3 * angle]));
        for h in [0.05, -0.05] {
            let right = certify(&well, Verlet, start, h);
            assert!(right.is_ok(), "{offset}, {angle}, {h}: {}", right.expect_err("a refusal"));
            for wrong in [certify(&well, EulerThatClaims2, start, h), certify(&well, Strong, start, h)] {
                let Err(CertifyError::Refused { shortfalls, .. }) = wrong else { panic!("certified: {wrong:?}") };
                let is_order = |shortfall: &Shortfall| matches!(shortfall, Shortfall::Order { .. });
                assert!(shortfalls.iter().any(is_order), "{offset}, {angle}, {h}: {shortfalls:?}");
            }
        }
    }
}

/// Differences of an energy say nothing where it changes by less than it is rounded.
#[test]
fn amplitudes_below_the_rounding_of_the_energy_are_certified() {
    for angle in [1.0, 1e-4, 1e-6, 1e-7, 1e-8] {
        let start = Phase::new([angle], [0.0]);
        for (kind, offset) in [(5, 0.0), (6, 1.0)] {
            let outcome = certify(&Well { kind, offset }, Verlet, start, 0.05);
            assert!(outcome.is_ok(), "{kind} at {angle}: {}", outcome.expect_err("a refusal"));
        }
    }
    for (offset, q) in [(1e9, 1.0), (1e12, 1.0), (1e15, 1.0), (1e6, 1e-4)] {
        let outcome = certify(&Well { kind: 6, offset }, Verlet, Phase::new([q], [0.0]), 0.05);
        assert!(outcome.is_ok(), "{offset} at {q}: {}", outcome.expect_err("a refusal"));
    }
}

/// The energy is the sum of terms that cancel there, and its slope is 2.5e-9.
#[test]
fn the_dual_moon_has_no_kink_in_its_valley() {
    let moon = Well { kind: 7, offset: 0.0 };
    let start = Phase::new([2.0], [0.3]);
    let error = gradient_error(&moon, start, 0.0);
    assert!(matches!(error, Ok(error) if error < 1e-14), "{error:?}");
    let outcome = certify(&moon, Verlet, start, 0.02);
    assert!(outcome.is_ok(), "{}", outcome.expect_err("a refusal"));
}

/// Where the third derivative of `V` jumps, errors shrink with the cube of the step. Long steps hide this, whose other errors
/// are larger.
#[test]
fn a_jump_of_the_third_derivative_is_found() {
    let (well, start) = (Well { kind: 8, offset: 0.0 }, Phase::new([1.0], [0.0]));
    for h in [0.05, 0.02, 0.01] {
        let outcome = certify(&well, Yoshida4, start, h);
        let Err(CertifyError::Refused { shortfalls, .. }) = outcome else { panic!("certified: {outcome:?}") };
        let is_third = |shortfall: &Shortfall| matches!(shortfall, Shortfall::OrderLost { observed, .. } if (observed - 3.0).abs() < 0.5);
        assert!(shortfalls.iter().any(is_third), "{h}: {shortfalls:?}");
        let outcome = certify(&well, Verlet, start, h);
        assert!(outcome.is_ok(), "{}", outcome.expect_err("a refusal"));
    }
}

/// Three bodies that a bond holds at an angle.
struct Bent {
    angle: f64,
}

#[hamiltonian]
impl Bent {
    fn kinetic(&self, p: [[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| 0.5 * (p[i][0] * p[i][0] + p[i][1] * p[i][1])).sum()
    }
    fn potential(&self, q: [[f64; 2]; 3]) -> f64 {
        let (ax, ay) = (q[0][0] - q[1][0], q[0][1] - q[1][1]);
        let (bx, by) = (q[2][0] - q[1][0], q[2][1] - q[1][1]);
        let (aa, bb) = (ax * ax + ay * ay, bx * bx + by * by);
        let angle = ((ax * bx + ay * by) / (aa * bb).sqrt()).acos();
        0.5 * (angle - self.angle).powi(2) + 3.0 * (aa.sqrt() - 1.0).powi(2) + 3.0 * (bb.sqrt() - 1.0).powi(2)
    }
}

/// At a straight angle `acos` has no slope: no check accuses a flow, a sequence or the macro of that.
#[test]
fn a_start_without_a_force_is_the_only_reason() {
    let straight = Phase::new([[-1.0, 0.0], [0.0, 0.0], [1.1, 0.0]], [[0.0, 0.1], [0.0, -0.2], [0.0, 0.1]]);
    for angle in [1.9, core::f64::consts::PI] {
        let system = Bent { angle };
        let outcomes = [
            certify(&system, Verlet, straight, 0.01),
            certify(&system, VelocityVerlet, straight, 0.01),
            certify(&system, Yoshida4, straight, 0.01),
        ];
        for outcome in outcomes {
            let Err(CertifyError::Refused { shortfalls, .. }) = outcome else { panic!("certified: {outcome:?}") };
            let is_one = matches!(
                shortfalls[..],
                [Shortfall::Unmeasured { check: "the gradient", reason: CheckError::NotFinite { .. } }]
            );
            assert!(is_one, "{shortfalls:?}");
        }
        let error = gradient_error(&system, straight, 0.0);
        assert!(matches!(error, Err(CheckError::NotFinite { .. })), "{error:?}");
    }
}

/// A well with a step of some height around its middle, of which a drive reads the time.
struct Stepped {
    step: f64,
    width: f64,
    rate: f64,
}

#[hamiltonian]
impl Stepped {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        let square = q[0] * q[0] + q[1] * q[1];
        let smooth = 0.5 * (q[0] * q[0] + 1.7 * q[1] * q[1]) + 1e-3 * q[0] * (self.rate * t).cos();
        let inside = if self.width > 0.0 {
            0.5 * (1.0 + ((0.49 - square) / self.width).tanh())
        } else if square < 0.49 {
            1.0
        } else {
            0.0
        };
        smooth + self.step * inside
    }
}

#[test]
fn a_jump_is_found_where_no_energy_is_conserved() {
    let start = Phase::new([1.0, 0.2], [0.1, 0.6]);
    for step in [0.1, -1e-3, 1e-6] {
        let outcome = certify(&Stepped { step, width: 0.0, rate: 1.0 }, Yoshida4, start, 0.05);
        let Err(CertifyError::Refused { shortfalls, .. }) = outcome else { panic!("certified: {outcome:?}") };
        let [Shortfall::EnergyJumps { function: "potential", by, .. }] = shortfalls[..] else {
            panic!("{shortfalls:?}")
        };
        // Up to the roundings of energies below four.
        assert!((by.abs() - step.abs()).abs() < 64.0 * f64::EPSILON, "{by} at {step}");
    }
    for (step, width) in [(0.0, 0.0), (0.1, 0.3)] {
        let outcome = certify(&Stepped { step, width, rate: 1.0 }, Yoshida4, start, 0.02);
        assert!(outcome.is_ok(), "{}", outcome.expect_err("a refusal"));
    }
}

/// A drive of half a period or more in a step is refused, however accurate a composition is in far shorter steps.
#[test]
fn a_step_that_does_not_resolve_a_drive_is_refused() {
    let start = Phase::new([1.0, 0.2], [0.1, 0.6]);
    for (periods, h, resolved) in [(0.4, 0.05, true), (0.7, -0.05, false), (5.0, 0.05, false)] {
        let system = Stepped { step: 0.0, width: 0.0, rate: periods * core::f64::consts::TAU / h };
        let found = match certify(&system, Yoshida4, start, h) {
            Ok(_) => false,
            Err(CertifyError::Refused { shortfalls, .. }) => {
                let [Shortfall::DriveNotResolved { half, .. }] = shortfalls[..] else { panic!("{shortfalls:?}") };
                half < f64::abs(h)
            }
            Err(error) => panic!("{error}"),
        };
        assert_ne!(found, resolved, "{periods} periods in a step of {h}");
    }
}

/// By value or by reference, with a time of its own or without.
#[test]
#[allow(clippy::needless_borrows_for_generic_args, reason = "starts by reference are among the forms")]
fn a_gradient_is_checked_at_any_form_of_a_start() {
    let system = Stepped { step: 0.1, width: 0.3, rate: 1.0 };
    let point = Phase::new([1.0, 0.2], [0.1, 0.6]);
    let expected = gradient_error(&system, point, 1.5);
    assert!(expected.is_ok(), "{expected:?}");
    assert_eq!(gradient_error(&system, &point, 1.5), expected);
    assert_eq!(gradient_error(&system, point.at_time(1.0), 0.5), expected);
    assert_eq!(gradient_error(&system, &point.at_time(1.5), 0.0), expected);
}
