//! The chain of Fermi, Pasta, Ulam and Tsingou (1955), the energies of its modes, and their recurrence.

use integrator_core::prelude::*;
use std::f64::consts::PI;

/// Number of segments between the walls, one more than the number of moving sites.
pub(crate) const SEGMENTS: usize = 32;

/// Nonlinearity of the original run, and the step of its leapfrog.
pub(crate) const ALPHA: f64 = 0.25;
pub(crate) const THEIR_STEP: f64 = 0.353_553_390_593_273_8;

/// A chain with fixed ends, whose springs are slightly stiffer when stretched.
pub(crate) struct Chain {
    pub(crate) alpha: f64,
}

#[hamiltonian(compose = BlanesMoanSrkn11)]
impl Chain {
    fn kinetic(&self, p: [f64; SEGMENTS - 1]) -> f64 {
        let mut energy = 0.0;
        for i in 0..SEGMENTS - 1 {
            energy += 0.5 * p[i] * p[i];
        }
        energy
    }
    fn potential(&self, q: [f64; SEGMENTS - 1]) -> f64 {
        let mut energy = self.spring(q[0]) + self.spring(-q[SEGMENTS - 2]);
        for i in 0..SEGMENTS - 2 {
            energy += self.spring(q[i + 1] - q[i]);
        }
        energy
    }
    fn spring(&self, stretch: f64) -> f64 {
        0.5 * stretch * stretch + self.alpha * stretch.powi(3) / 3.0
    }
}

pub(crate) type Sites = [f64; SEGMENTS - 1];

/// Returns the frequency of a mode, `2 sin(π k / 2N)`.
pub(crate) fn frequency(mode: usize) -> f64 {
    2.0 * (PI * mode as f64 / (2 * SEGMENTS) as f64).sin()
}

/// Returns the period of the lowest mode in the linear chain.
pub(crate) fn period() -> f64 {
    2.0 * PI / frequency(1)
}

/// Returns the initial state: at rest, half a sine wave of height 1.
pub(crate) fn start() -> Phase<Sites> {
    let shape = std::array::from_fn(|i| (PI * (i + 1) as f64 / SEGMENTS as f64).sin());
    Phase::new(shape, [0.0; SEGMENTS - 1])
}

/// Returns the energies of the lowest modes, as in the linear chain.
pub(crate) fn mode_energies<const MODES: usize>(state: &Phase<Sites>) -> [f64; MODES] {
    std::array::from_fn(|index| {
        let mode = index + 1;
        let amplitude = |sites: &Sites| {
            let wave = |site: usize| (PI * (mode * (site + 1)) as f64 / SEGMENTS as f64).sin();
            let sum: f64 = sites.iter().enumerate().map(|(site, x)| x * wave(site)).sum();
            sum * (2.0 / SEGMENTS as f64).sqrt()
        };
        0.5 * (amplitude(&state.p).powi(2) + (frequency(mode) * amplitude(&state.q)).powi(2))
    })
}

/// A sample: the time in periods of the lowest mode, and the share of each mode in the energy.
pub(crate) type ModeShares<const MODES: usize> = (f64, [f64; MODES]);

/// Samples a run until `go_on` returns false. Returns the samples and the largest energy change.
pub(crate) fn mode_shares<const MODES: usize>(
    run: Run<Sites>,
    interval: u64,
    periods: f64,
    mut go_on: impl FnMut(f64) -> bool,
) -> Result<(Vec<ModeShares<MODES>>, f64), Error> {
    let (whole, mut samples, mut energy_error) = (run.energy(), Vec::new(), 0.0_f64);
    for sample in run.samples(interval) {
        let sample = sample?;
        let time = sample.time / period();
        samples.push((time, mode_energies(&sample.state).map(|energy| energy / whole)));
        energy_error = energy_error.max((sample.energy() / whole - 1.0).abs());
        if time >= periods || !go_on(time) {
            break;
        }
    }
    Ok((samples, energy_error))
}

/// Returns the time and the share of the recurrence: the largest share of the lowest mode after its minimum. `None` if the
/// share still grows at the last sample.
pub(crate) fn recurrence<const MODES: usize>(samples: &[ModeShares<MODES>]) -> Option<(f64, f64)> {
    let first = || samples.iter().map(|(time, shares)| (*time, shares[0])).enumerate();
    let (least, _) = first().min_by(|a, b| a.1.1.total_cmp(&b.1.1))?;
    let (most, highest) = first().skip(least).max_by(|a, b| a.1.1.total_cmp(&b.1.1))?;
    (most + 1 < samples.len()).then_some(highest)
}
