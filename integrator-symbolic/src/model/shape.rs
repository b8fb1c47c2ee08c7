//! The arguments of the two functions: their shapes, and which is which.

use crate::{errors::Errors, graph::Part};
use quote::ToTokens;
use syn::{Expr, ExprLit, FnArg, ImplItemFn, Lit, Pat, PatType, ReceiverKind, ReturnType, Type};

/// The length of an array of coordinates.
#[derive(Clone)]
pub(crate) enum Length {
    /// A number.
    Literal(u64),
    /// A constant of the user.
    Constant(Expr),
}

impl Length {
    fn of(expression: &Expr) -> Self {
        match expression {
            Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => {
                number.base10_parse().map_or_else(|_| Self::Constant(expression.clone()), Self::Literal)
            }
            _ => Self::Constant(expression.clone()),
        }
    }

    pub(crate) fn literal(&self) -> Option<u64> {
        match self {
            Self::Literal(length) => Some(*length),
            Self::Constant(_) => None,
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Literal(length) => length.to_string(),
            Self::Constant(expression) => expression.to_token_stream().to_string(),
        }
    }
}

/// The shape of the coordinates: numbers or points, and how many.
#[derive(Clone)]
pub(crate) struct Shape {
    /// How many numbers or points.
    pub(crate) length: Length,
    /// How many components a point has; `None` for numbers.
    pub(crate) dimension: Option<Length>,
}

impl Shape {
    /// How many indices lead to a number.
    pub(crate) fn rank(&self) -> usize {
        1 + usize::from(self.dimension.is_some())
    }

    /// The length that the index at `level` runs over.
    pub(crate) fn extent(&self, level: usize) -> Option<&Length> {
        match level {
            0 => Some(&self.length),
            1 => self.dimension.as_ref(),
            _ => None,
        }
    }

    /// The shape as a type of the user's language.
    pub(crate) fn text(&self) -> String {
        let length = self.length.text();
        match &self.dimension {
            None => format!("[f64; {length}]"),
            Some(dimension) => format!("[[f64; {}]; {length}]", dimension.text()),
        }
    }

    fn of(kind: &Type, errors: &mut Errors) -> Option<Self> {
        let outer = array(peeled(kind), errors)?;
        let (element, length) = (peeled(&outer.elem), Length::of(&outer.len));
        if is_f64(element) {
            return Some(Self { length, dimension: None });
        }
        let inner = array(element, errors)?;
        if !is_f64(peeled(&inner.elem)) {
            errors.at(&inner.elem, "coordinates are f64 numbers: write `[f64; N]` or `[[f64; D]; N]`");
            return None;
        }
        Some(Self { length, dimension: Some(Length::of(&inner.len)) })
    }
}

fn array<'t>(kind: &'t Type, errors: &mut Errors) -> Option<&'t syn::TypeArray> {
    match kind {
        Type::Array(array) => Some(array),
        other => {
            errors.at(other, "coordinates are f64 numbers: write `[f64; N]` or `[[f64; D]; N]`, or a reference to one");
            None
        }
    }
}

fn peeled(kind: &Type) -> &Type {
    match kind {
        Type::Reference(reference) => peeled(&reference.elem),
        Type::Paren(inner) => peeled(&inner.elem),
        Type::Group(inner) => peeled(&inner.elem),
        other => other,
    }
}

pub(crate) fn is_f64(kind: &Type) -> bool {
    matches!(peeled(kind), Type::Path(path) if path.qself.is_none() && path.path.is_ident("f64"))
}

/// The arguments of one of the two functions.
pub(crate) struct Signature<'f> {
    /// The function's own coordinates.
    pub(crate) own: &'f Pat,
    pub(crate) shape: Shape,
    /// The other part's coordinates, which the function may not have; noted as a mistake where they are read.
    pub(crate) foreign: Option<&'f PatType>,
    /// The explicit time.
    pub(crate) time: Option<&'f Pat>,
}

/// The name that the coordinates of a part usually have.
pub(crate) fn usual_name(part: Part) -> &'static str {
    match part {
        Part::Position => "q",
        Part::Momentum => "p",
    }
}

fn other(part: Part) -> Part {
    match part {
        Part::Position => Part::Momentum,
        Part::Momentum => Part::Position,
    }
}

fn is_named(pattern: &Pat, name: &str) -> bool {
    matches!(pattern, Pat::Ident(pattern) if pattern.ident == name)
}

/// Reads the signature of `function`, which gives the energy of `part`.
pub(crate) fn signature<'f>(function: &'f ImplItemFn, part: Part, errors: &mut Errors) -> Option<Signature<'f>> {
    let (name, letter) = (&function.sig.ident, usual_name(part));
    match &function.sig.output {
        ReturnType::Type(_, kind) if is_f64(kind) => {}
        ReturnType::Type(_, kind) => errors.at(kind, format!("`{name}` gives an energy: it has to return f64")),
        ReturnType::Default => errors.at(name, format!("`{name}` gives an energy: it has to return f64, `-> f64`")),
    }
    let mut coordinates = Vec::new();
    let mut time = None;
    for argument in &function.sig.inputs {
        match argument {
            FnArg::Receiver(receiver) if !matches!(receiver.kind, ReceiverKind::Reference(_, _, None)) => {
                errors.at(receiver, format!("`{name}` only looks at the parameters: it has to take `&self`"));
            }
            FnArg::Receiver(_) => {}
            FnArg::Typed(argument) if is_f64(&argument.ty) && !coordinates.is_empty() && time.is_none() => {
                time = Some(&*argument.pat);
            }
            FnArg::Typed(argument) => coordinates.push(argument),
        }
    }
    let (own, foreign) = match coordinates[..] {
        [own] => (own, None),
        [first, second] if is_named(&first.pat, letter) || is_named(&second.pat, usual_name(other(part))) => {
            (first, Some(second))
        }
        [first, second] => (second, Some(first)),
        [] => {
            let message = format!("`{name}` has no coordinates: write `fn {name}(&self, {letter}: [f64; N]) -> f64`");
            errors.at(name, message);
            return None;
        }
        _ => {
            errors
                .at(&function.sig.inputs, format!("`{name}` takes `&self`, `{letter}` and perhaps the time, `t: f64`"));
            return None;
        }
    };
    let wrong = usual_name(other(part));
    if foreign.is_none() && is_named(&own.pat, wrong) {
        let of = if part == Part::Position { "positions" } else { "momenta" };
        errors.at(&own.pat, format!("`{name}` is a function of the {of}: call its argument `{letter}`, not `{wrong}`"));
    }
    Some(Signature { own: &own.pat, shape: Shape::of(&own.ty, errors)?, foreign, time })
}
