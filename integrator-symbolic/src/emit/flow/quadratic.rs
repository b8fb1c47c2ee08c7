//! The flow of a part that is a quadratic form in positions and momenta. The runtime computes its matrices from the
//! second derivatives that are generated here, and from the first derivatives at zero.

use super::Flow;
use crate::{
    differentiate::{Contribution, gradient},
    emit::printer::{block::Emitter, expression::Printer, frame::Frame, function::Body},
    graph::{NodeId, Part, Scope},
    model::Model,
    pattern::stores::lower_roots,
    program::{Program, Sink, Store},
    syntax::names::Names,
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The derivatives of a part, which its matrices are made from.
pub(crate) struct Derivatives {
    /// The number of the part.
    part: Literal,
    /// How many components a point has, if coordinates are points.
    components: Option<TokenStream>,
    lines: Body,
}

impl Derivatives {
    /// What prepared constants implement of the runtime.
    pub(super) fn implementation(&self, constants: &TokenStream, names: &Names) -> TokenStream {
        let (Self { part, components, lines }, Names { runtime, .. }) = (self, names);
        let components = components.as_ref().map(|components| {
            let body = Body::new(quote!(#components));
            let (parameters, body) = (body.argument("parameters"), &body.0);
            quote!(fn components(#parameters: &Self) -> usize { #body })
        });
        let (parameters, length, form) =
            (lines.argument("parameters"), lines.argument("length"), lines.argument("form"));
        let lifted = lines.mentions("of").then(|| quote!(use #runtime::Real as _;));
        let lines = &lines.0;
        quote! {
            impl #runtime::QuadraticPart<#part> for #constants {
                #components
                fn derivatives(#parameters: &Self, #length: usize, #form: &mut #runtime::Form) {
                    #lifted
                    #lines
                }
            }
        }
    }
}

/// The most coupled coordinates whose matrix is held in registers.
const IN_REGISTERS: u64 = 2;

/// The flow of the part with this number.
pub(super) fn flow(emitter: &mut Emitter<'_>, number: usize, energy: NodeId) -> Flow {
    let stores = derivatives(emitter.model, energy);
    // Whether no degree of freedom couples to another one, whatever the parameters are, and nothing is linear.
    let is_lone = stores.iter().all(|store| match store.sink {
        Sink::SecondDerivative(a, b) => (a.index, a.component) == (b.index, b.component),
        _ => false,
    });
    let lines = Body::new(emitter.evaluate(&Frame::Constants, &[], &stores).tokens);
    let (names, part) = (emitter.names, Literal::usize_unsuffixed(number));
    let (Emitter { model, fields, .. }, Names { runtime, scalar, leaf, .. }) = (emitter, names);
    let program = Program::default();
    let printer = Printer::new(model, names, &program, &Frame::Constants);
    let components = model.lengths.get(1).map(|components| printer.index(fields, *components));
    Flow {
        body: Body::new(quote! {
            solver.flow::<#runtime::Shaped<Self, #leaf>>(duration, &mut motion.q, &mut motion.p);
        }),
        solver: Some(quote!(#runtime::Quadratic<#scalar, #part, #is_lone>)),
        is_large: !is_lone && model.shape.numbers().is_none_or(|coordinates| coordinates > IN_REGISTERS),
        derivatives: Some(Derivatives { part, components, lines }),
        ..Flow::default()
    }
}

/// The second derivatives of a quadratic form, and the first ones where all coordinates are zero. Those by a position
/// and a momentum come once.
fn derivatives(model: &mut Model, energy: NodeId) -> Vec<Store> {
    let mut stores = Vec::new();
    let others: [(Part, &[Part]); 2] =
        [(Part::Position, &[Part::Position, Part::Momentum]), (Part::Momentum, &[Part::Momentum])];
    for (part, others) in others {
        for Contribution { context, element, value } in gradient(&mut model.graph, energy, part) {
            for other in others {
                stores.extend(gradient(&mut model.graph, value, *other).into_iter().map(|second| Store {
                    context: context.iter().chain(&second.context).copied().collect(),
                    sink: Sink::SecondDerivative(element, second.element),
                    value: second.value,
                }));
            }
            let first = model.graph.at_origin(value);
            stores.extend(first.map(|value| Store { context, sink: Sink::FirstDerivative(element), value }));
        }
    }
    let conditions = stores.iter().flat_map(|store| store.context.iter().filter_map(Scope::condition));
    let roots: Vec<NodeId> = stores.iter().map(|store| store.value).chain(conditions).collect();
    let lowered = lower_roots(model, &roots);
    let of = |id: NodeId| roots.iter().position(|root| *root == id).map_or(id, |position| lowered[position]);
    for store in &mut stores {
        store.value = of(store.value);
        for around in &mut store.context {
            if let Scope::Branch(condition, _) = around {
                *condition = of(*condition);
            }
        }
    }
    stores
}
