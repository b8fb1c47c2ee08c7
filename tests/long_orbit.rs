//! What rounding leaves of an orbit of eccentricity 0.6 after a thousand periods, with and without compensation.

use integrator_core::prelude::*;
use serde_json::{Value, from_str, from_value};

#[path = "../examples/choose/systems.rs"]
#[expect(dead_code, reason = "the example chooses for more systems")]
mod systems;

use systems::Kepler;

/// A power of two, so that the step is exactly representable and no error of the time hides behind that of the state.
/// The method's own error, of order 10, is below 1e-13 then.
const STEPS: u64 = 1 << 18;
/// How often the energy is looked at.
const LOOKS: u64 = 1 << 10;

/// The start, the time, and the state at the end in 113-bit arithmetic.
fn problem() -> (Phase<[f64; 2]>, f64, [f64; 4]) {
    let problems: Value = from_str(include_str!("../examples/data/problems.json")).expect("JSON");
    let kepler = &problems["problems"]["kepler"];
    let pair = |key: &str| from_value(kepler[key].clone()).expect("two numbers");
    let end = from_value(kepler["reference"]["z"].clone()).expect("four numbers");
    (Phase::new(pair("q"), pair("p")), kepler["T"].as_f64().expect("a time"), end)
}

/// The largest deviation of the energy.
fn deviation(energy: f64) -> f64 {
    (energy + 0.5).abs()
}

/// The distance of the end from the reference in units of its length.
fn distance(found: [f64; 4], exact: [f64; 4]) -> f64 {
    let length = |x: [f64; 4]| x.map(|x| x * x).iter().sum::<f64>().sqrt();
    length(std::array::from_fn(|i| found[i] - exact[i])) / length(exact)
}

/// With every update compensated, the rounding of the forces is what is left: each kick changes the energy by up to
/// ε/2·b·h·|F·v| at random. With 35 kicks a step of about a fifth of the step each, and a mean |F·v| of 2 on this
/// orbit, 2^18 steps add up to 3e-15 in the energy. A change of the energy changes the period; over 1000 periods, that
/// is 3e-11 in the time of arrival, where momenta change by three times their own size per unit of time: 1e-10 in the
/// state. Bounds are three times this. No coefficient and no step enters but through the root of their number.
#[test]
fn compensation_leaves_the_rounding_of_the_forces() {
    let (start, time, exact) = problem();
    let compensated = Phase::compensated(start.q, start.p);
    let mut run = Kepler.run_with(SofroniouSpaletta10, compensated, time / STEPS as f64).expect("a start");
    let mut energy = 0.0_f64;
    for _ in 0..LOOKS {
        run.advance(STEPS / LOOKS).expect("finite states");
        energy = energy.max(deviation(run.energy()));
    }
    let Phase { q, p } = run.state();
    let distance = distance([q[0].value, q[1].value, p[0].value, p[1].value], exact);
    assert!(energy < 1e-14, "{energy:e}");
    assert!(distance < 3e-10, "{distance:e}");
}

/// Without compensation every drift and every kick rounds the state too: some ε/2 of |q| times a force of up to 6.
#[test]
fn plain_scalar_types_lose_ten_times_as_much_and_more() {
    let (start, time, exact) = problem();
    let mut run = Kepler.run_with(SofroniouSpaletta10, start, time / STEPS as f64).expect("a start");
    run.advance(STEPS).expect("finite states");
    let Phase { q, p } = run.state();
    let (energy, distance) = (deviation(run.energy()), distance([q[0], q[1], p[0], p[1]], exact));
    assert!(energy > 3e-14 && energy < 3e-12, "{energy:e}");
    assert!(distance > 3e-10 && distance < 1e-7, "{distance:e}");
}
