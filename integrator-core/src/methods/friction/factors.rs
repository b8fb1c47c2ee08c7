//! The factors of `O` for one duration, in the layout of the momenta.

use super::rates::{Coordinate, Rates};
use crate::{scalar::real::Real, system::dissipation::WithFriction};
use alloc::{sync::Arc, vec::Vec};

/// The factors of a slot: those of the coordinates in its lanes.
#[derive(Clone, Copy)]
pub(super) struct Row<W> {
    pub(super) friction: W,
    pub(super) noise: W,
}

/// The factors of all slots for a duration; one row, where all coordinates are alike.
pub(super) fn rows<H: WithFriction, R: Real>(members: &[Rates], slots: usize, duration: f64) -> Arc<[Row<H::Wide<R>>]> {
    let members = over(members, duration);
    let mut rows = Vec::with_capacity(slots);
    let count = if are_alike(&members) { slots.min(1) } else { slots };
    for slot in 0..count {
        let of_lane =
            |lane: usize| of_coordinate(&members, lane % R::LANES, || H::coordinate::<R>(slot, lane / R::LANES));
        rows.push(Row {
            friction: H::Wide::<R>::parameter(&|lane| of_lane(lane).friction),
            noise: H::Wide::<R>::parameter(&|lane| of_lane(lane).noise),
        });
    }
    rows.into()
}

/// The factors of the members for a duration.
fn over(members: &[Rates], duration: f64) -> Vec<Vec<Coordinate>> {
    members.iter().map(|member| member.over(duration)).collect()
}

fn are_alike(members: &[Vec<Coordinate>]) -> bool {
    members.iter().all(|member| member.len() == 1)
}

/// The factors of a coordinate of a member. Lanes after the last coordinate have neither friction nor noise.
fn of_coordinate(members: &[Vec<Coordinate>], member: usize, coordinate: impl Fn() -> usize) -> Coordinate {
    let member = &members[member % members.len()];
    let coordinate = if member.len() == 1 { 0 } else { coordinate() };
    member.get(coordinate).copied().unwrap_or(Coordinate { friction: 0.0, noise: 0.0 })
}
