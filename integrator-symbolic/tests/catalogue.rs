//! The catalogue of the runtime crate as data: what its proofs cost, and that they can fail.

use std::{fs, path::Path, time::Instant};

use integrator_symbolic::composition;
use proc_macro2::{Literal, TokenStream, TokenTree};

/// The declarations of every block, by file.
fn catalogue() -> Vec<(String, Vec<TokenStream>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../integrator-core/src/composition/catalogue");
    let mut files: Vec<_> =
        fs::read_dir(folder).expect("the catalogue").map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    let blocks = files.iter().map(|file| {
        let source = syn::parse_file(&fs::read_to_string(file).expect("text")).expect("Rust");
        let tokens = source.items.into_iter().find_map(|item| match item {
            syn::Item::Macro(item) if item.mac.path.is_ident("composition") => Some(item.mac.tokens),
            _ => None,
        });
        let name = file.file_stem().expect("a name").to_string_lossy().into_owned();
        (name, declarations(tokens.expect("a block")))
    });
    blocks.collect()
}

fn declarations(block: TokenStream) -> Vec<TokenStream> {
    let mut declarations = vec![TokenStream::new()];
    for tree in block {
        let ends = matches!(&tree, TokenTree::Punct(mark) if mark.as_char() == ';');
        declarations.last_mut().expect("one").extend([tree]);
        if ends {
            declarations.push(TokenStream::new());
        }
    }
    declarations.retain(|declaration| !declaration.is_empty());
    declarations
}

fn name(declaration: &TokenStream) -> String {
    let mut trees = declaration.clone().into_iter();
    trees.find(|tree| matches!(tree, TokenTree::Ident(word) if word == "struct"));
    trees.next().expect("a name").to_string()
}

fn refusal(declaration: TokenStream) -> Option<String> {
    let text = composition(declaration).to_string();
    text.contains("compile_error").then_some(text)
}

/// A copy in which `change` was applied to the first literal that it accepts.
fn changed(tokens: TokenStream, done: &mut bool, change: &dyn Fn(&str) -> Option<String>) -> TokenStream {
    let change = |tree| match tree {
        TokenTree::Group(group) => {
            let inner = changed(group.stream(), done, change);
            TokenTree::Group(proc_macro2::Group::new(group.delimiter(), inner))
        }
        TokenTree::Literal(literal) if !*done => match change(&literal.to_string()) {
            Some(text) => {
                *done = true;
                TokenTree::Literal(text.parse::<Literal>().expect("a literal"))
            }
            None => TokenTree::Literal(literal),
        },
        other => other,
    };
    tokens.into_iter().map(change).collect()
}

#[test]
fn every_entry_is_proved_and_the_cost_is_printed() {
    let mut total = 0.0;
    let mut entries = 0;
    for (file, declarations) in catalogue() {
        entries += declarations.len();
        for declaration in declarations {
            // The fastest of three runs is the cost; the others are the machine's.
            let milliseconds = (0..3).map(|_| {
                let start = Instant::now();
                assert_eq!(refusal(declaration.clone()), None);
                start.elapsed().as_secs_f64() * 1e3
            });
            let milliseconds = milliseconds.fold(f64::INFINITY, f64::min);
            println!("{milliseconds:7.2} ms  {file}::{}", name(&declaration));
            total += milliseconds;
        }
    }
    println!("{total:7.2} ms for {entries} compositions");
    assert!(entries >= 40, "the walk must reach the catalogue");
}

#[test]
fn a_wrong_twentieth_digit_is_refused() {
    let wrong = |literal: &str| {
        let digits = literal.trim_start_matches(['0', '.']);
        if !literal.starts_with(|first: char| first.is_ascii_digit()) || digits.len() < 30 {
            return None;
        }
        let position = literal.len() - digits.len() + 20;
        let digit = literal[position..=position].parse::<u32>().ok()?;
        Some(format!("{}{}{}", &literal[..position], (digit + 1) % 10, &literal[position + 1..]))
    };
    let mut refused = 0;
    for declaration in catalogue().into_iter().flat_map(|(_, declarations)| declarations) {
        let mut done = false;
        let mistyped = changed(declaration.clone(), &mut done, &wrong);
        if done {
            let message = refusal(mistyped).unwrap_or_else(|| panic!("{} passes", name(&declaration)));
            assert!(message.contains("wrong or missing digits"), "{message}");
            refused += 1;
        }
    }
    assert!(refused > 30, "most entries have decimals");
}

/// The declared orders: one, or one for each power of a small part.
fn orders(declaration: &TokenStream) -> Vec<u32> {
    let trees: Vec<TokenTree> = declaration.clone().into_iter().collect();
    let at = trees.iter().position(|tree| matches!(tree, TokenTree::Ident(word) if word == "order"));
    let literals: Vec<TokenTree> = match &trees[at.expect("an order") + 1] {
        TokenTree::Group(group) => group.stream().into_iter().collect(),
        single => vec![single.clone()],
    };
    let literals = literals.iter().filter(|tree| matches!(tree, TokenTree::Literal(_)));
    literals.map(|literal| literal.to_string().parse().expect("an order")).collect()
}

#[test]
fn one_order_more_is_refused() {
    for declaration in catalogue().into_iter().flat_map(|(_, declarations)| declarations) {
        let orders = orders(&declaration);
        for (place, order) in orders.iter().enumerate() {
            // The orders do not rise.
            if place > 0 && orders[place - 1] == *order {
                continue;
            }
            let mut literals = 0;
            let overclaimed = each_literal(declaration.clone(), &mut |literal| {
                // The citation and the doc comment are literals as well, behind and before the orders.
                let is_order = literal.to_string().parse::<u32>().is_ok() && literals < orders.len();
                literals += usize::from(is_order);
                match is_order && literals == place + 1 {
                    true => Literal::u32_unsuffixed(order + 1),
                    false => literal,
                }
            });
            let message = refusal(overclaimed).unwrap_or_else(|| panic!("{} passes", name(&declaration)));
            let finds = if *order == 10 && orders.len() == 1 {
                "no order above 10".to_owned()
            } else {
                format!("finds order {order}")
            };
            assert!(message.contains(&finds), "{message}");
        }
    }
}

/// A copy with every literal changed, in their order.
fn each_literal(tokens: TokenStream, change: &mut dyn FnMut(Literal) -> Literal) -> TokenStream {
    let mut changed = TokenStream::new();
    for tree in tokens {
        changed.extend([match tree {
            TokenTree::Group(group) => {
                let inner = each_literal(group.stream(), change);
                TokenTree::Group(proc_macro2::Group::new(group.delimiter(), inner))
            }
            TokenTree::Literal(literal) => TokenTree::Literal(change(literal)),
            other => other,
        }]);
    }
    changed
}
