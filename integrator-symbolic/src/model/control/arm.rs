//! `match` and `if let` on values of the system. An arm is a branch under a condition of parameters. The names that it
//! binds are parameters, evaluated in a separate `match`.

use crate::graph::{
    Comparison, NodeId,
    index::{Index, IndexId, LoopSet},
};
use crate::model::{
    Reader,
    code::assigned::{Assigned, Names, simple_name},
    control::{
        branch::Sides,
        sides::{Body, Flow, Outcome},
    },
    parameters::text::identifiers,
    values::value::{Opaque, Value},
};
use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use std::collections::HashMap;
use syn::{Expr, ExprLit, ExprMatch, Lit, Pat, PatGuard, visit::Visit};

/// An arm that is being read.
#[derive(Clone)]
pub(crate) struct Arm {
    matched: Opaque,
    /// The patterns of the arms before, which are tried first.
    earlier: Vec<TokenStream>,
    pattern: TokenStream,
    /// What the pattern binds: a name of the user's, and the one that texts have for it.
    names: Vec<(Ident, Ident)>,
}

impl Arm {
    /// Whether a text has a name that the arm binds.
    fn binds(&self, text: &TokenStream) -> bool {
        let mut found = Vec::new();
        identifiers(text.clone(), &mut found);
        self.names.iter().any(|(_, name)| found.contains(name))
    }

    /// A text that is evaluated where the arm is taken, and stands for `otherwise` elsewhere.
    fn around(&self, text: &TokenStream, otherwise: &TokenStream) -> TokenStream {
        let Self { matched: Opaque { text: matched, .. }, earlier, pattern, .. } = self;
        quote!((match #matched { #(#earlier => #otherwise,)* #pattern => #text, _ => #otherwise }))
    }
}

/// An arm as the user wrote it; one without a pattern is taken where no other is.
pub(crate) struct ArmText<'a> {
    pub(crate) pattern: Option<&'a Pat>,
    pub(crate) guard: Option<&'a Expr>,
    pub(crate) body: Body<'a>,
}

impl Reader<'_> {
    /// Whether an arm binds a name of the texts.
    pub(crate) fn is_bound(&self, name: &Ident) -> bool {
        self.arms.iter().flat_map(|arm| &arm.names).any(|(_, own)| own == name)
    }

    /// The text of a parameter, evaluated under the arms whose names it mentions.
    pub(crate) fn in_arms(&self, text: TokenStream, loops: LoopSet, otherwise: &TokenStream) -> (TokenStream, LoopSet) {
        self.arms.iter().rev().fold((text, loops), |(text, loops), arm| match arm.binds(&text) {
            true => (arm.around(&text, otherwise), loops.union(arm.matched.loops)),
            false => (text, loops),
        })
    }

    /// `match value { ... }` on a value of the system.
    pub(crate) fn matched(&mut self, whole: &ExprMatch, flow: Flow) -> Option<Outcome> {
        let arms = whole.arms.iter().map(|arm| {
            let (pattern, guard) = match &arm.pat {
                Pat::Guard(PatGuard { pat, guard, .. }) => (&**pat, Some(&**guard)),
                pattern => (pattern, None),
            };
            ArmText { pattern: Some(pattern), guard, body: Body::Expression(&arm.body) }
        });
        let arms: Vec<ArmText<'_>> = arms.collect();
        let Some((matched, integer)) = self.matchable(&whole.expr)? else {
            return self.refused(&Expr::Match(whole.clone())).map(Outcome::of);
        };
        self.first_of(&arms, &matched, integer, flow, whole)
    }

    /// What may be matched: a value of the system, and the integer that it is where it is one of indices. Nothing is noted
    /// of others.
    pub(crate) fn matchable(&mut self, expression: &Expr) -> Option<Option<(Opaque, Option<IndexId>)>> {
        if let Some(id) = simple_name(expression).and_then(|name| self.lookup(&name.to_string()))
            && let Value::Joint(joint) = &self.bindings[id.0].value
        {
            return Some(Some((joint.own.clone(), None)));
        }
        let Some(Value::Opaque(whole)) = self.verbatim(expression) else { return Some(None) };
        if let Expr::Tuple(_) = expression {
            return Some(Some((whole, None)));
        }
        let value = self.expression(expression)?;
        Some(Some(match self.of_own_type(value.into_own()) {
            Value::Opaque(opaque) => (opaque, None),
            Value::Integer(index) => (self.opaque(&Value::Integer(index)).unwrap_or(whole), Some(index)),
            _ => (whole, None),
        }))
    }

    /// The value of the first arm that is taken.
    pub(crate) fn first_of(
        &mut self,
        arms: &[ArmText<'_>],
        matched: &Opaque,
        integer: Option<IndexId>,
        flow: Flow,
        place: &dyn ToTokens,
    ) -> Option<Outcome> {
        let mut assigned = Assigned::default();
        for arm in arms {
            arm.body.visit(&mut assigned);
        }
        let fork = self.fork(&assigned);
        let depth = self.conditions.len();
        let (mut sides, mut earlier): (Sides<'_>, Vec<TokenStream>) = (Vec::new(), Vec::new());
        let mut last = None;
        for (at, text) in arms.iter().enumerate() {
            let is_last = at + 1 == arms.len();
            let Some(pattern) = text.pattern else {
                last = Some(self.side(&fork, None, true, |reader| reader.body(text.body, flow)));
                break;
            };
            let arm = self.arm(pattern, matched.clone(), earlier.clone());
            if text.guard.is_none() && (is_last || is_irrefutable(pattern)) {
                let read = |reader: &mut Self| reader.in_arm(arm, |reader| reader.settled_body(text.body, flow, 1));
                last = Some(self.side(&fork, None, true, read));
                break;
            }
            // What is matched has its value before any arm is tried.
            let tried = self.conditions.split_off(depth);
            let fits = self.fits(&arm, integer, pattern);
            self.conditions.extend(tried);
            let condition = match text.guard {
                None => Some(fits),
                Some(_) if self.is_known(Some(fits), false) => Some(fits),
                Some(guard) => {
                    let guard = self.in_arm(arm.clone(), |reader| reader.condition_of(guard));
                    guard.map(|guard| self.graph.and(fits, guard))
                }
            };
            // A guard may fail where its pattern fits, so that later arms are tried there as well.
            earlier.extend(text.guard.is_none().then(|| arm.pattern.clone()));
            let read = |reader: &mut Self| reader.in_arm(arm, |reader| reader.settled_body(text.body, flow, 1));
            let side = self.side(&fork, condition, true, read);
            sides.push((condition, side, place));
            condition.into_iter().for_each(|condition| self.past(condition));
            if self.is_known(condition, true) {
                last = Some(fork.untaken());
                break;
            }
        }
        self.conditions.truncate(depth);
        self.joined(fork, sides, last?)
    }

    /// Whether an arm's pattern fits.
    pub(crate) fn fits(&mut self, arm: &Arm, integer: Option<IndexId>, pattern: &Pat) -> NodeId {
        if let (Some(index), Some(literals)) = (integer, literals(pattern)) {
            let none = self.graph.truth(false);
            return literals.into_iter().fold(none, |any, literal| {
                let literal = self.graph.loops.intern(Index::Literal(literal));
                let equal = self.graph.compare_index(Comparison::Equal, index, literal);
                self.graph.or(any, equal)
            });
        }
        let Arm { matched: Opaque { text, loops }, pattern, .. } = arm;
        let flag = self.parameter(quote!(::core::matches!(#text, #pattern)), "condition", *loops);
        self.graph.flag(flag)
    }

    /// An arm whose names no other arm around it has.
    pub(crate) fn arm(&self, pattern: &Pat, matched: Opaque, earlier: Vec<TokenStream>) -> Arm {
        let mut names = Names(Vec::new());
        names.visit_pat(pattern);
        let taken = |name: &Ident| self.arms.iter().flat_map(|arm| &arm.names).any(|(_, known)| known == name);
        let bound = names.0.into_iter().filter(|name| !name.starts_with(char::is_uppercase));
        let mut names: Vec<(Ident, Ident)> = Vec::new();
        for name in bound {
            let own = format_ident!("matched_{name}");
            let numbered = (2..).map(|count| format_ident!("matched_{name}_{count}"));
            let own = std::iter::once(own.clone()).chain(numbered).find(|name| !taken(name)).unwrap_or(own);
            if names.iter().all(|(known, _)| *known != name) {
                names.push((format_ident!("{name}"), own));
            }
        }
        let pattern = renamed(pattern.to_token_stream(), &names, false);
        Arm { matched, earlier, pattern, names }
    }

    /// Reads something in an arm, where the names of its pattern are known.
    pub(crate) fn in_arm<T>(&mut self, arm: Arm, read: impl FnOnce(&mut Self) -> T) -> T {
        self.scopes.push(HashMap::new());
        for (name, own) in &arm.names {
            let value = Opaque { text: own.to_token_stream(), loops: arm.matched.loops };
            self.declare(name.to_string(), Value::Opaque(value));
        }
        self.arms.push(arm);
        let value = read(self);
        self.arms.pop();
        self.scopes.pop();
        value
    }

    /// The body of this number of arms inside of each other: what leaves it is a number, since the names of the
    /// patterns mean nothing outside.
    pub(crate) fn settled_body(&mut self, body: Body<'_>, flow: Flow, arms: usize) -> Option<Outcome> {
        let mut assigned = Assigned::default();
        body.visit(&mut assigned);
        let ids: Vec<_> = assigned.names.iter().filter_map(|name| self.lookup(name)).collect();
        let outcome = self.body(body, flow);
        for id in ids {
            let left = std::mem::replace(&mut self.bindings[id.0].value, Value::Unknown);
            self.bindings[id.0].value = self.settled(left, arms);
        }
        let Outcome { value, returned } = outcome?;
        let returned = returned.into_iter().map(|(condition, value)| (condition, self.settled(value, arms))).collect();
        Some(Outcome { value: self.settled(value, arms), returned })
    }

    fn settled(&mut self, value: Value, arms: usize) -> Value {
        match value {
            Value::Opaque(Opaque { ref text, .. }) if self.arms.iter().rev().take(arms).any(|arm| arm.binds(text)) => {
                self.real(&value).map_or(value, Value::Real)
            }
            Value::Array(parts) => Value::Array(parts.into_iter().map(|part| self.settled(part, arms)).collect()),
            Value::Tuple(parts) => Value::Tuple(parts.into_iter().map(|part| self.settled(part, arms)).collect()),
            other => other,
        }
    }
}

/// Whether a pattern fits every value.
fn is_irrefutable(pattern: &Pat) -> bool {
    match pattern {
        Pat::Wild(_) => true,
        Pat::Ident(name) => name.subpat.is_none() && !name.ident.to_string().starts_with(char::is_uppercase),
        Pat::Paren(inner) => is_irrefutable(&inner.pat),
        _ => false,
    }
}

/// The numbers of a pattern that is made of them.
fn literals(pattern: &Pat) -> Option<Vec<u64>> {
    match pattern {
        Pat::Lit(ExprLit { lit: Lit::Int(number), .. }) => Some(vec![number.base10_parse().ok()?]),
        Pat::Or(cases) => cases.cases.iter().map(literals).collect::<Option<Vec<_>>>().map(|found| found.concat()),
        Pat::Paren(inner) => literals(&inner.pat),
        _ => None,
    }
}

/// A pattern whose names have other names; `fields` says that it is the list of a struct's fields, where a name alone is
/// that of a field too.
fn renamed(pattern: TokenStream, names: &[(Ident, Ident)], fields: bool) -> TokenStream {
    let trees: Vec<TokenTree> = pattern.into_iter().collect();
    let is_mark = |tree: &TokenTree, mark| matches!(tree, TokenTree::Punct(found) if found.as_char() == mark);
    let own_of = |tree: &TokenTree| match tree {
        TokenTree::Ident(name) => names.iter().find(|(known, _)| known == name),
        _ => None,
    };
    let mut output = TokenStream::new();
    for part in trees.split_inclusive(|tree| is_mark(tree, ',')) {
        let has_pattern = part.iter().any(|tree| is_mark(tree, ':'));
        if fields && !has_pattern {
            output.extend(part.iter().filter_map(own_of).map(|(name, _)| quote!(#name:)));
        }
        for (at, tree) in part.iter().enumerate() {
            let is_field = fields && has_pattern && at == 0;
            match (tree, own_of(tree).filter(|_| !is_field)) {
                (_, Some((_, own))) => output.extend(quote!(#own)),
                (TokenTree::Group(group), None) => {
                    let inner = renamed(group.stream(), names, group.delimiter() == Delimiter::Brace);
                    output.extend([TokenTree::from(Group::new(group.delimiter(), inner))]);
                }
                (other, None) => output.extend([other.clone()]),
            }
        }
    }
    output
}
