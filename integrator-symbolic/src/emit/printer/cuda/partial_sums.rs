//! Sums of loops that the processor has in lanes: the device adds them in the same order.
//!
//! In: the lines of a loop. Out: the lines around it that declare partial sums, name the one of an iteration, and add them.
//! Always true: the order is that of `integrator-core/src/layout/loops.rs`.

use super::Cuda;
use crate::{
    graph::NodeId,
    layout::loops_in_lanes,
    model::Model,
    program::{Item, Program},
};
use std::collections::BTreeSet;
use std::fmt::Write;

/// The lines around a loop for its partial sums.
#[derive(Default)]
pub(super) struct PartialSums {
    /// Before the loop.
    pub(super) begin: String,
    /// First in an iteration.
    pub(super) open: String,
    /// After the loop.
    pub(super) end: String,
}

/// The sums of a program that the processor adds in lanes.
pub(super) fn partial_sums(model: &Model, program: &Program) -> BTreeSet<NodeId> {
    loops_in_lanes(model, program, |lanes| lanes.sums.clone()).into_iter().flatten().collect()
}

impl Cuda<'_, '_> {
    /// The lines around a loop from one index to another, whose own index has a name.
    pub(super) fn partial_sums_of(&self, body: &[Item], index: &str, [from, to]: [&str; 2]) -> PartialSums {
        let sum = |item: &Item| match item {
            Item::Add { sum, .. } if self.partial.contains(sum) => Some(*sum),
            _ => None,
        };
        let sums: BTreeSet<NodeId> = body.iter().filter_map(sum).collect();
        let mut lines = PartialSums::default();
        for name in sums.into_iter().map(|sum| self.name(sum)) {
            let _ = writeln!(lines.begin, "PartialSums<R> partial_{name}({from}, {to});");
            let _ = writeln!(lines.open, "R& {name} = partial_{name}.at({index});");
            let _ = writeln!(lines.end, "R {name} = partial_{name}.total();");
        }
        lines
    }
}
