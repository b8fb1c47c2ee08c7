//! Compares spellings of the same Hamiltonian: `cargo bench -p integrator-bench --bench spelling`, or with `-- images triplets` the groups
//! of these names alone.
//!
//! A group has one Hamiltonian, and each row is one way of writing it. Times are per step of `Verlet` on one thread, in
//! interleaved rounds. The last column is the time over the fastest of the group. A row that says much more than one has no fast
//! form yet. The last lines are the largest such ratio of each group (`ratio_<group>=`).

mod bodies;
mod fields;
mod liquids;
mod pairs;
mod polymers;
mod sums;
mod triplets;

use integrator_bench::{
    race::{Racer, race},
    table::Table,
};
use std::error::Error;

/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 7;

/// The spellings of one Hamiltonian, with the energies of their starts.
struct Group<'a> {
    name: &'static str,
    steps: u64,
    racers: Vec<Racer<'a>>,
    energies: Vec<f64>,
}

impl<'a> Group<'a> {
    fn new(name: &'static str, steps: u64) -> Self {
        Self { name, steps, racers: Vec::new(), energies: Vec::new() }
    }

    fn add(&mut self, spelling: &'static str, energy: f64, mut advance: impl FnMut(u64) + 'a) {
        let steps = self.steps;
        self.energies.push(energy);
        self.racers.push(Racer::new(spelling, move || advance(steps)));
    }
}

/// Adds a run of each system to a group. The systems have the same parameters and the same start.
macro_rules! spellings {
    ($group:expr, $parameters:expr, $start:expr, $step:expr; $($spelling:literal $system:ident),* $(,)?) => {
        $(
            let mut run = $system($parameters).run($start, $step).expect("a good start").with_threads(1);
            $group.add($spelling, run.energy(), move |steps| run.advance(steps).expect("finite states"));
        )*
    };
}
pub(crate) use spellings;

/// A potential of the module's own `Data`, with masses of one.
macro_rules! of_data {
    ($name:ident, $coordinates:ty, |$self:ident, $q:ident| $potential:expr) => {
        struct $name(#[allow(dead_code, reason = "a funnel reads no data")] Data);

        #[hamiltonian]
        impl $name {
            fn kinetic(&self, p: $coordinates) -> f64 {
                p.iter().map(|p| 0.5 * p * p).sum()
            }
            fn potential(&$self, $q: $coordinates) -> f64 {
                $potential
            }
        }
    };
    ($name:ident, |$self:ident, $q:ident| $potential:expr) => {
        $crate::of_data!($name, &[f64], |$self, $q| $potential);
    };
}
pub(crate) use of_data;

fn main() -> Result<(), Box<dyn Error>> {
    // Cargo adds `--bench`.
    let named: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let (mut table, mut lines) = (Table::new("spelling", &["group", "spelling", "us/step", "to fastest"]), Vec::new());
    for group in liquids::groups()
        .into_iter()
        .chain(pairs::groups())
        .chain(polymers::groups())
        .chain(bodies::groups())
        .chain(sums::groups())
        .chain(fields::groups())
        .chain(triplets::groups())
        .filter(|group| named.is_empty() || named.iter().any(|name| name == group.name))
    {
        let Group { name, steps, racers, energies } = group;
        // Sums of up to a million terms in different orders.
        let differ = |energy: &f64| (energy - energies[0]).abs() > 1e-9 * energies[0].abs();
        if let Some(other) = energies.iter().position(differ) {
            return Err(format!("{name}: the energies {energies:?} differ, first number {other}").into());
        }
        let times = race(ROUNDS, steps as f64 * 1e3, racers);
        let all = 0..times.names().len();
        let fastest = all.clone().min_by(|a, b| times.median(*a).total_cmp(&times.median(*b))).unwrap_or(0);
        let mut slowest: f64 = 1.0;
        for (racer, spelling) in times.names().iter().enumerate() {
            let ratio = times.ratio(racer, fastest);
            table.row([name, spelling], &[times.median(racer), ratio]);
            slowest = slowest.max(ratio);
        }
        lines.push(format!("ratio_{name}={slowest:.3}"));
    }
    table.write()?;
    lines.iter().for_each(|line| println!("{line}"));
    Ok(())
}
