//! The operations that generated code carries out are those that the report states.

use crate::{
    choice::seeds,
    examples::{Example, examples},
    expansion::Expansion,
    grammar,
    judge::{Case, System, machine, method},
    lines::iterations,
    number::{Kind, Number},
    value::{Outcome, Stop, Value},
};
use integrator_symbolic::{Each, Report, Tally, report};
use proc_macro2::TokenStream;
use std::{collections::HashMap, rc::Rc};
use syn::{ImplItemFn, ItemImpl};

/// The operations of one flow or energy.
struct Counted {
    flow: &'static str,
    stated: Tally,
    done: Tally,
}

/// The flows and the energies of a system in a case.
fn counted(
    methods: &[&ImplItemFn],
    expansion: &Expansion,
    report: &Report,
    case: &Case,
    constants: &[(String, Value)],
) -> Outcome<Vec<Counted>> {
    let rows = [
        ("drift", &report.drift.places, true),
        ("kick", &report.kick.places, true),
        ("kinetic", &report.energies[0], false),
        ("potential", &report.energies[1], false),
    ];
    let mut found = Vec::new();
    for (name, places, is_flow) in rows {
        let (done, calls) = done(methods, expansion, case, constants, (name, is_flow))?;
        let mut stated = Tally::default();
        for place in places {
            let called = match place.each {
                Each::Iterations => 1,
                Each::Sites => most(&calls, &["contributions"]),
                Each::Bodies => most(&calls, &["drift_body", "one_body", "energy_alone"]),
                Each::Pairs | Each::OrderedPairs => most(&calls, &["pair", "energy"]),
            };
            if called > 0 {
                add(&mut stated, &place.operations, called * iterations(methods, case, constants, place)?);
            }
        }
        found.push(Counted { flow: name, stated, done });
    }
    Ok(found)
}

/// What a generated function carries out.
fn done(
    methods: &[&ImplItemFn],
    expansion: &Expansion,
    case: &Case,
    constants: &[(String, Value)],
    (name, is_flow): (&str, bool),
) -> Outcome<(Tally, HashMap<String, u64>)> {
    let mut machine = machine(methods, case);
    machine.constants = constants.iter().cloned().collect();
    expansion.teach(&mut machine);
    let function = |name: &str| expansion.function(name).ok_or_else(|| Stop::Foreign(format!("no `{name}`")));
    let parameters = machine.call(function("parameters")?, vec![Value::size(case.state[0].len())])?;
    let mut parameters = parameters.lifted(Kind::Scalar);
    if let Some(begin) = expansion.begin_step() {
        parameters = machine.with_self(parameters, |machine| machine.call(begin, vec![Value::plain(case.time)]))?;
    }
    let slots = |part: usize| {
        let slot = |value| Value::Slot(Number::plain(value).of_kind(Kind::Scalar));
        case.shaped(&case.state[part], slot)
    };
    let fields = [("q", slots(0)), ("p", slots(1)), ("parameters", parameters)];
    let motion = Value::Struct(Rc::new(fields.map(|(name, value)| (name.to_owned(), value)).to_vec()));
    let time = Value::plain(case.time);
    machine.done = Tally::default();
    machine.calls.clear();
    machine.takes_both = true;
    if is_flow {
        machine.run(function(name)?, vec![motion, Value::plain(0.37), time], Some(0))?;
    } else {
        machine.call(function(name)?, vec![motion, time])?;
        // Nothing moves: contributions are added up.
        machine.done.additions += std::mem::take(&mut machine.done.coordinates);
    }
    Ok((machine.done, machine.calls))
}

/// How often the runtime called the one of these functions that it calls most.
fn most(calls: &HashMap<String, u64>, functions: &[&str]) -> u64 {
    functions.iter().filter_map(|name| calls.get(*name)).copied().max().unwrap_or_default()
}

/// Adds operations as often as they are carried out.
fn add(to: &mut Tally, operations: &Tally, times: u64) {
    to.additions += times * operations.additions;
    to.multiplications += times * operations.multiplications;
    to.divisions += times * operations.divisions;
    to.roots += times * operations.roots;
    for (name, count) in &operations.functions {
        if times * count > 0 {
            *to.functions.entry(name.clone()).or_default() += times * count;
        }
    }
    to.branches += times * operations.branches;
    to.coordinates += times * operations.coordinates;
}

/// A system in which these are compared.
pub(crate) struct Compared<'s> {
    name: String,
    arguments: TokenStream,
    system: &'s System,
    constants: Vec<(String, Value)>,
}

impl<'s> Compared<'s> {
    /// A system without arguments of the macro.
    pub(crate) fn of(name: String, system: &'s System) -> Self {
        Self { name, arguments: TokenStream::new(), system, constants: Vec::new() }
    }
}

/// What came of many systems.
#[derive(Default)]
pub(crate) struct Outcomes {
    equal: usize,
    /// Cases in which a function of the user panics.
    panics: usize,
    pub(crate) apart: Vec<(String, String)>,
}

impl Outcomes {
    fn compare(&mut self, compared: &Compared<'_>) {
        let Compared { name, arguments, system, .. } = compared;
        let report = match report(arguments.clone(), system.item.clone()) {
            Ok(report) => report,
            Err(error) => return self.apart.push((name.clone(), error.to_string())),
        };
        let expansion = integrator_symbolic::hamiltonian(arguments.clone(), system.item.clone());
        self.compare_with(compared, &report, &Expansion::read(expansion).expect("code"));
    }

    /// Compares the counts of a text that may not be what the macro writes.
    pub(crate) fn compare_with(&mut self, compared: &Compared<'_>, report: &Report, expansion: &Expansion) {
        let Compared { name, system, constants, .. } = compared;
        let item: ItemImpl = syn::parse2(system.item.clone()).expect("an impl");
        let methods: Vec<_> = item.items.iter().filter_map(method).collect();
        for case in &system.cases {
            match counted(&methods, expansion, report, case, constants) {
                Err(Stop::Panic(_)) => self.panics += 1,
                Err(stop) => self.apart.push((name.clone(), stop.to_string())),
                Ok(found) => {
                    for Counted { flow, stated, done } in found {
                        if stated == done {
                            self.equal += 1;
                        } else {
                            let text = format!("{flow}: the report states {stated}, and {done} are carried out");
                            self.apart.push((name.clone(), text));
                        }
                    }
                }
            }
        }
    }

    /// Nothing is apart but what a row of the table says, and these are.
    fn assert_equal(&self, exceptions: &[(&str, &str)]) {
        println!("{} flows and energies are equal, {} cases panic", self.equal, self.panics);
        let is_excepted = |name: &str| exceptions.iter().any(|(excepted, _)| *excepted == name);
        let apart: Vec<_> = self.apart.iter().filter(|(name, _)| !is_excepted(name)).collect();
        assert!(apart.is_empty(), "{apart:#?}");
        let needless = exceptions.iter().filter(|(excepted, _)| !self.apart.iter().any(|(name, _)| name == excepted));
        let needless: Vec<_> = needless.collect();
        assert!(needless.is_empty(), "these are equal: {needless:?}");
    }
}

/// Systems of the corpus whose counts are not compared, with the reason.
const EXCEPTIONS: &[(&str, &str)] = &[
    ("Dimers", "the interpreter knows no types with methods of the user"),
    ("RampedLattice", "the interpreter knows no enums"),
    ("Tabulated", "the interpreter knows no methods of the user in flows"),
];

#[test]
fn counts_of_the_corpus_are_those_of_the_report() {
    let mut outcomes = Outcomes::default();
    for example in examples() {
        match example {
            Err((name, reason)) => outcomes.apart.push((name, reason)),
            Ok(Example { name, arguments, system, constants }) => {
                outcomes.compare(&Compared { name, arguments, system: &system, constants });
            }
        }
    }
    outcomes.assert_equal(EXCEPTIONS);
}

/// Random systems whose counts are not compared, with the reason.
const RANDOM_EXCEPTIONS: &[(&str, &str)] =
    &[("system 392", FLAG_OF_A_LOOP), ("system 539", FLAG_OF_A_LOOP), ("system 915", FLAG_OF_A_LOOP)];
const FLAG_OF_A_LOOP: &str = "the report states a condition of a loop that has no iterations as the user wrote it";

/// `RANDOM_COUNTS_COUNT` asks for more systems of each kind.
#[test]
fn counts_of_random_systems_are_those_of_the_report() {
    type OfSeed = fn(u64) -> System;
    let kinds: [(&str, OfSeed); 3] =
        [("system", grammar::system), ("lattice", grammar::lattice), ("bodies", grammar::pairs)];
    let mut outcomes = Outcomes::default();
    let mut names = Vec::new();
    for (kind, of_seed) in kinds {
        for seed in seeds(["RANDOM_COUNTS_SEED", "RANDOM_COUNTS_COUNT"], 20) {
            let (name, system) = (format!("{kind} {seed}"), with_another_number(of_seed(seed)));
            if report(TokenStream::new(), system.item.clone()).is_ok() {
                outcomes.compare(&Compared::of(name.clone(), &system));
                names.push(name);
            }
        }
    }
    let exceptions: Vec<_> =
        RANDOM_EXCEPTIONS.iter().filter(|(excepted, _)| names.iter().any(|name| name == excepted)).copied().collect();
    outcomes.assert_equal(&exceptions);
    assert!(outcomes.panics * 10 < outcomes.equal, "{} of {} panic", outcomes.panics, outcomes.equal);
}

/// The same system with `self.number` in the place of `self.n`, which in a report is the number of coordinates.
fn with_another_number(system: System) -> System {
    let item = system.item.to_string();
    let mut parts = item.split("self . n");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let is_longer = part.starts_with(|next: char| next.is_alphanumeric() || next == '_');
        text += if is_longer { "self . n" } else { "self . number" };
        text += part;
    }
    let cases = system.cases.into_iter().map(|case| {
        let Value::Struct(fields) = &case.fields else { return case };
        let name = |name: &str| if name == "n" { "number".to_owned() } else { name.to_owned() };
        let fields = fields.iter().map(|(known, value)| (name(known), value.clone())).collect();
        Case { fields: Value::Struct(Rc::new(fields)), ..case }
    });
    System { item: text.parse().expect("tokens"), cases: cases.collect() }
}
