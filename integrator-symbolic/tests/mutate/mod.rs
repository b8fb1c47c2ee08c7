//! Annotated impls with mistakes in them, made of bytes: for the property tests, and for the fuzz targets, which include
//! this file by its path.
//!
//! Comes in: bytes, which are read as choices. Goes out: the arguments and the item of an annotation, as text that need
//! not be tokens. Always true: equal bytes give equal text.

use proc_macro2::{Delimiter, Group, Spacing, TokenStream, TokenTree};
use quote::ToTokens;
use std::{fs, path::Path};

/// An annotated impl, its tokens one by one, so that brackets can be lost as well.
pub(crate) struct Sample {
    arguments: Vec<String>,
    item: Vec<String>,
}

impl Sample {
    /// A sample of the text of an annotation's arguments and of its item.
    pub(crate) fn new(arguments: &str, item: &str) -> Self {
        let flat = |text: &str| {
            let mut tokens = Vec::new();
            flatten(text.parse().expect("tokens"), &mut tokens);
            tokens
        };
        Self { arguments: flat(arguments), item: flat(item) }
    }
}

/// The annotated impls in the files of a folder.
pub(crate) fn annotated(folder: &Path) -> Vec<Sample> {
    let entries = fs::read_dir(folder).expect("a readable folder").map(|entry| entry.expect("an entry").path());
    let mut files: Vec<_> =
        entries.filter(|path| path.extension().is_some_and(|extension| extension == "rs")).collect();
    files.sort();
    let mut found = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("text");
        for item in syn::parse_file(&text).expect("a file of Rust").items {
            let syn::Item::Impl(mut item) = item else { continue };
            let Some(at) = item.attrs.iter().position(|attribute| attribute.path().is_ident("hamiltonian")) else {
                continue;
            };
            let arguments = match item.attrs.remove(at).meta {
                syn::Meta::List(list) => list.tokens.to_string(),
                _ => String::new(),
            };
            found.push(Sample::new(&arguments, &item.to_token_stream().to_string()));
        }
    }
    found
}

fn flatten(tokens: TokenStream, into: &mut Vec<String>) {
    for tree in tokens {
        match tree {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                into.push(open.to_owned());
                flatten(group.stream(), into);
                into.push(close.to_owned());
            }
            // Signs of one operator stay together.
            TokenTree::Punct(sign) if sign.spacing() == Spacing::Joint => into.push(format!("{sign}{JOINT}")),
            other => into.push(other.to_string()),
        }
    }
}

/// Marks a sign that the next one follows without a space.
const JOINT: char = '\u{0}';

fn text(tokens: &[String]) -> String {
    tokens.join(" ").replace("\u{0} ", "").replace(JOINT, "")
}

/// Bytes as choices; behind their end every choice is the first.
struct Choices<'b>(&'b [u8]);

impl Choices<'_> {
    /// A number below `count`.
    fn below(&mut self, count: usize) -> usize {
        let (now, rest) = self.0.split_at(self.0.len().min(2));
        self.0 = rest;
        let number = now.iter().fold(0, |number, byte| number << 8 | usize::from(*byte));
        number % count.max(1)
    }

    fn of<'l>(&mut self, list: &'l [&str]) -> &'l str {
        list[self.below(list.len())]
    }
}

/// What takes the place of a token.
const OTHERS: [&str; 40] = [
    "+",
    "0",
    "1.5",
    "p",
    "q",
    "self",
    "for",
    "if",
    "=",
    ";",
    "(",
    "}",
    "'a",
    "-",
    "fn",
    "1e999",
    "_",
    "..",
    "%",
    "else",
    "18446744073709551615",
    "let",
    "mut",
    "|",
    "return",
    "continue",
    "break",
    "&&",
    "i",
    "[",
    ".",
    "sum",
    "map",
    "impl",
    "as",
    "match",
    "unsafe",
    "\"text\"",
    "#",
    "as f64",
];

/// A sample with up to three changes to its item and one to its arguments.
pub(crate) fn mutated(bytes: &[u8], samples: &[Sample]) -> [String; 2] {
    let mut choices = Choices(bytes);
    let sample = &samples[choices.below(samples.len())];
    let (mut arguments, mut item) = (sample.arguments.clone(), sample.item.clone());
    for _ in 0..choices.below(4) {
        change(&mut item, samples, &mut choices);
    }
    for _ in 0..choices.below(2) {
        change(&mut arguments, samples, &mut choices);
    }
    [text(&arguments), text(&item)]
}

/// Loses, doubles, exchanges or replaces a token, or brings tokens of another sample.
fn change(list: &mut Vec<String>, samples: &[Sample], choices: &mut Choices<'_>) {
    if list.is_empty() {
        return;
    }
    let (kind, at) = (choices.below(5), choices.below(list.len()));
    match kind {
        0 => drop(list.remove(at)),
        1 => list.insert(at, list[at].clone()),
        2 => {
            let other = choices.below(list.len());
            list.swap(at, other);
        }
        3 => list[at] = choices.of(&OTHERS).to_owned(),
        _ => {
            let other = &samples[choices.below(samples.len())].item;
            let from = choices.below(other.len());
            let to = other.len().min(from + 1 + choices.below(12));
            list.splice(at..at, other[from..to].iter().cloned());
        }
    }
}

/// Words of the language of H; brackets open here and are closed at the end.
const WORDS: [&str; 64] = [
    "q",
    "p",
    "t",
    "x",
    "i",
    "j",
    "self",
    "self.mass",
    "self.list",
    "q[0]",
    "q[i]",
    "p[1]",
    "0",
    "1",
    "2.5",
    "0..2",
    "1..=n",
    "..",
    "+",
    "-",
    "*",
    "/",
    "%",
    "<",
    "==",
    "&&",
    "!",
    "=",
    "+=",
    ".",
    ",",
    ";",
    "let x =",
    "let mut v = 0.0;",
    "v +=",
    "for i in 0..2 {",
    "for x in q {",
    "for (i, j) in &self.list {",
    "if q[0] < 1.0 {",
    "} else {",
    "}",
    "(",
    ")",
    "[",
    "]",
    "{",
    ".sin()",
    ".powi(2)",
    ".powf(",
    ".sqrt()",
    ".iter()",
    ".map(|x|",
    ".sum::<f64>()",
    ".zip(",
    ".enumerate()",
    ".windows(2)",
    ".fold(0.0, |s, x| s +",
    ".filter(|x|",
    "self.helper(",
    "Self::helper(",
    "f64::sin(",
    "as f64",
    "&",
    "|x|",
];

/// Bodies of arbitrary words in an impl that is sound otherwise.
pub(crate) fn arbitrary(bytes: &[u8]) -> [String; 2] {
    let mut choices = Choices(bytes);
    let body = |choices: &mut Choices<'_>| {
        let mut text = String::new();
        let mut open = Vec::new();
        for _ in 0..choices.below(12) {
            let word = choices.of(&WORDS);
            for sign in word.chars() {
                match sign {
                    '(' => open.push(')'),
                    '[' => open.push(']'),
                    '{' => open.push('}'),
                    ')' | ']' | '}' if open.last() == Some(&sign) => drop(open.pop()),
                    // A bracket that closes nothing is left out.
                    ')' | ']' | '}' => continue,
                    _ => {}
                }
                text.push(sign);
            }
            text.push(' ');
        }
        text.extend(open.into_iter().rev());
        text
    };
    let [kinetic, potential, helper] = [0; 3].map(|_| body(&mut choices));
    let item = format!(
        "impl System {{ fn kinetic(&self, p: [f64; 2]) -> f64 {{ {kinetic} }} \
         fn potential(&self, q: &[f64; 2], t: f64) -> f64 {{ {potential} }} \
         fn helper(&self, x: f64) -> f64 {{ {helper} }} }}"
    );
    [String::new(), item]
}

/// Expands text, if it is tokens, and says what is wrong with the outcome: the user's item comes first, and what follows
/// is code that parses, or messages.
pub(crate) fn expanded([arguments, item]: &[String; 2]) -> Result<(), String> {
    let (Ok(arguments), Ok(item)) = (arguments.parse::<TokenStream>(), item.parse::<TokenStream>()) else {
        return Ok(());
    };
    let output = integrator_symbolic::hamiltonian(arguments, item.clone());
    if syn::parse2::<syn::File>(output.clone()).is_ok() || has_message(&output) {
        return if follows(&output, &item) { Ok(()) } else { Err(format!("the item is lost: {output}")) };
    }
    Err(format!("neither code nor a message: {output}"))
}

fn has_message(output: &TokenStream) -> bool {
    output.clone().into_iter().any(|tree| match tree {
        TokenTree::Ident(name) => name == "compile_error",
        TokenTree::Group(group) => has_message(&group.stream()),
        _ => false,
    })
}

/// Whether the output contains the item, after attributes at most.
fn follows(output: &TokenStream, item: &TokenStream) -> bool {
    let plain = |tokens: &TokenStream| as_typed(tokens.clone()).to_string();
    plain(output).contains(&plain(item))
}

/// Tokens without the attribute `#[derivative(..)]`, which the macro removes, and with the bodies that it hides from rustc.
fn as_typed(tokens: TokenStream) -> TokenStream {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let is_own = |at: usize| match (trees.get(at), trees.get(at + 1)) {
        (Some(TokenTree::Punct(sign)), Some(TokenTree::Group(group))) if sign.as_char() == '#' => {
            let first = group.stream().into_iter().next();
            matches!(first, Some(TokenTree::Ident(name)) if name == "derivative")
        }
        _ => false,
    };
    // The sign and the brackets after it.
    let is_part = |at: usize| is_own(at) || at > 0 && is_own(at - 1);
    let kept = trees.iter().enumerate().filter(|(at, _)| !is_part(*at));
    let inner = |tree: &TokenTree| match tree {
        TokenTree::Group(group) => {
            let stream = hidden(group).unwrap_or_else(|| group.stream());
            TokenTree::Group(Group::new(group.delimiter(), as_typed(stream)))
        }
        other => other.clone(),
    };
    kept.map(|(_, tree)| inner(tree)).collect()
}

/// The body behind `#[cfg(test)]`, in a function with a mistake.
fn hidden(body: &Group) -> Option<TokenStream> {
    let trees: Vec<TokenTree> = body.stream().into_iter().collect();
    let [_, _, TokenTree::Group(lints), _, TokenTree::Group(_), TokenTree::Group(typed), ..] = &trees[..] else {
        return None;
    };
    lints.stream().to_string().starts_with("allow (unused , reason").then(|| typed.stream())
}
