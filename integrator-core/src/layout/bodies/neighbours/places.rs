//! Where bodies are when lists are made.
//!
//! In: coordinates in `f64`. Out: lists. Always true: nothing here depends on the system or on the numbers that it computes in. So
//! the search for neighbours in a plane and in space is compiled with this crate, once for all systems.

use super::{cells::Cells, lists::Lists};
use crate::scalar::real::Real;
use alloc::vec::Vec;

/// The bodies of a member: their coordinates one body after the other, the sides of their box, and the radius of their lists.
pub(super) struct Places {
    pub(super) coordinates: Vec<f64>,
    pub(super) sides: Vec<f64>,
    pub(super) radius: f64,
}

/// The largest coordinate that is finite.
pub(super) fn farthest(coordinates: &[f64]) -> f64 {
    coordinates.iter().filter(|x| x.is_finite()).fold(0.0, |farthest, x| farthest.max(Real::abs(*x)))
}

/// Lists this number of bodies that are within the radius of each other in any of the members, in the memory of old lists.
pub(super) fn lists<const D: usize>(members: &[Places], bodies: usize, threads: usize, old: Option<Lists>) -> Lists {
    if const { D == 2 } {
        return in_plane(members, bodies, threads, old);
    }
    if const { D == 3 } {
        return in_space(members, bodies, threads, old);
    }
    in_dimensions::<D>(members, bodies, threads, old)
}

/// Lists in two dimensions: no generic function.
#[inline(never)]
fn in_plane(members: &[Places], bodies: usize, threads: usize, old: Option<Lists>) -> Lists {
    in_dimensions::<2>(members, bodies, threads, old)
}

/// The same in three dimensions.
#[inline(never)]
fn in_space(members: &[Places], bodies: usize, threads: usize, old: Option<Lists>) -> Lists {
    in_dimensions::<3>(members, bodies, threads, old)
}

fn in_dimensions<const D: usize>(members: &[Places], bodies: usize, threads: usize, old: Option<Lists>) -> Lists {
    let mut cells = Vec::with_capacity(members.len());
    for Places { coordinates, sides: given, radius } in members {
        let mut sides = [0.0; D];
        sides.copy_from_slice(given);
        cells.push(Cells::<D>::new(coordinates.as_chunks().0.to_vec(), sides, *radius));
    }
    Lists::new(bodies, &cells, threads, old)
}
