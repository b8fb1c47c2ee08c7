//! What the runtime does with sums over lists, in its plainest form: term by term, and the addends of each in their order.

use crate::{
    drivers::{components, row},
    expansion::{constant, function},
    machine::Machine,
    number::Kind,
    value::{Outcome, Value, argument, foreign, panic},
};
use std::rc::Rc;
use syn::{Expr, ExprStruct, ItemImpl, Lit, Member};

/// The term of a sum: `Term` as it is written in front of the sum.
pub(crate) type Term = Rc<ItemImpl>;

impl Machine<'_> {
    /// A call of `Terms::add_to`.
    pub(crate) fn list_sum(&mut self, call: &syn::ExprMethodCall) -> Outcome<Value> {
        let Some(term) = self.term.clone() else { return foreign("a sum over a list without a term") };
        let terms = self.expression(&call.receiver)?;
        let reads = structures(&term, "READS")?;
        let addends = structures(&term, "ADDENDS")?;
        let Some(values) = function(&term, "values") else { return foreign("a term without values") };
        let (place, is_flat) = match call.args.first() {
            Some(sums) => sums_of(sums)?,
            None => return foreign("a sum without a place"),
        };
        let Value::Range(from, to) = terms.field("range")?.clone() else { return foreign("terms without a range") };
        let [lists, parts] = ["lists", "parts"].map(|name| terms.field(name).and_then(Value::items));
        let (lists, parts) = (lists?, parts?);
        let common = terms.field("common")?.lifted(Kind::Wide);
        let mut sums = self.expression(place)?.items()?.to_vec();
        for number in from.value..to.value {
            let number = number as usize;
            let point = |list: usize| argument(lists, list)?.at(number)?.index();
            let mut points = Vec::new();
            for read in &reads {
                let read_from = argument(parts, integer(read, "part")?)?;
                points.push(row(&components(read_from.at(point(integer(read, "list")?)?)?)?));
            }
            let constants = terms.field("constants")?.items()?.iter();
            let constants = constants.map(|table| Ok(table.at(number)?.lifted(Kind::Wide)));
            let constants = Value::list(constants.collect::<Outcome<Vec<_>>>()?);
            let results = self.call(values, vec![Value::list(points), constants, common.clone()])?;
            for addend in &addends {
                let value = results.at(integer(addend, "value")?)?.number()?.clone().of_kind(Kind::Scalar);
                let sum = part_of(
                    &mut sums,
                    point(integer(addend, "list")?)?,
                    integer(addend, "component")?,
                    is_flat.is_some(),
                )?;
                let before = sum.number()?;
                self.done.coordinates += 1;
                *sum = if truth(addend, "negative")? { before.sub(&value) } else { before.add(&value) }.into();
            }
        }
        self.store(place, Value::list(sums))?;
        Ok(Value::Unit)
    }
}

/// The structs in a constant that is an array of them.
pub(crate) fn structures<'t>(term: &'t Term, name: &str) -> Outcome<Vec<&'t ExprStruct>> {
    let array = match constant(term, name) {
        Some(Expr::Reference(reference)) => Some(&*reference.expr),
        found => found,
    };
    let Some(Expr::Array(array)) = array else { return foreign(format!("a term without an array `{name}`")) };
    let structures = array.elems.iter().map(|element| match element {
        Expr::Struct(literal) => Ok(literal),
        _ => foreign(format!("an element of `{name}`")),
    });
    structures.collect()
}

fn literal<'t>(literal: &'t ExprStruct, name: &str) -> Outcome<&'t Lit> {
    let value = literal.fields.iter().find_map(|field| match (&field.member, &field.expr) {
        (Member::Named(known), Expr::Lit(value)) if known == name => Some(&value.lit),
        _ => None,
    });
    value.map_or_else(|| foreign(format!("no `{name}`")), Ok)
}

pub(crate) fn integer(of: &ExprStruct, name: &str) -> Outcome<usize> {
    match literal(of, name)? {
        Lit::Int(value) => value.base10_parse().or_else(|_| foreign(format!("`{name}` that is no size"))),
        _ => foreign(format!("`{name}` that is no size")),
    }
}

fn truth(of: &ExprStruct, name: &str) -> Outcome<bool> {
    match literal(of, name)? {
        Lit::Bool(value) => Ok(value.value),
        _ => foreign(format!("`{name}` that is no truth")),
    }
}

/// The buffer that sums go to, and how many of its numbers are a point if these are no lists of their own.
pub(crate) fn sums_of(sums: &Expr) -> Outcome<(&Expr, Option<usize>)> {
    match sums {
        // `&mut gradient[..]`
        Expr::Reference(reference) => match &*reference.expr {
            Expr::Index(index) => Ok((&index.expr, None)),
            _ => foreign("a place of sums"),
        },
        // `gradient.as_chunks_mut::<1>().0`
        Expr::Field(field) => match &*field.base {
            Expr::MethodCall(chunks) if chunks.method == "as_chunks_mut" => {
                Ok((&chunks.receiver, Some(chunk_length(chunks)?)))
            }
            _ => foreign("a place of sums"),
        },
        _ => foreign("a place of sums"),
    }
}

/// `2` of `as_chunks::<2>()`.
pub(crate) fn chunk_length(call: &syn::ExprMethodCall) -> Outcome<usize> {
    let length = call.turbofish.as_ref().and_then(|turbofish| match turbofish.args.first() {
        Some(syn::GenericArgument::Const(Expr::Lit(literal))) => match &literal.lit {
            Lit::Int(length) => length.base10_parse().ok(),
            _ => None,
        },
        _ => None,
    });
    length.map_or_else(|| foreign("chunks without a length"), Ok)
}

/// The sum of a component of a point.
fn part_of(sums: &mut [Value], point: usize, component: usize, is_flat: bool) -> Outcome<&mut Value> {
    let Some(sum) = sums.get_mut(point) else { return panic("a point out of bounds") };
    match sum {
        sum if is_flat && component == 0 => Ok(sum),
        Value::List(components) => match Rc::make_mut(components).get_mut(component) {
            Some(sum) => Ok(sum),
            None => foreign("a component that a point lacks"),
        },
        _ => foreign("sums of another shape"),
    }
}
