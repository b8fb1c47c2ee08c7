//! Benchmarks a step, generated and hand-written: `cargo bench -p integrator-bench --bench step`.
//!
//! Small systems use `Verlet` and two long compositions, large ones `Verlet`. The hand-written steppers are plain safe Rust
//! and, where that is not the limit, vectors of `std::arch`. Both use the same instructions as the generated code. The last
//! lines, `ratio_<problem>_<composition>=`, are the generated time divided by that of the best hand-written stepper in the same
//! round, medians of interleaved rounds. The target is 1.05. `docs/performance.md` has the results.

use integrator_bench::{
    by_hand::{
        carried,
        chain::Chain,
        field::Field,
        law::Law,
        oscillators, plain,
        points::{Point, scalar, wide},
        row,
        tiles::{Attraction, Bodies},
    },
    plan::Plan,
    plot::{Dots, Row, dots, named},
    problems::{Fput, Phi4, Phi4Plane, SineGordon, Toda},
    race::{Racer, Times, race},
    starts::{Problem, Problems, argon, cluster, rows_of_waves, waves},
    table::{Table, folder},
};
use integrator_core::{Compensated, Coords, prelude::*};
use std::error::Error;

/// Approximate number of force evaluations per round of a small system.
const EVALUATIONS: u64 = 40_000;
/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 61;
/// Number of rounds for large systems, which take longer.
const FEW_ROUNDS: usize = 15;

/// A hand-written stepper: its name, and a function that integrates and returns a number of the final state.
type HandWritten<'a> = (&'static str, Box<dyn Fn(&Plan, u64) -> f64 + 'a>);

struct Report {
    table: Table,
    ratios: Vec<String>,
    rows: Vec<Row>,
}

impl Report {
    fn add(&mut self, problem: &str, what: &str, times: &Times) {
        let best = (1..times.names().len()).min_by(|&a, &b| times.median(a).total_cmp(&times.median(b)));
        let plain = times.names().iter().position(|name| *name == "plain").map_or(f64::NAN, |i| times.median(i));
        let best = best.map_or(f64::NAN, |best| times.median(best));
        self.rows.push(Row {
            name: format!("{}, {}", named(problem), named(what)),
            values: vec![times.ratio_to_best(), plain / best],
        });
        self.table.row([problem, what], &[times.median(0), plain, best, times.ratio_to_best()]);
        self.ratios.push(format!("ratio_{problem}_{what}={:.3}", times.ratio_to_best()));
    }

    /// Measures a composition on a small problem, in nanoseconds per force evaluation.
    fn small<H: Hamiltonian, X: Composition<H>>(&mut self, problem: &Problem<H>, _: X, h: f64, by_hand: &[HandWritten])
    where
        H::Coords: Coords<Leaf = f64>,
    {
        let steps = EVALUATIONS / X::FORCE_EVALUATIONS as u64;
        let generated = || {
            let run = problem.system.run_with::<f64, X>(X::default(), problem.start.clone(), h);
            let mut run = run.expect("a start");
            run.advance(steps).expect("finite states");
            run.state()
        };
        let plan = Plan::of::<X>(h);
        let mut racers = vec![Racer::new("generated", generated)];
        racers.extend(by_hand.iter().map(|(name, by_hand)| Racer::new(name, || by_hand(&plan, steps))));
        let units = (steps * X::FORCE_EVALUATIONS as u64) as f64;
        self.add(problem.name, &X::NAME.to_lowercase(), &race(ROUNDS, units, racers));
    }

    /// The same with compensated coordinates. The column of plain loops contains the run without compensation.
    fn compensated<H: Hamiltonian, X: Composition<H>>(
        &mut self,
        problem: &Problem<H>,
        _: X,
        h: f64,
        by_hand: HandWritten,
    ) where
        H::Coords: Coords<Leaf = f64>,
    {
        let steps = EVALUATIONS / X::FORCE_EVALUATIONS as u64;
        let Phase { q, p } = &problem.start;
        let start = Phase::compensated(q.clone(), p.clone());
        let generated = || {
            let run = problem.system.run_with::<Compensated<f64>, X>(X::default(), start.clone(), h);
            let mut run = run.expect("a start");
            run.advance(steps).expect("finite states");
            run.state()
        };
        let without = || {
            let run = problem.system.run_with::<f64, X>(X::default(), problem.start.clone(), h);
            let mut run = run.expect("a start");
            run.advance(steps).expect("finite states");
            run.state()
        };
        let plan = Plan::of::<X>(h);
        let (name, by_hand) = by_hand;
        let racers = vec![
            Racer::new("generated", generated),
            Racer::new(name, || by_hand(&plan, steps)),
            Racer::new("without", without),
        ];
        let times = race(ROUNDS, (steps * X::FORCE_EVALUATIONS as u64) as f64, racers);
        let problem = format!("{}_carried", problem.name);
        let what = X::NAME.to_lowercase();
        self.rows.push(Row {
            name: format!("{}, {}", named(&problem), named(&what)),
            values: vec![times.ratio(0, 1), times.median(2) / times.median(1)],
        });
        let [generated, by_hand, without] = [0, 1, 2].map(|racer| times.median(racer));
        self.table.row([&problem, &what], &[generated, without, by_hand, times.ratio(0, 1)]);
        self.ratios.push(format!("ratio_{problem}_{what}={:.3}", times.ratio(0, 1)));
        self.ratios.push(format!("ratio_{problem}_{what}_over_plain={:.3}", times.ratio(0, 2)));
    }

    /// Measures Verlet and long compositions.
    fn small_in_all<H: Hamiltonian>(&mut self, problem: &Problem<H>, h: f64, by_hand: &[HandWritten])
    where
        H::Coords: Coords<Leaf = f64>,
    {
        self.small(problem, Verlet, h, by_hand);
        self.small(problem, KahanLi8, h, by_hand);
        self.small(problem, SofroniouSpaletta10, h, by_hand);
    }

    /// Measures Verlet on a chain, in nanoseconds per site and step. Every round continues from the previous one.
    fn chain<H: Hamiltonian<Coords = Vec<f64>>>(&mut self, name: &str, system: &H, law: Law, sites: usize) {
        let start = waves(sites);
        // As many steps as a long run takes between two outputs.
        let steps = (2_000_000 / sites).max(1024);
        let h = 0.05;
        let plan = Plan::of::<Verlet>(h);
        // One thread, as in the hand-written steppers: a racer measures the CPU time of its own thread.
        let mut run = system.run_with::<f64, Verlet>(Verlet, start.clone(), h).expect("a start").with_threads(1);
        let skewed = Chain { law, q: start.q, p: start.p };
        let [mut skewed, mut plain] = [skewed.clone(), skewed];
        let racers = vec![
            Racer::new("generated", || run.advance(steps as u64).expect("finite states")),
            Racer::new("plain", || plain.two_pass(&plan, steps)),
            Racer::new("skewed", || skewed.skewed(&plan, steps)),
        ];
        self.add(name, "verlet", &race(FEW_ROUNDS, (sites * steps) as f64, racers));
    }

    /// Measures Verlet on a plane, in nanoseconds per site and step.
    fn plane(&mut self, name: &str, system: Phi4Plane, rows: usize) {
        let start = rows_of_waves(rows);
        let sites = rows * start.q[0].len();
        let steps = (2_000_000 / sites).max(64);
        let h = 0.05;
        let plan = Plan::of::<Verlet>(h);
        let run = system.run_with::<f64, Verlet>(Verlet, start.clone(), h).expect("a start");
        let mut run = run.with_threads(1);
        let one_pass = Field { stiffness: system.stiffness, q: start.q, p: start.p };
        let [mut one_pass, mut plain] = [one_pass.clone(), one_pass];
        let racers = vec![
            Racer::new("generated", || run.advance(steps as u64).expect("finite states")),
            Racer::new("plain", || plain.two_pass(&plan, steps)),
            Racer::new("one pass", || one_pass.one_pass(&plan, steps)),
        ];
        self.add(name, "verlet", &race(FEW_ROUNDS, (sites * steps) as f64, racers));
    }

    /// Measures Verlet on bodies, in nanoseconds per pair and step.
    fn bodies<H: Hamiltonian<Coords = Vec<[f64; 3]>>>(&mut self, name: &str, system: &H, mut by_hand: Bodies, h: f64) {
        let count = by_hand.count();
        let start = Phase::new(
            (0..count).map(|i| by_hand.body(i)[0]).collect::<Vec<_>>(),
            (0..count).map(|i| by_hand.body(i)[1]).collect(),
        );
        let plan = Plan::of::<Verlet>(h);
        let pairs = count * (count - 1) / 2;
        let steps = (10_000_000 / pairs as u64).max(2);
        // Racers measure the CPU time of one thread.
        let mut run = system.run_with::<f64, Verlet>(Verlet, start, h).expect("a start").with_threads(1);
        let racers = vec![
            Racer::new("generated", || run.advance(steps).expect("finite states")),
            Racer::new("tiles", || by_hand.advance(&plan, steps)),
        ];
        self.add(name, "verlet", &race(FEW_ROUNDS, pairs as f64 * steps as f64, racers));
    }
}

fn small_problems(report: &mut Report) {
    let problems = Problems::default();

    let pendulum = problems.pendulum();
    let columns = [2.0, 0.0, 1.0, 1.0];
    report.small_in_all(
        &pendulum,
        0.01,
        &[
            ("plain", Box::new(|plan, steps| plain::pendulum(&pendulum.system, pendulum.start, plan, steps).q[0])),
            ("own sine", Box::new(move |plan, steps| scalar(Point::Pendulum, columns, plan, steps)[0])),
        ],
    );

    let columns = [0.1, 0.0, 0.0, 0.5];
    report.small_in_all(
        &problems.henon_heiles(),
        0.01,
        &[("plain", Box::new(move |plan, steps| scalar(Point::HenonHeiles, columns, plan, steps)[0]))],
    );

    report.small(
        &problems.coupled_oscillators(),
        Aba864,
        0.01,
        &[("plain", Box::new(move |plan, steps| oscillators::henon_heiles([columns], plan, steps)[0][0]))],
    );

    let by_hand: HandWritten = ("scalars", Box::new(move |plan, steps| carried::henon_heiles(columns, plan, steps)));
    report.compensated(&problems.henon_heiles(), KahanLi8, 0.01, by_hand);

    let columns = [0.4, 0.0, 0.0, 2.0];
    report.small_in_all(
        &problems.kepler(),
        0.001,
        &[
            ("plain", Box::new(move |plan, steps| scalar(Point::Kepler, columns, plan, steps)[0])),
            ("vectors", Box::new(move |plan, steps| wide(Point::Kepler, columns, plan, steps)[0])),
        ],
    );

    let solar = problems.solar();
    report.small_in_all(
        &solar,
        10.0,
        &[
            ("plain", Box::new(|plan, steps| plain::solar(&solar.system, solar.start, plan, steps).q[0][0])),
            ("ring", Box::new(|plan, steps| row::solar(&solar.system, solar.start, plan, steps).q[0][0])),
        ],
    );

    let by_hand: HandWritten =
        ("ring", Box::new(|plan, steps| carried::solar(&solar.system, solar.start, plan, steps)[0]));
    report.compensated(&solar, KahanLi8, 10.0, by_hand);

    let chain = problems.chain();
    report.small_in_all(
        &chain,
        0.05,
        &[
            ("plain", Box::new(|plan, steps| plain::chain(&chain.system, chain.start, plan, steps).q[0])),
            ("blocks", Box::new(|plan, steps| row::chain(&chain.system, chain.start, plan, steps).q[0])),
        ],
    );
    let by_hand: HandWritten =
        ("blocks", Box::new(|plan, steps| carried::chain(&chain.system, chain.start, plan, steps)[0]));
    report.compensated(&chain, KahanLi8, 0.05, by_hand);
}

fn large_problems(report: &mut Report) {
    let alpha = 0.25;
    for (name, sites) in [("fput_1e4", 10_000), ("fput_1e5", 100_000), ("fput_1e6", 1_000_000)] {
        report.chain(name, &Fput { alpha }, Law::Fput { alpha }, sites);
    }
    let stiffness = 0.7;
    report.chain("toda_1e4", &Toda, Law::Toda, 10_000);
    report.chain("sine_gordon_1e4", &SineGordon { stiffness }, Law::SineGordon { stiffness }, 10_000);
    report.chain("phi4_1e4", &Phi4 { stiffness }, Law::Phi4 { stiffness }, 10_000);
    report.plane("phi4_2d", Phi4Plane { stiffness }, 256);
    report.plane("phi4_2d_2e6", Phi4Plane { stiffness }, 8192);

    let (system, start) = cluster(1000);
    let by_hand = Bodies::new(Attraction::Gravity, &system.masses, &start.q, &start.p);
    report.bodies("nbody_1000", &system, by_hand, 1e-3);
    // Too few atoms for neighbour lists.
    let (system, start) = argon(376);
    let attraction = Attraction::LennardJones { cutoff: system.cutoff };
    report.bodies("argon_376", &system, Bodies::new(attraction, &vec![1.0; 376], &start.q, &start.p), 1e-4);
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("ns per force evaluation of a small system, per site of a lattice, per pair of bodies");
    let table = Table::new("step", &["problem", "composition", "generated", "plain", "by hand", "ratio"]);
    let mut report = Report { table, ratios: Vec::new(), rows: Vec::new() };
    small_problems(&mut report);
    large_problems(&mut report);
    report.table.write()?;
    dots(
        &folder().join("step"),
        &Dots {
            title: "Time of a force evaluation, relative to hand-written code".to_owned(),
            better: "Left of 1, generated code is faster; the band covers ratios from 0.9 to 1.05".to_owned(),
            axis: "time / time of the best hand-written stepper".to_owned(),
            series: vec!["generated".to_owned(), "hand-written, plain loops".to_owned()],
            band: [0.9, 1.05],
            rows: report.rows,
        },
    )?;
    report.ratios.iter().for_each(|line| println!("{line}"));
    Ok(())
}
