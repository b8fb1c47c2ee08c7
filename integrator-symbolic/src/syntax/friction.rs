//! The functions annotated with `#[friction]` and `#[temperature]`, and their place in `split`.

use super::split::{NOT_LAST, Parts};
use crate::errors::Errors;
use syn::{FnArg, Ident, ImplItem, ImplItemFn, ItemImpl, Meta, Pat, PatType, ReturnType, Type};

/// The attribute of the function that gives the rate of friction of each coordinate.
pub(crate) const FRICTION: &str = "friction";
/// The attribute of the function that gives its temperature.
pub(crate) const TEMPERATURE: &str = "temperature";

/// Friction, and the temperature of its noise.
pub(crate) struct Friction {
    pub(crate) rate: RateFunction,
    pub(crate) temperature: Option<RateFunction>,
}

/// A function of the index of a coordinate and perhaps of the time.
pub(crate) struct RateFunction {
    pub(crate) name: Ident,
    /// Whether it takes the time.
    pub(crate) reads_time: bool,
}

impl Friction {
    /// Reads the annotated functions, and takes the name of friction out of the parts of H.
    pub(super) fn of(item: &ItemImpl, parts: &mut Parts, errors: &mut Errors) -> Option<Self> {
        let rate = annotated(item, FRICTION, errors);
        let temperature = annotated(item, TEMPERATURE, errors);
        let trailing = parts.trailing.take();
        let Some(rate) = rate else {
            if let Some(temperature) = temperature {
                let message = "a temperature requires friction, whose noise it determines\nhelp: add `#[friction] fn \
                               friction(&self, i: usize) -> f64`";
                errors.at(&temperature.name, message);
            }
            for name in parts.names.extract_if(.., |name| takes_index(item, name)) {
                let message = format!("`{name}` is a function of an index\nhelp: annotate it with `#[friction]`");
                errors.at(name, message);
            }
            if let Some(name) = trailing {
                errors.at(name, NOT_LAST);
            }
            return None;
        };
        let is_split = !parts.names.is_empty() || trailing.is_some();
        let count = parts.names.len();
        let levels = parts.nests.iter().map(|nest| nest.first).min().unwrap_or(count);
        let at = parts.names.iter().position(|name| *name == rate.name).filter(|at| *at < levels);
        match at {
            Some(at) => {
                parts.names.remove(at);
                parts.nests.iter_mut().for_each(|nest| nest.first -= 1);
            }
            None if trailing.as_ref().is_some_and(|name| *name == rate.name) => {}
            None if is_split => {
                let message = format!("`split` does not name the friction\nhelp: write `split = .. + {}`", rate.name);
                errors.at(&rate.name, message);
            }
            None => {}
        }
        // The same as without `split`.
        if parts.nests.is_empty() && parts.names.iter().map(ToString::to_string).eq(["kinetic", "potential"]) {
            parts.names.clear();
        }
        Some(Self { rate, temperature })
    }
}

/// Whether a function of this name takes one index and nothing else.
fn takes_index(item: &ItemImpl, name: &Ident) -> bool {
    item.items.iter().any(|item| match item {
        ImplItem::Fn(function) if function.sig.ident == *name => {
            match function.sig.inputs.iter().collect::<Vec<_>>()[..] {
                [FnArg::Receiver(_), FnArg::Typed(index)] => is_of_type(index, "usize"),
                _ => false,
            }
        }
        _ => false,
    })
}

/// Whether an argument is of a type with this name.
fn is_of_type(argument: &PatType, name: &str) -> bool {
    matches!(&*argument.ty, Type::Path(path) if path.path.is_ident(name))
}

/// The function with an attribute.
fn annotated(item: &ItemImpl, attribute: &str, errors: &mut Errors) -> Option<RateFunction> {
    let mut found: Option<RateFunction> = None;
    for item in &item.items {
        let ImplItem::Fn(function) = item else { continue };
        let Some(own) = function.attrs.iter().find(|own| own.path().is_ident(attribute)) else { continue };
        if !matches!(own.meta, Meta::Path(_)) {
            errors.at(own, format!("`#[{attribute}]` takes no arguments"));
        }
        if let Some(first) = &found {
            let message =
                format!("`{}` is annotated with `#[{attribute}]` already\nhelp: use one function", first.name);
            errors.at(&function.sig.ident, message);
            continue;
        }
        found = rate_function(function, attribute, errors);
    }
    found
}

/// A function `(&self, i: usize) -> f64`, or `(&self, i: usize, t: f64) -> f64`.
fn rate_function(function: &ImplItemFn, attribute: &str, errors: &mut Errors) -> Option<RateFunction> {
    let signature = &function.sig;
    let is = |argument: &PatType, kind: &str| {
        is_of_type(argument, kind) && matches!(&*argument.pat, Pat::Ident(_) | Pat::Wild(_))
    };
    let arguments: Vec<_> = signature.inputs.iter().collect();
    let reads_time = match &arguments[..] {
        [FnArg::Receiver(_), FnArg::Typed(index)] if is(index, "usize") => Some(false),
        [FnArg::Receiver(_), FnArg::Typed(index), FnArg::Typed(time)] if is(index, "usize") && is(time, "f64") => {
            Some(true)
        }
        _ => None,
    };
    let returns = matches!(&signature.output, ReturnType::Type(_, kind) if matches!(&**kind, Type::Path(path) if path.path.is_ident("f64")));
    let Some(reads_time) = reads_time.filter(|_| returns) else {
        let message = format!(
            "`#[{attribute}]` requires a function of the index of a coordinate or a point, and optionally of the time\nhelp: write \
             `fn {name}(&self, i: usize) -> f64` or `fn {name}(&self, i: usize, t: f64) -> f64`",
            name = signature.ident
        );
        errors.at(signature, message);
        return None;
    };
    Some(RateFunction { name: signature.ident.clone(), reads_time })
}
