//! The source of the user's parameter expressions, rewritten for other indices.

use crate::graph::{
    Comparison, Graph, Node, NodeId, ParameterId,
    index::{Index, LoopId, LoopSet},
    rename::{End, Parameters, Place, Renaming},
};
use crate::model::{
    Parameter, Whole,
    parameters::{
        classes::THIS_BODY,
        factors::factors,
        flags::OTHER_BODY,
        presence::unlooked,
        running_index::{loop_of, mentioned, mentions, running_index, with_index, with_indices},
    },
};
use proc_macro2::{Delimiter, Group, Ident, Literal, TokenStream, TokenTree};
use quote::{format_ident, quote};
use std::collections::HashMap;

/// What the number of bodies is called where it is not that of the coordinates.
pub(crate) const COUNT: &str = "__bodies";

/// The texts of a model, and what the indices in them are called.
pub(crate) struct Texts<'m> {
    parameters: &'m mut Vec<Parameter>,
    running: &'m mut HashMap<LoopId, Ident>,
    /// The runtime crate.
    pub(super) root: &'m syn::Path,
    /// The number of bodies, as it is called where parameters are evaluated.
    pub(super) count: Ident,
    /// The parameters by the loops whose indices they mention, and by their text; filled when first requested.
    known: HashMap<(LoopSet, String), ParameterId>,
    /// What the entries of tables by classes are: the loops over the two bodies of a pair, and the text of an entry, also as shown.
    pub(super) entries: HashMap<ParameterId, ([LoopId; 2], [TokenStream; 2])>,
}

impl Parameters for Texts<'_> {
    fn rename(&mut self, graph: &mut Graph, id: ParameterId, renaming: Renaming) -> Option<ParameterId> {
        let loops = graph.loops.of_parameter(id);
        if renaming.keeps(loops) {
            return Some(id);
        }
        let text = self.text(id);
        if !is_plain(&text) {
            return None;
        }
        let renamed_to = |to: LoopId| loops.iter().find(|from| renaming.of(*from) == Place::Loop(to));
        let captured = |by: LoopId| !loops.contains(by) && mentions(&text, by);
        if loops
            .iter()
            .any(|from| renamed_to(from).is_some() && matches!(renaming.of(from), Place::Loop(to) if captured(to)))
        {
            return None;
        }
        let index = |by: LoopId| match renaming.of(by) {
            // The index of a closure in the text changes places with one that it would capture.
            _ if !loops.contains(by) => renamed_to(by).map(|from| running_index(from).into()),
            Place::Loop(to) => Some(running_index(to).into()),
            Place::Number(value) => Some(Literal::u64_unsuffixed(value).into()),
        };
        let [text, own] = [text, self.own_text(id)].map(|text| with_indices(&text, &index));
        let loops = loops.iter().fold(LoopSet::EMPTY, |set, by| match renaming.of(by) {
            Place::Loop(to) => set.union(LoopSet::of(to)),
            Place::Number(_) => set,
        });
        let renamed = self.id(graph, text, loops);
        self.show(renamed, &own);
        graph.declare_like(renamed, id);
        if !loops.is_empty() {
            self.parameters[renamed.0 as usize].whole = self.parameters[id.0 as usize].whole.clone();
        }
        Some(renamed)
    }

    fn factors(&mut self, graph: &mut Graph, id: ParameterId) -> Vec<(ParameterId, i32)> {
        let factors = factors(self.text(id));
        if factors.len() < 2 {
            return vec![(id, 1)];
        }
        let loops = graph.loops.of_parameter(id);
        let mut of = |(text, exponent): (TokenStream, i32)| {
            let own = mentioned(&text, loops);
            (self.id(graph, text, own), exponent)
        };
        factors.into_iter().map(&mut of).collect()
    }

    fn bare(&mut self, graph: &mut Graph, id: ParameterId) -> (bool, ParameterId) {
        let text = without_guard(self.text(id));
        let (negative, text) = match without_sign(text.clone()) {
            Some(positive) => (true, positive),
            None => (false, text),
        };
        (negative, self.id(graph, text, graph.loops.of_parameter(id)))
    }

    fn multiple(&mut self, graph: &mut Graph, id: ParameterId) -> (f64, ParameterId) {
        self.multiple_of(graph, id)
    }

    fn indicator(&mut self, graph: &mut Graph, by: LoopId, is_zero: bool) -> Option<ParameterId> {
        let comparison = if is_zero { quote!(==) } else { quote!(!=) };
        Some(self.of_index(graph, by, |index| quote!(((#index #comparison 0) as u8 as f64))))
    }

    fn behind_first(&mut self, graph: &mut Graph, id: ParameterId, by: LoopId) -> Option<ParameterId> {
        let (text, index) = (self.text(id), running_index(by));
        let behind = TokenTree::Group(Group::new(Delimiter::Parenthesis, quote!(#index.max(1))));
        let text = is_plain(&text).then(|| with_index(&text, by, behind))?;
        Some(self.id(graph, text, graph.loops.of_parameter(id)))
    }

    fn flag(
        &mut self,
        graph: &mut Graph,
        id: ParameterId,
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        self.flag_of_pair(graph, id, pair, ends)
    }

    fn entry(
        &mut self,
        graph: &mut Graph,
        id: ParameterId,
        pair: [LoopId; 2],
        ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        self.number_of_pair(graph, id, pair, ends)
    }

    fn of_distinct(&mut self, graph: &mut Graph, id: ParameterId, bodies: [LoopId; 3]) -> ParameterId {
        let mut text = self.text(id);
        let known = text.to_string();
        while let Some(inner) = unguarded(&text, &bodies, None) {
            text = inner;
        }
        if text.to_string() == known {
            return id;
        }
        let of = bodies.into_iter().filter(|by| mentions(&text, *by));
        let of = of.fold(LoopSet::EMPTY, |all, by| all.union(LoopSet::of(by)));
        let own = self.own_text(id);
        let inner = self.id(graph, text, of);
        self.show(inner, &own);
        inner
    }

    fn choice(&mut self, graph: &mut Graph, id: NodeId, pair: [LoopId; 2], ends: [Option<End>; 2]) -> Option<NodeId> {
        self.choice_of_pair(graph, id, pair, ends)
    }

    fn sum(&mut self, graph: &mut Graph, id: NodeId, pair: [LoopId; 2], ends: [Option<End>; 2]) -> Option<NodeId> {
        self.sum_of_pair(graph, id, pair, ends)
    }

    fn without(
        &mut self,
        graph: &mut Graph,
        id: ParameterId,
        is_integer: bool,
        by: LoopId,
        end: End,
    ) -> Option<ParameterId> {
        let (text, index, count) = (self.text(id), running_index(by), &self.count);
        let is_other = match end {
            End::First => quote!(#index > 0),
            End::Last => quote!(#index + 1 < #count),
        };
        if self.parameters[id.0 as usize].whole.is_some() {
            return Some(id);
        }
        if !is_plain(&text) || graph.loops.of_parameter(id) != LoopSet::of(by) {
            return None;
        }
        let number = if is_integer { quote!((#text) as f64) } else { text.clone() };
        let guarded = quote!((if #is_other { #number } else { 0.0 }));
        let guard = quote!(if #is_other).to_string();
        if text.to_string().trim_start_matches('(').starts_with(&guard) {
            return Some(id);
        }
        let guarded = self.id(graph, guarded, LoopSet::of(by));
        let own = self.parameters[id.0 as usize].own.clone();
        self.show(guarded, &own);
        graph.declare_like(guarded, id);
        Some(guarded)
    }

    fn of_point(
        &mut self,
        graph: &mut Graph,
        id: ParameterId,
        by: LoopId,
        components: u64,
        point: LoopId,
    ) -> Option<ParameterId> {
        if graph.loops.of_parameter(id) != LoopSet::of(by) || !self.is_plain_number(id) {
            return None;
        }
        let [text, own] =
            [self.text(id), self.own_text(id)].map(|text| divided(&text, by, components, &running_index(point)));
        if mentions(&text, by) || mentions(&own, by) {
            return None;
        }
        let of_point = self.id(graph, text, LoopSet::of(point));
        self.show(of_point, &own);
        graph.declare_like(of_point, id);
        Some(of_point)
    }

    fn extremes(
        &mut self,
        graph: &mut Graph,
        id: ParameterId,
        by: LoopId,
        end: Option<End>,
    ) -> Option<[ParameterId; 2]> {
        self.extreme_values(graph, id, by, end)
    }

    fn extreme_entries(&mut self, graph: &mut Graph, table: ParameterId) -> Option<[ParameterId; 2]> {
        self.extremes_of_table(graph, table)
    }

    fn density(&mut self, graph: &mut Graph, by: LoopId, number: usize) -> Option<ParameterId> {
        let name = format_ident!("__density_{number}");
        let density = self.of_index(graph, by, |index| quote!(#name[#index]));
        graph.declare_computed(density);
        Some(density)
    }

    fn name_if_new(&mut self, new: LoopId, like: LoopId) {
        if !self.running.contains_key(&new) {
            self.name(new, like);
        }
    }

    fn name(&mut self, new: LoopId, like: LoopId) {
        let base = self.running.get(&like).cloned().unwrap_or_else(|| format_ident!("k"));
        let free = self.free(&base);
        self.running.insert(new, free);
    }
}

impl<'m> Texts<'m> {
    pub(crate) fn new(
        parameters: &'m mut Vec<Parameter>,
        running: &'m mut HashMap<LoopId, Ident>,
        root: &'m syn::Path,
    ) -> Self {
        Self {
            parameters,
            running,
            root,
            count: format_ident!("length"),
            known: HashMap::new(),
            entries: HashMap::new(),
        }
    }

    /// The same of bodies whose number is that of the coordinates or another one.
    pub(crate) fn of_bodies(
        parameters: &'m mut Vec<Parameter>,
        running: &'m mut HashMap<LoopId, Ident>,
        root: &'m syn::Path,
        is_length: bool,
    ) -> Self {
        let texts = Self::new(parameters, running, root);
        if is_length { texts } else { Self { count: format_ident!("{COUNT}"), ..texts } }
    }

    /// A number of each body that is zero from the body with the number `acting` on, where the lists of the user may end.
    pub(crate) fn of_first(&mut self, graph: &mut Graph, id: NodeId, bodies: LoopId, acting: ParameterId) -> NodeId {
        let value = self.read_for_first(graph, id, bodies, acting, &mut HashMap::new());
        if matches!(graph.node(id), Node::Parameter(_) | Node::FromIndex(_)) || !graph.loops_of(id).contains(bodies) {
            return value;
        }
        let [index, acting] = [Index::Running(bodies), Index::Parameter(acting)].map(|id| graph.loops.intern(id));
        let (acts, zero) = (graph.compare_index(Comparison::Less, index, acting), graph.constant(0.0));
        graph.select(acts, value, zero)
    }

    /// The same value for the first bodies, which reads no list for others.
    fn read_for_first(
        &mut self,
        graph: &mut Graph,
        id: NodeId,
        bodies: LoopId,
        acting: ParameterId,
        known: &mut HashMap<NodeId, NodeId>,
    ) -> NodeId {
        if let Some(first) = known.get(&id) {
            return *first;
        }
        let (node, index) = (graph.node(id), running_index(bodies));
        let first = match node {
            _ if !graph.loops_of(id).contains(bodies) => id,
            Node::Parameter(parameter) => {
                let first = self.parameter_of_first(graph, parameter, bodies, acting);
                graph.parameter(first)
            }
            Node::FromIndex(integer) if !graph.loops.is_without_lists(integer) => {
                match (self.text_of(graph, integer), self.text(acting)) {
                    (Some(number), acting) => {
                        let text = quote!((if #index < #acting { (#number) as f64 } else { 0.0 }));
                        let first = self.id(graph, text, LoopSet::of(bodies));
                        graph.parameter(first)
                    }
                    (None, _) => id,
                }
            }
            Node::FromIndex(_) => id,
            Node::Flag(parameter) => {
                let (text, acting) = (self.text(parameter), self.text(acting));
                let first = self.id(graph, quote!((#index < #acting && #text)), LoopSet::of(bodies));
                graph.rebuilt(Node::Flag(first))
            }
            node => {
                let mut first = HashMap::new();
                for child in node.children() {
                    first.insert(child, self.read_for_first(graph, child, bodies, acting, known));
                }
                graph.rebuilt(node.map(|child| first[&child]))
            }
        };
        known.insert(id, first);
        first
    }

    /// The parameter for the first bodies, and zero for the others.
    fn parameter_of_first(
        &mut self,
        graph: &mut Graph,
        parameter: ParameterId,
        bodies: LoopId,
        acting: ParameterId,
    ) -> ParameterId {
        let (own, index) = (self.own_text(parameter), running_index(bodies));
        let first = match self.parameters[parameter.0 as usize].whole.clone() {
            Some(Whole { code, .. }) => {
                let root = self.root;
                let code = quote!(#root::__private::padded(#code, length));
                self.list(graph, quote!((#code)[#index]), LoopSet::of(bodies), code)
            }
            None => {
                let (text, acting) = (self.text(parameter), self.text(acting));
                self.id(graph, quote!((if #index < #acting { #text } else { 0.0 })), LoopSet::of(bodies))
            }
        };
        self.show(first, &own);
        graph.declare_like(first, parameter);
        first
    }

    /// Names the index of a loop that takes the place of others, one of which it is `like`: apart from those of all loops that
    /// stay, since any of these may be inside of it from now on.
    pub(crate) fn name_in_place(&mut self, by: LoopId, like: LoopId, replaced: &[LoopId]) {
        let base = self.running.get(&by).or_else(|| self.running.get(&like)).cloned();
        let base = base.unwrap_or_else(|| format_ident!("k"));
        let mut others = self.running.iter().filter(|(other, _)| **other != by && !replaced.contains(other));
        let name = if others.any(|(_, name)| *name == base) { self.free(&base) } else { base };
        self.running.insert(by, name);
    }

    /// Names the index of a new loop as no text and no other index is called.
    pub(super) fn name_apart(&mut self, by: LoopId) {
        if !self.running.contains_key(&by) {
            let base = format_ident!("k");
            let name = if self.is_taken(&base) { self.free(&base) } else { base };
            self.running.insert(by, name);
        }
    }

    /// A name like another one that no index of a loop has and no text mentions.
    fn free(&self, base: &Ident) -> Ident {
        let free = (2_u32..).map(|count| format_ident!("{base}_{count}")).find(|name| !self.is_taken(name));
        free.unwrap_or_else(|| base.clone())
    }

    fn is_taken(&self, name: &Ident) -> bool {
        let mut texts = self.parameters.iter().map(|parameter| &parameter.text);
        self.running.values().any(|known| known == name) || texts.any(|text| mentions_name(text, name))
    }

    /// Whether a number is an expression of each body, without closures and blocks.
    pub(super) fn is_plain_number(&self, id: ParameterId) -> bool {
        let Parameter { text, whole, .. } = &self.parameters[id.0 as usize];
        whole.is_none() && is_plain(text)
    }

    pub(super) fn own_text(&self, id: ParameterId) -> TokenStream {
        self.parameters[id.0 as usize].own.clone()
    }

    pub(super) fn text(&self, id: ParameterId) -> TokenStream {
        self.parameters[id.0 as usize].text.clone()
    }

    /// The text of a parameter of a pair, without the condition that it is not one of a body with itself, which loops that visit pairs
    /// twice leave out.
    pub(super) fn text_of_pair(&self, id: ParameterId, pair: [LoopId; 2], ends: [Option<End>; 2]) -> TokenStream {
        let text = self.text(id);
        unguarded(&text, &pair, ends[0]).unwrap_or(text)
    }

    /// The item of a list with the index of a loop.
    pub(crate) fn item(&mut self, graph: &mut Graph, list: &TokenStream, by: LoopId) -> ParameterId {
        self.of_index(graph, by, |index| quote!(#list[#index]))
    }

    /// A parameter that follows from the index of a loop.
    pub(crate) fn of_index(
        &mut self,
        graph: &mut Graph,
        by: LoopId,
        text: impl FnOnce(Ident) -> TokenStream,
    ) -> ParameterId {
        self.id(graph, text(running_index(by)), LoopSet::of(by))
    }

    /// A parameter that is the same for all indices.
    pub(crate) fn fixed(&mut self, graph: &mut Graph, text: TokenStream) -> ParameterId {
        self.id(graph, text, LoopSet::EMPTY)
    }

    /// A parameter whose values are computed at once by `code`, each of which is also an expression.
    pub(super) fn list(
        &mut self,
        graph: &mut Graph,
        text: TokenStream,
        loops: LoopSet,
        code: TokenStream,
    ) -> ParameterId {
        let id = self.id(graph, text, loops);
        self.parameters[id.0 as usize].whole = Some(Whole { code, table: None });
        id
    }

    /// A parameter of pairs of bodies that `code` creates as a table of this type.
    pub(super) fn table(&mut self, graph: &mut Graph, table: &'static str, code: TokenStream) -> ParameterId {
        let id = self.id(graph, code.clone(), LoopSet::EMPTY);
        self.parameters[id.0 as usize].whole = Some(Whole { code, table: Some(table) });
        id
    }

    /// Shows a parameter of the macro's own to people as this text of the user.
    pub(super) fn show(&mut self, id: ParameterId, text: &TokenStream) {
        self.parameters[id.0 as usize].own = text.clone();
    }

    /// Whether another parameter is shown to people as this text.
    pub(super) fn is_shown(&self, text: &TokenStream, id: ParameterId) -> bool {
        let text = text.to_string();
        let mut others = (0..).map(ParameterId).zip(self.parameters.iter());
        others.any(|(other, parameter)| other != id && parameter.own.to_string() == text)
    }

    /// Shows a parameter of the macro's own to people as if the system had a field of this name.
    pub(crate) fn call(&mut self, id: ParameterId, name: &str) {
        let name = format_ident!("{name}");
        self.parameters[id.0 as usize].own = quote!(self.#name);
    }

    /// The parameter with this text, new or known.
    pub(super) fn id(&mut self, graph: &mut Graph, text: TokenStream, loops: LoopSet) -> ParameterId {
        if let Some(known) = self.known_id(graph, &text, loops) {
            return known;
        }
        let made = ParameterId(self.parameters.len() as u32);
        self.known.insert((loops, text.to_string()), made);
        self.parameters.push(Parameter { own: text.clone(), text, whole: None });
        graph.loops.declare_parameter(made, loops);
        made
    }

    /// The parameter with this text, if there is one.
    pub(super) fn known_id(&mut self, graph: &Graph, text: &TokenStream, loops: LoopSet) -> Option<ParameterId> {
        if self.known.is_empty() {
            let parameters = (0..).map(ParameterId).zip(self.parameters.iter());
            let key = |id, parameter: &Parameter| (graph.loops.of_parameter(id), parameter.text.to_string());
            self.known = parameters.map(|(id, parameter)| (key(id, parameter), id)).collect();
        }
        self.known.get(&(loops, text.to_string())).copied()
    }
}

/// A text with something else for the index of a loop divided by a number, in parentheses or brackets.
fn divided(text: &TokenStream, by: LoopId, number: u64, other: &Ident) -> TokenStream {
    let is_quotient = |tokens: &[TokenTree]| match tokens {
        [TokenTree::Ident(index), TokenTree::Punct(mark), TokenTree::Literal(divisor)] => {
            let divisor = divisor.to_string();
            loop_of(index) == Some(by)
                && mark.as_char() == '/'
                && (divisor == number.to_string() || divisor == format!("{number}usize"))
        }
        _ => false,
    };
    let tokens = text.clone().into_iter().map(|token| match token {
        TokenTree::Group(group) if group.delimiter() != Delimiter::Brace => {
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            let stream = match is_quotient(&inner) {
                true => quote!(#other),
                false => divided(&group.stream(), by, number, other),
            };
            let mut new = Group::new(group.delimiter(), stream);
            new.set_span(group.span());
            new.into()
        }
        other => other,
    });
    tokens.collect()
}

/// Whether a text mentions a variable.
fn mentions_name(text: &TokenStream, name: &Ident) -> bool {
    text.clone().into_iter().any(|token| match token {
        TokenTree::Ident(ident) => ident == *name,
        TokenTree::Group(group) => mentions_name(&group.stream(), name),
        TokenTree::Punct(_) | TokenTree::Literal(_) => false,
    })
}

/// The text after a minus sign in front of a product.
pub(super) fn without_sign(text: TokenStream) -> Option<TokenStream> {
    let tokens: Vec<TokenTree> = text.into_iter().collect();
    match &tokens[..] {
        [TokenTree::Group(group)] if group.delimiter() == Delimiter::Parenthesis => without_sign(group.stream()),
        [TokenTree::Punct(mark), product @ ..] if mark.as_char() == '-' => {
            let in_product = |token: &TokenTree| match token {
                TokenTree::Punct(mark) => matches!(mark.as_char(), '*' | '/' | '.' | ':'),
                TokenTree::Ident(name) => name != "as",
                TokenTree::Group(_) | TokenTree::Literal(_) => true,
            };
            (!product.is_empty() && product.iter().all(in_product)).then(|| product.iter().cloned().collect())
        }
        _ => None,
    }
}

/// A text without the condition around it, if that only selects a body by its index.
fn without_guard(text: TokenStream) -> TokenStream {
    match guarded(&text) {
        Some((condition, inner)) if asks_for_indices(&condition) => inner,
        _ => text,
    }
}

/// The text inside of a condition that is not one of indices.
pub(super) fn without_condition(text: &TokenStream) -> Option<TokenStream> {
    let (condition, inner) = guarded(text)?;
    (!asks_for_indices(&condition)).then_some(inner)
}

/// The condition around a text, and the text inside of it: of `(if condition { text } else { .. })`.
fn guarded(text: &TokenStream) -> Option<(TokenStream, TokenStream)> {
    let tokens: Vec<TokenTree> = text.clone().into_iter().collect();
    let [TokenTree::Group(group)] = &tokens[..] else { return None };
    let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
    match &tokens[..] {
        [
            TokenTree::Ident(choice),
            condition @ ..,
            TokenTree::Group(guarded),
            TokenTree::Ident(_),
            TokenTree::Group(_),
        ] if choice == "if" => Some((condition.iter().cloned().collect(), guarded.stream())),
        _ => None,
    }
}

/// The text inside of a condition on the indices of these bodies, if the condition holds wherever they differ, or if the text is looked up
/// where its lists have it.
fn unguarded(text: &TokenStream, bodies: &[LoopId], end: Option<End>) -> Option<TokenStream> {
    let (condition, inner) = guarded(text)?;
    (is_known(&condition, bodies, end) || asks_for_indices(&condition) && unlooked(&inner).is_some()).then_some(inner)
}

/// Whether a condition always holds since the indices of these loops differ, and the first of them has no partner at this end.
fn is_known(condition: &TokenStream, bodies: &[LoopId], end: Option<End>) -> bool {
    let text: String = condition.to_string().chars().filter(|letter| !matches!(letter, ' ' | '(' | ')')).collect();
    let is_first_less = end.map(|end| end == End::Last);
    text.split("&&").all(|one| {
        let (one, holds) = one.strip_prefix('!').map_or((one, true), |one| (one, false));
        let position = |name| bodies.iter().position(|by| running_index(*by) == name);
        let parts = ["==", "<=", "<"].into_iter().find_map(|sign| Some((sign, one.split_once(sign)?)));
        let Some((sign, (a, b))) = parts else { return false };
        let (Some(a), Some(b)) = (position(a), position(b)) else { return false };
        let is_less = is_first_less.map(|first| first == (a < b));
        a != b && if sign == "==" { !holds } else { is_less == Some(holds) }
    })
}

/// Whether a condition is one of indices of loops and of the number of bodies alone.
fn asks_for_indices(condition: &TokenStream) -> bool {
    condition.clone().into_iter().all(|token| match token {
        TokenTree::Ident(name) => {
            let known = ["length", COUNT, "saturating_sub", "any", "usize"];
            known.iter().any(|known| name == known) || loop_of(&name).is_some()
        }
        TokenTree::Group(group) => group.delimiter() == Delimiter::Parenthesis && asks_for_indices(&group.stream()),
        TokenTree::Punct(_) | TokenTree::Literal(_) => true,
    })
}

/// Whether a text is an expression without closures but those over indices and other bodies, and without blocks but those of
/// conditions.
fn is_plain(text: &TokenStream) -> bool {
    let tokens: Vec<TokenTree> = text.clone().into_iter().collect();
    if let [
        TokenTree::Ident(choice),
        condition @ ..,
        TokenTree::Group(guarded),
        TokenTree::Ident(_),
        TokenTree::Group(other),
    ] = &tokens[..]
        && choice == "if"
    {
        let condition = condition.iter().cloned().collect();
        return [condition, guarded.stream(), other.stream()].iter().all(is_plain);
    }
    let is_index = |at: usize| match tokens.get(at) {
        Some(TokenTree::Ident(name)) => {
            name == OTHER_BODY || name == THIS_BODY || name == "usize" || loop_of(name).is_some()
        }
        _ => false,
    };
    (0..).zip(&tokens).all(|(at, token)| match token {
        TokenTree::Punct(mark) => mark.as_char() != '|' || is_index(at + 1) || at > 0 && is_index(at - 1),
        TokenTree::Group(group) => group.delimiter() != Delimiter::Brace && is_plain(&group.stream()),
        TokenTree::Ident(_) | TokenTree::Literal(_) => true,
    })
}
