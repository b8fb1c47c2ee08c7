//! The flows of two coupled copies of the state, each of which moves by what H says of the other.

use super::{Flow, Flows};
use crate::{
    differentiate::{Contribution, gradient},
    emit::printer::{block::Emitter, frame::Frame, function::Body},
    graph::{NodeId, Part},
};
use quote::quote;

impl Flows {
    /// Those of `H(q, y)`, `H(x, p)` and the coupling.
    pub(crate) fn of_copies(emitter: &mut Emitter<'_>, coupling: NodeId) -> Self {
        let lines = along_both(emitter).body.0;
        let [drift, middle] = [quote!(first), quote!(second)].map(|copy| Flow {
            body: Body::new(quote!(let (motion, moved) = motion.#copy(); #lines)),
            ..Flow::default()
        });
        let coupling = emitter.value(&Frame::Motion, coupling).tokens;
        let kick = Body::new(quote!(let coupling = #coupling; motion.rotate(coupling, duration);));
        let kick = Flow { body: kick, ..Flow::default() };
        Self { drift, middle: vec![middle], kick, many_body: None, in_jacobi: false, copies: true }
    }
}

/// The motion along the field of H, of coordinates that it does not read.
fn along_both(emitter: &mut Emitter<'_>) -> Flow {
    let energy = emitter.model.kinetic;
    let graph = &mut emitter.model.graph;
    let velocity: Vec<Contribution> = gradient(graph, energy, Part::Momentum);
    let mut field = gradient(graph, energy, Part::Position);
    field.iter_mut().for_each(|contribution| contribution.value = graph.neg(contribution.value));
    field.extend(velocity);
    Flow::along(emitter, &field, Part::Momentum, &Frame::Apart)
}
