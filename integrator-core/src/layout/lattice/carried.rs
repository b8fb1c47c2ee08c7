//! Compensated states of short lattices: the numbers in arrays of their own, and what they carry in others, so that both
//! are vectors from the first stage of a block of steps to the last.
//!
//! A flow of a lattice reads one half of the state and adds to the other. It adds to what the numbers of that half carry,
//! as if this were the half itself; then each number takes over what it can, and carries the rest. These are the
//! operations of a slot that is moved by itself, in the same order.

use crate::{
    layout::lattice::sites::is_short,
    scalar::{exact::fast_two_sum, real::Real, simd::block::Block},
    state::{
        coords::Coords,
        precision::{Precision, Slot},
    },
    system::{
        QuadraticKinetic, System,
        flows::Flows,
        sites::{Flow, Sites},
    },
};

/// A number for each site.
type Numbers<H, R> = <<H as System>::Coords as Coords>::Slots<R>;

/// Half of a state: a number for each site, and what it carries.
struct Half<H: System, R: Real> {
    numbers: Numbers<H, R>,
    carried: Numbers<H, R>,
}

impl<H: System, R: Real> Half<H, R> {
    #[inline(always)]
    fn of<S: Slot<R>>(slots: &[S]) -> Self {
        let part = |part: usize| H::Coords::slots_from(slots.len(), |site| slots[site].parts()[part]);
        Self { numbers: part(0), carried: part(1) }
    }

    #[inline(always)]
    fn store<S: Slot<R>>(&self, slots: &mut [S]) {
        let (numbers, carried) = (H::Coords::slots(&self.numbers), H::Coords::slots(&self.carried));
        for (slot, (number, carried)) in slots.iter_mut().zip(numbers.iter().zip(carried)) {
            *slot = S::of_parts([*number, *carried]);
        }
    }

    /// Adds the carried numbers to the numbers, and carries the rounding errors.
    #[inline(always)]
    fn take_over(&mut self) {
        let numbers = H::Coords::slots_mut(&mut self.numbers);
        let carried = H::Coords::slots_mut(&mut self.carried);
        let blocks = numbers.len() - numbers.len() % R::Block::WIDTH;
        let ((numbers, last_numbers), (carried, last_carried)) =
            (numbers.split_at_mut(blocks), carried.split_at_mut(blocks));
        take_over::<R, R::Block>(numbers, carried);
        take_over::<R, R>(last_numbers, last_carried);
    }
}

/// Adds the carried numbers to those of a slice, in blocks that divide both slices evenly.
#[inline(always)]
fn take_over<R: Real, B: Block<R>>(numbers: &mut [R], carried: &mut [R]) {
    for (numbers, carried) in numbers.chunks_exact_mut(B::WIDTH).zip(carried.chunks_exact_mut(B::WIDTH)) {
        let [number, rest] = fast_two_sum(B::read(numbers), B::read(carried));
        number.write(numbers);
        rest.write(carried);
    }
}

/// The executor of short lattices whose state is compensated.
pub(crate) struct CarriedApart<'m, H: System, R: Real, K: Precision> {
    motion: &'m mut H::Motion<R, K>,
    q: Half<H, R>,
    p: Half<H, R>,
}

impl<'m, H: System, R: Real, K: Precision> CarriedApart<'m, H, R, K> {
    /// Whether numbers and what they carry are taken apart: where sites are moved in blocks that fit into registers.
    pub(crate) const ENABLED: bool = K::COMPENSATED
        && <R::Block as Block<R>>::WIDTH > 1
        && matches!(H::STENCIL_RADII, Some(radii) if !radii.of_layers)
        && H::PARTS.len() <= 2
        && !H::PIECEWISE_IN_TIME
        && is_short::<H::Coords>();

    /// Separates the numbers of a motion from those that they carry; `None` where it is no lattice.
    #[inline(always)]
    pub(crate) fn load(motion: &'m mut H::Motion<R, K>) -> Option<Self> {
        let sites = H::sites::<R, K>(motion)?;
        let (q, p) = (Half::of(sites.q), Half::of(sites.p));
        Some(Self { motion, q, p })
    }

    /// Writes the separated numbers back to the motion.
    #[inline(always)]
    pub(crate) fn store(&mut self) {
        if let Some(sites) = H::sites::<R, K>(self.motion) {
            self.q.store(sites.q);
            self.p.store(sites.p);
        }
    }

    #[inline(always)]
    fn apply(&mut self, flow: &Flow) {
        let Some(Sites { parameters, first, length, .. }) = H::sites::<R, K>(self.motion) else { return };
        let (q, p) = if flow.drifts {
            (&mut self.q.carried, &mut self.p.numbers)
        } else {
            (&mut self.q.numbers, &mut self.p.carried)
        };
        let (q, p) = (H::Coords::slots_mut(q), H::Coords::slots_mut(p));
        let sites = Sites { q, p, parameters, first, length, columns: 1 };
        H::apply_to_sites::<R, f64>(sites.moved_by(flow.drifts), flow, 0..length);
        if flow.drifts { self.q.take_over() } else { self.p.take_over() }
    }
}

impl<H: System, R: Real, K: Precision> Flows<H> for &mut CarriedApart<'_, H, R, K> {
    const COMPENSATED: bool = K::COMPENSATED;

    #[inline(always)]
    fn drift(&mut self, duration: f64, time: f64) {
        self.apply(&Flow { drifts: true, duration, time });
    }
    #[inline(always)]
    fn kick(&mut self, duration: f64, time: f64) {
        self.apply(&Flow { drifts: false, duration, time });
    }
    fn middle(&mut self, _duration: f64, _time: f64, _backwards: bool) {}
    #[inline(always)]
    fn gradient_kick(&mut self, duration: f64, gradient: f64, time: f64)
    where
        H: QuadraticKinetic,
    {
        self.store();
        H::gradient_kick::<R, K>(self.motion, duration, gradient, time);
        if let Some(Sites { p, .. }) = H::sites::<R, K>(self.motion) {
            self.p = Half::of(p);
        }
    }
}
