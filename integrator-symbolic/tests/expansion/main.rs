//! What the macros write, as reviewed text: in the folders beside this file, `name.expanded.rs` is what they make of
//! `name.rs`, without the user's own item. Of what recurrences of Taylor series bring along, only that is kept, and of flows
//! as text for devices, only this text, as `name.expanded.cu`.

use integrator_symbolic::{composition, hamiltonian};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use std::{
    fs,
    path::{Path, PathBuf},
};
use syn::Item;

#[path = "../../../tests/support/kept.rs"]
mod kept;

use kept::assert_kept;

#[test]
fn expansions_are_those_that_are_kept() {
    let entries = |folder: &Path| -> Vec<PathBuf> {
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect()
    };
    let folders = entries(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/expansion"));
    let files = folders.iter().filter(|folder| folder.is_dir()).flat_map(|folder| entries(folder));
    let (outputs, inputs): (Vec<_>, Vec<_>) = files.partition(|file| file.to_string_lossy().contains(".expanded."));
    assert!(inputs.len() >= 15, "the walk must reach the folders");
    for input in &inputs {
        let file = syn::parse_file(&fs::read_to_string(input).expect("text")).expect("items");
        let [item] = &file.items[..] else { panic!("{}: one item", input.display()) };
        let expanded = expanded(item);
        match device_text(&expanded) {
            Some(text) => assert_kept(&input.with_extension("expanded.cu"), &text),
            None => assert_kept(&input.with_extension("expanded.rs"), &expanded),
        }
    }
    for output in &outputs {
        assert!(output.with_extension("").with_extension("rs").exists(), "{} has no input", output.display());
    }
}

/// What a macro makes of the item that calls it.
fn expanded(item: &Item) -> String {
    let items = match item {
        Item::Macro(call) => syn::parse2(composition(call.mac.tokens.clone())).expect("items"),
        Item::Impl(item) => {
            let mut item = item.clone();
            let attribute = item.attrs.pop().expect("the attribute").meta;
            let arguments = attribute.require_list().map_or_else(|_| TokenStream::new(), |list| list.tokens.clone());
            let mut items = generated(arguments.clone(), item.to_token_stream());
            if let Some(others) = arguments.to_string().strip_suffix("taylor") {
                let others = others.trim_end_matches([',', ' ']).parse().expect("tokens");
                let mut unasked = generated(others, item.to_token_stream());
                let heads: Vec<_> = statements(&mut unasked).iter().map(head).collect();
                statements(&mut items).retain(|statement| !heads.contains(&head(statement)));
            }
            items
        }
        _ => panic!("an annotated impl, or a call of `composition!`"),
    };
    prettyplease::unparse(&items)
}

/// The flows as text for devices, where there are any.
fn device_text(expanded: &str) -> Option<String> {
    let (_, behind) = expanded.split_once("const TEXT: &'static str = ")?;
    let (literal, _) =
        behind.split_once(";\n    const CONSTANTS").or_else(|| behind.split_once(";\n        const CONSTANTS"))?;
    Some(syn::parse_str::<syn::LitStr>(literal).expect("a literal").value())
}

/// The statements of the block around all that is generated.
fn statements(file: &mut syn::File) -> &mut Vec<syn::Stmt> {
    match &mut file.items[..] {
        [Item::Const(syn::ItemConst { expr, .. })] => match &mut **expr {
            syn::Expr::Block(block) => &mut block.block.stmts,
            _ => panic!("a block"),
        },
        _ => panic!("a constant"),
    }
}

/// A statement up to its body.
fn head(statement: &syn::Stmt) -> String {
    let body = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    statement.to_token_stream().into_iter().take_while(|token| !body(token)).collect::<TokenStream>().to_string()
}

/// What is generated beside the user's item.
fn generated(arguments: TokenStream, item: TokenStream) -> syn::File {
    let mut file: syn::File = syn::parse2(hamiltonian(arguments, item)).expect("items");
    assert!(matches!(file.items.remove(0), Item::Impl(_)), "the user's item comes first");
    file
}

/// The stepper alone.
fn stepper(arguments: &str, item: &str) -> String {
    prettyplease::unparse(&generated(arguments.parse().expect("tokens"), item.parse().expect("tokens")))
}

#[test]
fn functions_of_the_flows_are_fast_on_request() {
    let item = "impl Rotor {
        fn kinetic(&self, p: [f64; 1]) -> f64 { 0.5 * p[0] * p[0] }
        fn potential(&self, q: [f64; 1]) -> f64 { self.strength.sin() * q[0].cos() + q[0].exp() * q[0].sinh() }
    }";
    let fast = stepper("functions = fast", item);
    for (text, expected) in [
        (".fast_sin()", true),
        (".fast_cos()", true),
        ("self.strength.sin()", true),
        (".fast_exp()", true),
        (".fast_sinh", false),
    ] {
        assert_eq!(fast.contains(text), expected, "{text} in\n{fast}");
    }
    assert_eq!(stepper("functions = precise", item), stepper("", item));
}

/// The generated code is held against the user's functions, which are called as their signatures say.
#[test]
fn the_functions_are_called_as_they_are() {
    let rows = [
        ("&self, q: [f64; 1]", "self, *q"),
        ("&self, q: ([[f64; 3]; 4]), t: f64", "self, *q, time"),
        ("&self, q: &[f64; 1], _: &f64", "self, q, &time"),
        ("&self, &[x]: &[f64; 1]", "self, q"),
        ("&self, q: &[f64]", "self, q"),
        ("&self, q: &mut [[f64; 2]]", "self, &mut q.clone()"),
        ("&self, q: &Vec<[f64; 3]>", "self, q"),
        ("&self, q: &&[f64]", "self, &&q[..]"),
        ("&self, q: &&[f64; 2]", "self, &q"),
        ("q: [f64; 1]", "*q"),
    ];
    for (signature, arguments) in rows {
        let kind: syn::ImplItemFn = syn::parse_str(&format!("fn f({signature}) {{}}")).expect("a function");
        let of_coordinates = |argument: &syn::FnArg| match argument {
            syn::FnArg::Typed(argument) => Some(quote!(#argument).to_string()),
            syn::FnArg::Receiver(_) => None,
        };
        let own = kind.sig.inputs.iter().find_map(of_coordinates).expect("coordinates");
        let kind = own.split_once(':').expect("a type").1;
        let text = stepper(
            "",
            &format!(
                "impl System {{
                    fn kinetic(&self, p: {kind}) -> f64 {{ 0.0 }}
                    fn potential({signature}) -> f64 {{ 0.0 }}
                }}"
            ),
        );
        assert!(text.contains(&format!("potential: Self::potential({arguments}),")), "{signature}: {text}");
    }
    for (signature, arguments) in [
        ("&self, q: [f64; 1], p: [f64; 1]", "self, *q, *p"),
        ("&self, [x]: [f64; 1], p: &[f64; 1], t: f64", "self, *q, p, time"),
    ] {
        let text = stepper("", &format!("impl System {{ fn hamiltonian({signature}) -> f64 {{ 0.0 }} }}"));
        assert!(text.contains(&format!("Whole(Self::hamiltonian({arguments}))")), "{signature}: {text}");
    }
}

/// The rows are H in one function, and the two functions that it is the sum of.
#[test]
fn one_function_is_sorted_into_two() {
    let rows = [
        (
            "&self, [x, y]: [f64; 2], [px, py]: [f64; 2]",
            "0.5 * (px * px + py * py) + 0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0",
            "0.5 * (px * px + py * py)",
            "0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0",
        ),
        // Terms of sums in loops, with factors around them.
        (
            "&self, q: &[f64], p: &[f64]",
            "let mut h = 0.0; for i in 0..q.len() { h += p[i] * p[i] / self.m[i] - q[i].cos(); } 0.5 * h",
            "let mut h = 0.0; for i in 0..p.len() { h += p[i] * p[i] / self.m[i]; } 0.5 * h",
            "let mut h = 0.0; for i in 0..q.len() { h -= q[i].cos(); } 0.5 * h",
        ),
        // A condition belongs to what reads its coordinates.
        (
            "&self, q: [f64; 1], p: [f64; 1], t: f64",
            "let v = if q[0] > 0.0 { q[0].powi(4) + p[0] * p[0] } else { p[0] * p[0] }; v + t * p[0]",
            "p[0] * p[0] + t * p[0]",
            "if q[0] > 0.0 { q[0].powi(4) } else { 0.0 }",
        ),
        // What reads neither belongs to the potential energy.
        ("&self, q: [f64; 1], p: [f64; 1]", "p[0] * p[0] + self.rest", "p[0] * p[0]", "self.rest"),
        // By helper methods, one of which has the name of a part.
        (
            "&self, q: [f64; 1], p: [f64; 1]",
            "self.kinetic(p) + (1.0 - q[0].cos())",
            "p[0] * p[0] / (2.0 * self.m)",
            "1.0 - q[0].cos()",
        ),
    ];
    for (arguments, whole, kinetic, potential) in rows {
        let parts = arguments.split(", ").collect::<Vec<_>>().join(", ");
        let inputs: syn::ImplItemFn = syn::parse_str(&format!("fn f({parts}) {{}}")).expect("a function");
        let inputs: Vec<String> = inputs.sig.inputs.iter().map(|input| quote!(#input).to_string()).collect();
        let time = inputs.get(3).map_or(String::new(), |time| format!(", {time}"));
        let helper = "fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / (2.0 * self.m) }";
        let helper = if whole.contains("self.kinetic") { helper } else { "" };
        let in_one = format!("impl System {{ fn hamiltonian({arguments}) -> f64 {{ {whole} }} {helper} }}");
        let in_two = format!(
            "impl System {{
                fn kinetic(&self, {}{time}) -> f64 {{ {kinetic} }}
                fn potential(&self, {}{time}) -> f64 {{ {potential} }}
            }}",
            inputs[2], inputs[1]
        );
        let written = |text: &str| {
            let text = stepper("", text);
            let (_, flows) = text.split_once("fn drift<").expect("a drift");
            flows.split_once("fn stated").expect("the user's functions").0.to_owned()
        };
        assert_eq!(written(&in_one), written(&in_two), "{whole}");
    }
}

/// A chain of so many nonlinear springs, with a helper method.
fn chain(length: u32) -> String {
    let text = "impl Chain {
            fn kinetic(&self, p: &[f64; LENGTH]) -> f64 {
                let mut t = 0.0;
                for i in 0..LENGTH { t += 0.5 * p[i] * p[i]; }
                t
            }
            fn potential(&self, q: &[f64; LENGTH]) -> f64 {
                let mut v = self.spring(q[0]) + self.spring(-q[LAST]);
                for i in 0..LAST { v += self.spring(q[i + 1] - q[i]); }
                v
            }
            fn spring(&self, d: f64) -> f64 { 0.5 * d * d + self.alpha / 3.0 * d.powi(3) + self.beta / 4.0 * d.powi(4) }
        }";
    text.replace("LENGTH", &length.to_string()).replace("LAST", &(length - 1).to_string())
}

/// A contribution that no site has is zero.
#[test]
fn bonds_may_lead_to_the_second_next_site_alone() {
    let text = stepper(
        "",
        "impl Second {
            fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| 0.5 * p * p).sum() }
            fn potential(&self, q: &[f64]) -> f64 { (0..q.len() - 2).map(|i| (q[i + 2] - q[i]).powi(4)).sum() }
        }",
    );
    assert!(text.contains("[contribution_0, Wide::of(0.0), contribution_2]"), "{text}");
}

/// Loops stay loops: the text for a long chain is that for a short one, but for the numbers and their fingerprint, and
/// that small systems keep their buffers on the stack.
#[test]
fn code_does_not_grow_with_the_system() {
    let text = |length: u32| {
        let tokens = hamiltonian(TokenStream::new(), chain(length).parse().expect("tokens"));
        let text = tokens.to_string();
        let (before, rest) = text.split_once("FINGERPRINT : u64 = ").expect("a fingerprint");
        let (_, after) = rest.split_once(' ').expect("a number");
        format!("{before}{after}").replace(&length.to_string(), "LENGTH").replace(&(length - 1).to_string(), "LAST")
    };
    assert_eq!(text(100_000), text(1_000_000));
    assert!(text(100).len().abs_diff(text(1_000_000).len()) < 100);
}

/// What is prepared for a loop that a potential consists of, with a coordinate for each iteration: the text that
/// evaluates an element of the table, or the number, behind the condition that the function has around it.
const PREPARED: &[(&str, &str)] = &[
    ("if i > 0 { v += self.long[i - 1] * q[i]; }", "if (0) < (i) { self.long[(i - 1)] } else { 0.0 }"),
    ("if i == 0 { continue; } v += self.long[i - 1] * q[i];", "if !((i) == (0)) { self.long[(i - 1)] } else { 0.0 }"),
    (
        "if i < self.short.len() { v += self.short[i] * q[i]; }",
        "if (i < self.short.len()) { self.short[i] } else { 0.0 }",
    ),
    (
        "for j in 0..q.len() { if j > i { v += self.long[j - i] * q[j]; } }",
        "if (i) < (j) { self.long[(j - i)] } else { 0.0 }",
    ),
    (
        "if self.list.is_empty() { v += q[i]; } else { v += self.list[0] * q[i]; }",
        "if !((self.list.is_empty())) { self.list[0] } else { 0.0 }",
    ),
    (
        "if self.k.is_some() { v += self.k.unwrap() * q[i]; }",
        "if (self.k.is_some()) { ::integrator_core::__private::by_value(self.k.unwrap()) } else { 0.0 }",
    ),
    (
        "if self.k.is_some() && self.k.unwrap() > q[i] { v += q[i]; }",
        "if (self.k.is_some()) { self.k.unwrap() } else { 0.0 }",
    ),
    (
        "v += if self.list.is_empty() { 0.0 } else { self.list[0] } * q[i];",
        "if !((self.list.is_empty())) { (self.list[0]) } else { 0.0 }",
    ),
    // Names of the user's are not those of the generated code.
    (
        "let (m, length) = (q.len(), self.n); v += self.list.iter().map(|x| x + (length - m) as f64).sum::<f64>() * q[i];",
        "let (length, m) = (self.n, length);",
    ),
    // A list that is read by the index as it is has an element for every iteration, whichever iterations add.
    (
        "for j in 0..q.len() { if i != j { v += self.mass[i] * q[j]; } }",
        "mass: runtime::table(length, &|i: usize| self.mass[i])",
    ),
    ("if self.on { v += self.k * q[i]; }", "k: self.k"),
];

#[test]
fn prepared_constants_are_evaluated_where_the_function_reads_them() {
    let plain = |text: &str| text.split_whitespace().collect::<String>().replace(",)", ")");
    for (body, expected) in PREPARED {
        let item = format!(
            "impl System {{
                fn kinetic(&self, p: &[f64]) -> f64 {{ let mut t = 0.0; for i in 0..p.len() {{ t += p[i] * p[i] / 2.0; }} t }}
                fn potential(&self, q: &[f64]) -> f64 {{ let mut v = 0.0; for i in 0..q.len() {{ {body} }} v }}
            }}"
        );
        let text = plain(&stepper("", &item));
        assert!(text.contains(&plain(expected)), "{body}: {expected}\n{}", stepper("", &item));
    }
}
