//! Prepared constants: what depends on parameters alone becomes a field, or a table where it depends on loops too.

use super::{
    equations::Formulas,
    expression::{Dialect, Printer},
    frame::Frame,
    names::Names,
};
use crate::{
    graph::{
        ExternalId, Graph, Node, NodeId, ParameterId,
        index::{Index, IndexId, LoopId, LoopSet},
    },
    lower::lower,
    model::{Method, Model, Parameter},
};
use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use std::collections::HashMap;

/// What a field holds.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Content {
    Number(NodeId),
    Integer(ParameterId),
    /// One where a condition of parameters holds, else zero.
    Flag(ParameterId),
    /// A method of the user with so many arguments.
    External(ExternalId),
    /// The middle of the step under way, which is the same for all lanes.
    Middle,
}

/// The fields asked for so far, in order of first use.
#[derive(Default)]
pub(super) struct Fields {
    order: Vec<(Content, Ident)>,
    names: HashMap<Content, Ident>,
}

/// Whether a node is read from a prepared constant: it depends on parameters, and on one loop at most unless it is a
/// parameter itself (a table over two loops is only made where the user has one).
pub(super) fn is_field(graph: &Graph, parameters: &[Parameter], id: NodeId) -> bool {
    match graph.node(id) {
        Node::Constant(_) | Node::FromIndex(_) | Node::Neg(_) => false,
        condition if condition.is_condition() => false,
        Node::Parameter(parameter) => !is_constant(&parameters[parameter.0 as usize].text),
        _ => graph.is_prepared(id) && graph.loops_of(id).iter().count() <= 1,
    }
}

/// Whether a node is read rather than computed by a flow.
pub(super) fn is_leaf(graph: &Graph, parameters: &[Parameter], id: NodeId) -> bool {
    matches!(
        graph.node(id),
        Node::Constant(_) | Node::FromIndex(_) | Node::Parameter(_) | Node::Time | Node::Middle | Node::Step
    ) || is_field(graph, parameters, id)
}

/// Whether a text is the path of a constant, which needs no preparation.
pub(super) fn is_constant(text: &TokenStream) -> bool {
    text.clone().into_iter().all(|token| match token {
        TokenTree::Ident(name) => name != "self" && name != "length",
        TokenTree::Punct(mark) => mark.as_char() == ':',
        TokenTree::Literal(_) | TokenTree::Group(_) => false,
    })
}

impl Fields {
    pub(super) fn number(&mut self, graph: &Graph, parameters: &[Parameter], id: NodeId) -> Ident {
        let text = match graph.node(id) {
            Node::Parameter(parameter) => Some(&parameters[parameter.0 as usize].own),
            _ => None,
        };
        self.named(Content::Number(id), text)
    }

    pub(super) fn integer(&mut self, parameters: &[Parameter], id: ParameterId) -> Ident {
        self.named(Content::Integer(id), Some(&parameters[id.0 as usize].own))
    }

    pub(super) fn flag(&mut self, parameters: &[Parameter], id: ParameterId) -> Ident {
        self.named(Content::Flag(id), Some(&parameters[id.0 as usize].own))
    }

    pub(super) fn external(&mut self, externals: &[Method], id: ExternalId) -> Ident {
        self.named_as(Content::External(id), Some(externals[id.0 as usize].name.clone()))
    }

    pub(super) fn middle(&mut self) -> Ident {
        self.named_as(Content::Middle, Some(format_ident!("middle")))
    }

    /// The field that holds the middle of the step, if a flow reads it.
    pub(super) fn known_middle(&self) -> Option<&Ident> {
        self.names.get(&Content::Middle)
    }

    /// A field's name: the user's own where it is `self.name` or `self.name[i]`.
    fn named(&mut self, content: Content, text: Option<&TokenStream>) -> Ident {
        self.named_as(content, text.and_then(own_name))
    }

    fn named_as(&mut self, content: Content, base: Option<Ident>) -> Ident {
        if let Some(name) = self.names.get(&content) {
            return name.clone();
        }
        let base = base.unwrap_or_else(|| format_ident!("prepared_{}", self.order.len()));
        let mut name = base.clone();
        let mut count = 1;
        while self.order.iter().any(|(_, known)| *known == name) {
            count += 1;
            name = format_ident!("{base}_{count}");
        }
        self.names.insert(content, name.clone());
        self.order.push((content, name.clone()));
        name
    }

    /// The struct of prepared constants, how one is gathered for lanes, and the body that prepares them.
    pub(super) fn emit(self, model: &mut Model, names: &Names) -> Prepared {
        let mut single = Fields::default();
        let mut prepared = Prepared::default();
        let scalar = &names.scalar;
        for (content, name) in self.order {
            let table = Table::of(model, names, content);
            let (kind, value) = match content {
                Content::Number(id) => {
                    let lowered = lower(&mut model.graph, &[id], |_, _| false)[0];
                    let body = super::block::function(model, &mut single, names, lowered, Dialect::Single);
                    (scalar.to_token_stream(), body)
                }
                Content::Integer(id) => {
                    let text = &model.parameters[id.0 as usize].text;
                    (quote!(usize), quote!(#text))
                }
                Content::Flag(id) => {
                    let text = &model.parameters[id.0 as usize].text;
                    (scalar.to_token_stream(), quote!(if #text { 1.0 } else { 0.0 }))
                }
                Content::Middle => (scalar.to_token_stream(), quote!(0.0)),
                Content::External(id) => {
                    let (method, runtime) = (&model.externals[id.0 as usize], &names.runtime);
                    let count = Literal::usize_unsuffixed(method.arguments);
                    let arguments: Vec<_> = (0..method.arguments)
                        .map(|number| format_ident!("argument_{number}").to_token_stream())
                        .collect();
                    let call = method.call(&quote!(system), &arguments);
                    let value = quote!({
                        let system = ::core::clone::Clone::clone(self);
                        #runtime::Vec::from([#runtime::Arc::new(move |[#(#arguments),*]: [f64; #count]| #call) as _])
                    });
                    (quote!(#runtime::External<#count>), value)
                }
            };
            let runtime = &names.runtime;
            let gathered = match content {
                Content::Number(_) | Content::Flag(_) | Content::Middle => {
                    quote!(#runtime::in_lanes(members, |member| &member.#name))
                }
                Content::Integer(_) => quote!(::core::clone::Clone::clone(&members[0].#name)),
                Content::External(_) => {
                    quote!(#runtime::table(<#scalar as #runtime::Real>::LANES, &|lane| ::core::clone::Clone::clone(&members[lane].#name[0])))
                }
            };
            let documentation = super::equations::documentation(model, content.node());
            let kind = table.kind(kind, names);
            let value = table.prepared(value, content, names);
            prepared.common.extend(match (content, table.levels.first()) {
                (Content::Integer(_), _) => Some(quote!(a.#name == b.#name)),
                (_, Some(Level { literal: None, .. })) => Some(quote!(a.#name.len() == b.#name.len())),
                _ => None,
            });
            if !matches!(content, Content::External(_)) {
                prepared.digested.push(name.clone());
            }
            if let Content::Number(id) = content {
                let (formula, runtime) = (Formulas::of(model).short(id), &names.runtime);
                let formula = formula.unwrap_or_else(|| name.to_string());
                let indices = table.levels.iter().map(|level| level.index.to_string());
                prepared.searched.push(quote!(#runtime::not_finite(#formula, &[#(#indices),*], &single.#name)));
            }
            prepared.fields.extend(quote!(#documentation #name: #kind,));
            prepared.gathered.extend(quote!(#name: #gathered,));
            prepared.values.extend(quote!(#name: #value,));
        }
        prepared
    }
}

impl Content {
    fn node(self) -> Option<NodeId> {
        match self {
            Content::Number(id) => Some(id),
            Content::Integer(_) | Content::Flag(_) | Content::External(_) | Content::Middle => None,
        }
    }
}

/// The parts of what is written for prepared constants.
#[derive(Default)]
pub(super) struct Prepared {
    pub(super) fields: TokenStream,
    pub(super) gathered: TokenStream,
    pub(super) values: TokenStream,
    /// What two members that share lanes have in common, as conditions on `a` and `b`.
    pub(super) common: Vec<TokenStream>,
    /// The search for a number that is not finite in each field of a `single`.
    pub(super) searched: Vec<TokenStream>,
    /// The fields that are numbers, or tables of numbers.
    pub(super) digested: Vec<Ident>,
}

/// `name` of `self.name` and of `self.name[...]`.
fn own_name(text: &TokenStream) -> Option<Ident> {
    let tokens: Vec<TokenTree> = text.clone().into_iter().collect();
    match &tokens[..] {
        [TokenTree::Ident(own), TokenTree::Punct(_), TokenTree::Ident(name), rest @ ..]
            if own == "self" && rest.iter().all(|token| matches!(token, TokenTree::Group(_))) =>
        {
            // A call is not a name.
            let indexed = rest.iter().all(|token| token.to_string().starts_with('['));
            indexed.then(|| name.clone())
        }
        _ => None,
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
            Content::External(_) | Content::Middle => LoopSet::EMPTY,
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
            None => quote!(#runtime::Vec<#inner>),
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
            Content::External(_) | Content::Middle => element,
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
        let printer = single(model, names);
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

/// A printer of `f64` expressions.
fn single<'m>(model: &'m Model, names: &'m Names) -> Printer<'m> {
    Printer {
        graph: &model.graph,
        parameters: &model.parameters,
        running: &model.running,
        dialect: Dialect::Single,
        names: HashMap::new(),
        scalar: &names.scalar,
        runtime: &names.runtime,
        externals: &model.externals,
        functions: model.functions,
        frame: &Frame::Motion,
    }
}
