//! The motion of a system with friction: that of the system, with the factors of `O`.

use super::{factors::Factors, rates::Rates, scheme::Letter};
use crate::{
    error::Unsolved,
    scalar::real::Real,
    state::{coords::Coords, phase::Phase, precision::Precision},
    system::{
        System,
        counts::Counts,
        dissipation::WithFriction,
        motion::{Found, Motion, Noise},
    },
};
use alloc::{sync::Arc, vec, vec::Vec};

/// The constants of a run with friction: those of the system.
pub struct FrictionConstants<P> {
    parameters: Arc<P>,
}

impl<P> FrictionConstants<P> {
    /// Returns the constants of a run.
    pub fn new(parameters: Arc<P>) -> Arc<Self> {
        Arc::new(Self { parameters })
    }
}

/// The motion of a system with friction, whose momenta are computed in `W`.
pub struct Damped<M, P, W> {
    pub(super) motion: M,
    /// The constants of the members in the lanes, from which rates are computed.
    members: Arc<Vec<Arc<P>>>,
    /// The number of coordinates.
    count: usize,
    /// The factors of the stages `O` of a step, in their order.
    pub(super) factors: Vec<Factors<W>>,
    pub(super) noise: Noise,
}

/// The motion of `H` with friction.
pub type DampedOf<H, R, K> =
    Damped<<H as System>::Motion<R, K>, <H as System>::Parameters<f64>, <H as WithFriction>::Wide<R>>;

impl<M: Clone, P, W: Clone> Clone for Damped<M, P, W> {
    fn clone(&self) -> Self {
        Self {
            motion: self.motion.clone(),
            members: self.members.clone(),
            count: self.count,
            factors: self.factors.clone(),
            noise: self.noise.clone(),
        }
    }
}

/// Prepares the factors of the stages of a step of this duration, unless they are those of the last one.
pub(super) fn prepare<H: WithFriction, R: Real, K: Precision>(
    motion: &mut DampedOf<H, R, K>,
    letters: &[Letter],
    h: f64,
    time: f64,
) {
    let durations = || {
        letters.iter().filter_map(|letter| match letter {
            Letter::O(duration) => Some(duration * h),
            _ => None,
        })
    };
    let is_prepared = motion.factors.iter().map(|factors| factors.duration).eq(durations());
    if is_prepared && !H::READS_TIME {
        return;
    }
    let rates = rates::<H, R, K>(motion, time);
    motion.factors.clear();
    for duration in durations() {
        let same = motion.factors.iter().find(|known| known.duration == duration).cloned();
        let factors = same.unwrap_or_else(|| factors_of::<H, R, K>(motion, &rates, duration));
        motion.factors.push(factors);
    }
}

/// Prepares the factors of one stage at its own time.
pub(super) fn prepare_stage<H: WithFriction, R: Real, K: Precision>(
    motion: &mut DampedOf<H, R, K>,
    stage: usize,
    time: f64,
) {
    let rates = rates::<H, R, K>(motion, time);
    motion.factors[stage] = factors_of::<H, R, K>(motion, &rates, motion.factors[stage].duration);
}

fn rates<H: WithFriction, R: Real, K: Precision>(motion: &DampedOf<H, R, K>, time: f64) -> Vec<Rates> {
    motion.members.iter().map(|parameters| Rates::of::<H>(parameters, motion.count, time)).collect()
}

fn factors_of<H: WithFriction, R: Real, K: Precision>(
    motion: &mut DampedOf<H, R, K>,
    rates: &[Rates],
    duration: f64,
) -> Factors<H::Wide<R>> {
    let slots = H::momenta::<R, K>(&mut motion.motion).len();
    Factors::of::<H, R>(rates, slots, duration)
}

impl<C, M, P, W> Motion<C, FrictionConstants<P>> for Damped<M, P, W>
where
    C: Coords,
    M: Motion<C, P>,
    P: Send + Sync + 'static,
    W: Real,
{
    const MIXES: bool = M::MIXES;

    fn load(constants: &[&FrictionConstants<P>], states: &[&Phase<C>]) -> Self {
        let parameters: Vec<&P> = constants.iter().map(|constants| &*constants.parameters).collect();
        let mut members: Vec<_> = constants.iter().map(|constants| constants.parameters.clone()).collect();
        // Members that share their constants share their rates.
        if members.windows(2).all(|pair| Arc::ptr_eq(&pair[0], &pair[1])) {
            members.truncate(1);
        }
        Self {
            motion: M::load(&parameters, states),
            members: Arc::new(members),
            count: states.first().map_or(0, |state| state.q.flat().len()),
            factors: Vec::new(),
            noise: Noise { seed: 0, members: vec![0; states.len()] },
        }
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        self.motion.store(lane, to);
    }
    fn copy_state(&mut self, from: &Self) {
        self.motion.copy_state(&from.motion);
    }
    fn copy_state_on(&mut self, from: &Self, threads: Option<usize>) {
        self.motion.copy_state_on(&from.motion, threads);
    }
    fn found(&self) -> Option<Found> {
        self.motion.found()
    }
    fn use_found(&mut self, found: &Found) {
        self.motion.use_found(found);
    }
    fn share_among(&mut self, threads: Option<usize>) {
        self.motion.share_among(threads);
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.motion.unsolved(lane)
    }
    fn noise(&mut self) -> Option<&mut Noise> {
        Some(&mut self.noise)
    }
    fn counts(&self) -> Option<Counts> {
        self.motion.counts()
    }
    fn finite(&self) -> bool {
        self.motion.finite()
    }
    fn finite_on(&self, threads: Option<usize>) -> bool {
        self.motion.finite_on(threads)
    }
}
