//! Work–precision curves: the CPU time to an error, from runs with decreasing steps.

use cpu_time::ThreadTime;
use std::time::Duration;

/// The two measured errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The largest relative deviation of the energy over the run.
    Energy,
    /// The relative distance of the positions from the reference at the end.
    Global,
}

/// One run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// CPU time in milliseconds, the minimum of some repetitions.
    pub milliseconds: f64,
    /// The largest relative deviation of the energy.
    pub energy: f64,
    /// The relative distance from the reference at the end.
    pub global: f64,
}

impl Point {
    /// Returns one of the two errors.
    pub fn error(&self, kind: Kind) -> f64 {
        match kind {
            Kind::Energy => self.energy,
            Kind::Global => self.global,
        }
    }
}

/// A method on a problem.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Name of the method, preceded by the crate if it is not this library.
    pub method: String,
    /// Whether the method is from this library.
    pub ours: bool,
    /// Runs, fastest first.
    pub points: Vec<Point>,
}

/// A longer run ends the curve.
const PATIENCE: Duration = Duration::from_millis(300);
/// Approximate total duration of the repetitions of a run.
const REPETITION: Duration = Duration::from_millis(12);

impl Curve {
    /// Measures runs at all levels until rounding dominates or a run takes too long. `errors` returns the errors of a
    /// run, or `None` if it fails; `run` is timed.
    pub fn measure(
        method: String,
        ours: bool,
        levels: impl IntoIterator<Item = u32>,
        errors: impl Fn(u32) -> Option<[f64; 2]>,
        run: impl Fn(u32),
    ) -> Self {
        // Errors may decrease by chance, so the curve ends only after two consecutive runs with larger errors.
        let (mut points, mut worse): (Vec<Point>, u32) = (Vec::new(), 0);
        for level in levels {
            let Some([energy, global]) = errors(level) else { continue };
            let time = least(|| run(level));
            let grown = points.last().is_some_and(|last| energy > last.energy && global > last.global);
            worse = if grown { worse + 1 } else { 0 };
            if energy < 0.5 {
                points.push(Point { milliseconds: time.as_secs_f64() * 1e3, energy, global });
            }
            if time > PATIENCE || (worse > 1 && energy < 1e-6) {
                break;
            }
        }
        Self { method, ours, points }
    }

    /// Returns the milliseconds to an error, interpolated on logarithmic scales. If the first run is accurate enough,
    /// its time is returned; if no run is, `None`.
    pub fn time_to(&self, kind: Kind, error: f64) -> Option<f64> {
        let first = self.points.iter().position(|point| point.error(kind) <= error)?;
        let good = self.points[first];
        let Some(bad) = first.checked_sub(1).map(|before| self.points[before]) else {
            return Some(good.milliseconds);
        };
        let along = (error / bad.error(kind)).ln() / (good.error(kind) / bad.error(kind)).ln();
        Some(bad.milliseconds * (good.milliseconds / bad.milliseconds).powf(along))
    }
}

/// Returns the least CPU time of some repetitions.
fn least(run: impl Fn()) -> Duration {
    let (mut best, mut spent) = (Duration::MAX, Duration::ZERO);
    while spent < REPETITION {
        let start = ThreadTime::now();
        run();
        let time = start.elapsed();
        best = best.min(time);
        spent += time.max(Duration::from_micros(1));
    }
    best
}

/// Returns the least time to an error, and the name of the fastest method.
pub fn best<'c>(curves: impl IntoIterator<Item = &'c Curve>, kind: Kind, error: f64) -> Option<(f64, &'c str)> {
    let times = curves.into_iter().filter_map(|curve| Some((curve.time_to(kind, error)?, curve.method.as_str())));
    times.min_by(|a, b| a.0.total_cmp(&b.0))
}
