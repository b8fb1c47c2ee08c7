//! Calls by path, and methods of numbers, integers, truths and options.

use crate::{
    lists::chunk_length,
    machine::Machine,
    number::{Kind, Number},
    value::{Integer, IntegerType, Outcome, USIZE, Value, argument, foreign, panic},
};
use std::rc::Rc;
use syn::{BinOp, Expr, Type};

/// The last names of a path, without generics.
pub(crate) fn names_of(path: &syn::Path) -> Vec<String> {
    path.segments.iter().map(|segment| segment.ident.to_string()).collect()
}

/// What a type parameter of generated code stands for.
fn kind_of(name: &str) -> Option<Kind> {
    match name.trim_end_matches('_') {
        "Scalar" => Some(Kind::Scalar),
        "Wide" => Some(Kind::Wide),
        _ => None,
    }
}

/// A number of integers.
fn counted(value: i128) -> Value {
    Integer { value: value.max(0), of: Some(USIZE) }.into()
}

impl Machine<'_> {
    pub(crate) fn path(&mut self, path: &syn::Path) -> Outcome<Value> {
        if let Some(name) = path.get_ident()
            && let Some((_, value)) = self.names.iter().rev().find(|(known, _)| known == name)
        {
            return Ok(value.clone());
        }
        let names = names_of(path);
        let last = names.last().map_or("", String::as_str);
        if let Some(constant) = self.constants.get(last) {
            return Ok(constant.clone());
        }
        let constant = match last {
            "PI" => std::f64::consts::PI,
            "E" => std::f64::consts::E,
            "TAU" => std::f64::consts::TAU,
            "SQRT_2" => std::f64::consts::SQRT_2,
            "NAN" => f64::NAN,
            "INFINITY" => f64::INFINITY,
            "NEG_INFINITY" => f64::NEG_INFINITY,
            "EPSILON" => f64::EPSILON,
            "None" => return Ok(Value::Option(None)),
            "Some" => return Ok(Value::Path(names.join("::"))),
            _ if names.len() > 1 => return Ok(Value::Path(names.join("::"))),
            "Self" => return Ok(Value::Struct(Rc::default())),
            name => match self.structs.get(name) {
                Some(_) => return Ok(Value::Struct(Rc::default())),
                None => return foreign(format!("`{name}` is not known")),
            },
        };
        Ok(Value::plain(constant))
    }

    pub(crate) fn called(&mut self, call: &syn::ExprCall) -> Outcome<Value> {
        let Expr::Path(path) = &*call.func else {
            let function = self.expression(&call.func)?;
            let arguments = self.all(call.args.iter())?;
            return self.apply(&function, arguments);
        };
        if let Some(name) = path.path.get_ident()
            && let Some((_, function)) = self.names.iter().rev().find(|(known, _)| known == name).cloned()
        {
            let arguments = self.all(call.args.iter())?;
            return self.apply(&function, arguments);
        }
        let names = names_of(&path.path);
        match names.last().map_or("", String::as_str) {
            "from_fn" => self.array_from(given(&call.args, 0)?),
            "table" => self.table(given(&call.args, 0)?, given(&call.args, 1)?),
            "inner_products" | "add_multiples_of_rows" => self.products_of_rows(call),
            // Whether a list has an element is asked of the list.
            "Elements" => self.expression(given(&call.args, 0)?),
            // A reference is its value here, and a type the one that it has.
            "by_value" | "identity" => self.expression(given(&call.args, 0)?),
            _ => {
                let arguments = self.all(call.args.iter())?;
                // `<Scalar::Mask as runtime::Mask>::of`: the type is told before the trait.
                let joined = names.join("::");
                let name = if path.qself.is_some() && joined.ends_with("Mask::of") { "Mask::of" } else { &joined };
                self.call_path(name, arguments)
            }
        }
    }

    pub(crate) fn call_path(&mut self, path: &str, arguments: Vec<Value>) -> Outcome<Value> {
        let mut names = path.rsplit("::");
        let (last, before) = (names.next().unwrap_or_default(), names.next().unwrap_or_default());
        if let Some(kind) = kind_of(before) {
            self.done.branches += u64::from(last == "select");
            return Self::of_flow(kind, last, &arguments);
        }
        match (before, last, &arguments[..]) {
            // Where constants are prepared, what flows compute in is `f64`.
            ("f64", "of", [value @ Value::Number(_)]) => Ok(value.clone()),
            ("runtime", "repeated", [length, element]) => {
                Ok(Value::list(std::iter::repeat_n(element.clone(), length.index()?)))
            }
            ("slice", "from_mut", [value]) => Ok(Value::list([value.clone()])),
            ("Mask", "of", [Value::Bool(holds)]) => Ok(Value::Mask(*holds)),
            (_, "Some", [value]) => Ok(Value::Option(Some(Rc::new(value.clone())))),
            ("f64", "from", [Value::Bool(truth)]) => Ok(Value::plain(f64::from(u8::from(*truth)))),
            ("f64", "from", [Value::Integer(integer)]) => Ok(Value::plain(integer.value as f64)),
            ("f64", "from", [value @ Value::Number(_)]) => Ok(value.clone()),
            ("Box" | "Arc" | "Rc", "new", [value]) => Ok(value.clone()),
            (_, "like", [Value::Integer(other), Value::Integer(integer)]) => {
                let value = other.of.map_or(integer.value, |of| of.wrapped(integer.value));
                Ok(Integer { value, of: other.of }.into())
            }
            (_, "bound", [Value::Integer(end)]) => Ok(counted(end.value)),
            (_, "bound_through", [Value::Integer(last)]) => Ok(counted(last.value + 1)),
            (_, "span", [Value::Integer(first), Value::Integer(end)]) => Ok(counted(end.value - first.value)),
            (_, "span_through", [Value::Integer(first), Value::Integer(last)]) => {
                Ok(counted(last.value - first.value + 1))
            }
            (_, "wrapped", [Value::Integer(integer)]) => {
                Ok(Integer { value: USIZE.wrapped(integer.value), of: Some(USIZE) }.into())
            }
            ("f64" | "Ord", name, [receiver, rest @ ..]) => self.method_of(receiver.clone(), name, rest.to_vec()),
            (of, "from", [Value::Integer(integer)]) if IntegerType::named(of).is_some() => {
                Ok(Integer { of: IntegerType::named(of), ..*integer }.into())
            }
            (of, name, [receiver, rest @ ..]) if IntegerType::named(of).is_some() => {
                self.method_of(receiver.clone(), name, rest.to_vec())
            }
            (_, name, _) => match self.functions.get(name) {
                Some(function) => {
                    let function = *function;
                    self.call(function, arguments)
                }
                None => foreign(format!("a call of `{path}`")),
            },
        }
    }

    /// What the runtime's numbers make of plain ones, and of each other.
    fn of_flow(kind: Kind, name: &str, arguments: &[Value]) -> Outcome<Value> {
        match (name, arguments) {
            ("of", [Value::Number(number)]) if number.kind == Kind::Plain => Ok(number.clone().of_kind(kind).into()),
            ("least", []) => Ok(Number::plain(2.0_f64.powi(-511)).of_kind(kind).into()),
            ("huge", []) => Ok(Number::plain(2.0_f64.powi(896)).of_kind(kind).into()),
            ("splat", [Value::Number(number)]) if number.kind == Kind::Scalar => {
                Ok(number.clone().of_kind(kind).into())
            }
            ("select", [mask, Value::Number(a), Value::Number(b)]) if a.kind == kind && b.kind == kind => {
                Ok(if mask.mask()? { a.clone() } else { b.clone() }.into())
            }
            _ => foreign(format!("`{name}` of {kind:?} with {} arguments", arguments.len())),
        }
    }

    /// An array whose length its type tells.
    fn array_from(&mut self, element: &Expr) -> Outcome<Value> {
        let Some(Type::Array(array)) = self.expected.clone() else { return foreign("an array of no known length") };
        let count = self.expression(&array.len)?.index()?;
        let element = self.expression(element)?;
        let outer = self.expected.replace(*array.elem);
        let elements =
            (0..count).map(|place| self.apply(&element, vec![Value::size(place)])).collect::<Outcome<Vec<_>>>();
        self.expected = outer;
        Ok(Value::list(elements?))
    }

    /// A table of prepared constants.
    fn table(&mut self, count: &Expr, element: &Expr) -> Outcome<Value> {
        let count = self.expression(count)?.index()?;
        let element = self.expression(element)?;
        let inner = self.expected.as_ref().and_then(argument_of);
        let outer = std::mem::replace(&mut self.expected, inner);
        let elements =
            (0..count).map(|place| self.apply(&element, vec![Value::size(place)])).collect::<Outcome<Vec<_>>>();
        self.expected = outer;
        Ok(Value::list(elements?))
    }

    pub(crate) fn structure(&mut self, literal: &syn::ExprStruct) -> Outcome<Value> {
        let name = names_of(&literal.path).pop().unwrap_or_default();
        let declared = self.structs.get(&name).copied();
        let mut fields = Vec::new();
        for field in &literal.fields {
            let syn::Member::Named(name) = &field.member else { return foreign("a struct without names") };
            let kind = declared.and_then(|item| item.fields.iter().find(|known| known.ident.as_ref() == Some(name)));
            let outer = std::mem::replace(&mut self.expected, kind.map(|known| known.ty.clone()));
            let value = self.expression(&field.expr);
            self.expected = outer;
            fields.push((name.to_string(), value?));
        }
        Ok(Value::Struct(Rc::new(fields)))
    }

    pub(crate) fn invoked(&mut self, found: &syn::Macro) -> Outcome<Value> {
        let name = names_of(&found.path).pop().unwrap_or_default();
        let parse = syn::punctuated::Punctuated::<Expr, syn::Token![,]>::parse_terminated;
        match name.as_str() {
            "vec" => match found.parse_body_with(parse) {
                Ok(elements) => Ok(Value::list(self.all(elements.iter())?)),
                Err(_) => foreign("this `vec!`"),
            },
            "matches" => foreign("`matches!`"),
            "panic" | "unreachable" => panic("the text panics"),
            _ => foreign(format!("`{name}!`")),
        }
    }

    pub(crate) fn method(&mut self, call: &syn::ExprMethodCall) -> Outcome<Value> {
        let name = call.method.to_string();
        if let Some(result) = self.driver(call, &name) {
            return result;
        }
        let receiver = self.expression(&call.receiver)?;
        if let Value::Slot(slot) = &receiver {
            return match &name[..] {
                "value" => Ok(slot.clone().into()),
                "add" => {
                    let by = self.expression(given(&call.args, 0)?)?;
                    self.done.coordinates += 1;
                    self.update(&call.receiver, by.number()?)?;
                    Ok(Value::Unit)
                }
                "fma" | "scale_add" => {
                    let arguments = self.all(call.args.iter())?;
                    let [a, b] = [argument(&arguments, 0)?.number()?, argument(&arguments, 1)?.number()?];
                    if a.kind != b.kind {
                        return foreign("factors of two kinds");
                    }
                    self.count_move(call);
                    self.fuse(&call.receiver, a, b)?;
                    Ok(Value::Unit)
                }
                _ => foreign(format!("`{name}` of a slot")),
            };
        }
        if name == "as_chunks" {
            let (items, length) = (receiver.items()?, chunk_length(call)?);
            let chunks = items.chunks_exact(length);
            let rest = Value::list(chunks.remainder().iter().cloned());
            return Ok(Value::tuple([Value::list(chunks.map(|chunk| Value::list(chunk.iter().cloned()))), rest]));
        }
        let arguments = self.all(call.args.iter())?;
        if let Value::Told = &receiver {
            self.told.push((name, arguments));
            return Ok(Value::Unit);
        }
        let is_self = matches!(&*call.receiver, Expr::Path(path) if path.path.is_ident("self"));
        if is_self {
            return match self.functions.get(&name).copied() {
                Some(function) => self.call(function, arguments),
                None => foreign(format!("no method `{name}`")),
            };
        }
        let value = self.method_of(receiver, &name, arguments)?;
        if ["scale", "fma", "scale_add"].contains(&&name[..]) {
            self.count_product([&call.receiver, given(&call.args, 0)?]);
        }
        Ok(value)
    }

    pub(crate) fn method_of(&mut self, receiver: Value, name: &str, arguments: Vec<Value>) -> Outcome<Value> {
        match (&receiver, name) {
            (receiver, "clone" | "to_owned" | "copied" | "as_ref") if !matches!(receiver, Value::Sequence(_)) => {
                Ok(receiver.clone())
            }
            (Value::Number(number), _) => self.of_number(number, name, &arguments),
            (Value::Integer(integer), _) => Self::of_integer(*integer, name, &arguments),
            (Value::Torn, _) => receiver.of_torn(name, &arguments),
            (Value::Mask(mask), "and" | "or") if matches!(arguments.first(), Some(Value::Torn)) => {
                Ok(if *mask == (name == "and") { Value::Torn } else { receiver.clone() })
            }
            (Value::Mask(mask), "any") => Ok(Value::Bool(*mask)),
            (Value::Mask(mask), "not") => Ok(Value::Mask(!mask)),
            (Value::Mask(mask), "and") => Ok(Value::Mask(mask & argument(&arguments, 0)?.mask()?)),
            (Value::Mask(mask), "or") => Ok(Value::Mask(mask | argument(&arguments, 0)?.mask()?)),
            (Value::Option(option), "is_some") => Ok(Value::Bool(option.is_some())),
            (Value::Option(option), "is_none") => Ok(Value::Bool(option.is_none())),
            (Value::Option(option), "unwrap_or") => {
                let other = argument(&arguments, 0)?;
                Ok(option.as_ref().map_or_else(|| other.clone(), |value| (**value).clone()))
            }
            (Value::Option(option), "unwrap_or_default") => {
                Ok(option.as_ref().map_or_else(|| Value::list([]), |value| (**value).clone()))
            }
            (Value::Option(option), "unwrap" | "expect") => match option {
                Some(value) => Ok((**value).clone()),
                None => panic("`unwrap` of nothing"),
            },
            (Value::Site(site), _) => site.clone().method(name, &arguments),
            _ => self.of_sequence(receiver, name, arguments),
        }
    }

    fn of_number(&mut self, number: &Number, name: &str, arguments: &[Value]) -> Outcome<Value> {
        self.count_method(name);
        let alike = |value: &Value| match value {
            Value::Number(other) if other.kind == number.kind => Ok(other.clone()),
            other => foreign(format!("{} of another type as an argument of `{name}`", other.kind())),
        };
        Ok(match (name, arguments) {
            ("powi", [exponent]) => {
                let exponent = exponent.integer()?;
                if exponent.of.is_some_and(|of| of.name != "i32") {
                    return foreign("`powi` of another integer than i32");
                }
                number.powi(exponent.value as i32).into()
            }
            ("square", []) => number.mul(number).into(),
            ("square_add", [c]) => number.fma(number, &alike(c)?).into(),
            ("square_from", [c]) => number.neg().fma(number, &alike(c)?).into(),
            ("scale", [x]) => number.mul(&alike(x)?).into(),
            ("fma" | "scale_add" | "mul_add", [b, c]) => number.fma(&alike(b)?, &alike(c)?).into(),
            ("powf" | "fast_powf", [exponent]) => number.powf(&alike(exponent)?).into(),
            ("atan2" | "fast_atan2", [x]) => number.atan2(&alike(x)?).into(),
            ("hypot", [x]) => number.hypot(&alike(x)?).into(),
            ("remainder", [by]) => number.rem(&alike(by)?).into(),
            ("min", [other]) => number.extreme(&alike(other)?, f64::min).into(),
            ("max", [other]) => number.extreme(&alike(other)?, f64::max).into(),
            ("clamp", [low, high]) => {
                let (low, high) = (alike(low)?, alike(high)?);
                if low.main.value > high.main.value || low.main.value.is_nan() || high.main.value.is_nan() {
                    return panic("`clamp` between bounds in the wrong order");
                }
                // `clamp` keeps a NaN, `max` and `min` do not.
                if number.main.value.is_nan() {
                    return Ok(number.clone().into());
                }
                number.extreme(&low, f64::max).extreme(&high, f64::min).into()
            }
            ("log", [base]) => {
                let [x, base] = [number.function("ln"), alike(base)?.function("ln")];
                x.zip(base).map_or(Value::Unit, |(x, base)| x.div(&base).into())
            }
            ("rem_euclid", [by]) => {
                let by = alike(by)?;
                let reduced = number.rem(&by);
                self.on_edge |= reduced.main.is_near(0.0.into());
                let below = reduced.main.value < 0.0;
                (if below { reduced.add(&Number::plain(by.main.value.abs()).of_kind(number.kind)) } else { reduced })
                    .into()
            }
            ("sin_cos", []) => {
                let both = [number.function("sin"), number.function("cos")];
                Value::tuple(both.into_iter().flatten().map(Value::from))
            }
            ("fast_sin_cos", []) => return self.of_number(number, "sin_cos", &[]),
            ("div_sqrt", [x]) => match alike(x)?.function("sqrt") {
                Some(root) => number.div(&root).into(),
                None => Value::Unit,
            },
            ("div_pow_3_2", [x]) => {
                let x = alike(x)?;
                match x.function("sqrt") {
                    Some(root) => number.div(&x.mul(&root)).into(),
                    None => Value::Unit,
                }
            }
            ("less", [b]) => self.mask(BinOp::Lt(Default::default()), number, &alike(b)?)?,
            ("less_or_equal", [b]) => self.mask(BinOp::Le(Default::default()), number, &alike(b)?)?,
            ("equal", [b]) => self.mask(BinOp::Eq(Default::default()), number, &alike(b)?)?,
            ("is_nan", []) => Value::Bool(number.main.value.is_nan()),
            ("is_finite", []) => Value::Bool(number.main.value.is_finite()),
            (_, []) => match number.function(name) {
                Some(result) => {
                    let jumps =
                        ["floor", "ceil", "round", "round_ties_even", "trunc", "fract", "signum"].contains(&name);
                    self.on_edge |= jumps && !result.main.is_known() && number.main.is_known();
                    result.into()
                }
                None => return foreign(format!("`{name}` of a number")),
            },
            _ => return foreign(format!("`{name}` of a number")),
        })
    }

    fn of_integer(integer: Integer, name: &str, arguments: &[Value]) -> Outcome<Value> {
        let Integer { value: a, of } = integer;
        let other = || -> Outcome<(i128, Option<IntegerType>)> {
            let other = argument(arguments, 0)?.integer()?;
            Ok((other.value, integer.common(other)?))
        };
        let fitted = |value: i128, of: Option<IntegerType>| {
            let range = of.or_else(|| IntegerType::named("i32")).unwrap_or(USIZE);
            Integer { value: value.clamp(range.from, range.to), of }
        };
        let wrapped = |value: i128, of: Option<IntegerType>| {
            let range = of.or_else(|| IntegerType::named("i32")).unwrap_or(USIZE);
            Integer { value: range.wrapped(value), of }
        };
        let result = match name {
            "saturating_sub" => other().map(|(b, of)| fitted(a - b, of))?,
            "saturating_add" => other().map(|(b, of)| fitted(a + b, of))?,
            "wrapping_sub" => other().map(|(b, of)| wrapped(a - b, of))?,
            "wrapping_add" => other().map(|(b, of)| wrapped(a + b, of))?,
            "abs_diff" => other().map(|(b, of)| Integer { value: (a - b).abs(), of })?,
            "min" => other().map(|(b, of)| Integer { value: a.min(b), of })?,
            "max" => other().map(|(b, of)| Integer { value: a.max(b), of })?,
            "rem_euclid" => match other()? {
                (0, _) => return panic("a remainder by zero"),
                (b, of) => Integer { value: a.rem_euclid(b), of },
            },
            "pow" => {
                let (b, _) = other()?;
                Integer::checked(u32::try_from(b).ok().and_then(|b| a.checked_pow(b)), of)?
            }
            "abs" => Integer { value: a.abs(), of },
            _ => return foreign(format!("`{name}` of an integer")),
        };
        Ok(result.into())
    }
}

/// The type argument of `Vec<T>`.
fn argument_of(kind: &Type) -> Option<Type> {
    let Type::Path(path) = kind else { return None };
    let syn::PathArguments::AngleBracketed(arguments) = &path.path.segments.last()?.arguments else { return None };
    arguments.args.iter().find_map(|argument| match argument {
        syn::GenericArgument::Type(inner) => Some(inner.clone()),
        _ => None,
    })
}

/// An argument of a call.
fn given(arguments: &syn::punctuated::Punctuated<Expr, syn::Token![,]>, place: usize) -> Outcome<&Expr> {
    match arguments.iter().nth(place) {
        Some(argument) => Ok(argument),
        None => foreign("an argument is missing"),
    }
}
