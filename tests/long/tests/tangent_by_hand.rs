//! Hand-written and generated tangents give the same steps and the same derivatives, up to rounding.
//!
//! Tolerances are those of `by_hand.rs`, and a hundred times as much for vectors: they are products of derivatives,
//! which are sums of a few terms each.

use integrator_bench::{
    by_hand::{oscillators, tangent},
    plan::Plan,
    starts::Problems,
};
use integrator_core::{Coords, Memoryless, prelude::*};

const STEPS: u64 = 40;

/// Returns a vector with a component along every coordinate of the initial state.
fn vector<C: Coords<Leaf = f64>>(start: &Phase<C>) -> Phase<C> {
    let mut vector = start.clone();
    for half in [vector.q.flat_mut(), vector.p.flat_mut()] {
        let size = half.iter().fold(1e-9, |size: f64, x| size.max(x.abs()));
        for (place, number) in half.iter_mut().enumerate() {
            *number = size * (1.0 + 1.7 * place as f64).sin();
        }
    }
    vector
}

#[track_caller]
fn agree<C: Coords<Leaf = f64>>(ours: &Phase<C>, theirs: &Phase<C>, tolerance: f64) {
    for (ours, theirs) in [(ours.q.flat(), theirs.q.flat()), (ours.p.flat(), theirs.p.flat())] {
        let largest = ours.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        for (i, (a, b)) in ours.iter().zip(theirs).enumerate() {
            assert!((a - b).abs() <= tolerance * largest, "coordinate {i}: {a} and {b}");
        }
    }
}

#[track_caller]
fn compare<H, X, C>(system: &H, start: Phase<C>, _: X, h: f64, by_hand: impl Fn([Phase<C>; 2], &Plan) -> [Phase<C>; 2])
where
    H: Hamiltonian<Coords = C>,
    X: Composition<H> + Memoryless<H>,
    C: Coords<Leaf = f64, With<f64> = C>,
{
    let vector = vector(&start);
    let mut ours = system.tangent::<f64, X>(X::default(), start.clone(), [vector.clone()], h).expect("a start");
    ours.advance(STEPS).expect("finite states");
    let [state, image] = by_hand([start, vector], &Plan::of::<X>(h));
    agree(&ours.state(), &state, 1e-12);
    agree(&ours.vectors()[0], &image, 1e-10);
}

#[test]
fn points_agree() {
    let problems = Problems::default();
    let pendulum = problems.pendulum();
    compare(&pendulum.system, pendulum.start, KahanLi8, 0.01, |points, plan| {
        tangent::pendulum(&pendulum.system, points, plan, STEPS)
    });
    let henon = problems.henon_heiles();
    compare(&henon.system, henon.start, KahanLi8, 0.01, |points, plan| tangent::henon_heiles(points, plan, STEPS));
    compare(&problems.coupled_oscillators().system, henon.start, Aba864, 0.01, |points, plan| {
        let points = points.map(|Phase { q: [x, y], p: [px, py] }| [x, y, px, py]);
        oscillators::henon_heiles(points, plan, STEPS).map(|[x, y, px, py]| Phase::new([x, y], [px, py]))
    });
}

#[test]
fn rings_agree() {
    let solar = Problems::default().solar();
    compare(&solar.system, solar.start, KahanLi8, 100.0, |points, plan| {
        tangent::solar(&solar.system, points, plan, STEPS)
    });
}

#[test]
fn blocks_agree() {
    let chain = Problems::default().chain();
    compare(&chain.system, chain.start, KahanLi8, 0.1, |points, plan| {
        tangent::chain(&chain.system, points, plan, STEPS)
    });
}

#[test]
fn orbits_agree() {
    let (planets, start) = Problems::default().planets();
    compare(&planets, start, Verlet, 150.0, |points, plan| tangent::planets(&planets, points, plan, STEPS));
}
