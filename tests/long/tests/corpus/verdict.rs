//! Tests of a system in the corpus.

use crate::{
    member::{Filled, Member},
    reference::{self, Exact, Point},
};
use integrator_core::{
    __private::{Composition, Motion},
    Coords,
    check::{CertifyError, gradient_error},
    prelude::*,
};
use num_dual::Dual64;

/// Tolerance in units in the last place of the scale: half a unit for each of sixteen operations on the longest path
/// from the coordinates, including the rounding of elementary functions and of the reference.
const ULPS: f64 = 8.0;

/// Compares all generated code of a system with the reference, the formula and the user's own functions.
pub(crate) fn judge<S: Member>(name: &str) {
    let system = S::example();
    let points = reference::points(name);
    assert!(points.len() >= 3, "{name}: a few points");
    for point in &points {
        gradients_agree(name, &system, point);
        energies_agree(name, &system, point);
        let deviation = gradient_error::<S, f64>(&system, phase::<S>(point), point.time);
        // In units of the rounding of the coordinates: the operations above, once as code and once in dual numbers.
        assert!(deviation.as_ref().is_ok_and(|error| *error <= 32.0 * f64::EPSILON), "{name}: {deviation:?}");
    }
}

/// Certification succeeds for a smooth system and fails for a rough one.
pub(crate) fn certified<S: Member, X: Composition<S>>(name: &str, method: X) {
    let start = phase::<S>(&reference::points(name)[0]);
    match (certify::<S, X, f64>(&S::example(), method, start, S::STEP), S::ROUGH) {
        (Ok(_), None) | (Err(CertifyError::Refused { .. }), Some(_)) => {}
        (Ok(certificate), Some(reason)) => panic!("{name}: certified, though {reason}: {certificate}"),
        (Err(refused), _) => panic!("{name}: {refused}"),
    }
}

fn phase<S: Member>(point: &Point) -> Phase<S::Coords> {
    Phase::new(S::Coords::filled(&point.q), S::Coords::filled(&point.p))
}

/// Compares the generated gradients and those of the formula with the reference.
fn gradients_agree<S: Member>(name: &str, system: &S, point: &Point) {
    let (kinetic, potential) = generated(system, point);
    let by_momenta = formula(&point.p, |p| system.kinetic_formula(p, point.time));
    let by_positions = formula(&point.q, |q| system.potential_formula(q, point.time));
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

/// Returns the gradients of `T` and `V` as used in a step. A drift of unit duration from zero adds `dT/dp` to positions
/// without rounding; a kick subtracts `dV/dq` from momenta. (The energy may be undefined at the origin.)
fn generated<S: Member>(system: &S, point: &Point) -> (Vec<f64>, Vec<f64>) {
    let zeros = vec![0.0; point.q.len()];
    let flown = |q: &[f64], p: &[f64], flow: fn(&mut S::Motion<f64, f64>, f64, f64)| {
        let mut moved = Phase::new(S::Coords::filled(q), S::Coords::filled(p));
        let mut motion = motion(system, &moved);
        S::begin_step::<f64, f64>(&mut motion, point.time);
        flow(&mut motion, 1.0, point.time);
        motion.store(0, &mut moved);
        moved
    };
    let drifted = flown(&zeros, &point.p, S::drift::<f64, f64>);
    let kicked = flown(&point.q, &zeros, S::kick::<f64, f64>);
    (drifted.q.flat().to_vec(), kicked.p.flat().iter().map(|p| -p).collect())
}

/// Returns a system at a point, in the representation of runs.
fn motion<S: Member>(system: &S, at: &Phase<S::Coords>) -> S::Motion<f64, f64> {
    let parameters = system.parameters(at.q.flat().len());
    S::Motion::<f64, f64>::load(&[&parameters], &[at])
}

/// Returns a gradient by dual numbers, one component at a time.
fn formula(at: &[f64], energy: impl Fn(&[Dual64]) -> Dual64) -> Vec<f64> {
    let seeded = |seed: usize| {
        let numbers: Vec<Dual64> =
            at.iter().enumerate().map(|(i, x)| Dual64::new(*x, if i == seed { 1.0 } else { 0.0 })).collect();
        energy(&numbers).eps
    };
    (0..at.len()).map(seeded).collect()
}

/// Compares the energies of the user's functions, the generated code and the formula with the reference.
fn energies_agree<S: Member>(name: &str, system: &S, point: &Point) {
    let at = phase::<S>(point);
    let [kinetic, potential] = system.energies(&at, point.time);
    assert_close(&format!("{name}: the user's T"), kinetic, &point.kinetic);
    assert_close(&format!("{name}: the user's V"), potential, &point.potential);
    assert_close(&format!("{name}: the formula's T"), system.kinetic_formula(&point.p, point.time), &point.kinetic);
    assert_close(&format!("{name}: the formula's V"), system.potential_formula(&point.q, point.time), &point.potential);
    let total = Exact {
        value: point.kinetic.value + point.potential.value,
        scale: point.kinetic.scale + point.potential.scale,
    };
    let motion = motion(system, &at);
    let generated = S::kinetic::<f64, f64>(&motion, point.time) + S::potential::<f64, f64>(&motion, point.time);
    assert_close(&format!("{name}: the generated energy"), generated, &total);
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
