//! Declared invariants: `#[invariant]` on methods of the impl that take positions and momenta.

use crate::graph::{NodeId, Part};
use crate::model::{
    Reader,
    code::{
        attributes::invariant_attributes,
        shape::{Shape, WholeSignature, is_f64, mismatch, whole_signature},
    },
};
use proc_macro2::{Ident, TokenStream};
use syn::{FnArg, ImplItemFn, Meta, ReturnType};

/// A function of positions and momenta that is said to stay as it is.
pub(crate) struct Invariant {
    pub(crate) name: Ident,
    pub(crate) value: NodeId,
    /// What the user's function is called with, where `self`, and references `q` and `p` to the coordinates are at hand.
    pub(crate) arguments: Vec<TokenStream>,
}

impl Reader<'_> {
    /// The invariants of a system with coordinates of this shape; what is wrong with them is noted.
    pub(crate) fn invariants(&mut self, shape: &Shape) -> Vec<Invariant> {
        let input = self.input;
        let mut found: Vec<Invariant> = Vec::new();
        for method in input.functions() {
            let mut attributes = invariant_attributes(method);
            let Some(attribute) = attributes.next() else { continue };
            if let Some(again) = attributes.next() {
                self.errors.at(again, "`#[invariant]` is given twice");
            }
            if !matches!(attribute.meta, Meta::Path(_)) {
                self.errors.at(attribute, "`#[invariant]` takes no arguments");
            }
            let name = &method.sig.ident;
            if found.iter().any(|other| other.name == *name) {
                self.errors.at(name, format!("the invariant `{name}` is defined twice\nhelp: rename this function"));
                continue;
            }
            found.extend(self.invariant(method, shape));
        }
        found
    }

    fn invariant(&mut self, method: &ImplItemFn, shape: &Shape) -> Option<Invariant> {
        let name = &method.sig.ident;
        if !fits(method) {
            let kind = shape.text();
            let message = format!(
                "an invariant has to be a function of positions and momenta\nhelp: write `fn {name}(&self, q: {kind}, \
                 p: {kind}) -> f64`"
            );
            self.errors.at(&method.sig, message);
            return None;
        }
        if is_column(&name.to_string()) {
            let message = format!("`{name}` is the name of a column in output files\nhelp: rename the invariant");
            self.errors.at(name, message);
            return None;
        }
        let signature = whole_signature(method, self.errors)?;
        let WholeSignature { shape: own, time, .. } = &signature;
        if let Some(time) = time {
            let message = "an invariant does not depend on time\nhelp: remove this argument";
            self.errors.at(time, message);
            return None;
        }
        if mismatch((own, ""), (shape, "")).is_some() {
            let message = format!("H has the coordinates `{}`, and these are `{}`", shape.text(), own.text());
            self.errors.at(&method.sig.inputs, message);
            return None;
        }
        self.may_mix = true;
        let value = self.whole_value(method, &signature);
        self.may_mix = false;
        let value = value?;
        let Some(value) = self.real(&value) else {
            let message = format!("`{name}` has to return an `f64`, but ends in {}", value.describe());
            self.errors.at(method.block.stmts.last(), message);
            return None;
        };
        if ![Part::Position, Part::Momentum].into_iter().any(|part| self.graph.reads(value, part)) {
            let message = format!("the invariant `{name}` depends on neither positions nor momenta");
            self.errors.at(name, message);
            return None;
        }
        Some(Invariant { name: name.clone(), value, arguments: signature.arguments })
    }
}

/// Whether samples have a column of this name: the time, the energy, and coordinates with their indices.
fn is_column(name: &str) -> bool {
    let of_coordinates = name.strip_prefix(['q', 'p']);
    let is_index = |rest: &str| rest.chars().all(|letter| letter.is_ascii_digit() || letter == '_');
    matches!(name, "t" | "energy") || of_coordinates.is_some_and(is_index)
}

/// Whether a method takes two arguments that are no numbers, beside what it may not take, and returns a number.
fn fits(method: &ImplItemFn) -> bool {
    let is_coordinates = |argument: &FnArg| matches!(argument, FnArg::Typed(argument) if !is_f64(&argument.ty));
    let number = matches!(&method.sig.output, ReturnType::Type(_, kind) if is_f64(kind));
    number
        && method.sig.receiver().is_some()
        && method.sig.inputs.iter().filter(|input| is_coordinates(input)).count() == 2
}
