//! The flow of a Kepler part: the bodies and constants for the orbits of the runtime.

use super::Flow;
use crate::{
    emit::printer::{block::Emitter, expression::Printer, frame::Frame, function::Body},
    graph::{
        NodeId,
        kepler::{Bodies, Orbits},
    },
    program::Program,
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The flow of these bodies.
pub(super) fn flow(emitter: &mut Emitter<'_>, orbits: &[Orbits]) -> Flow {
    let calls: TokenStream = orbits.iter().map(|orbits| call(emitter, orbits)).collect();
    let runtime = &emitter.names.runtime;
    Flow {
        body: Body::new(calls),
        solver: Some(quote!(#runtime::Kepler)),
        // Bodies are computed side by side.
        is_wide: orbits.iter().any(|orbits| matches!(orbits.bodies, Bodies::Each(_))),
        is_large: true,
        ..Flow::default()
    }
}

fn call(emitter: &mut Emitter<'_>, orbits: &Orbits) -> TokenStream {
    let (before, range) = range(emitter, orbits.bodies);
    let [q, p] = [quote!(q), quote!(p)].map(|half| match &range {
        Some(range) => quote!(&mut motion.#half[#range]),
        None => quote!(::core::slice::from_mut(&mut motion.#half)),
    });
    let [inverse_mass, strength] =
        [orbits.inverse_mass, orbits.strength].map(|constant| constant_of(emitter, constant, range.as_ref()));
    quote!(#before solver.flow([#q, #p], #inverse_mass, #strength, duration);)
}

/// The indices of bodies among the points of the coordinates, if these are points, after what is read before the points
/// are lent to be moved: how many there are may be among it.
fn range(emitter: &mut Emitter<'_>, bodies: Bodies) -> (TokenStream, Option<TokenStream>) {
    let Emitter { model, names, fields } = emitter;
    let program = Program::default();
    let printer = Printer::new(model, names, &program, &Frame::Motion);
    match bodies {
        Bodies::Whole => (TokenStream::new(), None),
        Bodies::One(index) => {
            let literal = model.graph.loops.literal(index).is_some();
            let index = printer.index(fields, index);
            read_before(quote!(#index..=#index), literal)
        }
        Bodies::Each(by) => {
            let range = model.graph.loops.get(by);
            if model.graph.loops.literal(range.from) == Some(0) && model.lengths.first() == Some(&range.to) {
                return (TokenStream::new(), Some(quote!(..)));
            }
            let literal = [range.from, range.to].iter().all(|bound| model.graph.loops.literal(*bound).is_some());
            let (from, to) = (printer.index(fields, range.from), printer.index(fields, range.to));
            read_before(quote!(#from..#to), literal)
        }
    }
}

/// A range that is read where it is wanted, if it is a literal, or once before.
fn read_before(range: TokenStream, literal: bool) -> (TokenStream, Option<TokenStream>) {
    match literal {
        true => (TokenStream::new(), Some(range)),
        false => (quote!(let bodies = #range;), Some(quote!(bodies.clone()))),
    }
}

/// A number of all bodies, or the part of a table that is theirs.
fn constant_of(emitter: &mut Emitter<'_>, constant: NodeId, range: Option<&TokenStream>) -> TokenStream {
    let Emitter { model, names, fields } = emitter;
    let scalar = &names.scalar;
    if let Some(number) = model.graph.as_constant(constant) {
        let number = Literal::f64_unsuffixed(number);
        return quote!(&#scalar::of(#number));
    }
    let name = fields.number(&model.graph, &model.parameters, constant);
    let is_table = !model.graph.loops_of(constant).is_empty();
    let part = range.filter(|_| is_table).map(|range| quote!([#range]));
    quote!(&motion.parameters.#name #part)
}
