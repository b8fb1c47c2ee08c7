//! Points of phase space behind a pointer, of any shape: engines are compiled once for these.

use crate::{
    error::Divergence,
    state::{clock::Clock, coords::Coords, phase::Phase, precision::Precision},
};
use alloc::boxed::Box;
use core::any::Any;

/// A type-erased state.
pub(crate) trait Point: Any + Send + Sync {
    fn boxed_clone(&self) -> Box<dyn Point>;
    fn is_finite(&self) -> bool;
    /// The report on a trajectory that has taken its last finite step, to this state; one more leads to `next`.
    fn divergence(&self, next: &dyn Point, clock: Clock) -> Divergence;
}

impl<C: Coords> Point for Phase<C> {
    fn boxed_clone(&self) -> Box<dyn Point> {
        Box::new(self.clone())
    }

    fn is_finite(&self) -> bool {
        all_finite(self.q.flat()) && all_finite(self.p.flat())
    }

    fn divergence(&self, next: &dyn Point, clock: Clock) -> Divergence {
        clock.divergence(self, shaped(next))
    }
}

impl Clone for Box<dyn Point> {
    fn clone(&self) -> Self {
        (**self).boxed_clone()
    }
}

fn all_finite<K: Precision>(leaves: &[K]) -> bool {
    for leaf in leaves {
        if !leaf.to_f64().is_finite() {
            return false;
        }
    }
    true
}

/// The point in its shape, which is that of its run or ensemble.
pub(crate) fn shaped<C: Coords>(point: &dyn Point) -> &Phase<C> {
    match (point as &dyn Any).downcast_ref() {
        Some(point) => point,
        None => mixed_up(),
    }
}

/// The point in its shape, to be written.
pub(crate) fn shaped_mut<C: Coords>(point: &mut dyn Point) -> &mut Phase<C> {
    match (point as &mut dyn Any).downcast_mut() {
        Some(point) => point,
        None => mixed_up(),
    }
}

/// Panics: all states of a run or of an ensemble have one type, and so have its motions.
#[cold]
#[inline(never)]
pub(crate) fn mixed_up() -> ! {
    unreachable!("states or motions of two systems mixed up")
}
