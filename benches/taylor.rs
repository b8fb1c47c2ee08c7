//! Benchmarks Taylor's method, generated and hand-written: `cargo bench -p integrator-bench --bench taylor`.
//!
//! Both sides use the same orders and tolerances, compensated states and the same rule for steps, so they take the same steps
//! with the same errors. A row has the milliseconds of both for the whole span of the problem (medians of interleaved rounds),
//! the nanoseconds of the hand-written stepper per polynomial, and the largest relative energy errors of 256 samples.
//! Hand-written steppers need AVX2 or AVX-512. The last lines:
//!
//! - `ratio_taylor_over_hand_<problem>_<error>=` is the least time to an energy error divided by that of the hand-written
//!   stepper, each the best of the same orders and tolerances. The target is 1.1.
//! - `ratio_taylor_by_tolerance_over_best_<problem>_<error>=` is the least time to an energy error by a tolerance alone,
//!   divided by that of the best even order from 10 to 28.
//! - `ratio_taylor_lanes_over_alone_<problem>=` is the time of an ensemble in one thread divided by that of its members one
//!   after the other.

use integrator_bench::{
    Instructions,
    by_hand::taylor::{self, Course, ORDERS},
    precision::{Curve, Kind, Point, best},
    race::{Racer, race},
    starts::{Problem, Problems},
    table::Table,
};
use integrator_core::{
    Compensated, Coords,
    prelude::*,
    taylor::{Recurrences, Taylor},
};
use std::{error::Error, ops::RangeInclusive};

/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 15;
/// Number of energy samples.
const LOOKS: u32 = 256;
/// Energy errors at which times are compared.
const ERRORS: [(f64, &str); 3] = [(1e-8, "1e-8"), (1e-10, "1e-10"), (1e-12, "1e-12")];

/// Decades of tolerances, and the fixed orders that are compared with the automatic choice.
const DECADES: RangeInclusive<u32> = 4..=18;
const FIXED: RangeInclusive<usize> = 10..=28;

/// Number of members of an ensemble, and step of a run.
const MEMBERS: usize = 256;
const STEP: f64 = 10.0;

/// A hand-written integrator: passes its states to the callback, and returns the number of polynomials.
type HandWritten<'t, C> = &'t dyn Fn(Course, &mut dyn FnMut(Phase<C>)) -> u64;

/// A run with compensated states.
type CompensatedRun<C> = Run<<C as Coords>::With<Compensated<f64>>>;

struct Report {
    table: Table,
    choices: Vec<String>,
    ratios: Vec<String>,
}

impl Report {
    /// Measures eight tolerances from `10^-first` on, a decade apart.
    fn add<H: Hamiltonian + Recurrences>(
        &mut self,
        problem: &Problem<H>,
        first: i32,
        by_hand: HandWritten<H::Coords>,
    ) -> Result<(), Box<dyn Error>>
    where
        H::Coords: Coords<Leaf = f64>,
    {
        let mut curves = [Vec::new(), Vec::new()];
        for order in ORDERS {
            let mut points = [Vec::new(), Vec::new()];
            for tolerance in (first..first + 8).map(|decade| 10.0_f64.powi(-decade)) {
                let row = self.race(problem, order, tolerance, by_hand)?;
                points.iter_mut().zip(row).for_each(|(points, point)| points.push(point));
            }
            for ((side, points), ours) in curves.iter_mut().zip(points).zip([true, false]) {
                side.push(Curve { method: format!("Taylor {order}"), ours, points });
            }
        }
        for (error, text) in ERRORS {
            let [ours, by_hand] = [0, 1].map(|side| best(&curves[side], Kind::Energy, error));
            if let Some(((ours, order), (by_hand, other))) = ours.zip(by_hand) {
                let name = problem.name;
                let [name_of, ratio] = [format!("{name}_{text}"), format!("{:.3}", ours / by_hand)];
                let times = format!("{ours:>9.4} ms by {order}; by hand {by_hand:>9.4} ms by {other}");
                self.choices.push(format!("{name_of:<16} {times}; ratio {ratio}"));
                self.ratios.push(format!("ratio_taylor_over_hand_{name_of}={ratio}"));
            }
        }
        Ok(())
    }

    /// Measures the generated and the hand-written integrator.
    fn race<H: Hamiltonian + Recurrences>(
        &mut self,
        problem: &Problem<H>,
        order: usize,
        tolerance: f64,
        by_hand: HandWritten<H::Coords>,
    ) -> Result<[Point; 2], Box<dyn Error>>
    where
        H::Coords: Coords<Leaf = f64>,
    {
        let Problem { name, system, start, span, reference } = problem;
        let method = Taylor::tolerance(tolerance).with_order(order);
        let course = |looks| Course { order, tolerance, span: *span, looks };
        let energy = |state| Ok::<_, integrator_core::Error>(system.run_with::<f64, _>(Verlet, state, *span)?.energy());
        let exact = energy(start.clone())?;
        let errors = errors(problem, method)?;
        let mut states = Vec::new();
        let polynomials = by_hand(course(LOOKS), &mut |state| states.push(state));
        let (mut worst, mut end) = (0.0_f64, Vec::new());
        for state in states {
            end = state.q.flat().to_vec();
            worst = worst.max((energy(state)? / exact - 1.0).abs());
        }
        let errors_by_hand = [worst, distance(&end, reference)];

        let racers = vec![
            Racer::new("generated", || {
                let mut run = begin(problem, method, 1).expect("a start");
                run.advance(1).expect("finite states");
                run.state()
            }),
            Racer::new("by hand", || {
                let mut end = None;
                by_hand(course(1), &mut |state| end = Some(state));
                end
            }),
        ];
        // Nanoseconds per million units are milliseconds.
        let times = race(ROUNDS, 1e6, racers);
        let [ours, theirs] = [times.median(0), times.median(1)];
        let per_polynomial = theirs * 1e6 / polynomials as f64;
        self.table.row(
            [name, &format!("order {order}, {tolerance:.0e}")],
            &[polynomials as f64, per_polynomial, theirs, ours, times.ratio(0, 1), errors_by_hand[0], errors[0]],
        );
        let point = |milliseconds, [energy, global]: [f64; 2]| Point { milliseconds, energy, global };
        Ok([point(ours, errors), point(theirs, errors_by_hand)])
    }
}

/// Creates a run with a step of the span divided by `looks`.
fn begin<H: Hamiltonian + Recurrences>(
    Problem { system, start, span, .. }: &Problem<H>,
    method: Taylor,
    looks: u32,
) -> Result<CompensatedRun<H::Coords>, integrator_core::Error>
where
    H::Coords: Coords<Leaf = f64>,
{
    let start = Phase::compensated(start.q.clone(), start.p.clone());
    system.run_with::<Compensated<f64>, _>(method, start, span / f64::from(looks))
}

/// Returns the largest relative energy error, and the distance from the reference at the end.
fn errors<H: Hamiltonian + Recurrences>(
    problem: &Problem<H>,
    method: Taylor,
) -> Result<[f64; 2], integrator_core::Error>
where
    H::Coords: Coords<Leaf = f64>,
{
    let exact = begin(problem, method, 1)?.energy();
    let (mut worst, mut end) = (0.0_f64, Vec::new());
    for sample in begin(problem, method, LOOKS)?.samples(1).take(LOOKS as usize + 1) {
        let sample = sample?;
        worst = worst.max((sample.energy() / exact - 1.0).abs());
        end = sample.state.q.flat().iter().map(|leaf| leaf.value).collect();
    }
    Ok([worst, distance(&end, &problem.reference)])
}

/// Returns the distance of positions from the reference, relative to its norm.
fn distance(q: &[f64], reference: &[f64]) -> f64 {
    let square = |numbers: &mut dyn Iterator<Item = f64>| numbers.map(|x| x * x).sum::<f64>();
    let apart = square(&mut q.iter().zip(reference).map(|(q, reference)| q - reference));
    (apart / square(&mut reference[..q.len()].iter().copied())).sqrt()
}

/// Compares tolerance alone, with automatic order, to the best fixed order at each energy error.
fn by_tolerance<H: Hamiltonian + Recurrences>(problem: &Problem<H>)
where
    H::Coords: Coords<Leaf = f64>,
{
    let curve = |name: String, method: &dyn Fn(f64) -> Taylor| {
        let method = |decade: u32| method(10.0_f64.powi(-(decade as i32)));
        let run = |decade| begin(problem, method(decade), 1).and_then(|mut run| run.advance(1)).expect("finite states");
        Curve::measure(name, true, DECADES, |decade| errors(problem, method(decade)).ok(), run)
    };
    let fixed =
        FIXED.step_by(2).map(|order| curve(format!("order {order}"), &|t| Taylor::tolerance(t).with_order(order)));
    let fixed: Vec<_> = fixed.collect();
    let free = curve("tolerance".to_owned(), &Taylor::tolerance);
    for (error, text) in [(1e-6, "1e-6")].into_iter().chain(ERRORS) {
        if let Some(((least, order), time)) = best(&fixed, Kind::Energy, error).zip(free.time_to(Kind::Energy, error)) {
            let ratio = time / least;
            println!("ratio_taylor_by_tolerance_over_best_{}_{text}={ratio:.3} (best: {order})", problem.name);
        }
    }
}

/// Compares the time of an ensemble of close orbits with that of its members one after the other.
fn lanes<H: Hamiltonian + Recurrences + Copy>(
    Problem { name, system, start, .. }: &Problem<H>,
) -> Result<(), Box<dyn Error>>
where
    H::Coords: Coords<Leaf = f64>,
{
    let method = Taylor::tolerance(1e-15);
    let members = (0..MEMBERS).map(|member| {
        let shrunk = |part: &H::Coords| part.map(|leaf| leaf * (1.0 - 1e-3 * member as f64 / MEMBERS as f64));
        (*system, Phase::new(shrunk(&start.q), shrunk(&start.p)))
    });
    let members: Vec<(H, Phase<H::Coords>)> = members.collect();
    let runs = members.iter().map(|(system, start)| system.run_with::<f64, _>(method, start.clone(), STEP));
    let mut runs = runs.collect::<Result<Vec<_>, _>>()?;
    let mut swarm = Ensemble::new(method, members, STEP)?.with_threads(1);
    let racers = vec![
        Racer::new("lanes", || swarm.advance(1).expect("finite states")),
        Racer::new("alone", || runs.iter_mut().for_each(|run| run.advance(1).expect("finite states"))),
    ];
    println!("ratio_taylor_lanes_over_alone_{name}={:.3}", race(ROUNDS, 1.0, racers).ratio(0, 1));
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    if Instructions::chosen() == Instructions::Baseline {
        println!("no hand-written steppers: these are written for AVX2 and AVX-512");
        return Ok(());
    }
    let head = ["polynomials", "ns each", "by hand", "generated", "ratio", "its error", "error"];
    let head: Vec<&str> = ["problem", "method"].into_iter().chain(head).collect();
    let mut report = Report { table: Table::new("taylor", &head), choices: Vec::new(), ratios: Vec::new() };
    let problems = Problems::default();
    let pendulum = problems.pendulum();
    report.add(&pendulum, 8, &|course, see| taylor::pendulum(&pendulum.system, &pendulum.start, course, see))?;
    let henon = problems.henon_heiles();
    report.add(&henon, 8, &|course, see| taylor::henon_heiles(&henon.start, course, see))?;
    let kepler = problems.kepler();
    report.add(&kepler, 8, &|course, see| taylor::kepler(&kepler.start, course, see))?;
    let solar = problems.solar();
    report.add(&solar, 8, &|course, see| taylor::solar(&solar.system, &solar.start, course, see))?;
    let chain = problems.chain();
    report.add(&chain, 8, &|course, see| taylor::chain(&chain.system, &chain.start, course, see))?;
    report.table.write()?;
    println!("\nTo each energy error, the best of the orders on both sides:");
    report.choices.iter().chain(&report.ratios).for_each(|line| println!("{line}"));
    by_tolerance(&pendulum);
    by_tolerance(&henon);
    by_tolerance(&kepler);
    by_tolerance(&solar);
    by_tolerance(&chain);
    lanes(&pendulum)?;
    lanes(&henon)?;
    lanes(&kepler)
}
