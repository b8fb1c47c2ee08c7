//! How a system of the corpus is judged.

use crate::{
    member::{Filled, Member},
    reference::{self, Exact, Point},
};
use integrator_core::{
    Compensated, Coords, Visitor,
    check::{Certificate, CertifyError, gradient_error},
    prelude::*,
};
use num_dual::Dual64;

/// By how many units in the last place of its scale a number may be off: half a unit for each of sixteen operations on
/// the longest path from the coordinates to it, the elementary functions' own roundings and the reference's included.
const ULPS: f64 = 8.0;

/// Holds everything that is generated for a system against the reference, the twin and the user's own functions.
pub(crate) fn judge<S: Member>(name: &str) {
    let system = S::example();
    let points = reference::points(name);
    assert!(points.len() >= 3, "{name}: a few points");
    for point in &points {
        gradients_agree(name, &system, point);
        energies_agree(name, &system, point);
        let deviation = gradient_error::<S, f64>(&system, phase::<S>(point), point.time);
        // Units of the rounding of the coordinates; the same operations as above, once as code and once in duals.
        assert!(deviation.as_ref().is_ok_and(|error| *error <= 32.0 * f64::EPSILON), "{name}: {deviation:?}");
    }
    let start = phase::<S>(&points[0]);
    let certificate = if const { S::SMOOTH >= Yoshida4::ORDER } {
        certify::<S, _, f64>(&system, Yoshida4, start.clone(), S::STEP)
    } else {
        certify::<S, _, f64>(&system, Verlet, start.clone(), S::STEP)
    };
    agrees_with_smoothness::<S>(name, certificate);
    S::visit_compositions(&mut WithForceGradients { name, system: &system, start });
}

/// Certifies a system with `Chin4A` if its `T` is quadratic: force gradients need the generated second derivatives.
struct WithForceGradients<'m, S: Member> {
    name: &'m str,
    system: &'m S,
    start: Phase<S::Coords>,
}

impl<S: Member> Visitor<S> for WithForceGradients<'_, S> {
    fn visit<X: Composition<S>>(&mut self, composition: X) {
        // Known when this is compiled, so that nothing is compiled for the others: one certificate of one system takes
        // the compiler a second.
        if const { is_chin_4a::<X>() && S::SMOOTH >= X::ORDER } {
            let certificate = certify::<S, X, f64>(self.system, composition, self.start.clone(), S::STEP);
            agrees_with_smoothness::<S>(self.name, certificate);
        }
    }
}

/// Whether a composition has the numbers of `Chin4A`, which no other one in the catalogue has.
const fn is_chin_4a<X: Scheme>() -> bool {
    X::SYMMETRIC
        && X::ORDER == Chin4A::ORDER
        && X::FORCE_EVALUATIONS == Chin4A::FORCE_EVALUATIONS
        && X::GRADIENT_EVALUATIONS == Chin4A::GRADIENT_EVALUATIONS
}

/// A smooth system is certified, a rough one is not.
fn agrees_with_smoothness<S: Member>(name: &str, certificate: Result<Certificate, CertifyError>) {
    match (certificate, S::ROUGH) {
        (Ok(_), None) | (Err(CertifyError::Refused { .. }), Some(_)) => {}
        (Ok(certificate), Some(reason)) => panic!("{name}: certified, though {reason}: {certificate}"),
        (Err(refused), _) => panic!("{name}: {refused}"),
    }
}

fn phase<S: Member>(point: &Point) -> Phase<S::Coords> {
    Phase::new(S::Coords::filled(&point.q), S::Coords::filled(&point.p))
}

/// The generated gradients and those of the twin are those of the reference.
fn gradients_agree<S: Member>(name: &str, system: &S, point: &Point) {
    let (kinetic, potential) = generated(system, point);
    let by_momenta = twin(&point.p, |p| system.kinetic_twin(p, point.time));
    let by_positions = twin(&point.q, |q| system.potential_twin(q, point.time));
    let all_close = |what: &str, found: &[f64], exact: &[Exact]| {
        assert_eq!(found.len(), exact.len(), "{name}: {what}");
        for (index, (found, exact)) in found.iter().zip(exact).enumerate() {
            assert_close(&format!("{name}: {what}, component {index}"), *found, exact);
        }
    };
    all_close("generated dT/dp", &kinetic, &point.kinetic_gradient);
    all_close("generated dV/dq", &potential, &point.potential_gradient);
    all_close("dual dT/dp", &by_momenta, &point.kinetic_gradient);
    all_close("dual dV/dq", &by_positions, &point.potential_gradient);
}

/// A duration so short that conditions on the time hold throughout, and a power of two, by which numbers are multiplied and
/// divided without rounding.
const SHORT: f64 = 1.0 / (1 << 20) as f64;

/// The gradients of `T` and `V` as a run sees them: a kick from rest leaves `-dV/dq` times its duration in the momenta, a
/// drift adds `dT/dp` times its duration to the positions, which carry what the sum rounds. (There may be no energy at the
/// origin.)
fn generated<S: Member>(system: &S, point: &Point) -> (Vec<f64>, Vec<f64>) {
    let zeros = S::Coords::filled(&vec![0.0; point.q.len()]);
    let from_rest = Phase::new(S::Coords::filled(&point.q), zeros);
    let moving = Phase::compensated(S::Coords::filled(&point.q), S::Coords::filled(&point.p));
    let mut kick = system.run_with::<f64, _>(Euler, from_rest, SHORT).expect("a start").at_time(point.time);
    kick.advance(1).expect("finite");
    let mut drift =
        system.run_with::<Compensated<f64>, _>(EulerAdjoint, moving, SHORT).expect("a start").at_time(point.time);
    drift.advance(1).expect("finite");
    let moved =
        drift.state().q.flat().iter().zip(&point.q).map(|(q, from)| (q.value - from) + q.carried).collect::<Vec<_>>();
    let rates = |changes: &[f64], sign: f64| changes.iter().map(|change| sign * change / SHORT).collect();
    (rates(&moved, 1.0), rates(kick.state().p.flat(), -1.0))
}

/// A gradient by dual numbers, one seed after the other.
fn twin(at: &[f64], energy: impl Fn(&[Dual64]) -> Dual64) -> Vec<f64> {
    let seeded = |seed: usize| {
        let numbers: Vec<Dual64> =
            at.iter().enumerate().map(|(i, x)| Dual64::new(*x, if i == seed { 1.0 } else { 0.0 })).collect();
        energy(&numbers).eps
    };
    (0..at.len()).map(seeded).collect()
}

/// The user's functions, the generated energy and the twin give the energy of the reference.
fn energies_agree<S: Member>(name: &str, system: &S, point: &Point) {
    let at = phase::<S>(point);
    let [kinetic, potential] = system.energies(&at, point.time);
    assert_close(&format!("{name}: the user's T"), kinetic, &point.kinetic);
    assert_close(&format!("{name}: the user's V"), potential, &point.potential);
    assert_close(&format!("{name}: the twin's T"), system.kinetic_twin(&point.p, point.time), &point.kinetic);
    assert_close(&format!("{name}: the twin's V"), system.potential_twin(&point.q, point.time), &point.potential);
    let total = Exact {
        value: point.kinetic.value + point.potential.value,
        scale: point.kinetic.scale + point.potential.scale,
    };
    let run = system.run::<f64>(at, S::STEP).expect("a start").at_time(point.time);
    assert_close(&format!("{name}: the generated energy"), run.energy(), &total);
}

fn assert_close(what: &str, found: f64, exact: &Exact) {
    let ulp = exact.scale.next_up() - exact.scale;
    let error = (found - exact.value).abs();
    assert!(error <= ULPS * ulp, "{what}: {found:e} for {exact:?}, {:.1} ulp", error / ulp);
}

#[test]
#[should_panic(expected = "a wrong number: ")]
fn a_number_that_is_off_is_seen() {
    let exact = Exact { value: 1.0, scale: 1.0 };
    assert_close("a right number", 1.0 + ULPS * f64::EPSILON, &exact);
    assert_close("a wrong number", 1.0 + (ULPS + 1.0) * f64::EPSILON, &exact);
}

#[test]
#[should_panic(expected = "a NaN: ")]
fn a_nan_is_seen() {
    assert_close("a NaN", f64::NAN, &Exact { value: 1.0, scale: 1.0 });
}
