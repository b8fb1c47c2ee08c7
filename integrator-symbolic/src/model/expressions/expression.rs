//! Expressions.

use crate::model::{
    Reader,
    code::{
        assigned::Assigned,
        escape::{CONTINUE, escape},
    },
    control::sides::Flow,
    parameters::text::{element, identifiers, is_reference, operand, place, with_variables},
    values::value::{Opaque, Value, View, is_list},
};
use crate::{
    errors::quoted,
    graph::{
        NodeId, Part,
        index::{Index, IndexId, LoopSet},
    },
    limits::{NESTED, OPERATIONS, READINGS},
};
use proc_macro2::{Ident, Span};
use quote::{ToTokens, quote};
use syn::{Expr, ExprArray, ExprField, ExprIndex, ExprLit, ExprPath, Lit, Macro, Member, visit::Visit};

/// How many elements an array of values may have.
const MANY: usize = 1024;

/// How arrays of values that differ are read.
const BY_LITERALS: &str = "this array of values does not support this index\nhelp: index it by literals, or in a loop \
                           of at most 16 iterations\nnote: an array filled by a loop, `for k in 0..32 { h[k] = ...; \
                           }`, supports any index";

impl Reader<'_> {
    /// The value of an expression; `None` if a mistake was noted in it.
    pub(crate) fn expression(&mut self, expression: &Expr) -> Option<Value> {
        self.readings += 1;
        if self.readings > READINGS || self.graph.len() > OPERATIONS {
            // Noted once: from here on every reading ends immediately.
            if self.readings <= READINGS + 1 {
                self.readings = READINGS + 1;
                let message =
                    format!("H has more than {OPERATIONS} different operations\nhelp: write what repeats as a loop");
                self.errors.at(expression, message);
            }
            return None;
        }
        if self.nested >= NESTED {
            self.readings = READINGS + 1;
            let message = format!(
                "expressions and their helper methods are nested more than {NESTED} levels deep\nhelp: name inner \
                 parts with `let`, or write a loop"
            );
            self.errors.at(expression, message);
            return None;
        }
        self.nested += 1;
        let value = self.expression_by_kind(expression);
        self.nested -= 1;
        value
    }

    fn expression_by_kind(&mut self, expression: &Expr) -> Option<Value> {
        match expression {
            Expr::Paren(inner) => self.grouped(&inner.expr),
            Expr::Reference(inner) if inner.mutability.is_none() => {
                self.expression(&inner.expr).map(Value::into_reference)
            }
            Expr::Block(inner) if inner.label.is_none() => self.block(&inner.block).map(Value::into_operand),
            Expr::Lit(literal) => self.literal(literal),
            Expr::Path(path) => self.path(path),
            Expr::Unary(unary) => self.unary(unary, expression),
            Expr::Binary(_) => self.chain(expression),
            Expr::Cast(cast) => self.cast(cast),
            Expr::Index(index) => self.index(index),
            Expr::Field(field) => self.field(field),
            Expr::Array(ExprArray { elems, .. }) => {
                let parts: Vec<_> = elems.iter().map(|part| self.expression(part)).collect();
                Some(Value::Array(parts.into_iter().collect::<Option<_>>()?))
            }
            Expr::Repeat(repeat) => {
                let (value, length) = (self.expression(&repeat.expr), self.expression(&repeat.len));
                let (value, length) = (value?, length?);
                let literal = self.integer(&length).and_then(|length| self.graph.loops.literal(length));
                match literal.and_then(|length| usize::try_from(length).ok()).filter(|length| *length <= MANY) {
                    Some(length) => Some(Value::Array(vec![value; length])),
                    None if literal.is_none() && matches!(length, Value::Integer(_) | Value::Opaque(_)) => {
                        self.repeated_to(value, &length)
                    }
                    None => {
                        let message = format!("the length of an array of values has to be a literal of at most {MANY}");
                        self.errors.at(&repeat.len, message);
                        None
                    }
                }
            }
            Expr::Closure(closure) => self.captured(closure),
            Expr::If(branch) => self.branch(branch, Flow::Value).map(|outcome| outcome.value),
            Expr::Match(whole) => {
                self.verbatim(expression).or_else(|| self.matched(whole, Flow::Value).map(|outcome| outcome.value))
            }
            Expr::Tuple(tuple) => {
                let parts: Vec<_> = tuple.elems.iter().map(|part| self.expression(part)).collect();
                Some(Value::Tuple(parts.into_iter().collect::<Option<_>>()?))
            }
            Expr::MethodCall(call) => self.method(call),
            Expr::Call(call) => self.call(call),
            Expr::Macro(called) if is_value(&called.mac) => {
                self.verbatim(expression).or_else(|| self.assertion(&called.mac))
            }
            Expr::Macro(called) => self.assertion(&called.mac),
            _ => self.verbatim(expression).or_else(|| self.refused(expression)),
        }
    }

    /// A value as a number; notes a mistake at `place` if it is none.
    pub(crate) fn number(&mut self, value: &Value, place: impl ToTokens) -> Option<NodeId> {
        let number = self.real(value);
        if number.is_none() {
            let message = match value {
                Value::Accumulating => {
                    "this variable is read in the loop that sums it\nhelp: read it after the loop".to_owned()
                }
                Value::Integer(index) => {
                    self.note_integer(*index, &place.to_token_stream());
                    return None;
                }
                Value::Unknown => return None,
                other => format!("expected an `f64`, found {}", other.describe()),
            };
            self.errors.at(place, message);
        }
        number
    }

    /// Parentheses stay around parameters, whose text is kept.
    fn grouped(&mut self, inner: &Expr) -> Option<Value> {
        self.expression(inner).map(Value::in_parentheses)
    }

    fn literal(&mut self, literal: &ExprLit) -> Option<Value> {
        let number = match &literal.lit {
            Lit::Float(number) => number.base10_parse::<f64>(),
            Lit::Int(number) if number.suffix() == "f64" => number.base10_parse::<f64>(),
            Lit::Int(number) => {
                let index = number.base10_parse().map_err(|error| self.errors.push(error)).ok()?;
                return Some(Value::Integer(self.graph.loops.intern(Index::Literal(index))));
            }
            other => {
                let text = other.to_token_stream();
                return Some(Value::Opaque(Opaque { text, loops: LoopSet::EMPTY }));
            }
        };
        let number = number.map_err(|error| self.errors.push(error)).ok()?;
        Some(Value::Real(self.graph.constant(number)))
    }

    /// A variable, or a constant of the surroundings.
    fn path(&mut self, path: &ExprPath) -> Option<Value> {
        let name = path.path.get_ident().filter(|_| path.qself.is_none());
        if let Some(name) = name {
            if let Some(id) = self.lookup(&name.to_string()) {
                return self.variable(name, self.bindings[id.0].value.clone());
            }
            let is_constant = name.to_string().chars().next().is_some_and(char::is_uppercase);
            if !is_constant && name != "self" {
                self.unknown_name(name);
                return None;
            }
        }
        Some(Value::Opaque(Opaque { text: path.to_token_stream(), loops: LoopSet::EMPTY }))
    }

    fn variable(&mut self, name: &Ident, value: Value) -> Option<Value> {
        match &value {
            Value::Unknown => return None,
            Value::Accumulating => {
                let message = format!("`{name}` is read in the loop that sums it\nhelp: read it after the loop");
                self.errors.at(name, message);
                return None;
            }
            _ => {}
        }
        Some(value.into_operand())
    }

    fn unknown_name(&mut self, name: &Ident) {
        let message = match name.to_string().as_str() {
            "p" if !self.may_mix => {
                "`p` is not known here\nhelp: move the terms with momenta to `kinetic`\nnote: V(q) is a function of \
                 the positions"
                    .to_owned()
            }
            "q" if !self.may_mix => {
                "`q` is not known here\nhelp: move the terms with positions to `potential`\nnote: T(p) is a function \
                 of the momenta"
                    .to_owned()
            }
            "pi" => "`pi` is not known here\nhelp: write `std::f64::consts::PI`".to_owned(),
            other => format!("`{other}` is not known here"),
        };
        self.errors.at(name, message);
        // One mistake, one message: from here on the name is known to be unknown.
        self.declare(name.to_string(), Value::Unknown);
    }

    fn index(&mut self, index: &ExprIndex) -> Option<Value> {
        if let Expr::Range(range) = &*index.index
            && let Some(part) = self.part_of_list(&index.expr, range)
        {
            return part.map(Value::List);
        }
        let (value, at) = (self.expression(&index.expr), self.expression(&index.index));
        let (value, at) = (value?, at?.into_own());
        if let Value::Opaque(list) = &value
            && (matches!(at, Value::Opaque(_) | Value::Tuple(_)) || is_reference(&index.index))
        {
            return self.element_at(list, &at, index);
        }
        let Some(position) = self.integer(&at) else {
            self.errors.at(&index.index, format!("an index has to be an integer, and this is {}", at.describe()));
            return None;
        };
        // The type of an index is `usize`.
        let position = self.graph.loops.unsigned(position);
        match value {
            Value::View(view) => self.coordinate(view, position, index),
            Value::Array(parts) => {
                if self.graph.loops.literal(position).is_none()
                    && let Some(Opaque { text, loops }) = self.list_text(&parts)
                {
                    let at = self.place_text(&Value::Integer(position))?;
                    let text = element(text, place(at.text), index.bracket_token.span.join());
                    return Some(Value::Opaque(Opaque { text, loops: loops.union(at.loops) }));
                }
                let literal = self.known(position);
                let part = literal.and_then(|literal| parts.get(usize::try_from(literal).ok()?));
                if literal.is_none()
                    && let Some(list) = self.as_list(&Value::Array(parts.clone()))
                {
                    return self.nth(&list, position);
                }
                if part.is_none() {
                    let message = match literal {
                        Some(_) => format!("the index is out of bounds for this array of {} elements", parts.len()),
                        None => format!("{BY_LITERALS}{}", self.unseen_bound()),
                    };
                    self.errors.at(&index.index, message);
                }
                part.cloned().map(Value::into_operand)
            }
            Value::Opaque(list) => self.element_at(&list, &Value::Integer(position), index),
            Value::List(part) => {
                let (count, literal) = (self.count_of_literal(&part), self.graph.loops.literal(position));
                let message = match literal.zip(count) {
                    Some((position, count)) if position >= count => {
                        format!("the index is out of bounds for this array of {count} elements")
                    }
                    None if part.literal => format!("{BY_LITERALS}{}", self.unseen_bound()),
                    _ => return self.nth(&part, position),
                };
                self.errors.at(&index.index, message);
                None
            }
            other => {
                let message = format!("{} cannot be indexed", other.describe());
                let message = self.several_sensitive(&other).unwrap_or(message);
                self.errors.at(&index.expr, message);
                None
            }
        }
    }

    /// An element of a list or of a map of the system: maps are read by a reference to any type.
    fn element_at(&mut self, list: &Opaque, at: &Value, index: &ExprIndex) -> Option<Value> {
        let found = match is_reference(&index.index) {
            true => self.argument(at, &index.index),
            false => self.place_text(at),
        };
        let Some(at) = found else {
            self.errors.at(&index.index, format!("an index has to be an integer, and this is {}", at.describe()));
            return None;
        };
        Some(Value::Opaque(Opaque {
            text: element(place(list.text.clone()), at.text, index.bracket_token.span.join()),
            loops: list.loops.union(at.loops),
        }))
    }

    /// An index into coordinates, compared with their bounds where both are known.
    fn coordinate(&mut self, view: View, position: IndexId, place: &ExprIndex) -> Option<Value> {
        let shape = self.shape.clone()?;
        let Some(extent) = shape.extent(view.at.len()) else {
            self.errors.at(place, "a coordinate is an `f64` and cannot be indexed");
            return None;
        };
        let upper = self.graph.loops.upper(position).and_then(|upper| self.graph.loops.literal(upper));
        if let (Some(length), Some(upper)) = (extent.literal(), upper)
            && upper >= length
            && !self.is_empty_loop(position)
            && !self.is_kept_below(position, length)
            && !self.stays_below(position, length)
        {
            let message = format!(
                "index {upper} is out of bounds for the coordinates `{}`\nnote: the last index here is {}",
                shape.text(),
                length.saturating_sub(1)
            );
            self.errors.at(&place.index, message);
            return None;
        }
        if self.foreign == Some(view.part) {
            self.foreign_read(&view, place);
        }
        Some(self.element(View { part: view.part, at: view.at.into_iter().chain([position]).collect() }))
    }

    /// Whether an index runs over nothing, so that its bounds say nothing.
    fn is_empty_loop(&self, position: IndexId) -> bool {
        let loops = &self.graph.loops;
        loops.of_index(position).iter().any(|by| {
            let range = loops.get(by);
            loops.literal(range.from).zip(loops.literal(range.to)).is_some_and(|(from, to)| from >= to)
        })
    }

    /// Notes that a function reads the other function's coordinates; a product that mixes both is noted elsewhere.
    fn foreign_read(&mut self, view: &View, place: &ExprIndex) {
        if !view.at.is_empty() {
            return;
        }
        let (letter, own, of, instead) = match view.part {
            Part::Momentum => ("p", "V(q)", "momentum", "kinetic"),
            Part::Position => ("q", "T(p)", "position", "potential"),
        };
        self.foreign_reads.push((
            place.expr.to_token_stream(),
            format!("{own} may not depend on the {of} `{letter}`\nhelp: move the terms in `{letter}` to `{instead}`"),
        ));
    }

    fn field(&mut self, field: &ExprField) -> Option<Value> {
        let value = self.expression(&field.base)?;
        match (value, &field.member) {
            (Value::Opaque(Opaque { text, loops }), member) => {
                let text = place(text);
                if let Some(number) = self.sensitive_field(&text, member) {
                    return Some(number);
                }
                Some(Value::Opaque(Opaque { text: quote!(#text.#member), loops }))
            }
            (Value::Tuple(parts), Member::Unnamed(position)) if (position.index as usize) < parts.len() => {
                Some(parts[position.index as usize].clone().into_operand())
            }
            (other, member) => {
                let cure = match member {
                    Member::Unnamed(position) if is_list(&other) => {
                        format!("\nhelp: write `{}[{}]`", quoted(&field.base), position.index)
                    }
                    _ => String::new(),
                };
                let message = format!("{} has no such field{cure}", other.describe());
                self.errors.at(member, self.several_sensitive(&other).unwrap_or(message));
                None
            }
        }
    }

    /// Any expression that mentions parameters and loop indices alone: it is evaluated once per run as it stands.
    pub(crate) fn verbatim(&mut self, expression: &Expr) -> Option<Value> {
        let mut assigned = Assigned::default();
        assigned.visit_expr(expression);
        if escape(expression).is_some() {
            return None;
        }
        if assigned.names.iter().any(|name| self.lookup(name).is_some()) {
            return None;
        }
        let text = expression.to_token_stream();
        let mut names = Vec::new();
        identifiers(text.clone(), &mut names);
        let (mut variables, mut loops) = (Vec::new(), LoopSet::EMPTY);
        for name in names {
            let Some(id) = self.lookup(&name.to_string()) else { continue };
            let value = self.bindings[id.0].value.clone();
            let Opaque { text, loops: mentioned } = self.opaque(&value)?;
            loops = loops.union(mentioned);
            variables.push((name, text));
        }
        Some(Value::Opaque(Opaque { text: with_variables(operand(text), &variables), loops }))
    }

    /// Notes an expression that is not supported.
    pub(crate) fn refused(&mut self, expression: &Expr) -> Option<Value> {
        let escape = escape(expression);
        let expression = escape.as_ref().unwrap_or(expression);
        let what = match expression {
            Expr::While(_) => "`while` loops are not supported\nhelp: write the sum as `for i in a..b`",
            Expr::Loop(_) => "`loop` is not supported\nhelp: write the sum as `for i in a..b`",
            Expr::Match(_) => "`match` on coordinates is not supported\nhelp: write `if ... else if ... else`",
            Expr::Return(_) => {
                "this `return` is not supported\nhelp: return in a branch of the function body, as in `if r > cutoff \
                 { return 0.0; }`\nnote: `return` inside a loop or an expression is not supported"
            }
            Expr::Unsafe(_) => "`unsafe` code with coordinates is not supported\nhelp: write plain indices",
            Expr::Break(_) => {
                "`break` is not supported\nhelp: shorten the range of the loop, or wrap the added term \
                               in `if`"
            }
            Expr::Continue(_) => CONTINUE,
            Expr::Try(_) => {
                "`?` is not supported\nhelp: return an energy in every case\nnote: the force of an early \
                             exit is not defined"
            }
            Expr::Reference(_) => "`&mut` is not supported\nhelp: assign to the variable itself",
            Expr::ForLoop(_) => "a loop has no value\nhelp: sum into a `let mut` variable",
            _ => {
                "this expression with coordinates is not supported\nnote: supported are arithmetic, methods of `f64`, \
                 helper methods of this impl, `let`, `if` and `for i in a..b`"
            }
        };
        match keyword(expression) {
            Some(span) => self.errors.at_span(span, what),
            None => self.errors.at(expression, what),
        }
        None
    }
}

/// The keyword at fault, where what follows it may be many lines long.
fn keyword(expression: &Expr) -> Option<Span> {
    match expression {
        Expr::While(repeat) => Some(repeat.while_token.span),
        Expr::Loop(repeat) => Some(repeat.loop_token.span),
        Expr::ForLoop(repeat) => Some(repeat.for_token.span),
        Expr::Match(choice) => Some(choice.match_token.span),
        Expr::Unsafe(block) => Some(block.unsafe_token.span),
        Expr::Try(attempt) => Some(attempt.question_token.span),
        _ => None,
    }
}

/// Whether a macro gives a value, which may be made of parameters.
fn is_value(called: &Macro) -> bool {
    called.path.is_ident("matches") || called.path.is_ident("vec")
}
