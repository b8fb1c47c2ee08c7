//! The annotated impls of the corpus, as text.

use proc_macro2::TokenStream;
use std::{fs, path::Path};
use syn::{Item, ItemImpl, Meta};

/// An annotated impl of the corpus.
pub(crate) struct System {
    pub(crate) arguments: TokenStream,
    pub(crate) item: ItemImpl,
}

/// All of them, in the order of their files' names.
pub(crate) fn corpus() -> Vec<System> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/long/tests/corpus");
    let entries = fs::read_dir(folder).expect("the corpus").map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<_> = entries.filter(|path| path.extension().is_some_and(|kind| kind == "rs")).collect();
    paths.sort();
    paths.iter().flat_map(|path| systems(&fs::read_to_string(path).expect("text"))).collect()
}

fn systems(text: &str) -> Vec<System> {
    let items = syn::parse_file(text).expect("Rust").items;
    items.into_iter().filter_map(system).collect()
}

fn system(item: Item) -> Option<System> {
    let Item::Impl(mut item) = item else { return None };
    let position = item.attrs.iter().position(|attribute| attribute.path().is_ident("hamiltonian"))?;
    let arguments = match item.attrs.remove(position).meta {
        Meta::List(list) => list.tokens,
        _ => TokenStream::new(),
    };
    Some(System { arguments, item })
}
