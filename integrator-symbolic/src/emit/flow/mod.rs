//! Rust code for flows and energies.

pub(super) mod bodies;
pub(super) mod constants;
pub(super) mod device;
pub(super) mod doubled;
pub(super) mod field;
pub(super) mod force_gradient;
pub(super) mod friction;
#[cfg(test)]
mod guarded;
pub(super) mod invariants;
pub(crate) mod jacobi;
pub(super) mod kepler;
pub(super) mod lattice;
pub(super) mod nested;
pub(super) mod pairs;
pub(super) mod parameter_slopes;
pub(super) mod part_of_pairs;
pub(super) mod pieces;
pub(super) mod quadratic;
pub(super) mod rated_field;
pub(super) mod shifted;
pub(super) mod transformed;
pub(super) mod user_energies;

use crate::{
    differentiate::{Contribution, gradient},
    emit::printer::{
        block::Emitter,
        frame::Frame,
        function::{Body, Lines},
    },
    graph::{Graph, NodeId, Part, exact::Exact},
    layout::{Form, form_of_loops},
    model::{ExactPart, Length, Shape},
    pattern::{
        Pattern,
        all_pairs::LISTED_FROM,
        stencil_of_energy,
        stores::{Pass, lower_roots, passes},
    },
    program::{Item, Store},
    stencil::Stencil,
    syntax::names::Names,
};
use lattice::Sweep;
use nested::NestedFlows;
use pairs::ManyBody;
use part_of_pairs::PartOfPairs;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quadratic::Derivatives;
use quote::quote;

/// The flows of the parts of H.
pub(crate) struct Flows {
    /// That of `T`, or of the first part.
    drift: Flow,
    /// Those of the parts between the first and the last.
    middle: Vec<Flow>,
    /// That of `V`, or of the last part.
    kick: Flow,
    /// What they consist of, where bodies act on each other in pairs.
    many_body: Option<ManyBody>,
    /// Whether these move in Jacobi coordinates.
    in_jacobi: bool,
    /// Whether they move two copies of the state.
    copies: bool,
    /// The energies that the sites of a lattice compute.
    energies: Vec<Sweep>,
    /// The last of them that take inner steps, the outermost first.
    nests: Vec<NestedFlows>,
}

impl Flows {
    /// Those along the gradients of `T` and of `V`.
    pub(crate) fn of(
        emitter: &mut Emitter<'_>,
        kinetic: &[Contribution],
        potential: &[Contribution],
        pattern: &Pattern,
    ) -> Self {
        let (many_body, [mut drift, mut kick]) = match pattern {
            Pattern::AllPairs(pairs) => {
                let many_body = ManyBody::of(emitter, pairs);
                let [drift, kick] = Form::of_bodies(many_body.listed(), many_body.is_row(), many_body.has_triplets());
                let flow = |part, form| Flow { body: ManyBody::flow(part), form, ..Flow::default() };
                (Some(many_body), [flow(Part::Momentum, drift), flow(Part::Position, kick)])
            }
            Pattern::Sites([velocity, force]) => {
                let drift = Flow::of(emitter, kinetic, Part::Momentum, velocity.as_ref());
                (None, [drift, Flow::of(emitter, potential, Part::Position, force.as_ref())])
            }
        };
        let in_jacobi = emitter.model.jacobi().is_some();
        if in_jacobi {
            (drift.body, kick.body) = (jacobi::drift(), jacobi::kick(&kick.body.0));
        }
        Self {
            drift,
            middle: Vec::new(),
            kick,
            many_body,
            in_jacobi,
            copies: false,
            energies: Vec::new(),
            nests: Vec::new(),
        }
    }

    /// None, where H stays in one piece.
    pub(crate) fn none() -> Self {
        let none = Flow::default;
        Self {
            drift: none(),
            middle: Vec::new(),
            kick: none(),
            many_body: None,
            in_jacobi: false,
            copies: false,
            energies: Vec::new(),
            nests: Vec::new(),
        }
    }

    /// Those of the parts that are named, in their order.
    pub(crate) fn of_parts(emitter: &mut Emitter<'_>) -> Self {
        let mut flows: Vec<_> = (0..emitter.model.parts.len()).map(|part| Flow::of_part(emitter, part)).collect();
        let solving: Vec<_> = flows.iter_mut().filter(|flow| flow.solver.is_some()).collect();
        let last = solving.len().saturating_sub(1);
        for (number, flow) in solving.into_iter().enumerate() {
            // Of pairs `(first, (second, third))`.
            let path = (0..number).map(|_| quote!(.1)).chain((number < last).then(|| quote!(.0)));
            let (path, body) = (quote!(motion.solvers #(#path)*), &flow.body.0);
            flow.body = Body::new(quote!(let solver = &mut #path; #body));
            if let Some(pairs) = &mut flow.pairs {
                pairs.solver = path;
            }
        }
        let kick = flows.pop().unwrap_or_default();
        let middle = flows.split_off(flows.len().min(1));
        let nests = NestedFlows::of(emitter);
        Self {
            drift: flows.pop().unwrap_or_default(),
            middle,
            kick,
            many_body: None,
            in_jacobi: false,
            copies: false,
            energies: Vec::new(),
            nests,
        }
    }

    /// All of them, in the order of the parts.
    fn all(&self) -> impl Iterator<Item = &Flow> {
        [&self.drift].into_iter().chain(&self.middle).chain([&self.kick])
    }

    /// Whether bodies act on each other in pairs.
    pub(crate) fn are_of_bodies(&self) -> bool {
        self.many_body.is_some()
    }

    /// The layout of the motion.
    pub(crate) fn motion(&self, parameters: &TokenStream, names: &Names) -> TokenStream {
        let Names { runtime, scalar, leaf, .. } = names;
        match &self.many_body {
            Some(many_body) if self.in_jacobi => {
                jacobi::motion(&many_body.motion(parameters, names), many_body.dimension(), names)
            }
            Some(many_body) => many_body.motion(parameters, names),
            None if self.copies => quote!(#runtime::Doubled<#scalar, #runtime::Shaped<Self, #leaf>, #parameters>),
            None => match self.solvers() {
                None => quote!(#runtime::Plain<#scalar, #runtime::Shaped<Self, #leaf>, #parameters>),
                Some(solvers) => {
                    quote!(#runtime::Solving<#scalar, #runtime::Shaped<Self, #leaf>, #parameters, #solvers>)
                }
            },
        }
    }

    /// The type of what flows keep beside the state: that of one, or pairs `(first, (second, third))`.
    fn solvers(&self) -> Option<TokenStream> {
        let solvers: Vec<_> = self.all().filter_map(|flow| flow.solver.clone()).collect();
        solvers.into_iter().rev().reduce(|others, first| quote!((#first, #others)))
    }

    /// The items for the runtime about their form: constants, and the functions that move a lattice segment by
    /// segment.
    pub(crate) fn layout(&self, names: &Names) -> (TokenStream, Option<TokenStream>) {
        let Self { drift, kick, many_body, .. } = self;
        let is_wide = self.all().any(|flow| flow.is_wide);
        let wide = (kick.sweep.is_some() || many_body.is_some() || is_wide).then(|| {
            quote!(
                const WIDE: bool = true;
            )
        });
        let is_large = self.in_jacobi || self.all().any(|flow| flow.is_large);
        let large = is_large.then(|| {
            quote!(
                const LARGE_FLOWS: bool = true;
            )
        });
        let lattice = |flow: &Flow| flow.sweep.as_ref().map(Sweep::lattice);
        let alike = lattice(drift).filter(|of_drift| lattice(kick) == Some(*of_drift));
        let (radii, sites) = alike.map(|alike| lattice::parts(alike, names)).unzip();
        let forms = || self.all().map(|flow| flow.form);
        let layout = forms().any(|form| form != Form::Plain).then(|| {
            let words = forms().map(Form::name);
            quote!(
                const LAYOUT: &'static [&'static str] = &[#(#words),*];
            )
        });
        let columns = [kick, drift].into_iter().find_map(|flow| flow.sweep.as_ref()?.columns());
        (quote!(#wide #large #radii #columns #layout), sites)
    }

    /// The function that compares the number of bodies that act with the least number whose neighbours are listed.
    pub(crate) fn is_listed(&self, count: Option<&TokenStream>) -> Option<TokenStream> {
        let of_parts = self.all().filter_map(|flow| flow.pairs.as_ref()).map(PartOfPairs::many_body);
        self.many_body.iter().chain(of_parts).find_map(ManyBody::listed)?;
        let (count, from) = (count.cloned().unwrap_or_else(|| quote!(length)), Literal::u64_unsuffixed(LISTED_FROM));
        Some(quote! {
            fn is_listed(&self, length: usize) -> bool {
                #count >= #from
            }
        })
    }

    /// The functions `drift` and `kick`, and `middle` where there are more parts.
    pub(crate) fn functions(&self, names: &Names) -> TokenStream {
        if !self.nests.is_empty() {
            return self.functions_of_nests(names);
        }
        let [drift, kick] =
            [("drift", &self.drift), ("kick", &self.kick)].map(|(name, flow)| flow.body.flow(name, names));
        let middle = Self::middle_function("middle", &self.middle.iter().collect::<Vec<_>>(), names);
        quote!(#drift #middle #kick)
    }

    /// The function of this name of flows between the first and the last, in their order or backwards.
    fn middle_function(name: &str, flows: &[&Flow], names: &Names) -> Option<TokenStream> {
        let Names { runtime, scalar, leaf, .. } = names;
        let flows: Vec<_> = flows.iter().map(|flow| &flow.body.0).collect();
        let body = match &flows[..] {
            [] => return None,
            [alone] => quote!(#alone),
            flows => {
                let backwards = flows.iter().rev();
                quote! {
                    if backwards {
                        #({ #backwards })*
                    } else {
                        #({ #flows })*
                    }
                }
            }
        };
        let body = Body::new(body);
        let [motion, duration, backwards] = ["motion", "duration", "backwards"].map(|name| body.argument(name));
        let time = body.argument("time");
        let (name, body) = (Ident::new(name, Span::call_site()), &body.0);
        Some(quote! {
            #[inline(always)]
            fn #name<#scalar: #runtime::Real, #leaf: #runtime::Precision>(#motion: &mut Self::Motion<#scalar, #leaf>, #duration: f64, #time: f64, #backwards: bool) { #body }
        })
    }

    /// The function that returns an energy; `true` if terms are in lanes.
    pub(crate) fn energy(
        &mut self,
        emitter: &mut Emitter<'_>,
        name: &str,
        energy: NodeId,
        of_parts: &[NodeId],
    ) -> (TokenStream, bool) {
        if let Some(energy) = self.energy_of_parts(emitter, name, of_parts) {
            return (energy, true);
        }
        if let Some((true, beside)) = self.many_body.as_ref().map(|bodies| bodies.energy(name)) {
            return (Self::energy_of_bodies(emitter, name, beside), true);
        }
        let of_flow = self.kick.sweep.as_ref().map(Sweep::stencil);
        let sites = of_flow.and_then(|of_flow| stencil_of_energy(emitter.model, energy, of_flow));
        let energy = lower_roots(emitter.model, &[energy])[0];
        if let Some(sites) = sites {
            let (sweep, names) = (lattice::energy(emitter, &sites, name), emitter.names);
            let lines = sweep.energy_or(name, || emitter.value_in_lanes(energy).0.tokens, names);
            self.energies.push(sweep);
            return (Body::new(lines).energy(name, names), true);
        }
        let ((lines, has_lanes), names) = (emitter.value_in_lanes(energy), emitter.names);
        let around = |energy| match self.in_jacobi {
            true => jacobi::energy(name, &energy),
            false => self.plain(&energy),
        };
        // The time is still a number here.
        (lines.map(around).body(&names.scalar).energy(name, names), has_lanes)
    }

    /// The function that returns an energy of bodies, which the runtime sums, and others beside them.
    fn energy_of_bodies(emitter: &mut Emitter<'_>, name: &str, beside: Option<NodeId>) -> TokenStream {
        let beside = beside.filter(|beside| emitter.model.graph.as_constant(*beside) != Some(0.0));
        let beside = beside.map(|beside| {
            let beside = lower_roots(emitter.model, &[beside])[0];
            let lines = emitter.value(&Frame::Motion, beside);
            let body = Body::new(lines.tokens.clone());
            let reads_state = ["q", "p"].into_iter().any(|half| body.mentions(half));
            let plain = reads_state.then(|| quote!(let motion = &motion.plain::<Self::Coords>();));
            let Body(beside) = lines.map(|beside| quote!(#plain #beside)).body(&emitter.names.scalar);
            quote!(+ { #beside })
        });
        let function = Ident::new(name, Span::call_site());
        Body::new(quote!(motion.#function::<Self>(time) #beside)).energy(name, emitter.names)
    }

    /// Lines about a motion in the user's own shape: bodies in lanes are unpacked for results that are rarely needed.
    fn plain(&self, lines: &TokenStream) -> TokenStream {
        match &self.many_body {
            Some(_) => quote!(let motion = &motion.plain::<Self::Coords>(); #lines),
            None => lines.clone(),
        }
    }

    /// The lines that end in the value of a function of positions and momenta.
    fn value(&self, emitter: &mut Emitter<'_>, value: NodeId) -> TokenStream {
        let value = lower_roots(emitter.model, &[value])[0];
        let Lines { tokens, .. } = emitter.value(&Frame::Motion, value);
        if self.in_jacobi { jacobi::in_own_coordinates(&tokens) } else { self.plain(&tokens) }
    }

    /// What bodies in pairs implement of the runtime, on themselves and on their prepared constants.
    pub(crate) fn of_bodies(
        &self,
        implementation: impl Fn(TokenStream, &TokenStream) -> TokenStream,
        parameters: &TokenStream,
        names: &Names,
    ) -> Option<TokenStream> {
        Some(self.many_body.as_ref()?.implementations(implementation, parameters, names))
    }

    /// What prepared constants implement of the runtime for parts that are quadratic forms.
    pub(crate) fn of_quadratic_forms(&self, constants: &TokenStream, names: &Names) -> TokenStream {
        let derivatives = self.all().filter_map(|flow| flow.derivatives.as_ref());
        derivatives.map(|derivatives| derivatives.implementation(constants, names)).collect()
    }

    /// What a lattice implements of the runtime.
    pub(crate) fn of_lattice(
        &self,
        implementation: impl Fn(TokenStream, &TokenStream) -> TokenStream,
        names: &Names,
    ) -> TokenStream {
        let sweeps = [&self.drift, &self.kick].into_iter().filter_map(|flow| flow.sweep.as_ref()).chain(&self.energies);
        sweeps.map(|sweep| sweep.implementation(&implementation, names)).collect()
    }
}

/// A flow: the body of its function, and how it goes about its coordinates.
#[derive(Default)]
pub(crate) struct Flow {
    body: Body,
    /// Where all sites of a lattice take part alike, what the runtime sweeps along them.
    sweep: Option<Sweep>,
    form: Form,
    /// Whether it gains from vectors of 512 bits: it divides by a root cubed, or computes terms of lists or functions in lanes.
    is_wide: bool,
    /// Whether it takes so long that a choice among flows costs nothing beside it.
    is_large: bool,
    /// The type of what it keeps beside the state, if its equations have to be solved.
    solver: Option<TokenStream>,
    /// What its matrices are made from, if it has some.
    derivatives: Option<Derivatives>,
    /// What it consists of, if it is that of a part of H in which many bodies act on each other in pairs.
    pairs: Option<PartOfPairs>,
}

impl Flow {
    /// The exact flow of a part of H.
    fn of_part(emitter: &mut Emitter<'_>, number: usize) -> Self {
        let ExactPart { energy, ref form, ref own, .. } = emitter.model.parts[number];
        match form {
            Exact::Own => Self::own(emitter, number, own.clone()),
            Exact::OfMomenta => Self::by(emitter, energy, Part::Momentum),
            Exact::OfPositions => match part_of_pairs::flow(emitter, number) {
                Some(flow) => flow,
                None => Self::by(emitter, energy, Part::Position),
            },
            Exact::Quadratic(form) => quadratic::flow(emitter, number, *form),
            Exact::Shifted(shifted) => {
                let shifted = shifted.clone();
                shifted::flow(emitter, &shifted)
            }
            Exact::Kepler(orbits) => {
                let orbits = orbits.clone();
                kepler::flow(emitter, &orbits)
            }
            Exact::Shear => {
                let motion = sheared(&mut emitter.model.graph, energy);
                Self::along(emitter, &motion, Part::Momentum, &Frame::Motion)
            }
        }
    }

    /// The flow that the user wrote.
    fn own(emitter: &mut Emitter<'_>, part: usize, method: Option<Ident>) -> Self {
        let Names { runtime, leaf, .. } = emitter.names;
        let body = method.map(|method| {
            let field = emitter.fields.own_flow(part, &method);
            quote! {
                #runtime::own_flow::<_, #runtime::Shaped<Self, #leaf>>(
                    &mut motion.q,
                    &mut motion.p,
                    &motion.parameters.#field,
                    duration,
                );
            }
        });
        Self { body: Body::new(body.unwrap_or_default()), ..Self::default() }
    }

    /// The motion of the conjugates of what an energy reads of a part, where it stays.
    fn by(emitter: &mut Emitter<'_>, energy: NodeId, part: Part) -> Self {
        let gradient = gradient(&mut emitter.model.graph, energy, part);
        Self::along(emitter, &gradient, part, &Frame::Motion)
    }

    /// That of sites which take part alike, or else each component of the gradient moves its coordinate.
    fn of(emitter: &mut Emitter<'_>, gradient: &[Contribution], part: Part, stencil: Option<&Stencil>) -> Self {
        match stencil {
            Some(stencil) => {
                let sweep = lattice::sweep(emitter, stencil, part);
                let form = sweep.lattice().into();
                let body = sweep.flow_or(|| Self::along(emitter, gradient, part, &Frame::Motion).body.0);
                Self { body: Body::new(body), sweep: Some(sweep), form, ..Self::default() }
            }
            None if gradient.is_empty() => Self::default(),
            None => Self::along(emitter, gradient, part, &Frame::Motion),
        }
    }

    /// Each component of the gradient moves its coordinate: on the spot where every coordinate gets one contribution;
    /// else contributions are collected first.
    fn along(emitter: &mut Emitter<'_>, gradient: &[Contribution], part: Part, frame: &Frame<'_>) -> Self {
        let lines = Self::lines_along(emitter, gradient, part, frame);
        let duration = match part {
            Part::Momentum => quote!(duration),
            Part::Position => quote!(-duration),
        };
        let (form, has_wide_lanes) = form_of_loops(emitter.model, &lines.program);
        let is_wide = lines.program.divides_by_root_cubed || has_wide_lanes;
        let scalar = &emitter.names.scalar;
        let body = lines.map(|lines| quote!(let step = #scalar::of(#duration); #lines)).body(scalar);
        Self { body, form, is_wide, is_large: form != Form::Plain, ..Self::default() }
    }

    /// The lines that move each coordinate by `step` times its component.
    fn lines_along(emitter: &mut Emitter<'_>, gradient: &[Contribution], part: Part, frame: &Frame<'_>) -> Lines {
        let passes = passes(emitter.model, gradient, part).into_iter().map(|Pass { stores, moved }| match moved {
            None => in_place(emitter, frame, &stores),
            Some(moved) => {
                let method = frame.step_update();
                let apply = |place, value| quote!(#place.#method(step, #value););
                through_buffer(emitter, frame, moved, &stores, apply)
            }
        });
        let both = |Lines { tokens: first, mut program }: Lines, Lines { tokens: second, program: other }: Lines| {
            program.reads_time |= other.reads_time;
            Lines { tokens: quote!({ #first } { #second }), program }
        };
        passes.reduce(both).unwrap_or_default()
    }
}

/// Lines that move coordinates on the spot, in slices of one length if that is known at run time: their loops have vectors then.
fn in_place(emitter: &mut Emitter<'_>, frame: &Frame<'_>, stores: &[Store]) -> Lines {
    let lines = emitter.evaluate(frame, &[], stores);
    let has_loops = lines.program.items.iter().any(|item| matches!(item, Item::Loop { .. }));
    if !has_loops || !matches!(emitter.model.shape.length, Length::OfStart) {
        return lines;
    }
    let runtime = &emitter.names.runtime;
    let slices = quote!(#runtime::in_place(&mut motion.q, &mut motion.p, &motion.parameters));
    lines.map(|lines| quote!({ let motion = &mut #slices; #lines }))
}

/// The motion of a shear. What it reads does not move, so that both halves are computed together.
fn sheared(graph: &mut Graph, energy: NodeId) -> Vec<Contribution> {
    let velocity = gradient(graph, energy, Part::Momentum);
    let mut motion = gradient(graph, energy, Part::Position);
    motion.iter_mut().for_each(|contribution| contribution.value = graph.neg(contribution.value));
    motion.extend(velocity);
    motion
}

/// The lines that collect a gradient in a buffer and apply it to the coordinates of `part`.
fn through_buffer(
    emitter: &mut Emitter<'_>,
    frame: &Frame<'_>,
    part: Part,
    stores: &[Store],
    apply: impl Fn(TokenStream, TokenStream) -> TokenStream,
) -> Lines {
    let (open, close) = buffer(&emitter.model.shape, frame, part, emitter.names, apply);
    emitter.evaluate(frame, &[], stores).map(|lines| quote!(#open #lines #close))
}

/// The most elements that a buffer has on the stack; a longer one, or one of a length known at run time, is on the heap.
const SMALL: u64 = 4096;

/// A buffer for the gradient, and its application to each of the coordinates of `part`.
fn buffer(
    shape: &Shape,
    frame: &Frame<'_>,
    part: Part,
    names: &Names,
    apply: impl Fn(TokenStream, TokenStream) -> TokenStream,
) -> (TokenStream, TokenStream) {
    let Names { runtime, scalar, .. } = names;
    let zero = quote!(#scalar::of(0.0));
    let coordinates = match part {
        Part::Position => quote!(q),
        Part::Momentum => quote!(p),
    };
    let element = shape.element(zero);
    let length = shape.length.tokens();
    let on_stack = match shape.length {
        Length::Literal(length) => length <= SMALL,
        Length::Constant(_) => true,
        Length::OfStart => false,
    };
    let open = if on_stack {
        quote!(let mut gradient = [#element; #length];)
    } else {
        quote!(let mut gradient = #runtime::repeated(#length, #element);)
    };
    let (moved, application) = (frame.moved(), apply(quote!((*slot)), quote!(*gradient)));
    let within = shape
        .inner
        .iter()
        .fold(application, |within, _| quote!(for (slot, gradient) in ::core::iter::zip(slot, gradient) { #within }));
    let close =
        quote!(for (slot, gradient) in ::core::iter::zip(#moved.#coordinates.iter_mut(), &gradient) { #within });
    (open, close)
}
