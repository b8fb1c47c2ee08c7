//! The tokens of device code, and their translation from C++ to C99 in double precision.
//!
//! In: the lines of a function. Out: the same lines in C. Always true: operations and their order stay as they are; what has a
//! type parameter becomes a `double`, a reference becomes a pointer, and what C has no words for becomes a function.

use std::collections::{BTreeMap, BTreeSet};

/// A token, after the space in front of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token<'t> {
    pub(super) space: &'t str,
    pub(super) text: &'t str,
}

/// The tokens of C++ without comments and directives.
pub(super) fn tokens(text: &str) -> Vec<Token<'_>> {
    let (mut found, mut rest) = (Vec::new(), text);
    while !rest.trim_start().is_empty() {
        let (space, code) = rest.split_at(rest.len() - rest.trim_start().len());
        if code.starts_with("//") || code.starts_with('#') {
            let line = code.split_inclusive('\n').scan(true, |goes_on, line| {
                std::mem::replace(goes_on, line.trim_end().ends_with('\\')).then_some(line.len())
            });
            rest = &code[line.sum::<usize>()..];
            continue;
        }
        let length = length_of_token(code);
        found.push(Token { space, text: &code[..length] });
        rest = &code[length..];
    }
    found
}

fn length_of_token(code: &str) -> usize {
    let is_word = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    if code.starts_with(|first: char| first.is_ascii_digit()) {
        let mut last = ' ';
        let is_hexadecimal = code.starts_with("0x");
        let goes_on = |letter: char| {
            let signs = if is_hexadecimal { ['p', 'P'] } else { ['e', 'E'] };
            let goes_on = is_word(letter) || letter == '.' || matches!(letter, '+' | '-') && signs.contains(&last);
            last = letter;
            !goes_on
        };
        return code.find(goes_on).unwrap_or(code.len());
    }
    if code.starts_with(is_word) {
        return code.find(|letter| !is_word(letter)).unwrap_or(code.len());
    }
    let pairs = ["::", "<<", "<=", ">=", "==", "!=", "&&", "||", "+=", "-=", "++", "--"];
    if pairs.iter().any(|pair| code.starts_with(pair)) { 2 } else { code.chars().next().map_or(1, char::len_utf8) }
}

/// The position after the bracket that closes the one at the beginning.
pub(super) fn closing(tokens: &[Token<'_>]) -> usize {
    let mut depth = 0;
    for (at, token) in tokens.iter().enumerate() {
        match token.text {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    tokens.len()
}

/// What commas outside of brackets separate.
pub(super) fn separated<'a, 't>(tokens: &'a [Token<'t>]) -> Vec<&'a [Token<'t>]> {
    let (mut found, mut from, mut at) = (Vec::new(), 0, 0);
    while at < tokens.len() {
        match tokens[at].text {
            "(" | "[" | "{" => at += closing(&tokens[at..]),
            "<" if matches!(tokens.get(at + 2).map(|token| token.text), Some("," | ">")) => {
                at += tokens[at..].iter().position(|token| token.text == ">").map_or(1, |end| end + 1);
            }
            "," => {
                found.push(&tokens[from..at]);
                (from, at) = (at + 1, at + 1);
            }
            _ => at += 1,
        }
    }
    if from < tokens.len() {
        found.push(&tokens[from..]);
    }
    found
}

/// What lines know of the functions and constants around them.
pub(super) struct Scope<'s> {
    /// What all names begin with.
    pub(super) prefix: &'s str,
    /// Of each function, which arguments are references.
    pub(super) functions: BTreeMap<String, Vec<bool>>,
    /// Functions of the maths library, by their names in C++.
    pub(super) library: BTreeMap<String, String>,
    pub(super) constants: BTreeMap<String, String>,
    /// The lengths of tables of prepared constants.
    pub(super) tables: BTreeMap<String, u64>,
    /// The number of components of a point.
    pub(super) dimension: Option<u64>,
    /// Called so far.
    pub(super) called: BTreeSet<String>,
}

/// The lines of one function.
pub(super) struct Lines<'l, 's> {
    pub(super) scope: &'l mut Scope<'s>,
    /// What unqualified names of its own scope begin with.
    pub(super) own: &'l str,
    /// The names that are pointers, each with the depth of its block.
    pub(super) pointers: Vec<(String, usize)>,
    depth: usize,
}

impl<'l, 's> Lines<'l, 's> {
    pub(super) fn new(scope: &'l mut Scope<'s>, own: &'l str, pointers: impl Iterator<Item = String>) -> Self {
        Self { scope, own, pointers: pointers.map(|name| (name, 0)).collect(), depth: 0 }
    }

    /// The same in C.
    pub(super) fn in_c(&mut self, tokens: &[Token<'_>]) -> String {
        let (mut out, mut statement, mut at) = (String::new(), 0, 0);
        while at < tokens.len() {
            let (rest, space) = (&tokens[at..], tokens[at].space);
            let texts: Vec<&str> = rest.iter().take(9).map(|token| token.text).collect();
            let prefix = self.scope.prefix;
            let (text, length) = match texts[..] {
                ["typedef", ..] => (String::new(), 1 + position(rest, ";")),
                ["if", "constexpr", ..] => self.choice(rest),
                ["System", "::", name, "(", ..] => self.call(name, "", &rest[3..], 3),
                ["System", "::", ..] | ["::", ..] => (String::new(), if texts[0] == "System" { 2 } else { 1 }),
                ["Pairs", "<", ..] => {
                    let name = position(rest, "::") + 1;
                    self.call(rest[name].text, "pairs_", &rest[name + 1..], name + 1)
                }
                ["Format", "<", "R", ">", "::", name, ..] => (self.constant(&format!("Format::{name}")), 6),
                ["F", "::", name, ..] => (self.constant(&format!("Format::{name}")), 3),
                ["R", "(", ..] => {
                    let end = 1 + closing(&rest[1..]);
                    let inside = self.in_c(&rest[2..end - 1]);
                    let is_word = inside.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '.');
                    (if is_word { inside } else { format!("({inside})") }, end)
                }
                ["double" | "float" | "int", "(", ..] => (format!("({})", texts[0]), 1),
                ["PartialSums", "<", "R", ">", name, ..] => {
                    let end = 5 + closing(&rest[5..]);
                    let arguments = self.in_c(&rest[5..end]);
                    (format!("{prefix}partial_sums {name} = {prefix}partial_sums_of{arguments}"), end)
                }
                ["R", "&", name, "=", sums, ".", "at", "(", ..] => {
                    let end = 7 + closing(&rest[7..]);
                    let index = self.in_c(&rest[8..end - 1]);
                    self.pointers.push((name.to_owned(), self.depth));
                    (format!("double* {name} = {prefix}partial_sum(&{sums}, {index})"), end)
                }
                [sums, ".", "total", "(", ")", ..] => (format!("{prefix}total_of(&{sums})"), 5),
                ["Plain", "<", "R", ">", ..] => {
                    let end = 4 + closing(&rest[4..]);
                    (self.in_c(&rest[5..end - 1]), end)
                }
                ["Reduced", "<", "R", ">", ..] => (format!("{prefix}reduced"), 4),
                ["Point", ..] => (format!("{prefix}point"), 1),
                ["motion", ".", "position" | "momentum", ..] => {
                    let end = 3 + closing(&rest[3..]);
                    let (half, number) = (if texts[2] == "position" { "q" } else { "p" }, self.in_c(&rest[4..end - 1]));
                    let place = match self.scope.dimension {
                        Some(dimension) => format!("[({number}) / {dimension}][({number}) % {dimension}]"),
                        None => format!("[{number}]"),
                    };
                    (format!("motion->{half}{place}"), end)
                }
                [".", "value", "(", ")", ..] => (String::new(), 4),
                [".", "fma" | "add", ..] => {
                    let end = 2 + closing(&rest[2..]);
                    let (place, arguments) = (out[statement..].trim().to_owned(), self.in_c(&rest[3..end - 1]));
                    let fused = texts[1] == "fma";
                    (if fused { format!(" = fma({arguments}, {place})") } else { format!(" += {arguments}") }, end)
                }
                ["element_of", "(", ..] => self.element(rest),
                [name, "<", "R", ">", "(", ..] => self.call(name, self.own, &rest[4..], 4),
                [name, "(", ..] if name.starts_with(|first: char| first.is_ascii_alphabetic()) && !is_keyword(name) => {
                    self.call(name, self.own, &rest[1..], 1)
                }
                ["=", "{", "}", ..] => ("= {0}".to_owned(), 3),
                ["R", ..] => ("double".to_owned(), 1),
                ["bool", ..] => ("int".to_owned(), 1),
                ["true", ..] => ("1".to_owned(), 1),
                ["false", ..] => ("0".to_owned(), 1),
                [name, ..] => self.name(name, &texts),
                [] => (String::new(), 1),
            };
            match texts[0] {
                "{" => self.depth += 1,
                "}" => {
                    self.depth -= 1;
                    let depth = self.depth;
                    self.pointers.retain(|(_, of)| *of <= depth);
                }
                _ => {}
            }
            if texts[0] != "typedef" {
                out += space;
            }
            out += &text;
            if matches!(texts[0], ";" | "{" | "}") {
                statement = out.len();
            }
            at += length;
        }
        out
    }

    fn is_pointer(&self, name: &str) -> bool {
        self.pointers.iter().any(|(pointer, _)| pointer == name)
    }

    /// A name, or another token.
    fn name(&self, name: &str, texts: &[&str]) -> (String, usize) {
        if self.is_pointer(name) {
            return match texts.get(1) {
                Some(&".") if texts.get(2) != Some(&"value") => (format!("{name}->"), 2),
                _ => (format!("(*{name})"), 1),
            };
        }
        match self.scope.constants.get(name) {
            Some(value) => (value.clone(), 1),
            None => (name.to_owned(), 1),
        }
    }

    fn constant(&self, name: &str) -> String {
        self.scope.constants.get(name).cloned().unwrap_or_else(|| name.to_owned())
    }

    /// A call of a function, whose arguments follow.
    fn call(&mut self, name: &str, own: &str, rest: &[Token<'_>], before: usize) -> (String, usize) {
        let length = closing(rest);
        let known =
            [format!("{own}{name}"), name.to_owned()].into_iter().find(|name| self.scope.functions.contains_key(name));
        let references = known.as_ref().map(|known| self.scope.functions[known].clone()).unwrap_or_default();
        let arguments: Vec<String> = separated(&rest[1..length - 1])
            .into_iter()
            .enumerate()
            .map(|(number, argument)| {
                if references.get(number) != Some(&true) {
                    return self.in_c(argument).trim().to_owned();
                }
                match argument {
                    [one] if self.is_pointer(one.text) => one.text.to_owned(),
                    _ => format!("&{}", self.in_c(argument).trim()),
                }
            })
            .collect();
        let name = match (&known, self.scope.library.get(name)) {
            (Some(known), _) => {
                self.scope.called.insert(known.clone());
                format!("{}{known}", self.scope.prefix)
            }
            (None, Some(name)) => name.clone(),
            (None, None) => name.to_owned(),
        };
        (format!("{name}({})", arguments.join(", ")), before + length)
    }

    /// The branch of a condition on constants that holds.
    fn choice(&mut self, rest: &[Token<'_>]) -> (String, usize) {
        let condition = closing(&rest[2..]) + 2;
        let holds = self.constant(rest[condition - 2].text) != "0";
        let first = condition + closing(&rest[condition..]);
        let is_followed = rest.get(first).is_some_and(|token| token.text == "else");
        let second = if is_followed { first + 1 + closing(&rest[first + 1..]) } else { first };
        let chosen = if holds { &rest[condition..first] } else { &rest[(first + 1).min(second)..second] };
        (if chosen.is_empty() { String::new() } else { self.in_c(chosen).trim_start().to_owned() }, second)
    }

    /// An element of a table over the sites of a line; zero where it has none.
    fn element(&mut self, rest: &[Token<'_>]) -> (String, usize) {
        let end = 1 + closing(&rest[1..]);
        let arguments = separated(&rest[2..end - 1]);
        let name = arguments[0].last().map_or("", |token| token.text);
        let length = self.scope.tables.get(name).copied().unwrap_or_default();
        let [table, site] = [arguments[0], arguments[1]].map(|argument| self.in_c(argument).trim().to_owned());
        (format!("({site} < {length} ? {table}[{site}] : 0)"), end)
    }
}

fn position(tokens: &[Token<'_>], text: &str) -> usize {
    tokens.iter().position(|token| token.text == text).unwrap_or(tokens.len() - 1)
}

fn is_keyword(word: &str) -> bool {
    matches!(word, "for" | "if" | "return")
}
