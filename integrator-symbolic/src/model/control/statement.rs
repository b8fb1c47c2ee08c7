//! Blocks and assignments.

use crate::model::{
    Binding, BindingId, Reader, Target,
    code::{
        assigned::{Assigned, addend, is_assignment, root_name, simple_name},
        escape::{Skip, is_skip_unless},
    },
    control::sides::{Body, Flow},
    loops::{
        fill::declared_array,
        sequence::{FEW, is_adaptor},
    },
    values::value::Value,
};
use crate::{errors::quoted, graph::NodeId};
use proc_macro2::Ident;
use quote::format_ident;
use std::collections::HashMap;
use syn::{
    BinOp, Block, Expr, ExprAssign, ExprBinary, ExprIndex, ExprUnary, Item, Local, Macro, Pat, Stmt, UnOp, parse_quote,
    visit::Visit,
};

/// How elements of arrays are assigned.
const BY_INDEX: &str = "this assignment to an element of an array is not supported\nhelp: assign at literal indices, \
                        in a loop of a few iterations, or at the index of the loop, `for k in 0..32 { h[k] = ...; \
                        }`\nnote: the loop over the elements may contain other loops";

impl Reader<'_> {
    /// The value of a block; `None` if a mistake was noted in it.
    pub(crate) fn block(&mut self, block: &Block) -> Option<Value> {
        self.inner(&block.stmts)
    }

    /// The value of the last of some statements in a scope of their own.
    pub(crate) fn inner(&mut self, statements: &[Stmt]) -> Option<Value> {
        self.scopes.push(HashMap::new());
        let value = self.statements(statements);
        self.scopes.pop();
        value
    }

    /// The value of the last statement, if it is an expression without semicolon.
    pub(crate) fn statements(&mut self, statements: &[Stmt]) -> Option<Value> {
        let mut value = Some(Value::Unit);
        let mut sound = true;
        for (position, statement) in statements.iter().enumerate() {
            let rest = &statements[position + 1..];
            if let Some(skip) = Skip::of(statement) {
                return self.skipped(skip, rest).filter(|_| sound);
            }
            if let Some((pattern, value)) = is_skip_unless(statement) {
                let outcome = self.let_else(pattern, value, Body::Nothing, rest, Flow::Value, statement);
                return outcome.map(|outcome| outcome.value).filter(|_| sound);
            }
            match statement {
                Stmt::Expr(expression, semicolon) => {
                    let result = self.statement(expression);
                    sound &= result.is_some();
                    value = result.filter(|_| rest.is_empty() && semicolon.is_none()).or(Some(Value::Unit));
                }
                Stmt::Local(local) => sound &= self.local(local).is_some(),
                Stmt::Item(item) => sound &= self.item(item).is_some(),
                Stmt::Macro(statement) => sound &= self.assertion(&statement.mac).is_some(),
            }
        }
        value.filter(|_| sound)
    }

    fn local(&mut self, local: &Local) -> Option<()> {
        let value = match &local.init {
            Some(init) if init.diverge.is_none() => match declared_array(local) {
                Some(array) => self.expression(&array),
                None if matches!(&*init.expr, Expr::MethodCall(call) if is_adaptor(call)) => {
                    // What an iterator in a variable gives is what is read of it later.
                    self.verbatim(&init.expr).or_else(|| self.collected(&init.expr))
                }
                None => match &local.pat {
                    Pat::Type(typed) => self.expression_of(&init.expr, &typed.ty),
                    _ => self.expression(&init.expr),
                },
            },
            Some(init) => {
                if let Some(true) = self.fits_length(&local.pat, &init.expr)? {
                    return Some(());
                }
                self.errors.at(
                    local,
                    "`let ... else` is not supported here\nhelp: write `if let` around the \
                                       statements that need the value, or give the value in every case",
                );
                None
            }
            None => {
                self.errors.at(local, "a variable without a value is not supported\nhelp: write `let x = ...;`");
                None
            }
        };
        let sound = value.is_some();
        self.bind(&local.pat, value.unwrap_or(Value::Unknown));
        if let Some(init) = &local.init {
            self.note_declared(&local.pat, &init.expr);
        }
        sound.then_some(())
    }

    /// Constants inside a function are parameters; other items have no meaning there.
    fn item(&mut self, item: &Item) -> Option<()> {
        match item {
            Item::Const(constant) => {
                let value = self.expression(&constant.expr);
                self.declare(constant.ident.to_string(), value?);
                Some(())
            }
            Item::Use(item) => {
                self.uses.push(item.clone());
                Some(())
            }
            Item::Fn(function) => {
                self.inner_function(function);
                Some(())
            }
            other => {
                self.errors.at(other, "items inside the function are not supported\nhelp: move it out of the impl");
                None
            }
        }
    }

    /// Assertions stay in the user's function and mean nothing to the derivative.
    pub(crate) fn assertion(&mut self, called: &Macro) -> Option<Value> {
        let name = called.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
        if name.starts_with("debug_assert") || name.starts_with("assert") {
            return Some(Value::Unit);
        }
        let message = format!(
            "`{name}!` is not supported\nhelp: write the formula without a macro\nnote: assertions are the \
                     only macros that H may call"
        );
        self.errors.at(called, message);
        None
    }

    /// An expression in the place of a statement.
    pub(crate) fn statement(&mut self, expression: &Expr) -> Option<Value> {
        match expression {
            Expr::ForLoop(repeat) => self.repeat(repeat),
            Expr::Assign(ExprAssign { left, right, .. }) => self.assign(left, None, right, expression),
            Expr::Binary(ExprBinary { left, op, right, .. }) if is_assignment(op) => {
                self.assign(left, Some(op), right, expression)
            }
            _ => self.expression(expression),
        }
    }

    /// `(a, b) = (x, y)`: both are evaluated before either is assigned.
    fn assign_parts(&mut self, places: Vec<&Expr>, right: &Expr, whole: &Expr) -> Option<Value> {
        let value = self.expression(right)?;
        self.scopes.push(HashMap::new());
        let names: Vec<Ident> = (0..places.len()).map(|place| format_ident!("__part_{place}")).collect();
        let pattern: Pat = match whole {
            Expr::Array(_) => parse_quote!([#(#names),*]),
            _ => parse_quote!((#(#names,)*)),
        };
        self.bind(&pattern, value);
        let assigned = places.into_iter().zip(&names).filter(|(place, _)| !matches!(place, Expr::Infer(_)));
        let outcomes: Vec<_> =
            assigned.map(|(place, name)| self.assign(place, None, &parse_quote!(#name), place)).collect();
        self.scopes.pop();
        outcomes.into_iter().all(|outcome| outcome.is_some()).then_some(Value::Unit)
    }

    /// `place = right`, or `place op= right`, where the place is a variable or an element of an array.
    fn assign(&mut self, left: &Expr, op: Option<&BinOp>, right: &Expr, whole: &Expr) -> Option<Value> {
        match (left, op) {
            (Expr::Tuple(tuple), None) => return self.assign_parts(tuple.elems.iter().collect(), right, left),
            (Expr::Array(array), None) => return self.assign_parts(array.elems.iter().collect(), right, left),
            _ => {}
        }
        let Some(target) = self.target(left) else {
            let id = root_name(left).and_then(|name| self.lookup(&name.to_string()));
            if id.is_some_and(|id| matches!(self.bindings[id.0].value, Value::Unknown)) {
                // The mistake about it is known; what it is made of may have another one.
                self.expression(right);
            }
            return None;
        };
        if self.bindings[target.id.0].depth < self.frames.len() {
            return self.accumulate(target, left, op, right, whole);
        }
        let value = match op {
            None => self.expression(right)?,
            Some(op) => {
                // The text of `x *= a + b` has no parentheses of its own, nor has that of what `x` was.
                let (now, change) = (self.element_of(&target)?.clone(), self.expression(right)?);
                self.note_operand(op, Some(&change), right);
                self.combine(&plain(op), now.into_operand(), change.into_operand(), left, right, whole)?
            }
        };
        *self.element_of_mut(&target)? = value;
        Some(Value::Unit)
    }

    /// The variable, or the element of an array, that is assigned to.
    fn target(&mut self, place: &Expr) -> Option<Target> {
        match place {
            Expr::Paren(inner) => self.target(&inner.expr),
            Expr::Unary(ExprUnary { op: UnOp::Deref(_), expr, .. }) => self.target(expr),
            Expr::Index(ExprIndex { expr, index, .. }) => {
                let mut target = self.target(expr)?;
                self.spread(&target)?;
                if let Value::Opaque(_) = self.element_of(&target)? {
                    let message = "assigning to an element of a list of the system is not supported\nhelp: write the \
                                   list as one expression, or as a method of this impl that takes no coordinates";
                    self.errors.at(place, message);
                    return None;
                }
                let position = self.expression(index)?;
                let position = self.integer(&position).and_then(|index| self.known(index));
                self.list_as_array(&target);
                let elements = match self.element_of(&target)? {
                    Value::Array(elements) => elements.len(),
                    Value::Accumulating => usize::MAX,
                    Value::List(list) => {
                        let list = list.clone();
                        let message = self.unseen_length(&list).unwrap_or_else(|| BY_INDEX.to_owned());
                        self.errors.at(place, message);
                        // One mistake, one message, however often it is assigned to.
                        self.bindings[target.id.0].value = Value::Unknown;
                        return None;
                    }
                    Value::View(_) => {
                        let message = format!(
                            "assigning to an element of a copy of the coordinates is not supported for more than \
                             {FEW} elements\nhelp: write the new value as a variable"
                        );
                        self.errors.at(place, message);
                        return None;
                    }
                    _ => 0,
                };
                match position.and_then(|position| usize::try_from(position).ok()) {
                    Some(position) if position < elements => target.at.push(position),
                    Some(_) => {
                        self.errors
                            .at(index, format!("the index is out of bounds for this array of {elements} elements"));
                        return None;
                    }
                    None => {
                        self.errors.at(index, format!("{BY_INDEX}{}", self.unseen_bound()));
                        return None;
                    }
                }
                Some(target)
            }
            _ => {
                let Some(name) = simple_name(place) else {
                    self.errors.at(place, "only a variable or an element of an array can be assigned to");
                    return None;
                };
                let Some(id) = self.lookup(&name.to_string()) else {
                    self.errors.at(place, format!("`{name}` is not known here"));
                    return None;
                };
                match self.bindings[id.0] {
                    Binding { value: Value::View(_), mutable: false, .. } => {
                        self.errors.at(place, format!("the coordinates `{name}` cannot be assigned to"));
                        None
                    }
                    Binding { value: Value::Unknown, .. } => None,
                    _ => Some(Target { id, at: Vec::new() }),
                }
            }
        }
    }

    /// Makes a variable that is a copy of a point an array of its components, which may be assigned one by one.
    fn spread(&mut self, target: &Target) -> Option<()> {
        let copy @ Value::View(_) = self.element_of(target)?.clone() else { return Some(()) };
        let Some(list) = self.as_list(&copy) else { return Some(()) };
        let Some(range) = self.known_iterations(&list) else { return Some(()) };
        let parts = range.map(|position| {
            let position = self.literal_index(position);
            self.item_of(&list, position).map(|item| item.value)
        });
        *self.element_of_mut(target)? = Value::Array(parts.collect::<Option<_>>()?);
        Some(())
    }

    pub(crate) fn element_of(&self, target: &Target) -> Option<&Value> {
        target.at.iter().try_fold(&self.bindings[target.id.0].value, |value, position| match value {
            Value::Array(parts) => parts.get(*position),
            Value::Accumulating => Some(value),
            _ => None,
        })
    }

    pub(crate) fn element_of_mut(&mut self, target: &Target) -> Option<&mut Value> {
        target.at.iter().try_fold(&mut self.bindings[target.id.0].value, |value, position| match value {
            Value::Array(parts) => parts.get_mut(*position),
            _ => None,
        })
    }

    /// An assignment inside a loop to a variable from outside: it has to add something.
    fn accumulate(
        &mut self,
        target: Target,
        place: &Expr,
        op: Option<&BinOp>,
        right: &Expr,
        whole: &Expr,
    ) -> Option<Value> {
        let Some((negative, addend)) = addend(place, op, right) else {
            let name = quoted(place);
            let message = format!(
                "a loop may only add to `{name}`, which is declared outside of it\nhelp: write `{name} += ...` or \
                 `{name} -= ...`\nnote: loops with literal bounds, as in `for k in 0..4`, support any assignment for \
                 up to {FEW} iterations{}",
                self.unseen_bound()
            );
            self.errors.at(whole, message);
            return None;
        };
        let value = self.expression(addend)?;
        self.note_addend(&value, addend);
        let value = self.operand(&value, addend)?;
        let value = if negative { self.graph.neg(value) } else { value };
        self.add_to_frame(target, value);
        Some(Value::Unit)
    }

    /// Notes that an iteration of the innermost loop adds `value` to a variable.
    pub(crate) fn add_to_frame(&mut self, target: Target, value: NodeId) {
        let Self { graph, frames, .. } = self;
        let Some(frame) = frames.last_mut() else { return };
        match frame.sums.iter_mut().find(|(known, _)| *known == target) {
            Some((_, sum)) => *sum = graph.add(*sum, value),
            None => frame.sums.push((target, value)),
        }
    }

    /// Variables from outside that a body assigns to have no value while it is read. Returns what they had.
    pub(crate) fn hold(&mut self, body: &Block) -> Vec<(BindingId, Value)> {
        let mut assigned = Assigned::default();
        assigned.visit_block(body);
        let mut held: Vec<(BindingId, Value)> = Vec::new();
        for name in assigned.names {
            if let Some(id) = self.lookup(&name)
                && !held.iter().any(|(known, _)| *known == id)
                && !matches!(
                    self.bindings[id.0],
                    Binding { value: Value::View(_), mutable: false, .. } | Binding { value: Value::Unknown, .. }
                )
            {
                held.push((id, std::mem::replace(&mut self.bindings[id.0].value, Value::Accumulating)));
            }
        }
        held
    }
}

/// The operator of a compound assignment.
fn plain(op: &BinOp) -> BinOp {
    match op {
        BinOp::AddAssign(_) => syn::parse_quote!(+),
        BinOp::SubAssign(_) => syn::parse_quote!(-),
        BinOp::MulAssign(_) => syn::parse_quote!(*),
        _ => syn::parse_quote!(/),
    }
}
