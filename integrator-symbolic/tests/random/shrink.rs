//! A smaller system with the same fault: statements are dropped, branches taken, expressions replaced by parts of theirs.

use crate::judge::{Fault, System};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::{Block, Expr, ImplItem, ItemImpl, Stmt};

/// How many systems are looked at on the way.
const LOOKS: usize = 2_000;

/// The smallest system with this fault that was found.
pub(crate) fn shrunk(system: &System, fault: Fault) -> System {
    let has_fault = |system: &System| {
        let found = std::panic::catch_unwind(|| system.judge());
        matches!(found, Ok(Ok(verdict)) if verdict.faults.iter().any(|(found, _)| *found == fault))
    };
    let mut smallest = system.clone();
    for case in &system.cases {
        let alone = System { cases: vec![case.clone()], ..system.clone() };
        if has_fault(&alone) {
            smallest = alone;
        }
    }
    let mut looks = 0;
    loop {
        let smaller = candidates(&smallest.item).into_iter().find_map(|item| {
            looks += 1;
            let candidate = System { item, ..smallest.clone() };
            (looks < LOOKS && has_fault(&candidate)).then_some(candidate)
        });
        match smaller {
            Some(smaller) => smallest = smaller,
            None => return smallest,
        }
    }
}

/// Systems that are smaller by one thing.
fn candidates(item: &TokenStream) -> Vec<TokenStream> {
    let Ok(item) = syn::parse2::<ItemImpl>(item.clone()) else { return Vec::new() };
    let mut found = Vec::new();
    for (place, function) in item.items.iter().enumerate() {
        let ImplItem::Fn(function) = function else { continue };
        let mut with = |block: Option<Block>| {
            let mut smaller = item.clone();
            match block {
                Some(block) => {
                    let mut function = function.clone();
                    function.block = block;
                    smaller.items[place] = ImplItem::Fn(function);
                }
                None => drop(smaller.items.remove(place)),
            }
            found.push(smaller.to_token_stream());
        };
        with(None);
        with(syn::parse2(quote!({ 0.0 })).ok().filter(|_| function.block.to_token_stream().to_string() != "{ 0.0 }"));
        with_fewer_statements(&function.block).into_iter().for_each(|block| with(Some(block)));
        let tokens: Vec<TokenTree> = function.block.to_token_stream().into_iter().collect();
        let variations = variations(&tokens).into_iter();
        variations
            .filter_map(|tokens| syn::parse2(tokens.into_iter().collect()).ok())
            .for_each(|block| with(Some(block)));
    }
    let whole = item.to_token_stream().to_string();
    found.retain(|smaller| smaller.to_string().len() < whole.len());
    found
}

fn with_fewer_statements(block: &Block) -> Vec<Block> {
    let mut found = Vec::new();
    for (place, statement) in block.stmts.iter().enumerate() {
        let mut with = |statements: Vec<Stmt>| {
            let mut smaller = block.clone();
            smaller.stmts.splice(place..=place, statements);
            found.push(smaller);
        };
        with(Vec::new());
        let Stmt::Expr(expression, end) = statement else { continue };
        match expression {
            Expr::ForLoop(each) => {
                for body in with_fewer_statements(&each.body) {
                    with(vec![Stmt::Expr(Expr::ForLoop(syn::ExprForLoop { body, ..each.clone() }), *end)]);
                }
            }
            Expr::If(choice) => {
                with(choice.then_branch.stmts.clone());
                for then_branch in with_fewer_statements(&choice.then_branch) {
                    with(vec![Stmt::Expr(Expr::If(syn::ExprIf { then_branch, ..choice.clone() }), *end)]);
                }
            }
            _ => {}
        }
    }
    found
}

/// Token lists that are shorter by one thing: a group that becomes a number or one of its parts, a method that is not
/// called, a branch that is taken.
fn variations(tokens: &[TokenTree]) -> Vec<Vec<TokenTree>> {
    let mut found = Vec::new();
    for (place, token) in tokens.iter().enumerate() {
        let mut with = |end: usize, replacement: Vec<TokenTree>| {
            found.push([&tokens[..place], &replacement, &tokens[end..]].concat());
        };
        match token {
            TokenTree::Group(group) => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                let regrouped = |inner: Vec<TokenTree>| {
                    vec![TokenTree::Group(Group::new(group.delimiter(), inner.into_iter().collect()))]
                };
                if group.delimiter() == Delimiter::Parenthesis && inner.len() > 1 {
                    with(place + 1, regrouped(quote!(1.0).into_iter().collect()));
                }
                let operators = inner
                    .iter()
                    .enumerate()
                    .filter(|(_, token)| matches!(token, TokenTree::Punct(mark) if "+-*/&|".contains(mark.as_char())));
                for (at, _) in operators {
                    with(place + 1, regrouped(inner[..at].to_vec()));
                    with(place + 1, regrouped(inner[at + 1..].to_vec()));
                }
                for inner in variations(&inner) {
                    with(place + 1, regrouped(inner));
                }
            }
            TokenTree::Punct(mark) if mark.as_char() == '.' => {
                let call = tokens[place..].iter().position(|token| matches!(token, TokenTree::Group(_)));
                // Without it a list of the system would be moved.
                let borrows = tokens.get(place + 1).is_some_and(|name| name.to_string() == "iter");
                if let Some(length) = call.filter(|length| !borrows && (*length == 2 || *length == 7)) {
                    with(place + length + 1, Vec::new());
                }
            }
            TokenTree::Punct(mark) if "+-*/".contains(mark.as_char()) => {
                let end = tokens[place + 1..]
                    .iter()
                    .position(|token| matches!(token, TokenTree::Punct(mark) if "+-*/;,".contains(mark.as_char())));
                with(end.map_or(tokens.len(), |end| place + 1 + end), Vec::new());
            }
            TokenTree::Ident(name) if name == "if" => {
                let braces = tokens[place..].iter().enumerate().filter(
                    |(_, token)| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace),
                );
                let braces: Vec<usize> = braces.map(|(at, _)| place + at).collect();
                if let [then, other, ..] = braces[..]
                    && other == then + 2
                {
                    with(other + 1, vec![tokens[then].clone()]);
                    with(other + 1, vec![tokens[other].clone()]);
                }
            }
            _ => {}
        }
    }
    found
}
