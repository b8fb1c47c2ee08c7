//! A Rust file as far as the macros see it: annotated impls and declared compositions.
//!
//! Comes in: a path, or text. Goes out: the tokens that the macros would get. The file is looked through as tokens, with
//! a stack of its own, so that neither syntax from elsewhere nor depth can do harm; what is in it is judged by the
//! macros alone.

use crate::mistake::Mistake;
use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use std::{fs, path::Path};

const NO_TOKENS: &str = "this is not Rust: a bracket or a quote does not close, or a character is none of the language";

/// A text with a name.
pub(crate) struct Source {
    /// The path as it was typed, or what stands for it.
    pub(crate) name: String,
    pub(crate) text: String,
}

/// An annotated impl.
pub(crate) struct Annotated {
    /// What is in the parentheses of the annotation.
    pub(crate) arguments: TokenStream,
    /// What is after it.
    pub(crate) item: TokenStream,
    /// The annotation.
    pub(crate) span: Span,
}

impl Annotated {
    /// The name of the annotated type; empty if the item is no impl.
    pub(crate) fn system(&self) -> String {
        let Ok(item) = syn::parse2::<syn::ItemImpl>(self.item.clone()) else { return String::new() };
        match &*item.self_ty {
            syn::Type::Path(path) => path.path.segments.last().map(|last| last.ident.to_string()).unwrap_or_default(),
            _ => String::new(),
        }
    }
}

/// What the macros see of a file.
#[derive(Default)]
pub(crate) struct Seen {
    pub(crate) systems: Vec<Annotated>,
    /// What is in `composition!`.
    pub(crate) declarations: Vec<TokenStream>,
}

impl Source {
    /// Reads a file of text.
    pub(crate) fn read(path: &Path) -> Result<Self, Mistake> {
        let name = path.display().to_string();
        match fs::read(path).map(String::from_utf8) {
            Ok(Ok(text)) => Ok(Self { name, text }),
            Ok(Err(_)) => Err(Mistake::plain(format!("{name} is not a text file"))),
            Err(error) => Err(Mistake::plain(format!("{name} cannot be read: {error}"))),
        }
    }

    /// The tokens of the text.
    pub(crate) fn tokens(&self) -> Result<TokenStream, Mistake> {
        self.text
            .parse()
            .map_err(|error: proc_macro2::LexError| Mistake::at(self, [(error.span(), NO_TOKENS.to_owned())]))
    }

    /// What the macros see of the file.
    pub(crate) fn seen(&self) -> Result<Seen, Mistake> {
        let mut seen = Seen::default();
        let mut open = vec![self.tokens()?];
        while let Some(tokens) = open.pop() {
            let trees: Vec<TokenTree> = tokens.into_iter().collect();
            for (at, tree) in trees.iter().enumerate() {
                if let Some(arguments) = annotation(&trees[at..]) {
                    let span = tree.span().join(trees[at + 1].span()).unwrap_or(tree.span());
                    let item = item(&trees[at + 2..]);
                    // The pattern of a `macro_rules!` is no impl yet.
                    if !mentions_dollar(&item) {
                        seen.systems.push(Annotated { arguments, item, span });
                    }
                }
                seen.declarations.extend(declarations(&trees[at..]));
            }
            // Those further up in the file are taken out first.
            open.extend(trees.into_iter().rev().filter_map(|tree| match tree {
                TokenTree::Group(group) => Some(group.stream()),
                _ => None,
            }));
        }
        seen.systems.sort_by_key(|annotated| (annotated.span.start().line, annotated.span.start().column));
        Ok(seen)
    }
}

/// The arguments of `#[hamiltonian(..)]`, if the trees begin with it.
fn annotation(trees: &[TokenTree]) -> Option<TokenStream> {
    let [TokenTree::Punct(mark), TokenTree::Group(group), ..] = trees else { return None };
    if mark.as_char() != '#' || group.delimiter() != Delimiter::Bracket {
        return None;
    }
    let inside: Vec<TokenTree> = group.stream().into_iter().collect();
    let (path, arguments) = match inside.split_last()? {
        (TokenTree::Group(group), path) if group.delimiter() == Delimiter::Parenthesis => (path, group.stream()),
        _ => (&inside[..], TokenStream::new()),
    };
    let is_path = path.iter().all(|tree| match tree {
        TokenTree::Ident(_) => true,
        TokenTree::Punct(mark) => mark.as_char() == ':',
        _ => false,
    });
    let named = matches!(path.last()?, TokenTree::Ident(name) if name == "hamiltonian");
    (is_path && named).then_some(arguments)
}

/// The item that the trees begin with: up to its first braces or its semicolon.
fn item(trees: &[TokenTree]) -> TokenStream {
    let ends = |tree: &TokenTree| match tree {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        TokenTree::Punct(mark) => mark.as_char() == ';',
        _ => false,
    };
    let length = trees.iter().position(ends).map_or(trees.len(), |last| last + 1);
    trees[..length].iter().cloned().collect()
}

fn mentions_dollar(tokens: &TokenStream) -> bool {
    let mut open = vec![tokens.clone()];
    while let Some(tokens) = open.pop() {
        for tree in tokens {
            match tree {
                TokenTree::Punct(mark) if mark.as_char() == '$' => return true,
                TokenTree::Group(group) => open.push(group.stream()),
                _ => {}
            }
        }
    }
    false
}

/// What is in `composition! { .. }`, if the trees begin with it.
fn declarations(trees: &[TokenTree]) -> Option<TokenStream> {
    match trees {
        [TokenTree::Ident(name), TokenTree::Punct(mark), TokenTree::Group(group), ..]
            if name == "composition" && mark.as_char() == '!' && !mentions_dollar(&group.stream()) =>
        {
            Some(group.stream())
        }
        _ => None,
    }
}
