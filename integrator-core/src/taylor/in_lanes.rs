//! Members of an ensemble, each on polynomials of its own.

use super::{
    Recurrences, Taylor,
    expansion::{Of, follow},
    moment::Moment,
};
use crate::{group::GroupMoves, hamiltonian::Motion, in_lanes::InLanes, real::Real, slot::Keep};

impl<H: Recurrences> InLanes<H> for Taylor {
    fn group_moves<L: Real, K: Keep, const REGISTERS: usize>() -> GroupMoves<Of<H, L, K>> {
        GroupMoves {
            lanes: L::LANES,
            // No two of them would stay in registers.
            together: 1,
            advance: |expansions, clock, steps| {
                for expansion in expansions {
                    follow::<H, L, K>(expansion, clock, Moment::of(clock.steps + steps, clock.h));
                }
            },
            complete: |_, _| {},
            show: None,
            finite: |expansions| expansions.iter().all(Motion::finite),
        }
    }
}
