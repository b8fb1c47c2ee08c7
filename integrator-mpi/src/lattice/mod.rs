//! A long lattice that is distributed over ranks.
//!
//! Every rank integrates a slab of sites with the flows of a line of its length. The error from the ends of the slab,
//! where other sites are missing, moves inwards by a few sites per step. Before it has crossed the halo, the neighbours
//! send the values of these sites. Each site of a rank is hence bitwise identical to that in a run of all sites on one
//! rank.

mod border;
mod checkpoint;
mod exchange;
mod looks;
mod slab;

use crate::error::{Error, Failure, agree};
use border::{Border, Moved, put_all};
use exchange::{differing, halos, put};
use integrator_core::{
    __private::{Composition, Precision, go_on_from, unfinished},
    Coords, Error as CoreError, Hamiltonian, Phase, Run,
};
use mpi::{
    collective::SystemOperation,
    traits::{Communicator, CommunicatorCollectives},
};
use slab::{Reach, Slab};
use std::{any::type_name, mem::replace};

/// A run of some sites, by their numbers, from a state.
type RunOf<'w, C> = Box<dyn Fn(&[usize], Phase<C>) -> Result<Run<C>, CoreError> + 'w>;

/// A long chain of sites, or a plane of rows of fixed width, distributed over all ranks of a communicator.
///
/// Each site is bitwise identical to that in a [`Run`] of all sites on one rank with the same instruction set, for
/// every number of ranks. Collective methods are marked, as for [`crate::Ensemble`].
pub struct Lattice<'w, W: Communicator, C: Coords> {
    world: &'w W,
    run: Run<C>,
    slab: Slab,
    /// The slab in the middle of the current step, when the neighbours last said what its halos are, and after how many
    /// steps that was.
    exchanged: (Phase<C>, u64),
    /// After how many steps the state was last changed from outside, which a run may have been that this continues from.
    opened: u64,
    run_of: RunOf<'w, C>,
    /// The borders with its neighbours.
    borders: Vec<Border<C>>,
    /// How many steps were taken while messages travelled.
    overlapped: u64,
}

impl<'w, W: Communicator, C: Coords> Lattice<'w, W, C> {
    /// Creates a lattice of sites, or rows, with step `h` and a composition. Collective.
    ///
    /// `slab` returns the system and the start of the sites with the given indices. Lists of the system have one
    /// element per site.
    ///
    /// ```no_run
    /// use integrator_core::prelude::*;
    /// use integrator_mpi as cluster;
    ///
    /// /// Fermi, Pasta, Ulam and Tsingou's ring.
    /// struct Fput { alpha: f64 }
    ///
    /// #[hamiltonian]
    /// impl Fput {
    ///     fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| p * p / 2.0).sum() }
    ///     fn potential(&self, q: &[f64]) -> f64 {
    ///         (0..q.len())
    ///             .map(|i| {
    ///                 let r = q[(i + 1) % q.len()] - q[i];
    ///                 r * r / 2.0 + self.alpha * r.powi(3) / 3.0
    ///             })
    ///             .sum()
    ///     }
    /// }
    ///
    /// let universe = cluster::start()?;
    /// let world = universe.world();
    /// let mut ring = cluster::Lattice::new(&world, Yoshida4, 10_000_000, 0.05, |sites| {
    ///     let q = sites.iter().map(|site| (*site as f64 * 1e-3).sin()).collect();
    ///     (Fput { alpha: 0.25 }, Phase::new(q, vec![0.0; sites.len()]))
    /// })?;
    /// ring.advance(10_000)?;
    /// let squares = ring.sum(|_, q, _| Some(q[0] * q[0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::NoLattice`]: the system is not a lattice.
    /// - [`Error::FewSites`]: there are too few sites for the number of ranks.
    /// - [`Error::SitesDiffer`]: the formula of a site depends on its index or on the number of sites.
    /// - [`Error::Rank`]: a start or the step is invalid for a run.
    pub fn new<H, X>(
        world: &'w W,
        composition: X,
        sites: usize,
        h: f64,
        slab: impl Fn(&[usize]) -> (H, Phase<C>) + 'w,
    ) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: Composition<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let of_rank = slab_of::<H, X, C>(world, sites)?;
        let (system, start) = slab(&of_rank.indices());
        Self::begin(world, composition, h, of_rank, system, start, slab)
    }

    /// The lattice of which this rank moves these sites from these states.
    fn begin<H, X>(
        world: &'w W,
        composition: X,
        h: f64,
        of_rank: Slab,
        system: H,
        start: Phase<C>,
        slab: impl Fn(&[usize]) -> (H, Phase<C>) + 'w,
    ) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: Composition<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        let begun = || -> Result<_, Failure> {
            let (given, asked) = (start.q.length(), of_rank.indices().len());
            match given == asked {
                true => system.run_with(composition, start.clone(), h).map_err(failure),
                false => Err(Failure::Other(format!("the initial state has {given} sites, but {asked} are required"))),
            }
        };
        let run = agree(world, begun())?;
        let probe = system.run_with(composition, shaken(&start, &of_rank.indices()), h);
        let run_of: RunOf<'w, C> = Box::new(move |sites, state| slab(sites).0.run_with(composition, state, h));
        let sides = (0..2).filter(|side| of_rank.ahead > 0 && of_rank.neighbours[*side].is_some());
        let borders: Result<Vec<_>, _> = sides.map(|side| Border::of(&of_rank, side, &run_of, &start)).collect();
        // A border that cannot be a run of its own waits for its neighbours.
        let borders = agree(world, borders.map_err(failure));
        let mut slab = of_rank;
        slab.ahead = if borders.is_ok() { slab.ahead } else { 0 };
        let (exchanged, borders) = ((unfinished(&run), 0), borders.unwrap_or_default());
        let mut lattice = Self { world, run, slab, exchanged, opened: 0, run_of, borders, overlapped: 0 };
        // Not every system has an energy near its start.
        if let Ok(probe) = agree(world, probe.map_err(failure)) {
            lattice.probe(probe)?;
        }
        Ok(lattice)
    }

    /// Takes a step from a state in which all sites move: it detects a formula that is not the same for all of them.
    fn probe(&mut self, probe: Run<C>) -> Result<(), Error> {
        let started = (unfinished(&probe), 0);
        let (run, start) = (replace(&mut self.run, probe), replace(&mut self.exchanged, started));
        // Where the step leads out of the finite numbers, it tells nothing.
        let outcome = self.take_steps(1).map_or(Ok(()), |()| self.exchange(0));
        (self.run, self.exchanged) = (run, start);
        outcome
    }

    /// Starts the clock at `t0` instead of 0.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.run = self.run.at_time(t0);
        self.borders = self.borders.into_iter().map(|border| border.at_time(t0)).collect();
        self
    }

    /// Limits the number of threads on this rank; the default is all that it may run on. Results do not depend on it.
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.run = self.run.with_threads(threads);
        self.borders = self.borders.into_iter().map(|border| border.with_threads(threads)).collect();
        self
    }

    /// Takes `steps` steps with all sites. Collective.
    ///
    /// # Errors
    /// - [`Error::Diverged`]: a site diverged; all sites keep the state of the step before.
    /// - [`Error::HaloDiverged`]: the border of a slab diverged, where its neighbours are missing.
    /// - [`Error::Rank`]: the time is not finite, or the steps cannot be counted.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        let done = self.steps();
        let end = done.checked_add(steps).ok_or(CoreError::Steps { done, asked: steps });
        let begun = end.and_then(|end| self.run.advance(0).map(|()| end));
        let end = agree(self.world, begun.map_err(failure))?;
        while self.steps() < end {
            let since = self.steps() - self.exchanged.1;
            if since == self.slab.steps {
                self.exchange(self.slab.ahead.min(end - self.steps()))?;
                continue;
            }
            self.take_steps((self.slab.steps - since).min(end - self.steps()))?;
        }
        Ok(())
    }

    /// Takes steps for which the halos are wide enough; fewer, with new halos after them, where the end of a slab has
    /// diverged.
    fn take_steps(&mut self, steps: u64) -> Result<(), Error> {
        let outcome = self.run.advance(steps);
        let (own, mut first) = (last_step(&outcome), u64::MAX);
        self.world.all_reduce_into(&own, &mut first, SystemOperation::min());
        if first == u64::MAX {
            return Ok(());
        }
        let (state, since) = &self.exchanged;
        go_on_from(&mut self.run, *since, self.opened, state);
        let begun = first.max(*since) - since;
        // No rank has diverged in these.
        let again = self.run.advance(begun);
        let site = self.diverged_site(&outcome).filter(|_| own == first);
        let site = site.map_or(u64::MAX, |site| site as u64);
        let mut found = u64::MAX;
        self.world.all_reduce_into(&site, &mut found, SystemOperation::min());
        let (step, time) = (first.saturating_add(1), self.time() + self.run.step());
        if found != u64::MAX {
            return Err(Error::Diverged { site: found as usize, step, time });
        }
        let refused = match outcome {
            Err(CoreError::Diverged(_)) | Ok(()) => again,
            refused => refused,
        };
        agree(self.world, refused.map_err(failure))?;
        if begun == 0 {
            return Err(Error::HaloDiverged { step, time });
        }
        self.exchange(0)
    }

    /// The site of this rank's own that an outcome says has diverged first.
    fn diverged_site(&self, outcome: &Result<(), CoreError>) -> Option<usize> {
        let Err(CoreError::Diverged(divergence)) = outcome else { return None };
        // Where it was not found out which one, it is one of them.
        let place = divergence.coordinate.map_or(self.slab.inner().start, |(_, number)| number / C::COMPONENTS);
        self.slab.inner().contains(&place).then(|| self.slab.indices()[place])
    }

    /// Asks the neighbours what the halos are, and takes steps while their messages travel: those of the interior,
    /// after which the borders come once they know their halos.
    fn exchange(&mut self, ahead: u64) -> Result<(), Error> {
        let (mut state, steps) = (unfinished(&self.run), self.steps());
        let (received, moved) = halos(self.world, &self.slab, &state, || self.run.advance(ahead));
        let site = differing(&self.slab, &state, &received).map_or(u64::MAX, |site| site as u64);
        for (side, numbers) in received.iter().enumerate() {
            put(&mut state, self.slab.halo(side), numbers);
        }
        // What is wrong in the halos may lead out of the finite numbers: then these steps are taken once more.
        let borders = moved.ok().filter(|()| ahead > 0).and_then(|()| self.move_borders(&state, steps, ahead));
        let (own, mut first) = ([site, u64::from(borders.is_some())], [u64::MAX; 2]);
        self.world.all_reduce_into(&own[..], &mut first[..], SystemOperation::min());
        let [site, all_moved] = first;
        if site != u64::MAX {
            return Err(Error::SitesDiffer { site: site as usize });
        }
        match borders.filter(|_| all_moved == 1) {
            Some(borders) => {
                let mut moved = unfinished(&self.run);
                put_all(&mut moved, borders);
                go_on_from(&mut self.run, steps + ahead, self.opened, &moved);
                self.overlapped += ahead;
            }
            None => go_on_from(&mut self.run, steps, self.opened, &state),
        }
        self.exchanged = (state, steps);
        Ok(())
    }

    /// What the borders are this number of steps after a state of the slab; nothing where one of them cannot take these.
    fn move_borders(&mut self, from: &Phase<C>, steps: u64, ahead: u64) -> Option<Vec<Moved>> {
        let since = [steps, self.opened];
        let moved: Result<Vec<_>, _> =
            self.borders.iter_mut().map(|border| border.advance(from, since, ahead)).collect();
        Some(moved.ok()?.into_iter().flatten().collect())
    }
}

/// The sites of this rank.
fn slab_of<H, X, C>(world: &impl Communicator, sites: usize) -> Result<Slab, Error>
where
    H: Hamiltonian,
    X: Composition<H>,
    C: Coords,
{
    Slab::of(reach_of::<H, X, C>()?, sites, world.rank() as usize, world.size() as usize)
}

/// How far what is wrong at the ends of a slab comes, if the system is a lattice.
fn reach_of<H, X, C>() -> Result<Reach, Error>
where
    H: Hamiltonian,
    X: Composition<H>,
    C: Coords,
{
    let reach = Reach::of::<H, X>().filter(|_| C::LENGTH.is_none());
    reach.ok_or_else(|| Error::NoLattice { system: type_name::<H>() })
}

/// The last step before the one of a divergence; the first of all for whatever else is wrong, and none where nothing is.
fn last_step(outcome: &Result<(), CoreError>) -> u64 {
    match outcome {
        Ok(()) => u64::MAX,
        Err(CoreError::Diverged(divergence)) => divergence.step - 1,
        Err(_) => 0,
    }
}

fn failure(error: CoreError) -> Failure {
    Failure::Other(error.to_string())
}

/// A state near the start, in which every site moves: each by an amount that follows from its number.
fn shaken<C: Coords>(start: &Phase<C>, sites: &[usize]) -> Phase<C> {
    let mut state = start.clone();
    for (half, number) in [(&mut state.q, 0.0), (&mut state.p, 0.5)] {
        for (place, leaf) in half.flat_mut().iter_mut().enumerate() {
            let site = (sites[place / C::COMPONENTS] * C::COMPONENTS + place % C::COMPONENTS) as f64;
            let parts = leaf.parts();
            // The golden ratio leaves no two sites alike.
            let by = ((site * 0.618_033_988_749_895 + number).fract() - 0.5) / 64.0;
            *leaf = C::Leaf::from_parts([parts[0] + by, parts[1]]);
        }
    }
    state
}
