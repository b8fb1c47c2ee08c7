//! Finds the cheapest composition and step for a system: `choose SYSTEM TOLERANCE [energy]`.
//!
//! SYSTEM is one of pendulum, `henon_heiles`, kepler, fput and `outer_solar_system`. The program prints the compositions that
//! keep the trajectory (or the energy) within the tolerance, cheapest first: the step, the measured error, and the work in
//! force evaluations. A smaller tolerance favours a higher order.

#[path = "../outer_solar_system/system.rs"]
#[expect(dead_code, reason = "the other example also compares with a reference")]
mod outer_solar_system;
mod systems;

use integrator_core::{
    check::{Goal, choose},
    prelude::*,
};
use std::error::Error;
use systems::{Problem, fput, henon_heiles, kepler, pendulum};

fn report<H: Hamiltonian>(problem: Problem<H>, goal: Goal) -> Result<(), Box<dyn Error>>
where
    H::Coords: integrator_core::Coords<Leaf = f64>,
{
    println!("{}", choose::<H, f64>(&problem.system, problem.start, problem.span, goal)?);
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (system, tolerance, energy) = match &arguments[..] {
        [] => ("kepler", "1e-9", false),
        [system, tolerance] => (system.as_str(), tolerance.as_str(), false),
        [system, tolerance, goal] if goal == "energy" => (system.as_str(), tolerance.as_str(), true),
        _ => return Err("usage: choose SYSTEM TOLERANCE [energy]".into()),
    };
    let tolerance = tolerance.parse()?;
    let goal = if energy { Goal::Energy(tolerance) } else { Goal::Trajectory(tolerance) };
    match system {
        "pendulum" => report(pendulum(), goal),
        "henon_heiles" => report(henon_heiles(), goal),
        "kepler" => report(kepler(), goal),
        "fput" => report(fput(), goal),
        "outer_solar_system" => {
            let (system, start) = outer_solar_system::measured()?;
            // 27 years, two and a third periods of Jupiter.
            report(Problem { system, start, span: 10_000.0 }, goal)
        }
        other => {
            Err(format!("no system is called {other}: pendulum, henon_heiles, kepler, fput and outer_solar_system are")
                .into())
        }
    }
}
