//! Benchmarks the throughput of ensembles, chains, lattices and many bodies: `cargo bench -p integrator-bench --bench throughput`.
//!
//! Ensembles are compared with hand-written groups of vectors, whose sine has the same accuracy. Chains are compared with two
//! plain loops and with time-skewed tiles, and bodies with tiles that use the third law. The last lines are rates divided by
//! those of the best hand-written stepper in the same round (`ratio_<scene>_to_hand=`; the target is 0.9), and the gain from a
//! second thread (`speedup_<scene>_two_threads=`). `docs/performance.md` has the results.

use integrator_bench::{
    by_hand::{
        chain::Chain,
        field::{Field, Layer},
        law::Law,
        points::Point,
        swarm::Swarm,
        tiles::{Attraction, Bodies},
    },
    plan::Plan,
    plot::{Dots, Row, dots, named},
    problems::{FastPendulum, Fput, HenonHeiles, Kepler, Pendulum, Phi4Volume, Phi4WidePlane},
    race::{Racer, race},
    starts::{cluster, planes_of_waves, rows_of_waves, waves},
    table::{Table, folder},
};
use integrator_core::{Coords, prelude::*};
use std::error::Error;

/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 31;
/// Number of trajectories in an ensemble: a few hundred groups of vectors.
const MEMBERS: usize = 8192;
/// A small ensemble, of one group of vectors.
const FEW: usize = 64;
/// Steps of all members per round of an ensemble.
const STEPS: usize = 8_192_000;
/// Step of a lattice.
const STEP: f64 = 0.05;

struct Report {
    table: Table,
    lines: Vec<String>,
    rows: Vec<Row>,
}

impl Report {
    /// Adds a scene: units per second of the generated code, with one and two threads, and of the hand-written
    /// steppers.
    fn add(&mut self, scene: &str, unit: &str, rounds: usize, units: f64, racers: Vec<Racer>) {
        let times = race(rounds, units, racers);
        let place = |name| times.names().iter().position(|racer| *racer == name);
        let rate = |name| place(name).map_or(f64::NAN, |i| 1e9 / times.median(i));
        let by_hand = place("by hand").expect("a hand-written stepper");
        let to_hand = 1.0 / times.ratio(0, by_hand);
        let plain = place("plain").map_or(f64::NAN, |plain| times.ratio(by_hand, plain));
        self.rows.push(Row { name: named(scene).to_owned(), values: vec![to_hand, plain] });
        let two = place("one thread").zip(place("two threads")).map_or(f64::NAN, |(one, two)| times.ratio(one, two));
        self.table.row([scene, unit], &[rate("generated"), rate("plain"), rate("by hand"), to_hand, two]);
        self.lines.push(format!("ratio_{scene}_to_hand={to_hand:.3}"));
        if two.is_finite() {
            self.lines.push(format!("speedup_{scene}_two_threads={two:.3}"));
        }
        if let Some(plain) = place("plain") {
            self.lines.push(format!("speedup_{scene}_over_plain_loops={:.3}", times.ratio(plain, 0)));
        }
    }

    fn chain(&mut self, name: &str, sites: usize) {
        let (law, start) = (Law::Fput { alpha: 0.25 }, waves(sites));
        let plan = Plan::of::<Verlet>(STEP);
        // As many steps as a long run takes between two outputs.
        let steps = (2_000_000 / sites).max(1024);
        let generated = Fput { alpha: 0.25 }.run_with(Verlet, start.clone(), STEP).expect("a start");
        let by_hand = Chain { law, q: start.q, p: start.p };
        let [mut plain, mut skewed] = [by_hand.clone(), by_hand];
        let (plain, skewed) = (|| plain.two_pass(&plan, steps), || skewed.skewed(&plan, steps));
        self.lattice(name, if sites > 1_000_000 { 5 } else { 15 }, [sites, steps], generated, plain, skewed);
    }

    /// Measures a field on rows or planes.
    fn field<T: Layer>(
        &mut self,
        name: &str,
        system: impl Hamiltonian<Coords = Vec<T>>,
        stiffness: f64,
        start: Phase<Vec<T>>,
    ) where
        Vec<T>: Coords<Leaf = f64, With<f64> = Vec<T>>,
    {
        let plan = Plan::of::<Verlet>(STEP);
        let (sites, steps) = (start.q.len() * T::SITES, 256);
        let generated = system.run_with::<f64, _>(Verlet, start.clone(), STEP).expect("a start");
        let by_hand = Field { stiffness, q: start.q, p: start.p };
        let [mut plain, mut skewed] = [by_hand.clone(), by_hand];
        let (plain, skewed) = (|| plain.two_pass(&plan, steps), || skewed.skewed(&plan, steps));
        self.lattice(name, 3, [sites, steps], generated, plain, skewed);
    }

    /// Compares a lattice with two plain loops and with hand-written time skewing.
    fn lattice<C: Coords<Leaf = f64>>(
        &mut self,
        name: &str,
        rounds: usize,
        [sites, steps]: [usize; 2],
        generated: Run<C>,
        plain: impl FnMut(),
        skewed: impl FnMut(),
    ) {
        let generated = generated.with_threads(1);
        let [mut run, mut wall] = [generated.clone(), generated.clone()];
        let mut two = generated.with_threads(2);
        let racers = vec![
            Racer::new("generated", || run.advance(steps as u64).expect("finite states")),
            Racer::new("plain", plain),
            Racer::new("by hand", skewed),
            Racer::new("two threads", || two.advance(steps as u64).expect("finite states")).in_threads(),
            Racer::new("one thread", || wall.advance(steps as u64).expect("finite states")).in_threads(),
        ];
        self.add(name, "site-steps/s", rounds, (sites * steps) as f64, racers);
    }

    fn bodies(&mut self, name: &str, count: usize) {
        let (system, start) = cluster(count);
        let h = 1e-3;
        let plan = Plan::of::<Verlet>(h);
        let mut by_hand = Bodies::new(Attraction::Gravity, &system.masses, &start.q, &start.p);
        let generated = system.run_with(Verlet, start, h).expect("a start").with_threads(1);
        let [mut run, mut wall] = [generated.clone(), generated.clone()];
        let mut two = generated.with_threads(2);
        let pairs = count * (count - 1) / 2;
        let steps = (10_000_000 / pairs as u64).max(2);
        let racers = vec![
            Racer::new("generated", || run.advance(steps).expect("finite states")),
            Racer::new("by hand", || by_hand.advance(&plan, steps)),
            Racer::new("two threads", || two.advance(steps).expect("finite states")).in_threads(),
            Racer::new("one thread", || wall.advance(steps).expect("finite states")).in_threads(),
        ];
        let rounds = if count > 1_000 { 7 } else { 15 };
        self.add(name, "pairs/s", rounds, pairs as f64 * steps as f64, racers);
    }
}

/// Compares an ensemble, with one and with two threads, with its hand-written stepper.
macro_rules! ensemble {
    ($report:ident, $scene:literal, $count:expr, $number:ident, $point:expr, $columns:expr, $member:expr) => {{
        let (h, steps) = (0.01, (STEPS / $count) as u64);
        let columns: Vec<[f64; 4]> = (0..$count).map(|i| $columns(i as f64 / $count as f64)).collect();
        let members = || columns.iter().map($member);
        let mut one = Ensemble::new(Verlet, members(), h).expect("members").with_threads(1);
        // One thread in wall-clock time, for comparison with two threads.
        let mut wall = Ensemble::new(Verlet, members(), h).expect("members").with_threads(1);
        let mut two = Ensemble::new(Verlet, members(), h).expect("members").with_threads(2);
        let mut by_hand = Swarm::<$number>::new($point, &columns);
        let plan = Plan::of::<Verlet>(h);
        let racers = vec![
            Racer::new("generated", || one.advance(steps).expect("finite states")),
            Racer::new("by hand", || by_hand.advance(&plan, steps)),
            Racer::new("two threads", || two.advance(steps).expect("finite states")).in_threads(),
            Racer::new("one thread", || wall.advance(steps).expect("finite states")).in_threads(),
        ];
        $report.add($scene, "trajectory-steps/s", ROUNDS, STEPS as f64, racers);
    }};
}

/// Converts coordinates to the required precision.
macro_rules! planar {
    ($system:expr, $number:ident) => {
        |&[x, y, px, py]: &[f64; 4]| ($system, Phase::new([x as $number, y as $number], [px as $number, py as $number]))
    };
}

fn ensembles(report: &mut Report) {
    // Pendulums of many lengths, so that no parameter is shared. The columns contain angle, momentum, and inverse
    // inertia and torque for a bob of mass 1 and gravity 1.
    let pendulum = |x: f64| {
        let length = 0.5 + x;
        [0.5 + 2.0 * x, 0.0, 1.0 / (length * length), length]
    };
    let system = |length: f64| Pendulum { mass: 1.0, length, gravity: 1.0 };
    let double = |&[q, p, _, length]: &[f64; 4]| (system(length), Phase::new([q], [p]));
    let single = |&[q, p, _, length]: &[f64; 4]| (system(length), Phase::new([q as f32], [p as f32]));
    let fast = |columns: &[f64; 4]| {
        let (system, start) = double(columns);
        (FastPendulum(system), start)
    };
    ensemble!(report, "pendulum", MEMBERS, f64, Point::Pendulum, pendulum, double);
    ensemble!(report, "pendulum_fast", MEMBERS, f64, Point::FastPendulum, pendulum, fast);
    ensemble!(report, "pendulum_f32", MEMBERS, f32, Point::Pendulum, pendulum, single);

    let henon = |x: f64| [0.1 + 0.2 * x, 0.1 * x, 0.0, 0.3];
    ensemble!(report, "henon", MEMBERS, f64, Point::HenonHeiles, henon, planar!(HenonHeiles, f64));
    ensemble!(report, "henon_64", FEW, f64, Point::HenonHeiles, henon, planar!(HenonHeiles, f64));
    ensemble!(report, "henon_f32", MEMBERS, f32, Point::HenonHeiles, henon, planar!(HenonHeiles, f32));

    let kepler = |x: f64| [0.6 + 0.4 * x, 0.0, 0.0, 1.0 + 0.2 * x];
    ensemble!(report, "kepler", MEMBERS, f64, Point::Kepler, kepler, planar!(Kepler, f64));
    ensemble!(report, "kepler_64", FEW, f64, Point::Kepler, kepler, planar!(Kepler, f64));
    ensemble!(report, "kepler_f32", MEMBERS, f32, Point::Kepler, kepler, planar!(Kepler, f32));
}

fn main() -> Result<(), Box<dyn Error>> {
    let head = ["scene", "unit", "generated", "plain", "by hand", "to hand", "2 threads"];
    let mut report = Report { table: Table::new("throughput", &head), lines: Vec::new(), rows: Vec::new() };
    ensembles(&mut report);
    for (name, sites) in
        [("fput_1e4", 10_000), ("fput_1e5", 100_000), ("fput_1e6", 1_000_000), ("fput_1e7", 10_000_000)]
    {
        report.chain(name, sites);
    }
    let stiffness = 0.7;
    report.field("phi4_4096x4096", Phi4WidePlane { stiffness }, stiffness, rows_of_waves(4096));
    report.field("phi4_128x128x128", Phi4Volume { stiffness }, stiffness, planes_of_waves(128));
    for (name, count) in [("nbody_100", 100), ("nbody_1000", 1_000), ("nbody_10000", 10_000)] {
        report.bodies(name, count);
    }
    report.table.write()?;
    dots(
        &folder().join("throughput"),
        &Dots {
            title: "Throughput of one thread, relative to hand-written code".to_owned(),
            better: "Right of 1, generated code is faster; the band covers ratios from 0.9 to 1.1".to_owned(),
            axis: "rate / rate of the best hand-written stepper".to_owned(),
            series: vec!["generated".to_owned(), "hand-written, plain loops".to_owned()],
            band: [0.9, 1.1],
            rows: report.rows,
        },
    )?;
    report.lines.iter().for_each(|line| println!("{line}"));
    Ok(())
}
