//! The systems of the corpus, with the parameters and the first point of their reference.

use crate::{
    judge::{Case, System},
    machine::Machine,
    value::Value,
};
use proc_macro2::TokenStream;
use quote::ToTokens;
use std::{fs, path::Path};
use syn::{Expr, GenericParam, ImplItem, ImplItemFn, Item, ItemImpl, Type};

/// A system of the corpus.
pub(crate) struct Example {
    pub(crate) name: String,
    pub(crate) arguments: TokenStream,
    pub(crate) system: System,
    /// The constants that its text names.
    pub(crate) constants: Vec<(String, Value)>,
}

/// All of them; `Err` with the name of one whose parameters or coordinates the interpreter does not know, and why.
pub(crate) fn examples() -> Vec<Result<Example, (String, String)>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/long/tests/corpus");
    let reference = fs::read_to_string(folder.join("reference.json")).expect("the reference");
    let entries = fs::read_dir(&folder).expect("the corpus").map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<_> = entries.filter(|path| path.extension().is_some_and(|kind| kind == "rs")).collect();
    paths.sort();
    let mut found = Vec::new();
    for path in paths {
        let items = syn::parse_file(&fs::read_to_string(path).expect("text")).expect("Rust").items;
        for item in &items {
            let Item::Impl(item) = item else { continue };
            let attribute = item.attrs.iter().find(|attribute| attribute.path().is_ident("hamiltonian"));
            if let Some(attribute) = attribute {
                let arguments = attribute.meta.require_list().map(|list| list.tokens.clone()).unwrap_or_default();
                let name = named(&item.self_ty);
                let example = example(&items, item, &name, &reference);
                found.push(
                    example
                        .map(|(system, constants)| Example { name: name.clone(), arguments, system, constants })
                        .map_err(|reason| (name, reason)),
                );
            }
        }
    }
    found
}

fn named(of: &Type) -> String {
    match of {
        Type::Path(path) => path.path.segments.last().map_or_else(String::new, |last| last.ident.to_string()),
        other => other.to_token_stream().to_string(),
    }
}

fn example(
    items: &[Item],
    annotated: &ItemImpl,
    name: &str,
    reference: &str,
) -> Result<(System, Vec<(String, Value)>), String> {
    let member = items.iter().find_map(|item| match item {
        Item::Impl(of) if of.trait_.is_some() && named(&of.self_ty) == name => method(of, "example").map(|_| of),
        _ => None,
    });
    let own = member.and_then(|member| Some((&*member.self_ty, method(member, "example")?.block.clone())));
    let written =
        || items.iter().find_map(|item| written_in_a_macro(item, name)).map(|block| (&*annotated.self_ty, block));
    let (of, block) = own.or_else(written).ok_or("no example")?;
    let mut machine = Machine::new(methods(items, name));
    machine.structs = items.iter().filter_map(structure).collect();
    let constants = constants(items, annotated, of, &mut machine)?;
    machine.constants = constants.iter().cloned().collect();
    let fields = machine.block(&block).map_err(|stop| stop.to_string())?;
    let energy = method(annotated, "potential").or_else(|| method(annotated, "hamiltonian")).ok_or("no energies")?;
    let dimension = dimension(energy, &mut machine)?;
    let point = reference.split(&format!("\"{}\": [", snake(name))).nth(1).ok_or("no reference")?;
    let numbers = |part: &str| -> Result<Vec<Vec<f64>>, String> {
        let list = point.split(&format!("\"{part}\":[")).nth(1).and_then(|list| list.split(']').next());
        let numbers = list.ok_or("no point")?.split(',').map(|number| number.trim().parse::<f64>());
        let numbers: Vec<f64> = numbers.collect::<Result<_, _>>().map_err(|error| error.to_string())?;
        Ok(numbers.chunks(dimension.unwrap_or(1)).map(<[f64]>::to_vec).collect())
    };
    let time = point.split("\"time\":").nth(1).and_then(|time| time.split(',').next());
    let time = time.and_then(|time| time.parse().ok()).ok_or("no time")?;
    let state = [numbers("q")?, numbers("p")?];
    let mut item = annotated.clone();
    item.attrs.retain(|attribute| !attribute.path().is_ident("hamiltonian"));
    let case = Case { fields, state, is_flat: dimension.is_none(), time };
    Ok((System { item: item.to_token_stream(), cases: vec![case] }, constants))
}

/// `N` of `Toda<5>`, constants of the system and those of its file.
fn constants(
    items: &[Item],
    annotated: &ItemImpl,
    of: &Type,
    machine: &mut Machine<'_>,
) -> Result<Vec<(String, Value)>, String> {
    let mut texts: Vec<(String, Expr)> = Vec::new();
    if let Type::Path(path) = of
        && let Some(last) = path.path.segments.last()
        && let syn::PathArguments::AngleBracketed(arguments) = &last.arguments
    {
        let values = arguments.args.iter().filter_map(|argument| match argument {
            syn::GenericArgument::Const(value) => Some(value.clone()),
            _ => None,
        });
        let names = annotated.generics.params.iter().filter_map(|parameter| match parameter {
            GenericParam::Const(constant) => Some(constant.ident.to_string()),
            _ => None,
        });
        texts.extend(names.zip(values));
    }
    for item in items {
        match item {
            Item::Const(constant) => texts.push((constant.ident.to_string(), (*constant.expr).clone())),
            Item::Impl(of) if of.trait_.is_none() && named(&of.self_ty) == named(&annotated.self_ty) => {
                texts.extend(of.items.iter().filter_map(|item| match item {
                    ImplItem::Const(constant) => Some((constant.ident.to_string(), constant.expr.clone())),
                    _ => None,
                }));
            }
            _ => {}
        }
    }
    let mut found = Vec::new();
    for (name, text) in texts {
        let value = machine.expression(&text).map_err(|stop| format!("{name}: {stop}"))?;
        machine.constants.insert(name.clone(), value.clone());
        found.push((name, value));
    }
    Ok(found)
}

/// How many components a point has; `None` if coordinates are numbers.
fn dimension(energy: &ImplItemFn, machine: &mut Machine<'_>) -> Result<Option<usize>, String> {
    let Some(syn::FnArg::Typed(coordinates)) = energy.sig.inputs.iter().nth(1) else {
        return Err("no arguments".into());
    };
    let mut of = &*coordinates.ty;
    while let Type::Reference(reference) = of {
        of = &reference.elem;
    }
    let element = match of {
        Type::Array(array) => &*array.elem,
        Type::Slice(slice) => &*slice.elem,
        _ => return Err("coordinates of another type".into()),
    };
    match element {
        Type::Array(point) => {
            let count = machine.expression(&point.len).and_then(|count| count.index());
            count.map(Some).map_err(|stop| stop.to_string())
        }
        _ => Ok(None),
    }
}

/// The example of `well!(Walls { width: 1.0 }, ...)`.
fn written_in_a_macro(item: &Item, name: &str) -> Option<syn::Block> {
    let Item::Macro(found) = item else { return None };
    let mut tokens = found.mac.tokens.clone().into_iter();
    let (of, fields) = (tokens.next()?, tokens.next()?);
    (of.to_string() == name).then(|| syn::parse_quote!({ #of #fields }))
}

/// The name of a type as the reference has it.
fn snake(name: &str) -> String {
    let mut text = String::new();
    for (place, letter) in name.chars().enumerate() {
        if letter.is_uppercase() && place > 0 {
            text.push('_');
        }
        text.extend(letter.to_lowercase());
    }
    text
}

fn method<'i>(of: &'i ItemImpl, name: &str) -> Option<&'i ImplItemFn> {
    of.items.iter().filter_map(crate::judge::method).find(|function| function.sig.ident == name)
}

fn methods<'i>(items: &'i [Item], name: &str) -> Vec<&'i ImplItemFn> {
    let of_type = items.iter().filter_map(move |item| match item {
        Item::Impl(of) if named(&of.self_ty) == name => Some(&of.items),
        _ => None,
    });
    of_type.flatten().filter_map(crate::judge::method).collect()
}

fn structure(item: &Item) -> Option<(String, &syn::ItemStruct)> {
    match item {
        Item::Struct(item) => Some((item.ident.to_string(), item)),
        _ => None,
    }
}
