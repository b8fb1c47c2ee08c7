//! Blocks, assignments and loops.

use super::{BindingId, Frame, Reader, value::Value};
use crate::graph::{
    NodeId,
    index::{Index, IndexId, Loop, LoopId, LoopSet},
};
use proc_macro2::Ident;
use quote::{format_ident, quote};
use std::collections::HashMap;
use syn::{
    BinOp, Block, Expr, ExprAssign, ExprBinary, ExprForLoop, Item, Local, Macro, Pat, RangeLimits, Stmt, visit::Visit,
};

/// Names that the generated functions use themselves.
const RESERVED: [&str; 7] = ["motion", "step", "time", "duration", "of_lane", "lane", "table"];

impl Reader<'_> {
    /// The value of a block; `None` if a mistake was noted in it.
    pub(super) fn block(&mut self, block: &Block) -> Option<Value> {
        self.scopes.push(HashMap::new());
        let mut value = Some(Value::Unit);
        let mut sound = true;
        for (position, statement) in block.stmts.iter().enumerate() {
            let last = position + 1 == block.stmts.len();
            match statement {
                Stmt::Expr(expression, semicolon) => {
                    let result = self.statement(expression);
                    sound &= result.is_some();
                    value = result.filter(|_| last && semicolon.is_none()).or(value.map(|_| Value::Unit));
                }
                Stmt::Local(local) => sound &= self.local(local).is_some(),
                Stmt::Item(item) => sound &= self.item(item).is_some(),
                Stmt::Macro(statement) => sound &= self.assertion(&statement.mac).is_some(),
            }
        }
        self.scopes.pop();
        value.filter(|_| sound)
    }

    fn local(&mut self, local: &Local) -> Option<()> {
        let value = match &local.init {
            Some(init) if init.diverge.is_none() => self.expression(&init.expr),
            Some(_) => {
                self.errors.at(local, "`let ... else` is not understood here: give the value unconditionally");
                None
            }
            None => {
                self.errors.at(local, "a variable needs its value where it is declared: write `let x = ...;`");
                None
            }
        };
        let sound = value.is_some();
        self.bind(&local.pat, value.unwrap_or(Value::Unknown));
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
            Item::Use(_) => Some(()),
            other => {
                self.errors.at(other, "an item inside the function: move it out of the impl");
                None
            }
        }
    }

    /// Assertions stay in the user's function and mean nothing to the derivative.
    pub(super) fn assertion(&mut self, called: &Macro) -> Option<Value> {
        let name = called.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default();
        if name.starts_with("debug_assert") || name.starts_with("assert") {
            return Some(Value::Unit);
        }
        let message =
            format!("`{name}!` cannot be differentiated: only assertions may stand here; write the formula out");
        self.errors.at(called, message);
        None
    }

    /// An expression in the place of a statement.
    fn statement(&mut self, expression: &Expr) -> Option<Value> {
        match expression {
            Expr::ForLoop(repeat) => self.repeat(repeat),
            Expr::Assign(ExprAssign { left, right, .. }) => self.assign(left, None, right, expression),
            Expr::Binary(ExprBinary { left, op, right, .. }) => match op {
                BinOp::AddAssign(_) | BinOp::SubAssign(_) | BinOp::MulAssign(_) | BinOp::DivAssign(_) => {
                    self.assign(left, Some(op), right, expression)
                }
                _ => self.expression(expression),
            },
            _ => self.expression(expression),
        }
    }

    /// `name = right`, or `name op= right`.
    fn assign(&mut self, left: &Expr, op: Option<&BinOp>, right: &Expr, whole: &Expr) -> Option<Value> {
        let Some(name) = simple_name(left) else {
            self.errors.at(left, "only a variable can be assigned to: declare one with `let mut`");
            return None;
        };
        let Some(id) = self.lookup(&name.to_string()) else {
            self.errors.at(left, format!("`{name}` is not known here"));
            return None;
        };
        let outside = self.bindings[id.0].depth < self.frames.len();
        if outside {
            return self.accumulate(id, name, op, right, whole);
        }
        let value = match op {
            None => self.expression(right)?,
            Some(op) => {
                let (now, change) = (self.bindings[id.0].value.clone(), self.expression(right)?);
                if let Value::View(_) = now {
                    self.errors.at(left, format!("`{name}` are coordinates: the functions only read them"));
                    return None;
                }
                self.combine(&plain(op), now, change, left, right, whole)?
            }
        };
        self.bindings[id.0].value = value;
        Some(Value::Unit)
    }

    /// An assignment inside a loop to a variable from outside: it has to add something.
    fn accumulate(
        &mut self,
        id: BindingId,
        name: &Ident,
        op: Option<&BinOp>,
        right: &Expr,
        whole: &Expr,
    ) -> Option<Value> {
        let (negative, addend) = match (op, right) {
            (Some(BinOp::AddAssign(_)), addend) => (false, addend),
            (Some(BinOp::SubAssign(_)), addend) => (true, addend),
            (None, Expr::Binary(ExprBinary { left, op: BinOp::Add(_), right, .. })) if is_name(left, name) => {
                (false, &**right)
            }
            (None, Expr::Binary(ExprBinary { left, op: BinOp::Add(_), right, .. })) if is_name(right, name) => {
                (false, &**left)
            }
            (None, Expr::Binary(ExprBinary { left, op: BinOp::Sub(_), right, .. })) if is_name(left, name) => {
                (true, &**right)
            }
            _ => {
                let message = format!(
                    "`{name}` comes from outside this loop, so the loop can only sum it up: write `{name} += ...` or \
                     `{name} -= ...`"
                );
                self.errors.at(whole, message);
                return None;
            }
        };
        let value = self.expression(addend)?;
        let value = self.number(&value, addend)?;
        let value = if negative { self.graph.neg(value) } else { value };
        self.add_to_frame(id, value);
        Some(Value::Unit)
    }

    /// Notes that a turn of the innermost loop adds `value` to a variable.
    fn add_to_frame(&mut self, id: BindingId, value: NodeId) {
        let Self { graph, frames, .. } = self;
        let Some(frame) = frames.last_mut() else { return };
        match frame.sums.iter_mut().find(|(known, _)| *known == id) {
            Some((_, sum)) => *sum = graph.add(*sum, value),
            None => frame.sums.push((id, value)),
        }
    }

    /// `for index in range { ... }`
    fn repeat(&mut self, repeat: &ExprForLoop) -> Option<Value> {
        let (from, to) = self.range(&repeat.expr)?;
        let Some(name) = loop_name(&repeat.pat) else {
            self.errors.at(&repeat.pat, "the index of a loop is a name: write `for i in 0..n`");
            return None;
        };
        let by = self.enter(name, from, to, repeat)?;
        let held = self.hold(&repeat.body);
        self.scopes.push(HashMap::new());
        let index = self.graph.loops.intern(Index::Running(by));
        self.declare(name.to_string(), Value::Integer(index));
        let body = self.block(&repeat.body);
        self.scopes.pop();
        let sums = self.frames.pop().map(|frame| frame.sums).unwrap_or_default();
        for (id, value) in held {
            self.bindings[id.0].value = value;
        }
        for (id, addend) in sums {
            let sum = self.graph.sum(by, addend);
            if self.bindings[id.0].depth < self.frames.len() {
                self.add_to_frame(id, sum);
            } else {
                let now = self.bindings[id.0].value.clone();
                let now = self.number(&now, &repeat.pat)?;
                self.bindings[id.0].value = Value::Real(self.graph.add(now, sum));
            }
        }
        body.map(|_| Value::Unit)
    }

    /// Opens a loop over `from..to`, with a name for its index that no other loop has.
    fn enter(&mut self, name: &Ident, from: IndexId, to: IndexId, repeat: &ExprForLoop) -> Option<LoopId> {
        if self.graph.loops.count() >= LoopSet::CAPACITY {
            let message = format!("more than {} different loops in one Hamiltonian", LoopSet::CAPACITY);
            self.errors.at(repeat.for_token, message);
            return None;
        }
        if self.graph.loops.upper(to).is_none() || self.graph.loops.lower(from).is_none() {
            let message = "how far this loop may get is not known: its bounds are made of literals, integers of the \
                           impl that depend on no loop, and indices of outer loops";
            self.errors.at(&repeat.expr, message);
            return None;
        }
        let parent = self.frames.last().map(|frame| frame.by);
        let by = self.graph.loops.range(Loop { parent, from, to });
        if !self.running.contains_key(&by) {
            // Loops beside each other are never nested in what is written, so they may share a name.
            let around: Vec<&Ident> = self.frames.iter().filter_map(|frame| self.running.get(&frame.by)).collect();
            let taken = |name: &Ident| RESERVED.iter().any(|word| name == word) || around.contains(&name);
            let base = if name == "_" { format_ident!("turn") } else { name.clone() };
            let free = std::iter::once(base.clone()).chain((2..).map(|count| format_ident!("{base}_{count}")));
            let free = { free }.find(|name| !taken(name)).unwrap_or(base);
            self.running.insert(by, free);
        }
        self.frames.push(Frame { by, sums: Vec::new() });
        Some(by)
    }

    /// The bounds of a loop.
    fn range(&mut self, range: &Expr) -> Option<(IndexId, IndexId)> {
        match range {
            Expr::Paren(inner) => self.range(&inner.expr),
            Expr::Range(range) => {
                let (Some(start), Some(end)) = (&range.start, &range.end) else {
                    self.errors.at(range, "the range of a loop needs both bounds: write `a..b` or `a..=b`");
                    return None;
                };
                let (from, to) = (self.bound(start), self.bound(end));
                let (from, mut to) = (from?, to?);
                if matches!(range.limits, RangeLimits::Closed(_)) {
                    let one = self.graph.loops.intern(Index::Literal(1));
                    to = self.graph.loops.intern(Index::Add(to, one));
                }
                Some((from, to))
            }
            other => {
                self.errors.at(other, "a loop runs over a range of integers: write `for i in a..b`");
                None
            }
        }
    }

    fn bound(&mut self, bound: &Expr) -> Option<IndexId> {
        let value = self.expression(bound)?;
        let index = self.integer(&value);
        if index.is_none() {
            let message = format!("this bound is {}: the range of a loop is made of integers", value.describe());
            self.errors.at(bound, message);
        }
        index
    }

    /// Variables from outside that a body assigns to have no value while it is read. Returns what they had.
    fn hold(&mut self, body: &Block) -> Vec<(BindingId, Value)> {
        let mut assigned = Assigned(Vec::new());
        assigned.visit_block(body);
        let mut held = Vec::new();
        for name in assigned.0 {
            if let Some(id) = self.lookup(&name)
                && !held.iter().any(|(known, _)| *known == id)
            {
                held.push((id, std::mem::replace(&mut self.bindings[id.0].value, Value::Accumulating)));
            }
        }
        held
    }
}

/// The names that a block assigns to.
struct Assigned(Vec<String>);

impl Visit<'_> for Assigned {
    fn visit_expr(&mut self, expression: &Expr) {
        let target = match expression {
            Expr::Assign(ExprAssign { left, .. }) => simple_name(left),
            Expr::Binary(ExprBinary { left, op, .. }) if is_assignment(op) => simple_name(left),
            _ => None,
        };
        self.0.extend(target.map(ToString::to_string));
        syn::visit::visit_expr(self, expression);
    }
}

fn is_assignment(op: &BinOp) -> bool {
    matches!(op, BinOp::AddAssign(_) | BinOp::SubAssign(_) | BinOp::MulAssign(_) | BinOp::DivAssign(_))
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

/// The name that an expression is, if it is one.
pub(super) fn simple_name(expression: &Expr) -> Option<&Ident> {
    match expression {
        Expr::Path(path) if path.qself.is_none() => path.path.get_ident(),
        Expr::Paren(inner) => simple_name(&inner.expr),
        _ => None,
    }
}

fn is_name(expression: &Expr, name: &Ident) -> bool {
    simple_name(expression) == Some(name)
}

fn loop_name(pattern: &Pat) -> Option<&Ident> {
    match pattern {
        Pat::Ident(name) if name.subpat.is_none() => Some(&name.ident),
        _ => None,
    }
}

/// The text of variables that an expression mentions, declared in front of it, so that it can stand alone.
pub(super) fn with_variables(
    text: proc_macro2::TokenStream,
    variables: &[(Ident, proc_macro2::TokenStream)],
) -> proc_macro2::TokenStream {
    if variables.is_empty() {
        return text;
    }
    let declarations = variables.iter().map(|(name, value)| quote!(let #name = #value;));
    quote!({ #(#declarations)* #text })
}
