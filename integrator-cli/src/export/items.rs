//! The structs and constants of a file.
//!
//! In: tokens. Out: a struct's fields, and the value of a constant by its path. The tokens are looked through with a stack of its
//! own, and items that are nested deeply are left out.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Expr, Field, Fields, ItemConst, ItemImpl, ItemStruct, Type, parse::Parse};

/// What else a file declares that parameters may read.
#[derive(Default)]
pub(super) struct Items {
    structs: Vec<ItemStruct>,
    /// Each with the type in whose impl it is.
    constants: Vec<(Option<String>, ItemConst)>,
}

/// How deep the brackets of an item may be.
const DEEPEST: usize = 40;

impl Items {
    /// The items in tokens, however deep.
    pub(super) fn of(tokens: TokenStream) -> Self {
        let mut items = Self::default();
        let mut open = vec![(tokens, None)];
        while let Some((tokens, owner)) = open.pop() {
            let trees: Vec<TokenTree> = tokens.into_iter().collect();
            let mut of_impl = None;
            for (at, tree) in trees.iter().enumerate() {
                match tree {
                    TokenTree::Ident(word) if word == "struct" => items.structs.extend(parsed(&trees[at..], false)),
                    TokenTree::Ident(word) if word == "const" => {
                        items.constants.extend(parsed(&trees[at..], true).map(|item| (owner.clone(), item)));
                    }
                    TokenTree::Ident(word) if word == "impl" => of_impl = owner_of(&trees[at..]),
                    TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                        open.push((group.stream(), of_impl.take().or_else(|| owner.clone())));
                    }
                    TokenTree::Group(group) => open.push((group.stream(), owner.clone())),
                    _ => {}
                }
            }
        }
        items
    }

    /// The named fields of a struct; `None` if it is not in the file, or if the file has several that differ.
    pub(super) fn fields(&self, name: &str) -> Option<Vec<&Field>> {
        let mut found = self.structs.iter().filter(|item| item.ident == name);
        let first = found.next()?;
        let text = |item: &ItemStruct| item.to_token_stream().to_string();
        if found.any(|other| text(other) != text(first)) {
            return None;
        }
        match &first.fields {
            Fields::Named(fields) => Some(fields.named.iter().collect()),
            _ => Some(Vec::new()),
        }
    }

    /// The value of a constant of a module, or of the impls of a type; `None` of none, and of several that differ.
    pub(super) fn constant(&self, owner: Option<&str>, name: &str) -> Option<&Expr> {
        let mut found = self.constants.iter().filter(|(of, item)| of.as_deref() == owner && item.ident == name);
        let first = &found.next()?.1;
        let text = |item: &ItemConst| item.expr.to_token_stream().to_string();
        (!found.any(|(_, other)| text(other) != text(first))).then_some(&*first.expr)
    }
}

/// The item that trees begin with, up to its semicolon or, if it may have none, its braces.
fn parsed<T: Parse>(trees: &[TokenTree], needs_semicolon: bool) -> Option<T> {
    let ends = |tree: &TokenTree| match tree {
        TokenTree::Punct(mark) => mark.as_char() == ';',
        TokenTree::Group(group) => !needs_semicolon && group.delimiter() == Delimiter::Brace,
        _ => false,
    };
    let end = trees.iter().position(ends)?;
    let item: TokenStream = trees[..=end].iter().cloned().collect();
    is_shallow(&item).then(|| syn::parse2(item).ok()).flatten()
}

/// The type of an impl.
fn owner_of(trees: &[TokenTree]) -> Option<String> {
    let is_block = |tree: &TokenTree| matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    let block = trees.iter().position(is_block)?;
    let empty = TokenTree::Group(Group::new(Delimiter::Brace, TokenStream::new()));
    let head: TokenStream = trees[..block].iter().cloned().chain([empty]).collect();
    match *is_shallow(&head).then(|| syn::parse2::<ItemImpl>(head).ok()).flatten()?.self_ty {
        Type::Path(path) => path.path.segments.last().map(|last| last.ident.to_string()),
        _ => None,
    }
}

fn is_shallow(tokens: &TokenStream) -> bool {
    let mut open = vec![(tokens.clone(), 0)];
    while let Some((tokens, depth)) = open.pop() {
        if depth > DEEPEST {
            return false;
        }
        open.extend(tokens.into_iter().filter_map(|tree| match tree {
            TokenTree::Group(group) => Some((group.stream(), depth + 1)),
            _ => None,
        }));
    }
    true
}
