//! Nothing is computed in a loop that it does not depend on, in the code of the corpus and of random systems; and a line that is
//! moved into such a loop is found, by its place and by the counts.

use crate::{
    choice::seeds,
    counts::{Compared, Outcomes},
    expansion::Expansion,
    grammar,
    judge::System,
    placement::{Kind, Misplaced, misplaced},
    systems::corpus,
};
use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::{
    Block, Expr, Item, Stmt,
    visit_mut::{self, VisitMut},
};

/// What stays in place, by the kind and the function, with the reason.
const STAYS: [(Kind, &str, &str); 1] = [(
    Kind::Operation,
    "drift_body",
    "the runtime calls this for rows of bodies, and the function is inlined into the loop: the compiler moves the product of \
     step and parameter out of it",
)];

/// Random systems with an operation in a loop that it does not depend on, under a schedule that is not mended.
const NOT_MENDED: [&str; 6] = ["system 129", "system 227", "system 235", "system 237", "system 273", "system 288"];

/// `RANDOM_COUNTS_COUNT` asks for more systems of each kind.
#[test]
fn values_are_in_the_outermost_loop_that_they_depend_on() {
    let (mut found, mut drawn): (Vec<(String, Misplaced)>, Vec<String>) = (Vec::new(), Vec::new());
    let mut add = |name: String, output: &TokenStream| {
        found.extend(misplaced(output).into_iter().map(|misplaced| (name.clone(), misplaced)));
    };
    for system in corpus() {
        let name = system.item.self_ty.to_token_stream().to_string();
        add(name, &integrator_symbolic::hamiltonian(system.arguments, system.item.to_token_stream()));
    }
    type OfSeed = fn(u64) -> System;
    let kinds: [(&str, OfSeed); 3] =
        [("system", grammar::system), ("lattice", grammar::lattice), ("bodies", grammar::pairs)];
    for (kind, of_seed) in kinds {
        for seed in seeds(["RANDOM_COUNTS_SEED", "RANDOM_COUNTS_COUNT"], 20) {
            let item = of_seed(seed).item;
            drawn.push(format!("{kind} {seed}"));
            add(format!("{kind} {seed}"), &integrator_symbolic::hamiltonian(TokenStream::new(), item));
        }
    }
    let stays = |of: &Misplaced| STAYS.iter().position(|(kind, name, _)| (*kind, *name) == (of.kind, &of.function[..]));
    let (kept, moved): (Vec<_>, Vec<_>) = found.into_iter().partition(|(_, misplaced)| stays(misplaced).is_some());
    let (known, new): (Vec<_>, Vec<_>) = moved.into_iter().partition(|(name, _)| NOT_MENDED.contains(&&name[..]));
    assert!(new.is_empty(), "{new:#?}");
    let is_mended =
        |name: &&&str| drawn.iter().any(|drawn| drawn == **name) && !known.iter().any(|(known, _)| known == **name);
    let mended: Vec<_> = NOT_MENDED.iter().filter(is_mended).collect();
    assert!(mended.is_empty(), "mended, but in the table: {mended:?}");
    let is_needed = |row: usize| kept.iter().any(|(_, misplaced)| stays(misplaced) == Some(row));
    assert!((0..STAYS.len()).all(is_needed), "a row that nothing needs");
}

/// A loop in a loop, and a value in front of the inner one.
const NEST: &str = "impl System {
    fn kinetic(&self, p: [f64; 5]) -> f64 { p.iter().map(|p| p * p).sum::<f64>() }
    fn potential(&self, q: [f64; 5]) -> f64 {
        let mut v = 0.0;
        for i in 0..q.len() {
            let slope = q[i].sin();
            for j in 0..i {
                v += (slope * q[j]).exp();
            }
        }
        v
    }
}";

/// A loop that does nothing but what one mask decides.
const MASKED: &str = "impl System {
    fn kinetic(&self, p: [f64; 5]) -> f64 { p.iter().map(|p| p * p).sum::<f64>() }
    fn potential(&self, q: [f64; 5]) -> f64 {
        q.iter().zip(&self.k).map(|(q, k)| if self.flag { k * q.cos() } else { 0.0 }).sum::<f64>()
    }
}";

/// Moves the first line of `let` in front of a loop into this loop.
struct IntoTheLoop(bool);

impl VisitMut for IntoTheLoop {
    fn visit_block_mut(&mut self, block: &mut Block) {
        visit_mut::visit_block_mut(self, block);
        let is_operation = |statement: &Stmt| match statement {
            Stmt::Local(local) => local.init.as_ref().is_some_and(|init| {
                let text = init.expr.to_token_stream().to_string();
                text.contains(". sin ()") || text.contains(". sin_cos ()")
            }),
            _ => false,
        };
        let Some(line) = block.stmts.iter().position(is_operation) else { return };
        let target = block.stmts[line..].iter().position(|line| matches!(line, Stmt::Expr(Expr::ForLoop(_), _)));
        if let Some(target) = target.filter(|_| !self.0) {
            let moved = block.stmts[line].clone();
            if let Stmt::Expr(Expr::ForLoop(each), _) = &mut block.stmts[line + target] {
                each.body.stmts.insert(0, moved);
                self.0 = true;
            }
        }
    }
}

/// Puts the branch around a loop inside of it.
struct IntoTheIterations(bool);

impl VisitMut for IntoTheIterations {
    fn visit_expr_mut(&mut self, expression: &mut Expr) {
        visit_mut::visit_expr_mut(self, expression);
        if let Expr::If(choice) = expression
            && !self.0
            && let [Stmt::Expr(Expr::ForLoop(each), _)] = &choice.then_branch.stmts[..]
        {
            let (mut each, condition) = (each.clone(), &choice.cond);
            let body = &each.body;
            each.body = syn::parse_quote!({ if #condition #body });
            *expression = Expr::ForLoop(each);
            self.0 = true;
        }
    }
}

/// The output of the macro with a change in what is generated, and none in the user's own text.
fn generated_with(output: TokenStream, change: &mut dyn VisitMut) -> TokenStream {
    let mut file: syn::File = syn::parse2(output).expect("a file");
    for item in file.items.iter_mut().filter(|item| matches!(item, Item::Const(_))) {
        change.visit_item_mut(item);
    }
    file.to_token_stream()
}

#[test]
fn lines_in_the_wrong_loop_are_found() {
    let kinds = |text: &str, change: &mut dyn VisitMut| {
        let output = integrator_symbolic::hamiltonian(TokenStream::new(), text.parse().expect("tokens"));
        assert_eq!(misplaced(&output), []);
        let found = misplaced(&generated_with(output, change)).into_iter();
        found.map(|misplaced| misplaced.kind).collect::<Vec<_>>()
    };
    assert_eq!(kinds(NEST, &mut IntoTheLoop(false)), [Kind::Operation]);
    assert_eq!(kinds(MASKED, &mut IntoTheIterations(false)), [Kind::Condition]);
}

/// A table whose elements are the same.
#[test]
fn tables_of_one_number_are_found() {
    let output = |element: &str| {
        let text = format!(
            "const _: () = {{ impl System for S {{ fn parameters(&self) {{ runtime::table(4, &|k: usize| {element}); }} }} }};"
        );
        misplaced(&text.parse().expect("tokens")).into_iter().map(|misplaced| misplaced.kind).collect::<Vec<_>>()
    };
    assert_eq!(output("self.k[k] * 2.0"), []);
    assert_eq!(output("self.k[0] * 2.0"), [Kind::Table]);
}

/// Counts notice an operation that is carried out more often than the report states.
#[test]
fn counts_of_moved_lines_differ() {
    let is_found = (1..200).any(|seed| {
        let system = grammar::system(seed);
        let Ok(report) = integrator_symbolic::report(TokenStream::new(), system.item.clone()) else { return false };
        let output = integrator_symbolic::hamiltonian(TokenStream::new(), system.item.clone());
        let mut change = IntoTheLoop(false);
        let Ok(expansion) = Expansion::read(generated_with(output, &mut change)) else { return false };
        let mut outcomes = Outcomes::default();
        outcomes.compare_with(&Compared::of(format!("system {seed}"), &system), &report, &expansion);
        change.0 && !outcomes.apart.is_empty()
    });
    assert!(is_found, "no moved line is noticed");
}
