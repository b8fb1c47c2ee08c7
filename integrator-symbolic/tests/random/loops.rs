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
        let keeps_results =
            matches!(call.args.first(), Some(Expr::Reference(several)) if matches!(&*several.expr, Expr::Block(_)));
        let Value::Range(from, to) = run.field("range")?.clone() else { return foreign("a loop without a range") };
        let [parts, constants] = ["parts", "constants"].map(|name| run.field(name).and_then(Value::items));
        let (parts, constants) = (parts?, constants?);
        let common = run.field("common")?.lifted(Kind::Wide);
        let mut sums =
            Value::list((0..sums_of_type(&next.sig)?).map(|_| Number::plain(0.0).of_kind(Kind::Wide).into()));
        for number in from.value..to.value {
            let near = |offset: i128| place(number + offset);
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
            self.keeps_results = keeps_results;
            let results = self.call(next, arguments);
            self.keeps_results = false;
            let Value::Tuple(results) = results? else {
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

    /// A call of `Loop::inner_product` or `Loop::add_multiples`.
    pub(crate) fn products(&mut self, call: &syn::ExprMethodCall) -> Outcome<Value> {
        let run = self.expression(&call.receiver)?;
        let [parts, constants, common, range] = ["parts", "constants", "common", "range"].map(|name| run.field(name));
        let (Some(offset), table) = (call.args.first(), argument(constants?.items()?, 0)?.clone()) else {
            return foreign("products without an offset");
        };
        let row = Row { table, range: range?.clone(), offset: signed(offset)? };
        match call.args.get(1) {
            None => self.inner_product(&row, argument(parts?.items()?, 0)?),
            Some(gradient) => self.add_multiples(&row, argument(common?.items()?, 0)?, gradient),
        }
    }

    /// A call of `inner_products` or `add_multiples_of_rows`.
    pub(crate) fn products_of_rows(&mut self, call: &syn::ExprCall) -> Outcome<Value> {
        let arguments: Vec<&Expr> = call.args.iter().collect();
        let [table, range, offset, read, Expr::Reference(syn::ExprReference { expr: to, .. })] = arguments[..] else {
            let [table, range, offset, factors, gradient] = arguments[..] else {
                return foreign("products of rows with other arguments");
            };
            let [table, range, factors] = [table, range, factors].map(|argument| self.expression(argument));
            let (table, range, offset) = (table?, range?, signed(offset)?);
            for (number, factor) in factors?.items()?.iter().enumerate() {
                let row = Row { table: table.at(number)?.clone(), range: range.clone(), offset };
                self.add_multiples(&row, factor, gradient)?;
            }
            return Ok(Value::Unit);
        };
        let [table, range, read] = [table, range, read].map(|argument| self.expression(argument));
        let (table, range, read, offset) = (table?, range?, read?, signed(offset)?);
        let count = self.expression(to)?.items()?.len();
        let products = (0..count).map(|number| {
            let row = Row { table: table.at(number)?.clone(), range: range.clone(), offset };
            self.inner_product(&row, &read)
        });
        let products = Value::list(products.collect::<Outcome<Vec<_>>>()?);
        self.store(to, products)?;
        Ok(Value::Unit)
    }

    fn inner_product(&mut self, of: &Row, coordinates: &Value) -> Outcome<Value> {
        let mut sum: Value = Number::plain(0.0).of_kind(Kind::Scalar).into();
        for (constant, near) in of.entries()? {
            let read = row(&components(coordinates.at(near)?)?).lifted(Kind::Scalar);
            sum = self.method_of(constant, "scale_add", vec![argument(read.items()?, 0)?.clone(), sum])?;
        }
        Ok(sum)
    }

    fn add_multiples(&mut self, of: &Row, factor: &Value, gradient: &Expr) -> Outcome<Value> {
        let (to, group) = sums_of(gradient)?;
        let gradient = Gradient { place: to.clone(), from: 0, group };
        for (constant, near) in of.entries()? {
            let mut numbers = self.expression(&gradient.place)?.items()?.to_vec();
            let before = argument(gradient.point(&numbers, near)?.items()?, 0)?.clone();
            let after = self.method_of(constant, "scale_add", vec![factor.lifted(Kind::Scalar), before])?;
            self.count_addition_to_gradient();
            gradient.set(&mut numbers, near, &Value::list([after]))?;
            self.store(&gradient.place, Value::list(numbers))?;
        }
        Ok(Value::Unit)
    }
}

/// A row of constants, the range of those that are multiplied, and how far coordinates are from these.
struct Row {
    table: Value,
    range: Value,
    offset: i128,
}

impl Row {
    /// The constants, each with the index of its coordinate.
    fn entries(&self) -> Outcome<Vec<(Value, usize)>> {
        let Value::Range(from, to) = &self.range else { return foreign("a row without a range") };
        let entry =
            |number: i128| Ok((self.table.at(place(number)?)?.lifted(Kind::Scalar), place(number + self.offset)?));
        (from.value..to.value).map(entry).collect()
    }
}

/// A place that is not before the first one.
fn place(number: i128) -> Outcome<usize> {
    match usize::try_from(number) {
        Ok(place) => Ok(place),
        Err(_) => panic("a point before the first one"),
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
    /// Both parts of a gradient, `apart(&mut gradient[..], from)` or `groups_apart` of those, as chunks; or the results of all
    /// iterations, a block with `let [results_0] = &mut results`, as chunks.
    fn several(&mut self, several: &Expr) -> Outcome<Vec<Gradient>> {
        let Expr::Reference(several) = several else { return foreign("parts of a gradient that are no reference") };
        match &*several.expr {
            Expr::Block(block) => {
                let Some(syn::Stmt::Local(syn::Local { init: Some(results), .. })) = block.block.stmts.first() else {
                    return foreign("results without a name");
                };
                let Expr::Reference(list) = &*results.expr else { return foreign("results that are no reference") };
                let (list, count) = (&list.expr, self.expression(&list.expr)?.items()?.len());
                let gradient = |n: usize| Gradient { place: syn::parse_quote!(#list[#n]), from: 0, group: Some(1) };
                Ok((0..count).map(gradient).collect())
            }
            Expr::Call(call) => {
                let group = group_of(call)?;
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

/// The numbers of a point, `2` of `groups_apart::<_, 2>(..)`; `None` of `apart(..)`.
fn group_of(call: &syn::ExprCall) -> Outcome<Option<usize>> {
    let Expr::Path(path) = &*call.func else { return foreign("parts of a gradient") };
    let arguments = path.path.segments.last().map(|last| &last.arguments);
    let Some(syn::PathArguments::AngleBracketed(types)) = arguments else { return Ok(None) };
    match types.args.last() {
        Some(syn::GenericArgument::Const(count)) => Ok(Some(signed(count)? as usize)),
        _ => foreign("points of no length"),
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
