//! What the macro writes for a system, taken apart for the interpreter.

use crate::{
    calls::names_of,
    drivers::{Bodies, Boundary, Driven, Lattice},
    machine::Machine,
};
use proc_macro2::TokenStream;
use std::collections::HashMap;
use syn::{Expr, ImplItem, ImplItemFn, Item, ItemImpl, ItemStruct, Stmt};

/// The generated items, or why the macro refused.
pub(crate) struct Expansion {
    structs: Vec<ItemStruct>,
    impls: Vec<ItemImpl>,
}

impl Expansion {
    /// The expansion of an annotated impl; the messages of the macro where it refuses.
    pub(crate) fn of(item: TokenStream) -> Result<Self, String> {
        Self::read(integrator_symbolic::hamiltonian(TokenStream::new(), item))
    }

    /// The generated items in the output of the macro.
    pub(crate) fn read(output: TokenStream) -> Result<Self, String> {
        let file: syn::File = syn::parse2(output).map_err(|error| format!("the output is no file: {error}"))?;
        let mut found = Self { structs: Vec::new(), impls: Vec::new() };
        let mut refusal = String::new();
        for item in file.items {
            match item {
                Item::Macro(message) => refusal += &message.mac.tokens.to_string(),
                Item::Const(scope) => {
                    let Expr::Block(block) = *scope.expr else { continue };
                    for statement in block.block.stmts {
                        match statement {
                            Stmt::Item(Item::Struct(item)) => found.structs.push(item),
                            Stmt::Item(Item::Impl(item)) => found.impls.push(item),
                            _ => {}
                        }
                    }
                }
                _ => {}
            }
        }
        if refusal.is_empty() { Ok(found) } else { Err(refusal) }
    }

    /// The implementation of a trait of the runtime, perhaps with a type argument.
    fn implementation(&self, of: &str, argument: &str) -> Option<&ItemImpl> {
        self.impls.iter().find(|item| {
            let Some(last) = item.trait_.as_ref().and_then(|(path, _)| path.segments.last()) else { return false };
            let arguments = &last.arguments;
            last.ident == of && quote::quote!(#arguments).to_string().contains(argument)
        })
    }

    /// A function of the stepper.
    pub(crate) fn function(&self, name: &str) -> Option<&ImplItemFn> {
        function(self.implementation("System", "")?, name)
    }

    /// What tells the runtime the derivatives of the part with this number, where that is a quadratic form.
    pub(crate) fn derivatives(&self, part: usize) -> Option<&ImplItemFn> {
        function(self.implementation("QuadraticPart", &part.to_string())?, "derivatives")
    }

    /// The flows as text for devices, and what adds the constants that they read to a list.
    pub(crate) fn device_text(&self) -> Option<(String, &ImplItemFn)> {
        let written = self.implementation("DeviceText", "")?;
        let Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = constant(written, "TEXT")? else { return None };
        Some((text.value(), function(written, "push_constants")?))
    }

    /// A flow, or the product with the Hessian of `V`.
    pub(crate) fn flow(&self, name: &str) -> Option<&ImplItemFn> {
        self.function(name).or_else(|| function(self.implementation("QuadraticKinetic", "")?, name))
    }

    /// What tells prepared constants the middle of a step, where conditions on the time alone are read.
    pub(crate) fn begin_step(&self) -> Option<&ImplItemFn> {
        function(self.implementation("Prepared", "")?, "begin_step")
    }

    /// Lets a machine find what the generated text names.
    pub(crate) fn teach<'t>(&'t self, machine: &mut Machine<'t>) {
        machine.is_generated = true;
        machine.structs = self.structs.iter().map(|item| (item.ident.to_string(), item)).collect();
        let [drift, kick, kinetic, potential] = ["Drift", "Kick", "KineticEnergy", "PotentialEnergy"]
            .map(|flow| lattice(self.implementation("Stencil", flow)?));
        machine.driven = Driven { drift, kick, kinetic, potential, bodies: self.bodies() };
    }

    fn bodies(&self) -> Option<Bodies<'_>> {
        let (system, constants) = (self.implementation("ManyBody", "")?, self.implementation("BodyConstants", "")?);
        let functions = [
            "drift_body",
            "pair",
            "interacts",
            "included",
            "one_body",
            "other_terms",
            "energy",
            "energy_alone",
            "triplet",
            "triplet_energy",
        ];
        let functions = functions.into_iter().filter_map(|name| Some((name.to_owned(), function(system, name)?)));
        let body_constants =
            function(constants, "body_constants").map(|function| ("body_constants".to_owned(), function));
        let [reciprocal, central] = ["RECIPROCAL", "CENTRAL"].map(|name| text(system, name) == "true");
        let functions: HashMap<_, _> = functions.chain(body_constants).collect();
        Some(Bodies { functions, reciprocal, central })
    }
}

pub(crate) fn function<'i>(item: &'i ItemImpl, name: &str) -> Option<&'i ImplItemFn> {
    item.items.iter().find_map(|item| match item {
        ImplItem::Fn(function) if function.sig.ident == name => Some(function),
        _ => None,
    })
}

/// The value of a constant as text.
fn text(item: &ItemImpl, name: &str) -> String {
    constant(item, name).map(|value| quote::quote!(#value).to_string()).unwrap_or_default()
}

pub(crate) fn constant<'i>(item: &'i ItemImpl, name: &str) -> Option<&'i Expr> {
    item.items.iter().find_map(|item| match item {
        ImplItem::Const(constant) if constant.ident == name => Some(&constant.expr),
        _ => None,
    })
}

fn lattice(item: &ItemImpl) -> Option<Lattice<'_>> {
    let sites = boundary(constant(item, "BOUNDARY")?).unwrap_or_default();
    let rows = constant(item, "ROW_BOUNDARY").and_then(|rows| match rows {
        Expr::Call(some) => boundary(some.args.first()?),
        _ => None,
    });
    Some(Lattice { shares: function(item, "contributions")?, sites, rows })
}

fn boundary(literal: &Expr) -> Option<Boundary> {
    let Expr::Struct(literal) = literal else { return None };
    if names_of(&literal.path).last()? != "Boundary" {
        return None;
    }
    let value = |name: &str| {
        literal.fields.iter().find_map(|field| match &field.member {
            syn::Member::Named(known) if known == name => {
                let value = &field.expr;
                Some(quote::quote!(#value).to_string())
            }
            _ => None,
        })
    };
    Some(Boundary { forward: value("forward")?.parse().ok()?, periodic: value("periodic")? == "true" })
}
