//! Ensembles whose steps are taken elsewhere, as on a device: how members leave one in the middle of the current step,
//! how they come back, and what it says of steps that it does not take itself.

use crate::{
    ensemble::{Ensemble, batch::Finished, members::of_member},
    error::{Divergence, Error},
    state::{clock::Clock, coords::Coords, flat::flat, phase::Phase, point::shaped},
    trajectory::{motions::Form, run::Run},
};
use alloc::vec::Vec;

/// A member: the number of steps and the time at which it failed or finished, if it did; and its state, in the middle
/// of the current step if it is in progress.
pub type MemberElsewhere<C> = (Option<(u64, f64)>, Phase<C>);

/// The data of an ensemble that steps elsewhere require.
pub struct Elsewhere<C: Coords> {
    /// The time at which the clock started.
    pub t0: f64,
    /// The step.
    pub h: f64,
    /// The number of steps that the members in progress have taken.
    pub steps: u64,
    /// The number of steps after which the states were last changed from outside.
    pub opened: u64,
    /// The members, in their order.
    pub members: Vec<MemberElsewhere<C>>,
}

/// The members of an ensemble, for steps elsewhere.
pub fn leave<C: Coords>(ensemble: &Ensemble<C>) -> Elsewhere<C> {
    let mut members = Vec::with_capacity(ensemble.len());
    ensemble.members.unfinished(&mut |finished, state| {
        members.push((finished.map(|Finished { steps, time }| (steps, time)), shaped::<C>(state).clone()));
    });
    let Clock { t0, h, steps } = ensemble.members.clock;
    Elsewhere { t0, h, steps, opened: ensemble.members.opened(), members }
}

/// Continues the members from the states that steps elsewhere have led to, after `steps` steps of all. The states were
/// last changed from outside after `opened` of them.
pub fn come_back<C: Coords>(ensemble: &mut Ensemble<C>, steps: u64, opened: u64, members: &[MemberElsewhere<C>]) {
    let clock = Clock { steps, ..ensemble.members.clock };
    ensemble.members.between = None;
    ensemble.members.resume(clock, opened, &|member| &members[member].1, &|member| {
        members[member].0.map(|(steps, time)| Finished { steps, time })
    });
}

/// Returns the number of steps done after `steps` more than the `done` ones that were taken elsewhere.
///
/// # Errors
/// Those of [`Ensemble::advance`] that it returns before the first step.
pub fn begin<C: Coords>(ensemble: &mut Ensemble<C>, done: u64, steps: u64) -> Result<u64, Error> {
    ensemble.members.clock.steps = done;
    let end = ensemble.members.clock.end(steps)?;
    ensemble.members.check_starts()?;
    ensemble.members.between = None;
    Ok(end)
}

/// Returns the largest number of further steps, after the `done` ones, that do not lead beyond a time.
///
/// # Errors
/// [`Error::Time`] and [`Error::Passed`], as by [`Ensemble::advance_to`].
pub fn steps_before<C: Coords>(ensemble: &Ensemble<C>, done: u64, time: f64) -> Result<u64, Error> {
    let clock = ensemble.members.clock;
    clock.check()?;
    let present = clock.at(done);
    if !time.is_finite() {
        Err(Error::Time { time })
    } else if clock.is_beyond(present, time) {
        Err(Error::Passed { time, present })
    } else {
        Ok(clock.whole_steps_to(time).saturating_sub(done))
    }
}

/// The indices of the active members.
pub fn under_way<C: Coords>(ensemble: &Ensemble<C>) -> Vec<usize> {
    ensemble.members.under_way()
}

/// The energy of a member in a state at a time.
pub fn energy_in<C: Coords>(ensemble: &Ensemble<C>, member: usize, state: &Phase<C>, time: f64) -> f64 {
    ensemble.members.energies.parts(member, state, time).total
}

/// The report on a member whose last finite step is that after `steps`, from its state in the middle of the current step.
///
/// # Errors
/// [`Error::Member`] for a member that there is not.
pub fn divergence<C: Coords>(
    ensemble: &Ensemble<C>,
    member: usize,
    (steps, opened): (u64, u64),
    state: &Phase<C>,
) -> Result<Divergence, Error> {
    let clock = Clock { steps, ..ensemble.members.clock };
    let Some(batch) = ensemble.members.batch_of(member) else { return Err(of_member(member)(Error::NoMembers)) };
    let engine = batch.alone_from(member, Form::after(steps - opened), state);
    let mut run = Run::of_engine(engine, ensemble.energies_of(member), state.clone(), clock, opened);
    let last = flat(&run.state());
    Ok(match run.take_step() {
        Err(Error::Diverged(divergence)) => divergence,
        // Where this processor rounds otherwise than what took the steps, it may be finite a little longer.
        _ => {
            let step = steps.saturating_add(1);
            Divergence { step, time: clock.at(step), limit: f64::INFINITY, coordinate: None, q: last.q, p: last.p }
        }
    })
}
