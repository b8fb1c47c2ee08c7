//! Adaptors that transform a sequence item by item: `map`, `filter`, `zip`, `windows` and the others.

use crate::graph::index::Index;
use crate::model::{
    Reader,
    loops::sequence::{ADAPTED, FEW},
    values::value::{Item, Sequence, Value},
};
use proc_macro2::Ident;
use quote::ToTokens;
use std::rc::Rc;
use syn::{
    Expr, ExprMethodCall, ExprRange, GenericArgument, Pat, PatParen, PatReference, PatType, Type, parse_quote,
    punctuated::Punctuated,
};

impl Reader<'_> {
    /// A sequence whose items are taken apart by a pattern.
    pub(crate) fn sequence_of(&mut self, sequence: &Expr, item: Option<&Pat>) -> Option<Sequence> {
        match sequence {
            Expr::MethodCall(call) if call.method == "array_windows" && call.args.is_empty() => {
                let sized = sized_windows(call, item);
                self.sequence(sized.as_ref().unwrap_or(sequence))
            }
            _ => self.sequence(sequence),
        }
    }

    /// `sequence.map(...)`, `.enumerate()` and so on.
    pub(crate) fn adapted(&mut self, call: &ExprMethodCall) -> Option<Sequence> {
        let item = match call.args.first() {
            Some(Expr::Closure(closure)) => closure.inputs.first(),
            _ => None,
        };
        if call.method == "zip"
            && let (Some(first), Some(second)) = (endless(&call.receiver), call.args.first())
        {
            let other = self.sequence(second)?;
            let base = self.endless(first, &other)?;
            return self.pairs(base, other, second);
        }
        let base = self.sequence_of(&call.receiver, item)?;
        let Sequence { from, to, ref at, filtered, literal } = base;
        let at = Rc::clone(at);
        let name = call.method.to_string();
        if filtered && !matches!(name.as_str(), "map" | "filter" | "copied" | "cloned" | "iter" | "into_iter") {
            let message = format!(
                "`{name}` after `filter` is not supported\nhelp: put `filter` last\nnote: the \
                                   number of items that `filter` leaves is not known at compile time"
            );
            self.errors.at(&call.method, message);
            return None;
        }
        match (name.as_str(), call.args.first()) {
            ("iter", None) => Some(base.of_references()),
            ("copied" | "cloned", None) => Some(base.with(Value::into_place)),
            ("into_iter" | "by_ref", None) => Some(base),
            ("map", Some(closure)) => {
                let closure = self.closure(closure, 1)?;
                let at = move |reader: &mut Reader<'_>, index| {
                    let Item { value, condition } = at(reader, index)?;
                    let value = reader.under(condition, true, |reader| reader.applied(&closure, vec![value]));
                    Some(Item { value: value?, condition })
                };
                Some(Sequence { from, to, at: Rc::new(at), filtered, literal })
            }
            ("filter", Some(closure)) => {
                let closure = self.closure(closure, 1)?;
                let at = move |reader: &mut Reader<'_>, index| {
                    let Item { value, condition } = at(reader, index)?;
                    let kept = reader.under(condition, true, |reader| {
                        let kept = reader.applied(&closure, vec![value.clone()])?;
                        reader.condition(&kept)
                    })?;
                    let condition = match condition {
                        Some(condition) => reader.graph.and(condition, kept),
                        None => kept,
                    };
                    Some(Item { value, condition: Some(condition) })
                };
                Some(Sequence { from, to, at: Rc::new(at), filtered: true, literal })
            }
            ("enumerate", None) => {
                let at = move |reader: &mut Reader<'_>, index| {
                    let Item { value, .. } = at(reader, index)?;
                    let position = reader.graph.loops.intern(Index::Sub(index, from));
                    Some(Item::plain(Value::Tuple(vec![Value::Integer(position), value])))
                };
                Some(Sequence { from, to, at: Rc::new(at), filtered, literal })
            }
            ("rev", None) => {
                let at = move |reader: &mut Reader<'_>, index| {
                    let (sum, one) = (reader.graph.loops.intern(Index::Add(from, to)), reader.literal_index(1));
                    let last = reader.graph.loops.intern(Index::Sub(sum, one));
                    let mirrored = reader.graph.loops.intern(Index::Sub(last, index));
                    at(reader, mirrored)
                };
                Some(Sequence { from, to, at: Rc::new(at), filtered, literal })
            }
            ("zip", Some(place)) => {
                let other = match endless(place) {
                    Some(endless) => self.endless(endless, &base)?,
                    None => self.sequence(place)?,
                };
                self.pairs(base, other, place)
            }
            ("skip", Some(count)) => {
                let count = self.bound(count)?;
                let from = self.graph.loops.intern(Index::Add(from, count));
                Some(Sequence { from, ..base })
            }
            ("take", Some(count)) => {
                let count = self.bound(count)?;
                let end = self.graph.loops.intern(Index::Add(from, count));
                let to = self.graph.loops.intern(Index::Min(to, end));
                Some(Sequence { to, ..base })
            }
            ("step_by", Some(stride)) => self.strided(base, stride),
            ("windows" | "chunks_exact", Some(size)) => self.grouped_items(base, size, name == "windows"),
            ("cycle", None) => {
                let message = "`cycle` is supported only in the argument of a `zip`\nhelp: write, for example, \
                               `q.iter().zip(q.iter().cycle().skip(1))`\nnote: `cycle` never ends, so the other \
                               sequence has to";
                self.errors.at(&call.method, message);
                None
            }
            ("chunks", Some(size)) if self.divides(size, &base) => self.grouped_items(base, size, false),
            ("chunks", Some(_)) => {
                let message = "`chunks` is not supported\nhelp: write `chunks_exact`, which leaves out an incomplete \
                               last chunk\nnote: the last item of `chunks` may have fewer elements than the others";
                self.errors.at(&call.method, message);
                None
            }
            ("array_windows", None) => {
                let message = "the length of these windows is not known\nhelp: write `array_windows::<2>()`, or a \
                               pattern where the window is used, as in `.map(|[a, b]| ..)`";
                self.errors.at(&call.method, message);
                None
            }
            _ => {
                let message = format!("`{name}` is not supported\nnote: the supported adaptors are {ADAPTED}");
                self.errors.at(&call.method, message);
                None
            }
        }
    }

    /// Pairs of items, as many as the shorter sequence has. The index is the first sequence's.
    fn pairs(&mut self, base: Sequence, other: Sequence, place: &Expr) -> Option<Sequence> {
        if other.filtered {
            let message = "`filter` inside `zip` is not supported\nhelp: put `filter` after `zip`, or write a loop \
                           with an `if`\nnote: the number of items that `filter` leaves is not known at compile time";
            self.errors.at(place, message);
            return None;
        }
        let loops = &mut self.graph.loops;
        let count = loops.span(other.from, other.to);
        let end = loops.intern(Index::Add(base.from, count));
        let to = loops.intern(Index::Min(base.to, end));
        let (from, others_from, literal) = (base.from, other.from, base.literal || other.literal);
        let at = move |reader: &mut Reader<'_>, index| {
            let others = reader.graph.loops.shifted(index, from, others_from);
            let (a, b) = (reader.item_of(&base, index)?, reader.item_of(&other, others)?);
            Some(Item::plain(Value::Tuple(vec![a.value, b.value])))
        };
        Some(Sequence { from, to, at: Rc::new(at), filtered: false, literal })
    }

    /// As many items of a sequence without an end as another one has.
    fn endless(&mut self, endless: Endless<'_>, like: &Sequence) -> Option<Sequence> {
        let count = self.count_of(like);
        let (items, skipped) = match endless {
            Endless::From(start) => {
                let from = self.bound(start)?;
                let to = self.graph.loops.intern(Index::Add(from, count));
                return Some(self.integers(from, to));
            }
            Endless::Cycle { items, skipped } => (items, skipped),
        };
        let base = self.sequence(items)?;
        if base.filtered {
            let message = "`cycle` after `filter` is not supported\nhelp: put `filter` after `zip`, or write a loop \
                           with an `if`\nnote: the number of items that `filter` leaves is not known at compile time";
            self.errors.at(items, message);
            return None;
        }
        let from = match skipped {
            Some(count) => self.bound(count)?,
            None => self.literal_index(0),
        };
        let length = self.count_of(&base);
        let to = self.graph.loops.intern(Index::Add(from, count));
        let literal = base.literal;
        let at = move |reader: &mut Reader<'_>, index| {
            let position = reader.graph.loops.intern(Index::Rem(index, length));
            let position = reader.graph.loops.intern(Index::Add(base.from, position));
            reader.item_of(&base, position)
        };
        Some(Sequence { from, to, at: Rc::new(at), filtered: false, literal })
    }

    /// Every `n`th item, counted from the first.
    fn strided(&mut self, base: Sequence, stride: &Expr) -> Option<Sequence> {
        let stride = self.bound(stride)?;
        let zero = self.literal_index(0);
        let loops = &mut self.graph.loops;
        let length = loops.span(base.from, base.to);
        let one = loops.intern(Index::Literal(1));
        let less = loops.intern(Index::Sub(stride, one));
        let rounded = loops.intern(Index::Add(length, less));
        let count = loops.intern(Index::Div(rounded, stride));
        let literal = base.literal;
        let at = move |reader: &mut Reader<'_>, index| {
            let distance = reader.graph.loops.intern(Index::Mul(index, stride));
            let position = reader.graph.loops.intern(Index::Add(base.from, distance));
            reader.item_of(&base, position)
        };
        Some(Sequence { from: zero, to: count, at: Rc::new(at), filtered: false, literal })
    }

    /// Whether a number of items is known to divide that of a sequence.
    fn divides(&mut self, size: &Expr, base: &Sequence) -> bool {
        let size = match size {
            Expr::Lit(literal) => literal.to_token_stream().to_string().parse().ok(),
            _ => None,
        };
        let count = self.count_of_literal(base);
        size.zip(count).is_some_and(|(size, count): (u64, u64)| size > 0 && count.is_multiple_of(size))
    }

    /// Neighbouring items as arrays, or as parts of the sequence if these are long: overlapping windows, or chunks one after the
    /// other.
    fn grouped_items(&mut self, base: Sequence, size: &Expr, windows: bool) -> Option<Sequence> {
        let width = self.bound(size)?;
        let Some(count) = self.graph.loops.literal(width).filter(|count| (1..=64).contains(count)) else {
            self.errors.at(size, "the length of a group has to be a literal between 1 and 64");
            return None;
        };
        let zero = self.literal_index(0);
        let less = self.literal_index(count - 1);
        let loops = &mut self.graph.loops;
        let length = loops.span(base.from, base.to);
        let to = loops.intern(if windows { Index::Monus(length, less) } else { Index::Div(length, width) });
        let literal = base.literal;
        let at = move |reader: &mut Reader<'_>, index| {
            let first = if windows { index } else { reader.graph.loops.intern(Index::Mul(index, width)) };
            if count > FEW && !base.literal {
                let (base, before) = (base.clone(), reader.graph.loops.intern(Index::Add(base.from, first)));
                let at = move |reader: &mut Reader<'_>, index| {
                    let position = reader.graph.loops.intern(Index::Add(before, index));
                    reader.item_of(&base, position)
                };
                let group = Sequence { from: zero, to: width, at: Rc::new(at), filtered: false, literal: false };
                return Some(Item::plain(Value::List(group)));
            }
            let parts = (0..count).map(|position| {
                let position = reader.offset(first, position);
                let position = reader.graph.loops.intern(Index::Add(base.from, position));
                reader.item_of(&base, position).map(|item| item.value)
            });
            Some(Item::plain(Value::Array(parts.collect::<Option<_>>()?)))
        };
        Some(Sequence { from: zero, to, at: Rc::new(at), filtered: false, literal })
    }
}

/// A sequence without an end.
enum Endless<'e> {
    /// `items.cycle()`, after some of its items.
    Cycle { items: &'e Expr, skipped: Option<&'e Expr> },
    /// `start..`
    From(&'e Expr),
}

fn endless(sequence: &Expr) -> Option<Endless<'_>> {
    let call = match sequence {
        Expr::Paren(inner) => return endless(&inner.expr),
        Expr::Range(ExprRange { start: Some(start), end: None, .. }) => return Some(Endless::From(start)),
        Expr::MethodCall(call) => call,
        _ => return None,
    };
    let cycle = |call: &'_ ExprMethodCall| call.method == "cycle" && call.args.is_empty();
    match &*call.receiver {
        items if cycle(call) => Some(Endless::Cycle { items, skipped: None }),
        Expr::MethodCall(inner) if call.method == "skip" && cycle(inner) => {
            Some(Endless::Cycle { items: &inner.receiver, skipped: call.args.first() })
        }
        _ => None,
    }
}

/// `list.array_windows()` as `list.windows(n)`, with the number of a window's items from `array_windows::<n>()` or from the
/// pattern that takes them apart.
fn sized_windows(call: &ExprMethodCall, item: Option<&Pat>) -> Option<Expr> {
    let size: Expr = match (&call.turbofish, item) {
        (Some(turbofish), _) => match turbofish.args.first()? {
            GenericArgument::Const(size) => size.clone(),
            GenericArgument::Type(Type::Path(name)) => parse_quote!(#name),
            _ => return None,
        },
        (None, Some(Pat::Slice(items))) => {
            let count = items.elems.len();
            parse_quote!(#count)
        }
        (None, Some(Pat::Reference(PatReference { pat, .. }) | Pat::Paren(PatParen { pat, .. }))) => {
            return sized_windows(call, Some(pat));
        }
        (None, Some(Pat::Type(PatType { pat, .. }))) => return sized_windows(call, Some(pat)),
        (None, _) => return None,
    };
    let method = Ident::new("windows", call.method.span());
    let args = Punctuated::from_iter([size]);
    Some(Expr::MethodCall(ExprMethodCall { method, turbofish: None, args, ..call.clone() }))
}
