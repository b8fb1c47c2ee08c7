//! Prints what is derived from every annotated impl of a file (equations of motion, operation counts) and what
//! `#[hamiltonian]` writes for it, formatted: `cargo run -p integrator-symbolic --example expand -- FILE.rs`

use proc_macro2::TokenStream;
use quote::ToTokens;
use std::{env, error::Error, fs};
use syn::{Item, Meta};

fn main() -> Result<(), Box<dyn Error>> {
    let path = env::args().nth(1).ok_or("usage: expand FILE.rs")?;
    let file = syn::parse_file(&fs::read_to_string(&path)?)?;
    for item in file.items {
        let Item::Impl(mut annotated) = item else { continue };
        let position = annotated.attrs.iter().position(|attribute| attribute.path().is_ident("hamiltonian"));
        let Some(position) = position else { continue };
        let arguments = match annotated.attrs.remove(position).meta {
            Meta::List(list) => list.tokens,
            _ => TokenStream::new(),
        };
        let item = annotated.into_token_stream();
        if let Some(report) = integrator_symbolic::report(arguments.clone(), item.clone()) {
            for line in report.to_string().lines() {
                println!("// {line}");
            }
        }
        let expansion = integrator_symbolic::hamiltonian(arguments, item);
        println!("{}", prettyplease::unparse(&syn::parse2(expansion)?));
    }
    Ok(())
}
