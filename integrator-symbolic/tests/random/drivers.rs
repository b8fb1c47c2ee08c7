//! What the runtime does around generated functions, in its plainest form: sweeps along lattices and sums over pairs.

use crate::{
    bounded::Bounded,
    machine::Machine,
    number::{Kind, Number},
    value::{Outcome, Value, argument, foreign},
};
use std::{collections::HashMap, rc::Rc};
use syn::{Expr, ImplItemFn};

/// The neighbourhood of a site, as `shares` sees it.
pub(crate) struct Site {
    /// The coordinates, row by row; a line is one row.
    rows: Rc<Vec<Vec<Number>>>,
    row: usize,
    site: usize,
    /// Whether rows, and the sites of a row, are closed.
    periodic: [bool; 2],
}

/// How a generated flow shares out among the sites of a lattice, in the direction of sites or of rows.
#[derive(Clone, Copy, Default)]
pub(crate) struct Boundary {
    pub(crate) forward: usize,
    pub(crate) periodic: bool,
}

/// A flow along a lattice.
pub(crate) struct Lattice<'t> {
    pub(crate) shares: &'t ImplItemFn,
    pub(crate) sites: Boundary,
    pub(crate) rows: Option<Boundary>,
}

/// What bodies do to each other.
pub(crate) struct Bodies<'t> {
    pub(crate) functions: HashMap<String, &'t ImplItemFn>,
    pub(crate) reciprocal: bool,
    pub(crate) central: bool,
}

/// The flows of an expansion that the runtime carries out.
#[derive(Default)]
pub(crate) struct Driven<'t> {
    pub(crate) drift: Option<Lattice<'t>>,
    pub(crate) kick: Option<Lattice<'t>>,
    pub(crate) kinetic: Option<Lattice<'t>>,
    pub(crate) potential: Option<Lattice<'t>>,
    pub(crate) bodies: Option<Bodies<'t>>,
}

fn wrapped(place: usize, by: i128, length: usize, periodic: bool) -> Option<usize> {
    let place = place as i128 + by;
    let length = length as i128;
    let place = if periodic && length > 0 { place.rem_euclid(length) } else { place };
    (0..length).contains(&place).then_some(place as usize)
}

impl Site {
    /// A neighbour; what lies beyond an open end is no number, so that nothing may use it.
    fn neighbour(&self, down: i128, ahead: i128) -> Value {
        let row = wrapped(self.row, down, self.rows.len(), self.periodic[0]);
        let found = row.and_then(|row| {
            let site = wrapped(self.site, ahead, self.rows[row].len(), self.periodic[1])?;
            Some(self.rows[row][site].clone())
        });
        let beyond = Number { main: Bounded { value: f64::NAN, error: f64::NAN }, ..Number::plain(f64::NAN) };
        found.unwrap_or(beyond).of_kind(Kind::Wide).into()
    }

    /// An element of a table at the row or site so much further on; zero where it has none.
    fn of_table(table: &[Value], place: usize, by: i128, length: usize) -> Option<&Value> {
        let place = (place as i128 + by).rem_euclid(length as i128);
        table.get(place as usize)
    }

    pub(crate) fn method(self: Rc<Self>, name: &str, arguments: &[Value]) -> Outcome<Value> {
        let length = self.rows[self.row].len();
        let zero = || Value::from(Number::plain(0.0).of_kind(Kind::Wide));
        let by = |place: usize| -> Outcome<i128> { Ok(argument(arguments, place)?.integer()?.value) };
        let within = |place: usize| match argument(arguments, 0)? {
            Value::Range(from, to) => Ok((from.value..to.value).contains(&(place as i128))),
            other => foreign(format!("{} in place of a range", other.kind())),
        };
        let sum = |holds: bool| -> Outcome<Value> {
            let (sum, value) = (argument(arguments, 1)?.number()?, argument(arguments, 2)?.number()?);
            Ok(if holds { sum.add(value) } else { sum.clone() }.into())
        };
        match name {
            "length" => Ok(Value::size(length)),
            "rows" => Ok(Value::size(self.rows.len())),
            "at" => Ok(self.neighbour(0, by(0)?)),
            "above" => Ok(self.neighbour(-1, by(0)?)),
            "below" => Ok(self.neighbour(1, by(0)?)),
            "table" => {
                let found = Self::of_table(argument(arguments, 0)?.items()?, self.site, by(1)?, length);
                Ok(found.map_or_else(zero, |value| value.lifted(Kind::Wide)))
            }
            "table_over_rows" => {
                let found = Self::of_table(argument(arguments, 0)?.items()?, self.row, by(1)?, self.rows.len());
                Ok(found.map_or_else(zero, |value| value.lifted(Kind::Wide)))
            }
            "table_of_rows" => {
                let Some(row) = Self::of_table(argument(arguments, 0)?.items()?, self.row, by(1)?, self.rows.len())
                else {
                    return Ok(zero());
                };
                let found = Self::of_table(row.items()?, self.site, by(2)?, length);
                Ok(found.map_or_else(zero, |value| value.lifted(Kind::Wide)))
            }
            "masked" => Ok(if within(self.site)? { argument(arguments, 1)?.clone() } else { zero() }),
            "row_masked" => Ok(if within(self.row)? { argument(arguments, 1)?.clone() } else { zero() }),
            "masked_add" => sum(within(self.site)?),
            "row_masked_add" => sum(within(self.row)?),
            _ => foreign(format!("`{name}` of a site")),
        }
    }
}

impl Machine<'_> {
    /// A call of what the runtime does with a motion, or with the terms of a sum.
    pub(crate) fn driver(&mut self, call: &syn::ExprMethodCall, name: &str) -> Option<Outcome<Value>> {
        if name == "add_to" {
            return Some(self.list_sum(call));
        }
        if name == "run" || name == "run_apart" {
            return Some(self.loop_in_lanes(call));
        }
        if name == "inner_product" || name == "add_multiples" {
            return Some(self.products(call));
        }
        if !matches!(&*call.receiver, Expr::Path(path) if path.path.is_ident("motion")) {
            return None;
        }
        match name {
            "plain" => Some(self.expression(&call.receiver)),
            "kinetic" | "potential" => Some(self.energy_of_bodies(call, name)),
            "kinetic_of_layers" => Some(self.energy_of_layers(call, "p")),
            "potential_of_layers" => Some(self.energy_of_layers(call, "q")),
            "drift" | "kick" | "drift_layers" | "kick_layers" => {
                Some(self.driven_flow(call, name.starts_with("drift")))
            }
            _ => None,
        }
    }

    fn driven_flow(&mut self, call: &syn::ExprMethodCall, drifts: bool) -> Outcome<Value> {
        let arguments = self.all(call.args.iter())?;
        let [duration, time] = [argument(&arguments, 0)?.number()?, &argument(&arguments, 1)?.number()?.clone()];
        let step = if drifts { duration.clone() } else { duration.neg() };
        let motion = self.expression(&call.receiver)?;
        let (read, moved) = if drifts { ("p", "q") } else { ("q", "p") };
        let rows = |name| motion.field(name)?.items()?.iter().map(components).collect::<Outcome<Vec<_>>>();
        let (read, mut coordinates) = (rows(read)?, rows(moved)?);
        let driven = std::mem::take(&mut self.driven);
        let lattice = if drifts { &driven.drift } else { &driven.kick };
        let added = match (lattice, &driven.bodies) {
            (Some(lattice), _) => self.swept(lattice, &read, &motion, time),
            (None, Some(bodies)) if drifts => self.drifted(bodies, &read, &coordinates, &motion, [&step, time]),
            (None, Some(bodies)) => self.attracted(bodies, &read, &motion, time),
            (None, None) => foreign("a flow that nobody carries out"),
        };
        let replaces = drifts && lattice.is_none();
        let others = match &driven.bodies {
            Some(bodies) if !drifts => self.other_terms(bodies, &motion, time),
            _ => Ok(None),
        };
        self.driven = driven;
        for added in [Some(added?), others?].into_iter().flatten() {
            for (row, added) in coordinates.iter_mut().zip(added) {
                for (slot, added) in row.iter_mut().zip(added) {
                    *slot = if replaces { added } else { slot.add(&added.mul(&step)).of_kind(Kind::Scalar) };
                }
            }
        }
        let shape = motion.field(moved)?.items()?.iter().any(|item| matches!(item, Value::List(_)));
        let slots = coordinates.into_iter().map(|row| {
            let mut slots = row.into_iter().map(|number| Value::Slot(number.of_kind(Kind::Scalar)));
            if shape { Value::list(slots) } else { slots.next().unwrap_or(Value::Unit) }
        });
        let Value::Struct(fields) = &motion else { return foreign("a motion") };
        let mut fields = fields.to_vec();
        let moved = fields.iter_mut().find(|(name, _)| name == moved);
        if let Some((_, value)) = moved {
            *value = Value::list(slots);
        }
        self.store(&call.receiver, Value::Struct(Rc::new(fields)))?;
        Ok(Value::Unit)
    }

    /// The gradient of the terms beside pairs, if there are any.
    fn other_terms(&mut self, bodies: &Bodies<'_>, motion: &Value, time: &Number) -> Outcome<Option<Vec<Vec<Number>>>> {
        let Some(other_terms) = bodies.functions.get("other_terms").copied() else { return Ok(None) };
        let (_, after) = self.run(other_terms, vec![motion.clone(), time.clone().into()], Some(0))?;
        Ok(Some(after.field("p")?.items()?.iter().map(components).collect::<Outcome<_>>()?))
    }

    /// An energy of bodies, which the runtime sums.
    fn energy_of_bodies(&mut self, call: &syn::ExprMethodCall, name: &str) -> Outcome<Value> {
        let (arguments, motion) = (self.all(call.args.iter())?, self.expression(&call.receiver)?);
        let time = argument(&arguments, 0)?;
        let half = if name == "kinetic" { "p" } else { "q" };
        let read = motion.field(half)?.items()?.iter().map(components).collect::<Outcome<Vec<_>>>()?;
        let driven = std::mem::take(&mut self.driven);
        let energy = match &driven.bodies {
            Some(bodies) if name == "kinetic" => self.kinetic_energy(bodies, &read, &motion, time.number()?),
            Some(bodies) => self.energy_of_pairs(bodies, &read, &motion, time),
            None => foreign("an energy of bodies, of which there are none"),
        };
        self.driven = driven;
        Ok(energy?.of_kind(Kind::Scalar).into())
    }

    /// Half the sum of the products of momenta and velocities.
    fn kinetic_energy(
        &mut self,
        bodies: &Bodies<'_>,
        momenta: &[Vec<Number>],
        motion: &Value,
        time: &Number,
    ) -> Outcome<Number> {
        let zero = Number::plain(0.0);
        let rest: Vec<_> = momenta.iter().map(|p| vec![zero.clone(); p.len()]).collect();
        let velocities = self.drifted(bodies, momenta, &rest, motion, [&Number::plain(1.0), time])?;
        let products = momenta.iter().zip(&velocities).flat_map(|(p, v)| p.iter().zip(v));
        self.done.multiplications += momenta.iter().map(|p| p.len() as u64).sum::<u64>();
        let twice =
            products.fold(zero.of_kind(Kind::Wide), |sum, (p, v)| sum.add(&p.clone().of_kind(Kind::Wide).mul(v)));
        Ok(twice.mul(&Number::plain(0.5).of_kind(Kind::Wide)))
    }

    fn energy_of_pairs(
        &mut self,
        bodies: &Bodies<'_>,
        read: &[Vec<Number>],
        motion: &Value,
        time: &Value,
    ) -> Outcome<Number> {
        let Some(energy) = bodies.functions.get("energy").copied() else { return foreign("no `energy`") };
        let (parameters, prepared) = (motion.field("parameters")?.clone(), self.prepared(bodies, read.len(), motion)?);
        let mut sum = Number::plain(0.0).of_kind(Kind::Wide);
        for i in 0..read.len() {
            if let Some(alone) = bodies.functions.get("energy_alone").copied() {
                let arguments = vec![parameters.clone(), row(&read[i]), prepared[i].clone(), time.clone()];
                if let Value::Option(Some(alone)) = self.call(alone, arguments)? {
                    self.done.additions += 1;
                    sum = sum.add(alone.number()?);
                }
            }
            for j in 0..i {
                let of_both = [row(&read[i]), row(&read[j]), prepared[i].clone(), prepared[j].clone()];
                let arguments: Vec<_> =
                    std::iter::once(parameters.clone()).chain(of_both).chain([time.clone()]).collect();
                if self.is_included(bodies, arguments.clone())? {
                    self.done.additions += 1;
                    sum = sum.add(self.call(energy, arguments)?.number()?);
                }
            }
        }
        Ok(sum.add(&self.energy_of_triplets(bodies, read, &prepared, [&parameters, time])?))
    }

    /// The sum of the terms of all sites of a plane.
    fn energy_of_layers(&mut self, call: &syn::ExprMethodCall, half: &str) -> Outcome<Value> {
        let (arguments, motion) = (self.all(call.args.iter())?, self.expression(&call.receiver)?);
        let time = argument(&arguments, 0)?.number()?;
        let read = motion.field(half)?.items()?.iter().map(components).collect::<Outcome<Vec<_>>>()?;
        let driven = std::mem::take(&mut self.driven);
        let terms = match if half == "p" { &driven.kinetic } else { &driven.potential } {
            Some(lattice) => self.swept(lattice, &read, &motion, time),
            None => foreign("an energy of sites, of which there are none"),
        };
        self.driven = driven;
        let sum = |sum: Number, term: Number| sum.add(&term);
        Ok(terms?.into_iter().flatten().fold(Number::plain(0.0).of_kind(Kind::Wide), sum).of_kind(Kind::Scalar).into())
    }

    /// What every site of a lattice gets from all shares.
    fn swept(
        &mut self,
        lattice: &Lattice<'_>,
        read: &[Vec<Number>],
        motion: &Value,
        time: &Number,
    ) -> Outcome<Vec<Vec<Number>>> {
        let zero = Number::plain(0.0).of_kind(Kind::Wide);
        let plane = lattice.rows.is_some();
        let rows = if plane { read.to_vec() } else { vec![read.iter().map(|point| point[0].clone()).collect()] };
        let rows = Rc::new(rows);
        let along = lattice.rows.unwrap_or_default();
        let periodic = [along.periodic, lattice.sites.periodic];
        let mut shares: Vec<Vec<Vec<Number>>> = Vec::with_capacity(rows.len());
        for row in 0..rows.len() {
            let mut own = Vec::with_capacity(rows[row].len());
            for site in 0..rows[row].len() {
                let near = Value::Site(Rc::new(Site { rows: rows.clone(), row, site, periodic }));
                let arguments = vec![near, motion.field("parameters")?.clone(), time.clone().into()];
                let shares = self.call(lattice.shares, arguments)?;
                own.push(shares.items()?.iter().map(|share| share.number().cloned()).collect::<Outcome<Vec<_>>>()?);
            }
            shares.push(own);
        }
        // What arrives at a site of a row in the order of how far it comes from.
        let arrived = |row: usize, site: usize, places: std::ops::Range<usize>| {
            let mut sum = shares[row][site][places.start].clone();
            for place in places.start + 1..places.end {
                let from = wrapped(site, -((place - places.start) as i128), shares[row].len(), periodic[1]);
                sum = sum.add(&from.map_or_else(|| zero.clone(), |from| shares[row][from][place].clone()));
            }
            sum
        };
        let below = lattice.sites.forward + 1;
        let mut sums: Vec<Vec<Number>> = Vec::with_capacity(rows.len());
        for row in 0..rows.len() {
            let own = (0..rows[row].len()).map(|site| {
                let (sum, all) = (arrived(row, site, 0..below), shares[row][site].len());
                if along.forward == 0 {
                    return sum;
                }
                let above = wrapped(row, -1, rows.len(), periodic[0]);
                sum.add(&above.map_or_else(|| zero.clone(), |above| arrived(above, site, below..all)))
            });
            sums.push(own.collect());
        }
        Ok(if plane { sums } else { sums.remove(0).into_iter().map(|sum| vec![sum]).collect() })
    }

    /// What is prepared of every body.
    fn prepared(&mut self, bodies: &Bodies<'_>, count: usize, motion: &Value) -> Outcome<Vec<Value>> {
        let Some(body_constants) = bodies.functions.get("body_constants") else {
            return foreign("no `body_constants`");
        };
        let own = motion.field("parameters")?.lifted(Kind::Plain);
        let mut prepared = Vec::new();
        self.with_self(own, |machine| {
            for body in 0..count {
                prepared.push(machine.call(body_constants, vec![Value::size(body)])?);
            }
            Ok(Value::Unit)
        })?;
        Ok(prepared.iter().map(|of| of.lifted(Kind::Wide)).collect())
    }

    /// The positions after a drift of each body.
    fn drifted(
        &mut self,
        bodies: &Bodies<'_>,
        momenta: &[Vec<Number>],
        positions: &[Vec<Number>],
        motion: &Value,
        [step, time]: [&Number; 2],
    ) -> Outcome<Vec<Vec<Number>>> {
        let Some(drift_body) = bodies.functions.get("drift_body").copied() else { return foreign("no `drift_body`") };
        let parameters = motion.field("parameters")?.clone();
        let mut moved = Vec::new();
        let prepared = self.prepared(bodies, momenta.len(), motion)?;
        for ((q, p), of) in positions.iter().zip(momenta).zip(prepared) {
            let slots = Value::list(q.iter().map(|number| Value::Slot(number.clone().of_kind(Kind::Wide))));
            let step = Value::from(step.clone().of_kind(Kind::Wide));
            let arguments = vec![parameters.clone(), slots, row(p), of, step, time.clone().into()];
            let (_, changed) = self.run(drift_body, arguments, Some(1))?;
            moved.push(components(&changed)?);
        }
        Ok(moved)
    }

    /// The gradient of the potential of bodies, in the order of one row of them.
    fn attracted(
        &mut self,
        bodies: &Bodies<'_>,
        read: &[Vec<Number>],
        motion: &Value,
        time: &Number,
    ) -> Outcome<Vec<Vec<Number>>> {
        let (parameters, time) = (motion.field("parameters")?.clone(), Value::from(time.clone()));
        let (prepared, count) = (self.prepared(bodies, read.len(), motion)?, read.len());
        let mut sums: Vec<Option<Vec<Number>>> = vec![None; count];
        if let Some(one_body) = bodies.functions.get("one_body").copied() {
            for (body, sum) in sums.iter_mut().enumerate() {
                let arguments = vec![parameters.clone(), row(&read[body]), prepared[body].clone(), time.clone()];
                if let Value::Option(Some(gradient)) = self.call(one_body, arguments)? {
                    *sum = Some(components(&gradient)?);
                }
            }
        }
        for by in (1..count).filter(|by| !bodies.reciprocal || 2 * by <= count) {
            let mut forces = Vec::with_capacity(count);
            for i in 0..count {
                let j = (i + by) % count;
                let two = [row(&read[i]), row(&read[j]), prepared[i].clone(), prepared[j].clone()];
                let arguments = std::iter::once(parameters.clone()).chain(two).chain([time.clone()]).collect();
                forces.push(self.force(bodies, [&read[i], &read[j]], arguments)?);
            }
            for (i, sum) in sums.iter_mut().enumerate() {
                let mut addend = forces[i].clone();
                if bodies.reciprocal && 2 * by != count {
                    let reaction = &forces[(i + count - by) % count];
                    addend = addend.iter().zip(reaction).map(|(action, reaction)| action.sub(reaction)).collect();
                }
                *sum = Some(match sum.take() {
                    Some(sum) => sum.iter().zip(&addend).map(|(sum, addend)| sum.add(addend)).collect(),
                    None => addend,
                });
            }
        }
        let zero = Number::plain(0.0).of_kind(Kind::Wide);
        let sums = sums.into_iter().zip(read).map(|(sum, own)| sum.unwrap_or_else(|| vec![zero.clone(); own.len()]));
        let mut sums = sums.collect::<Vec<_>>();
        self.add_triplets(bodies, read, &prepared, [&parameters, &time], &mut sums)?;
        Ok(sums)
    }

    /// Whether lists do not leave two bodies out.
    fn is_included(&mut self, bodies: &Bodies<'_>, arguments: Vec<Value>) -> Outcome<bool> {
        match bodies.functions.get("included").copied() {
            Some(included) => self.uncounted(|machine| machine.call(included, arguments))?.truth(),
            None => Ok(true),
        }
    }

    /// The gradient of the energy of two bodies by the coordinates of the first one.
    fn force(&mut self, bodies: &Bodies<'_>, [i, j]: [&[Number]; 2], arguments: Vec<Value>) -> Outcome<Vec<Number>> {
        let interacts = match bodies.functions.get("interacts").copied() {
            Some(interacts) => self.uncounted(|machine| machine.call(interacts, arguments.clone()))?.truth()?,
            None => true,
        };
        let Some(pair) = bodies.functions.get("pair").copied() else { return foreign("no `pair`") };
        let mut force = components(&self.call(pair, arguments.clone())?)?;
        if !self.is_included(bodies, arguments)? {
            force.fill(Number::plain(0.0).of_kind(Kind::Wide));
        }
        if !interacts && force.iter().any(|force| force.main.value != 0.0) {
            return foreign("a force where nothing interacts");
        }
        let dimension = i.len() as u64;
        self.done.coordinates += dimension * u64::from(bodies.central) + dimension * u64::from(bodies.reciprocal);
        self.done.multiplications += dimension * u64::from(bodies.central);
        let central = |(i, j): (&Number, &Number)| force[0].mul(&i.sub(j).of_kind(Kind::Wide));
        Ok(if bodies.central { i.iter().zip(j).map(central).collect() } else { force })
    }
}

/// The coordinates of a point, or the one of a site.
pub(crate) fn components(point: &Value) -> Outcome<Vec<Number>> {
    match point {
        Value::List(_) | Value::Slot(_) | Value::Number(_) => {
            let mut numbers = Vec::new();
            point.numbers(&mut numbers);
            Ok(numbers)
        }
        other => foreign(format!("{} in place of coordinates", other.kind())),
    }
}

/// Coordinates of bodies side by side.
pub(crate) fn row(point: &[Number]) -> Value {
    Value::list(point.iter().map(|number| number.clone().of_kind(Kind::Wide).into()))
}
