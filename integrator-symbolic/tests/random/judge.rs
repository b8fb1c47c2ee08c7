//! Holds what is generated for a system against the user's own text.
//!
//! The reference evaluates `kinetic` and `potential` as they stand, with derivatives carried forward; the generated text
//! is evaluated by the same interpreter. Two values may differ by the sum of their bounds, and by nothing else.

use crate::{
    bounded::Bounded,
    expansion::Expansion,
    machine::Machine,
    number::{Kind, Number},
    value::{Outcome, Stop, Value},
};
use proc_macro2::TokenStream;
use quote::format_ident;
use std::rc::Rc;
use syn::{ImplItem, ImplItemFn, ItemImpl};

/// An annotated impl, and where it is looked at.
#[derive(Clone)]
pub(crate) struct System {
    pub(crate) item: TokenStream,
    pub(crate) cases: Vec<Case>,
}

/// The fields of the system, a state, and a time.
#[derive(Clone)]
pub(crate) struct Case {
    pub(crate) fields: Value,
    /// Positions and momenta: points, of one number each where `is_flat`.
    pub(crate) state: [Vec<Vec<f64>>; 2],
    pub(crate) is_flat: bool,
    pub(crate) time: f64,
}

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Fault {
    /// The user's function gives a number, and the generated text panics.
    Panics,
    Energy,
    Force,
    /// A coefficient that the runtime is told of a part that it solves.
    Solved,
    /// The generated text is no Rust, or was not taught to the interpreter.
    Text,
}

/// What came of a system.
#[derive(Default)]
pub(crate) struct Verdict {
    pub(crate) faults: Vec<(Fault, String)>,
    /// How many numbers were compared.
    pub(crate) compared: usize,
    /// How many could not be: a branch that rounding decides, a bound that is not finite.
    pub(crate) skipped: usize,
    /// In how many cases a function of the user panics itself.
    pub(crate) panics: usize,
}

/// Why there is no verdict.
pub(crate) enum Outside {
    /// The macro has a message.
    Refused(String),
    /// The user's text is none that the interpreter knows.
    Foreign(String),
}

/// Both parts of H: the function of the user, the flow that its gradient makes, and the step for which that is the gradient.
const PARTS: [(&str, &str, f64); 2] = [("potential", "kick", -1.0), ("kinetic", "drift", 1.0)];

impl System {
    pub(crate) fn judge(&self) -> Result<Verdict, Outside> {
        self.parsed()?;
        let expansion = Expansion::of(self.item.clone()).map_err(Outside::Refused)?;
        self.judge_expansion(&expansion)
    }

    fn parsed(&self) -> Result<ItemImpl, Outside> {
        syn::parse2(self.item.clone()).map_err(|error| Outside::Foreign(error.to_string()))
    }

    /// Judges a text that may not be what the macro writes.
    pub(crate) fn judge_expansion(&self, expansion: &Expansion) -> Result<Verdict, Outside> {
        let item = self.parsed()?;
        let methods: Vec<&ImplItemFn> = item.items.iter().filter_map(method).collect();
        let mut verdict = Verdict::default();
        for case in &self.cases {
            let mut references = Vec::new();
            for (number, (name, ..)) in PARTS.into_iter().enumerate() {
                references.push(Evaluation::of_reference(&methods, case, number, name)?);
            }
            // What is prepared is prepared for both parts.
            if references.iter().any(|reference| reference.energy.is_err()) {
                verdict.panics += 1;
                continue;
            }
            for (number, (part, reference)) in PARTS.into_iter().zip(references).enumerate() {
                let generated = Evaluation::of_generated(&methods, expansion, case, number, part);
                verdict.add(&reference, generated, part.0);
                // The half of the field that implicit methods use.
                let half = ["along_force", "along_velocity"][number];
                if expansion.function(half).is_some() {
                    let (name, _, duration) = part;
                    let part = (name, half, duration);
                    let generated = Evaluation::of_generated(&methods, expansion, case, number, part);
                    verdict.add(&reference, generated, "field");
                }
            }
        }
        Ok(verdict)
    }
}

pub(crate) fn method(item: &ImplItem) -> Option<&ImplItemFn> {
    match item {
        ImplItem::Fn(function) => Some(function),
        _ => None,
    }
}

/// An energy and its gradient, as far as they could be evaluated.
struct Evaluation {
    energy: Outcome<Bounded>,
    gradient: Outcome<Vec<Bounded>>,
    on_edge: bool,
}

impl Evaluation {
    fn of_reference(methods: &[&ImplItemFn], case: &Case, number: usize, name: &str) -> Result<Self, Outside> {
        let mut machine = machine(methods, case);
        let points = &case.state[number];
        let count = points.iter().map(Vec::len).sum();
        let mut place = 0;
        let coordinates = case.shaped(points, |value| {
            place += 1;
            Number::coordinate(value, place - 1, count).into()
        });
        let Some(function) = machine.functions.get(name).copied() else {
            return Err(Outside::Foreign(format!("no `{name}`")));
        };
        let energy = machine.call(function, vec![coordinates, Value::plain(case.time)]);
        let energy = match energy.and_then(|energy| energy.number().cloned()) {
            Err(Stop::Panic(_)) => {
                let panics = || Stop::Panic(String::new());
                return Ok(Self { energy: Err(panics()), gradient: Err(panics()), on_edge: false });
            }
            Err(stop) => return Err(Outside::Foreign(stop.to_string())),
            Ok(energy) => energy,
        };
        let gradient = (0..count).map(|place| energy.tangent(place)).collect();
        Ok(Self { energy: Ok(energy.main), gradient: Ok(gradient), on_edge: machine.on_edge })
    }

    fn of_generated(
        methods: &[&ImplItemFn],
        expansion: &Expansion,
        case: &Case,
        number: usize,
        (name, flow, duration): (&str, &str, f64),
    ) -> Self {
        let mut machine = machine(methods, case);
        expansion.teach(&mut machine);
        let function = |name| expansion.function(name).ok_or_else(|| Stop::Foreign(format!("no `{name}`")));
        let parameters = function("parameters")
            .and_then(|parameters| machine.call(parameters, vec![Value::size(case.state[number].len())]));
        let parameters = parameters.and_then(|parameters| {
            let parameters = parameters.lifted(Kind::Scalar);
            match expansion.begin_step() {
                Some(begin) => {
                    machine.with_self(parameters, |machine| machine.call(begin, vec![Value::plain(case.time)]))
                }
                None => Ok(parameters),
            }
        });
        let parameters = match parameters {
            Ok(parameters) => parameters,
            Err(stop) => {
                return Self { energy: Err(stop.clone()), gradient: Err(stop), on_edge: false };
            }
        };
        // The coordinates that a flow moves begin at zero, where they end as the gradient.
        let slots = |part: usize, moved: bool| {
            let slot = |value| Value::Slot(Number::plain(if moved { 0.0 } else { value }).of_kind(Kind::Scalar));
            case.shaped(&case.state[part], slot)
        };
        let motion = |moved: usize| {
            let fields = [("q", slots(0, moved == 0)), ("p", slots(1, moved == 1)), ("parameters", parameters.clone())];
            Value::Struct(Rc::new(fields.map(|(name, value)| (name.to_owned(), value)).to_vec()))
        };
        let moved = 1 - number;
        let time = Value::plain(case.time);
        let energy = function(name).and_then(|energy| {
            let energy = machine.call(energy, vec![motion(2), time.clone()])?;
            let energy = energy.number()?;
            if energy.kind == Kind::Scalar { Ok(energy.main) } else { Err(Stop::Foreign("an energy in f64".into())) }
        });
        let gradient = function(flow).and_then(|flow| {
            let (arguments, changed) = match flow.sig.inputs.len() {
                3 => (vec![motion(moved), Value::plain(duration), time.clone()], 0),
                // The field is read at one point, and moves another.
                _ => (vec![motion(2), motion(moved), Value::plain(duration), time.clone()], 1),
            };
            let (_, after) = machine.run(flow, arguments, Some(changed))?;
            let mut numbers = Vec::new();
            // A flow without a gradient has no motion to name.
            if let Value::Struct(_) = after {
                after.field(["q", "p"][moved])?.numbers(&mut numbers);
            } else {
                motion(moved).field(["q", "p"][moved])?.numbers(&mut numbers);
            }
            Ok(numbers.into_iter().map(|number| number.main).collect())
        });
        Self { energy, gradient, on_edge: machine.on_edge }
    }
}

/// A machine that knows the user's methods and the system.
pub(crate) fn machine<'t>(methods: &[&'t ImplItemFn], case: &Case) -> Machine<'t> {
    let mut machine = Machine::new(methods.iter().copied());
    machine.names.push((format_ident!("self"), case.fields.clone()));
    machine
}

impl Case {
    pub(crate) fn shaped(&self, points: &[Vec<f64>], mut of: impl FnMut(f64) -> Value) -> Value {
        let point = |point: &Vec<f64>| match self.is_flat {
            true => of(point[0]),
            false => Value::list(point.iter().map(|value| of(*value)).collect::<Vec<_>>()),
        };
        Value::list(points.iter().map(point).collect::<Vec<_>>())
    }
}

impl Verdict {
    fn add(&mut self, reference: &Evaluation, generated: Evaluation, name: &str) {
        let (Ok(energy), Ok(gradient)) = (&reference.energy, &reference.gradient) else { return };
        // Where the energy is no number, nor is its gradient.
        let on_edge = reference.on_edge || generated.on_edge || !energy.value.is_finite();
        let found = generated.energy.map(|energy| vec![energy]);
        self.compare(Fault::Energy, name, std::slice::from_ref(energy), found, on_edge);
        self.compare(Fault::Force, name, gradient, generated.gradient, on_edge);
    }

    pub(crate) fn compare(
        &mut self,
        fault: Fault,
        name: &str,
        expected: &[Bounded],
        found: Outcome<Vec<Bounded>>,
        on_edge: bool,
    ) {
        let found = match found {
            Ok(found) if found.len() == expected.len() => found,
            Ok(found) => {
                return self.note(Fault::Text, format!("{name}: {} components, not {}", found.len(), expected.len()));
            }
            // What is infinite or lost in the user's own text may be so in any way.
            Err(Stop::Panic(what)) => return self.note(Fault::Panics, format!("{name}, {fault:?}: {what}")),
            Err(stop) => return self.note(Fault::Text, format!("{name}, {fault:?}: {stop}")),
        };
        for (place, (expected, found)) in expected.iter().zip(found).enumerate() {
            if on_edge || !expected.is_known() || found.value.is_finite() && !found.error.is_finite() {
                self.skipped += 1;
                continue;
            }
            self.compared += 1;
            let (apart, bound) = ((expected.value - found.value).abs(), expected.error + found.error);
            if apart > bound || apart.is_nan() {
                self.note(
                    fault,
                    format!(
                        "{name}, {fault:?} {place}: {} where the function has {}, bound {bound:e}",
                        found.value, expected.value
                    ),
                );
            }
        }
    }

    pub(crate) fn note(&mut self, fault: Fault, what: String) {
        self.faults.push((fault, what));
    }
}
