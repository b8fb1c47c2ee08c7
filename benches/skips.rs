//! Measures the work that generated code saves: `cargo bench -p integrator-bench --features report --bench skips`.
//!
//! Each row compares two variants of a scene in interleaved rounds, and the operations of a drift and a kick as the macro
//! counts them. The slower variant is hand-written where the macro cannot produce it. The last lines, `ratio_<point>=`, are the
//! time of the first variant divided by that of the second.

use integrator_bench::{
    by_hand::{chain::Chain, law::Law},
    plan::Plan,
    plot::{Dots, Row, dots},
    problems::{Argon, Fput},
    race::{Racer, race},
    starts::{argon, cluster, waves},
    table::{Table, folder},
};
use integrator_core::{Coords, prelude::*};
use std::error::Error;

/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 31;

/// Defines a system and stores its source code for the macro's report.
macro_rules! scene {
    ($name:ident { $($field:ident),* }, $($functions:tt)*) => {
        struct $name { $($field: f64),* }
        #[hamiltonian]
        impl $name { $($functions)* }
        impl Scene for $name {
            const TEXT: &str = stringify!(impl $name { $($functions)* });
        }
    };
}

trait Scene {
    const TEXT: &str;

    /// Returns the operations of a drift and a kick: first as written in the derivatives, then as computed.
    fn operations() -> [f64; 2] {
        let item = Self::TEXT.parse().expect("tokens");
        let report = integrator_symbolic::report(Default::default(), item).expect("no mistake");
        [report.operations_written as f64, report.operations_shared as f64]
    }
}

scene! {
    AllCoordinates {},
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        -q[0].cos() - q[1].cos() - q[2].cos()
    }
}
scene! {
    TwoCyclic {},
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        -q[0].cos()
    }
}
scene! {
    Driven { drive },
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        0.5 * q[0] * q[0] + 0.25 * q[0].powi(4) - q[0] * (self.drive * t).cos()
    }
}
scene! {
    Free {},
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0] + 0.25 * q[0].powi(4)
    }
}
scene! {
    ManyParameters { a, b, c },
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / (2.0 * self.a.exp() * self.b.powf(1.3))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.c.sin() / (self.a + self.b).sqrt() * q[0].powi(4) / self.b.ln_1p()
    }
}
scene! {
    TwoParameters { mass, stiffness },
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] * self.mass
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.stiffness * q[0].powi(4)
    }
}
scene! {
    WrittenOut {},
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() - 0.1 / (q[0] * q[0] + q[1] * q[1]).sqrt().powi(3)
    }
}
scene! {
    Named {},
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        let r = (q[0] * q[0] + q[1] * q[1]).sqrt();
        let inverse = 1.0 / r;
        -inverse - 0.1 * inverse * inverse * inverse
    }
}

struct Report {
    table: Table,
    rows: Vec<Row>,
    lines: Vec<String>,
}

impl Report {
    /// Adds a race of `with` against `without`, and the operations of each.
    fn add(&mut self, name: &str, scene: &str, units: f64, [without, with]: [Racer; 2], operations: [f64; 2]) {
        let times = race(ROUNDS, units, vec![without, with]);
        let ratio = times.ratio(0, 1);
        self.table.row([name, scene], &[times.median(0), times.median(1), ratio, operations[0], operations[1]]);
        self.rows.push(Row { name: scene.to_owned(), values: vec![ratio] });
        self.lines.push(format!("ratio_{name}={ratio:.3}"));
    }

    /// Compares two generated scenes.
    fn scenes<A: Hamiltonian + Scene, B: Hamiltonian + Scene>(
        &mut self,
        name: &str,
        scene: &str,
        (without, start): (A, Phase<A::Coords>),
        (with, other): (B, Phase<B::Coords>),
    ) where
        A::Coords: Coords<Leaf = f64>,
        B::Coords: Coords<Leaf = f64>,
    {
        let steps = 30_000;
        let racers = [steps_of("without", without, start, steps), steps_of("with", with, other, steps)];
        self.add(name, scene, steps as f64, racers, [A::operations()[1], B::operations()[1]]);
    }
}

/// Takes steps; every round continues from the previous one.
fn steps_of<H: Hamiltonian>(name: &'static str, system: H, start: Phase<H::Coords>, steps: u64) -> Racer<'static>
where
    H::Coords: Coords<Leaf = f64>,
{
    let mut run = system.run_with::<f64, Verlet>(Verlet, start, 1e-3).expect("a start").with_threads(1);
    Racer::new(name, move || run.advance(steps).expect("finite states"))
}

fn small(report: &mut Report) {
    let line = Phase::new([0.7], [0.0]);
    let plane = Phase::new([1.0, 0.0], [0.0, 1.1]);
    let space = Phase::new([0.7, 0.8, 0.9], [0.0; 3]);
    report.scenes(
        "zero_gradients",
        "1 two of three cyclic, or none",
        (TwoCyclic {}, space),
        (AllCoordinates {}, space),
    );
    report.scenes("time", "1 H without time, or with time", (Free {}, line), (Driven { drive: 0.3 }, line));
    report.scenes(
        "parameters",
        "2 two parameters, or formulas of three",
        (TwoParameters { mass: 0.5, stiffness: 0.2 }, line),
        (ManyParameters { a: 0.3, b: 0.8, c: 0.4 }, line),
    );
    report.scenes("shared", "3 r named once, or written out", (Named {}, plane), (WrittenOut {}, plane));

    // Reading the state completes the last step on a copy; without an output, consecutive steps merge.
    let steps = 10_000;
    let run = || Free {}.run_with(KahanLi8, line, 1e-3).expect("a start");
    let (mut merged, mut looked_at) = (run(), run());
    let racers = [
        Racer::new("without", move || merged.advance(steps).expect("finite states")),
        Racer::new("with", move || {
            for _ in 0..steps {
                looked_at.advance(1).expect("finite states");
                std::hint::black_box(looked_at.state());
            }
        }),
    ];
    report.add("merged", "4 merged steps, or every step read", steps as f64, racers, [f64::NAN; 2]);
}

/// Compares the time per site of a long chain with that of a short one. Neither this time nor the code of a kick should
/// grow with the number of sites.
fn loops(report: &mut Report) {
    let chain = |sites: usize, steps: u64| {
        let run = Fput { alpha: 0.25 }.run_with(Verlet, waves(sites), 0.05);
        let mut run = run.expect("a start");
        Racer::new("chain", move || {
            for _ in 0..1_600 / sites {
                run.advance(steps).expect("finite states");
            }
        })
    };
    let racers = [chain(1_600, 1_000), chain(160, 1_000)];
    report.add("loops", "5 one chain of 1600 sites, or ten of 160", 1.6e6, racers, [f64::NAN; 2]);
}

/// A naive hand-written chain: every bond adds to both of its ends.
fn scatter(q: &mut [f64], p: &mut [f64], alpha: f64, h: f64) {
    let bond = |stretch: f64| stretch + alpha * stretch * stretch;
    let last = q.len() - 1;
    p[0] -= h * bond(q[0]);
    p[last] += h * bond(-q[last]);
    for i in 0..last {
        let force = h * bond(q[i + 1] - q[i]);
        p[i] += force;
        p[i + 1] -= force;
    }
    for (q, p) in q.iter_mut().zip(p) {
        *q += h * *p;
    }
}

fn large(report: &mut Report) {
    let (alpha, h) = (0.25, 0.05);
    let plan = Plan::of::<Verlet>(h);
    let generated = |sites: usize, steps: u64| {
        let mut run = Fput { alpha }.run_with(Verlet, waves(sites), h).expect("a start").with_threads(1);
        Racer::new("generated", move || run.advance(steps).expect("finite states"))
    };
    let mut by_hand = waves(10_000);
    let scattered = Racer::new("scatter", move || {
        for _ in 0..200 {
            scatter(&mut by_hand.q, &mut by_hand.p, alpha, h);
        }
    });
    report.add("gather", "6 gather, or hand-written scatter", 2e6, [generated(10_000, 200), scattered], [f64::NAN; 2]);

    let start = waves(1_000_000);
    let mut sweeps = Chain { law: Law::Fput { alpha }, q: start.q, p: start.p };
    let swept = Racer::new("sweeps", move || sweeps.two_pass(&plan, 32));
    report.add(
        "tiled",
        "6 time tiles, or hand-written sweeps",
        3.2e7,
        [generated(1_000_000, 32), swept],
        [f64::NAN; 2],
    );

    let (system, start) = cluster(500);
    let masses = system.masses.clone();
    let pairs = (500 * 499 / 2) as f64;
    let mut run = system.run_with(Verlet, start.clone(), 1e-3).expect("a start");
    let tiles = Racer::new("generated", move || run.advance(8).expect("finite states"));
    let mut state = start;
    let by_hand = Racer::new("pairs", move || (0..8).for_each(|_| pair_by_pair(&mut state, &masses, 1e-3)));
    report.add("pairs", "7 tiles of bodies, or hand-written pairs", 8.0 * pairs, [tiles, by_hand], [f64::NAN; 2]);

    let drop_of = |cutoff: f64| {
        // Too few atoms for neighbour lists.
        let mut run = Argon { cutoff }.run_with(Verlet, argon(376).1, 1e-4).expect("a start");
        Racer::new("argon", move || run.advance(8).expect("finite states"))
    };
    let pairs = (376 * 375 / 2) as f64;
    report.add("branch", "8 cutoff at 2.5, or none", 8.0 * pairs, [drop_of(2.5), drop_of(1e9)], [f64::NAN; 2]);
}

/// Naive hand-written gravity, pair by pair.
fn pair_by_pair(state: &mut Phase<Vec<[f64; 3]>>, masses: &[f64], h: f64) {
    for i in 0..masses.len() {
        for j in 0..i {
            let apart = [0, 1, 2].map(|axis| state.q[i][axis] - state.q[j][axis]);
            let square = apart.iter().map(|x| x * x).sum::<f64>();
            let pull = h * integrator_bench::problems::GRAVITY * masses[i] * masses[j] / (square * square.sqrt());
            for (axis, apart) in apart.into_iter().enumerate() {
                state.p[i][axis] -= pull * apart;
                state.p[j][axis] += pull * apart;
            }
        }
    }
    for ((q, p), mass) in state.q.iter_mut().zip(&state.p).zip(masses) {
        for (q, p) in q.iter_mut().zip(p) {
            *q += h / mass * p;
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("ns per step of a small system, per site or pair of a large one; operations of a drift and a kick");
    let table = Table::new("skips", &["point", "scene", "without", "with", "ratio", "ops", "ops with"]);
    let mut report = Report { table, rows: Vec::new(), lines: Vec::new() };
    small(&mut report);
    loops(&mut report);
    large(&mut report);
    report.table.write()?;
    dots(
        &folder().join("skips"),
        &Dots {
            title: "Work that generated code saves".to_owned(),
            better: "Time of the first variant over that of the second; left of 1, the first variant is faster"
                .to_owned(),
            axis: "time of the first variant / time of the second".to_owned(),
            series: vec!["ratio of times".to_owned()],
            band: [0.1, 1.05],
            rows: report.rows,
        },
    )?;
    report.lines.iter().for_each(|line| println!("{line}"));
    Ok(())
}
