//! Other names for variables.

use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, format_ident};
use std::collections::BTreeSet;
use syn::{
    Arm, Block, ExprClosure, ExprForLoop, ExprPath, FieldPat, FieldValue, ImplItemConst, ImplItemFn, ItemFn, ItemImpl,
    LitStr, Local, Macro, PatIdent, Stmt,
    visit::Visit,
    visit_mut::{self, VisitMut},
};

/// Which names the indices of loops get.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Scheme {
    /// By how many loops are around: all outer loops have one name.
    ByDepth,
    /// By how deep loops are inside: all innermost loops have one name, which is that of outer ones elsewhere.
    ByHeight,
    /// By turns, so that a loop has in one place the name of that inside of it in another.
    Swapped,
    /// One of its own for each loop.
    Apart,
}

impl Scheme {
    pub(crate) const ALL: [Self; 4] = [Self::ByDepth, Self::ByHeight, Self::Swapped, Self::Apart];
}

/// The identifiers of single variables in scope, each with the one that takes its place.
#[derive(Default)]
struct Scopes(Vec<Vec<(String, Ident)>>);

impl Scopes {
    fn find(&self, name: &Ident) -> Option<Ident> {
        let known = self.0.iter().rev().flat_map(|scope| scope.iter().rev()).find(|(known, _)| name == known)?;
        Some(Ident::new(&known.1.to_string(), name.span()))
    }

    fn bind(&mut self, name: &Ident, other: Ident) {
        self.0.last_mut().expect("a scope").push((name.to_string(), other));
    }

    fn in_tokens(&self, tokens: TokenStream) -> TokenStream {
        let of = |token| match token {
            TokenTree::Ident(name) => self.find(&name).unwrap_or(name).into(),
            TokenTree::Group(group) => Group::new(group.delimiter(), self.in_tokens(group.stream())).into(),
            other => other,
        };
        tokens.into_iter().map(of).collect()
    }
}

/// Renames the indices of loops and the arguments of closures.
pub(crate) struct Renamed {
    scheme: Scheme,
    /// Names that no text of the item mentions otherwise.
    free: Vec<Ident>,
    scopes: Scopes,
    depth: usize,
    count: usize,
}

/// Whether variables are bound that a loop runs over; otherwise they keep their names.
#[derive(Default)]
struct Height(usize, usize);

impl Visit<'_> for Height {
    fn visit_expr_for_loop(&mut self, looped: &ExprForLoop) {
        self.inside(|own| syn::visit::visit_expr_for_loop(own, looped));
    }
    fn visit_expr_closure(&mut self, closure: &ExprClosure) {
        self.inside(|own| syn::visit::visit_expr_closure(own, closure));
    }
}

impl Height {
    fn inside(&mut self, visit: impl FnOnce(&mut Self)) {
        self.0 += 1;
        self.1 = self.1.max(self.0);
        visit(self);
        self.0 -= 1;
    }
}

impl Renamed {
    pub(crate) fn new(scheme: Scheme, item: &ItemImpl) -> Self {
        let mut words = BTreeSet::new();
        words_of(item.to_token_stream(), &mut words);
        let names = ('i'..='z').chain('a'..='h').map(|letter| format_ident!("{letter}"));
        // Letters that other variables may have are left to these, but for those which loops have nearly always.
        let usual = ["i", "j", "k", "d"];
        let free = names.filter(|name| usual.iter().any(|usual| name == usual) || !words.contains(&name.to_string()));
        let free = free.chain((0..40).map(|count| format_ident!("index_{count}"))).collect();
        Self { scheme, free, scopes: Scopes(vec![Vec::new()]), depth: 0, count: 0 }
    }

    /// The name for the next variable of a loop with so many loops inside.
    fn next(&mut self, height: usize) -> Ident {
        self.count += 1;
        let place = match self.scheme {
            Scheme::ByDepth => self.depth,
            Scheme::ByHeight => height,
            Scheme::Swapped => (self.depth + self.count) % 2 + 2 * self.depth,
            Scheme::Apart => self.count + 8,
        };
        self.free[place % self.free.len()].clone()
    }

    fn loop_over(&mut self, pattern: &mut dyn FnMut(&mut Binder<'_>), height: usize, inside: impl FnOnce(&mut Self)) {
        self.scopes.0.push(Vec::new());
        let mut bound = Vec::new();
        pattern(&mut Binder(&mut bound));
        // Only the first variable is an index; others would need names of their own.
        for (place, name) in bound.into_iter().enumerate() {
            let other = if place == 0 { self.next(height) } else { name.clone() };
            self.scopes.bind(&name, other);
        }
        self.depth += 1;
        inside(self);
        self.depth -= 1;
        self.scopes.0.pop();
    }
}

/// Collects what a pattern binds.
struct Binder<'b>(&'b mut Vec<Ident>);

impl VisitMut for Binder<'_> {
    fn visit_pat_ident_mut(&mut self, pattern: &mut PatIdent) {
        self.0.push(pattern.ident.clone());
    }
}

fn words_of(tokens: TokenStream, words: &mut BTreeSet<String>) {
    for token in tokens {
        match token {
            TokenTree::Ident(name) => {
                words.insert(name.to_string());
            }
            TokenTree::Group(group) => words_of(group.stream(), words),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

impl VisitMut for Renamed {
    fn visit_expr_for_loop_mut(&mut self, looped: &mut ExprForLoop) {
        self.visit_expr_mut(&mut looped.expr);
        let mut height = Height::default();
        height.visit_block(&looped.body);
        let mut pattern = looped.pat.clone();
        self.loop_over(&mut |binder| binder.visit_pat_mut(&mut pattern), height.1, |own| {
            own.visit_pat_mut(&mut looped.pat);
            own.visit_block_mut(&mut looped.body);
        });
    }

    fn visit_expr_closure_mut(&mut self, closure: &mut ExprClosure) {
        let mut height = Height::default();
        height.visit_expr(&closure.body);
        let mut inputs = closure.inputs.clone();
        self.loop_over(
            &mut |binder| inputs.iter_mut().for_each(|input| binder.visit_pat_mut(input)),
            height.1,
            |own| {
                visit_mut::visit_expr_closure_mut(own, closure);
            },
        );
    }

    fn visit_block_mut(&mut self, block: &mut Block) {
        self.scopes.0.push(Vec::new());
        for statement in &mut block.stmts {
            visit_mut::visit_stmt_mut(self, statement);
            if let Stmt::Local(local) = statement {
                let mut bound = Vec::new();
                Binder(&mut bound).visit_pat_mut(&mut local.pat);
                bound.into_iter().for_each(|name| self.scopes.bind(&name.clone(), name));
            }
        }
        self.scopes.0.pop();
    }

    fn visit_local_mut(&mut self, local: &mut Local) {
        // What is declared keeps its name.
        if let Some(init) = &mut local.init {
            self.visit_expr_mut(&mut init.expr);
            if let Some((_, other)) = &mut init.diverge {
                self.visit_expr_mut(other);
            }
        }
    }

    fn visit_pat_ident_mut(&mut self, pattern: &mut PatIdent) {
        if let Some(other) = self.scopes.find(&pattern.ident) {
            pattern.ident = other;
        }
    }

    fn visit_expr_path_mut(&mut self, path: &mut ExprPath) {
        rename_path(&self.scopes, path);
    }

    fn visit_macro_mut(&mut self, called: &mut Macro) {
        called.tokens = self.scopes.in_tokens(std::mem::take(&mut called.tokens));
    }
}

fn rename_path(scopes: &Scopes, path: &mut ExprPath) {
    if path.qself.is_none()
        && let Some(name) = path.path.get_ident()
        && let Some(other) = scopes.find(name)
    {
        path.path = other.into();
    }
}

/// Gives each variable a number, in the order in which they are bound.
#[derive(Default)]
pub(crate) struct Numbered {
    scopes: Scopes,
    count: usize,
}

impl Numbered {
    fn inside(&mut self, visit: impl FnOnce(&mut Self)) {
        self.scopes.0.push(Vec::new());
        visit(self);
        self.scopes.0.pop();
    }

    /// An item sees no variables of what is around it.
    fn item(&mut self, visit: impl FnOnce(&mut Self)) {
        let around = std::mem::take(&mut self.scopes);
        self.inside(visit);
        self.scopes = around;
    }
}

impl VisitMut for Numbered {
    fn visit_attributes_mut(&mut self, attributes: &mut Vec<syn::Attribute>) {
        attributes.clear();
    }
    fn visit_impl_item_fn_mut(&mut self, function: &mut ImplItemFn) {
        self.item(|own| visit_mut::visit_impl_item_fn_mut(own, function));
    }
    fn visit_item_fn_mut(&mut self, function: &mut ItemFn) {
        self.item(|own| visit_mut::visit_item_fn_mut(own, function));
    }
    fn visit_block_mut(&mut self, block: &mut Block) {
        self.inside(|own| visit_mut::visit_block_mut(own, block));
    }
    fn visit_local_mut(&mut self, local: &mut Local) {
        if let Some(init) = &mut local.init {
            self.visit_local_init_mut(init);
        }
        self.visit_pat_mut(&mut local.pat);
    }
    fn visit_expr_for_loop_mut(&mut self, looped: &mut ExprForLoop) {
        self.visit_expr_mut(&mut looped.expr);
        self.inside(|own| {
            own.visit_pat_mut(&mut looped.pat);
            own.visit_block_mut(&mut looped.body);
        });
    }
    fn visit_expr_closure_mut(&mut self, closure: &mut ExprClosure) {
        self.inside(|own| visit_mut::visit_expr_closure_mut(own, closure));
    }
    fn visit_arm_mut(&mut self, arm: &mut Arm) {
        self.inside(|own| visit_mut::visit_arm_mut(own, arm));
    }
    fn visit_pat_ident_mut(&mut self, pattern: &mut PatIdent) {
        if pattern.ident.to_string().starts_with(|letter: char| letter.is_lowercase() || letter == '_') {
            let other = format_ident!("v{}", self.count);
            self.count += 1;
            self.scopes.bind(&pattern.ident, other.clone());
            pattern.ident = other;
        }
    }
    fn visit_expr_path_mut(&mut self, path: &mut ExprPath) {
        rename_path(&self.scopes, path);
    }
    fn visit_field_value_mut(&mut self, field: &mut FieldValue) {
        field.colon_token = Some(Default::default());
        visit_mut::visit_field_value_mut(self, field);
    }
    fn visit_field_pat_mut(&mut self, field: &mut FieldPat) {
        field.colon_token = Some(Default::default());
        visit_mut::visit_field_pat_mut(self, field);
    }
    /// The hash of the code has the names in it.
    fn visit_impl_item_const_mut(&mut self, constant: &mut ImplItemConst) {
        if constant.ident == "FINGERPRINT" {
            constant.expr = syn::parse_quote!(0);
        }
        visit_mut::visit_impl_item_const_mut(self, constant);
    }
    /// Messages say what the user calls an index.
    fn visit_lit_str_mut(&mut self, text: &mut LitStr) {
        *text = LitStr::new("", text.span());
    }
    fn visit_macro_mut(&mut self, called: &mut Macro) {
        called.tokens = self.scopes.in_tokens(std::mem::take(&mut called.tokens));
    }
}
