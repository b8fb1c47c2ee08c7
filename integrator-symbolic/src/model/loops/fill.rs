//! Arrays that a loop fills, one element per iteration, and collected lists. Each element is computed where it is read.
//! An array may hence have any length, and the loops that read it remain sums.

#[cfg(test)]
mod tests;

use crate::graph::{
    Comparison, NodeId,
    index::{Index, IndexId},
};
use crate::model::{
    BindingId, Reader,
    code::assigned::{Assigned, Names, simple_name},
    parameters::text::identifiers,
    values::value::{Scope, Sequence, Value},
};
use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use std::{collections::HashMap, rc::Rc};
use syn::{Block, Expr, ExprForLoop, ExprRepeat, Local, Pat, parse_quote, visit::Visit};

/// Arrays with what they hold before a loop, and the body for one element of each.
type Elementwise = (Vec<(Ident, Sequence)>, Block);

/// A loop that fills arrays at the index of its iterations.
struct Fill {
    pattern: Pat,
    sequence: Sequence,
    /// The body, in which the name of an array stands for its element of this iteration.
    body: Block,
    /// The arrays, with what they hold before the loop.
    arrays: Vec<(Ident, Sequence)>,
    /// The variables that the body sees, as they were at the loop.
    captured: Scope,
}

impl Reader<'_> {
    /// Reads a loop that assigns to arrays at its own index, if it is one; outside, whether it was read.
    pub(crate) fn fill(&mut self, repeat: &ExprForLoop, sequence: &Sequence) -> Option<Option<Value>> {
        let Some((arrays, body)) = self.elementwise(repeat, sequence)? else { return Some(None) };
        let captured = self.captured_by(repeat.to_token_stream());
        let (pattern, sequence) = ((*repeat.pat).clone(), sequence.clone());
        let fill = Rc::new(Fill { pattern, sequence, body, arrays, captured });
        // What the body adds to other variables is summed; its mistakes are found here, even if nothing reads the arrays.
        let read = self.sums(repeat, &fill.sequence, &|reader, index| {
            reader.elements(&fill, index)?;
            Some(Value::Unit)
        });
        for (place, (name, _)) in fill.arrays.iter().enumerate() {
            let value = read.as_ref().map_or(Value::Unknown, |_| Value::List(filled(&fill, place)));
            if let Some(id) = self.lookup(&name.to_string()) {
                self.bindings[id.0].value = value;
            }
        }
        read.map(Some)
    }

    /// The arrays that a body assigns to at the index of its iteration alone, with the body for one element; outside,
    /// whether the loop was read.
    fn elementwise(&mut self, repeat: &ExprForLoop, sequence: &Sequence) -> Option<Option<Elementwise>> {
        let mut assigned = Assigned::default();
        assigned.visit_block(&repeat.body);
        let mut arrays: Vec<(String, Sequence)> = Vec::new();
        for name in &assigned.names {
            if assigned.indexed.contains(name)
                && !arrays.iter().any(|(known, _)| known == name)
                && let Some(list) = self.lookup(name).and_then(|id| self.held(id))
            {
                arrays.push((name.clone(), list));
            }
        }
        let mut names = Names(Vec::new());
        names.visit_pat(&repeat.pat);
        let mut elements =
            Elements { arrays: &arrays, iterations: &names.0, index: None, found: Vec::new(), sound: true };
        let body = elements.written(repeat.body.to_token_stream());
        let Elements { index, found, sound, .. } = elements;
        let Some(index) = index.filter(|_| sound) else { return Some(None) };
        let Ok(body) = syn::parse2(body) else { return Some(None) };
        let mut inner = Names(Vec::new());
        inner.visit_block(&repeat.body);
        if inner.0.iter().any(|name| index == name || arrays.iter().any(|(array, _)| name == array)) {
            return Some(None);
        }
        if !self.counts(&index, repeat, sequence)? {
            return Some(None);
        }
        for (name, list) in &arrays {
            let count = self.count_of(list);
            let (iterations, count) = (self.graph.loops.literal(sequence.to), self.graph.loops.literal(count));
            if let (Some(iterations), Some(count)) = (iterations, count)
                && iterations > count
            {
                let place = found.iter().find(|found| *found == name).map_or(&index, |found| found);
                self.errors.at(place, format!("the index is out of bounds for this array of {count} elements"));
                return None;
            }
        }
        let arrays = arrays.into_iter().filter_map(|(name, list)| {
            let own = found.iter().find(|found| **found == name)?;
            Some((own.clone(), list))
        });
        Some(Some((arrays.collect(), body)))
    }

    /// What an array or a list holds that was declared beside a loop, if its elements are alike.
    fn held(&mut self, id: BindingId) -> Option<Sequence> {
        let binding = &self.bindings[id.0];
        if binding.depth != self.frames.len() {
            return None;
        }
        let value = binding.value.clone();
        self.as_list(&value)
    }

    /// An array of equal elements, or a list, as a list.
    pub(crate) fn as_list(&mut self, value: &Value) -> Option<Sequence> {
        match value {
            Value::List(list) => Some(list.clone()),
            view @ Value::View(_) => self.listed(view.clone(), &TokenStream::new()),
            Value::Array(parts) if parts.windows(2).all(|pair| alike(&pair[0], &pair[1])) => {
                let (first, count) = (parts.first()?.clone(), self.literal_index(parts.len() as u64));
                Some(self.repeated(first, count))
            }
            _ => None,
        }
    }

    /// A list of equal values.
    fn repeated(&mut self, value: Value, count: IndexId) -> Sequence {
        let zero = self.literal_index(0);
        Sequence::new(zero, count, move |_, _| Some(value.clone()))
    }

    /// `[value; length]` with a length that is no literal.
    pub(crate) fn repeated_to(&mut self, value: Value, length: &Value) -> Option<Value> {
        let length = self.integer(length)?;
        Some(Value::List(self.repeated(value, length)))
    }

    /// Whether a name of a loop's pattern is the index of its iterations.
    fn counts(&mut self, name: &Ident, repeat: &ExprForLoop, sequence: &Sequence) -> Option<bool> {
        let by = self.enter(Some(name), sequence.from, sequence.to, &repeat.expr)?;
        let index = self.graph.loops.intern(Index::Running(by));
        self.scopes.push(HashMap::new());
        let item = self.item_of(sequence, index);
        let counts = item.map(|item| {
            self.bind(&repeat.pat, item.value);
            let value = self.lookup(&name.to_string()).map(|id| &self.bindings[id.0].value);
            item.condition.is_none() && matches!(value, Some(Value::Integer(found)) if *found == index)
        });
        self.scopes.pop();
        self.leave();
        counts
    }

    /// The elements of all arrays that an iteration fills.
    fn elements(&mut self, fill: &Fill, index: IndexId) -> Option<Vec<Value>> {
        let item = self.item_of(&fill.sequence, index)?;
        self.scopes.push(HashMap::new());
        self.bind(&fill.pattern, item.value);
        let before = fill.arrays.iter().map(|(name, list)| Some((name, self.item_of(list, index)?.value)));
        let before: Option<Vec<_>> = before.collect();
        let read = before.and_then(|before| {
            for (name, value) in before {
                self.declare(name.to_string(), value);
            }
            self.block(&fill.body)
        });
        let element = |(name, _): &(Ident, _)| Some(self.bindings[self.lookup(&name.to_string())?.0].value.clone());
        let elements = read.and_then(|_| fill.arrays.iter().map(element).collect());
        self.scopes.pop();
        elements
    }

    /// The condition under which a loop has an iteration for an element; nothing where it has one for all of them.
    fn has_iteration(&mut self, iterations: &Sequence, list: &Sequence, index: IndexId) -> Option<NodeId> {
        let first = (iterations.from != list.from)
            .then(|| self.graph.compare_index(Comparison::LessOrEqual, iterations.from, index));
        let last = (iterations.to != list.to).then(|| self.graph.compare_index(Comparison::Less, index, iterations.to));
        match (first, last) {
            (Some(first), Some(last)) => Some(self.graph.and(first, last)),
            (one, other) => one.or(other),
        }
    }

    /// The items of a sequence as a list, `.collect()`.
    pub(crate) fn collected(&mut self, items: &Expr) -> Option<Value> {
        let sequence = self.sequence(items)?;
        if sequence.filtered {
            let message = "collecting the items of a `filter` is not supported\nhelp: end it with \
                           `.sum::<f64>()`\nnote: the number of items that `filter` leaves is not known at compile \
                           time";
            self.errors.at(items, message);
            return None;
        }
        if sequence.literal {
            let iterations = self.few_iterations(&sequence, items)?;
            let parts = iterations.map(|iteration| {
                let index = self.literal_index(iteration);
                Some(self.item_of(&sequence, index)?.value)
            });
            return Some(Value::Array(parts.collect::<Option<_>>()?));
        }
        let captured = self.captured_by(items.to_token_stream());
        let (from, to) = (sequence.from, sequence.to);
        Some(Value::List(Sequence::new(from, to, move |reader, index| {
            reader.seeing(&captured, |reader| Some(reader.item_of(&sequence, index)?.value))
        })))
    }
}

/// The list that an array is after a loop that fills it.
fn filled(fill: &Rc<Fill>, place: usize) -> Sequence {
    let (fill, list) = (Rc::clone(fill), fill.arrays[place].1.clone());
    let (from, to) = (list.from, list.to);
    Sequence::new(from, to, move |reader, index| {
        let iteration = reader.has_iteration(&fill.sequence, &list, index);
        let element = reader.under(iteration, true, |reader| {
            reader.seeing(&fill.captured, |reader| reader.elements(&fill, index))?.into_iter().nth(place)
        })?;
        let Some(iteration) = iteration else { return Some(element) };
        let before = reader.under(Some(iteration), false, |reader| reader.item_of(&list, index))?;
        reader.either(iteration, element, before.value, &fill.arrays[place].0)
    })
}

/// Whether two values are the same numbers.
fn alike(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Real(a), Value::Real(b)) => a == b,
        (Value::Joint(a), Value::Joint(b)) => a.number == b.number,
        (Value::Array(a), Value::Array(b)) | (Value::Tuple(a), Value::Tuple(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| alike(a, b))
        }
        (Value::Opaque(a), Value::Opaque(b)) => a.text.to_string() == b.text.to_string(),
        _ => false,
    }
}

/// A body in which the elements of arrays at the index of the iteration are variables of the arrays' names.
struct Elements<'a> {
    arrays: &'a [(String, Sequence)],
    /// The names that the loop's pattern binds.
    iterations: &'a [String],
    /// The name that is the index.
    index: Option<Ident>,
    /// The arrays that were found, as they stand in the text.
    found: Vec<Ident>,
    /// Whether arrays are read and written in this way alone.
    sound: bool,
}

impl Elements<'_> {
    fn is_array(&self, name: &Ident) -> bool {
        self.arrays.iter().any(|(known, _)| name == known)
    }

    fn written(&mut self, text: TokenStream) -> TokenStream {
        let mut tokens = text.into_iter().peekable();
        let mut written = TokenStream::new();
        let mut is_field = false;
        while let Some(token) = tokens.next() {
            let dot = matches!(&token, TokenTree::Punct(mark) if mark.as_char() == '.');
            match &token {
                TokenTree::Ident(name) if self.is_array(name) && !is_field => {
                    let at = tokens.next_if(
                        |next| matches!(next, TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket),
                    );
                    self.read(name.clone(), at);
                    written.extend([token]);
                }
                TokenTree::Group(group) => {
                    let mut inner = Group::new(group.delimiter(), self.written(group.stream()));
                    inner.set_span(group.span());
                    written.extend([TokenTree::Group(inner)]);
                }
                _ => written.extend([token]),
            }
            is_field = dot;
        }
        written
    }

    /// Notes the index in brackets after an array.
    fn read(&mut self, array: Ident, at: Option<TokenTree>) {
        let index = match at {
            Some(TokenTree::Group(group)) => syn::parse2::<Ident>(group.stream()).ok(),
            _ => None,
        };
        let known = index.as_ref().is_some_and(|index| self.iterations.iter().any(|name| index == name));
        self.sound &= known && self.index.as_ref().is_none_or(|own| Some(own) == index.as_ref());
        self.index = index;
        self.found.push(array);
    }
}

/// `for x in array.iter_mut() { *x = ...; }` as `for k in 0..array.len() { array[k] = ...; }`, also where the array is
/// zipped with others or counted.
pub(crate) fn indexed_loop(repeat: &ExprForLoop) -> Option<ExprForLoop> {
    let mut repeat = repeat.clone();
    let mut known = Vec::new();
    identifiers(repeat.to_token_stream(), &mut known);
    let mut free = (1..).map(|count| if count == 1 { format_ident!("k") } else { format_ident!("k_{count}") });
    let index = free.find(|name| !known.contains(name))?;
    let (name, array) = changed_items(&mut repeat.expr, &mut repeat.pat, &index)?;
    let body = by_index(repeat.body.to_token_stream(), &name, &quote!(#array[#index]));
    repeat.body = syn::parse2(body).ok()?;
    Some(repeat)
}

/// The name of the items that may be changed, and the array that they are of; a range and an index take their places.
fn changed_items(sequence: &mut Expr, pattern: &mut Pat, index: &Ident) -> Option<(Ident, Ident)> {
    let array = match sequence {
        Expr::MethodCall(call) => match call.method.to_string().as_str() {
            "iter_mut" => simple_name(&call.receiver)?.clone(),
            "zip" => return changed_items(&mut call.receiver, part_of(pattern, 0)?, index),
            "enumerate" => return changed_items(&mut call.receiver, part_of(pattern, 1)?, index),
            _ => return None,
        },
        Expr::Reference(inner) if inner.mutability.is_some() => simple_name(&inner.expr)?.clone(),
        _ => return None,
    };
    let Pat::Ident(name) = pattern else { return None };
    let name = std::mem::replace(&mut name.ident, index.clone());
    *sequence = parse_quote!((0..#array.len()));
    Some((name, array))
}

/// A part of a pattern for a tuple.
fn part_of(pattern: &mut Pat, place: usize) -> Option<&mut Pat> {
    match pattern {
        Pat::Tuple(parts) => parts.elems.get_mut(place),
        _ => None,
    }
}

/// Text in which the items of an array, `*name` or `name` alone, are its elements by index.
fn by_index(text: TokenStream, name: &Ident, element: &TokenStream) -> TokenStream {
    let mut tokens = text.into_iter().peekable();
    let mut written = TokenStream::new();
    let mut is_field = false;
    while let Some(token) = tokens.next() {
        let dot = matches!(&token, TokenTree::Punct(mark) if mark.as_char() == '.');
        let starred = matches!(&token, TokenTree::Punct(mark) if mark.as_char() == '*');
        match token {
            // Of a reference that may be changed there is no product: the star is for what is behind it.
            _ if starred
                && tokens.peek().is_some_and(|next| matches!(next, TokenTree::Ident(next) if next == name)) => {}
            TokenTree::Ident(ref found) if found == name && !is_field => written.extend(element.clone()),
            TokenTree::Group(group) => {
                let mut inner = Group::new(group.delimiter(), by_index(group.stream(), name, element));
                inner.set_span(group.span());
                written.extend([TokenTree::Group(inner)]);
            }
            other => written.extend([other]),
        }
        is_field = dot;
    }
    written
}

/// `vec![value; length]` in a variable that changes, written so that its elements are computed where they are read.
pub(crate) fn declared_array(local: &Local) -> Option<Expr> {
    match &*local.init.as_ref()?.expr {
        Expr::Macro(called) if called.mac.path.is_ident("vec") && is_mutable(&local.pat) => {
            let inner = &called.mac.tokens;
            let array: ExprRepeat = syn::parse2(quote!([#inner])).ok()?;
            Some(Expr::Repeat(array))
        }
        _ => None,
    }
}

fn is_mutable(pattern: &Pat) -> bool {
    match pattern {
        Pat::Ident(name) => name.mutability.is_some(),
        Pat::Type(typed) => is_mutable(&typed.pat),
        _ => false,
    }
}
