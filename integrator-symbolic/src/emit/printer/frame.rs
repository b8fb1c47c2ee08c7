//! The storage from which a generated function reads coordinates and prepared constants.

use super::{
    expression::{Dialect, Printer},
    fields::Fields,
    interleaved::InterleavedIndices,
};
use crate::{
    graph::{
        Graph, Node, NodeId,
        index::{Index, IndexId, LoopId, LoopSet},
    },
    model::{Model, is_leaf},
    stencil::Stencil,
    syntax::names::Names,
};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};
use std::collections::HashMap;

/// The storage that a function reads.
pub(crate) enum Frame<'m> {
    /// In the user's own fields, as `f64`: where constants are prepared.
    System,
    /// In prepared constants that are an argument, as `f64`, and nowhere else.
    Constants,
    /// In the motion.
    Motion,
    /// In a motion with a fictitious time, where the state determines the length of a step.
    OwnTime,
    /// In what a flow reads of a motion, apart from what it moves.
    Apart,
    /// In the neighbourhood of sites of a lattice, which is an argument.
    Sites(&'m Stencil),
    /// In its arguments: the coordinates and constants of bodies, and the constants that all bodies contribution.
    Bodies(Bodies),
    /// In tables of Taylor coefficients that are its arguments, whose rows may be interleaved.
    Series { interleaved: Option<InterleavedIndices> },
    /// In rows of coordinates that are its arguments.
    Edges,
}

/// Bodies that are arguments of a function.
pub(crate) struct Bodies {
    /// What is after `q` and `p` in the names of a body's coordinates, by the loop whose index it has.
    pub(crate) suffixes: Vec<(LoopId, String)>,
    /// The names of their prepared constants.
    pub(crate) constants: HashMap<NodeId, Ident>,
}

impl Frame<'_> {
    /// The type that it computes in.
    pub(crate) fn scalar<'n>(&self, names: &'n Names) -> &'n Ident {
        match self {
            Frame::Constants => &names.double,
            Frame::System | Frame::Motion | Frame::OwnTime | Frame::Apart | Frame::Series { .. } | Frame::Edges => {
                &names.scalar
            }
            Frame::Sites(_) | Frame::Bodies(_) => &names.wide,
        }
    }

    /// Whether the storage is that of a motion.
    pub(super) fn is_of_motion(&self) -> bool {
        matches!(self, Frame::Motion | Frame::OwnTime | Frame::Apart)
    }

    /// Whether a step is as long for all states.
    pub(super) fn has_fixed_step(&self) -> bool {
        !matches!(self, Frame::OwnTime)
    }

    /// What adds a multiple of the step to a slot.
    pub(crate) fn step_update(&self) -> TokenStream {
        if self.has_fixed_step() { quote!(scale_add) } else { quote!(fma) }
    }

    /// The storage of what a flow moves.
    pub(crate) fn moved(&self) -> TokenStream {
        if matches!(self, Frame::Apart) { quote!(moved) } else { quote!(motion) }
    }

    /// The dialect of its code.
    pub(super) fn dialect(&self) -> Dialect {
        if matches!(self, Frame::System) { Dialect::Single } else { Dialect::Generic }
    }

    /// Whether a node is read rather than computed.
    pub(super) fn is_leaf(&self, model: &Model, id: NodeId) -> bool {
        match (self, model.graph.node(id)) {
            (Frame::System, node) => matches!(node, Node::Constant(_) | Node::FromIndex(_) | Node::Parameter(_)),
            (Frame::Bodies(_), Node::Coordinate(_)) => true,
            _ => is_leaf(&model.graph, &model.parameters, id),
        }
    }

    /// Whether an integer of these loops' indices is read as a prepared number.
    pub(crate) fn has_prepared_index(&self, loops: LoopSet) -> bool {
        match self {
            Frame::System
            | Frame::Constants
            | Frame::Motion
            | Frame::OwnTime
            | Frame::Apart
            | Frame::Series { .. }
            | Frame::Edges => false,
            Frame::Sites(_) => !loops.is_empty(),
            Frame::Bodies(_) => true,
        }
    }
}

impl Bodies {
    /// The name of the coordinates of the body with this index.
    pub(crate) fn of_index(&self, graph: &Graph, letter: Ident, index: IndexId) -> Ident {
        let suffix = self.suffixes.iter().find(|(by, _)| graph.loops.index(index) == Index::Running(*by));
        suffix.map_or(letter.clone(), |(_, suffix)| format_ident!("{letter}{suffix}"))
    }
}

impl Printer<'_> {
    /// A prepared constant, or its element for the present iterations of its loops.
    pub(crate) fn field(&self, fields: &mut Fields, id: NodeId) -> TokenStream {
        if let Frame::Bodies(bodies) = self.frame
            && let Some(name) = bodies.constants.get(&id)
        {
            return name.to_token_stream();
        }
        let name = fields.number(self.graph, self.parameters, id);
        self.shared(name, self.graph.loops_of(id))
    }

    /// A field of the prepared constants as a number of the flow, for the present iterations of the loops.
    pub(crate) fn shared(&self, name: Ident, loops: LoopSet) -> TokenStream {
        match self.frame {
            Frame::System
            | Frame::Constants
            | Frame::Motion
            | Frame::OwnTime
            | Frame::Apart
            | Frame::Series { .. }
            | Frame::Edges => self.prepared(name, loops),
            Frame::Sites(lattice) => self.spread(lattice, name, loops),
            Frame::Bodies(_) => {
                let (scalar, field) = (self.scalar, self.prepared(name, loops));
                quote!(#scalar::splat(#field))
            }
        }
    }

    /// A field of the prepared constants as it is, for the present iterations of the loops.
    pub(crate) fn prepared(&self, name: Ident, loops: LoopSet) -> TokenStream {
        let at = loops.iter().map(|by| {
            let index = self.running.get(&by);
            quote!([#index])
        });
        match self.frame {
            Frame::System | Frame::Motion | Frame::OwnTime | Frame::Apart => quote!(motion.parameters.#name #(#at)*),
            Frame::Constants | Frame::Sites(_) | Frame::Bodies(_) | Frame::Series { .. } | Frame::Edges => {
                quote!(parameters.#name #(#at)*)
            }
        }
    }
}
