//! `composition!` on anything at all: it returns, and what it returns are items.

use integrator_symbolic::composition;
use proc_macro2::TokenStream;
use proptest::prelude::*;

/// Tokens of declarations in any order and nesting.
fn token_soup() -> impl Strategy<Value = String> {
    let atom = prop::sample::select(vec![
        "struct",
        "pub",
        "A",
        "B",
        "T",
        "V",
        ":",
        "=",
        ";",
        ",",
        "order",
        "symmetric",
        "4",
        "1/2",
        "-",
        "1e400",
        "0",
        "0.1",
        "_",
        "Verlet",
        "triple_jump",
        "suzuki",
        "compose",
        "adjoint",
        "sqrt",
        "cbrt",
        "root",
        "crate",
        "'a",
        "\"text\"",
        "#[doc = 1]",
        "/// docs\n",
        "1u8",
        "fn",
        "self",
        "r#type",
        "::",
        "|x|",
    ])
    .prop_map(str::to_owned);
    let group = atom.prop_recursive(4, 64, 8, |inner| {
        (prop::collection::vec(inner, 0..8), prop::sample::select(vec![("(", ")"), ("[", "]"), ("{", "}"), (" ", " ")]))
            .prop_map(|(parts, (open, close))| format!("{open}{}{close}", parts.join(" ")))
    });
    prop::collection::vec(group, 0..24).prop_map(|parts| parts.join(" "))
}

/// Declarations that get past the parser more often than not.
fn sequence_soup() -> impl Strategy<Value = String> {
    let number = prop::sample::select(vec![
        "1",
        "1/2",
        "-1/3",
        "0.25",
        "_",
        "sqrt(2)",
        "1/(2 - 2)",
        "1e200",
        "-1e100",
        "1e100",
        "0",
        "",
    ]);
    let stage =
        (prop::sample::select(vec!["T", "V", "W"]), number.clone()).prop_map(|(name, n)| format!("{name}({n})"));
    let leaf = prop_oneof![stage, Just("Verlet".to_owned()), Just("B".to_owned())];
    let sequence = leaf.prop_recursive(3, 24, 4, move |inner| {
        let name =
            prop::sample::select(vec!["triple_jump", "suzuki", "symmetric", "compose", "adjoint", "processed", ""]);
        let separator = prop::sample::select(vec![" ", ", ", "; "]);
        (name, number.clone(), separator, prop::collection::vec(inner, 0..4)).prop_map(|(name, n, separator, parts)| {
            match separator {
                "; " => format!("{name}({n}; {})", parts.join(" ")),
                _ => format!("{name}({})", parts.join(separator)),
            }
        })
    });
    prop::collection::vec(sequence, 1..4).prop_map(|parts| format!("struct A: order 2 = {};", parts.join(" ")))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(256) })]

    #[test]
    fn every_input_returns_items(text in prop_oneof![token_soup(), sequence_soup()]) {
        if let Ok(tokens) = text.parse::<TokenStream>() {
            let output = composition(tokens);
            prop_assert!(syn::parse2::<syn::File>(output.clone()).is_ok(), "{output}");
        }
    }
}

/// Nothing recurses over what is deeper than any composition: the compiler's stack is the user's.
#[test]
fn depth_is_refused_before_anything_recurses() {
    let nested = |depth: usize| format!("struct A = {}Verlet{};", "adjoint(".repeat(depth), ")".repeat(depth));
    let messages = |depth| composition(nested(depth).parse().expect("tokens")).to_string();
    assert!(!messages(100).contains("compile_error"));
    for depth in [300, 100_000] {
        assert!(messages(depth).contains("nested more than 200 levels deep"), "{depth}");
    }
}
