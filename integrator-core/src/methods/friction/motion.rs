//! The motion of a system with friction: that of the system, with the factors of `O`.

use super::{
    factors::{Row, rows},
    rates::{Rates, inverse_masses},
    scheme::Letter,
};
use crate::{
    error::Unsolved,
    layout::lattice::time_tiling::CACHED,
    scalar::real::Real,
    state::{coords::Coords, phase::Phase, precision::Precision},
    system::{
        System,
        counts::Counts,
        dissipation::{Dissipation, WithFriction},
        motion::{Found, Motion, Noise},
    },
};
use alloc::{sync::Arc, vec, vec::Vec};

/// The constants of a run with friction: those of the system.
pub struct FrictionConstants<P> {
    parameters: Arc<P>,
    dissipation: Dissipation,
}

impl<P> FrictionConstants<P> {
    /// Returns the constants of a run.
    pub fn new(parameters: Arc<P>, dissipation: Dissipation) -> Arc<Self> {
        Arc::new(Self { parameters, dissipation })
    }
}

/// The motion of a system with friction, whose momenta are computed in `W`.
pub struct Damped<M, P, W> {
    pub(super) motion: M,
    /// The constants of the members in the lanes, from which rates are computed.
    members: Arc<Vec<Arc<P>>>,
    /// The number of coordinates.
    count: usize,
    /// The durations of the stages `O` of a step, in their order, and the factors of each.
    durations: Vec<f64>,
    pub(super) factors: Vec<Arc<[Row<W>]>>,
    /// The inverse masses in the layout of the momenta, where heat is measured.
    pub(super) inverse_masses: Vec<W>,
    pub(super) noise: Noise,
    dissipation: Dissipation,
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
            durations: self.durations.clone(),
            factors: self.factors.clone(),
            inverse_masses: self.inverse_masses.clone(),
            noise: self.noise.clone(),
            dissipation: self.dissipation,
        }
    }
}

impl<M, P, W> Damped<M, P, W> {
    /// Whether a lattice of this motion does not fit into a cache.
    pub(super) fn is_long(&self) -> bool {
        self.count >= CACHED
    }
}

/// The durations of the stages `O` of a step.
fn durations_of(letters: &[Letter], h: f64) -> impl Iterator<Item = f64> {
    letters.iter().filter_map(move |letter| if let Letter::O(share) = letter { Some(share * h) } else { None })
}

/// Sets the durations of the stages `O` to those of steps of this duration; `false` if they are these already.
fn change_durations(durations: &mut Vec<f64>, letters: &[Letter], h: f64) -> bool {
    let change = !durations_of(letters, h).eq(durations.iter().copied());
    if change {
        durations.clear();
        durations.extend(durations_of(letters, h));
    }
    change
}

/// Prepares the factors of the stages of a step of this duration, unless they are those of the last one; and the masses with which
/// heat is measured.
pub(super) fn prepare<H: WithFriction, R: Real, K: Precision>(
    motion: &mut DampedOf<H, R, K>,
    letters: &[Letter],
    h: f64,
    time: f64,
) {
    if motion.noise.heat.is_some() && motion.inverse_masses.is_empty() {
        prepare_masses::<H, R, K>(motion);
    }
    if !change_durations(&mut motion.durations, letters, h) && !H::READS_TIME {
        return;
    }
    let rates = rates::<H>(&motion.members, motion.count, time);
    let slots = H::momenta::<R, K>(&mut motion.motion).len();
    motion.factors.clear();
    for duration in &motion.durations {
        motion.factors.push(rows::<H, R>(&rates, slots, *duration));
    }
}

/// Prepares the factors of one stage at its own time.
pub(super) fn prepare_stage<H: WithFriction, R: Real, K: Precision>(
    motion: &mut DampedOf<H, R, K>,
    stage: usize,
    time: f64,
) {
    let rates = rates::<H>(&motion.members, motion.count, time);
    let slots = H::momenta::<R, K>(&mut motion.motion).len();
    motion.factors[stage] = rows::<H, R>(&rates, slots, motion.durations[stage]);
}

/// The rates of members at a time.
fn rates<H: WithFriction>(members: &[Arc<H::Parameters<f64>>], count: usize, time: f64) -> Vec<Rates> {
    let mut rates = Vec::with_capacity(members.len());
    for parameters in members {
        rates.push(Rates::of::<H>(parameters, count, time));
    }
    rates
}

/// Prepares the inverse masses.
fn prepare_masses<H: WithFriction, R: Real, K: Precision>(motion: &mut DampedOf<H, R, K>) {
    let mut of_members = Vec::with_capacity(motion.members.len());
    for parameters in motion.members.iter() {
        of_members.push(inverse_masses::<H>(parameters, motion.count));
    }
    for slot in 0..H::momenta::<R, K>(&mut motion.motion).len() {
        motion.inverse_masses.push(H::Wide::<R>::parameter(&|lane| {
            let of_member = &of_members[lane % R::LANES % of_members.len()];
            of_member.get(H::coordinate::<R>(slot, lane / R::LANES)).copied().unwrap_or(0.0)
        }));
    }
}

/// The parameters of members; of those that share them, once.
fn members_of<P>(constants: &[&FrictionConstants<P>]) -> Arc<Vec<Arc<P>>> {
    let mut members = Vec::with_capacity(constants.len());
    let mut are_shared = true;
    for constants in constants {
        members.push(constants.parameters.clone());
        are_shared &= Arc::ptr_eq(&members[0], &constants.parameters);
    }
    if are_shared {
        members.truncate(1);
    }
    Arc::new(members)
}

/// References to the parameters of members.
fn parameters_of<'c, P>(constants: &[&'c FrictionConstants<P>]) -> Vec<&'c P> {
    let mut parameters = Vec::with_capacity(constants.len());
    for constants in constants {
        parameters.push(&*constants.parameters);
    }
    parameters
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
        Self {
            motion: M::load(&parameters_of(constants), states),
            members: members_of(constants),
            count: states.first().map_or(0, |state| state.q.flat().len()),
            durations: Vec::new(),
            factors: Vec::new(),
            inverse_masses: Vec::new(),
            noise: Noise { seed: 0, members: vec![0; states.len()], heat: None },
            dissipation: constants.first().map_or(Dissipation::None, |constants| constants.dissipation),
        }
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        self.motion.store(lane, to);
    }
    fn copy_state(&mut self, from: &Self) {
        self.motion.copy_state(&from.motion);
        self.noise.heat.clone_from(&from.noise.heat);
    }
    fn copy_state_on(&mut self, from: &Self, threads: Option<usize>) {
        self.motion.copy_state_on(&from.motion, threads);
        self.noise.heat.clone_from(&from.noise.heat);
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
        matches!(self.dissipation, Dissipation::Heat).then_some(&mut self.noise)
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
