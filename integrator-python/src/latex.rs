//! Formulas of the generator as LaTeX.

/// The functions that LaTeX has a command for, and names that are Greek letters.
const COMMANDS: &str = " sin cos tan sinh cosh tanh exp ln min max alpha beta gamma delta epsilon zeta eta theta iota kappa lambda \
                        mu nu xi rho sigma tau upsilon phi chi psi omega ";

/// Translates a formula such as `dp[0]/dt = -gm q[0] / r^3`, one line of `Hamiltonian::EQUATIONS`.
pub(crate) fn line(formula: &str) -> String {
    let (left, right) = formula.split_once(" = ").unwrap_or(("", formula));
    let left = match left.strip_suffix("/dt").and_then(|rate| rate.strip_prefix('d')) {
        Some(rate) => format!("\\dot {}", translated(rate)),
        None => translated(left),
    };
    format!("{left} &= {}", translated(right))
}

/// Words, brackets and operators, one after the other.
fn translated(formula: &str) -> String {
    let (mut latex, mut rest) = (String::new(), formula);
    // What ends the brackets that are open.
    let mut closing = Vec::new();
    while let Some(first) = rest.chars().next() {
        let is_of_word = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
        let length = rest.find(|c| !is_of_word(c)).unwrap_or(rest.len());
        if length > 0 && first != '_' {
            let word = &rest[..length];
            rest = &rest[length..];
            if let (true, Some(after)) = (word == "sqrt", rest.strip_prefix('(')) {
                latex.push_str("\\sqrt{");
                closing.push("}");
                rest = after;
            } else {
                latex.push_str(&named(word));
            }
            continue;
        }
        rest = &rest[first.len_utf8()..];
        match first {
            // The exponent is a word or in parentheses.
            '^' if !rest.starts_with('(') => {
                let sign = usize::from(rest.starts_with('-'));
                let length = rest[sign..].find(|c| !is_of_word(c)).map_or(rest.len(), |length| length + sign);
                latex.push_str(&format!("^{{{}}}", translated(&rest[..length])));
                rest = &rest[length..];
            }
            '[' if latex.ends_with('}') && latex.contains("_{") && rest_of_index(&latex) => {
                latex.pop();
                latex.push(',');
                closing.push("}");
            }
            '[' => {
                latex.push_str("_{");
                closing.push("}");
            }
            '_' if rest.starts_with('{') => {
                latex.push_str("_{");
                rest = &rest[1..];
                closing.push("}");
            }
            '(' | '{' => {
                latex.push_str(if first == '(' { "\\left(" } else { "\\left\\{" });
                closing.push(if first == '(' { "\\right)" } else { "\\right\\}" });
            }
            ')' | ']' | '}' => latex.push_str(closing.pop().unwrap_or_default()),
            'Σ' => latex.push_str("\\sum"),
            ' ' => latex.push_str(if rest.starts_with(['+', '-', '/', '=', '<', '>']) { " " } else { "\\, " }),
            '%' => latex.push_str("\\bmod "),
            other => latex.push(other),
        }
    }
    latex
}

/// Whether LaTeX ends with a subscript, to which further indices are added.
fn rest_of_index(latex: &str) -> bool {
    latex.rfind("_{").is_some_and(|begin| !latex[begin..latex.len() - 1].contains('}'))
}

/// A number, a letter, a Greek letter, a word between formulas, or a name of several letters.
fn named(word: &str) -> String {
    let head = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &word[head.len()..];
    let head = match head {
        _ if word.starts_with(|c: char| c.is_ascii_digit()) => return word.replace("..", " \\ldots "),
        "PI" => "\\pi".to_owned(),
        "if" | "else" | "for" | "in" => format!("\\text{{ {head} }}"),
        _ if COMMANDS.contains(&format!(" {head} ")) => format!("\\{head} "),
        _ if head.chars().count() == 1 => head.to_owned(),
        _ => format!("\\mathrm{{{}}}", head.replace('_', "\\_")),
    };
    if digits.is_empty() { head } else { format!("{head}_{{{digits}}}") }
}
