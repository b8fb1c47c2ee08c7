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
        let gradients = match call.args.first() {
            Some(Expr::Reference(empty)) if matches!(&*empty.expr, Expr::Array(_)) => Vec::new(),
            Some(gradient) if call.method == "run" => {
                let (place, group) = sums_of(gradient)?;
                vec![Gradient { place: place.clone(), from: 0, group }]
            }
            Some(several) => self.several(several)?,
            None => return foreign("a loop without a gradient"),
        };
        let Value::Range(from, to) = run.field("range")?.clone() else { return foreign("a loop without a range") };
        let [parts, constants] = ["parts", "constants"].map(|name| run.field(name).and_then(Value::items));
        let (parts, constants) = (parts?, constants?);
        let common = run.field("common")?.lifted(Kind::Wide);
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
            let mut moved = Vec::new();
            for gradient in &gradients {
                let numbers = self.expression(&gradient.place)?.items()?.to_vec();
                moved.push(row(&components(&gradient.point(&numbers, place)?)?));
            }
            let arguments = vec![Value::list(read), own, common.clone(), sums, Value::list(moved)];
            let Value::Tuple(results) = self.call(next, arguments)? else {
                return foreign("an iteration without a pair");
            };
            sums = argument(&results, 0)?.clone();
            for (gradient, point) in gradients.iter().zip(argument(&results, 1)?.items()?) {
                let mut numbers = self.expression(&gradient.place)?.items()?.to_vec();
                gradient.set(&mut numbers, place, &point.lifted(Kind::Scalar))?;
                self.store(&gradient.place, Value::list(numbers))?;
            }
        }
        Ok(sums.lifted(Kind::Scalar))
    }
}

/// A gradient that iterations add to.
struct Gradient {
    place: Expr,
    /// The index of the first number or point that belongs to it.
    from: usize,
    /// How many numbers are a point, if points are no lists of their own.
    group: Option<usize>,
}

impl Gradient {
    fn numbers(&self, place: usize) -> std::ops::Range<usize> {
        let length = self.group.unwrap_or(1);
        self.from + length * place..self.from + length * (place + 1)
    }

    fn point(&self, numbers: &[Value], place: usize) -> Outcome<Value> {
        match (numbers.get(self.numbers(place)), self.group) {
            (Some([point]), None) => Ok(point.clone()),
            (Some(numbers), Some(_)) => Ok(Value::list(numbers.iter().cloned())),
            _ => panic("a point out of bounds"),
        }
    }

    fn set(&self, numbers: &mut [Value], place: usize, point: &Value) -> Outcome<()> {
        let range = self.numbers(place);
        match self.group {
            None => numbers[range.start] = point.clone(),
            Some(_) => numbers[range].clone_from_slice(point.items()?),
        }
        Ok(())
    }
}

impl Machine<'_> {
    /// Both parts of a gradient, `apart(&mut gradient[..], from)`, or these as chunks; or the results of all iterations,
    /// `results.each_mut()`, as chunks.
    fn several(&mut self, several: &Expr) -> Outcome<Vec<Gradient>> {
        let (several, group) = match several {
            Expr::MethodCall(map) if map.method == "map" => match map.args.first() {
                Some(Expr::Closure(chunks)) => (&*map.receiver, sums_of(&chunks.body)?.1),
                _ => return foreign("chunks of a gradient"),
            },
            several => (several, None),
        };
        match several {
            Expr::MethodCall(each) if each.method == "each_mut" => {
                let (list, count) = (&each.receiver, self.expression(&each.receiver)?.items()?.len());
                Ok((0..count).map(|n| Gradient { place: syn::parse_quote!(#list[#n]), from: 0, group }).collect())
            }
            Expr::Call(call) => {
                let (Some(gradient), Some(from)) = (call.args.first(), call.args.get(1)) else {
                    return foreign("parts of no gradient");
                };
                let (place, from) = (sums_of(gradient)?.0.clone(), self.expression(from)?.index()?);
                Ok([0, from].map(|from| Gradient { place: place.clone(), from, group }).into())
            }
            _ => foreign("parts of a gradient"),
        }
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
