//! A pendulum, a noisy series of its angle, and the least-squares fit.

use integrator_core::prelude::*;
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::TAU;

const GRAVITY: f64 = 9.81;
/// Steps between observations, which are a tenth of a second apart.
const INTERVAL: u64 = 2;
const STEP: f64 = 0.05;
/// Maximum number of iterations.
const MOST: usize = 50;
/// Standard deviation of an observed angle, in radians.
pub(crate) const NOISE: f64 = 0.02;

/// A pendulum with a mass of one.
pub(crate) struct Pendulum {
    length: f64,
}

#[hamiltonian(sensitive(length))]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -GRAVITY * self.length * q[0].cos()
    }
}

/// The fitted parameters: the length, and the initial angle and angular momentum.
pub(crate) type Unknown = Vector3<f64>;

/// Returns observed angles with normally distributed errors of standard deviation [`NOISE`].
pub(crate) fn series(truth: Unknown, count: usize, mut normal: impl FnMut() -> f64) -> Result<Vec<f64>, Error> {
    let run = Pendulum { length: truth[0] }.run_with(BlanesMoanSrkn11, start(truth), STEP)?;
    run.samples(INTERVAL).take(count).map(|sample| Ok(sample?.state.q[0] + NOISE * normal())).collect()
}

fn start(unknown: Unknown) -> Phase<[f64; 1]> {
    Phase::new([unknown[1]], [unknown[2]])
}

/// The result of a fit.
pub(crate) struct Fit {
    pub(crate) unknown: Unknown,
    /// Covariance of the parameters.
    pub(crate) covariance: Matrix3<f64>,
    /// Root mean square of the residuals.
    pub(crate) residual: f64,
    pub(crate) iterations: usize,
}

impl Fit {
    /// Returns the length and its standard error.
    pub(crate) fn length(&self) -> (f64, f64) {
        (self.unknown[0], self.covariance[(0, 0)].sqrt())
    }

    /// Returns the period of small oscillations, 2π √(l/g), and its standard error.
    pub(crate) fn small_period(&self) -> (f64, f64) {
        let (length, error) = self.length();
        let period = TAU * (length / GRAVITY).sqrt();
        (period, period * error / (2.0 * length))
    }
}

/// Fits the parameters by the Gauss–Newton method. The run provides each angle and its derivatives with respect to the
/// parameters.
pub(crate) fn fit(series: &[f64], guess: Unknown) -> Result<Fit, Error> {
    let (mut unknown, mut iterations) = (guess, 0);
    loop {
        iterations += 1;
        let Equations { normal, right, residual } = equations(series, unknown)?;
        // Three angles determine the three parameters; the matrix is singular only for a pendulum at rest.
        let covariance = normal.try_inverse().unwrap_or_default();
        let change = covariance * right;
        unknown += change;
        // Converged: the change is small compared with the standard error.
        let counts = (0..3).any(|i| change[i].abs() > 1e-6 * NOISE * covariance[(i, i)].sqrt());
        if !counts || iterations == MOST {
            return Ok(Fit { unknown, covariance: covariance * NOISE * NOISE, residual, iterations });
        }
    }
}

/// Normal equations of the fit, linearised at given parameters.
struct Equations {
    normal: Matrix3<f64>,
    right: Vector3<f64>,
    residual: f64,
}

fn equations(series: &[f64], unknown: Unknown) -> Result<Equations, Error> {
    let (system, unit) = (Pendulum { length: unknown[0] }, [Phase::new([1.0], [0.0]), Phase::new([0.0], [1.0])]);
    let mut tangent = system.sensitivities(BlanesMoanSrkn11, start(unknown), unit, STEP)?;
    let (mut normal, mut right, mut squares) = (Matrix3::zeros(), Vector3::zeros(), 0.0);
    for seen in series {
        let [by_angle, by_momentum, by_length] = tangent.vectors()[..] else {
            unreachable!("two vectors and a parameter")
        };
        let slopes = Vector3::new(by_length.q[0], by_angle.q[0], by_momentum.q[0]);
        let off = seen - tangent.state().q[0];
        normal += slopes * slopes.transpose();
        right += slopes * off;
        squares += off * off;
        tangent.advance(INTERVAL)?;
    }
    Ok(Equations { normal, right, residual: (squares / series.len() as f64).sqrt() })
}
