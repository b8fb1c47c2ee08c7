//! The user's source: the arguments of the attribute and the annotated impl, with all spans.
//!
//! In: tokens. Out: an [`Input`], faithful to the source. Always true: only the form is checked here.

mod device;
mod friction;
mod method;
pub(crate) mod names;
mod order;
mod split;

use crate::{errors::Errors, scheme::InPlace};
use device::gpu_of;
pub(crate) use device::{DeviceFunctions, Gpu};
pub(crate) use friction::{FRICTION, Friction, RateFunction, TEMPERATURE};
use method::{compose_of, without_tolerance};
use order::{OrderClaim, order_of};
use proc_macro2::{Group, Span, TokenStream, TokenTree};
pub(crate) use split::Nest;
use split::{Parts, Split, split_of};
use syn::{
    Expr, Ident, ImplItem, ImplItemFn, ItemImpl, Path, Token, parenthesized,
    parse::{ParseStream, Parser},
    punctuated::Punctuated,
    spanned::Spanned,
    token::Paren,
};

/// The composition that the annotation requests.
pub(crate) enum Compose {
    /// A name.
    Named(Path),
    /// A sequence in place of a name.
    InPlace(Box<InPlace>, Span),
}

/// How near to the exact value the elementary functions have to be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Functions {
    /// Within one unit in the last place, or two.
    #[default]
    Precise,
    /// Within four, where that is faster.
    Fast,
}

/// The coordinates of a motion that are not those of the user's states: `jacobi(self.mass)`.
pub(crate) struct Coordinates {
    /// The name.
    pub(crate) name: Ident,
    /// The list of masses.
    pub(crate) masses: Expr,
}

/// The annotated impl and its annotation.
pub(crate) struct Input {
    /// `None` where the annotation has no `compose`.
    pub(crate) compose: Option<Compose>,
    /// The parts of H by their names, in the order of the letters A, B, C; none where the annotation has no `split`.
    pub(crate) split: Vec<Ident>,
    /// The parentheses around all parts but the first, which are one part then: a symmetric pair.
    pub(crate) paired: Option<Span>,
    /// The parts in parentheses that take inner steps, the outermost first.
    pub(crate) nests: Vec<Nest>,
    /// The coordinates of the motion, where they are not those of states.
    pub(crate) coordinates: Option<Coordinates>,
    /// How tightly two copies of the state are coupled, where `split = symmetric(omega = ..)` requests them.
    pub(crate) coupling: Option<Expr>,
    /// Where H stays in one piece, `split = none`.
    pub(crate) unsplit: Option<Span>,
    /// Friction, where a function is annotated with it.
    pub(crate) friction: Option<Friction>,
    pub(crate) functions: Functions,
    /// The order that a step has to have.
    pub(crate) order: Option<OrderClaim>,
    /// The layout that the kick has to have.
    pub(crate) layout: Option<Ident>,
    /// Whether recurrences for Taylor series are requested, and where.
    pub(crate) taylor: Option<Span>,
    /// The parameters that derivatives are taken by, fields of the system.
    pub(crate) sensitive: Vec<Ident>,
    /// Whether flows are also requested as text for devices.
    pub(crate) gpu: Option<Gpu>,
    /// The runtime crate.
    pub(crate) root: Path,
    pub(crate) item: ItemImpl,
}

impl Input {
    /// The functions of the impl.
    pub(crate) fn functions(&self) -> impl Iterator<Item = &ImplItemFn> {
        self.item.items.iter().filter_map(|item| match item {
            ImplItem::Fn(function) => Some(function),
            _ => None,
        })
    }

    /// The function of this name, if the impl has one.
    pub(crate) fn function(&self, name: &str) -> Option<&ImplItemFn> {
        self.functions().find(|function| function.sig.ident == name)
    }
}

/// Reads the arguments and the item, or notes what is wrong with their form.
pub(crate) fn input(arguments: TokenStream, item: TokenStream, errors: &mut Errors) -> Option<Input> {
    let arguments = arguments_of(arguments, errors);
    let item: ItemImpl = match syn::parse2(item.clone()) {
        Ok(item) => item,
        Err(error) if looks_like_impl(&item) => {
            errors.push(error);
            return None;
        }
        Err(_) => {
            let message = "`#[hamiltonian]` requires an `impl` with the functions `kinetic` and `potential`";
            errors.at(item, message);
            return None;
        }
    };
    if let Some((of, _)) = &item.trait_ {
        errors.at(
            of,
            "`#[hamiltonian]` does not support the impl of a trait\nhelp: write an inherent impl, `impl \
                     System { ... }`",
        );
        return None;
    }
    // Wrong arguments are noted; the functions are read all the same, so that all mistakes are reported together.
    let is_read = |name: &str| item.items.iter().any(|item| matches!(item, ImplItem::Fn(own) if own.sig.ident == name));
    let is_whole = is_read("hamiltonian") || is_read("kinetic") && is_read("potential");
    if arguments.is_none() && !is_whole {
        // Which functions are the parts of H was to be read from what is wrong.
        return None;
    }
    let Arguments { compose, split, coordinates, functions, order, layout, taylor, sensitive, gpu, root } =
        arguments.unwrap_or_default();
    let (mut parts, mut coupling, mut unsplit) = (Parts::default(), None, None);
    match split {
        None => {}
        Some(Split::Parts(named)) => parts = named,
        Some(Split::Nowhere(at)) => unsplit = Some(at),
        Some(Split::Symmetric(stated)) => {
            // H is read as it is meant all the same.
            let one = || syn::parse_quote!(1.0);
            coupling = Some(errors.keep(*stated).unwrap_or_else(one));
        }
    }
    let friction = Friction::of(&item, &mut parts, errors);
    let Parts { names, paired, nests, .. } = parts;
    let functions = functions.unwrap_or_default();
    let root = root.unwrap_or_else(|| syn::parse_quote!(::integrator_core));
    let sensitive = sensitive.unwrap_or_default();
    Some(Input {
        compose,
        split: names,
        paired,
        nests,
        coordinates,
        coupling,
        unsplit,
        friction,
        functions,
        order,
        layout,
        taylor,
        sensitive,
        gpu,
        root,
        item,
    })
}

fn looks_like_impl(item: &TokenStream) -> bool {
    item.clone().into_iter().any(|token| matches!(token, TokenTree::Ident(name) if name == "impl"))
}

/// The arguments of the attribute, each at most once.
#[derive(Default)]
struct Arguments {
    compose: Option<Compose>,
    split: Option<Split>,
    coordinates: Option<Coordinates>,
    functions: Option<Functions>,
    order: Option<OrderClaim>,
    layout: Option<Ident>,
    taylor: Option<Span>,
    sensitive: Option<Vec<Ident>>,
    gpu: Option<Gpu>,
    root: Option<Path>,
}

/// The arguments, separated by commas.
fn arguments_of(tokens: TokenStream, errors: &mut Errors) -> Option<Arguments> {
    let parser = |input: ParseStream<'_>| {
        let mut arguments = Arguments::default();
        while !input.is_empty() {
            arguments.read(input)?;
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        Ok(arguments)
    };
    parser.parse2(tokens).map_err(|error| errors.push(error)).ok()
}

impl Arguments {
    /// Reads one of them.
    fn read(&mut self, input: ParseStream<'_>) -> syn::Result<()> {
        if input.peek(Token![crate]) {
            let key: Token![crate] = input.parse()?;
            equals(input, key.span)?;
            let path = input.call(Path::parse_mod_style);
            let path = path.map_err(|_| misfit(input, key.span, "expected the path of `integrator_core`"))?;
            return match self.root.replace(path) {
                Some(_) => Err(syn::Error::new(key.span(), "`crate` is given twice")),
                None => Ok(()),
            };
        }
        let key: Ident = input
            .parse()
            .map_err(|error| syn::Error::new(error.span(), format!("expected an argument\n{EXPECTED}")))?;
        let twice = if key == "compose" {
            equals(input, key.span())?;
            self.compose.replace(compose_of(input, key.span())?).is_some()
        } else if key == "split" {
            equals(input, key.span())?;
            self.split.replace(split_of(input, key.span())?).is_some()
        } else if key == "coordinates" {
            equals(input, key.span())?;
            self.coordinates.replace(coordinates_of(input, key.span())?).is_some()
        } else if key == "functions" {
            equals(input, key.span())?;
            self.functions.replace(functions_of(input, key.span())?).is_some()
        } else if key == "order" {
            equals(input, key.span())?;
            self.order.replace(order_of(input, key.span())?).is_some()
        } else if key == "layout" {
            equals(input, key.span())?;
            self.layout.replace(layout_of(input, key.span())?).is_some()
        } else if key == "taylor" {
            without_tolerance(input)?;
            self.taylor.replace(key.span()).is_some()
        } else if key == "sensitive" {
            self.sensitive.replace(sensitive_of(input, key.span())?).is_some()
        } else if key == "gpu" {
            self.gpu.replace(gpu_of(input, key.span())?).is_some()
        } else {
            return Err(syn::Error::new(key.span(), format!("unknown argument `{key}`\n{EXPECTED}")));
        };
        if twice {
            return Err(syn::Error::new(key.span(), format!("`{key}` is given twice")));
        }
        Ok(())
    }
}

const EXPECTED: &str = "note: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = \
                        a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, \
                        `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`";

/// The sign between an argument and its value.
fn equals(input: ParseStream<'_>, key: Span) -> syn::Result<()> {
    let sign = input.parse::<Token![=]>();
    sign.map(|_| ()).map_err(|_| syn::Error::new(key, format!("this argument lacks its value\n{EXPECTED}")))
}

/// What stands in the place of a value, or the argument that lacks one.
fn misfit(input: ParseStream<'_>, key: Span, is: &str) -> syn::Error {
    if input.is_empty() {
        return syn::Error::new(key, format!("this argument lacks its value\n{EXPECTED}"));
    }
    input.error(format!("{is}\n{EXPECTED}"))
}

/// The names of the parameters that derivatives are taken by, each once.
fn sensitive_of(input: ParseStream<'_>, key: Span) -> syn::Result<Vec<Ident>> {
    let is = "`sensitive` requires the names of fields in parentheses\nhelp: write, for example, `sensitive(mass, \
              length)`";
    if !input.peek(Paren) {
        return Err(syn::Error::new(key, is));
    }
    let content;
    parenthesized!(content in input);
    let names = Punctuated::<Ident, Token![,]>::parse_terminated(&content);
    let names: Vec<Ident> = names.map_err(|error| syn::Error::new(error.span(), is))?.into_iter().collect();
    if names.is_empty() {
        return Err(syn::Error::new(key, is));
    }
    for (number, name) in names.iter().enumerate() {
        if names[..number].contains(name) {
            return Err(syn::Error::new(name.span(), format!("`{name}` is named twice")));
        }
    }
    Ok(names)
}

/// The coordinates of the motion.
fn coordinates_of(input: ParseStream<'_>, key: Span) -> syn::Result<Coordinates> {
    let is = "these coordinates are not supported\nhelp: write `coordinates = jacobi(self.mass)`, with the list of \
              masses";
    let here = input.fork();
    let name = match input.parse::<Ident>() {
        Ok(name) if name == "jacobi" => name,
        _ if here.is_empty() => return Err(misfit(&here, key, is)),
        _ => return Err(here.error(is)),
    };
    let masses = if input.peek(Paren) { input.parse::<Group>().ok() } else { None };
    let lacks = || {
        syn::Error::new(name.span(), "`jacobi` lacks the list of masses\nhelp: write, for example, `jacobi(self.mass)`")
    };
    let masses = masses.filter(|masses| !masses.stream().is_empty()).ok_or_else(lacks)?;
    Ok(Coordinates { masses: syn::parse2(masses.stream())?, name })
}

/// The word of a layout.
fn layout_of(input: ParseStream<'_>, key: Span) -> syn::Result<Ident> {
    let is = "expected the name of a layout\nhelp: write, for example, `layout = lists`";
    if input.peek(Ident) { input.parse() } else { Err(misfit(input, key, is)) }
}

fn functions_of(input: ParseStream<'_>, key: Span) -> syn::Result<Functions> {
    let is = "expected `fast` or `precise`\nnote: errors of elementary functions are at most 4 ulp if `fast`, and 1 \
              or 2 ulp if `precise`, the default";
    let misfit = |input: ParseStream<'_>| {
        if input.is_empty() { misfit(input, key, is) } else { input.error(is) }
    };
    let here = input.fork();
    match input.parse::<Ident>() {
        Ok(name) if name == "fast" => Ok(Functions::Fast),
        Ok(name) if name == "precise" => Ok(Functions::Precise),
        _ => Err(misfit(&here)),
    }
}
