//! What the runtime is told of parts that it solves: the derivatives of quadratic forms, masses and strengths of Kepler orbits.
//!
//! Nothing of it is in the energies or in the field, so that these may be right where it is wrong. The generated text tells it
//! to a recorder; what it should be are differences of the gradient of the user's own function.

use super::{Fault, Outcome, Split, Stop, Value, Verdict, machine};
use crate::{bounded::Bounded, expansion::Expansion, machine::Machine};
use std::{collections::BTreeMap, rc::Rc};
use syn::ImplItemFn;

/// The second derivatives of a part, row by row, and the first ones where all coordinates are zero.
struct Derivatives {
    second: Vec<Bounded>,
    first: Vec<Bounded>,
}

/// The inverse mass and the strength of each body.
type Orbits = BTreeMap<usize, [Bounded; 2]>;

impl Split {
    pub(super) fn judge_solved(&self, methods: &[&ImplItemFn], expansion: &Expansion, verdict: &mut Verdict) {
        for (number, part) in self.parts.iter().enumerate() {
            // Coordinates are points where there are orbits, and nowhere else.
            let is_kepler = !self.case.is_flat && *part == "a";
            let (expected, found) = if let Some(derivatives) = expansion.derivatives(number) {
                let all = |Derivatives { second, first }| [second, first].concat();
                let found = self.told_derivatives(methods, expansion, derivatives);
                (self.own_derivatives(methods, part).map(all), found.map(all))
            } else if is_kepler {
                let all = |orbits: Orbits| orbits.into_values().flatten().collect();
                let found = self.told_orbits(methods, expansion, ["drift", "kick"][number]);
                (self.own_orbits(methods, part).map(all), found.map(all))
            } else {
                continue;
            };
            match expected {
                Ok(expected) => verdict.compare(Fault::Solved, part, &expected, found, false),
                Err(stop) => verdict.note(Fault::Text, format!("the function of `{part}`: {stop}")),
            }
        }
    }

    /// The derivatives of a quadratic form by its gradient at points of which one coordinate is one.
    fn own_derivatives(&self, methods: &[&ImplItemFn], part: &str) -> Outcome<Derivatives> {
        let count = 2 * self.degrees();
        let gradient = |at: Option<usize>| {
            let mut state = self.case.state.clone();
            for (place, coordinate) in state.iter_mut().flatten().flatten().enumerate() {
                *coordinate = if at == Some(place) { 1.0 } else { 0.0 };
            }
            let energy = self.part_at(methods, part, &state)?;
            Ok((0..count).map(|place| energy.tangent(place)).collect::<Vec<_>>())
        };
        let first = gradient(None)?;
        let mut second = Vec::new();
        for place in 0..count {
            second.extend(gradient(Some(place))?.into_iter().zip(&first).map(|(there, here)| there - *here));
        }
        Ok(Derivatives { second, first })
    }

    fn told_derivatives(
        &self,
        methods: &[&ImplItemFn],
        expansion: &Expansion,
        derivatives: &ImplItemFn,
    ) -> Outcome<Derivatives> {
        let half = self.degrees();
        let (mut machine, parameters, length) = self.prepared(methods, expansion)?;
        machine.call(derivatives, vec![parameters, length, Value::Told])?;
        let zero = Bounded::from(0.0);
        let mut all = Derivatives { second: vec![zero; 4 * half * half], first: vec![zero; 2 * half] };
        let components = self.case.state[0][0].len();
        for (name, arguments) in std::mem::take(&mut machine.told) {
            let Some((value, places)) = arguments.split_last() else { return Err(unknown(&name)) };
            let value = value.number()?.main;
            let place = |half_of: char, indices: &Value| {
                let place = indices.items()?.iter().try_fold(0, |place, index| Ok(place * components + index.index()?));
                Ok::<_, Stop>(place? + if half_of == 'p' { half } else { 0 })
            };
            let places: Outcome<Vec<usize>> = name.chars().zip(places).map(|(half, at)| place(half, at)).collect();
            match (&name[..], &places?[..]) {
                ("q" | "p", [at]) => all.first[*at] = all.first[*at] + value,
                ("qq" | "pp" | "qp", [a, b]) => {
                    // Those by a position and a momentum come once, the others in both orders together.
                    let share = if name == "qp" { value } else { value * Bounded::from(0.5) };
                    for place in [a * 2 * half + b, b * 2 * half + a] {
                        all.second[place] = all.second[place] + share;
                    }
                }
                _ => return Err(unknown(&name)),
            }
        }
        Ok(all)
    }

    /// Masses by the change of the velocity with the momentum, strengths by `q · ∇(-k/|q|) = k/|q|`.
    fn own_orbits(&self, methods: &[&ImplItemFn], part: &str) -> Outcome<Orbits> {
        let [q, p] = &self.case.state;
        let (bodies, dimension, half) = (q.len(), q[0].len(), self.degrees());
        let resting = [q.clone(), vec![vec![0.0; dimension]; bodies]];
        let moving = [q.clone(), vec![vec![1.0; dimension]; bodies]];
        let (here, there) = (self.part_at(methods, part, &resting)?, self.part_at(methods, part, &moving)?);
        let zero = Bounded::from(0.0);
        let orbits = (0..bodies).map(|body| {
            let place = body * dimension;
            let inverse_mass = there.tangent(half + place) - here.tangent(half + place);
            let components = || q[body].iter().map(|component| Bounded::from(*component));
            let along = components().enumerate().fold(zero, |sum, (d, q)| sum + q * here.tangent(place + d));
            let distance = components().fold(zero, |sum, q| sum + q.square()).sqrt();
            (body, [inverse_mass, along * distance])
        });
        assert_eq!(p.len(), bodies, "a momentum for each");
        Ok(orbits.collect())
    }

    fn told_orbits(&self, methods: &[&ImplItemFn], expansion: &Expansion, flow: &str) -> Outcome<Orbits> {
        let (mut machine, parameters, _) = self.prepared(methods, expansion)?;
        // A body is known by its number, which stands for its coordinates.
        let numbered = |from: usize| Value::list((0..self.case.state[0].len()).map(|body| Value::size(from + body)));
        let fields =
            [("q", numbered(0)), ("p", numbered(MOMENTA)), ("parameters", parameters), ("solvers", Value::Told)];
        let motion = Value::Struct(Rc::new(fields.map(|(name, value)| (name.to_owned(), value)).to_vec()));
        let flow = expansion.function(flow).ok_or_else(|| unknown(flow))?;
        machine.call(flow, vec![motion, Value::plain(1.0), Value::plain(0.0)])?;
        let mut orbits = Orbits::new();
        for (name, arguments) in std::mem::take(&mut machine.told) {
            let [coordinates, inverse_masses, strengths, _] = &arguments[..] else { return Err(unknown(&name)) };
            let [q, p] = coordinates.items()? else { return Err(unknown(&name)) };
            for (place, (body, momentum)) in q.items()?.iter().zip(p.items()?).enumerate() {
                let body = body.index()?;
                let constants = [inverse_masses, strengths].map(|constant| match constant {
                    Value::List(of_bodies) => Ok(of_bodies.get(place).ok_or_else(|| unknown(&name))?.number()?.main),
                    of_all => Ok(of_all.number()?.main),
                });
                let [inverse_mass, strength] = constants;
                let known = orbits.insert(body, [inverse_mass?, strength?]);
                if momentum.index()? != MOMENTA + body || known.is_some() {
                    return Err(unknown(&name));
                }
            }
        }
        Ok(orbits)
    }

    /// A machine that knows the generated text, prepared constants, and the length of the coordinates.
    fn prepared<'t>(
        &self,
        methods: &[&'t ImplItemFn],
        expansion: &'t Expansion,
    ) -> Outcome<(Machine<'t>, Value, Value)> {
        let mut machine = machine(methods, &self.case);
        expansion.teach(&mut machine);
        let length = Value::size(self.case.state[0].len());
        let parameters = expansion.function("parameters").ok_or_else(|| unknown("parameters"))?;
        let parameters = machine.call(parameters, vec![length.clone()])?;
        Ok((machine, parameters, length))
    }
}

/// What the number of a body's momentum begins with.
const MOMENTA: usize = 100;

fn unknown(what: &str) -> Stop {
    Stop::Foreign(format!("`{what}` is not what the runtime is told"))
}
