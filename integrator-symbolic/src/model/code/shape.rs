//! The arguments of the two functions: their shapes, and which one is positions or momenta.

use crate::{
    errors::{Errors, quoted},
    graph::{Part, index::IntegerType},
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};
use syn::{
    Expr, ExprLit, FnArg, GenericArgument, GenericParam, ImplItemFn, Lit, Pat, PatType, PathArguments, ReceiverKind,
    ReturnType, Safety, Type,
};

/// The length of an array of coordinates.
#[derive(Clone)]
pub(crate) enum Length {
    /// A number.
    Literal(u64),
    /// A constant of the user.
    Constant(Box<Expr>),
    /// Known at run time: the length of the start.
    OfStart,
}

impl Length {
    pub(crate) fn of(expression: &Expr) -> Self {
        let constant = || Self::Constant(Box::new(expression.clone()));
        match expression {
            Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => {
                number.base10_parse().map_or_else(|_| constant(), Self::Literal)
            }
            _ => constant(),
        }
    }

    fn is_constant(&self) -> bool {
        matches!(self, Self::Constant(_))
    }

    pub(crate) fn literal(&self) -> Option<u64> {
        match self {
            Self::Literal(length) => Some(*length),
            Self::Constant(_) | Self::OfStart => None,
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Literal(length) => length.to_string(),
            Self::Constant(expression) => quoted(expression),
            Self::OfStart => "..".to_owned(),
        }
    }
}

/// The shape of the coordinates: numbers, points, or planes of sites, and how many.
#[derive(Clone)]
pub(crate) struct Shape {
    /// How many numbers, points or planes.
    pub(crate) length: Length,
    /// What each of them is an array of: nothing for numbers, the components of a point, the rows of a plane and their sites.
    pub(crate) inner: Vec<Length>,
}

impl Shape {
    /// How many indices lead to a number.
    pub(crate) fn rank(&self) -> usize {
        1 + self.inner.len()
    }

    /// The length that the index at `level` runs over.
    pub(crate) fn extent(&self, level: usize) -> Option<&Length> {
        self.extents().nth(level)
    }

    /// The lengths that indices run over, the outermost first.
    pub(crate) fn extents(&self) -> impl Iterator<Item = &Length> {
        std::iter::once(&self.length).chain(&self.inner)
    }

    /// The number of positions, if literals determine it.
    pub(crate) fn numbers(&self) -> Option<u64> {
        self.extents().try_fold(1_u64, |numbers, length| numbers.checked_mul(length.literal()?))
    }

    /// How many components a point has, if coordinates are points.
    pub(crate) fn dimension(&self) -> Option<&Length> {
        match &self.inner[..] {
            [dimension] => Some(dimension),
            _ => None,
        }
    }

    /// Whether coordinates are planes, one after the other.
    pub(crate) fn is_volume(&self) -> bool {
        self.inner.len() == 2
    }

    /// The shape as a type of the user's language.
    pub(crate) fn text(&self) -> String {
        let element =
            self.inner.iter().rev().fold("f64".to_owned(), |element, length| format!("[{element}; {}]", length.text()));
        match &self.length {
            Length::OfStart => format!("&[{element}]"),
            length => format!("[{element}; {}]", length.text()),
        }
    }

    /// Whether a length is a constant, whose value is not known here.
    pub(crate) fn has_constant(&self) -> bool {
        self.extents().any(Length::is_constant)
    }

    fn of(kind: &Type, errors: &mut Errors) -> Option<Self> {
        let Some((element, length)) = elements(kind) else {
            unexpected(peeled(kind), errors);
            return None;
        };
        let (mut inner, mut element) = (Vec::new(), peeled(element));
        while let Type::Array(array) = element
            && inner.len() < DEEPEST
        {
            inner.push(Length::of(&array.len));
            element = unwrapped(&array.elem);
        }
        if !is_f64(element) {
            unexpected(element, errors);
            return None;
        }
        Some(Self { length, inner })
    }
}

/// The most arrays within the coordinates: a plane is one of rows.
const DEEPEST: usize = 2;

const EXPECTED: &str = "this type of coordinates is not supported\nhelp: write `[f64; N]`, `[[f64; D]; N]`, `[[[f64; \
                        L]; M]; N]`, a reference to one of them, or a slice `&[f64]`, `&[[f64; D]]` or `&[[[f64; L]; \
                        M]]`";

/// What to write instead of some types.
const INSTEAD: [(&str, &str); 2] = [
    ("f64", "a single coordinate has to be an array\nhelp: write `[f64; 1]`, and `[0]` for the number"),
    (
        "f32",
        "coordinates have to be written in `f64`\nnote: a run is in single precision if its initial state is in \
             `f32`",
    ),
];

/// Notes a type that coordinates do not have, or may have behind a name of the user's.
fn unexpected(kind: &Type, errors: &mut Errors) {
    const PRIMITIVE: [&str; 4] = ["bool", "char", "str", "String"];
    let name = match kind {
        Type::Path(path) if path.qself.is_none() => path.path.get_ident(),
        _ => None,
    };
    let name = name.map(ToString::to_string);
    if let Some((_, instead)) = INSTEAD.iter().find(|(kind, _)| name.as_deref() == Some(*kind)) {
        errors.at(kind, instead);
        return;
    }
    match name {
        Some(name) if !PRIMITIVE.contains(&name.as_str()) && integer_type(kind).is_none() => {
            let message = format!(
                "the definition of the type `{name}` is not visible to the macro\nhelp: write the array, `[f64; N]` \
                 or `[[f64; D]; N]`"
            );
            errors.at(kind, message);
        }
        _ => errors.at(kind, EXPECTED),
    }
}

/// The type of the elements of an array, or of a list behind a reference, and their number.
fn elements(kind: &Type) -> Option<(&Type, Length)> {
    match (unwrapped(kind), peeled(kind)) {
        (_, Type::Array(array)) => Some((&*array.elem, Length::of(&array.len))),
        (Type::Reference(_), Type::Slice(slice)) => Some((&*slice.elem, Length::OfStart)),
        (Type::Reference(_), list) => Some((element_of_list(list)?, Length::OfStart)),
        _ => None,
    }
}

/// The type of the elements of a `Vec`.
fn element_of_list(kind: &Type) -> Option<&Type> {
    let Type::Path(path) = kind else { return None };
    let last = path.path.segments.last().filter(|last| last.ident == "Vec")?;
    match &last.arguments {
        PathArguments::AngleBracketed(arguments) => match arguments.args.first() {
            Some(GenericArgument::Type(element)) => Some(element),
            _ => None,
        },
        _ => None,
    }
}

/// The type behind all references.
fn peeled(kind: &Type) -> &Type {
    match unwrapped(kind) {
        Type::Reference(reference) => peeled(&reference.elem),
        other => other,
    }
}

/// The type without parentheses.
fn unwrapped(kind: &Type) -> &Type {
    match kind {
        Type::Paren(inner) => unwrapped(&inner.elem),
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
    /// What the function is called with, where `self`, a reference to the coordinates under their usual name and `time` are
    /// at hand.
    pub(crate) arguments: Vec<TokenStream>,
}

/// The name that the coordinates of a part usually have.
pub(crate) fn usual_name(part: Part) -> &'static str {
    match part {
        Part::Position => "q",
        Part::Momentum => "p",
    }
}

/// Whether a pattern is a name, perhaps with the underscore of what is not read.
fn is_named(pattern: &Pat, name: &str) -> bool {
    matches!(pattern, Pat::Ident(pattern) if pattern.ident.to_string().trim_start_matches('_') == name)
}

/// Whether a function takes coordinates.
pub(crate) fn has_coordinates(function: &ImplItemFn) -> bool {
    function.sig.inputs.iter().any(|argument| match argument {
        FnArg::Typed(argument) => Shape::of(&argument.ty, &mut Errors::default()).is_some(),
        FnArg::Receiver(_) => false,
    })
}

/// The arguments of a function that gives an energy.
struct Inputs<'f> {
    coordinates: Vec<&'f PatType>,
    time: Option<&'f Pat>,
    /// What the function is called with.
    arguments: Vec<TokenStream>,
}

/// Sorts the arguments of `function`; the coordinates are at hand under these names, in their order.
fn inputs<'f>(function: &'f ImplItemFn, usual: &[&str], errors: &mut Errors) -> Inputs<'f> {
    let name = &function.sig.ident;
    match &function.sig.output {
        ReturnType::Type(_, kind) if is_f64(kind) => {}
        ReturnType::Type(_, kind) => errors.at(kind, format!("`{name}` has to return an energy of type `f64`")),
        ReturnType::Default => errors.at(name, format!("`{name}` has to return an energy\nhelp: write `-> f64`")),
    }
    callable(function, errors);
    let (mut coordinates, mut time, mut arguments) = (Vec::new(), None, Vec::new());
    for argument in &function.sig.inputs {
        match argument {
            FnArg::Receiver(receiver) if !matches!(receiver.kind, ReceiverKind::Reference(_, _, None)) => {
                errors.at(receiver, format!("`{name}` has to take `&self`"));
            }
            FnArg::Receiver(_) => arguments.push(quote!(self)),
            FnArg::Typed(argument) if is_f64(&argument.ty) && coordinates.len() >= usual.len() && time.is_none() => {
                time = Some(&*argument.pat);
                arguments.push(passed(&argument.ty, &quote!(time), false));
            }
            FnArg::Typed(argument) => {
                let usual = Ident::new(usual[coordinates.len().min(usual.len() - 1)], Span::call_site());
                coordinates.push(argument);
                arguments.push(passed(&argument.ty, &quote!(#usual), true));
            }
        }
    }
    Inputs { coordinates, time, arguments }
}

/// The arguments of a function that gives all of H.
pub(crate) struct WholeSignature<'f> {
    /// The positions and the momenta.
    pub(crate) coordinates: [&'f Pat; 2],
    pub(crate) shape: Shape,
    pub(crate) time: Option<&'f Pat>,
    /// What the function is called with, where `self`, references `q` and `p` to the coordinates, and `time` are at hand.
    pub(crate) arguments: Vec<TokenStream>,
}

/// Reads the signature of a function of positions and momenta.
pub(crate) fn whole_signature<'f>(function: &'f ImplItemFn, errors: &mut Errors) -> Option<WholeSignature<'f>> {
    let name = &function.sig.ident;
    let Inputs { coordinates, time, arguments } = inputs(function, &["q", "p"], errors);
    let [q, p] = coordinates[..] else {
        let message = format!(
            "`{name}` has to take the positions, the momenta and optionally the time\nhelp: write `fn {name}(&self, \
             q: [f64; N], p: [f64; N]) -> f64`"
        );
        errors.at(
            if coordinates.is_empty() { name.to_token_stream() } else { function.sig.inputs.to_token_stream() },
            message,
        );
        return None;
    };
    if is_named(&q.pat, "p") || is_named(&p.pat, "q") {
        errors.at(
            &function.sig.inputs,
            format!("positions have to come before momenta\nhelp: write `fn {name}(&self, q, p)`"),
        );
        return None;
    }
    let (shape, of_momenta) = (Shape::of(&q.ty, errors), Shape::of(&p.ty, errors));
    let (shape, of_momenta) = (shape?, of_momenta?);
    if let Some(message) = mismatch((&shape, ""), (&of_momenta, " here")) {
        errors.at(&p.ty, message);
        return None;
    }
    Some(WholeSignature { coordinates: [&q.pat, &p.pat], shape, time, arguments })
}

/// The coordinates that the function of a part takes, where it takes positions or momenta alone; nothing where it takes
/// both. They are distinguished by the name of the argument.
pub(crate) fn lone_part(function: &ImplItemFn, errors: &mut Errors) -> Option<Option<Part>> {
    let coordinates = function.sig.inputs.iter().filter_map(|argument| match argument {
        FnArg::Typed(argument) if !is_f64(&argument.ty) => Some(argument),
        _ => None,
    });
    let [alone] = coordinates.collect::<Vec<_>>()[..] else { return Some(None) };
    let part = [Part::Position, Part::Momentum].into_iter().find(|part| is_named(&alone.pat, usual_name(*part)));
    if part.is_none() {
        let name = &function.sig.ident;
        let message = format!(
            "this argument of `{name}` may be the positions or the momenta\nhelp: name it `q` or `p`, or write `fn \
             {name}(&self, q: [f64; N], p: [f64; N]) -> f64`"
        );
        errors.at(&alone.pat, message);
    }
    part.map(Some)
}

/// Why positions and momenta of these shapes are not as many, where each stands somewhere.
pub(crate) fn mismatch(positions: (&Shape, &str), momenta: (&Shape, &str)) -> Option<String> {
    let ((of_positions, here), (of_momenta, there)) = (positions, momenta);
    let (q, p) = (of_positions.text(), of_momenta.text());
    let constants = of_positions.has_constant() || of_momenta.has_constant();
    let hint = if constants { "\nnote: lengths are compared by their spelling" } else { "" };
    (q != p)
        .then(|| format!("positions and momenta have different types: q is `{q}`{here}, but p is `{p}`{there}{hint}"))
}

/// Reads the signature of `function`, which gives the energy of `part`.
pub(crate) fn signature<'f>(function: &'f ImplItemFn, part: Part, errors: &mut Errors) -> Option<Signature<'f>> {
    let (name, letter) = (&function.sig.ident, usual_name(part));
    let Inputs { coordinates, time, arguments } = inputs(function, &[letter], errors);
    let (own, foreign) = match coordinates[..] {
        [own] => (own, None),
        [first, second] if is_named(&first.pat, letter) || is_named(&second.pat, usual_name(part.other())) => {
            (first, Some(second))
        }
        [first, second] => (second, Some(first)),
        [] => {
            let message =
                format!("`{name}` has no coordinates\nhelp: write `fn {name}(&self, {letter}: [f64; N]) -> f64`");
            errors.at(name, message);
            return None;
        }
        _ => {
            errors.at(
                &function.sig.inputs,
                format!("`{name}` has to take `&self`, `{letter}` and optionally the time, `t: f64`"),
            );
            return None;
        }
    };
    let wrong = usual_name(part.other());
    if foreign.is_none() && is_named(&own.pat, wrong) {
        let of = if part == Part::Position { "positions" } else { "momenta" };
        errors.at(
            &own.pat,
            format!(
                "`{name}` is a function of the {of}, and its argument is named `{wrong}`\nhelp: name it `{letter}`"
            ),
        );
    }
    Some(Signature { own: &own.pat, shape: Shape::of(&own.ty, errors)?, foreign, time, arguments })
}

/// Notes what keeps a function from being called with values alone.
fn callable(function: &ImplItemFn, errors: &mut Errors) {
    let (name, signature) = (&function.sig.ident, &function.sig);
    let why = "note: the macro calls it, to compare its values with those of the generated code";
    if let Some(word) = &signature.asyncness {
        errors.at(word, format!("`{name}` may not be `async`\n{why}"));
    }
    if let Safety::Unsafe(word) = &signature.safety {
        errors.at(word, format!("`{name}` may not be `unsafe`\n{why}"));
    }
    for generic in signature.generics.params.iter().filter(|generic| !matches!(generic, GenericParam::Lifetime(_))) {
        errors.at(generic, format!("`{name}` may not be generic\nhelp: move the parameter to the impl\n{why}"));
    }
}

/// A value in the form in which an argument of a type takes it; coordinates are at hand by reference.
fn passed(kind: &Type, value: &TokenStream, by_reference: bool) -> TokenStream {
    let Type::Reference(reference) = unwrapped(kind) else {
        return if by_reference { quote!(*#value) } else { value.clone() };
    };
    let (mutability, inner) = (&reference.mutability, unwrapped(&reference.elem));
    match (inner, mutability) {
        (Type::Reference(_), _) if by_reference && matches!(peeled(inner), Type::Slice(_)) => {
            let slice = passed(inner, &quote!(&#value[..]), true);
            quote!(&#mutability #slice)
        }
        (Type::Reference(_), _) => {
            let inner = passed(inner, value, by_reference);
            quote!(&#mutability #inner)
        }
        (_, Some(_)) if by_reference => quote!(&mut #value.clone()),
        (_, None) if by_reference => value.clone(),
        _ => quote!(&#mutability #value),
    }
}

/// The type of integers that a type is.
pub(crate) fn integer_type(kind: &Type) -> Option<IntegerType> {
    let Type::Path(path) = kind else { return None };
    path.path.get_ident().and_then(|name| IntegerType::named(&name.to_string()))
}

/// The arguments of a function but `self`.
pub(crate) fn typed_arguments(function: &ImplItemFn) -> impl Iterator<Item = &PatType> {
    function.sig.inputs.iter().filter_map(|argument| match argument {
        FnArg::Typed(argument) => Some(argument),
        FnArg::Receiver(_) => None,
    })
}
