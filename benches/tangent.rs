//! Benchmarks a step with deviation vectors: `cargo bench -p integrator-bench --bench tangent`.
//!
//! Runs with one and with four vectors are compared with the run alone. The run with one vector is also compared with a
//! hand-written stepper that evolves a state and a vector, with the same instructions. The last lines are medians over
//! interleaved rounds:
//!
//! - `ratio_tangent_<problem>_one=` and `_four=` are times divided by that of the run alone. Targets with one vector are 1.9
//!   for Hénon–Heiles and the outer solar system, and 2.2 for the others.
//! - `ratio_tangent_<problem>_by_hand=` is the time with one vector divided by that of the hand-written stepper; the target is
//!   1.1.
//! - `ratio_tangent_map_<composition>_<steps>=` is the time of a chaos map of Hénon–Heiles orbits divided by that of the
//!   ensemble without vectors; the target is 2.2. Short orbits are sampled every few steps, long ones every 64.
//! - `ratio_tangent_taylor_<problem>_one=` and `_four=` are times by Taylor's method divided by that of the run alone; the target
//!   with one vector is 3.
//! - `ratio_megno_<composition>=` is the time of `chaos::megno` of the outer solar system in Jacobi coordinates divided by that of
//!   the run alone; the target is 2.5. `_indicators=` is that of `chaos::indicators`, which integrates four vectors.

use integrator_bench::{
    by_hand::{oscillators, tangent},
    plan::Plan,
    problems::{Solar, jacobi::Jacobi},
    race::{Racer, race},
    starts::{Problem, Problems},
    table::Table,
};
use integrator_core::{
    Coords, Memoryless,
    chaos::{self, Indicator},
    prelude::*,
    taylor::{Recurrences, Taylor},
};
use std::error::Error;

/// Approximate number of force evaluations per round.
const EVALUATIONS: u64 = 20_000;
/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 41;

/// Numbers of steps by Taylor's method, and of those of planets.
const STEPS_BY_TAYLOR: u64 = 3_000;
const STEPS_OF_PLANETS: u64 = 10_000;

/// Number of orbits in a map.
const ORBITS: u32 = 1_000;
/// Number of rounds for maps, which take seconds each.
const ROUNDS_OF_MAPS: usize = 11;

/// A hand-written stepper: takes a state and a vector, and returns both after some steps.
type HandWritten<'a, C> = &'a dyn Fn([Phase<C>; 2], &Plan, u64) -> [Phase<C>; 2];

struct Report {
    table: Table,
    ratios: Vec<String>,
}

impl Report {
    /// Measures a composition on a problem, in nanoseconds per force evaluation.
    fn compare<H, X, C>(&mut self, name: &str, (system, start): (&H, &Phase<C>), _: X, h: f64, by_hand: HandWritten<C>)
    where
        H: Hamiltonian<Coords = C>,
        X: Composition<H> + Memoryless<H>,
        C: Coords<Leaf = f64, With<f64> = C>,
    {
        let steps = (EVALUATIONS / X::FORCE_EVALUATIONS as u64).max(2);
        let alone = || {
            let mut run = system.run_with::<f64, X>(X::default(), start.clone(), h).expect("a start").with_threads(1);
            run.advance(steps).expect("finite states");
            run.state()
        };
        let vectors = vectors(start);
        let carrying = |count: usize| {
            let vectors = vectors[..count.min(vectors.len())].to_vec();
            let mut tangent = system.tangent::<f64, X>(X::default(), start.clone(), vectors, h).expect("a start");
            tangent.advance(steps).expect("finite vectors");
            tangent.state()
        };
        let plan = Plan::of::<X>(h);
        let racers = vec![
            Racer::new("alone", alone),
            Racer::new("one vector", || carrying(1)),
            Racer::new("four vectors", || carrying(4)),
            Racer::new("by hand", || by_hand([start.clone(), vectors[0].clone()], &plan, steps)),
        ];
        let times = race(ROUNDS, (steps * X::FORCE_EVALUATIONS as u64) as f64, racers);
        let [one, four] = [1, 2].map(|racer| times.ratio(racer, 0));
        let over_hand = times.ratio(1, 3);
        let [alone, with_one, with_four, hand] = [0, 1, 2, 3].map(|racer| times.median(racer));
        self.table.row([name, X::NAME], &[alone, with_one, with_four, hand, one, four, over_hand]);
        let problem = format!("ratio_tangent_{name}_{}", X::NAME.to_lowercase());
        self.ratios.push(format!("{problem}_one={one:.3}"));
        self.ratios.push(format!("{problem}_four={four:.3}"));
        self.ratios.push(format!("{problem}_by_hand={over_hand:.3}"));
    }
}

/// Measures a map of orbits near an initial state and the ensemble of the same orbits. Returns a line with the ratio of
/// their times.
fn map<H, X, C>((system, start): (&H, &Phase<C>), _: X, h: f64, steps: u64) -> String
where
    H: Hamiltonian<Coords = C> + Clone,
    X: Composition<H> + Memoryless<H>,
    C: Coords<Leaf = f64, With<f64> = C>,
{
    let near = |number: u32| {
        let mut near = start.clone();
        near.q.flat_mut()[0] += 1e-3 * f64::from(number) / f64::from(ORBITS);
        near
    };
    let starts: Vec<_> = (0..ORBITS).map(near).collect();
    let alone = || {
        let members = starts.iter().map(|start| (system.clone(), start.clone()));
        let mut ensemble = Ensemble::new(X::default(), members, h).expect("starts");
        ensemble.advance(steps).expect("finite states");
        ensemble
    };
    let map = || {
        let found = chaos::map(system, X::default(), starts.iter().cloned(), h, steps, Indicator::Megno);
        found.expect("starts")
    };
    let racers = vec![Racer::new("ensemble", alone).in_threads(), Racer::new("map", map).in_threads()];
    let times = race(ROUNDS_OF_MAPS, (u64::from(ORBITS) * steps) as f64, racers);
    println!("{} of {steps} steps: {:.3} and with a vector {:.3} ns a step", X::NAME, times.median(0), times.median(1));
    format!("ratio_tangent_map_{}_{steps}={:.3}", X::NAME.to_lowercase(), times.ratio(1, 0))
}

/// Measures runs by Taylor's method with one and with four vectors, and the run alone. Returns lines with the ratios of their
/// times.
fn taylor<H: Hamiltonian + Recurrences>(Problem { name, system, start, .. }: &Problem<H>, h: f64) -> [String; 2]
where
    H::Coords: Coords<Leaf = f64, With<f64> = H::Coords>,
{
    let method = Taylor::tolerance(1e-15);
    let vectors = vectors(start);
    let carrying = |count: usize| {
        let vectors = vectors[..count.min(vectors.len())].to_vec();
        let mut tangent = system.tangent::<f64, _>(method, start.clone(), vectors, h).expect("a start");
        tangent.advance(STEPS_BY_TAYLOR).expect("finite vectors");
        tangent.state()
    };
    let alone = || {
        let mut run = system.run_with::<f64, _>(method, start.clone(), h).expect("a start");
        run.advance(STEPS_BY_TAYLOR).expect("finite states");
        run.state()
    };
    let racers = vec![
        Racer::new("alone", alone),
        Racer::new("one vector", || carrying(1)),
        Racer::new("four vectors", || carrying(4)),
    ];
    let times = race(ROUNDS, STEPS_BY_TAYLOR as f64, racers);
    let [alone, one, four] = [0, 1, 2].map(|racer| times.median(racer));
    println!("Taylor, {name}: {alone:.1}, with one vector {one:.1}, with four {four:.1} ns a step");
    let line = |count: &str, racer| format!("ratio_tangent_taylor_{name}_{count}={:.3}", times.ratio(racer, 0));
    [line("one", 1), line("four", 2)]
}

/// Measures chaos indicators of planets and the run alone. Returns lines with the ratios of their times.
fn megno<X: Composition<Jacobi> + Memoryless<Jacobi>>(_: X) -> [String; 2] {
    let Problem { start, system: Solar { masses }, .. } = Problems::default().solar();
    let (system, h) = (Jacobi { masses }, 100.0);
    let alone = || {
        let mut run = system.run_with::<f64, X>(X::default(), start, h).expect("a start").with_threads(1);
        run.advance(STEPS_OF_PLANETS).expect("finite states");
        run.state()
    };
    let racers = vec![
        Racer::new("alone", alone),
        Racer::new("megno", || chaos::megno(&system, X::default(), start, h, STEPS_OF_PLANETS)),
        Racer::new("indicators", || chaos::indicators(&system, X::default(), start, h, STEPS_OF_PLANETS)),
    ];
    let times = race(ROUNDS_OF_MAPS, STEPS_OF_PLANETS as f64, racers);
    let [alone, megno, indicators] = [0, 1, 2].map(|racer| times.median(racer));
    println!("{}: {alone:.1}, MEGNO {megno:.1}, all indicators {indicators:.1} ns a step", X::NAME);
    let name = X::NAME.to_lowercase();
    let line = |what: &str, racer| format!("ratio_megno_{name}{what}={:.3}", times.ratio(racer, 0));
    [line("", 1), line("_indicators", 2)]
}

/// Returns four vectors, or as many as the dimension allows, with components along every coordinate.
fn vectors<C: Coords<Leaf = f64>>(start: &Phase<C>) -> Vec<Phase<C>> {
    let vector = |number: usize| {
        let mut vector = start.clone();
        for half in [vector.q.flat_mut(), vector.p.flat_mut()] {
            let size = half.iter().fold(1e-9, |size: f64, x| size.max(x.abs()));
            for (place, x) in half.iter_mut().enumerate() {
                *x = size * (number as f64 + 1.7 * place as f64).sin();
            }
        }
        vector
    };
    (1..=4.min(2 * start.q.flat().len())).map(vector).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("ns per force evaluation of a whole system");
    let head = ["problem", "composition", "alone", "one", "four", "by hand", "one/alone", "four/alone", "one/hand"];
    let mut report = Report { table: Table::new("tangent", &head), ratios: Vec::new() };
    let problems = Problems::default();

    let pendulum = problems.pendulum();
    let by_hand = |points, plan: &Plan, steps| tangent::pendulum(&pendulum.system, points, plan, steps);
    let problem = (&pendulum.system, &pendulum.start);
    report.compare("pendulum", problem, KahanLi8, 0.01, &by_hand);

    let henon = problems.henon_heiles();
    let problem = (&henon.system, &henon.start);
    report.compare("henon", problem, Verlet, 0.01, &tangent::henon_heiles);
    report.compare("henon", problem, KahanLi8, 0.01, &tangent::henon_heiles);
    for steps in [1_000, 10_000] {
        report.ratios.push(map(problem, Verlet, 0.01, steps));
        report.ratios.push(map(problem, BlanesMoanSrkn11, 0.01, steps));
    }
    let by_hand = |points: [Phase<[f64; 2]>; 2], plan: &Plan, steps| {
        let points = points.map(|Phase { q: [x, y], p: [px, py] }| [x, y, px, py]);
        oscillators::henon_heiles(points, plan, steps).map(|[x, y, px, py]| Phase::new([x, y], [px, py]))
    };
    let parts = problems.coupled_oscillators();
    report.compare("henon_parts", (&parts.system, &parts.start), Aba864, 0.01, &by_hand);

    let solar = problems.solar();
    let by_hand = |points, plan: &Plan, steps| tangent::solar(&solar.system, points, plan, steps);
    let problem = (&solar.system, &solar.start);
    report.compare("solar", problem, Verlet, 10.0, &by_hand);
    report.compare("solar", problem, KahanLi8, 10.0, &by_hand);

    let chain = problems.chain();
    let by_hand = |points, plan: &Plan, steps| tangent::chain(&chain.system, points, plan, steps);
    let problem = (&chain.system, &chain.start);
    report.compare("fput", problem, Verlet, 0.05, &by_hand);
    report.compare("fput", problem, KahanLi8, 0.05, &by_hand);

    report.ratios.extend(taylor(&pendulum, 0.05));
    report.ratios.extend(taylor(&henon, 0.05));
    report.ratios.extend(taylor(&problems.kepler(), 0.05));
    report.ratios.extend(taylor(&solar, 10.0));
    report.ratios.extend(taylor(&chain, 0.05));
    report.ratios.extend([megno(Verlet), megno(Aba1064), megno(WisdomHolmanTouma17)].into_iter().flatten());

    report.table.write()?;
    report.ratios.iter().for_each(|line| println!("{line}"));
    Ok(())
}
