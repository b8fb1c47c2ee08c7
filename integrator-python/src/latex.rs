//! Formulas of the generator as LaTeX.

/// Names that are commands of LaTeX: functions and Greek letters.
const COMMANDS: &str = " sin cos tan sinh cosh tanh exp ln min max alpha beta gamma delta epsilon zeta eta theta iota kappa lambda \
                        mu nu xi rho sigma tau upsilon phi chi psi omega ";

/// Words between formulas.
const WORDS: &str = " if else for in where ";

/// Operators with a space on both sides.
const OPERATORS: [(&str, &str); 12] = [
    ("+=", "\\mathrel{+}="),
    ("<=", "\\le"),
    (">=", "\\ge"),
    ("==", "="),
    ("+", "+"),
    ("-", "-"),
    ("/", "/"),
    ("%", "\\bmod"),
    ("=", "="),
    ("<", "<"),
    (">", ">"),
    ("", "\\,"),
];

/// Translates a formula such as `dp[0]/dt = -gm q[0] / r^3`, one line of `Hamiltonian::EQUATIONS`. The first relation is aligned.
pub(crate) fn line(formula: &str) -> String {
    let rate = formula.split_once("/dt").and_then(|(rate, rest)| Some((rate.strip_prefix('d')?, rest)));
    let latex = match rate {
        Some((rate, rest)) => format!("\\dot {}{}", translated(rate), translated(rest)),
        None => translated(formula),
    };
    match latex.find("\\mathrel{+}=").or_else(|| latex.find("= ")) {
        Some(at) => format!("{}&{}", &latex[..at], &latex[at..]),
        None => latex,
    }
}

/// Words, brackets and operators, one after the other.
fn translated(formula: &str) -> String {
    let (mut latex, mut rest) = (String::new(), formula);
    // What ends the brackets that are open.
    let mut closing = Vec::new();
    while let Some(first) = rest.chars().next() {
        let length = length_of_word(rest);
        let (word, after) = rest.split_at(length.max(first.len_utf8()));
        rest = after;
        match first {
            _ if word == "sqrt" && rest.starts_with('(') => {
                latex.push_str("\\sqrt{");
                closing.push("}");
                rest = &rest[1..];
            }
            _ if length > 0 => latex.push_str(&named(word)),
            ' ' => {
                rest = rest.trim_start_matches(' ');
                let (operator, translation) =
                    OPERATORS.into_iter().find(|(operator, _)| rest.starts_with(operator)).unwrap_or_default();
                rest = rest[operator.len()..].trim_start_matches(' ');
                latex.push_str(&format!(" {translation} "));
            }
            '^' if rest.starts_with('(') => {
                latex.push_str("^{");
                closing.push("}");
                rest = &rest[1..];
            }
            '^' => {
                let sign = usize::from(rest.starts_with('-'));
                let (exponent, after) = rest.split_at(sign + length_of_word(&rest[sign..]));
                latex.push_str(&format!("^{{{}}}", translated(exponent)));
                rest = after;
            }
            '[' => {
                latex.push_str("_{");
                closing.push("}");
            }
            ']' if rest.starts_with('[') => {
                latex.push(',');
                rest = &rest[1..];
            }
            'Σ' => {
                latex.push_str("\\sum_{");
                closing.push("}");
                rest = rest.strip_prefix("_{").unwrap_or(rest);
            }
            '(' | '{' => {
                latex.push_str(if first == '(' { "\\left(" } else { "\\left\\{" });
                closing.push(if first == '(' { "\\right)" } else { "\\right\\}" });
            }
            ')' | ']' | '}' => latex.push_str(closing.pop().unwrap_or_default()),
            ',' => latex.push_str(",\\;"),
            other => latex.push(other),
        }
    }
    latex
}

/// The number of bytes of the name or number at the beginning; names of types, `f64::from`, are parts of it.
fn length_of_word(text: &str) -> usize {
    let is_of_word = |c: char| c != 'Σ' && (c.is_alphanumeric() || "_.:".contains(c));
    text.find(|c| !is_of_word(c)).unwrap_or(text.len())
}

/// A number, a letter, a Greek letter, a word between formulas, or a name of several letters.
fn named(word: &str) -> String {
    let head = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &word[head.len()..];
    let latex = match head {
        _ if word.starts_with(|c: char| c.is_ascii_digit()) => return word.replace("..", " \\ldots "),
        "PI" => "\\pi ".to_owned(),
        _ if WORDS.contains(&format!(" {head} ")) => format!("\\text{{ {head} }}"),
        _ if COMMANDS.contains(&format!(" {head} ")) => format!("\\{head} "),
        _ if head.chars().count() == 1 => head.to_owned(),
        _ => format!("\\mathrm{{{}}}", head.replace('_', "\\_")),
    };
    if digits.is_empty() { latex } else { format!("{latex}_{{{digits}}}") }
}
