//! The main frequencies of the members of an ensemble.

use super::{
    drift::{Drift, drift},
    series::{ORDER, needed},
};
use crate::{
    check::CheckError,
    ensemble::Ensemble,
    error::{Error, Lost},
    state::{coords::Coords, phase::Phase},
    threads::in_turns,
};
use std::{
    collections::BTreeMap,
    sync::{Mutex, PoisonError},
};

/// Computes the main frequencies of observables of all members, and their drifts, from samples after every `every` steps.
///
/// `observables` returns complex numbers `[real, imaginary]` of a state, for example `[[q[0], p[0]], [q[1], p[1]]]` for two
/// degrees of freedom. The ensemble takes `every · (samples - 1)` steps. Results are in the order of the members. They are
/// bitwise independent of other members and of the number of threads.
///
/// All samples are kept: 16 bytes for each observable of each member at each sample. Divide large maps into several ensembles.
///
/// ```
/// use integrator_core::{chaos, prelude::*};
///
/// struct Pendulum;
///
/// #[hamiltonian]
/// impl Pendulum {
///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
///     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
/// }
///
/// let members = (1..=20).map(|n| (Pendulum, Phase::new([0.1 * f64::from(n)], [0.0])));
/// let mut swarm = Ensemble::new(Yoshida4, members, 0.1)?;
/// for member in chaos::frequency_map(&mut swarm, 4, 1_000, |state| [[state.q[0], state.p[0]]])? {
///     let [drift] = member?;
///     println!("{:.6} {:.1}", drift.frequency, drift.diffusion());
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// - [`CheckError::Run`]: the steps cannot be taken for a reason that concerns all members, or `every` is 0.
/// - [`CheckError::TooFewSamples`]: there are fewer than 64 samples.
/// - The result of a member is an error if it failed ([`Error::Lost`]) or had finished before
///   ([`CheckError::TooFewSamples`]), if its steps have unequal lengths in time ([`CheckError::UnequalSteps`]), or for the
///   reasons of [`drift()`].
pub fn frequency_map<C: Coords, const N: usize>(
    ensemble: &mut Ensemble<C>,
    every: u64,
    samples: usize,
    observables: impl Fn(&Phase<C>) -> [[f64; 2]; N] + Sync,
) -> Result<Vec<Result<[Drift; N], CheckError>>, CheckError> {
    let needed = 2 * needed(ORDER);
    if samples < needed {
        return Err(CheckError::TooFewSamples { samples, needed });
    }
    let Some(step) = (0..ensemble.len()).find_map(|member| ensemble.run_of(member)).map(|run| run.step()) else {
        return Ok((0..ensemble.len()).map(|_| Err(CheckError::TooFewSamples { samples: 0, needed })).collect());
    };
    let steps = every.saturating_mul(samples as u64 - 1);
    // A mutex for each member, which no other thread uses at the same time.
    let series: Vec<_> = ensemble.states().map(|start| Mutex::new(vec![observables(&start)])).collect();
    let sample = |member: usize, state: &Phase<C>| {
        series[member].lock().unwrap_or_else(PoisonError::into_inner).push(observables(state));
        true
    };
    let mut failures = BTreeMap::new();
    match ensemble.advance_while(steps, every, sample) {
        Ok(()) => {}
        Err(Error::Lost(Lost { members })) => failures.extend(
            members
                .into_iter()
                .map(|(member, divergence)| (member, Error::Lost(Lost { members: vec![(member, divergence)] }))),
        ),
        Err(Error::Strayed { members }) => failures.extend(
            members.into_iter().map(|(member, strayed)| (member, Error::Strayed { members: vec![(member, strayed)] })),
        ),
        Err(error) => return Err(error.into()),
    }
    let time = ensemble.time();
    let of_member = |(member, series): (usize, Mutex<Vec<[[f64; 2]; N]>>)| {
        let series = series.into_inner().unwrap_or_else(PoisonError::into_inner);
        if let Some(error) = failures.get(&member) {
            return Err(error.clone().into());
        }
        if series.len() < samples {
            return Err(CheckError::TooFewSamples { samples: series.len(), needed: samples });
        }
        match ensemble.time_of(member) {
            Some(own) if own != time => Err(CheckError::UnequalSteps { time: own, expected: time }),
            _ => drifts(&series, step * every as f64),
        }
    };
    Ok(in_turns(series.into_iter().enumerate().collect(), &of_member))
}

/// The drifts of all observables of a member.
fn drifts<const N: usize>(series: &[[[f64; 2]; N]], interval: f64) -> Result<[Drift; N], CheckError> {
    let mut drifts = [Drift { frequency: 0.0, halves: [0.0; 2] }; N];
    for (observable, found) in drifts.iter_mut().enumerate() {
        let samples: Vec<[f64; 2]> = series.iter().map(|sample| sample[observable]).collect();
        *found = drift(&samples, interval)?;
    }
    Ok(drifts)
}
