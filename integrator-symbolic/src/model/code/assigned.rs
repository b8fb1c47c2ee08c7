//! What code assigns to, adds to and reads.

use quote::quote;
use syn::{
    BinOp, Expr, ExprAssign, ExprBinary, ExprClosure, ExprForLoop, ExprIndex, ExprReference, ExprUnary, Ident, Pat,
    PatIdent, UnOp, visit::Visit,
};

/// What a piece of code assigns to.
#[derive(Default)]
pub(crate) struct Assigned {
    /// The names of variables, and of arrays whose elements are assigned.
    pub(crate) names: Vec<String>,
    /// The names that are assigned otherwise than by adding to them.
    pub(crate) replaced: Vec<String>,
    /// The names that are indexed.
    pub(crate) indexed: Vec<String>,
    /// The names that are read, or of which elements are, but for what is added to.
    pub(crate) read: Vec<String>,
}

impl Visit<'_> for Assigned {
    fn visit_expr(&mut self, expression: &Expr) {
        let (left, op, right) = match expression {
            Expr::Assign(ExprAssign { left, right, .. }) => (left, None, right),
            Expr::Binary(ExprBinary { left, op, right, .. }) if is_assignment(op) => (left, Some(op), right),
            other => return self.visit_value(other),
        };
        self.assign(left);
        match addend(left, op, right) {
            Some((_, addend)) => self.visit_expr(addend),
            None => {
                self.replace(left);
                self.visit_expr(right);
            }
        }
    }

    fn visit_expr_closure(&mut self, closure: &ExprClosure) {
        self.visit_under(closure.inputs.iter(), |visitor| visitor.visit_expr(&closure.body));
    }

    fn visit_expr_for_loop(&mut self, repeat: &ExprForLoop) {
        self.visit_expr(&repeat.expr);
        self.visit_under([&*repeat.pat], |visitor| visitor.visit_block(&repeat.body));
    }
}

impl Assigned {
    /// Notes what is assigned to. It is not read, but for the indices in it.
    fn assign(&mut self, place: &Expr) {
        match place {
            Expr::Tuple(parts) => parts.elems.iter().for_each(|part| self.assign(part)),
            Expr::Array(parts) => parts.elems.iter().for_each(|part| self.assign(part)),
            Expr::Paren(inner) => self.assign(&inner.expr),
            Expr::Unary(ExprUnary { op: UnOp::Deref(_), expr, .. }) => self.assign(expr),
            Expr::Index(ExprIndex { expr, index, .. }) => {
                self.indexed.extend(root_name(expr).map(ToString::to_string));
                self.assign(expr);
                self.visit_expr(index);
            }
            place => self.names.extend(simple_name(place).map(ToString::to_string)),
        }
    }

    /// Visits what sees names that patterns declare, which are others than those outside.
    fn visit_under<'p>(&mut self, patterns: impl IntoIterator<Item = &'p Pat>, visit: impl FnOnce(&mut Self)) {
        let mut declared = Names(Vec::new());
        patterns.into_iter().for_each(|pattern| declared.visit_pat(pattern));
        let before = std::mem::take(&mut self.read);
        visit(self);
        self.read.retain(|name| !declared.0.contains(name));
        self.read.extend(before);
    }

    /// Notes that a place was overwritten.
    fn replace(&mut self, place: &Expr) {
        match place {
            Expr::Tuple(parts) => parts.elems.iter().for_each(|part| self.replace(part)),
            Expr::Array(parts) => parts.elems.iter().for_each(|part| self.replace(part)),
            place => self.replaced.extend(root_name(place).map(ToString::to_string)),
        }
    }

    fn visit_value(&mut self, expression: &Expr) {
        if let Expr::Reference(ExprReference { mutability: Some(_), expr, .. }) = expression {
            self.names.extend(root_name(expr).map(ToString::to_string));
        }
        if let Expr::Index(ExprIndex { expr, .. }) = expression {
            self.indexed.extend(root_name(expr).map(ToString::to_string));
        }
        self.read.extend(simple_name(expression).map(ToString::to_string));
        syn::visit::visit_expr(self, expression);
    }
}

/// Whether an operator changes what is on its left.
pub(crate) fn is_assignment(op: &BinOp) -> bool {
    matches!(op, BinOp::AddAssign(_) | BinOp::SubAssign(_) | BinOp::MulAssign(_) | BinOp::DivAssign(_))
}

/// What an assignment adds to its own place, if that is all it does; `true` if it subtracts.
pub(crate) fn addend<'e>(place: &Expr, op: Option<&BinOp>, right: &'e Expr) -> Option<(bool, &'e Expr)> {
    let same = |expression: &Expr| quote!(#expression).to_string() == quote!(#place).to_string();
    match (op, right) {
        (Some(BinOp::AddAssign(_)), addend) => Some((false, addend)),
        (Some(BinOp::SubAssign(_)), addend) => Some((true, addend)),
        (None, Expr::Binary(ExprBinary { left, op: BinOp::Add(_), right, .. })) if same(left) => {
            Some((false, &**right))
        }
        (None, Expr::Binary(ExprBinary { left, op: BinOp::Add(_), right, .. })) if same(right) => {
            Some((false, &**left))
        }
        (None, Expr::Binary(ExprBinary { left, op: BinOp::Sub(_), right, .. })) if same(left) => Some((true, &**right)),
        _ => None,
    }
}

/// The name that an expression is, if it is one.
pub(crate) fn simple_name(expression: &Expr) -> Option<&Ident> {
    match expression {
        Expr::Path(path) if path.qself.is_none() => path.path.get_ident(),
        Expr::Paren(inner) => simple_name(&inner.expr),
        _ => None,
    }
}

/// The name of the variable that a place is, or is an element of.
pub(crate) fn root_name(place: &Expr) -> Option<&Ident> {
    match place {
        Expr::Index(ExprIndex { expr, .. }) => root_name(expr),
        Expr::Unary(ExprUnary { op: UnOp::Deref(_), expr, .. }) => root_name(expr),
        _ => simple_name(place),
    }
}

/// The names that a pattern declares.
pub(crate) struct Names(pub(crate) Vec<String>);

impl Visit<'_> for Names {
    fn visit_pat_ident(&mut self, name: &PatIdent) {
        self.0.push(name.ident.to_string());
        syn::visit::visit_pat_ident(self, name);
    }
}
