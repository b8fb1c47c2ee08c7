//! The functions of device code in C99.
//!
//! In: C++, the runtime's or that of a system. Out: the functions of both as C, each where it is called.

use super::lines::{Lines, Scope, Token, closing, separated, tokens};
use std::collections::BTreeMap;

/// A function of C++.
pub(super) struct Function<'t> {
    /// With what its scope begins.
    pub(super) name: String,
    result: String,
    arguments: Vec<Argument>,
    lines: &'t [Token<'t>],
}

struct Argument {
    name: String,
    /// Its type in C, and what follows the name.
    kind: [String; 2],
    is_reference: bool,
}

/// What a text declares.
#[derive(Default)]
pub(super) struct Declared<'t> {
    pub(super) functions: Vec<Function<'t>>,
    pub(super) constants: BTreeMap<String, String>,
    pub(super) library: BTreeMap<String, String>,
    /// Arrays of numbers, with their declarations.
    pub(super) arrays: BTreeMap<String, String>,
}

impl<'t> Declared<'t> {
    /// Adds what tokens declare, whose names begin with `own`, as functions of double precision.
    pub(super) fn add(&mut self, text: &'t [Token<'t>], own: &str, prefix: &str) {
        let mut at = 0;
        while at < text.len() {
            let rest = &text[at..];
            let word = |number: usize| rest.get(number).map_or("", |token| token.text);
            at += match word(0) {
                "template" => 1 + end_of_angles(&rest[1..]),
                "namespace" => 3,
                "struct" => self.structure(rest, own, prefix),
                "constexpr" => self.numbers(&rest[2..], "") + 2,
                "static" if word(1) == "constexpr" => self.numbers(&rest[3..], "") + 3,
                "alignas" => self.array(rest, prefix),
                "DEVICE" => self.function(rest, own, prefix),
                "INTEGRATOR_LIBRARY" | "INTEGRATOR_LIBRARY_OF_TWO" => {
                    self.library.insert(format!("library_{}", word(2)), word(4).to_owned());
                    1 + closing(&rest[1..])
                }
                _ => 1,
            };
        }
    }

    /// A struct: of one format the constants, of pairs the functions.
    fn structure(&mut self, rest: &'t [Token<'t>], own: &str, prefix: &str) -> usize {
        let Some(open) = rest.iter().position(|token| matches!(token.text, "{" | ";")) else { return rest.len() };
        if rest[open].text == ";" {
            return open + 1;
        }
        let (end, text) =
            (open + closing(&rest[open..]), |number: usize| rest.get(number).map_or("", |token| token.text));
        let inside = &rest[open + 1..end - 1];
        match (text(1), text(3)) {
            ("Format", "double") => {
                for (at, _) in inside.iter().enumerate().filter(|(_, token)| token.text == "constexpr") {
                    let from =
                        inside[at..].iter().position(|token| token.text == "=").map_or(at, |equal| at + equal - 1);
                    self.numbers(&inside[from..], "Format::");
                }
            }
            ("Pairs", _) => self.add(inside, own, prefix),
            _ => {}
        }
        end + 1
    }

    /// `A = 1.0, B = 2.0;`
    fn numbers(&mut self, rest: &[Token<'_>], of: &str) -> usize {
        let end = rest.iter().position(|token| token.text == ";").unwrap_or(rest.len());
        for number in separated(&rest[..end]) {
            let [name, _, value @ ..] = number else { continue };
            let value: String =
                value.iter().map(|token| self.constants.get(token.text).map_or(token.text, String::as_str)).collect();
            let value = match value.as_str() {
                "true" => "1".to_owned(),
                "false" => "0".to_owned(),
                _ if number.len() == 3 => value,
                _ => format!("({value})"),
            };
            self.constants.insert(format!("{of}{}", name.text), value);
        }
        end + 1
    }

    /// `alignas(16) __device__ const double NAME[..] = {..};`
    fn array(&mut self, rest: &[Token<'_>], prefix: &str) -> usize {
        let end = rest.iter().position(|token| token.text == ";").unwrap_or(rest.len());
        let from = rest.iter().position(|token| token.text == "[").unwrap_or(1);
        let name = rest[from - 1].text;
        let lines: String = rest[from..end].iter().map(|token| format!("{}{}", token.space, token.text)).collect();
        self.constants.insert(name.to_owned(), format!("{prefix}{name}"));
        self.arrays.insert(format!("{prefix}{name}"), format!("static const double {prefix}{name}{lines};\n"));
        end + 1
    }

    /// A function, unless it is of single precision.
    fn function(&mut self, rest: &'t [Token<'t>], own: &str, prefix: &str) -> usize {
        let Some(open) = rest.iter().position(|token| token.text == "(") else { return rest.len() };
        let lines = open + closing(&rest[open..]);
        let end = lines + closing(&rest[lines..]);
        let head: Vec<&str> =
            rest[1..open - 1].iter().map(|token| token.text).filter(|text| *text != "static").collect();
        if rest[..lines].iter().all(|token| token.text != "float") {
            let arguments =
                separated(&rest[open + 1..lines - 1]).into_iter().map(|argument| Argument::of(argument, prefix));
            let function = Function {
                name: format!("{own}{}", rest[open - 1].text),
                result: kind(&head, prefix),
                arguments: arguments.collect(),
                lines: &rest[lines..end],
            };
            self.functions.push(function);
        }
        end
    }
}

/// The position after the angle bracket that closes the first one.
fn end_of_angles(tokens: &[Token<'_>]) -> usize {
    let mut depth = 0;
    let closes = tokens.iter().position(|token| {
        depth += i32::from(token.text == "<") - i32::from(token.text == ">");
        depth == 0
    });
    closes.map_or(tokens.len(), |at| at + 1)
}

/// A type in C.
fn kind(words: &[&str], prefix: &str) -> String {
    let named = |name: &str| match name {
        "R" => "double".to_owned(),
        "bool" => "int".to_owned(),
        "Motion" | "Reduced" | "Point" => format!("{prefix}{}", name.to_ascii_lowercase()),
        _ => name.to_owned(),
    };
    let generic = words.iter().position(|word| *word == "<").unwrap_or(words.len());
    words[..generic].iter().map(|word| named(word)).collect::<Vec<_>>().join(" ")
}

impl Argument {
    fn of(tokens: &[Token<'_>], prefix: &str) -> Self {
        let words: Vec<&str> = tokens.iter().map(|token| token.text).collect();
        // `R (&name)[3]`
        if let Some(open) = words.iter().position(|word| *word == "(") {
            let kind = [kind(&words[..open], prefix), words[open + 4..].concat()];
            return Self { name: words[open + 2].to_owned(), kind, is_reference: false };
        }
        let (name, words) = words.split_last().map_or(("", &words[..]), |(name, words)| (name, words));
        let is_reference = words.contains(&"&") && words[0] != "const" && words[0] != "Point";
        let words: Vec<&str> = words.iter().copied().filter(|word| *word != "&").collect();
        let star = if is_reference { " *" } else { " " };
        Self { name: name.to_owned(), kind: [kind(&words, prefix) + star, String::new()], is_reference }
    }
}

impl Function<'_> {
    pub(super) fn references(&self) -> Vec<bool> {
        self.arguments.iter().map(|argument| argument.is_reference).collect()
    }

    /// Its definition in C.
    pub(super) fn in_c(&self, scope: &mut Scope<'_>, own: &str) -> String {
        let Self { name, result, arguments, lines } = self;
        let prefix = scope.prefix;
        let pointers = arguments.iter().filter(|argument| argument.is_reference).map(|argument| argument.name.clone());
        let lines = Lines::new(scope, own, pointers).in_c(lines);
        let words: Vec<Token<'_>> = tokens(&lines);
        let unused = arguments.iter().filter(|argument| words.iter().all(|word| word.text != argument.name));
        let unused: String = unused.map(|argument| format!("\n    (void){};", argument.name)).collect();
        let lines = lines.trim_start().trim_start_matches('{').trim_end_matches('}').trim_end();
        let declared = arguments.iter().map(|Argument { name, kind: [before, after], .. }| {
            let gap = if before.ends_with(['*', ' ']) { "" } else { " " };
            format!("{before}{gap}{name}{after}")
        });
        let declared = declared.collect::<Vec<_>>().join(", ");
        let (lines, end) = if lines.contains('\n') || !unused.is_empty() {
            (lines.to_owned(), "\n}")
        } else {
            (lines.to_owned(), " }")
        };
        format!(
            "static inline {result} {prefix}{name}({}) {{{unused}{lines}{end}\n",
            if declared.is_empty() { "void" } else { &declared }
        )
    }
}
