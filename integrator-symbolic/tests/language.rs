//! The tables of `docs/language.md` are true: what is accepted expands to code, what is refused gives the message shown.

use integrator_symbolic::hamiltonian;
use proc_macro2::{TokenStream, TokenTree};

const DOCUMENT: &str = include_str!("../../docs/language.md");

/// The cells of every row of the tables in a part of the document, without heads and rules.
fn rows(part: &str) -> Vec<Vec<String>> {
    let lines = part.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| construct"));
    let cells = |line: &str| {
        let line = line.replace("\\|", "\u{0}");
        let cells = line.trim_matches('|').split(" | ").map(|cell| cell.trim().replace('\u{0}', "|"));
        cells.collect::<Vec<_>>()
    };
    lines.map(cells).collect()
}

/// The document's accepted and refused parts.
fn parts() -> [&'static str; 2] {
    let (_, tables) = DOCUMENT.split_once("\n## Accepted").expect("a section");
    let (accepted, refused) = tables.split_once("\n## Refused").expect("a section");
    [accepted, refused]
}

/// An example as an annotated item.
fn item(example: &str) -> String {
    let example = example.trim_matches('`');
    if example.starts_with("impl") {
        return example.to_owned();
    }
    if example.starts_with("fn potential") {
        let function: syn::ImplItemFn = syn::parse_str(example).expect("a function");
        let Some(syn::FnArg::Typed(q)) = function.sig.inputs.iter().nth(1) else { panic!("{example}") };
        let kind = &q.ty;
        return quote::quote!(impl System { fn kinetic(&self, p: #kind) -> f64 { 0.0 } #function }).to_string();
    }
    let (_, surroundings) = DOCUMENT.split_once("```rust\n").expect("the surroundings");
    let (surroundings, _) = surroundings.split_once("```").expect("their end");
    surroundings.replace("/* the example */", example)
}

fn expand(example: &str) -> TokenStream {
    hamiltonian(TokenStream::new(), item(example).parse().expect("tokens"))
}

/// Every message in some tokens.
fn messages(output: TokenStream) -> Vec<String> {
    let trees: Vec<TokenTree> = output.into_iter().collect();
    let mut found = Vec::new();
    for (at, tree) in trees.iter().enumerate() {
        match (tree, trees.get(at + 2)) {
            (TokenTree::Ident(name), Some(TokenTree::Group(text))) if name == "compile_error" => {
                found.push(syn::parse2::<syn::LitStr>(text.stream()).expect("a message").value());
            }
            (TokenTree::Group(group), _) => found.extend(messages(group.stream())),
            _ => {}
        }
    }
    found
}

#[test]
fn accepted_examples_expand() {
    let rows = rows(parts()[0]);
    assert!(rows.len() > 80, "the rows are found: {}", rows.len());
    for row in rows {
        let [_, example] = &row[..] else { panic!("two columns: {row:?}") };
        let output = expand(example);
        assert_eq!(messages(output.clone()), [""; 0], "{example}");
        assert!(syn::parse2::<syn::File>(output).is_ok(), "{example}");
    }
}

#[test]
fn refused_examples_are_refused_with_their_message() {
    let rows = rows(parts()[1]);
    assert!(rows.len() > 50, "the rows are found: {}", rows.len());
    let mut wrong = String::new();
    for row in rows {
        let [_, example, begins, _] = &row[..] else { panic!("four columns: {row:?}") };
        let found = messages(expand(example));
        assert!(!found.is_empty(), "{example} is accepted");
        // Two bounds of one loop, or two functions, may deserve the same message.
        for message in found.iter().filter(|message| !message.starts_with(begins.as_str())) {
            wrong += &format!("{example}: {}\n", message.lines().next().unwrap_or_default());
        }
    }
    assert!(wrong.is_empty(), "other messages:\n{wrong}");
}
