//! What the runtime does with loops in lanes, in its plainest form: iteration by iteration.

use crate::{
    drivers::{components, row},
    expansion::{constant, function},
    lists::{integer, structures, sums_of},
    machine::Machine,
    number::{Kind, Number},
    value::{Outcome, Value, argument, foreign, panic},
};
use syn::{Expr, ExprStruct, Lit, Member, UnOp};

impl Machine<'_> {
    /// A call of `Loop::run`.
    pub(crate) fn loop_in_lanes(&mut self, call: &syn::ExprMethodCall) -> Outcome<Value> {
        let Some(iteration) = self.term.clone() else { return foreign("a loop without iterations") };
        let run = self.expression(&call.receiver)?;
        let reads = structures(&iteration, "READS")?;
        let Some(next) = function(&iteration, "next") else { return foreign("an iteration without `next`") };
        let target = constant(&iteration, "TARGET").map_or(Ok(0), signed)?;
        let gradient = match call.args.first() {
            Some(Expr::Reference(empty)) if matches!(&*empty.expr, Expr::Array(_)) => None,
            Some(gradient) => Some(sums_of(gradient)?),
            None => return foreign("a loop without a gradient"),
        };
        let Value::Range(from, to) = run.field("range")?.clone() else { return foreign("a loop without a range") };
        let [parts, constants] = ["parts", "constants"].map(|name| run.field(name).and_then(Value::items));
        let (parts, constants) = (parts?, constants?);
        let common = run.field("common")?.lifted(Kind::Wide);
        let mut points = match gradient {
            Some((place, _)) => self.expression(place)?.items()?.to_vec(),
            None => Vec::new(),
        };
        let mut sums =
            Value::list((0..sums_of_type(&next.sig)?).map(|_| Number::plain(0.0).of_kind(Kind::Wide).into()));
        for number in from.value..to.value {
            let near = |offset: i128| match usize::try_from(number + offset) {
                Ok(place) => Ok(place),
                Err(_) => panic("a point before the first one"),
            };
            let mut read = Vec::new();
            for point in &reads {
                let offset = offset(point)?;
                read.push(row(&components(argument(parts, integer(point, "part")?)?.at(near(offset)?)?)?));
            }
            let own = constants.iter().map(|table| Ok(table.at(near(0)?)?.lifted(Kind::Wide)));
            let own = Value::list(own.collect::<Outcome<Vec<_>>>()?);
            let place = near(target)?;
            let moved = match gradient {
                Some(_) => match points.get(place) {
                    Some(point) => vec![row(&components(point)?)],
                    None => return panic("a point out of bounds"),
                },
                None => Vec::new(),
            };
            let arguments = vec![Value::list(read), own, common.clone(), sums, Value::list(moved)];
            let Value::Tuple(results) = self.call(next, arguments)? else {
                return foreign("an iteration without a pair");
            };
            sums = argument(&results, 0)?.clone();
            if let Some((_, is_flat)) = gradient {
                let point = argument(argument(&results, 1)?.items()?, 0)?.lifted(Kind::Scalar);
                points[place] = if is_flat { point.at(0)?.clone() } else { point };
            }
        }
        if let Some((place, _)) = gradient {
            self.store(place, Value::list(points))?;
        }
        Ok(sums.lifted(Kind::Scalar))
    }
}

/// The number of sums, from the type of the fourth argument: `[Wide; 2]`.
fn sums_of_type(signature: &syn::Signature) -> Outcome<usize> {
    match signature.inputs.iter().nth(3) {
        Some(syn::FnArg::Typed(typed)) => match &*typed.ty {
            syn::Type::Array(array) => Ok(signed(&array.len)? as usize),
            _ => foreign("sums that are no array"),
        },
        _ => foreign("an iteration without sums"),
    }
}

/// How far a point is from the iteration.
fn offset(near: &ExprStruct) -> Outcome<i128> {
    let value = near.fields.iter().find(|field| matches!(&field.member, Member::Named(name) if name == "offset"));
    value.map_or_else(|| foreign("a point without an offset"), |value| signed(&value.expr))
}

/// An integer, which may be below zero.
fn signed(expression: &Expr) -> Outcome<i128> {
    match expression {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(value) => value.base10_parse().or_else(|_| foreign("an offset that is no integer")),
            _ => foreign("an offset that is no integer"),
        },
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => Ok(-signed(&unary.expr)?),
        _ => foreign("an offset that is no integer"),
    }
}
