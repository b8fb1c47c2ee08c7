//! Members of an ensemble, each on polynomials of its own.

use super::{
    Recurrences, Taylor,
    expansion::{Of, advance_by},
};
use crate::{
    ensemble::{in_lanes::InLanes, interleaved::GroupMoves},
    scalar::real::Real,
    state::precision::Precision,
    system::motion::Motion,
};

impl<H: Recurrences> InLanes<H> for Taylor {
    fn group_moves<L: Real, K: Precision, const REGISTERS: usize>() -> GroupMoves<Of<H, L, K>> {
        GroupMoves {
            lanes: L::LANES,
            // No two of them would stay in registers.
            together: 1,
            advance: |expansions, clock, steps| {
                for expansion in expansions {
                    advance_by::<H, L, K>(expansion, clock, steps);
                }
            },
            complete: |_, _| {},
            show: None,
            finite: |expansions| expansions.iter().all(Motion::finite),
        }
    }
}
