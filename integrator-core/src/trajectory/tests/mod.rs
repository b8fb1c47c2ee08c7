//! Final states of all compositions for a system of each kind, compared with stored hashes.
//!
//! In: the compositions that can integrate a system, scalar types and instruction sets. Out: a line of
//! `tests/end_states.txt` for each combination of a system, a scalar type and an instruction set. Always true: the loop
//! that reads the table of a composition and the loop that is compiled for the composition take the same steps to the
//! last bit.

mod systems;

use crate::{
    composition::{Composition, Scheme, catalogue::*, catalogue_list::for_each_composition, visitor::Visitor},
    hamiltonian::Hamiltonian,
    scalar::{instruction_set::InstructionSet, real::Real},
    state::{
        clock::Clock, compensated::Compensated, coords::Coords, digest::Digest, fixed::Fixed, phase::Phase,
        precision::Precision,
    },
    system::{Shaped, motion::Motion},
    trajectory::{
        by_table::{ByTable, Kicks, Plain, WithGradients},
        method::{Described, Method},
        run::Run,
        step_functions::InTiles,
    },
};
use alloc::{boxed::Box, format, string::String, sync::Arc, vec::Vec};
use core::{array::from_fn, hash::Hasher};
use std::{env, fs};
use systems::*;

/// The file of the hashes.
const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/end_states.txt");

/// The head of the file.
const HEAD: &str = "\
# Hashes of states after a few steps: the system, the scalar type, the instruction set, and 16 bits for each composition
# that can integrate the system, in the order of the catalogue. A grid supports symmetric compositions only, and is
# tested with one set, as `f32` is. Systems whose runs use avx512 have lines of that set. A set without lines is not compared.
# The unit test `trajectory::tests` compares them; `.ci/bless states` writes the lines of this machine's sets.
";

const STEP: f64 = 0.125;
const BEGIN: f64 = 0.5;
/// The numbers of steps after which the state is read.
const PORTIONS: [u64; 3] = [1, 3, 2];

/// 16 bits that depend on all bits of some states.
fn hash<C: Coords>(states: &[Phase<C>]) -> u16 {
    // Debug output has every digit, those of rounding errors too.
    let text = format!("{states:?}");
    assert!(!text.contains("NaN") && !text.contains("inf"), "finite states");
    let mut digest = Digest::EMPTY;
    digest.write(text.as_bytes());
    digest.finish() as u16
}

/// The hash of the states of a composition by its table, computed in `R`.
fn by_table<H: Hamiltonian, G: Kicks<H>, R: Real, K: Precision>(
    system: &H,
    composition: ByTable<G>,
    start: &Phase<Shaped<H, K>>,
) -> u16 {
    let constants = composition.constants(Arc::new(system.parameters(start.q.length())));
    let functions = <ByTable<G> as Method<H>>::step_functions::<R, K, InTiles>();
    let mut motion = <ByTable<G> as Method<H>>::Motion::<R, K>::load(&[&constants], &[start]);
    let mut clock = Clock { t0: BEGIN, h: STEP, steps: 0 };
    let states = PORTIONS.map(|steps| {
        functions.advance_one(&mut motion, clock, steps);
        clock.steps += steps;
        let mut state = start.clone();
        functions.shown(motion.clone(), clock).store(0, &mut state);
        state
    });
    hash(&states)
}

/// The hash of the states of a run.
fn by_run<H: Hamiltonian, X: Composition<H>, K: Precision>(
    system: &H,
    composition: X,
    start: &Phase<Shaped<H, K>>,
) -> u16 {
    let run: Result<Run<_>, _> = system.run_with::<K, X>(composition, start.clone(), STEP);
    let mut run = run.expect("a start").at_time(BEGIN);
    hash(&PORTIONS.map(|steps| {
        run.advance(steps).expect("finite states");
        run.state()
    }))
}

/// Collects the compositions that it visits.
struct Compositions<G>(Vec<ByTable<G>>);

impl<H: Hamiltonian, G: Kicks<H>> Visitor<H> for Compositions<G> {
    fn visit<X: Composition<H>>(&mut self, composition: X) {
        self.0.push(ByTable::of(composition));
    }
}

/// The hashes of all compositions for a system, a scalar type and an instruction set.
struct Row {
    key: String,
    hashes: Vec<(&'static str, u16)>,
}

/// The rows of a system and a scalar type for the instruction sets of this machine, or for the first one.
fn rows<H: Hamiltonian, G: Kicks<H>, K: Precision, const ALL_SETS: bool>(
    name: &str,
    system: &H,
    compositions: &[ByTable<G>],
    start: &Phase<Shaped<H, K>>,
    rows: &mut Vec<Row>,
) {
    // Coordinates that mix do not stay on a grid.
    if const { K::REVERSIBLE && <H::Motion<f64, K> as Motion<_, _>>::MIXES } {
        return;
    }
    for set in InstructionSet::available() {
        let hash = match set {
            InstructionSet::Baseline => by_table::<H, G, K::Plain, K>,
            InstructionSet::Fused if const { ALL_SETS } => by_table::<H, G, K::Fused, K>,
            InstructionSet::Avx512 if const { ALL_SETS && H::WIDE } => by_table::<H, G, K::Avx512, K>,
            InstructionSet::Fused | InstructionSet::Avx512 => continue,
        };
        let composed = compositions.iter().map(|composition| (composition.facts(), *composition));
        let composed = composed.filter(|(facts, _)| facts.symmetric || !K::REVERSIBLE);
        let hashes = composed.map(|(facts, composition)| (facts.name, hash(system, composition, start))).collect();
        rows.push(Row { key: format!("{name} {} {set}", K::NAME), hashes });
    }
}

fn single(number: f64) -> f32 {
    number as f32
}

fn compensated(value: f64) -> Compensated<f64> {
    Compensated { value, carried: 0.0 }
}

fn on_grid(number: f64) -> Fixed<f64> {
    Fixed::new(number, 1.0 / (1_u64 << 40) as f64)
}

/// A start in any scalar type.
struct Start<C> {
    q: C,
    p: C,
}

impl<C: Coords<Leaf = f64>> Start<C> {
    fn of<K: Precision>(&self, leaf: fn(f64) -> K) -> Phase<C::With<K>> {
        Phase { q: self.q.map(leaf), p: self.p.map(leaf) }
    }
}

const POINT: Start<[f64; 2]> = Start { q: [1.0, 0.5], p: [0.3, -0.2] };

/// All rows that this machine can compute.
fn all_rows() -> Vec<Row> {
    let mut found = Vec::new();
    macro_rules! each {
        ($($kicks:ident $system:ident: $start:expr,)*) => {$(
            let (name, start, mut compositions) = (stringify!($system), $start, Compositions::<$kicks>(Vec::new()));
            $system::visit_compositions(&mut compositions);
            rows::<_, $kicks, f64, true>(name, &$system, &compositions.0, &start.of(|number| number), &mut found);
            rows::<_, $kicks, Compensated<f64>, true>(name, &$system, &compositions.0, &start.of(compensated), &mut found);
            rows::<_, $kicks, f32, false>(name, &$system, &compositions.0, &start.of(single), &mut found);
            rows::<_, $kicks, Fixed<f64>, false>(name, &$system, &compositions.0, &start.of(on_grid), &mut found);
        )*};
    }
    each! {
        WithGradients HenonHeiles: POINT,
        Plain Crystal: POINT,
        Plain Driven: POINT,
        WithGradients Switched: POINT,
        Plain ThreeParts: POINT,
        Plain Paired: POINT,
        WithGradients Perturbed: POINT,
        WithGradients Oscillators: POINT,
        Plain Mixed: POINT,
        WithGradients Planets: Start {
            q: [[0.0, 0.0], [1.0, 0.0], [0.0, 2.5]],
            p: [[0.0, -1e-3], [0.0, 1e-3], [-1.9e-4, 0.0]],
        },
        WithGradients Chain: Start {
            q: (0..19).map(|i| f64::from(i * i % 7) / 8.0).collect::<Vec<_>>(),
            p: (0..19).map(|i| f64::from(i * i % 5) / 16.0).collect(),
        },
        WithGradients Bodies: Start {
            q: from_fn(|i| from_fn(|d| (i * i % 5) as f64 * [0.25, 0.5, 0.125][d] + d as f64)),
            p: from_fn(|i| from_fn(|d| (i * d) as f64 / 32.0 - 0.125)),
        },
    }
    found
}

#[test]
fn final_states_have_the_stored_hashes() {
    let kept = fs::read_to_string(FILE).unwrap_or_default();
    let stored_of = |key: &str| kept.lines().find_map(|line| line.strip_prefix(key));
    let is_stored = |set: &str| kept.lines().any(|line| !line.starts_with('#') && line.contains(set));
    let mut wrong = Vec::new();
    let sets = InstructionSet::available().iter().map(|set| format!(" {set} "));
    let of_other_sets = |line: &&str| !line.starts_with('#') && !sets.clone().any(|set| line.contains(&set));
    let mut lines: Vec<String> = kept.lines().filter(of_other_sets).map(String::from).collect();
    for Row { key, hashes } in all_rows() {
        let text: String = hashes.iter().map(|(_, hash)| format!(" {hash:04x}")).collect();
        let set = key.split(' ').next_back().unwrap_or_default();
        let stored = stored_of(&key).unwrap_or_default();
        if is_stored(&format!(" {set} ")) && stored != text {
            let mut stored = stored.split_whitespace();
            let differ = hashes.iter().filter(|(_, hash)| stored.next() != Some(&format!("{hash:04x}")));
            wrong.push(format!("{key}: {:?}", differ.map(|(name, _)| *name).collect::<Vec<_>>()));
        }
        lines.push(format!("{key}{text}"));
    }
    if env::var_os("BLESS").is_some() {
        lines.sort();
        return fs::write(FILE, format!("{HEAD}{}\n", lines.join("\n"))).expect("a file to write");
    }
    assert!(kept.starts_with(HEAD), "the head of {FILE} is stale");
    assert!(wrong.is_empty(), "final states changed: {wrong:#?}");
}

#[test]
fn a_bit_of_a_coefficient_changes_the_hash() {
    let hash = |cycle| {
        let composition = ByTable::<Plain>::of(Yoshida4).with_cycle(cycle);
        let start = POINT.of(compensated);
        by_table::<HenonHeiles, Plain, f64, Compensated<f64>>(&HenonHeiles, composition, &start)
    };
    let cycle = Yoshida4::STAGES.cycle;
    let unchanged = hash(cycle);
    for row in 0..cycle.len() {
        for kick in [false, true] {
            let mut changed = cycle.to_vec();
            let number = if kick { &mut changed[row].kick } else { &mut changed[row].drift };
            *number = f64::from_bits(number.to_bits() ^ 1);
            assert_ne!(hash(Box::leak(changed.into())), unchanged, "row {row}");
        }
    }
}

#[test]
fn gradients_change_the_hash() {
    let hash = |composition| {
        let start = POINT.of(|number| number);
        by_table::<HenonHeiles, WithGradients, f64, f64>(&HenonHeiles, composition, &start)
    };
    assert_ne!(hash(ByTable::of(Chin4A)), hash(ByTable::of(Chin4B)));
    assert_ne!(hash(ByTable::of(Verlet)), hash(ByTable::of(TakahashiImada4)));
}

/// Compares the loop that is compiled for a composition with the loop that reads its table, for a system that uses avx2 at most.
fn agree<G: Kicks<H>, H: Hamiltonian, X: Composition<H>, K: Precision>(
    system: &H,
    composition: X,
    start: &Phase<Shaped<H, K>>,
) {
    let read = match InstructionSet::chosen() {
        InstructionSet::Baseline => by_table::<H, G, K::Plain, K>,
        InstructionSet::Fused | InstructionSet::Avx512 => by_table::<H, G, K::Fused, K>,
    };
    let compiled = by_run::<H, X, K>(system, composition, start);
    assert_eq!(compiled, read(system, ByTable::of(composition), start), "{}", X::NAME);
}

#[test]
fn compiled_compositions_take_the_steps_of_their_tables() {
    let (double, compensated) = (&POINT.of(|number| number), &POINT.of(compensated));
    macro_rules! agree {
        ($kicks:ident $system:ident $start:ident: $($composition:ident)*) => {$(
            agree::<$kicks, _, _, _>(&$system, $composition, $start);
        )*};
    }
    macro_rules! general {
        ($($composition:ident)*) => { agree!(Plain HenonHeiles double: $($composition)*); };
    }
    macro_rules! quadratic {
        ($($composition:ident)*) => { agree!(WithGradients HenonHeiles double: $($composition)*); };
    }
    for_each_composition!(general_kinds: general!);
    for_each_composition!(quadratic_kinds: quadratic!);
    agree!(Plain HenonHeiles compensated: Yoshida4);
    agree!(WithGradients HenonHeiles compensated: Chin4A);
    agree!(Plain Switched double: Yoshida4 VelocityVerlet BlanesCasasMurua6S11);
    agree!(Plain Switched compensated: Yoshida4);
    agree!(Plain ThreeParts double: Euler VelocityVerlet KahanLi6);
    agree!(Plain ThreeParts compensated: Yoshida4);
    agree!(Plain Paired double: Euler Abah844 BlanesCasasMurua6S11);
    agree!(Plain Paired compensated: Abah844);
    agree!(Plain Mixed double: Yoshida4 VelocityVerlet);
}
