//! Benchmarks the CPU time to a position error on eccentric orbits, by time transformation and other methods: `cargo bench -p
//! integrator --bench pace`.
//!
//! The systems are two bodies over 1000 periods at eccentricities of 0.6, 0.9 and 0.99, compared with the closed form, and the
//! same at 0.6 with a further potential `-0.005/r³` until t = 6000, compared with a Taylor series in compensated states. Errors
//! are distances in position at the end, in units of the semi-major axis. Steps shrink by half an octave and tolerances by half
//! a decade; times between are interpolated on logarithmic scales.
//!
//! A row is a method with its milliseconds of CPU time to errors of 1e-2, 1e-4, 1e-6, 1e-8 and 1e-10, empty where it does not
//! reach the error. The picture, `pace.svg`, shows one method of each kind: fixed steps, `Logarithmic`, `Paced`, and `Taylor`.
//! The bench of this name in `benches/peers` has other crates.
//!
//! `ratio_pace_logarithmic_over_taylor_0.6=` and similar lines are ratios of the least times to 1e-4. Targets are 0.55 at an
//! eccentricity of 0.6 and 0.25 at 0.99 relative to `Taylor`, and 0.2 relative to fixed steps. `ratio_pace_over_hand=` is the
//! time of a step of `SofroniouSpaletta8` divided by that of a hand-written stepper; the target is 1.1.
//! `energy_pace_1e5_revolutions_0.6=` and similar lines are the largest relative energy changes in 100,000 revolutions; a
//! rounding error at the pericentre is `2ε/(1 - e)`.

use integrator_bench::{
    by_hand::pace,
    plan::Plan,
    race::{Racer, race},
    table::{Table, folder},
};
use integrator_core::{
    Method, QuadraticKinetic, TimeTransformed,
    prelude::*,
    taylor::{Recurrences, Taylor},
};
use integrator_plot::{Axis, Chart, MARKERS, Mark, Panels, write};
use std::{cell::RefCell, f64::consts::TAU};

/// Errors at which times are reported.
const ERRORS: [f64; 5] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10];
/// Repetitions of a run; the median counts.
const REPETITIONS: usize = 3;
/// Longest run in milliseconds; a longer one ends the row.
const PATIENCE: f64 = 120.0;
/// Step of the long runs, in units in which a revolution takes 2π.
const LONG_STEP: f64 = 0.8;
/// Steps per round of the race, and number of rounds.
const STEPS: u64 = 4_096;
const ROUNDS: usize = 41;

/// A body in the potential `-1/r - twist/r³`.
#[derive(Clone, Copy)]
struct Comet {
    twist: f64,
}

#[hamiltonian(taylor)]
impl Comet {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        let square = q[0] * q[0] + q[1] * q[1];
        -1.0 / square.sqrt() - self.twist / (square * square.sqrt())
    }
    fn rate(&self, q: [f64; 2]) -> f64 {
        1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

/// The same system without the further potential, as a user who does not need it writes it.
struct TwoBodies;

#[hamiltonian(taylor)]
impl TwoBodies {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
    fn rate(&self, q: [f64; 2]) -> f64 {
        1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

/// A system with a known final state.
struct Orbit<'s, H> {
    name: &'static str,
    system: &'s H,
    start: Phase<[f64; 2]>,
    span: f64,
    end: [f64; 2],
    /// Errors and milliseconds of the measured methods.
    paths: RefCell<Vec<(String, Path)>>,
}

/// Errors and milliseconds, with decreasing steps.
type Path = Vec<(f64, f64)>;

/// Methods in the picture: name in the table, name in the picture.
const SHOWN: [(&str, &str); 4] = [
    ("BlanesMoanSrkn14", "fixed steps"),
    ("Logarithmic(SofroniouSpaletta10)", "Logarithmic"),
    ("Paced(SofroniouSpaletta8)", "Paced"),
    ("Taylor 20", "Taylor"),
];

fn at_pericentre(e: f64) -> Phase<[f64; 2]> {
    Phase::new([1.0 - e, 0.0], [0.0, ((1.0 + e) / (1.0 - e)).sqrt()])
}

/// Least time in milliseconds to each error.
#[derive(Clone, Copy)]
struct Best([f64; ERRORS.len()]);

impl Best {
    const NONE: Self = Self([f64::INFINITY; ERRORS.len()]);

    fn and(self, times: [f64; ERRORS.len()]) -> Self {
        Self(std::array::from_fn(|error| {
            self.0[error].min(if times[error].is_nan() { f64::INFINITY } else { times[error] })
        }))
    }
}

impl<H: Hamiltonian<Coords = [f64; 2]>> Orbit<'_, H> {
    /// Measures one row: `run(level)` returns the final position, or `None` if the run fails.
    fn row(&self, table: &mut Table, method: &str, run: impl Fn(i32) -> Option<[f64; 2]>) -> [f64; ERRORS.len()] {
        let mut path = Path::new();
        for level in 0..48 {
            // Per million units, nanoseconds become milliseconds.
            let time = race(REPETITIONS, 1e6, vec![Racer::new("", || run(level))]).median(0);
            if let Some([x, y]) = run(level) {
                path.push(((x - self.end[0]).hypot(y - self.end[1]), time));
            }
            if time > PATIENCE {
                break;
            }
        }
        let times = ERRORS.map(|error| time_to(&path, error));
        self.paths.borrow_mut().push((method.to_owned(), path));
        table.row([self.name, method], &times);
        times
    }

    /// Adds a row for a method with decreasing steps, in units of its own time variable.
    fn steps<X: Method<H>>(&self, table: &mut Table, name: &str, longest: f64, method: X) -> [f64; ERRORS.len()] {
        self.row(table, name, |level| {
            let h = longest * 0.5_f64.powf(f64::from(level) / 2.0);
            let mut run = self.system.run_with::<f64, X>(method, self.start, h).ok()?;
            run.advance_to(self.span).ok()?;
            Some(run.state().q)
        })
    }

    /// Adds the same row with compensated states.
    fn compensated<X: Method<H>>(&self, table: &mut Table, name: &str, longest: f64, method: X) -> [f64; ERRORS.len()] {
        self.row(table, &format!("{name}, compensated"), |level| {
            let h = longest * 0.5_f64.powf(f64::from(level) / 2.0);
            let start = Phase::compensated(self.start.q, self.start.p);
            let mut run = self.system.run_with::<Compensated<f64>, X>(method, start, h).ok()?;
            run.advance_to(self.span).ok()?;
            Some(run.state().q.map(|q| q.value))
        })
    }
}

impl<H> Orbit<'_, H> {
    /// Plots time against error for one method of each kind, as long as errors decrease.
    fn chart(&self, title: &str) -> Chart {
        let paths = self.paths.borrow();
        let chart = Chart::new(title)
            .along(Axis::logarithmic("position error at the end").between(1e-11, 1.0))
            .up(Axis::logarithmic("CPU time in ms").between(0.5, PATIENCE));
        SHOWN.iter().zip(MARKERS).fold(chart, |chart, ((method, name), marker)| {
            let path = paths.iter().find(|(known, _)| known == method).map_or(&[][..], |(_, path)| path);
            let mut least = 1.0;
            let falls = |point: &&(f64, f64)| {
                let is_less = point.0 < least;
                least = f64::min(least, point.0);
                is_less
            };
            let points = path.iter().filter(falls).copied().collect::<Vec<_>>();
            chart.series(Mark::Dotted, *name, points).marked(marker).wide(3.0)
        })
    }
}

impl<H: Hamiltonian<Coords = [f64; 2]> + Recurrences + QuadraticKinetic + TimeTransformed> Orbit<'_, H> {
    /// Adds rows for Taylor's method with decreasing tolerances, with automatic and with fixed orders.
    fn taylor(&self, table: &mut Table) -> Best {
        let mut best = Best::NONE;
        for order in [None, Some(16), Some(20), Some(24)] {
            let name = order.map_or("Taylor".to_owned(), |order| format!("Taylor {order}"));
            best = best.and(self.row(table, &name, |level| {
                let method = Taylor::tolerance(10.0_f64.powf(-3.0 - f64::from(level) / 2.0));
                let method = order.map_or(method, |order| method.with_order(order));
                let mut run = self.system.run_with::<f64, _>(method, self.start, self.span / 100.0).ok()?;
                run.advance(100).ok()?;
                Some(run.state().q)
            }));
        }
        best
    }

    fn all(&self, table: &mut Table) {
        let mut logarithmic = Best::NONE;
        logarithmic =
            logarithmic.and(self.steps(table, "Logarithmic(SofroniouSpaletta8)", 1.6, Logarithmic(SofroniouSpaletta8)));
        logarithmic = logarithmic.and(self.steps(
            table,
            "Logarithmic(SofroniouSpaletta10)",
            3.2,
            Logarithmic(SofroniouSpaletta10),
        ));
        logarithmic = logarithmic.and(self.compensated(
            table,
            "Logarithmic(SofroniouSpaletta10)",
            3.2,
            Logarithmic(SofroniouSpaletta10),
        ));
        self.steps(table, "Power(0.5, SofroniouSpaletta8)", 1.6, Power(0.5, SofroniouSpaletta8));
        let mut fixed = Best::NONE;
        fixed = fixed.and(self.steps(table, "SofroniouSpaletta10", 0.8, SofroniouSpaletta10));
        fixed = fixed.and(self.steps(table, "BlanesMoanSrkn14", 0.8, BlanesMoanSrkn14));
        let taylor = self.taylor(table);
        for (other, name) in [(taylor, "taylor"), (fixed, "fixed")] {
            println!("ratio_pace_logarithmic_over_{name}_{}={:.3}", self.name, logarithmic.0[1] / other.0[1]);
        }
    }
}

/// Returns the milliseconds to an error, interpolated between the first smaller error and the run before it.
fn time_to(path: &[(f64, f64)], target: f64) -> f64 {
    let Some(first) = path.iter().position(|(error, _)| *error < target) else { return f64::NAN };
    let (error, time) = path[first];
    let Some((before, earlier)) = first.checked_sub(1).map(|before| path[before]) else { return time };
    let share = (target / before).ln() / (error / before).ln();
    earlier.powf(1.0 - share) * time.powf(share)
}

/// Returns the largest relative energy change in 100,000 revolutions, from a thousand samples.
fn energy_change(e: f64) -> f64 {
    const PER_REVOLUTION: f64 = TAU / LONG_STEP;
    let mut run =
        TwoBodies.run_with::<f64, _>(Logarithmic(SofroniouSpaletta8), at_pericentre(e), LONG_STEP).expect("a start");
    let energy = run.energy();
    (0..1_000).fold(0.0, |largest: f64, _| {
        run.advance((100.0 * PER_REVOLUTION) as u64).expect("finite states");
        largest.max((run.energy() / energy - 1.0).abs())
    })
}

fn main() {
    let mut table = Table::new("pace", &["orbit", "method", "1e-2", "1e-4", "1e-6", "1e-8", "1e-10"]);
    let mut picture = Panels::new(
        "CPU time against error on eccentric orbits",
        "Time transformation is fastest for two bodies; a further force favours Taylor's method",
    )
    .measured("black discs: fixed steps; blue squares: Logarithmic; yellow diamonds: Paced; red triangles: Taylor")
    .columns(3)
    .panel(420, 460);
    for (name, e) in [("0.6", 0.6), ("0.9", 0.9), ("0.99", 0.99)] {
        let start = at_pericentre(e);
        let orbit =
            Orbit { name, system: &TwoBodies, start, span: 1_000.0 * TAU, end: start.q, paths: RefCell::default() };
        orbit.all(&mut table);
        orbit.steps(&mut table, "Paced(SofroniouSpaletta8)", 1.6, Paced(SofroniouSpaletta8));
        if e != 0.9 {
            picture = picture.chart(orbit.chart(&format!("Two bodies, e = {name}, 1000 periods")));
        }
    }
    let (comet, start, span) = (Comet { twist: 0.005 }, at_pericentre(0.6), 6_000.0);
    let exact = Phase::compensated(start.q, start.p);
    let mut exact = comet.run_with(Taylor::tolerance(1e-20), exact, span / 100.0).expect("a start");
    exact.advance(100).expect("finite states");
    let end = exact.state().q.map(|q| q.value);
    let orbit = Orbit { name: "0.6, twisted", system: &comet, start, span, end, paths: RefCell::default() };
    orbit.all(&mut table);
    orbit.steps(&mut table, "Paced(SofroniouSpaletta8)", 1.6, Paced(SofroniouSpaletta8));
    table.write().expect("a table");
    picture = picture.chart(orbit.chart("e = 0.6, further potential −0.005/r³"));
    write(&folder().join("pace"), &picture).expect("two files");

    for e in [0.0, 0.6, 0.9, 0.99, 0.9999] {
        println!("energy_pace_1e5_revolutions_{e}={:.1e}", energy_change(e));
    }

    let (start, h) = (at_pericentre(0.6), 0.4);
    let plan = Plan::of::<SofroniouSpaletta8>(h);
    let generated = || {
        let mut run = TwoBodies.run_with::<f64, _>(Logarithmic(SofroniouSpaletta8), start, h).expect("a start");
        run.advance(STEPS).expect("finite states");
        (run.time(), run.state())
    };
    let by_hand = || pace::two_bodies(start, &plan, STEPS);
    assert!((generated().0 - by_hand().0).abs() < 1e-6, "both follow the same orbit");
    let times = race(ROUNDS, STEPS as f64, vec![Racer::new("generated", generated), Racer::new("by hand", by_hand)]);
    println!("a step of SofroniouSpaletta8: {:.1} ns, by hand {:.1} ns", times.median(0), times.median(1));
    println!("ratio_pace_over_hand={:.3}", times.ratio_to_best());
}
