//! Gradients of a function of the ends of many runs, in SIMD lanes and on threads.

use crate::{
    ensemble::{
        Ensemble,
        batches::neighbours,
        in_lanes,
        lane_scalars::LaneScalars,
        member,
        way_back::{Back, LANES_OF_MEMBER, back, lane_of, shares_lanes, take},
    },
    error::Error,
    state::{clock::Clock, coords::Coords, phase::Phase, point::Point},
    system::{energy::energy, motion::Prepared, parameter_derivatives::ParameterDerivatives},
    threads::in_turns,
    trajectory::{
        dispatch::Nothing,
        engine::Engine,
        gradient::{Derivatives, Gradient, Reads, Way, check, gradient, in_precision, refusal, turned, turned_back},
        in_lanes::InLanes,
        method::Differentiable,
        motions::{Motions, load},
    },
};
use std::{ops::Range, sync::Arc};

/// The number of groups of members that a thread takes at a time. Those of a group go through the stages together.
const GROUPS: usize = 4;

impl<C: Coords> Ensemble<C> {
    /// Computes a function of the end of the run of each `(system, start)` pair, and its gradient like
    /// [`Hamiltonian::gradient`](crate::Hamiltonian::gradient).
    ///
    /// `loss` is called with the index of a member and its end; it returns the value and the derivatives with respect to
    /// positions and momenta. The gradient of a sum over members is the list of these gradients, and the sum of the derivatives
    /// with respect to parameters that they share. Results are in the order of the pairs, and bitwise independent of the other
    /// members and of the number of threads.
    ///
    /// Members share SIMD lanes. Those from [reversible](Phase::reversible) starts, and those with parameters by a method or a
    /// splitting that is not a composition of `T(p)` and `V(q)`, are distributed over threads.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Pendulum { length: f64 }
    ///
    /// #[hamiltonian]
    /// impl Pendulum {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / (2.0 * self.length.powi(2)) }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { -9.81 * self.length * q[0].cos() }
    /// }
    ///
    /// let members = (1..=100).map(|i| (Pendulum { length: i as f64 / 100.0 }, Phase::new([1.0_f64], [0.0])));
    /// let loss = |_, end: &Phase<[f64; 1]>| (end.q[0], Phase::new([1.0], [0.0]));
    /// let gradients = Ensemble::gradients(KahanLi8, members, 0.01, 100, loss);
    /// let longest = gradients[99].as_ref().expect("a finite end");
    /// assert!(longest.start.q[0].abs() < 2.0);
    /// ```
    ///
    /// # Errors
    /// Each member has a result of its own, with the errors of [`Hamiltonian::gradient`](crate::Hamiltonian::gradient).
    pub fn gradients<H, X>(
        method: X,
        members: impl IntoIterator<Item = (H, Phase<C>)>,
        h: f64,
        steps: u64,
        loss: impl Fn(usize, &Phase<C>) -> (f64, Phase<H::Coords>) + Sync,
    ) -> Vec<Result<Gradient<H::Coords>, Error>>
    where
        H: ParameterDerivatives + Sync,
        X: InLanes<H> + Differentiable<H>,
        C::Leaf: LaneScalars,
        H::Coords: Coords<With<C::Leaf> = C>,
        C: Coords<With<f64> = H::Coords>,
    {
        let members: Vec<_> = members.into_iter().collect();
        let alone = |number: usize| {
            let (system, start) = &members[number];
            let reads = Reads::End(steps);
            gradient::<H, X, C::Leaf>(system, method, start.clone(), h, reads, &mut |end| loss(number, &end.state))
        };
        let all_alone = || in_turns((0..members.len()).collect(), &alone);
        if const { !shares_lanes::<H, X, C::Leaf>() } {
            return all_alone();
        }
        let has_energy = |prepared: &Arc<_>, state: &Phase<C>, time| {
            energy::<H, C::Leaf>(prepared, state, time, None).admissible(time).is_ok()
        };
        let prepared = members.iter().map(|(system, start)| {
            let prepared = member::<H, C::Leaf, X>(system, method, start, h).ok();
            prepared.filter(|prepared| refusal::<H, X>(method).is_none() && has_energy(prepared, start, 0.0))
        });
        let parameters: Vec<Option<Arc<_>>> = prepared.collect();
        // Those of members without parameters are never read.
        let constants = parameters.iter().zip(&members).map(|(prepared, (system, start))| {
            let prepared = prepared.clone();
            method.constants(prepared.unwrap_or_else(|| Arc::new(system.parameters(start.q.length()))))
        });
        let constants = Arc::new(constants.collect::<Vec<_>>());
        let there = in_lanes::<H, X, C::Leaf, Nothing>(constants.clone());
        let Some(back) = back::<H, X, C>(method, constants, &parameters) else { return all_alone() };
        let alike = |a: usize, b: usize| match (&parameters[a], &parameters[b]) {
            (Some(of_a), Some(of_b)) => {
                let same = <H::Parameters<f64> as Prepared<f64>>::alike(of_a, of_b);
                same && members[a].1.q.length() == members[b].1.q.length()
            }
            _ => false,
        };
        let group = back.lanes / LANES_OF_MEMBER * GROUPS;
        let ends_with_energy = |number: usize, end: &Phase<C>, time: f64| {
            parameters[number].as_ref().is_some_and(|prepared: &Arc<_>| has_energy(prepared, end, time))
        };
        let request =
            Request { h, steps, there: &*there, back: &back, loss: &loss, ends_with_energy: &ends_with_energy };
        let found = in_turns(neighbours(members.len(), group, &alike), &|batch: Range<usize>| {
            let starts: Vec<_> = batch.clone().map(|number| (number, &members[number].1)).collect();
            let can_start = parameters[batch.start].is_some();
            let together = if can_start { request.together(&starts) } else { None };
            together.unwrap_or_else(|| batch.map(alone).collect::<Vec<_>>())
        });
        found.into_iter().flatten().collect()
    }
}

/// A function of the end of the run of a member, as [`Ensemble::gradients`] calls it.
type LossOfMember<'l, C> = dyn Fn(usize, &Phase<C>) -> (f64, Derivatives<C>) + Sync + 'l;

/// The result for a member.
type Found<C> = Result<Gradient<<C as Coords>::With<f64>>, Error>;

/// What is asked of members in lanes.
struct Request<'r, C: Coords> {
    h: f64,
    steps: u64,
    there: &'r dyn Motions,
    back: &'r Back<'r, C>,
    loss: &'r LossOfMember<'r, C>,
    /// Whether the energy of a member at its end is finite.
    ends_with_energy: &'r (dyn Fn(usize, &Phase<C>, f64) -> bool + Sync),
}

impl<C: Coords> Request<'_, C> {
    /// The gradients of members in lanes; nothing if one of them cannot take all steps on both ways, or has an error.
    fn together(&self, starts: &[(usize, &Phase<C>)]) -> Option<Vec<Found<C>>> {
        let mut ways: Vec<_> = starts.iter().map(|(_, start)| Way::from((*start).clone())).collect();
        let mut engine = Engine::new(load(
            self.there,
            starts.iter().map(|(number, start)| (*number, *start as &dyn Point)).collect(),
        ));
        let mut clock = Clock { t0: 0.0, h: self.h, steps: 0 };
        clock.end(self.steps).ok()?;
        for portion in [self.steps / 2, self.steps - self.steps / 2] {
            take(&mut engine, &mut clock, portion)?;
            for (lane, way) in ways.iter_mut().enumerate() {
                way.see(lane_of(&engine, clock, lane, &way.last));
            }
        }
        let (mut values, mut lanes) =
            (Vec::with_capacity(starts.len()), Vec::with_capacity(LANES_OF_MEMBER * starts.len()));
        for ((number, _), way) in starts.iter().zip(&ways) {
            let (value, derivatives) = (self.loss)(*number, &way.last);
            check(&way.last, &derivatives, self.steps).ok()?;
            if !(self.ends_with_energy)(*number, &way.last, clock.at(self.steps)) {
                return None;
            }
            values.push(value);
            let vector = in_precision(&way.last, &turned(&derivatives));
            lanes.extend([(*number, way.last.clone()), (*number, vector)]);
        }
        // Whole motions: those after the last member repeat it.
        let last = lanes[lanes.len() - LANES_OF_MEMBER..].to_vec();
        let missing = lanes.len().next_multiple_of(self.back.lanes) - lanes.len();
        lanes.extend(last.into_iter().cycle().take(missing));
        let clock = Clock { t0: clock.at(self.steps), h: -self.h, steps: 0 };
        let (points, slopes) = (self.back.take)(&lanes, clock, self.steps)?;
        let (mut found, parameters) = (Vec::with_capacity(starts.len()), self.back.parameters);
        for ((member, way), value) in ways.iter_mut().enumerate().zip(values) {
            let [state, vector] = [0, 1].map(|lane| &points[LANES_OF_MEMBER * member + lane]);
            way.see(state.clone());
            let slopes = slopes[parameters * member..parameters * (member + 1)].to_vec();
            found.push(way.gradient(value, turned_back(vector.to_f64()), slopes));
        }
        Some(found)
    }
}
