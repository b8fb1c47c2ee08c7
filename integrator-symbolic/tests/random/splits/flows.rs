//! Generated flows of parts: the derivative of a flow with respect to its duration is the field of the part where it ends, and
//! the energy of the part there is that at the start.

use super::{Fault, Number, Outcome, Split, Stop, Value, Verdict, machine, method};
use crate::{bounded::Bounded, expansion::Expansion, number::Kind};
use std::rc::Rc;
use syn::ImplItemFn;

/// How long the flow is.
const DURATION: f64 = 0.25;

impl Split {
    /// Compares the flow of the part `a`, unless it is between others.
    pub(super) fn judge_flow(&self, expansion: &Expansion, verdict: &mut Verdict) {
        let name = match self.parts.iter().position(|part| *part == "a") {
            Some(0) => "drift",
            Some(last) if last + 1 == self.parts.len() => "kick",
            _ => return,
        };
        let item = self.parsed();
        let methods: Vec<&ImplItemFn> = item.items.iter().filter_map(method).collect();
        let start = self.part_at(&methods, "a", &self.case.state);
        let end = self.flow(&methods, expansion, name);
        match end.and_then(|end| Ok((start?.main, self.part_where(&methods, &end)?, end))) {
            Ok((start, (energy, field), end)) => {
                let speeds = end.iter().map(|number| number.tangent(0)).collect();
                verdict.compare(Fault::Force, "flow", &field, Ok(speeds), false);
                verdict.compare(Fault::Energy, "flow", &[start], Ok(vec![energy]), false);
            }
            Err(stop) => verdict.note(Fault::Text, format!("the flow: {stop}")),
        }
    }

    /// Where the flow leads, positions first, with derivatives by its duration.
    fn flow(&self, methods: &[&ImplItemFn], expansion: &Expansion, name: &str) -> Outcome<Vec<Number>> {
        let mut machine = machine(methods, &self.case);
        expansion.teach(&mut machine);
        let function = |name: &str| expansion.function(name).ok_or_else(|| Stop::Foreign(format!("no `{name}`")));
        let length = Value::size(self.case.state[0].len());
        let parameters = machine.call(function("parameters")?, vec![length])?.lifted(Kind::Scalar);
        let slots = |part: usize| {
            let slot = |value| Value::Slot(Number::plain(value).of_kind(Kind::Scalar));
            self.case.shaped(&self.case.state[part], slot)
        };
        let fields = [("q", slots(0)), ("p", slots(1)), ("parameters", parameters)];
        let motion = Value::Struct(Rc::new(fields.map(|(name, value)| (name.to_owned(), value)).to_vec()));
        let duration = Number::coordinate(DURATION, 0, 1).into();
        let (_, after) = machine.run(function(name)?, vec![motion, duration, Value::plain(0.0)], Some(0))?;
        let mut numbers = Vec::new();
        after.field("q")?.numbers(&mut numbers);
        after.field("p")?.numbers(&mut numbers);
        Ok(numbers)
    }

    /// The energy and the field of the part at these coordinates.
    fn part_where(&self, methods: &[&ImplItemFn], at: &[Number]) -> Outcome<(Bounded, Vec<Bounded>)> {
        let mut machine = machine(methods, &self.case);
        let half = self.degrees();
        let coordinate = |place: usize| {
            let number = Number::coordinate(at[place].main.value, place, 2 * half);
            Value::from(Number { main: at[place].main, ..number })
        };
        let halves = [0, half].map(|first| Value::list((first..first + half).map(coordinate)));
        let energy = machine.call(machine.functions["a"], halves.to_vec())?;
        let energy = energy.number()?;
        let field = (0..2 * half).map(|place| match place.checked_sub(half) {
            Some(position) => -energy.tangent(position),
            None => energy.tangent(place + half),
        });
        Ok((energy.main, field.collect()))
    }
}
