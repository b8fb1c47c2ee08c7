//! Operators: signs, arithmetic, comparisons and casts.

use crate::graph::{
    NodeId, Part,
    index::{Index, IndexId},
};
use crate::model::{
    NOT_SEPARABLE, Reader,
    code::{assigned::simple_name, shape::integer_type},
    expressions::{
        cure::{Power, by_components, power_by_exclusive_or, power_by_operator},
        types::is_collected,
    },
    parameters::text::{bare, mentions_item, place, referent},
    values::{
        integer::Own,
        value::{Joint, Opaque, Value},
    },
};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{BinOp, Expr, ExprCast, ExprUnary, UnOp};

impl Reader<'_> {
    pub(crate) fn unary(&mut self, unary: &ExprUnary, whole: &Expr) -> Option<Value> {
        match &unary.op {
            UnOp::Deref(_) => {
                let value = self.expression(&unary.expr)?;
                Some(dereferenced(value, &unary.expr))
            }
            UnOp::Neg(_) => match self.operand_of_own_type(&unary.expr)?.into_place() {
                Value::Opaque(Opaque { text, loops }) => Some(Value::Opaque(Opaque { text: quote!(-#text), loops })),
                Value::Joint(Joint { number, own: Opaque { text, loops } }) => {
                    let number = self.graph.neg(number);
                    Some(Self::joint(number, Some(Opaque { text: quote!(-#text), loops })))
                }
                Value::Integer(index) => {
                    let zero = self.literal_index(0);
                    Some(Value::Integer(self.graph.loops.intern(Index::Minus(zero, index))))
                }
                value => {
                    let number = self.number(&value, &unary.expr)?;
                    Some(Value::Real(self.graph.neg(number)))
                }
            },
            UnOp::Not(_) => match self.expression(&unary.expr)?.into_place().into_own() {
                Value::Opaque(Opaque { text, loops }) => Some(Value::Opaque(Opaque { text: quote!(!#text), loops })),
                value => match self.condition(&value) {
                    Some(condition) => Some(Value::Condition(self.graph.not(condition))),
                    None => self.refused(whole),
                },
            },
            _ => self.verbatim(whole).or_else(|| self.refused(whole)),
        }
    }

    /// Operators. A long chain `a + b + c + ...` leans to the left, so it is walked down and read upwards: the depth of
    /// the reader does not grow with the number of terms.
    pub(crate) fn chain(&mut self, expression: &Expr) -> Option<Value> {
        let mut links = Vec::new();
        let mut innermost = expression;
        while let Expr::Binary(link) = innermost {
            links.push((link, innermost));
            innermost = &link.left;
        }
        let mut value = self.expression(innermost);
        if let Some((link, _)) = links.last() {
            self.note_operand(&link.op, value.as_ref(), innermost);
        }
        for (link, whole) in links.into_iter().rev() {
            // The second of two conditions is tested after the first.
            let first = value.as_ref().filter(|_| matches!(link.op, BinOp::And(_) | BinOp::Or(_))).cloned();
            let first = first.and_then(|first| self.condition(&first));
            let holds = matches!(link.op, BinOp::And(_));
            if let Some(known) = first.filter(|_| self.is_known(first, !holds)) {
                value = Some(Value::Condition(known));
                continue;
            }
            if let Some(Power { place, message }) = power_by_operator(link)
                && (matches!(link.op, BinOp::Mul(_)) || self.verbatim(whole).is_none())
            {
                self.errors.at(place, message);
                value = None;
                continue;
            }
            let right = self.under(first, holds, |reader| reader.expression(&link.right));
            self.note_operand(&link.op, right.as_ref(), &link.right);
            value = match (value, right) {
                (Some(left), Some(right)) => self.combine(&link.op, left, right, &link.left, &link.right, whole),
                _ => None,
            };
        }
        value
    }

    /// Notes where a value stands that is added or subtracted, for what is said of a part without an exact flow.
    pub(crate) fn note_addend(&mut self, value: &Value, place: &Expr) {
        if let Value::Real(addend) | Value::Joint(Joint { number: addend, .. }) = value
            && self.may_mix
        {
            let addend = self.graph.without_sign(*addend);
            self.addends.entry(addend).or_insert_with(|| place.to_token_stream());
        }
    }

    /// The same of a side of an operator.
    pub(crate) fn note_operand(&mut self, op: &BinOp, value: Option<&Value>, place: &Expr) {
        if matches!(op, BinOp::Add(_) | BinOp::Sub(_) | BinOp::AddAssign(_) | BinOp::SubAssign(_)) {
            value.into_iter().for_each(|value| self.note_addend(value, place));
        }
    }

    /// Whether an integer, which varies with a loop, is compared with the end of that loop, as in `i + 1 == self.n`. Such
    /// comparisons are of indices, so that it is known in which iterations they hold.
    fn is_at_end(&self, value: &Value, end: &Value) -> bool {
        let (Value::Integer(index), Value::Opaque(end)) = (value, end) else { return false };
        let (loops, end) = (&self.graph.loops, bare(place(end.text.clone())).to_string());
        let mut around = loops.of_index(*index).iter();
        around.any(|by| match loops.index(loops.get(by).to) {
            Index::Parameter(id) => self.parameters[id.0 as usize].own.to_string() == end,
            _ => false,
        })
    }

    /// `left op right`
    pub(crate) fn combine(
        &mut self,
        op: &BinOp,
        left: Value,
        right: Value,
        left_place: &Expr,
        right_place: &Expr,
        whole: &Expr,
    ) -> Option<Value> {
        let is_arithmetic = matches!(op, BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_) | BinOp::Rem(_));
        let [mut left, mut right] = Self::sides(left.into_place(), right.into_place(), is_arithmetic);
        if !is_arithmetic {
            if self.own_types(&left, &right) {
                [left, right] = [left, right].map(|value| self.opaque(&value).map_or(value, Value::Opaque));
            }
            let literals =
                matches!((&left, &right), (Value::Integer(_) | Value::Real(_), Value::Integer(_) | Value::Real(_)));
            let is_at_end = is_condition(op) && (self.is_at_end(&left, &right) || self.is_at_end(&right, &left));
            if let (Some(left), Some(right)) = (self.opaque(&left), self.opaque(&right))
                && !literals
                && !is_at_end
            {
                return Some(Value::Opaque(joined(&left, op, &right)));
            }
            if is_condition(op) {
                return self.compared(op, &left, &right, (left_place, right_place));
            }
            if let (BinOp::BitXor(_), Expr::Binary(link)) = (op, whole)
                && matches!(left, Value::Real(_) | Value::Joint(_))
            {
                let Power { place, message } = power_by_exclusive_or(link);
                self.errors.at(place, message);
                return None;
            }
            if let Some(index) = self.of_bits(op, &left, &right) {
                return Some(Value::Integer(index));
            }
            return if self.refuses_bits(op, [&left, &right], whole) { None } else { self.refused(whole) };
        }
        let literal_only = |value: &Value| matches!(value, Value::Real(_));
        match (&left, &right) {
            (Value::Integer(_), Value::Integer(_) | Value::Opaque(_)) | (Value::Opaque(_), Value::Integer(_)) => {
                return self.of_integers(op, &left, &right);
            }
            // Text of parameters stays text, unless it would join the indices of different loops into one table.
            _ if !(literal_only(&left) && literal_only(&right)) => {
                if let (Some(a), Some(b)) = (self.opaque(&left), self.opaque(&right))
                    && (a.loops.is_subset(b.loops) || b.loops.is_subset(a.loops))
                {
                    return Some(Value::Opaque(joined(&a, op, &b)));
                }
            }
            _ => {}
        }
        let own = match [&left, &right].map(|side| matches!(side, Value::Opaque(_) | Value::Joint(_))) {
            [true, true] => self.own_of(&left).zip(self.own_of(&right)).map(|(a, b)| joined(&a, op, &b)),
            _ => None,
        };
        if let Some(message) = self.of_components(op, [&left, &right], [left_place, right_place]) {
            self.errors.at(whole, message);
            return None;
        }
        let (a, b) = (self.operand(&left, left_place), self.operand(&right, right_place));
        let (a, b) = (a?, b?);
        if self.input.coordinates.is_some() && matches!(op, BinOp::Add(_) | BinOp::Sub(_)) {
            for (addend, place) in [(a, left_place), (b, right_place)] {
                self.addends.entry(self.graph.without_sign(addend)).or_insert_with(|| place.to_token_stream());
            }
        }
        let mixes = match op {
            BinOp::Mul(_) => self.mixes(a, b),
            BinOp::Div(_) => self.mixes(a, b) || self.is_mixed(b),
            BinOp::Rem(_) => self.mixes(a, b) || self.is_mixed(a) || self.is_mixed(b),
            _ => false,
        };
        if mixes {
            self.not_separable(whole);
            return None;
        }
        let number = match op {
            BinOp::Add(_) => self.graph.add(a, b),
            BinOp::Sub(_) => self.graph.sub(a, b),
            BinOp::Mul(_) => self.graph.mul(a, b),
            BinOp::Div(_) => self.graph.div(a, b),
            _ => self.graph.call_two("remainder", a, b),
        };
        Some(Self::joint(number, own))
    }

    /// What to write for an operation on points or arrays, which Rust does not have.
    fn of_components(&self, op: &BinOp, sides: [&Value; 2], places: [&Expr; 2]) -> Option<String> {
        let count = |side: &Value| match side {
            Value::View(view) if view.at.len() == 1 => self.shape.as_ref()?.dimension()?.literal(),
            Value::Array(parts) => Some(parts.len() as u64),
            _ => None,
        };
        let counts = sides.map(count);
        let is_array = |side: &Value| match side {
            Value::View(view) => !view.at.is_empty(),
            Value::Array(_) => true,
            // Whether a parameter is an array is not known: only an array can be added to one.
            Value::Opaque(_) => matches!(op, BinOp::Add(_) | BinOp::Sub(_)),
            _ => false,
        };
        let has_array = sides.iter().any(|side| !matches!(side, Value::Opaque(_)) && is_array(side));
        has_array.then(|| by_components(op, places, sides.map(is_array), counts[0].or(counts[1])))
    }

    fn operand_of_own_type(&mut self, operand: &Expr) -> Option<Value> {
        let value = self.expression(operand)?;
        Some(self.of_own_type(value))
    }

    /// An operation on two integers, one of which may be text.
    fn of_integers(&mut self, op: &BinOp, left: &Value, right: &Value) -> Option<Value> {
        let own = self.own_types(left, right).then(|| self.opaque(left).zip(self.opaque(right)));
        let own = own.flatten().map(|(a, b)| joined(&a, op, &b));
        // What has a type that a cast names is no index: it is one where another cast makes it one.
        let is_named = |value: &Value| matches!(self.type_of(value), Own::Named(_));
        if (is_named(left) || is_named(right))
            && let Some(own) = own
        {
            return Some(Value::Opaque(own));
        }
        let (a, b) = (self.integer(left)?, self.integer(right)?);
        let index = self.integer_operation(op, a, b);
        if let Some(Opaque { text, loops }) = own
            && self.graph.loops.literal(index).is_none()
        {
            self.own_integers.insert(index, Opaque { text: quote!((#text)), loops });
        }
        Some(Value::Integer(index))
    }

    /// Whether the system gives the type of one of two integers, and with it that of both.
    fn own_types(&self, left: &Value, right: &Value) -> bool {
        let is_own = |value: &Value| match value {
            Value::Integer(index) => self.own_integers.contains_key(index),
            value => matches!(value, Value::Opaque(_)),
        };
        let is_usize = |value: &Value| matches!(self.type_of(value), Own::Usize);
        (is_own(left) || is_own(right)) && !is_usize(left) && !is_usize(right)
    }

    /// An integer that is made of those of the system and of literals, as text: where it is no index, it has the type that the
    /// system gives it.
    pub(crate) fn of_own_type(&self, value: Value) -> Value {
        match value {
            Value::Integer(index) => match self.own_integers.get(&index) {
                Some(own) => Value::Opaque(own.clone()),
                None => value,
            },
            other => other,
        }
    }

    /// One where a condition holds, zero elsewhere.
    pub(crate) fn truth_as_number(&mut self, condition: NodeId) -> NodeId {
        let (one, zero) = (self.graph.constant(1.0), self.graph.constant(0.0));
        self.graph.select(condition, one, zero)
    }

    fn integer_operation(&mut self, op: &BinOp, a: IndexId, b: IndexId) -> IndexId {
        self.graph.loops.intern(match op {
            BinOp::Add(_) => Index::Add(a, b),
            BinOp::Sub(_) => return self.graph.loops.minus(a, b),
            BinOp::Mul(_) => Index::Mul(a, b),
            BinOp::Div(_) => Index::Div(a, b),
            _ => Index::Rem(a, b),
        })
    }

    /// Whether a number depends on positions and on momenta, where nothing may.
    pub(crate) fn is_mixed(&self, id: NodeId) -> bool {
        !self.may_mix && self.graph.is_mixed(id)
    }

    /// Whether two factors depend on positions and momenta together, and both of them on some, where nothing may.
    pub(crate) fn mixes(&self, a: NodeId, b: NodeId) -> bool {
        let [a, b] = [a, b].map(|id| [Part::Position, Part::Momentum].map(|part| self.graph.reads(id, part)));
        let both = (0..2).all(|part| a[part] || b[part]);
        !self.may_mix && both && a.contains(&true) && b.contains(&true)
    }

    /// Notes that the Hamiltonian is not separable.
    pub(crate) fn not_separable(&mut self, place: &Expr) {
        self.misplaced = true;
        self.errors.at(place, NOT_SEPARABLE);
    }

    pub(crate) fn cast(&mut self, cast: &ExprCast) -> Option<Value> {
        let value = self.operand_of_own_type(&cast.expr)?.into_own();
        let to_float = crate::model::code::shape::is_f64(&cast.ty);
        match (value, integer_type(&cast.ty)) {
            (Value::Integer(index), _) if to_float => Some(Value::Real(self.graph.number_of(index))),
            (Value::Integer(index), Some(kind)) => Some(Value::Integer(self.graph.loops.cast(index, kind))),
            (Value::Real(number), _) if to_float => Some(Value::Real(number)),
            (Value::Condition(condition), _) if to_float => Some(Value::Real(self.truth_as_number(condition))),
            // One or zero, whatever the integer's type.
            (Value::Condition(condition), Some(_)) => Some(Value::Condition(condition)),
            (value, _) => match self.opaque(&value) {
                Some(Opaque { text, loops }) => {
                    let kind = &cast.ty;
                    Some(Value::Opaque(Opaque { text: quote!((#text as #kind)), loops }))
                }
                None => {
                    let message =
                        format!("{} cannot be cast here\nnote: energies are computed in `f64`", value.describe());
                    self.errors.at(cast, message);
                    None
                }
            },
        }
    }
}

/// `*value`
fn dereferenced(value: Value, place: &Expr) -> Value {
    let Value::Opaque(Opaque { text, loops }) = value else { return value };
    let text = match referent(&text) {
        Some(text) => text,
        // An item of a list is a reference or not, as the list is: the text reads it where it lies.
        None if is_variable(place) && mentions_item(&text) && !is_collected_item(&text) => text,
        None => quote!((*#text)),
    };
    Value::Opaque(Opaque { text, loops })
}

fn is_collected_item(text: &TokenStream) -> bool {
    syn::parse2(text.clone()).is_ok_and(|item| is_collected(&item))
}

/// Whether an expression is a variable, or what a variable refers to.
fn is_variable(expression: &Expr) -> bool {
    match expression {
        Expr::Unary(ExprUnary { op: UnOp::Deref(_), expr, .. }) => is_variable(expr),
        Expr::Paren(inner) => is_variable(&inner.expr),
        other => simple_name(other).is_some_and(|name| name != "self"),
    }
}

/// Whether an operator makes a condition.
fn is_condition(op: &BinOp) -> bool {
    let compares =
        matches!(op, BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_) | BinOp::Eq(_) | BinOp::Ne(_));
    compares || matches!(op, BinOp::And(_) | BinOp::Or(_))
}

fn joined(left: &Opaque, op: &BinOp, right: &Opaque) -> Opaque {
    let (a, b) = (&left.text, &right.text);
    Opaque { text: quote!(#a #op #b), loops: left.loops.union(right.loops) }
}
