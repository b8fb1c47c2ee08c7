//! What holds for every Hamiltonian of the corpus, whose numbers are tested elsewhere: its derivative is cheap, and
//! together they use all of the language.

mod systems;

use integrator_symbolic::{Report, hamiltonian, known_functions, report};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::ToTokens;
use syn::ExprBinary;
use systems::{System, corpus};

impl System {
    fn name(&self) -> String {
        self.item.self_ty.to_token_stream().to_string()
    }

    fn report(&self) -> Report {
        report(self.arguments.clone(), self.item.to_token_stream())
            .unwrap_or_else(|error| panic!("{}: {error}", self.name()))
    }
}

#[test]
fn the_corpus_is_found() {
    assert!(corpus().len() >= 40, "{}", corpus().len());
}

/// The bound for reverse sweeps (Griewank): energy and derivatives together cost at most four times the energy.
#[test]
fn derivatives_are_cheap() {
    for system in corpus() {
        let Report { operations_of_energies: energies, operations_together: together, .. } = system.report();
        assert!(energies > 0 && together <= 4 * energies, "{}: {together} for {energies}", system.name());
    }
}

#[test]
fn the_same_system_gives_the_same_code() {
    for system in corpus() {
        let expansion = || hamiltonian(system.arguments.clone(), system.item.to_token_stream()).to_string();
        assert_eq!(expansion(), expansion(), "{}", system.name());
    }
}

/// A macro of `macro_rules!` passes on literals and formulas as groups without delimiters.
#[test]
fn fragments_of_macros_are_read_as_their_contents() {
    let mut changed = 0;
    for System { arguments, item } in corpus() {
        let item = item.to_token_stream();
        let passed_on = passed_on(item.clone());
        let behind = |item: &TokenStream| {
            let text = |tokens: &TokenStream| tokens.to_string().replace(char::is_whitespace, "");
            let expanded = text(&hamiltonian(arguments.clone(), item.clone()));
            expanded.split_once("const_:()=").map(|(_, behind)| behind.to_owned())
        };
        assert_eq!(behind(&passed_on), behind(&item), "{item}");
        changed += usize::from(count(&passed_on) > count(&item));
    }
    assert!(changed > 30, "{changed}");
}

/// The tokens with each literal, each formula in parentheses and each type of a slice as a fragment of its own.
fn passed_on(tokens: TokenStream) -> TokenStream {
    let trees: Vec<_> = tokens.into_iter().collect();
    let fragment = |trees: &[TokenTree]| TokenTree::Group(Group::new(Delimiter::None, trees.iter().cloned().collect()));
    let is_mark = |tree: Option<&TokenTree>, marks: &str| matches!(tree, Some(TokenTree::Punct(mark)) if marks.contains(mark.as_char()));
    let mut passed = Vec::new();
    let mut at = 0;
    while let Some(tree) = trees.get(at) {
        let before = at.checked_sub(1).map(|before| &trees[before]);
        let slice = match (is_mark(before, ":"), is_mark(Some(tree), "&"), trees.get(at + 1)) {
            (true, true, Some(TokenTree::Group(group))) => group.delimiter() == Delimiter::Bracket,
            _ => false,
        };
        at += if slice { 2 } else { 1 };
        passed.push(match tree {
            _ if slice => fragment(&trees[at - 2..at]),
            TokenTree::Literal(_) if !is_mark(before, ".#") => fragment(std::slice::from_ref(tree)),
            TokenTree::Group(group) if !is_mark(before, "#!") => {
                let inner = passed_on(group.stream());
                let is_formula = is_mark(before, "+-*/=") && syn::parse2::<ExprBinary>(group.stream()).is_ok();
                let is_passed_on = is_formula && group.delimiter() == Delimiter::Parenthesis;
                let delimiter = if is_passed_on { Delimiter::None } else { group.delimiter() };
                TokenTree::Group(Group::new(delimiter, inner))
            }
            other => other.clone(),
        });
    }
    passed.into_iter().collect()
}

/// How many groups without delimiters there are.
fn count(tokens: &TokenStream) -> usize {
    let groups = tokens.clone().into_iter().filter_map(|tree| match tree {
        TokenTree::Group(group) => Some(group),
        _ => None,
    });
    groups.map(|group| usize::from(group.delimiter() == Delimiter::None) + count(&group.stream())).sum()
}

/// A system of its own for each function: with none, one or two arguments beside the receiver, whichever is right.
#[test]
fn every_function_has_code() {
    let functions: Vec<&str> = known_functions().collect();
    assert!(functions.len() > 30, "{functions:?}");
    for function in functions {
        let is_right = |arguments: &&str| {
            let value = format!("q[0].{function}({arguments})");
            let value = if function == "sin_cos" { format!("{value}.0") } else { value };
            let item = format!(
                "impl System {{ fn kinetic(&self, p: [f64; 2]) -> f64 {{ p[0] * p[0] }} fn potential(&self, q: [f64; 2]) \
                 -> f64 {{ {value} }} }}"
            );
            report(TokenStream::new(), item.parse().expect("tokens")).is_ok()
        };
        assert!(["", "2", "q[1]", "q[1], 2.0"].iter().any(is_right), "`{function}`");
    }
}

/// What the language has beside functions, as tokens are printed.
const CONSTRUCTS: &[&str] = &[
    // coordinates
    "q : [f64 ;",
    "q : & [f64 ;",
    "q : & [[f64 ;",
    "q : & [f64]",
    "q : & [[f64 ; 3]]",
    "[x , y] : [f64 ; 2]",
    "[[ax , ay] , [bx , by] , [cx , cy]] : [[f64 ; 2] ; 3]",
    "& [f64 ; WEIGHTS]",
    "& [[f64 ; 3] ; N]",
    "& [f64 ; Self :: SITES]",
    "_ : [f64 ; 2]",
    ", t : f64",
    // loops
    "for i in 0 .. 4",
    "for i in 0 ..= 4",
    "for i in (1 .. q . len ()) . rev ()",
    "for i in (0 .. 4) . step_by (2)",
    "for j in 0 .. i",
    "for j in i + 1 .. 5",
    "for x in q . iter () . copied ()",
    "for & p in p",
    "for [x , y] in p",
    "for & (a , b) in & self . bonds",
    "for x in & self . data",
    "for i in 0 .. q . len () - 1",
    "for i in 0 .. self . pinned",
    "product *= 1.0 +",
    "continue",
    // iterator chains
    ". map (",
    ". filter (",
    ". enumerate ()",
    ". zip (",
    ". rev () . step_by (",
    "[q [0] , q [3]] . iter ()",
    ". skip (",
    ". take (",
    ". windows (",
    ". chunks_exact (",
    ". fold (",
    ". sum :: < f64 > ()",
    ". iter () . map (| x | x . powi (2)) . sum",
    // indices
    "(i + 1) % N",
    "i * w + j",
    "self . neighbours [i] [k]",
    "as usize",
    // branches
    "else if",
    "&& self",
    "||",
    "! inside",
    "x <= self . half",
    "if self . tilted",
    "if i < j",
    "if i % 2 == 0",
    "if t < self . ramp",
    "if matches ! (",
    // variables
    "let (mut",
    "let [",
    "sum = sum +",
    "-=",
    "[0.0 ; 3]",
    "let x = & q [0]",
    "let strength : f64",
    "let ([a , b] , last)",
    "last . 0",
    "slope *= 1.5",
    "far . powf (0.1 * q [2])",
    "15e-1_f64",
    "use std",
    "const TETRAHEDRAL",
    // parameters
    "self . stacking . gain",
    "self . masses [i]",
    "Self :: UNIT",
    "std :: f64 :: consts :: PI",
    "as f64",
    "impl < const N : usize >",
    "< '_ ,",
    "where L : Law",
    "match self . species",
    "self . field ()",
    "self . law . stiffness ()",
    "f64 :: from (self . charge)",
    "self . tilted as u8 as f64",
    // helpers, and what means nothing to the derivative
    "self . spring (",
    "Self :: spring (self",
    "-> (f64 , f64)",
    "-> [f64 ; 2]",
    "f64 :: sqrt (",
    "# [derivative (slope)]",
    "# [inline]",
    "debug_assert",
];

#[test]
fn every_construct_is_used() {
    let text = corpus().iter().map(|system| system.item.to_token_stream().to_string()).collect::<String>();
    let missing: Vec<_> = CONSTRUCTS.iter().filter(|construct| !text.contains(**construct)).collect();
    assert!(missing.is_empty(), "no system of the corpus has {missing:?}");
}
