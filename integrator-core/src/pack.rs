//! A few members of an ensemble: side by side in lanes as long as all are finite, else each alone.

use crate::{
    coords::Coords,
    engine::{BLOCK, Clock, Engine, Moves, Solo, Watched},
    error::Divergence,
    hamiltonian::Motion,
    phase::Phase,
};

/// The prepared constants and the start of a member.
pub(crate) type Member<P, C> = (P, Phase<C>);

/// Members of an ensemble that are carried on together.
pub(crate) trait Pack<C: Coords>: Send + Sync {
    /// The number of the first member.
    fn first(&self) -> usize;
    /// Takes `steps` steps from `clock` with every member that is not lost; returns those that are lost now.
    fn advance(&mut self, clock: Clock, steps: u64) -> Vec<(usize, Divergence)>;
    /// The state of a member, by its number in the ensemble.
    fn state(&self, member: usize, clock: Clock) -> Phase<C>;
    /// The energy of that state.
    fn energy(&self, member: usize, clock: Clock) -> f64;
}

/// Members on their own.
pub(crate) struct Alone<M, P, C> {
    first: usize,
    /// The engines; of a lost member also the number of steps that it took.
    members: Vec<(Solo<M, P, C>, Option<u64>)>,
}

impl<M: Motion<C, P>, P: Send + Sync + 'static, C: Coords> Alone<M, P, C> {
    pub(crate) fn new(first: usize, members: Vec<Member<P, C>>, moves: Moves<M>) -> Self {
        let members = members.into_iter().map(|(parameters, start)| (Solo::new(parameters, start, moves), None));
        Self { first, members: members.collect() }
    }

    fn member(&self, member: usize, clock: Clock) -> (&Solo<M, P, C>, Clock) {
        let (solo, lost) = &self.members[member - self.first];
        (solo, Clock { steps: lost.unwrap_or(clock.steps), ..clock })
    }
}

impl<M: Motion<C, P>, P: Send + Sync + 'static, C: Coords> Pack<C> for Alone<M, P, C> {
    fn first(&self) -> usize {
        self.first
    }

    fn advance(&mut self, clock: Clock, steps: u64) -> Vec<(usize, Divergence)> {
        let mut lost_now = Vec::new();
        for (number, (solo, lost)) in self.members.iter_mut().enumerate().filter(|(_, (_, lost))| lost.is_none()) {
            let taken = solo.advance(clock, steps);
            if taken < steps {
                let at = Clock { steps: clock.steps + taken, ..clock };
                *lost = Some(at.steps);
                lost_now.push((self.first + number, at.divergence(&solo.state(at))));
            }
        }
        lost_now
    }

    fn state(&self, member: usize, clock: Clock) -> Phase<C> {
        let (solo, clock) = self.member(member, clock);
        solo.state(clock)
    }

    fn energy(&self, member: usize, clock: Clock) -> f64 {
        let (solo, clock) = self.member(member, clock);
        solo.energies().energy(&solo.state(clock), clock.at(clock.steps))
    }
}

/// Members in the lanes of one motion, until one of them leaves the finite numbers.
pub(crate) struct SideBySide<L, M, P, C> {
    first: usize,
    watched: Watched<L>,
    alone: Moves<M>,
    members: Vec<Member<P, C>>,
    /// The members on their own, once one of them was lost.
    apart: Option<Alone<M, P, C>>,
}

impl<L, M, P, C> SideBySide<L, M, P, C>
where
    L: Motion<C, P>,
    M: Motion<C, P>,
    P: Clone + Send + Sync + 'static,
    C: Coords,
{
    /// `members` fill the lanes.
    pub(crate) fn new(first: usize, members: Vec<Member<P, C>>, lanes: Moves<L>, alone: Moves<M>) -> Self {
        let motion = L::load(|lane| (&members[lane].0, &members[lane].1));
        Self { first, watched: Watched::new(motion, lanes), alone, members, apart: None }
    }

    /// The members on their own, from where the motion is.
    fn taken_apart(&self) -> Alone<M, P, C> {
        let members = self.members.iter().enumerate().map(|(lane, (parameters, shape))| {
            let mut state = shape.clone();
            self.watched.motion().store(lane, &mut state);
            (parameters.clone(), state)
        });
        Alone::new(self.first, members.collect(), self.alone)
    }
}

impl<L, M, P, C> Pack<C> for SideBySide<L, M, P, C>
where
    L: Motion<C, P>,
    M: Motion<C, P>,
    P: Clone + Send + Sync + 'static,
    C: Coords,
{
    fn first(&self) -> usize {
        self.first
    }

    fn advance(&mut self, mut clock: Clock, steps: u64) -> Vec<(usize, Divergence)> {
        let end = clock.steps + steps;
        while self.apart.is_none() && clock.steps < end {
            let block = BLOCK.min(end - clock.steps);
            if self.watched.advance(clock, block) {
                clock.steps += block;
            } else {
                self.apart = Some(self.taken_apart());
            }
        }
        match &mut self.apart {
            Some(apart) => apart.advance(clock, end - clock.steps),
            None => Vec::new(),
        }
    }

    fn state(&self, member: usize, clock: Clock) -> Phase<C> {
        if let Some(apart) = &self.apart {
            return apart.state(member, clock);
        }
        let lane = member - self.first;
        self.watched.state(lane, clock, &self.members[lane].1)
    }

    fn energy(&self, member: usize, clock: Clock) -> f64 {
        if let Some(apart) = &self.apart {
            return apart.energy(member, clock);
        }
        let (state, parameters) = (self.state(member, clock), &self.members[member - self.first].0);
        self.alone.energy(&M::load(|_| (parameters, &state)), clock.at(clock.steps))
    }
}
