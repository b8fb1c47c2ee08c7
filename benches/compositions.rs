//! The time of a force evaluation inside every composition, against Verlet's: `cargo bench --bench compositions`.
//!
//! A run loops over a static table of stages, so a step of 35 stages should cost 35 times that of Verlet. The last lines,
//! `ratio_<problem>_<composition>=`, are nanoseconds per force evaluation over those of Verlet in the same turn, medians
//! of interleaved turns: 1.03 is asked. Met on the pendulum (0.85 to 1.01), on Hénon-Heiles (1.01 at most), on Kepler
//! (1.01) and on the outer solar system (1.01); not on FPUT-32, where a longer table costs 1.05 with the kick first and
//! 1.08 to 1.12 with the drift first.
//!
//! A gradient of the squared force is counted as no evaluation here, so that the ratios of compositions in which every
//! kick has one (`Chin4B`) tell what it costs: a kick with gradient takes the time of 1.3 forces on the pendulum, 1.6 on
//! Kepler, 2 on Hénon-Heiles, 3.6 on FPUT-32 and 4.9 on the outer solar system.
//!
//! A table costs little to compile: a program that runs the outer solar system by ten compositions takes 2.1 s of CPU time
//! in release, libraries aside, and 0.6 s by one; under 4 s is asked.

#[path = "../examples/outer_solar_system/system.rs"]
#[expect(dead_code, reason = "the example also compares with a reference")]
mod outer_solar_system;
mod paired;
#[path = "../examples/choose/systems.rs"]
mod systems;

use integrator_core::{Coords, Visitor, prelude::*};
use paired::{Comparison, compare};
use std::{cell::RefCell, hint::black_box};
use systems::{Problem, fput, henon_heiles, kepler, pendulum};

/// Force evaluations of one computation: divisible by the number of kicks of nearly every composition.
const EVALUATIONS: u64 = 2 * 2 * 2 * 3 * 3 * 5 * 7 * 11;

/// A step so short that no composition strays from the orbit.
const SHORTENING: f64 = 1e-5;

struct Ratios<'p, H: Hamiltonian> {
    problem: &'p Problem<H>,
    rows: Vec<(&'static str, Comparison)>,
}

impl<H: Hamiltonian> Visitor<H> for Ratios<'_, H>
where
    H::Coords: Coords<Leaf = f64>,
{
    fn visit<X: Composition<H>>(&mut self, _: X) {
        self.rows.push((X::NAME, compare(EVALUATIONS, self.evaluated::<X>(), self.evaluated::<Verlet>())));
    }
}

impl<H: Hamiltonian> Ratios<'_, H>
where
    H::Coords: Coords<Leaf = f64>,
{
    /// Steps with so many force evaluations in all. Every step of every turn goes on from the last one.
    fn evaluated<X: Composition<H>>(&self) -> impl Fn(u64) -> f64 {
        let Problem { system, start, span } = self.problem;
        let run = system.run_with::<f64, X>(X::default(), start.clone(), span * SHORTENING).expect("a start");
        let run = RefCell::new(run);
        move |evaluations| {
            let mut run = run.borrow_mut();
            run.advance(black_box(evaluations / X::FORCE_EVALUATIONS as u64)).expect("finite states");
            run.time()
        }
    }
}

/// Compares all that the problem admits, and prints nanoseconds per force evaluation.
fn measure<H: Hamiltonian>(name: &'static str, problem: &Problem<H>) -> (&'static str, Vec<(&'static str, f64)>)
where
    H::Coords: Coords<Leaf = f64>,
{
    let mut ratios = Ratios { problem, rows: Vec::new() };
    H::visit_compositions(&mut ratios);
    let row = |(composition, Comparison { first, second, ratio })| {
        println!("{name:<10} {composition:<24} {first:>8.2} {second:>8.2}");
        (composition, ratio)
    };
    (name, ratios.rows.into_iter().map(row).collect())
}

fn main() {
    println!("{:<35} {:>8} {:>8}   ns per force evaluation", "", "", "Verlet");
    let (system, start) = outer_solar_system::measured().expect("the planets");
    let tables = [
        measure("pendulum", &pendulum()),
        measure("henon", &henon_heiles()),
        measure("kepler", &kepler()),
        measure("solar", &Problem { system, start, span: 1e6 }),
        measure("fput", &fput()),
    ];
    for (problem, rows) in tables {
        for (composition, ratio) in rows {
            println!("ratio_{problem}_{composition}={ratio:.3}");
        }
    }
}
