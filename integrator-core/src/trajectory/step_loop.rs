//! The loop over steps, and the end of the current step: compositions applied to the flows of an executor.

use crate::{
    composition::{
        Composition, Lead,
        corrected_durations::{Between, Corrections},
    },
    layout::lattice::carried::CarriedApart,
    scalar::real::{Kernel, Real},
    state::{clock::Clock, precision::Precision},
    system::{
        System,
        flows::{Flows, Single},
        motion::{InRegisters, Motion},
    },
};
use core::marker::PhantomData;

/// The n-step loop.
pub(crate) struct Advance<F, H, X> {
    flows: F,
    clock: Clock,
    steps: u64,
    marker: PhantomData<(fn(H), X)>,
}

impl<F, H, X> Advance<F, H, X> {
    pub(crate) fn new(flows: F, clock: Clock, steps: u64) -> Self {
        Self { flows, clock, steps, marker: PhantomData }
    }
}

impl<F: Flows<H>, H: System, X: Composition<H>> Kernel for Advance<F, H, X> {
    type Out = ();

    #[inline(always)]
    fn call(mut self) {
        let Clock { h, steps: mut step, .. } = self.clock;
        let end = step + self.steps;
        if const { X::STAGES.are_whole::<H>() } {
            return self.whole_steps(end);
        }
        if step == 0 && end > 0 {
            X::open(&mut self.flows, h, self.clock.at(0));
            step = 1;
        }
        if F::COMPENSATED {
            let corrections = Corrections::new(&X::STAGES, h, const { Between::of::<H>() });
            if !corrections.none() {
                while step < end {
                    X::cycle(&mut corrections.on(&mut self.flows, step), h, self.clock.at(step));
                    step += 1;
                }
            }
        }
        while step < end {
            X::cycle(&mut self.flows, h, self.clock.at(step));
            step += 1;
        }
    }
}

impl<F: Flows<H>, H: System, X: Composition<H>> Advance<F, H, X> {
    /// Takes whole steps: each step ends before the next one begins, with its own middle.
    #[inline(always)]
    fn whole_steps(mut self, end: u64) {
        let Clock { h, steps, .. } = self.clock;
        let corrections = Corrections::of_whole_steps(&X::STAGES, &X::PROCESSOR, h, const { Between::of::<H>() });
        for step in steps..end {
            if let Some(under_way) = step.checked_sub(1) {
                let time = self.clock.at(under_way);
                self.flows.begin_step(time + h / 2.0);
                X::close(&mut self.flows, h, time);
            }
            let time = self.clock.at(step);
            self.flows.begin_step(time + h / 2.0);
            if F::COMPENSATED {
                X::open(&mut corrections.on(&mut self.flows, step), h, time);
            } else {
                X::open(&mut self.flows, h, time);
            }
        }
    }
}

/// The n-step loop of one motion.
pub(crate) struct AdvanceOne<'m, H: System, X, R: Real, K: Precision> {
    motion: &'m mut H::Motion<R, K>,
    clock: Clock,
    steps: u64,
    marker: PhantomData<X>,
}

impl<'m, H: System, X, R: Real, K: Precision> AdvanceOne<'m, H, X, R, K> {
    pub(crate) fn new(motion: &'m mut H::Motion<R, K>, clock: Clock, steps: u64) -> Self {
        Self { motion, clock, steps, marker: PhantomData }
    }
}

impl<H: System, X: Composition<H>, R: Real, K: Precision> Kernel for AdvanceOne<'_, H, X, R, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { motion, clock, steps, .. } = self;
        if const {
            match <H::Motion<R, K> as Motion<_, _>>::IN_REGISTERS {
                InRegisters::Never => false,
                InRegisters::Kicked => matches!(X::STAGES.lead, Lead::Kick),
                InRegisters::Always => true,
            }
        } {
            let mut own = motion.take();
            Advance::<_, H, X>::new(Single::<H, R, K>(&mut own), clock, steps).call();
            *motion = own;
        } else {
            Advance::<_, H, X>::new(Single::<H, R, K>(motion), clock, steps).call();
        }
    }
}

/// The n-step loop of a short lattice whose state is compensated.
pub(crate) struct AdvanceApart<'m, H: System, X, R: Real, K: Precision>(AdvanceOne<'m, H, X, R, K>);

impl<'m, H: System, X, R: Real, K: Precision> AdvanceApart<'m, H, X, R, K> {
    pub(crate) fn new(motion: &'m mut H::Motion<R, K>, clock: Clock, steps: u64) -> Self {
        Self(AdvanceOne::new(motion, clock, steps))
    }
}

impl<H: System, X: Composition<H>, R: Real, K: Precision> Kernel for AdvanceApart<'_, H, X, R, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let AdvanceOne { motion, clock, steps, .. } = self.0;
        if let Some(mut flows) = CarriedApart::<H, R, K>::load(motion) {
            Advance::<_, H, X>::new(&mut flows, clock, steps).call();
            flows.store();
        }
    }
}

/// The end of the current step: its last stages, or the inverse of the processor after them.
pub(crate) struct End<F, H, X, const SHOWN: bool> {
    flows: F,
    clock: Clock,
    marker: PhantomData<(fn(H), X)>,
}

impl<F, H, X, const SHOWN: bool> End<F, H, X, SHOWN> {
    pub(crate) fn new(flows: F, clock: Clock) -> Self {
        Self { flows, clock, marker: PhantomData }
    }
}

impl<F: Flows<H>, H: System, X: Composition<H>, const SHOWN: bool> Kernel for End<F, H, X, SHOWN> {
    type Out = ();

    #[inline(always)]
    fn call(mut self) {
        if let Some(under_way) = self.clock.steps.checked_sub(1) {
            let (h, time) = (self.clock.h, self.clock.at(under_way));
            if const { H::PIECEWISE_IN_TIME } {
                self.flows.begin_step(time + h / 2.0);
            }
            if SHOWN {
                X::show(&mut self.flows, h, time);
            } else {
                X::complete(&mut self.flows, h, time);
            }
        }
    }
}
