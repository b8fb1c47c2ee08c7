//! CPU time to a global error, by splittings of the outer solar system: `cargo bench -p integrator --bench splitting`.
//!
//! The system of `examples/data/problems.json`, for 999,999 days: split in T + V, by the compositions that are the best
//! at some error; and in Kepler parts and interaction with Jacobi coordinates, by those for a small second part and some
//! others. Compensated states get to errors that plain ones do not. The error is
//! that of the positions at the end, relative to their length, against 113-bit arithmetic. Steps get shorter by half an
//! octave; times in between are interpolated on logarithmic scales. A row is a composition with milliseconds to errors of
//! 1e-4, 1e-6, 1e-8, 1e-10 and 1e-12, nothing where it does not get there.
//!
//! The last lines, `ratio_1e-4=`, are those of the best row by Jacobi coordinates over the best row by T + V. Asked for:
//! 0.35, 0.35, 0.6 and 0.5 from 1e-4 to 1e-10. With `Verlet`, `Aba104`, `Aba1064` and `WisdomHolmanTouma17` alone, against
//! `BlanesMoanSrkn14`, `Teloy8C` and `SofroniouSpaletta10`, these were 0.49, 0.36, 0.67 and 0.63.
//!
//! Each row takes about ten seconds to compile: it is a run of its own for three instruction sets.

use integrator_bench::{
    problems::GRAVITY,
    race::{Racer, race},
    starts::{Problem, Problems},
    table::Table,
};
use integrator_core::{Coords, prelude::*};

/// The errors that times are given for.
const ERRORS: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// The fewest and the most force evaluations of a run, as powers of two.
const EVALUATIONS: [u32; 2] = [9, 19];

/// How often a run is timed; the median counts.
const ROUNDS: usize = 5;

/// The outer solar system in Jacobi coordinates.
#[derive(Clone, Copy)]
struct Jacobi {
    masses: [f64; 6],
}

#[hamiltonian(coordinates = jacobi(self.masses), split = kepler + interaction, compose = Aba1064)]
impl Jacobi {
    fn kinetic(&self, p: &[[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / (2.0 * self.masses[i]);
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                energy -= GRAVITY * self.masses[i] * self.masses[j] / (x * x + y * y + z * z).sqrt();
            }
        }
        energy
    }
}

type Bodies = [[f64; 3]; 6];
type Compensation = [[Compensated<f64>; 3]; 6];

/// The measurements of one splitting.
struct Splitting<'p, H: Hamiltonian> {
    name: &'static str,
    problem: &'p Problem<H>,
    table: &'p mut Table,
    /// The shortest time to each error.
    best: [f64; ERRORS.len()],
}

impl<H: Hamiltonian<Coords = Bodies>> Splitting<'_, H> {
    fn plain<X: Composition<H>>(&mut self) {
        self.measure::<X, Bodies>(X::NAME.to_owned(), self.problem.start, |leaf| leaf);
    }

    fn compensated<X: Composition<H>>(&mut self) {
        let start = Phase::compensated(self.problem.start.q, self.problem.start.p);
        self.measure::<X, Compensation>(format!("{}, compensated", X::NAME), start, |leaf| leaf.value);
    }

    /// Adds a row.
    fn measure<X: Composition<H>, C>(&mut self, name: String, start: Phase<C>, value: fn(C::Leaf) -> f64)
    where
        C: Coords<With<f64> = Bodies>,
        Bodies: Coords<With<C::Leaf> = C>,
    {
        let mut path = Vec::new();
        for half in 2 * EVALUATIONS[0]..2 * EVALUATIONS[1] {
            // Powers of two, and three halves of them.
            let evaluations = (2 + u64::from(half % 2)) << (half / 2 - 1);
            let steps = evaluations / X::FORCE_EVALUATIONS as u64;
            if steps < 256 {
                continue;
            }
            let error = self.run::<X, C>(&start, value, steps);
            let rises = path.last().is_some_and(|(last, _): &(f64, u64)| *last < 1e-9 && error > *last);
            path.push((error, steps));
            if error < ERRORS[ERRORS.len() - 1] || rises {
                break;
            }
        }
        let times = ERRORS.map(|target| self.time_to::<X, C>(&path, &start, value, target));
        for (best, time) in self.best.iter_mut().zip(times) {
            *best = best.min(if time.is_nan() { f64::INFINITY } else { time });
        }
        self.table.row([self.name, &name], &times);
    }

    /// Milliseconds to an error, between the longest step from which on all errors are less and the one before.
    fn time_to<X: Composition<H>, C>(
        &self,
        path: &[(f64, u64)],
        start: &Phase<C>,
        value: fn(C::Leaf) -> f64,
        target: f64,
    ) -> f64
    where
        C: Coords<With<f64> = Bodies>,
        Bodies: Coords<With<C::Leaf> = C>,
    {
        let Some(first) = path.iter().rposition(|(error, _)| *error > target).map_or(Some(0), |last| Some(last + 1))
        else {
            return f64::NAN;
        };
        let Some((error, steps)) = path.get(first) else { return f64::NAN };
        // In units of a million, nanoseconds are milliseconds.
        let time = |steps| race(ROUNDS, 1e6, vec![Racer::new("", || self.run::<X, C>(start, value, steps))]).median(0);
        let shorter = time(*steps);
        let Some((before, longer)) =
            first.checked_sub(1).map(|before| path[before]).filter(|(error, _)| error.is_finite())
        else {
            return shorter;
        };
        let share = (target / before).ln() / (error / before).ln();
        time(longer).powf(1.0 - share) * shorter.powf(share)
    }

    /// The error at the end; infinite where the run breaks off.
    fn run<X: Composition<H>, C>(&self, start: &Phase<C>, value: fn(C::Leaf) -> f64, steps: u64) -> f64
    where
        C: Coords<With<f64> = Bodies>,
        Bodies: Coords<With<C::Leaf> = C>,
    {
        let Problem { system, span, reference, .. } = self.problem;
        let run = system.run_with::<C::Leaf, X>(X::default(), start.clone(), span / steps as f64);
        let Ok(mut run) = run else { return f64::INFINITY };
        if run.advance(steps).is_err() {
            return f64::INFINITY;
        }
        let state = run.state();
        let square = |numbers: &mut dyn Iterator<Item = f64>| numbers.map(|x| x * x).sum::<f64>();
        let differences = state.q.flat().iter().zip(reference).map(|(leaf, exact)| value(*leaf) - exact);
        (square(&mut { differences }) / square(&mut reference[..18].iter().copied())).sqrt()
    }
}

/// Measures a splitting by some compositions.
macro_rules! measured {
    ($($splitting:ident.$states:ident: $($composition:ident)*;)*) => {
        $($($splitting.$states::<$composition>();)*)*
    };
}

fn main() {
    let mut table = Table::new("splitting", &["splitting", "composition", "1e-4", "1e-6", "1e-8", "1e-10", "1e-12"]);
    let solar = Problems::default().solar();
    let Problem { start, span, ref reference, ref system, .. } = solar;
    let (system, reference) = (Jacobi { masses: system.masses }, reference.clone());
    let jacobi = Problem { name: "solar", system, start, span, reference };
    let best = [f64::INFINITY; ERRORS.len()];
    let mut of_jacobi = Splitting { name: "jacobi", problem: &jacobi, table: &mut table, best };
    measured! {
        of_jacobi.plain:
            Verlet Saba4 Sbabc3 Aba84 Aba104 Aba864 Aba1064 Abah864 Abah1064 BlanesCasasRos764 WisdomHolmanTouma7
            WisdomHolmanTouma17 BlanesMoanSrkn11;
        of_jacobi.compensated: Aba1064;
    }
    let by_jacobi = of_jacobi.best;
    let mut of_separable = Splitting { name: "T + V", problem: &solar, table: &mut table, best };
    measured! {
        of_separable.plain: BlanesMoanSrkn11 BlanesMoanSrkn14 Teloy8C SofroniouSpaletta10;
        of_separable.compensated: SofroniouSpaletta10;
    }
    let separable = of_separable.best;
    table.write().expect("a table");
    for ((error, jacobi), separable) in ERRORS.into_iter().zip(by_jacobi).zip(separable) {
        println!("ratio_{error:e}={:.3} ({jacobi:.3} ms over {separable:.3} ms)", jacobi / separable);
    }
}
