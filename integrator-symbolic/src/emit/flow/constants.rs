//! The struct of prepared constants: its fields, their preparation, and how they are packed into lanes.

use super::pieces::Pieces;
use crate::{
    emit::{
        printer::{
            block::Emitter,
            expression::Printer,
            fields::{Content, Fields},
            frame::Frame,
            function::Body,
        },
        read_by_methods::ReadByMethods,
    },
    graph::{
        Graph, Node, NodeId, ParameterId,
        index::{Index, IndexId, LoopId, LoopSet},
    },
    lower::lower,
    model::{COUNT, Length, Model, Whole},
    program::Program,
    prose::{self, Formulas},
    syntax::names::Names,
};
use proc_macro2::{Group, Ident, Literal, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};

/// The prepared constants: what is written for each, field by field.
#[derive(Default)]
pub(crate) struct Constants {
    fields: TokenStream,
    gathered: TokenStream,
    /// The functions that read the fields of one member which are gathered in lanes: compiled once for all scalars.
    readers: TokenStream,
    values: TokenStream,
    /// Their derivatives by each of the parameters that are requested, and those by no parameter after these.
    slopes: Vec<TokenStream>,
    /// What two members that share lanes have in common, as conditions on `a` and `b`.
    common: Vec<TokenStream>,
    /// The search for a number that is not finite in each field of a `single`.
    not_finite: Vec<TokenStream>,
    /// The fields that are numbers, or tables of numbers.
    digested: Vec<Ident>,
    /// Whether a field is of the type that a flow computes in: integers and methods are the same for all.
    generic: bool,
    /// What is written where a flow reads the middle of its step.
    pub(crate) pieces: Pieces,
}

impl Constants {
    /// Those of the fields that lines have requested.
    pub(crate) fn of(mut emitter: Emitter<'_>) -> Self {
        let (fields, names) = (std::mem::take(&mut emitter.fields), emitter.names);
        let mut prepared =
            Self { pieces: Pieces::of(&fields, emitter.model.jacobi().is_some(), names), ..Self::default() };
        if let asked @ 1.. = emitter.model.sensitive.len() {
            prepared.slopes = vec![TokenStream::new(); asked + 1];
        }
        let scalar = &names.scalar;
        for (content, name) in fields.into_contents() {
            let table = Table::of(emitter.model, names, content);
            let (of_pairs, values) = (table_of_pairs(emitter.model, content), Values::of(emitter.model, content));
            let (kind, value) = match content {
                Content::Number(id) => match &of_pairs {
                    Some((kind, code)) => {
                        let (runtime, kind) = (&names.runtime, format_ident!("{kind}"));
                        (quote!(#runtime::#kind<#scalar>), code.clone())
                    }
                    None => {
                        let number = prepared_number(&mut emitter, id);
                        (scalar.to_token_stream(), values.named_in(number))
                    }
                },
                Content::Integer(id) => (quote!(usize), values.named_in(emitter.model.text(id))),
                Content::Flag(id) => {
                    let text = emitter.model.text(id);
                    (scalar.to_token_stream(), quote!(if #text { 1.0 } else { 0.0 }))
                }
                Content::Middle => (scalar.to_token_stream(), quote!(0.0)),
                Content::External(id) => {
                    let (method, runtime) = (&emitter.model.externals[id.0 as usize], &names.runtime);
                    let count = Literal::usize_unsuffixed(method.arguments);
                    let arguments: Vec<_> = (0..method.arguments)
                        .map(|number| format_ident!("argument_{number}").to_token_stream())
                        .collect();
                    let call = method.call(&quote!(system), &arguments);
                    let value = quote!({
                        let system = ::core::clone::Clone::clone(self);
                        #runtime::SharedTable::from([#runtime::Arc::new(move |[#(#arguments),*]: [f64; #count]| #call) as _])
                    });
                    (quote!(#runtime::External<#count>), value)
                }
                Content::InnerSteps(level) => {
                    let steps = Literal::u32_unsuffixed(emitter.model.nests[level].steps);
                    (quote!(usize), quote!(#steps))
                }
                Content::OwnFlow(part) => {
                    let runtime = &names.runtime;
                    (quote!(#runtime::OwnFlow), own_flow(emitter.model, names, part))
                }
            };
            let runtime = &names.runtime;
            let gathered = match content {
                Content::Number(_) | Content::Flag(_) | Content::Middle => {
                    let element = match &of_pairs {
                        Some((kind, _)) => {
                            let kind = format_ident!("{kind}");
                            quote!(#runtime::#kind<f64>)
                        }
                        None => quote!(f64),
                    };
                    let (single, parameters) = (table.kind(element, names), &names.parameters);
                    prepared.readers.extend(quote!(fn #name(&self) -> &#single { &self.#name }));
                    quote!(#runtime::in_lanes(members, #parameters::#name))
                }
                Content::Integer(_) | Content::InnerSteps(_) => quote!(::core::clone::Clone::clone(&members[0].#name)),
                Content::External(_) | Content::OwnFlow(_) => {
                    quote!(#runtime::table(<#scalar as #runtime::Real>::LANES, &|lane| ::core::clone::Clone::clone(&members[lane].#name[0])))
                }
            };
            let documentation = match content {
                Content::InnerSteps(_) => quote!(/** The number of inner steps. */),
                _ => prose::documentation(emitter.model, content.node()).to_token_stream(),
            };
            let kind = table.kind(kind, names);
            for (number, slopes) in prepared.slopes.iter_mut().enumerate() {
                let slope = match of_pairs.is_some() {
                    true => quote!(#value.zeros()),
                    false => table.prepared(slope(&mut emitter, content, number, &value), content, names),
                };
                slopes.extend(quote!(#name: #slope,));
            }
            let value = values.declared(values.named_in(table.prepared(value, content, names)));
            prepared.common.extend(match (content, table.levels.first()) {
                (Content::Integer(_) | Content::InnerSteps(_), _) => Some(quote!(a.#name == b.#name)),
                (_, Some(Level { literal: None, .. })) => Some(quote!(a.#name.len() == b.#name.len())),
                _ if of_pairs.is_some() => Some(quote!(a.#name.is_like(&b.#name))),
                _ => None,
            });
            if !matches!(content, Content::External(_) | Content::OwnFlow(_)) {
                prepared.digested.push(name.clone());
            }
            if let Content::Number(id) = content {
                let (formula, runtime) = (Formulas::of(emitter.model).short(id), &names.runtime);
                let formula = formula.unwrap_or_else(|| name.to_string());
                let indices = table.levels.iter().map(|level| level.index.to_string());
                prepared.not_finite.push(quote!(#runtime::not_finite(#formula, &[#(#indices),*], &single.#name)));
            }
            prepared.generic |= matches!(content, Content::Number(_) | Content::Flag(_) | Content::Middle);
            prepared.fields.extend(quote!(#documentation #name: #kind,));
            prepared.gathered.extend(quote!(#name: #gathered,));
            prepared.values.extend(quote!(#name: #value,));
        }
        prepared
    }

    /// The same with what methods of the user read that are called as they are.
    pub(crate) fn with_read(mut self, read: Option<&ReadByMethods>, names: &Names) -> Self {
        let Some(ReadByMethods { kind, value, .. }) = read else { return self };
        let name = &names.read;
        for values in self.slopes.iter_mut().chain([&mut self.values]) {
            values.extend(quote!(#name: #value,));
        }
        self.digested.push(name.clone());
        self.fields.extend(quote!(
            /// A fingerprint of what methods read that are called as they are.
            #name: #kind,
        ));
        self.gathered.extend(quote!(#name: ::core::clone::Clone::clone(&members[0].#name),));
        self
    }

    /// Their type, where flows compute in `scalar`.
    pub(crate) fn kind(&self, scalar: &TokenStream, names: &Names) -> TokenStream {
        let (parameters, generics) = (&names.parameters, self.generic.then(|| quote!(<#scalar>)));
        quote!(#parameters #generics)
    }

    /// The expression that prepares them.
    pub(crate) fn prepare(&self, names: &Names) -> TokenStream {
        let (parameters, values) = (&names.parameters, &self.values);
        if values.is_empty() { quote!(#parameters) } else { quote!(#parameters { #values }) }
    }

    /// The items for the runtime about their derivatives, if these are requested.
    pub(crate) fn sensitive(
        &self,
        parameters: &[Ident],
        count: Option<&TokenStream>,
        names: &Names,
    ) -> Option<TokenStream> {
        let (by_none, by_each) = self.slopes.split_last()?;
        let made = |values: &TokenStream| {
            let parameters = &names.parameters;
            if values.is_empty() { quote!(#parameters) } else { quote!(#parameters { #values }) }
        };
        let arms = by_each.iter().enumerate().map(|(number, slopes)| {
            let (number, slopes) = (Literal::usize_unsuffixed(number), made(slopes));
            quote!(#number => #slopes,)
        });
        let by_none = made(by_none);
        let body = with_count(quote!(match parameter { #(#arms)* _ => #by_none }), count);
        let (length, body, single) = (body.argument("length"), &body.0, self.kind(&quote!(f64), names));
        let parameters = parameters.iter().map(ToString::to_string);
        Some(quote! {
            const SENSITIVE: &'static [&'static str] = &[#(#parameters),*];
            fn parameter_slopes(&self, #length: usize, parameter: usize) -> #single { #body }
        })
    }

    /// Their struct, and what the runtime asks of it.
    pub(crate) fn declaration(&self, names: &Names) -> TokenStream {
        let Names { runtime, parameters, scalar, .. } = names;
        let Self { fields, gathered, readers, common, not_finite, digested, pieces, .. } = self;
        let [kind, single] = [quote!(#scalar), quote!(f64)].map(|scalar| self.kind(&scalar, names));
        let (fields, members, gathered) = match fields.is_empty() {
            true => (quote!(;), quote!(_members), None),
            false => (quote!({ #fields }), quote!(members), Some(quote!({ #gathered }))),
        };
        let readers = (!readers.is_empty()).then(|| quote!(impl #single { #readers }));
        let alike = (!common.is_empty()).then(|| {
            quote! {
                #[inline]
                fn alike(a: &Self::Single, b: &Self::Single) -> bool { #(#common)&&* }
            }
        });
        let not_finite = (!not_finite.is_empty()).then(|| {
            quote! {
                fn not_finite(single: &Self::Single) -> #runtime::Vec<#runtime::NotFinite> {
                    #runtime::all_found(&mut [#(#not_finite),*])
                }
            }
        });
        let digest = (!digested.is_empty()).then(|| {
            quote! {
                fn digest(single: &Self::Single, digest: &mut #runtime::Digest) {
                    #(digest.add(&single.#digested);)*
                }
            }
        });
        let set = &pieces.set;
        quote! {
            /// What depends on parameters alone, evaluated once per run.
            #[derive(::core::clone::Clone)]
            pub struct #kind #fields

            #readers

            impl<#scalar: #runtime::Real> #runtime::Prepared<#scalar> for #kind {
                type Single = #single;

                #[inline(always)]
                fn gather(#members: &[&Self::Single]) -> Self { #parameters #gathered }

                #alike
                #not_finite
                #digest
                #set
            }
        }
    }
}

/// Lines that evaluate parameters, with the number of bodies if they read it.
pub(crate) fn with_count(lines: TokenStream, count: Option<&TokenStream>) -> Body {
    let body = Body::new(lines);
    match count.filter(|_| body.mentions(COUNT)) {
        Some(count) => {
            let (name, lines) = (format_ident!("{COUNT}"), &body.0);
            Body::new(quote!(let #name = #count; #lines))
        }
        None => body,
    }
}

/// The type of the runtime that a prepared constant of pairs of bodies has, and its code.
fn table_of_pairs(model: &Model, content: Content) -> Option<(&'static str, TokenStream)> {
    let Whole { code, table } = whole(model, parameter(&model.graph, content.node()?)?)?;
    Some((table?, code))
}

/// The code of all values of a parameter at once, with the indices of loops as they are called.
fn whole(model: &Model, parameter: ParameterId) -> Option<Whole> {
    model.parameters[parameter.0 as usize].named_whole(&model.running)
}

fn parameter(graph: &Graph, id: NodeId) -> Option<ParameterId> {
    match graph.node(id) {
        Node::Parameter(parameter) => Some(parameter),
        _ => None,
    }
}

/// The lists that a prepared constant is computed from, whose values are made at once.
struct Values {
    /// The code of each, and its name.
    lists: Vec<(TokenStream, Ident)>,
}

impl Values {
    fn of(model: &Model, content: Content) -> Self {
        let parameters: Vec<ParameterId> = match content {
            Content::Number(number) => {
                let nodes = model.graph.reachable([number]);
                nodes.into_iter().filter_map(|id| parameter(&model.graph, id)).collect()
            }
            Content::Integer(parameter) => vec![parameter],
            _ => Vec::new(),
        };
        let lists = parameters.into_iter().filter_map(|id| whole(model, id)).filter(|whole| whole.table.is_none());
        let named = |(number, whole): (usize, Whole)| match number {
            0 => (whole.code, format_ident!("__values")),
            _ => (whole.code, format_ident!("__values_{number}")),
        };
        Self { lists: lists.enumerate().map(named).collect() }
    }

    /// A text that reads the lists by name in place of making them.
    fn named_in(&self, text: TokenStream) -> TokenStream {
        if self.lists.is_empty() {
            return text;
        }
        let named = text.into_iter().map(|token| match token {
            TokenTree::Group(group) => {
                let code = group.stream().to_string();
                let list = self.lists.iter().find(|(list, _)| list.to_string() == code);
                list.map_or_else(
                    || TokenTree::Group(Group::new(group.delimiter(), self.named_in(group.stream()))),
                    |(_, name)| name.clone().into(),
                )
            }
            other => other,
        });
        named.collect()
    }

    /// A text after the declaration of the lists.
    fn declared(&self, text: TokenStream) -> TokenStream {
        if self.lists.is_empty() {
            return text;
        }
        let declarations = self.lists.iter().map(|(code, name)| quote!(let #name = #code;));
        quote!({ #(#declarations)* #text })
    }
}

/// The expression of a number that is made of parameters alone.
fn prepared_number(emitter: &mut Emitter<'_>, id: NodeId) -> TokenStream {
    let lowered = lower(&mut emitter.model.graph, &[id], |_, _| false)[0];
    let body = emitter.value(&Frame::System, lowered);
    let lines = body.tokens;
    if body.program.items.len() > 1 { quote!({ #lines }) } else { lines }
}

/// The derivative of a prepared constant by one of the parameters that are requested, by its number, or by none; what
/// is no number of its own stays what it is.
fn slope(emitter: &mut Emitter<'_>, content: Content, parameter: usize, value: &TokenStream) -> TokenStream {
    match content {
        Content::Number(id) => match emitter.model.sensitive.get(parameter).copied() {
            Some(parameter) => {
                let slope = emitter.model.graph.by_parameter(id, parameter);
                prepared_number(emitter, slope)
            }
            None => quote!(0.0),
        },
        Content::Flag(_) | Content::Middle => quote!(0.0),
        Content::Integer(_) | Content::InnerSteps(_) | Content::External(_) | Content::OwnFlow(_) => value.clone(),
    }
}

/// The flow that the user wrote of a part, as the runtime calls it: coordinates come as one list of numbers.
fn own_flow(model: &Model, names: &Names, part: usize) -> TokenStream {
    let (runtime, method) = (&names.runtime, &model.parts[part].own);
    let [q, p] = ["q", "p"].map(|coordinates| format_ident!("{coordinates}"));
    let points = |coordinates: &Ident| {
        let chunked = |list, _: &Length| quote!(#list.as_chunks_mut().0);
        model.shape.inner.iter().fold(quote!(#coordinates), chunked)
    };
    let [of_q, of_p] = [points(&q), points(&p)];
    let call = match model.shape.length {
        Length::OfStart => quote!(system.#method(#of_q, #of_p, duration)),
        _ => quote! {
            if let (::core::result::Result::Ok(q), ::core::result::Result::Ok(p)) =
                (::core::convert::TryInto::try_into(#of_q), ::core::convert::TryInto::try_into(#of_p))
            {
                system.#method(q, p, duration);
            }
        },
    };
    quote!({
        let system = ::core::clone::Clone::clone(self);
        #runtime::SharedTable::from([#runtime::Arc::new(move |#q: &mut [f64], #p: &mut [f64], duration: f64| { #call }) as _])
    })
}

/// How many elements a table of prepared constants has along each of its loops; `None` where that is known at run time.
pub(crate) fn extents(model: &mut Model, names: &Names, content: Content) -> Vec<Option<u64>> {
    Table::of(model, names, content).levels.iter().map(|level| level.literal).collect()
}

/// The loops of a table of prepared constants: the index, the number of elements if that is known, and whether an element is read.
pub(crate) fn level_texts(
    emitter: &mut Emitter<'_>,
    content: Content,
) -> Vec<(Ident, Option<u64>, Option<TokenStream>)> {
    let levels = Table::of(emitter.model, emitter.names, content).levels;
    levels.into_iter().map(|Level { index, literal, inside, .. }| (index, literal, inside)).collect()
}

/// The expression of an element of a prepared constant, of a flag its condition; `None` of what is no expression of each element.
pub(crate) fn value_text(emitter: &mut Emitter<'_>, content: Content) -> Option<TokenStream> {
    if !Values::of(emitter.model, content).lists.is_empty() || table_of_pairs(emitter.model, content).is_some() {
        return None;
    }
    match content {
        Content::Number(id) => Some(prepared_number(emitter, id)),
        Content::Integer(id) | Content::Flag(id) => Some(emitter.model.text(id)),
        Content::Middle | Content::External(_) | Content::InnerSteps(_) | Content::OwnFlow(_) => None,
    }
}

/// The loops that a prepared constant depends on, with how far each runs.
struct Table {
    levels: Vec<Level>,
}

struct Level {
    index: Ident,
    /// How many elements, if that is a number.
    literal: Option<u64>,
    /// How many elements, as text.
    extent: TokenStream,
    /// Whether an element is ever read; what lies outside the loop's range is not evaluated.
    inside: Option<TokenStream>,
}

impl Table {
    fn of(model: &mut Model, names: &Names, content: Content) -> Self {
        let loops = match content {
            Content::Number(id) => model.graph.loops_of(id),
            Content::Integer(id) | Content::Flag(id) => model.graph.loops.of_parameter(id),
            _ => LoopSet::EMPTY,
        };
        Self { levels: loops.iter().map(|by| Level::of(model, names, by, loops)).collect() }
    }

    /// The type of the table.
    fn kind(&self, element: TokenStream, names: &Names) -> TokenStream {
        let runtime = &names.runtime;
        self.levels.iter().rev().fold(element, |inner, level| match level.literal {
            Some(length) => {
                let length = Literal::u64_unsuffixed(length);
                quote!([#inner; #length])
            }
            None => quote!(#runtime::SharedTable<#inner>),
        })
    }

    /// The whole table, with elements evaluated inside the loops' ranges alone.
    fn prepared(&self, element: TokenStream, content: Content, names: &Names) -> TokenStream {
        let runtime = &names.runtime;
        let conditions: Vec<_> = self.levels.iter().filter_map(|level| level.inside.clone()).collect();
        let element = match content {
            _ if conditions.is_empty() => element,
            Content::Number(_) | Content::Flag(_) => quote!(if #(#conditions)&&* { #element } else { 0.0 }),
            Content::Integer(_) => quote!(if #(#conditions)&&* { #element } else { 0 }),
            _ => element,
        };
        self.levels.iter().rev().fold(element, |inner, Level { index, literal, extent, .. }| match literal {
            Some(_) => quote!(::core::array::from_fn(|#index: usize| #inner)),
            None => quote!(#runtime::table(#extent, &|#index: usize| #inner)),
        })
    }
}

impl Level {
    fn of(model: &mut Model, names: &Names, by: LoopId, table: LoopSet) -> Self {
        let index = model.running[&by].clone();
        let range = model.graph.loops.get(by);
        let (from, to) = (bound(model, range.from, table, false), bound(model, range.to, table, true));
        // A row that is as long as a list says has the length of that list, others that of the longest.
        let ragged = to == range.to && !model.graph.loops.is_without_lists(to);
        let extent = if ragged { to } else { model.graph.loops.upper(range.to).unwrap_or(range.to) };
        let literal = model.graph.loops.literal(extent);
        let (zero, whole) = (model.graph.loops.literal(from) == Some(0), to == extent);
        let program = Program::default();
        let printer = Printer::new(model, names, &program, &Frame::System);
        let mut none = Fields::default();
        let (from, to, extent) =
            (printer.index(&mut none, from), printer.index(&mut none, to), printer.index(&mut none, extent));
        let inside = match (zero, whole) {
            (true, true) => None,
            (true, false) => Some(quote!(#index < #to)),
            (false, true) => Some(quote!(#index >= #from)),
            (false, false) => Some(quote!(#index >= #from && #index < #to)),
        };
        Self { index, literal, extent, inside }
    }
}

/// A bound of a loop as seen from a table over `table`: itself, or the furthest it gets where it depends on more.
fn bound(model: &mut Model, id: IndexId, table: LoopSet, upper: bool) -> IndexId {
    let loops = &mut model.graph.loops;
    if loops.of_index(id).is_subset(table) {
        return id;
    }
    let furthest = if upper { loops.upper(id) } else { loops.lower(id) };
    furthest.unwrap_or_else(|| loops.intern(Index::Literal(0)))
}
