//! A weight that swings on a stiff spring. Units: the length of the unloaded spring, the mass, and the acceleration of gravity.

use integrator_core::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A weight on a spring, with a rubber band that pulls it down.
pub(crate) struct Pendulum {
    /// Frequency of the spring; small swings have a frequency of about 1.
    pub(crate) frequency: f64,
    /// Stiffness of the rubber band.
    pub(crate) band: f64,
}

/// Height at which the band is tied. The spring hangs from the height 0.
const TIED: f64 = -1.5;

#[hamiltonian(split = slow + 16 * (spring + kinetic))]
impl Pendulum {
    /// Gravity and the rubber band, which has no length at rest.
    fn slow(&self, q: [f64; 2]) -> f64 {
        q[1] + 0.5 * self.band * (q[0] * q[0] + (q[1] - TIED).powi(2))
    }
    fn spring(&self, q: [f64; 2]) -> f64 {
        0.5 * (self.frequency * ((q[0] * q[0] + q[1] * q[1]).sqrt() - 1.0)).powi(2)
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }

    /// Returns a state at rest at an angle from the vertical. The spring is longer by `stretch` than the slow forces make it; without
    /// a stretch it hardly oscillates.
    pub(crate) fn start(&self, angle: f64, stretch: f64) -> Phase<[f64; 2]> {
        let (sine, cosine) = angle.sin_cos();
        let along_the_spring = cosine - self.band * (1.0 + TIED * cosine);
        let length = 1.0 + along_the_spring / self.frequency.powi(2) + stretch;
        Phase::new([length * sine, -length * cosine], [0.0; 2])
    }
}

/// Returns the period of a rigid pendulum that is released at rest: `2π / M(1, cos ½θ)`, with the arithmetic-geometric mean `M`
/// (Gauss).
pub(crate) fn rigid_period(angle: f64) -> f64 {
    let (mut larger, mut smaller) = (1.0, (0.5 * angle).cos());
    // The number of correct digits doubles each time.
    for _ in 0..6 {
        (larger, smaller) = (0.5 * (larger + smaller), f64::sqrt(larger * smaller));
    }
    TAU / larger
}

/// Returns by how much a stiff spring lengthens the rigid period `t` of swings of 90 degrees, times the square of its frequency `ω`.
///
/// The spring follows the forces: its length is `1 + (cos θ + θ̇²) / ω²`, which adds `-½ (θ̇² + cos θ)² / ω²` to the energy of the
/// swing. The integral of this term over a swing has the derivative `-30 π / t` by the energy.
pub(crate) fn excess_of_a_right_angle() -> f64 {
    30.0 * PI / rigid_period(FRAC_PI_2)
}

/// Returns the mean period of `swings` swings.
pub(crate) fn period(pendulum: &Pendulum, angle: f64, h: f64, swings: usize) -> Result<f64, Error> {
    let run = pendulum.run(pendulum.start(angle, 0.0), h)?;
    let passages = run.crossings(1 << 20, Direction::Rising, |state, _| state.q[0]).take(swings + 1);
    let times: Vec<f64> = passages.map(|passage| Ok(passage?.time)).collect::<Result<_, Error>>()?;
    Ok((times[swings] - times[0]) / swings as f64)
}

/// Returns the largest energy error until a time. The run ends early at an error of [`LARGEST`].
pub(crate) fn energy_error(run: &mut Run<[f64; 2]>, until: f64) -> Result<f64, Error> {
    let (energy, mut error) = (run.energy(), 0.0_f64);
    while run.time() < until && error < LARGEST {
        run.advance(1)?;
        error = error.max((run.energy() - energy).abs());
    }
    Ok(error.min(LARGEST))
}

/// Energy error at which runs end; the energy of the resting pendulum is about -1.
pub(crate) const LARGEST: f64 = 10.0;

/// Returns the largest energy error at outer steps of `halves` half periods of the spring, with inner steps of at most a hundredth
/// of a period.
pub(crate) fn error_at(pendulum: &Pendulum, angle: f64, halves: f64, until: f64) -> Result<f64, Error> {
    let inner_steps = (50.0 * halves).ceil() as u32;
    let h = halves * PI / pendulum.frequency;
    energy_error(&mut pendulum.run_with(Verlet.nested(inner_steps), pendulum.start(angle, 0.0), h)?, until)
}
