//! The values that sites of a line read from their neighbourhood, and the contributions that they pass on.

use super::Cuda;
use crate::{
    graph::{
        Element, NodeId, Part,
        index::{Index, LoopSet},
    },
    stencil::{Extent, Stencil},
};

impl Cuda<'_, '_> {
    /// A coordinate of a neighbour; beyond an open end a zero, which no site makes use of.
    pub(super) fn neighbour(&mut self, stencil: &Stencil, element: Element) -> String {
        let far = |index| self.printer.graph.loops.literal(index).unwrap_or_default();
        let far = match self.printer.graph.loops.index(element.index) {
            Index::Add(_, by) => far(by) as i64,
            Index::Sub(_, by) => -(far(by) as i64),
            _ => 0,
        };
        let (site, length) = (self.site(stencil), self.length as i64);
        let half = if element.part == Part::Position { "q" } else { "p" };
        let is_periodic = stencil.directions.iter().any(|direction| direction.periodic);
        match far {
            0 => format!("motion.{half}[{site}].value()"),
            _ if is_periodic => format!("motion.{half}[({site} + {}) % {length}].value()", far.rem_euclid(length)),
            1.. => format!("({site} + {far} < {length} ? motion.{half}[{site} + {far}].value() : R(0.0))"),
            _ => format!("({site} < {} ? R(0.0) : motion.{half}[{site} - {}].value())", -far, -far),
        }
    }

    /// The present site.
    fn site(&self, stencil: &Stencil) -> String {
        stencil.directions.first().map(|direction| self.running(direction.place)).unwrap_or_default()
    }

    /// The index of a table over the loops that ran over the sites; nothing of what is the same at all of them.
    pub(super) fn of_sites(&self, stencil: &Stencil, loops: LoopSet) -> Option<String> {
        let begins = loops.iter().find_map(|by| stencil.directions.first()?.begins.get(&by))?;
        let (site, length) = (self.site(stencil), self.length as i64);
        Some(match (-begins).rem_euclid(length.max(1)) {
            0 => site,
            ahead => format!("({site} + {ahead}) % {length}"),
        })
    }

    /// The line that notes a contribution.
    pub(super) fn contribution(&mut self, number: usize, value: NodeId) -> String {
        let Some(stencil) = self.stencil else { return String::new() };
        let (of, value, site) = (&stencil.contributions[number], self.expression(value).1, self.site(stencil));
        let onward = of.onward();
        let begun = stencil.contributions[..number].iter().any(|before| before.onward() == onward);
        let name = format!("contribution[{}]", onward.iter().sum::<usize>());
        let within = of.along.first().map_or(Extent::All, |along| along.places);
        let mut inside = |from, to| {
            let (from, to) = (self.index(from), self.index(to));
            format!("{from} <= {site} && {site} < {to}")
        };
        match within {
            Extent::Few(from, to) => {
                let inside = inside(from, to);
                format!("if ({inside}) {name} = {name} + ({value});\n")
            }
            Extent::Most(from, to) => {
                let inside = inside(from, to);
                let value = format!("({inside} ? {value} : R(0.0))");
                if begun { format!("{name} = {name} + {value};\n") } else { format!("{name} = {value};\n") }
            }
            Extent::All if begun => format!("{name} = {name} + ({value});\n"),
            Extent::All => format!("{name} = {value};\n"),
        }
    }
}
