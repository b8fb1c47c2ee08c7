//! Compares implicit methods with the methods that integrate the same H otherwise: `cargo bench -p integrator-bench --bench implicit`.
//!
//! Double pendulum, the orbit of a particle around a rotating black hole and an orbit of eccentricity 0.9 (H in one piece), and the
//! outer solar system (H = T + V). For each method: milliseconds of CPU time to a global error of 1e-6, 1e-10 and 1e-13, the largest relative
//! distance of positions at the end from a solution by Taylor's method in compensated arithmetic; a number that a method does
//! not reach is missing. The last lines:
//!
//! - `ratio_gauss_<problem>_<error>=` is the time of `GaussLegendre6`, the method of order 6, divided by that of the fastest
//!   Gauss-Legendre method. The target is 3 at an error of 1e-10.
//! - `ratio_taylor_<problem>_<error>=` is the time of Taylor's method divided by that of the fastest Gauss-Legendre method.
//! - `ratio_paced_eccentric_<error>=` is the time of `GaussLegendre<8>` in steps of equal time divided by that in steps that a rate
//!   controls.
//! - `stage_<problem>=` is the number of nanoseconds of a stage of `GaussLegendre::<8>`, and of a force evaluation of
//!   `KahanLi8` for H = T + V.

use integrator_bench::{
    precision::{Curve, Kind, best},
    starts::{Problem, Problems},
    table::Table,
};
use integrator_core::{
    BlanesMoanSrkn11, Compensated, Coords, GaussLegendre, KahanLi8, Method,
    prelude::*,
    taylor::{Recurrences, Taylor},
};
use std::{error::Error, f64::consts::TAU, time::Instant};

const ERRORS: [(f64, &str); 3] = [(1e-6, "1e-6"), (1e-10, "1e-10"), (1e-13, "1e-13")];

/// Each level has √2 times the steps of the one before.
fn steps_of(level: u32, fewest: f64) -> u64 {
    (fewest * 2.0_f64.powf(f64::from(level) / 2.0)).ceil() as u64
}

/// A system as a whole and as two copies.
macro_rules! as_two_systems {
    ($one:ident ($($of_one:tt)*), $two:ident ($($of_two:tt)*): $($function:tt)*) => {
        struct $one;

        #[hamiltonian($($of_one)*)]
        impl $one {
            $($function)*
        }

        struct $two;

        #[hamiltonian($($of_two)*)]
        impl $two {
            $($function)*
        }
    };
}

as_two_systems! {
    DoublePendulum (split = none, taylor), CopiedPendulum (split = symmetric(omega = 4.0)):
    /// Two rods of equal length and mass, one below the other.
    fn hamiltonian(&self, [a, b]: [f64; 2], [pa, pb]: [f64; 2]) -> f64 {
        let (sine, cosine) = (a - b).sin_cos();
        (pa * pa + 2.0 * pb * pb - 2.0 * pa * pb * cosine) / (2.0 * (1.0 + sine * sine)) - 2.0 * a.cos() - b.cos()
    }
}

as_two_systems! {
    Kerr (split = none, taylor), CopiedKerr (split = symmetric(omega = 1.0)):
    /// A geodesic in the coordinates (r, θ) of Boyer and Lindquist, with spin 0.9, energy 0.95 and axial angular momentum 2.5, of a
    /// particle of mass one: H = -1/2. The angle and the time are quadratures.
    fn hamiltonian(&self, [r, theta]: [f64; 2], [pr, ptheta]: [f64; 2]) -> f64 {
        let (sine, cosine) = theta.sin_cos();
        let sigma = r * r + 0.81 * cosine * cosine;
        let delta = r * r - 2.0 * r + 0.81;
        let radial = 0.95 * (r * r + 0.81) - 0.9 * 2.5;
        let polar = 0.95 * 0.9 * sine - 2.5 / sine;
        (delta * pr * pr + ptheta * ptheta - radial * radial / delta + polar * polar) / (2.0 * sigma)
    }
}

/// A body that is attracted by the origin, seen from axes that turn.
struct Eccentric;

#[hamiltonian(split = none, taylor)]
impl Eccentric {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0 + 0.3 * (y * px - x * py) - 1.0 / x.hypot(y)
    }
    /// A period takes 2π of the fictitious time, as of the time.
    fn rate(&self, [x, y]: [f64; 2]) -> f64 {
        1.0 / x.hypot(y)
    }
}

/// A problem of a bench: where it starts, how long it lasts, and its end in accurate arithmetic.
struct Course<C: Coords<Leaf = f64>> {
    name: &'static str,
    start: Phase<C>,
    span: f64,
    end: Vec<f64>,
}

impl<C: Coords<Leaf = f64, With<f64> = C>> Course<C> {
    fn new<H>(name: &'static str, system: &H, start: Phase<C>, span: f64) -> Self
    where
        H: Hamiltonian<Coords = C> + Recurrences,
    {
        let accurate = start.q.map(|x| Compensated { value: x, carried: 0.0 });
        let accurate = Phase { q: accurate, p: start.p.map(|x| Compensated { value: x, carried: 0.0 }) };
        let mut run = system.run_with(Taylor::tolerance(1e-20), accurate, span).expect("a start");
        run.advance(1).expect("an end");
        let end = run.state().q.map(|x: Compensated<f64>| x.value).flat().to_vec();
        Self { name, start, span, end }
    }

    /// The largest distance of a coordinate from the accurate one, in units of the largest coordinate.
    fn distance(&self, q: &C) -> f64 {
        let largest = |numbers: &mut dyn Iterator<Item = f64>| numbers.fold(0.0, |most: f64, x| most.max(x.abs()));
        let distances = &mut q.flat().iter().zip(&self.end).map(|(found, end)| found - end);
        largest(distances) / largest(&mut self.end.iter().copied())
    }

    /// Errors and times of a method, from this number of steps on; a method with a tolerance takes one step.
    fn curve<H: Hamiltonian<Coords = C>, X: Method<H>>(
        &self,
        name: &str,
        system: &H,
        levels: u32,
        of_level: impl Fn(u32) -> (X, u64),
    ) -> Curve {
        let taken = |level: u32| -> Option<Run<C>> {
            let (method, steps) = of_level(level);
            let mut run = system.run_with::<f64, X>(method, self.start.clone(), self.span / steps as f64).ok()?;
            if method.facts().name == "Paced" { run.advance_to(self.span) } else { run.advance(steps) }.ok()?;
            Some(run)
        };
        let errors = |level| {
            let run = taken(level)?;
            let start = system.run_with::<f64, X>(of_level(level).0, self.start.clone(), 1.0).ok()?;
            Some([(run.energy() / start.energy() - 1.0).abs(), self.distance(&run.state().q)])
        };
        Curve::measure(name.to_owned(), true, 0..levels, errors, |level| drop(taken(level)))
    }
}

/// The curves of Gauss-Legendre methods, by the number of stages: every further one compiles another minute.
fn gauss_legendre<H: Hamiltonian<Coords = C>, C: Coords<Leaf = f64, With<f64> = C>>(
    course: &Course<C>,
    system: &H,
    fewest: f64,
) -> Vec<Curve> {
    macro_rules! curves {
        ($($stages:literal),*) => {
            vec![$({
                // Higher orders take longer steps.
                let fewest = fewest / f64::from($stages);
                let of_level = |level| (GaussLegendre::<$stages>, steps_of(level, fewest));
                course.curve(concat!("GaussLegendre<", $stages, ">"), system, 24, of_level)
            }),*]
        };
    }
    curves!(2, 3, 4, 6, 8)
}

/// By a tolerance alone, for the whole span at once.
fn taylor<H: Hamiltonian<Coords = C> + Recurrences, C: Coords<Leaf = f64, With<f64> = C>>(
    course: &Course<C>,
    system: &H,
) -> Curve {
    course.curve("Taylor", system, 20, |level| (Taylor::tolerance(10.0_f64.powi(-4 - level as i32)), 1))
}

/// Prints the times of all curves, and returns the last lines.
fn report(table: &mut Table, name: &str, gauss: &[Curve], others: &[Curve]) -> Vec<String> {
    for curve in gauss.iter().chain(others) {
        let time = |(error, _): (f64, &str)| curve.time_to(Kind::Global, error).unwrap_or(f64::NAN);
        table.row([name, &curve.method], &ERRORS.map(time));
    }
    let mut lines = Vec::new();
    for (error, text) in ERRORS {
        let Some((least, _)) = best(gauss, Kind::Global, error) else { continue };
        let mut ratio = |over: &str, curve: Option<&Curve>| {
            if let Some(time) = curve.and_then(|curve| curve.time_to(Kind::Global, error)) {
                lines.push(format!("ratio_{over}_{name}_{text}={:.2}", time / least));
            }
        };
        ratio("gauss", gauss.iter().find(|curve| curve.method == "GaussLegendre<3>"));
        ratio("taylor", others.iter().find(|curve| curve.method == "Taylor"));
    }
    lines
}

/// The nanoseconds of an evaluation, in the least of some runs.
fn evaluation<H: Hamiltonian, X: Method<H>>(system: &H, method: X, start: &Phase<H::Coords>, h: f64) -> Option<f64> {
    let mut least = f64::INFINITY;
    for _ in 0..21 {
        let mut run = system.run_with::<f64, X>(method, start.clone(), h).ok()?;
        let clock = Instant::now();
        run.advance(1_000).ok()?;
        least = least.min(clock.elapsed().as_secs_f64() * 1e9 / run.evaluations() as f64);
    }
    Some(least)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut table = Table::new("implicit", &["problem", "method", "ms to 1e-6", "1e-10", "1e-13"]);
    let mut lines = Vec::new();

    let course = Course::new("double_pendulum", &DoublePendulum, Phase::new([1.0, -0.5], [0.2, 0.3]), 200.0);
    let others = [
        taylor(&course, &DoublePendulum),
        course.curve("KahanLi8, two copies", &CopiedPendulum, 24, |level| (KahanLi8, steps_of(level, 400.0))),
    ];
    lines.extend(report(&mut table, course.name, &gauss_legendre(&course, &DoublePendulum, 400.0), &others));
    let stage = evaluation(&DoublePendulum, GaussLegendre::<8>, &course.start, 0.2);
    lines.extend(stage.map(|stage| format!("stage_double_pendulum={stage:.2}")));

    let course = Course::new("kerr", &Kerr, Phase::new([10.0, 1.5], [0.2, 1.5]), 2_000.0);
    let others = [
        taylor(&course, &Kerr),
        course.curve("KahanLi8, two copies", &CopiedKerr, 24, |level| (KahanLi8, steps_of(level, 2_000.0))),
    ];
    lines.extend(report(&mut table, course.name, &gauss_legendre(&course, &Kerr, 400.0), &others));
    let stage = evaluation(&Kerr, GaussLegendre::<8>, &course.start, 2.0);
    lines.extend(stage.map(|stage| format!("stage_kerr={stage:.2}")));

    let start = Phase::new([0.1, 0.0], [0.0, 19_f64.sqrt()]);
    let course = Course::new("eccentric", &Eccentric, start, 100.0 * TAU);
    let fixed =
        course.curve("GaussLegendre<8>", &Eccentric, 12, |level| (GaussLegendre::<8>, steps_of(level, 5_000.0)));
    let of_level = |level| (Paced(GaussLegendre::<8>), steps_of(level, 1_000.0));
    let paced = course.curve("Paced(GaussLegendre<8>)", &Eccentric, 12, of_level);
    for (error, text) in ERRORS {
        let ratio = fixed.time_to(Kind::Global, error).zip(paced.time_to(Kind::Global, error));
        lines.extend(ratio.map(|(fixed, paced)| format!("ratio_paced_eccentric_{text}={:.2}", fixed / paced)));
    }
    lines.extend(report(&mut table, course.name, &[fixed, paced], &[taylor(&course, &Eccentric)]));

    let Problem { name, system, start, span, .. } = Problems::default().solar();
    let course = Course::new(name, &system, start, span);
    let others = [
        taylor(&course, &system),
        course.curve("KahanLi8", &system, 24, |level| (KahanLi8, steps_of(level, 500.0))),
        course.curve("BlanesMoanSrkn11", &system, 24, |level| (BlanesMoanSrkn11, steps_of(level, 500.0))),
    ];
    lines.extend(report(&mut table, course.name, &gauss_legendre(&course, &system, 16_000.0), &others));
    let stage = evaluation(&system, GaussLegendre::<8>, &course.start, 400.0);
    let force = evaluation(&system, KahanLi8, &course.start, 400.0);
    lines.extend(stage.zip(force).map(|(stage, force)| format!("stage_{name}={stage:.2} force={force:.2}")));

    table.write()?;
    lines.iter().for_each(|line| println!("{line}"));
    Ok(())
}
