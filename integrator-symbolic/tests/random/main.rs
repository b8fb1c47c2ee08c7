//! Random systems: what the macro writes is held against the user's own functions, over the whole language of H.
//!
//! No compiler takes part. An interpreter of Rust evaluates `kinetic` and `potential` as they stand, with derivatives
//! carried forward beside every number, and the generated `parameters`, energies and flows; both carry bounds of their
//! rounding errors, within which they have to agree, for lists and coordinates of any length. So a second is enough for
//! dozens of systems. `RANDOM_SYSTEMS_SEED` and `RANDOM_SYSTEMS_COUNT` ask for others, and for more.

mod bounded;
mod calls;
mod choice;
mod count;
mod counts;
mod device;
mod drivers;
mod examples;
mod expansion;
mod grammar;
mod judge;
mod lines;
mod lists;
mod loops;
mod machine;
mod mutate;
mod number;
mod operate;
mod place;
mod placed;
mod placement;
mod sequence;
mod shrink;
mod splits;
#[path = "../systems/mod.rs"]
mod systems;
mod triplets;
mod value;

use choice::{Choices, seeds};
use expansion::Expansion;
use grammar::PARTS;
use judge::{Fault, Outside, System, Verdict};
use mutate::{MUTATIONS, mutated};
use std::{collections::BTreeMap, fmt::Write as _};

/// The variables of the first seed and of the number of systems.
const SEEDS: [&str; 2] = ["RANDOM_SYSTEMS_SEED", "RANDOM_SYSTEMS_COUNT"];

/// How many faults are shown: each takes a while to be made small.
const SHOWN: usize = 3;

/// What came of many systems.
#[derive(Default)]
struct Tally {
    judged: usize,
    refused: usize,
    /// Texts that are no Rust, or that the interpreter does not know.
    foreign: usize,
    faulty: usize,
    /// Whether a panic is a fault: what a change puts behind a guard may be evaluated.
    judges_panics: bool,
    messages: BTreeMap<String, usize>,
    all: Verdict,
    faults: String,
}

impl Tally {
    fn judge(&mut self, name: &str, system: &System) {
        match system.judge() {
            Err(Outside::Refused(message)) => {
                self.refused += 1;
                *self.messages.entry(message).or_default() += 1;
            }
            Err(Outside::Foreign(what)) => {
                self.foreign += 1;
                *self.messages.entry(what).or_default() += 1;
            }
            Ok(mut verdict) => {
                verdict.faults.retain(|(fault, _)| PARTS.guards || self.judges_panics || *fault != Fault::Panics);
                self.judged += 1;
                self.all.compared += verdict.compared;
                self.all.skipped += verdict.skipped;
                self.all.panics += verdict.panics;
                self.faulty += usize::from(!verdict.faults.is_empty());
                if let Some((fault, what)) = verdict.faults.first().filter(|_| self.faulty <= SHOWN) {
                    let smallest = shrink::shrunk(system, *fault);
                    let found = smallest.judge().ok().and_then(|verdict| verdict.faults.into_iter().next());
                    let (_, again) = found.unwrap_or((*fault, what.clone()));
                    let text = pretty(&smallest);
                    let _ = writeln!(self.faults, "{name}: {what}\nas in\n{text}where {again}\n");
                }
            }
        }
    }

    /// Nothing is wrong, and the text of a system tells what was.
    fn assert_without_faults(&self) {
        let Self { judged, refused, foreign, faulty, messages, all, faults, .. } = self;
        println!("{judged} judged, {refused} refused, {foreign} foreign, {faulty} at fault; {messages:#?}");
        println!("{} numbers compared, {} skipped, {} panics of functions", all.compared, all.skipped, all.panics);
        assert!(faults.is_empty(), "{faults}");
        // A number whose bound is not finite says nothing; most say something.
        assert!(all.skipped * 10 < all.compared, "{} of {} numbers were skipped", all.skipped, all.compared);
    }
}

fn pretty(system: &System) -> String {
    match syn::parse2(system.item.clone()) {
        Ok(item) => prettyplease::unparse(&syn::File {
            shebang: None,
            frontmatter: None,
            attrs: Vec::new(),
            items: vec![syn::Item::Impl(item)],
        }),
        Err(_) => system.item.to_string(),
    }
}

#[test]
fn steppers_match_the_functions() {
    let mut tally = Tally { judges_panics: true, ..Tally::default() };
    for seed in seeds(SEEDS, 16) {
        tally.judge(&format!("system {seed}"), &grammar::system(seed));
    }
    tally.assert_without_faults();
    assert_eq!(tally.foreign, 0, "the grammar writes what the interpreter knows: {:?}", tally.messages);
    let all = tally.judged + tally.refused;
    assert!(tally.judged * 10 >= all * 9, "{} of {all} were refused: {:#?}", tally.refused, tally.messages);
}

#[test]
fn lattices_match_the_functions() {
    let mut tally = Tally { judges_panics: true, ..Tally::default() };
    for seed in seeds(SEEDS, 16) {
        tally.judge(&format!("lattice {seed}"), &grammar::lattice(seed));
    }
    tally.assert_without_faults();
    assert_eq!([tally.refused, tally.foreign], [0; 2], "all of them are understood: {:#?}", tally.messages);
}

#[test]
fn bodies_in_pairs_match_the_functions() {
    let mut tally = Tally { judges_panics: true, ..Tally::default() };
    for seed in seeds(SEEDS, 16) {
        tally.judge(&format!("bodies {seed}"), &grammar::pairs(seed));
    }
    tally.assert_without_faults();
    assert_eq!([tally.refused, tally.foreign], [0; 2], "all of them are understood: {:#?}", tally.messages);
}

/// Most of them are sums over triplets for the macro too; the others are evaluated as written.
#[test]
fn bodies_in_triplets_match_the_functions() {
    let mut tally = Tally { judges_panics: true, ..Tally::default() };
    let mut recognised = 0;
    for seed in seeds(SEEDS, 16) {
        let system = grammar::triplets(seed);
        let expanded = integrator_symbolic::hamiltonian(Default::default(), system.item.clone()).to_string();
        recognised += u32::from(expanded.contains("TRIPLETS"));
        tally.judge(&format!("triplets {seed}"), &system);
    }
    tally.assert_without_faults();
    assert_eq!([tally.refused, tally.foreign], [0; 2], "all of them are understood: {:#?}", tally.messages);
    assert!(recognised > 8 || seeds(SEEDS, 16).count() < 16, "{recognised}");
}

/// Energies and forces are finite where those of the functions are, whatever the units of coordinates.
#[test]
fn steppers_match_the_functions_in_units_of_any_size() {
    type OfSeed = fn(u64) -> System;
    let kinds: [(&str, OfSeed); 3] = [
        ("system", grammar::system_in_units),
        ("lattice", grammar::lattice_in_units),
        ("bodies", grammar::pairs_in_units),
    ];
    let mut tally = Tally { judges_panics: true, ..Tally::default() };
    for (kind, of_seed) in kinds {
        for seed in seeds(SEEDS, 16) {
            tally.judge(&format!("{kind} {seed} in units"), &of_seed(seed));
        }
    }
    tally.assert_without_faults();
    assert_eq!(tally.foreign, 0, "the grammar writes what the interpreter knows: {:?}", tally.messages);
    // Coordinates in units are an array of values, which no table of indices may index: a third of the systems have one.
    assert!(tally.judged > tally.refused * 4, "{} were refused: {:#?}", tally.refused, tally.messages);
}

#[test]
fn steppers_of_changed_systems_match_the_functions() {
    let mut tally = Tally::default();
    for seed in seeds(SEEDS, 16) {
        let (mut system, mut choices) = (grammar::system(seed), Choices::new(seed));
        for _ in 0..1 + choices.below(3) {
            let mutation = &MUTATIONS[choices.below(MUTATIONS.len())];
            system.item = mutated(&system.item, mutation, &mut choices).unwrap_or(system.item);
        }
        tally.judge(&format!("changed system {seed}"), &system);
    }
    tally.assert_without_faults();
    assert!(tally.judged > tally.refused + tally.foreign, "half of them are systems: {:#?}", tally.messages);
}

/// Each kind of change, made in the generated text, is noticed in some system.
#[test]
fn faults_in_generated_code_are_found() {
    for mutation in MUTATIONS.iter().filter(|mutation| mutation.name != "one more adaptor") {
        let found = (1..200).any(|seed| {
            let system = grammar::system(seed);
            let output = integrator_symbolic::hamiltonian(Default::default(), system.item.clone());
            let Some(output) = changed(&output, mutation, seed) else { return false };
            let Ok(expansion) = Expansion::read(output) else { return false };
            let sound = system.judge().is_ok_and(|verdict| verdict.faults.is_empty());
            sound && system.judge_expansion(&expansion).is_ok_and(|verdict| !verdict.faults.is_empty())
        });
        assert!(found, "{} stays unnoticed", mutation.name);
    }
}

/// The output of the macro with one change in the generated implementations.
fn changed(
    output: &proc_macro2::TokenStream,
    mutation: &mutate::Mutation,
    seed: u64,
) -> Option<proc_macro2::TokenStream> {
    let mut file: syn::File = syn::parse2(output.clone()).ok()?;
    let scope = file.items.iter_mut().find_map(|item| match item {
        syn::Item::Const(scope) => Some(scope),
        _ => None,
    })?;
    let syn::Expr::Block(block) = &mut *scope.expr else { return None };
    let stepper = block.block.stmts.iter_mut().find_map(|statement| match statement {
        syn::Stmt::Item(syn::Item::Impl(item)) => {
            let (of, _) = item.trait_.as_ref()?;
            of.segments.last().is_some_and(|name| name.ident == "System").then_some(item)
        }
        _ => None,
    })?;
    let text = quote::quote!(#stepper);
    *stepper = syn::parse2(mutated(&text, mutation, &mut Choices::new(seed))?).ok()?;
    Some(quote::quote!(#file))
}
