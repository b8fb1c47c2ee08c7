//! What is written compiles as far as names tell: fields have one declaration, and what is read was given a name before, in the
//! same function.

use integrator_symbolic::hamiltonian;
use proc_macro2::TokenStream;
use std::collections::BTreeSet;
use syn::{
    Expr, ExprClosure, ExprForLoop, ExprPath, ImplItemFn, ItemFn, ItemStruct, Local, PatIdent, Stmt,
    visit::{self, Visit},
};

/// The names in scope, one set per block.
#[derive(Default)]
struct Scopes {
    blocks: Vec<BTreeSet<String>>,
    faults: Vec<String>,
}

impl Scopes {
    /// Walks through a part of the text whose names end with it.
    fn inside(&mut self, walk: impl FnOnce(&mut Self)) {
        self.blocks.push(BTreeSet::new());
        walk(self);
        self.blocks.pop();
    }

    /// The same for an item, which sees nothing of what is around it.
    fn item(&mut self, walk: impl FnOnce(&mut Self)) {
        let around = std::mem::take(&mut self.blocks);
        self.inside(walk);
        self.blocks = around;
    }

    fn bind(&mut self, name: String) {
        self.blocks.last_mut().expect("a block").insert(name);
    }
}

impl<'t> Visit<'t> for Scopes {
    fn visit_item_struct(&mut self, item: &'t ItemStruct) {
        let mut names = BTreeSet::new();
        for field in &item.fields {
            if field.ident.as_ref().is_some_and(|name| !names.insert(name.to_string())) {
                self.faults.push(format!("`{}` has a field twice", item.ident));
            }
        }
    }

    fn visit_impl_item_fn(&mut self, function: &'t ImplItemFn) {
        self.item(|scopes| visit::visit_impl_item_fn(scopes, function));
    }

    fn visit_item_fn(&mut self, function: &'t ItemFn) {
        self.item(|scopes| visit::visit_item_fn(scopes, function));
    }

    fn visit_receiver(&mut self, _: &'t syn::Receiver) {
        self.bind("self".to_owned());
    }

    fn visit_block(&mut self, block: &'t syn::Block) {
        self.inside(|scopes| {
            for statement in &block.stmts {
                if let Stmt::Item(syn::Item::Fn(function)) = statement {
                    scopes.bind(function.sig.ident.to_string());
                }
            }
            visit::visit_block(scopes, block);
        });
    }

    fn visit_local(&mut self, local: &'t Local) {
        if let Some(init) = &local.init {
            self.visit_expr(&init.expr);
        }
        self.visit_pat(&local.pat);
    }

    fn visit_expr_for_loop(&mut self, looped: &'t ExprForLoop) {
        self.visit_expr(&looped.expr);
        self.inside(|scopes| {
            scopes.visit_pat(&looped.pat);
            scopes.visit_block(&looped.body);
        });
    }

    fn visit_expr_closure(&mut self, closure: &'t ExprClosure) {
        self.inside(|scopes| visit::visit_expr_closure(scopes, closure));
    }

    fn visit_pat_ident(&mut self, pattern: &'t PatIdent) {
        self.bind(pattern.ident.to_string());
    }

    fn visit_expr_path(&mut self, path: &'t ExprPath) {
        let Some(name) = path.path.get_ident().filter(|_| path.qself.is_none()) else { return };
        let name = name.to_string();
        let is_value = name.starts_with(|letter: char| letter.is_lowercase());
        if is_value && !self.blocks.iter().any(|block| block.contains(&name)) {
            self.faults.push(format!("`{name}` is not known"));
        }
    }

    fn visit_expr(&mut self, expression: &'t Expr) {
        visit::visit_expr(self, expression);
    }
}

/// Potentials of two loops over the same coordinates, with conditions on sums, on coordinates and on the time.
fn potentials() -> Vec<String> {
    let first = ["x * x", "t * x.sin()", "x.cos()"];
    let second = ["x.cos()", "t * x.sin() * x.cos()"];
    let conditions = ["true", "s > 0.5", "*x > 0.1", "t < 1.0", "s > 0.5 && *x < 0.2", "(t % 0.7).cosh() < 1.1"];
    let ends = ["z", "s * z", "if z < 1.0 { q[0] * t } else { z }", "z * t.clamp(-0.7, 0.8)"];
    let mut found = Vec::new();
    for (first, second) in first.iter().flat_map(|first| second.map(|second| (first, second))) {
        for (condition, end) in conditions.iter().flat_map(|condition| ends.map(|end| (condition, end))) {
            found.push(format!(
                "let mut s = 0.0; for x in q {{ s += {first}; }}
                 let mut z = 0.0; for x in q {{ if {condition} {{ z += {second}; }} }}
                 {end}"
            ));
            if !condition.contains('x') {
                found.push(format!(
                    "let mut s = 0.0; for x in q {{ s += {first}; }}
                     let mut z = 0.0; if {condition} {{ for x in q {{ z += {second}; }} }}
                     {end}"
                ));
            }
        }
    }
    // A power of the parameters that the kick computes in two branches, each behind its own reading of a coordinate.
    let chosen = "(if self.b <= self.a { q[0] - q[0] } else { 2.5_f64.powi(self.pw) })";
    found.push(format!(
        "let v = (1.0 + {chosen} * {chosen}).powi(self.pw);
         let mut z = 0.0; for x in q {{ z += x.cos(); }}
         -(q[2] + q[2]) - (q[2].abs() + 1.0).log10().clamp(-0.7, 0.8)
             + ((if self.flag {{ (1.0 + v * v).powi(self.pw) }} else {{ q[0] }}) - (self.a + q[0] * q[2])) + v + z * z"
    ));
    found
}

/// Every name in what is written for each potential of a shape of coordinates is known where it is read.
fn every_name_is_known(shape: &str) {
    let mut count = 0;
    for potential in potentials() {
        let item = format!(
            "impl S {{
                fn kinetic(&self, p: {shape}) -> f64 {{ p.iter().map(|x| x * x / 2.0).sum() }}
                fn potential(&self, q: {shape}, t: f64) -> f64 {{ {potential} }}
            }}"
        );
        let arguments: TokenStream = "taylor".parse().expect("tokens");
        let text = hamiltonian(arguments, item.parse().expect("tokens"));
        let mut file: syn::File = syn::parse2(text).expect("items");
        file.items.remove(0);
        let mut scopes = Scopes::default();
        scopes.visit_file(&file);
        assert!(scopes.faults.is_empty(), "{:?} in\n{item}\n{}", scopes.faults, prettyplease::unparse(&file));
        // Both loops of a potential move momenta in a product with the Hessian, which is not zero.
        let moved = prettyplease::unparse(&file).matches("gradient[").count();
        assert!(moved > 1, "no Hessian in\n{item}");
        count += 1;
    }
    assert!(count > 100, "{count}");
}

#[test]
fn every_name_is_known_in_lists() {
    every_name_is_known("&[f64]");
}

#[test]
fn every_name_is_known_in_arrays() {
    every_name_is_known("&[f64; 3]");
}
