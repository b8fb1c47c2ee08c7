//! Errors for lists among the parameters for derivatives, which must be single numbers.

use crate::{errors::Errors, syntax::Input};
use proc_macro2::Ident;
use syn::{
    Expr, ExprField, ExprForLoop, ExprIndex, ExprMethodCall, Member,
    visit::{self, Visit},
};

/// Methods of lists that numbers do not have.
const OF_LISTS: [&str; 16] = [
    "iter",
    "into_iter",
    "len",
    "is_empty",
    "first",
    "last",
    "get",
    "contains",
    "windows",
    "array_windows",
    "chunks",
    "chunks_exact",
    "split_at",
    "as_slice",
    "to_vec",
    "map",
];

/// Methods of sequences whose argument is a sequence as well.
const OF_TWO: [&str; 2] = ["zip", "chain"];

/// Notes the parameters that are used as lists, and leaves them out.
pub(crate) fn without_lists(input: &mut Input, errors: &mut Errors) {
    let mut lists = Lists { names: input.sensitive.clone(), found: Vec::new() };
    if !lists.names.is_empty() {
        lists.visit_item_impl(&input.item);
    }
    input.sensitive.retain(|name| {
        let is_list = lists.found.contains(name);
        if is_list {
            errors.at(name, several(name));
        }
        !is_list
    });
}

/// What to say of a field with several numbers that derivatives are taken by.
pub(crate) fn several(name: &Ident) -> String {
    format!(
        "`{name}` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one \
             number each"
    )
}

/// The fields of these names that are used as lists.
struct Lists {
    names: Vec<Ident>,
    found: Vec<Ident>,
}

impl Lists {
    /// Notes a list, if it is such a field.
    fn note(&mut self, list: &Expr) {
        match list {
            Expr::Reference(inner) => self.note(&inner.expr),
            Expr::Paren(inner) => self.note(&inner.expr),
            Expr::Field(ExprField { base, member: Member::Named(name), .. }) => {
                let is_own = matches!(&**base, Expr::Path(path) if path.path.is_ident("self"));
                if is_own && self.names.contains(name) {
                    self.found.push(name.clone());
                }
            }
            _ => {}
        }
    }
}

impl Visit<'_> for Lists {
    fn visit_expr_index(&mut self, index: &ExprIndex) {
        self.note(&index.expr);
        visit::visit_expr_index(self, index);
    }

    fn visit_expr_for_loop(&mut self, repeat: &ExprForLoop) {
        self.note(&repeat.expr);
        visit::visit_expr_for_loop(self, repeat);
    }

    fn visit_expr_method_call(&mut self, call: &ExprMethodCall) {
        if OF_LISTS.iter().any(|method| call.method == method) {
            self.note(&call.receiver);
        }
        if OF_TWO.iter().any(|method| call.method == method) {
            call.args.iter().for_each(|argument| self.note(argument));
        }
        visit::visit_expr_method_call(self, call);
    }
}
