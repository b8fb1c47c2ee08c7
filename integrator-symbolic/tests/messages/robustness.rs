//! The macro returns for every input, says the same about the same, and names no other runtime than it is told.

use crate::{gather, tokens};
use integrator_symbolic::hamiltonian;
use proc_macro2::{TokenStream, TokenTree};
use proptest::prelude::*;

#[test]
fn equal_tokens_give_equal_text() {
    for (arguments, item) in SAMPLES {
        let expand = || hamiltonian(tokens(arguments), tokens(item)).to_string();
        assert_eq!(expand(), expand(), "{item}");
    }
}

#[test]
fn a_renamed_runtime_is_the_only_one_named() {
    for (arguments, item) in SAMPLES {
        let text = hamiltonian(tokens(&format!("crate = my::runtime, {arguments}")), tokens(item)).to_string();
        assert!(text.contains("my :: runtime :: __private") && !text.contains("integrator_core"), "{text}");
    }
}

/// Systems that between them use most of the language.
const SAMPLES: [(&str, &str); 4] = [
    (
        "compose = Yoshida4",
        "impl Pendulum { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / (2.0 * self.mass) } \
         fn potential(&self, q: [f64; 1]) -> f64 { -self.mass * self.gravity * q[0].cos() } }",
    ),
    (
        "compose = V(1/2) T(1) V(1/2)",
        "impl Bodies { fn kinetic(&self, p: &[[f64; 3]; 4]) -> f64 { let mut t = 0.0; for i in 0..4 { for d in 0..3 { \
         t += p[i][d] * p[i][d] / (2.0 * self.mass[i]); } } t } \
         fn potential(&self, q: &[[f64; 3]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { \
         let mut r2 = 0.0; for d in 0..3 { let dx = q[i][d] - q[j][d]; r2 += dx * dx; } \
         v -= self.mass[i] * self.mass[j] / r2.sqrt(); } } v } }",
    ),
    (
        "",
        "impl<const N: usize> Chain<N> { fn kinetic(&self, p: [f64; N]) -> f64 { let mut t = 0.0; for i in 0..N { \
         t += 0.5 * p[i] * p[i]; } t } fn potential(&self, q: [f64; N]) -> f64 { let mut v = self.spring(q[0]); \
         for i in 1..N { v += self.spring(q[i] - q[i - 1]); } v } \
         fn spring(&self, d: f64) -> f64 { let (s, c) = d.sin_cos(); d * d / 2.0 + self.alpha * s * c } }",
    ),
    (
        "",
        "impl Driven { fn kinetic(&self, p: [f64; 2], t: f64) -> f64 { (1.0 + p[0] * p[0]).sqrt() + p[1] * t.sin() } \
         fn potential(&self, [x, y]: [f64; 2], t: f64) -> f64 { const C: f64 = 2.0; \
         x.powi(2) / C - self.amplitude * x * (self.omega * t).cos() + y.exp().ln_1p() } }",
    ),
];

/// A change to a list of tokens, at a place given as a fraction of its length.
#[derive(Clone, Debug)]
enum Change {
    Delete(prop::sample::Index),
    Duplicate(prop::sample::Index),
    Exchange(prop::sample::Index, prop::sample::Index),
    Replace(prop::sample::Index, &'static str),
}

fn change() -> impl Strategy<Value = Change> {
    let at = any::<prop::sample::Index>;
    let others =
        vec!["+", "0", "1.5", "p", "q", "self", "for", "if", "=", ";", "(", "}", "'a", "-", "fn", "1e999", "_"];
    prop_oneof![
        at().prop_map(Change::Delete),
        at().prop_map(Change::Duplicate),
        (at(), at()).prop_map(|(one, other)| Change::Exchange(one, other)),
        (at(), prop::sample::select(others)).prop_map(|(at, other)| Change::Replace(at, other)),
    ]
}

/// The tokens of a text one by one, so that parentheses can be lost as well.
fn flat(tokens: TokenStream, into: &mut Vec<String>) {
    for tree in tokens {
        match tree {
            TokenTree::Group(group) => {
                let text = TokenTree::Group(proc_macro2::Group::new(group.delimiter(), TokenStream::new())).to_string();
                let (open, close) = text.split_at(1);
                into.push(open.to_owned());
                flat(group.stream(), into);
                into.push(close.trim().to_owned());
            }
            // Joint signs stay together.
            TokenTree::Punct(sign) if sign.spacing() == proc_macro2::Spacing::Joint => {
                into.push(format!("{sign}\u{0}"));
            }
            other => into.push(other.to_string()),
        }
    }
}

fn changed(text: &str, changes: &[Change]) -> String {
    let mut list = Vec::new();
    flat(tokens(text), &mut list);
    for change in changes {
        let length = list.len();
        if length == 0 {
            break;
        }
        match change {
            Change::Delete(at) => drop(list.remove(at.index(length))),
            Change::Duplicate(at) => list.insert(at.index(length), list[at.index(length)].clone()),
            Change::Exchange(one, other) => list.swap(one.index(length), other.index(length)),
            Change::Replace(at, other) => list[at.index(length)] = (*other).to_owned(),
        }
    }
    list.join(" ").replace("\u{0} ", "")
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(512) })]

    /// Where tokens are lost, doubled, exchanged or replaced, the macro returns, the user's item comes first, and what
    /// follows is items: a stepper, or messages.
    #[test]
    fn every_input_returns_the_item(
        sample in prop::sample::select(SAMPLES.to_vec()),
        changes in prop::collection::vec(change(), 0..4),
        on_arguments in prop::collection::vec(change(), 0..2),
    ) {
        let (arguments, item) = (changed(sample.0, &on_arguments), changed(sample.1, &changes));
        if let (Ok(arguments), Ok(item)) = (arguments.parse::<TokenStream>(), item.parse::<TokenStream>()) {
            let output = hamiltonian(arguments, item.clone());
            let text = output.to_string();
            prop_assert!(text.contains(&item.to_string()), "{text}");
            let mut found = Vec::new();
            gather(output.clone(), &mut found);
            prop_assert!(!found.is_empty() || syn::parse2::<syn::File>(output).is_ok(), "{text}");
        }
    }
}
