//! `#[hamiltonian]` from mistakes to messages: the text and the place of each, that all are reported, and that the macro
//! returns the user's item for every input.

mod friction;
mod jacobi;
mod layout;
#[path = "../mutate/mod.rs"]
mod mutate;
mod nested;
mod robustness;
mod sensitive;
mod size;
mod table;

use integrator_symbolic::{hamiltonian, known_functions};
use proc_macro2::{TokenStream, TokenTree};

fn tokens(text: &str) -> TokenStream {
    text.parse().expect("tokens")
}

/// The errors in the output, as `line:column message`. Columns count from 0, as the compiler's spans do.
fn errors(arguments: &str, item: &str) -> Vec<String> {
    let mut found = Vec::new();
    gather(hamiltonian(tokens(arguments), tokens(item)), &mut found);
    found
}

/// Finds `compile_error!` in any tokens: where the user's item does not parse, neither does the output.
fn gather(output: TokenStream, found: &mut Vec<String>) {
    let trees: Vec<TokenTree> = output.into_iter().collect();
    for (at, tree) in trees.iter().enumerate() {
        match (tree, trees.get(at + 2)) {
            (TokenTree::Ident(name), Some(TokenTree::Group(text))) if name == "compile_error" => {
                let message: syn::LitStr = syn::parse2(text.stream()).expect("a message");
                assert!(is_formed(&message.value()), "not of the form of a message: {}", message.value());
                let start = name.span().start();
                found.push(format!("{}:{} {}", start.line, start.column, short(&message.value())));
            }
            (TokenTree::Group(group), _) => gather(group.stream(), found),
            _ => {}
        }
    }
}

/// Whether a message is one line without a full stop, followed by lines with advice and reasons.
fn is_formed(message: &str) -> bool {
    let mut lines = message.lines();
    let what = lines.next().unwrap_or_default();
    let is_short = !what.is_empty() && what.chars().count() <= 200;
    let has_begin = |line: &str| line.starts_with("help: ") || line.starts_with("note: ");
    is_short && !message.lines().any(|line| line.ends_with('.') && !line.ends_with("..")) && lines.all(has_begin)
}

/// A message without what is the same for every function that is not known.
fn short(message: &str) -> String {
    message.replace(
        "\nnote: supported are the methods of `f64` listed in docs/language.md, and helper methods of this impl",
        "",
    )
}

/// A row: what is typed, and every message about it at its line and column.
type Row = (&'static str, &'static [&'static str]);

/// Holds rows against what is found; `wrap` makes arguments and an item of what is typed.
fn check(rows: &[Row], wrap: impl Fn(&str) -> (String, String)) {
    let mut wrong = String::new();
    for (text, expected) in rows {
        let (arguments, item) = wrap(text);
        let found = errors(&arguments, &item);
        if found != *expected {
            wrong += &format!("        ({text:?},\n         &{found:?}),\n");
        }
    }
    assert!(wrong.is_empty(), "found:\n{wrong}");
}

const KINETIC: &str = "fn kinetic(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] }";
const POTENTIAL: &str = "fn potential(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1] * q[1] }";

#[test]
fn arguments() {
    check(table::ARGUMENTS, |text| (text.to_owned(), format!("impl System {{ {KINETIC} {POTENTIAL} }}")));
}

#[test]
fn splits() {
    check(table::SPLITS, |text| {
        let (arguments, functions) = text.split_once(" on ").expect("an annotation and functions");
        (arguments.to_owned(), format!("impl System {{\n{functions} }}"))
    });
}

#[test]
fn items() {
    check(table::ITEMS, |text| (String::new(), text.to_owned()));
}

/// The body of `potential` begins on line 2.
#[test]
fn bodies() {
    check(table::BODIES, |text| {
        let item = format!(
            "impl System {{ {KINETIC} fn potential(&self, q: [f64; 2], t: f64) -> f64 {{\n{text}\n}} \
             fn helper(&self, x: f64) -> f64 {{ x * x }} fn endless(&self, x: f64) -> f64 {{ self.endless(x) }} }}"
        );
        (String::new(), item)
    });
}

/// Calls of helper methods are followed by recursion, on the stack of the compiler, which has 8 MiB.
#[test]
fn long_chains_of_helpers_are_refused_at_a_call() {
    fn found(length: usize, open: &str, close: &str) -> Vec<String> {
        let helpers: String = (0..length)
            .map(|k| format!("fn f{k}(&self, x: f64) -> f64 {{ {open}self.f{}(x * 0.99){close} + 0.1 * x }}\n", k + 1))
            .collect();
        let item = format!(
            "impl System {{ {KINETIC} fn potential(&self, q: [f64; 2]) -> f64 {{ self.f0(q[0]) }}\n\
             {helpers} fn f{length}(&self, x: f64) -> f64 {{ x.cos() }} }}"
        );
        let expanded = std::thread::Builder::new().stack_size(8 << 20).spawn(move || errors("", &item));
        expanded.expect("a thread").join().expect("no panic")
    }
    assert_eq!(found(150, "", ""), [""; 0]);
    for (length, open, close) in [(600, "", ""), (3000, "", ""), (100, "((((((((((", "))))))))))")] {
        let [message] = &found(length, open, close)[..] else { panic!("one message for a chain of {length}") };
        assert!(message.contains("nested more than 500 levels deep"), "{message}");
    }
}

#[test]
fn known_functions_are_listed() {
    let listed: Vec<&str> = known_functions().collect();
    for name in ["sin", "cos", "sqrt", "powi", "exp", "ln", "atan2", "mul_add"] {
        assert!(listed.contains(&name), "{name} in {listed:?}");
    }
    let item = format!("impl System {{ {KINETIC} fn potential(&self, q: [f64; 2]) -> f64 {{ q[0].unknown() }} }}");
    // What is listed is understood: none of it is refused by name.
    for name in listed {
        let item = item.replace("unknown()", &format!("{name}(1.0)"));
        let refused = errors("", &item).iter().any(|message| message.contains("no derivative of"));
        assert!(!refused, "{name} is listed but not known");
    }
}
