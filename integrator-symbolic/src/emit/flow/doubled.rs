//! The flows of two coupled copies of the state: the derivatives of `H` at one copy move the other one.

use super::{Flow, Flows};
use crate::{
    emit::printer::{block::Emitter, frame::Frame, function::Body},
    graph::NodeId,
};
use quote::quote;

impl Flows {
    /// Those of `H(q, y)`, `H(x, p)` and the coupling.
    pub(crate) fn of_copies(emitter: &mut Emitter<'_>, coupling: NodeId) -> Self {
        let leaf = &emitter.names.leaf;
        let [drift, middle] = [quote!(first), quote!(second)].map(|copy| Flow {
            body: Body::new(quote! {
                let (read, moved) = motion.#copy();
                Self::along_field::<_, #leaf>(read, moved, duration, 0.0);
            }),
            ..Flow::default()
        });
        let coupling = emitter.value(&Frame::Motion, coupling).tokens;
        let kick = Body::new(quote!(let coupling = #coupling; motion.rotate(coupling, duration);));
        let kick = Flow { body: kick, ..Flow::default() };
        Self {
            drift,
            middle: vec![middle],
            kick,
            many_body: None,
            in_jacobi: false,
            copies: true,
            energies: Vec::new(),
            nests: Vec::new(),
        }
    }
}
