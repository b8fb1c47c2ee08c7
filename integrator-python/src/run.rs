//! Runs without their types: what the Python class `Run` calls.

use crate::{
    errors::Fault,
    interrupt::{Pulse, Report},
};
use integrator_core::{Coords, Direction, Error, Run, Sample};

/// The number of steps up to which a call of `advance` is not interrupted.
const SHORT: u64 = 256;

/// The most numbers for which columns have room at once.
const ROOM: u64 = 1 << 24;

/// The function whose zeros are searched, of positions, momenta and time.
pub(crate) type Crossed<'f> = &'f mut (dyn FnMut(&[f64], &[f64], f64) -> f64 + Send);

/// Samples, one after the other.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    pub(crate) t: Vec<f64>,
    pub(crate) q: Vec<f64>,
    pub(crate) p: Vec<f64>,
    pub(crate) energy: Vec<f64>,
    pub(crate) invariants: Vec<(&'static str, Vec<f64>)>,
}

impl Columns {
    /// Adds a sample; the first one makes room for `count`.
    fn push<C: Coords>(&mut self, sample: &Sample<C>, count: u64) {
        let state = sample.state.to_f64();
        if self.t.is_empty() {
            let width = state.q.flat().len() as u64;
            let room = |width: u64| usize::try_from(count.saturating_mul(width).min(ROOM)).unwrap_or_default();
            self.t.reserve(room(1));
            self.energy.reserve(room(1));
            self.q.reserve(room(width));
            self.p.reserve(room(width));
            self.invariants = sample.invariants().map(|(name, _)| (name, Vec::new())).collect();
        }
        self.t.push(sample.time);
        self.q.extend_from_slice(state.q.flat());
        self.p.extend_from_slice(state.p.flat());
        self.energy.push(sample.energy());
        for ((_, values), (_, value)) in self.invariants.iter_mut().zip(sample.invariants()) {
            values.push(value);
        }
    }
}

/// A run of any system, by any method, in any precision.
pub(crate) trait AnyRun: Send + Sync {
    fn advance(&mut self, steps: u64, report: Report<'_>) -> Result<(), Fault>;
    fn advance_to(&mut self, time: f64) -> Result<(), Fault>;
    /// The positions and the momenta.
    fn state(&self) -> [Vec<f64>; 2];
    fn time(&self) -> f64;
    fn step(&self) -> f64;
    fn steps(&self) -> u64;
    fn energy(&self) -> f64;
    fn invariant(&self, name: &str) -> Result<f64, Fault>;
    fn watch_energy(&mut self, bound: f64) -> Result<(), Fault>;
    /// Takes samples, the first of the present state. `report` hears how many of them are done.
    fn sample(&mut self, count: u64, every: u64, columns: &mut Columns, report: Report<'_>) -> Result<(), Fault>;
    /// Finds zeros within a number of steps.
    fn crossings(
        &mut self,
        count: u64,
        steps: u64,
        direction: Direction,
        function: Crossed<'_>,
        columns: &mut Columns,
    ) -> Result<(), Fault>;
}

impl<C: Coords> AnyRun for Run<C> {
    fn advance(&mut self, steps: u64, report: Report<'_>) -> Result<(), Fault> {
        self.advance_with(steps, |progress| report(progress.done, progress.steps))?;
        Ok(())
    }
    fn advance_to(&mut self, time: f64) -> Result<(), Fault> {
        Ok(Self::advance_to(self, time)?)
    }
    fn state(&self) -> [Vec<f64>; 2] {
        let state = Self::state(self).to_f64();
        [state.q.flat().to_vec(), state.p.flat().to_vec()]
    }
    fn time(&self) -> f64 {
        Self::time(self)
    }
    fn step(&self) -> f64 {
        Self::step(self)
    }
    fn steps(&self) -> u64 {
        Self::steps(self)
    }
    fn energy(&self) -> f64 {
        Self::energy(self)
    }
    fn invariant(&self, name: &str) -> Result<f64, Fault> {
        Ok(Self::invariant(self, name)?)
    }
    fn watch_energy(&mut self, bound: f64) -> Result<(), Fault> {
        Ok(Self::watch_energy(self, bound)?)
    }
    fn sample(&mut self, count: u64, every: u64, columns: &mut Columns, report: Report<'_>) -> Result<(), Fault> {
        if every == 0 {
            return Err(Error::SampleInterval.into());
        }
        let mut pulse = Pulse::new();
        for done in 0..count {
            let end = self.steps().saturating_add(every);
            if done > 0 && every <= SHORT {
                Self::advance(self, every)?;
            } else if done > 0 {
                self.advance_with(every, |_| report(done, count))?;
                if self.steps() < end {
                    return Ok(());
                }
            }
            for sample in self.by_ref().samples(every).take(1) {
                columns.push(&sample?, count);
            }
            if (pulse.is_due() || done + 1 == count) && report(done + 1, count).is_break() {
                return Ok(());
            }
        }
        Ok(())
    }
    fn crossings(
        &mut self,
        count: u64,
        steps: u64,
        direction: Direction,
        function: Crossed<'_>,
        columns: &mut Columns,
    ) -> Result<(), Fault> {
        let mut found = self.by_ref().crossings(steps, direction, |state, time| {
            let state = state.to_f64();
            function(state.q.flat(), state.p.flat(), time)
        });
        for _ in 0..count {
            match found.next() {
                Some(sample) => columns.push(&sample?, 1),
                None => return Ok(()),
            }
        }
        Ok(())
    }
}
