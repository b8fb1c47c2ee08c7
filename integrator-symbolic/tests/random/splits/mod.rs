//! Random systems in named parts: a part has the flow that it was written to have, and none where one term is in the way.
//!
//! What is derived of them is compared with the user's own functions by the interpreter: the energies of the first part and
//! of the others, the field of the whole, the flows of parts that the runtime does not solve, and what it is told of others.

mod flows;
mod grammar;
mod solved;

use crate::{
    SEEDS,
    bounded::Bounded,
    choice::seeds,
    expansion::Expansion,
    judge::{Fault, Verdict, machine, method},
    number::{Kind, Number},
    value::{Outcome, Stop, Value},
};
use grammar::{FLOWS, Flow, Split};
use proc_macro2::TokenStream;
use std::rc::Rc;
use syn::{FnArg, ImplItemFn, ItemImpl, Pat};

/// What an annotated impl says of H: the energies of the first part and of the others, and the field of the whole.
struct Said {
    energies: [Bounded; 2],
    /// Nothing for the stepper of an H that is `T(p) + V(q)`: its flows tell the field.
    field: Option<Vec<Bounded>>,
}

impl Split {
    fn parsed(&self) -> ItemImpl {
        syn::parse_str(&self.item).unwrap_or_else(|error| panic!("{error} in {}", self.item))
    }

    fn output(&self) -> TokenStream {
        let arguments: TokenStream = format!("split = {}", self.parts.join(" + ")).parse().expect("names");
        integrator_symbolic::hamiltonian(arguments, self.item.parse().expect("an impl"))
    }

    /// What the macro writes, or its message.
    fn expansion(&self) -> Result<Expansion, String> {
        Expansion::read(self.output())
    }

    fn judge(&self, expansion: &Expansion) -> Verdict {
        let item = self.parsed();
        let methods: Vec<&ImplItemFn> = item.items.iter().filter_map(method).collect();
        let mut verdict = Verdict::default();
        let said = match self.said_by_functions(&methods) {
            Ok(said) => said,
            Err(stop) => {
                verdict.note(Fault::Text, format!("the functions: {stop}"));
                return verdict;
            }
        };
        let found = self.said_by_stepper(&methods, expansion);
        let energies = found.as_ref().map(|found| found.energies.to_vec()).map_err(Stop::clone);
        verdict.compare(Fault::Energy, "energies", &said.energies, energies, false);
        let field = found.map(|found| found.field).transpose();
        if let (Some(said), Some(field)) = (said.field, field) {
            verdict.compare(Fault::Force, "field", &said, field, false);
        }
        self.judge_solved(&methods, expansion, &mut verdict);
        verdict
    }

    /// What the parts are as they stand, with derivatives carried forward.
    fn said_by_functions(&self, methods: &[&ImplItemFn]) -> Outcome<Said> {
        let mut energies = [Number::plain(0.0), Number::plain(0.0)];
        for (number, part) in self.parts.iter().enumerate() {
            let sum = &mut energies[usize::from(number > 0)];
            *sum = sum.add(&self.part_at(methods, part, &self.case.state)?);
        }
        let half = self.degrees();
        let whole = energies[0].add(&energies[1]);
        let field = (0..2 * half).map(|place| match place.checked_sub(half) {
            Some(position) => -whole.tangent(position),
            None => whole.tangent(place + half),
        });
        let field = Some(field.collect());
        Ok(Said { energies: energies.map(|energy| energy.main), field })
    }

    /// How many positions there are.
    fn degrees(&self) -> usize {
        self.case.state[0].iter().map(Vec::len).sum()
    }

    /// A part as it stands, with derivatives carried forward, at some positions and momenta.
    fn part_at(&self, methods: &[&ImplItemFn], part: &str, state: &[Vec<Vec<f64>>; 2]) -> Outcome<Number> {
        let mut machine = machine(methods, &self.case);
        let half = self.degrees();
        let coordinates = |part: usize| {
            let mut place = part * half;
            self.case.shaped(&state[part], |value| {
                place += 1;
                Number::coordinate(value, place - 1, 2 * half).into()
            })
        };
        let function = machine.functions[part];
        let halves = function.sig.inputs.iter().filter_map(|argument| match argument {
            FnArg::Typed(typed) => match &*typed.pat {
                Pat::Ident(name) => Some(coordinates(usize::from(name.ident == "p"))),
                _ => None,
            },
            FnArg::Receiver(_) => None,
        });
        Ok(machine.call(function, halves.collect())?.number()?.clone())
    }

    /// What the generated text is.
    fn said_by_stepper(&self, methods: &[&ImplItemFn], expansion: &Expansion) -> Outcome<Said> {
        let mut machine = machine(methods, &self.case);
        expansion.teach(&mut machine);
        let function = |name: &str| expansion.function(name).ok_or_else(|| Stop::Foreign(format!("no `{name}`")));
        let length = Value::size(self.case.state[0].len());
        let parameters = machine.call(function("parameters")?, vec![length])?.lifted(Kind::Scalar);
        let slots = |part: usize, moved: bool| {
            let slot = |value| Value::Slot(Number::plain(if moved { 0.0 } else { value }).of_kind(Kind::Scalar));
            self.case.shaped(&self.case.state[part], slot)
        };
        let fields = |fields: Vec<(&str, Value)>| {
            Value::Struct(Rc::new(fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()))
        };
        let motion = fields(vec![("q", slots(0, false)), ("p", slots(1, false)), ("parameters", parameters)]);
        let moved = fields(vec![("q", slots(0, true)), ("p", slots(1, true))]);
        let time = Value::plain(0.0);
        let mut energy = |name| {
            let energy = machine.call(function(name)?, vec![motion.clone(), time.clone()])?;
            Ok(energy.number()?.main)
        };
        let energies = [energy("kinetic")?, energy("potential")?];
        let Some(along_field) = expansion.function("along_field") else {
            return Ok(Said { energies, field: None });
        };
        let arguments = vec![motion.clone(), moved, Value::plain(1.0), time.clone()];
        let (_, after) = machine.run(along_field, arguments, Some(1))?;
        let mut numbers = Vec::new();
        after.field("q")?.numbers(&mut numbers);
        after.field("p")?.numbers(&mut numbers);
        Ok(Said { energies, field: Some(numbers.into_iter().map(|number| number.main).collect()) })
    }
}

#[test]
fn parts_have_the_flows_that_they_are_written_to_have() {
    let mut all = Verdict::default();
    for (seed, flow) in seeds(SEEDS, 16).flat_map(|seed| FLOWS.map(|flow| (seed, flow))) {
        let split = grammar::split(seed, flow, false);
        let text = format!("split = {} on {}", split.parts.join(" + "), split.item);
        let expansion = split.expansion().unwrap_or_else(|message| panic!("{flow:?} {seed}: {message}\n{text}"));
        let mut verdict = split.judge(&expansion);
        if matches!(flow, Flow::Shear | Flow::Shifted) {
            split.judge_flow(&expansion, &mut verdict);
        }
        assert!(verdict.faults.is_empty(), "{flow:?} {seed}: {:?}\n{text}", verdict.faults);
        all.compared += verdict.compared;
        all.skipped += verdict.skipped;
    }
    assert!(all.skipped * 10 < all.compared, "{} of {} numbers were skipped", all.skipped, all.compared);
}

#[test]
fn parts_that_miss_a_flow_by_a_term_are_refused() {
    for (seed, flow) in seeds(SEEDS, 16).flat_map(|seed| FLOWS.map(|flow| (seed, flow))) {
        let split = grammar::split(seed, flow, true);
        let text = format!("split = {} on {}", split.parts.join(" + "), split.item);
        match split.expansion() {
            Ok(_) => panic!("{flow:?} {seed} is accepted\n{text}"),
            Err(message) => {
                assert!(message.contains("no exact flow is known for `a`"), "{flow:?} {seed}: {message}\n{text}");
            }
        }
    }
}

#[test]
fn another_coefficient_is_found() {
    for seed in 0..20 {
        let split = grammar::split(seed, Flow::Quadratic, false);
        let item = split.item.replace("7.3 *", "7.300001 *");
        assert_ne!(item, split.item);
        let other = Split { item, parts: split.parts.clone(), case: split.case.clone() };
        let expansion = other.expansion().unwrap_or_else(|message| panic!("{message}\n{}", other.item));
        let faults = split.judge(&expansion).faults;
        for fault in [Fault::Energy, Fault::Force, Fault::Solved] {
            assert!(faults.iter().any(|(found, _)| *found == fault), "{fault:?} of {seed} is not found: {faults:?}");
        }
    }
}

#[test]
fn wrong_runtime_arguments_are_found_although_energies_and_field_are_right() {
    let wrong = [
        (Flow::Quadratic, "form . qq", "form . pp", Fault::Solved),
        (Flow::Quadratic, "form . pp", "form . qp", Fault::Solved),
        (Flow::Kepler, "[& mut motion . q", "[& mut motion . p", Fault::Text),
        (Flow::Kepler, "Scalar :: of (1.0) , duration", "Scalar :: of (1.5) , duration", Fault::Solved),
    ];
    for (flow, from, to, fault) in wrong {
        let mut changed = 0;
        for seed in 0..10 {
            let split = grammar::split(seed, flow, false);
            let output = split.output().to_string();
            let other = output.replace(from, to);
            let expansion = Expansion::read(other.parse().expect("tokens")).expect("the same but for a word");
            let faults = split.judge(&expansion).faults;
            changed += usize::from(output != other);
            let mut found: Vec<_> = faults.iter().map(|(fault, _)| *fault).collect();
            found.dedup();
            let expected = if output == other { vec![] } else { vec![fault] };
            assert_eq!(found, expected, "{flow:?} {seed}, `{to}` for `{from}`: {faults:?}");
        }
        assert!(changed > 0, "`{from}` is nowhere");
    }
}

#[test]
fn a_wrong_shift_is_found_by_the_flow() {
    for (from, to) in
        [("Scalar :: of (- 1.0)", "Scalar :: of (- 1.01)"), ("Scalar :: of (1.0)", "Scalar :: of (- 1.0)")]
    {
        let mut changed = 0;
        for seed in 0..10 {
            let split = grammar::split(seed, Flow::Shifted, false);
            let output = split.output().to_string();
            let other = output.replacen(from, to, 1);
            let expansion = Expansion::read(other.parse().expect("tokens")).expect("the same but for a number");
            let mut verdict = Verdict::default();
            split.judge_flow(&expansion, &mut verdict);
            // The flow of a part between others is not compared, and the first number may be one of another function.
            changed += usize::from(!verdict.faults.is_empty());
        }
        assert!(changed > 2, "`{to}` for `{from}` is found {changed} times");
    }
}
