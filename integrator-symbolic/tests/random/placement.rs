//! Every value of generated code is computed in the outermost loop whose index it reads, and every condition is asked there.
//!
//! This reads texts, not their schedule: it knows on which loops names depend, and looks for operations, conditions and
//! prepared tables that are the same in all iterations of the loop that is directly around them. Allowed are:
//!
//! - operations under a condition inside of that loop, since their operands may not be there in other iterations
//! - a test of a mask that was computed in front of the loop, if the loop has lines beside it: two loops would compute
//!   what both need twice
//! - what is in the elements of prepared tables, which are computed once per run from the user's own text

use proc_macro2::TokenStream;
use quote::ToTokens;
use std::collections::BTreeSet;
use syn::{
    Block, Expr, FnArg, ImplItem, ImplItemFn, Item, ItemImpl, Pat, Stmt,
    visit::{self, Visit},
};

/// What is out of place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    /// An operation that is the same in all iterations.
    Operation,
    /// A condition that is.
    Condition,
    /// A prepared table whose elements are the same.
    Table,
}

/// Something out of place, with the function around it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Misplaced {
    pub(crate) kind: Kind,
    pub(crate) function: String,
    pub(crate) text: String,
}

/// What is out of place in the output of the macro.
pub(crate) fn misplaced(output: &TokenStream) -> Vec<Misplaced> {
    let file: syn::File = syn::parse2(output.clone()).expect("a file");
    let mut walk = Walk::default();
    for item in file.items {
        // The user's own impl comes first.
        if let Item::Const(scope) = item
            && let Expr::Block(block) = &*scope.expr
        {
            for statement in &block.block.stmts {
                if let Stmt::Item(Item::Impl(item)) = statement {
                    walk.implementation(item);
                }
            }
        }
    }
    walk.found
}

/// Functions that the runtime calls in loops of its own, with the arguments that are the same in all iterations.
const CALLED_IN_LOOPS: [(&str, &[usize]); 8] = [
    ("next", &[2]),
    ("values", &[2]),
    ("contributions", &[]),
    ("pair", &[]),
    ("drift_body", &[4]),
    ("one_body", &[]),
    ("energy", &[]),
    ("energy_alone", &[]),
];

/// Methods of numbers that are operations.
const METHODS: [&str; 26] = [
    "square",
    "scale",
    "square_add",
    "square_from",
    "scale_add",
    "fma",
    "div_sqrt",
    "div_pow_3_2",
    "sqrt",
    "sin_cos",
    "sin",
    "cos",
    "tan",
    "exp",
    "ln",
    "powf",
    "atan2",
    "hypot",
    "tanh",
    "sinh",
    "cosh",
    "atan",
    "asin",
    "acos",
    "cbrt",
    "exp_m1",
];

#[derive(Clone, Copy, PartialEq, Eq)]
enum Scope {
    Loop(usize),
    Branch,
}

#[derive(Default)]
struct Walk {
    scopes: Vec<Scope>,
    /// The loops that names depend on; the last one of a name is seen.
    names: Vec<(String, BTreeSet<usize>)>,
    loops: usize,
    function: String,
    found: Vec<Misplaced>,
}

impl Walk {
    fn implementation(&mut self, item: &ItemImpl) {
        for item in &item.items {
            if let ImplItem::Fn(function) = item {
                self.function(function);
            }
        }
    }

    fn function(&mut self, function: &ImplItemFn) {
        let name = function.sig.ident.to_string();
        let scopes = std::mem::take(&mut self.scopes);
        let names = std::mem::take(&mut self.names);
        let outer = std::mem::replace(&mut self.function, name.clone());
        let own = CALLED_IN_LOOPS.iter().find(|(known, _)| *known == name);
        let around = own.map(|_| self.enter());
        for (place, input) in function.sig.inputs.iter().enumerate() {
            let FnArg::Typed(typed) = input else { continue };
            let is_common = own.is_none_or(|(_, common)| common.contains(&place)) || {
                let text = typed.pat.to_token_stream().to_string();
                text == "parameters" || text == "time"
            };
            let depends = around.filter(|_| !is_common).into_iter().collect();
            self.bind(&typed.pat, &depends);
        }
        self.block(&function.block);
        (self.scopes, self.names, self.function) = (scopes, names, outer);
    }

    fn enter(&mut self) -> usize {
        self.loops += 1;
        self.scopes.push(Scope::Loop(self.loops));
        self.loops
    }

    fn bind(&mut self, pattern: &Pat, depends: &BTreeSet<usize>) {
        let mut found = Names(Vec::new());
        found.visit_pat(pattern);
        self.names.extend(found.0.into_iter().map(|name| (name, depends.clone())));
    }

    fn block(&mut self, block: &Block) {
        let depth = self.names.len();
        for statement in &block.stmts {
            match statement {
                Stmt::Local(local) => {
                    let Some(init) = &local.init else { continue };
                    self.expression(&init.expr);
                    let depends = self.depends(&init.expr);
                    self.bind(&local.pat, &depends);
                }
                Stmt::Expr(expression, _) => self.expression(expression),
                Stmt::Item(Item::Impl(item)) => self.implementation(item),
                Stmt::Item(_) | Stmt::Macro(_) => {}
            }
        }
        self.names.truncate(depth);
    }

    /// The loops whose indices an expression reads.
    fn depends(&self, expression: &Expr) -> BTreeSet<usize> {
        let mut read = Read { names: &self.names, loops: BTreeSet::new() };
        read.visit_expr(expression);
        read.loops
    }

    /// Whether an expression is an operation of a flow or an energy: what is prepared is the user's own text.
    fn is_computed(&self, expression: &Expr) -> bool {
        self.function != "parameters" && is_operation(expression)
    }

    /// The loop directly around, unless the expression depends on it.
    fn is_misplaced(&self, expression: &Expr) -> bool {
        matches!(self.scopes.last(), Some(Scope::Loop(around)) if !self.depends(expression).contains(around))
    }

    fn note(&mut self, kind: Kind, of: &impl ToTokens) {
        let (function, text) = (self.function.clone(), of.to_token_stream().to_string());
        self.found.push(Misplaced { kind, function, text });
    }

    fn expression(&mut self, expression: &Expr) {
        match expression {
            Expr::ForLoop(each) => {
                self.expression(&each.expr);
                let depth = self.names.len();
                let around = self.enter();
                // What an iteration changes depends on it.
                let mut changed = Changed(Vec::new());
                changed.visit_block(&each.body);
                for name in &changed.0 {
                    self.change(name, &[around].into());
                }
                self.bind(&each.pat, &[around].into());
                self.decided(&each.body);
                self.block(&each.body);
                self.scopes.pop();
                self.names.truncate(depth);
                for (_, loops) in &mut self.names {
                    loops.remove(&around);
                }
            }
            Expr::If(choice) => {
                if self.function != "parameters" && mask(&choice.cond).is_none() && self.is_misplaced(&choice.cond) {
                    self.note(Kind::Condition, &choice.cond);
                }
                let depends = self.depends(&choice.cond);
                let mut changed = Changed(Vec::new());
                changed.visit_expr_if(choice);
                changed.0.iter().for_each(|name| self.change(name, &depends));
                self.scopes.push(Scope::Branch);
                self.block(&choice.then_branch);
                if let Some((_, other)) = &choice.else_branch {
                    self.expression(other);
                }
                self.scopes.pop();
            }
            Expr::Block(block) => self.block(&block.block),
            Expr::Assign(assign) => {
                self.expression(&assign.right);
                self.assigned(&assign.left, &assign.right);
            }
            Expr::Binary(binary) if self.is_computed(expression) => {
                if matches!(binary.op, syn::BinOp::AddAssign(_) | syn::BinOp::SubAssign(_)) {
                    self.expression(&binary.right);
                    self.assigned(&binary.left, &binary.right);
                } else if self.is_misplaced(expression) {
                    self.note(Kind::Operation, expression);
                } else {
                    self.expression(&binary.left);
                    self.expression(&binary.right);
                }
            }
            Expr::MethodCall(call) => {
                // What adds to a coordinate is no value.
                let is_slot = call.receiver.to_token_stream().to_string().starts_with("motion .");
                if !is_slot && self.is_computed(expression) && self.is_misplaced(expression) {
                    self.note(Kind::Operation, expression);
                    return;
                }
                self.expression(&call.receiver);
                call.args.iter().for_each(|argument| self.expression(argument));
            }
            Expr::Call(call) => {
                let name = call.func.to_token_stream().to_string();
                if name.ends_with("table") {
                    call.args.iter().for_each(|argument| self.table(argument));
                } else if !name.ends_with("of") {
                    call.args.iter().for_each(|argument| self.expression(argument));
                }
            }
            Expr::Paren(inner) => self.expression(&inner.expr),
            Expr::Unary(inner) => self.expression(&inner.expr),
            Expr::Reference(inner) => self.expression(&inner.expr),
            Expr::Tuple(tuple) => tuple.elems.iter().for_each(|element| self.expression(element)),
            Expr::Array(array) => array.elems.iter().for_each(|element| self.expression(element)),
            Expr::Struct(literal) => literal.fields.iter().for_each(|field| self.expression(&field.expr)),
            _ => {}
        }
    }

    /// Lines of a loop that one mask for all iterations decides.
    fn decided(&mut self, body: &Block) {
        let masks = body.stmts.iter().map(|statement| match statement {
            Stmt::Expr(Expr::If(choice), _) if choice.else_branch.is_none() => mask(&choice.cond),
            _ => None,
        });
        let masks: Option<BTreeSet<String>> = masks.collect();
        if let (Some(masks), Some(Stmt::Expr(Expr::If(choice), _))) = (masks, body.stmts.first())
            && masks.len() == 1
            && self.is_misplaced(&choice.cond)
        {
            self.note(Kind::Condition, &choice.cond);
        }
    }

    /// The elements of a prepared table, by a closure.
    fn table(&mut self, argument: &Expr) {
        let inner = match argument {
            Expr::Reference(inner) => &*inner.expr,
            other => other,
        };
        let Expr::Closure(closure) = inner else { return };
        let (depth, around) = (self.names.len(), self.enter());
        closure.inputs.iter().for_each(|input| self.bind(input, &[around].into()));
        if self.is_misplaced(&closure.body) {
            self.note(Kind::Table, closure);
        }
        self.scopes.pop();
        self.names.truncate(depth);
    }

    fn assigned(&mut self, place: &Expr, value: &Expr) {
        let depends = self.depends(value);
        if let Some(name) = root(place) {
            self.change(&name, &depends);
        }
    }

    fn change(&mut self, name: &str, depends: &BTreeSet<usize>) {
        if let Some((_, loops)) = self.names.iter_mut().rev().find(|(known, _)| known == name) {
            loops.extend(depends);
        }
    }
}

/// Whether an expression is arithmetic of numbers at its top.
fn is_operation(expression: &Expr) -> bool {
    use syn::BinOp::{Add, AddAssign, Div, Mul, Sub, SubAssign};
    match expression {
        Expr::Binary(binary) => {
            matches!(binary.op, Add(_) | Sub(_) | Mul(_) | Div(_) | AddAssign(_) | SubAssign(_))
        }
        Expr::MethodCall(call) => METHODS.iter().any(|name| call.method == name),
        _ => false,
    }
}

/// The name of the mask that a condition tests, `name.any()` or `name.not().any()`.
fn mask(condition: &Expr) -> Option<String> {
    match condition {
        Expr::MethodCall(call) if call.method == "any" || call.method == "not" => mask(&call.receiver),
        Expr::Path(path) => path.path.get_ident().map(ToString::to_string),
        _ => None,
    }
}

/// The variable that a place is a part of.
fn root(place: &Expr) -> Option<String> {
    match place {
        Expr::Path(path) => path.path.get_ident().map(ToString::to_string),
        Expr::Index(index) => root(&index.expr),
        Expr::Field(field) => root(&field.base),
        Expr::Paren(inner) => root(&inner.expr),
        Expr::Unary(inner) => root(&inner.expr),
        _ => None,
    }
}

/// The names that a pattern binds.
struct Names(Vec<String>);

impl<'a> Visit<'a> for Names {
    fn visit_pat_ident(&mut self, name: &'a syn::PatIdent) {
        self.0.push(name.ident.to_string());
    }
}

/// The loops that the names in an expression depend on.
struct Read<'n> {
    names: &'n [(String, BTreeSet<usize>)],
    loops: BTreeSet<usize>,
}

impl<'a> Visit<'a> for Read<'_> {
    fn visit_expr_path(&mut self, path: &'a syn::ExprPath) {
        if let Some(name) = path.path.get_ident()
            && let Some((_, loops)) = self.names.iter().rev().find(|(known, _)| name == known)
        {
            self.loops.extend(loops);
        }
    }
}

/// The variables that lines assign.
struct Changed(Vec<String>);

impl<'a> Visit<'a> for Changed {
    fn visit_expr_assign(&mut self, assign: &'a syn::ExprAssign) {
        self.0.extend(root(&assign.left));
        visit::visit_expr_assign(self, assign);
    }

    fn visit_expr_binary(&mut self, binary: &'a syn::ExprBinary) {
        use syn::BinOp::{AddAssign, DivAssign, MulAssign, SubAssign};
        if matches!(binary.op, AddAssign(_) | SubAssign(_) | MulAssign(_) | DivAssign(_)) {
            self.0.extend(root(&binary.left));
        }
        visit::visit_expr_binary(self, binary);
    }

    fn visit_expr_reference(&mut self, reference: &'a syn::ExprReference) {
        if reference.mutability.is_some() {
            self.0.extend(root(&reference.expr));
        }
        visit::visit_expr_reference(self, reference);
    }
}
