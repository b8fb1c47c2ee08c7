//! The factors of `O` for one duration, in the layout of the momenta.

use super::rates::Rates;
use crate::{
    scalar::{elementary::Elementary, real::Real},
    system::dissipation::WithFriction,
};
use alloc::{sync::Arc, vec::Vec};

/// The factors of all momenta for a duration.
#[derive(Clone)]
pub(super) struct Factors<W> {
    pub(super) duration: f64,
    pub(super) rows: Arc<[Row<W>]>,
}

/// The factors of a slot.
#[derive(Clone, Copy)]
pub(super) struct Row<W> {
    /// `exp(-γt) - 1`, by which friction multiplies a momentum for its change.
    pub(super) friction: W,
    /// `√(m kT (1 - exp(-2γt)))`, the width of the noise.
    pub(super) noise: W,
}

impl<W: Real> Factors<W> {
    /// The factors for motions with this number of slots, whose members have these rates.
    pub(super) fn of<H: WithFriction<Wide<R> = W>, R: Real>(members: &[Rates], slots: usize, duration: f64) -> Self {
        let alike = members.iter().all(|member| member.rates.len() == 1);
        let count = if alike { slots.min(1) } else { slots };
        let rows = (0..count).map(|slot| {
            // The rate and the variance of a lane; lanes after the last coordinate have none.
            let of_lane = |lane: usize| {
                let (member, part) = (&members[lane % R::LANES % members.len()], lane / R::LANES);
                let coordinate = if member.rates.len() == 1 { 0 } else { H::coordinate::<R>(slot, part) };
                let rate = member.rates.get(coordinate).copied().unwrap_or(0.0);
                (rate, member.variances.get(coordinate).copied().unwrap_or(0.0))
            };
            Row {
                friction: W::parameter(&|lane| Elementary::exp_m1(-of_lane(lane).0 * duration)),
                noise: W::parameter(&|lane| {
                    let (rate, variance) = of_lane(lane);
                    Elementary::sqrt(variance * -Elementary::exp_m1(-2.0 * rate * duration))
                }),
            }
        });
        Self { duration, rows: rows.collect::<Vec<_>>().into() }
    }
}
