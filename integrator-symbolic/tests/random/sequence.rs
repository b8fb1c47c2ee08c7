//! Iterators and slices: adaptors are those of `std`, over elements that are evaluated when they are asked for.

use crate::{
    machine::Machine,
    value::{Element, Integer, Outcome, Value, argument, foreign, panic},
};
use std::rc::Rc;
use syn::BinOp;

impl Machine<'_> {
    /// The elements of whatever can be iterated over.
    pub(crate) fn elements(source: &Value) -> Outcome<Vec<Element>> {
        Ok(match source {
            Value::Sequence(elements) => elements.to_vec(),
            Value::List(items) => items.iter().cloned().map(Element::Ready).collect(),
            Value::Option(option) => option.iter().map(|value| Element::Ready((**value).clone())).collect(),
            Value::Range(from, to) => {
                let number = |value| Element::Ready(Integer { value, of: from.of }.into());
                (from.value..to.value).map(number).collect()
            }
            other => return foreign(format!("an iteration over {}", other.kind())),
        })
    }

    pub(crate) fn evaluated(&mut self, element: &Element) -> Outcome<Value> {
        match element {
            Element::Ready(value) => Ok(value.clone()),
            Element::Mapped(function, inner) => {
                let value = self.evaluated(inner)?;
                self.apply(function, vec![value])
            }
            Element::Both(a, b) => Ok(Value::tuple([self.evaluated(a)?, self.evaluated(b)?])),
        }
    }

    pub(crate) fn of_sequence(&mut self, receiver: Value, name: &str, arguments: Vec<Value>) -> Outcome<Value> {
        if let Value::List(items) = &receiver
            && let Some(result) = Self::of_slice(items, name, &arguments)
        {
            return result;
        }
        let elements = Self::elements(&receiver)?;
        let count = || argument(&arguments, 0).and_then(Value::index);
        let transformed: Vec<Element> = match name {
            "iter" | "into_iter" | "cloned" | "copied" | "by_ref" => elements,
            "rev" => elements.into_iter().rev().collect(),
            "skip" => elements.into_iter().skip(count()?).collect(),
            "take" => elements.into_iter().take(count()?).collect(),
            "step_by" => match count()? {
                0 => return panic("`step_by` with zero"),
                step => elements.into_iter().step_by(step).collect(),
            },
            "enumerate" => {
                let numbered =
                    |(place, element)| Element::Both(Rc::new(Element::Ready(Value::size(place))), Rc::new(element));
                elements.into_iter().enumerate().map(numbered).collect()
            }
            "zip" => {
                let others = Self::elements(argument(&arguments, 0)?)?;
                let both = |(a, b)| Element::Both(Rc::new(a), Rc::new(b));
                elements.into_iter().zip(others).map(both).collect()
            }
            "chain" => elements.into_iter().chain(Self::elements(argument(&arguments, 0)?)?).collect(),
            "map" => {
                let function = argument(&arguments, 0)?;
                let mapped = |element| Element::Mapped(function.clone(), Rc::new(element));
                elements.into_iter().map(mapped).collect()
            }
            "filter" => {
                let mut kept = Vec::new();
                for element in elements {
                    let value = self.evaluated(&element)?;
                    if self.apply(argument(&arguments, 0)?, vec![value.clone()])?.truth()? {
                        kept.push(Element::Ready(value));
                    }
                }
                kept
            }
            "flatten" | "flat_map" => {
                let mut all = Vec::new();
                for element in elements {
                    let mut value = self.evaluated(&element)?;
                    if name == "flat_map" {
                        value = self.apply(argument(&arguments, 0)?, vec![value])?;
                    }
                    all.extend(Self::elements(&value)?);
                }
                all
            }
            _ => return self.consumed(elements, name, &arguments),
        };
        Ok(Value::Sequence(Rc::new(transformed)))
    }

    /// What an iterator comes to in the end.
    fn consumed(&mut self, elements: Vec<Element>, name: &str, arguments: &[Value]) -> Outcome<Value> {
        match name {
            "sum" | "product" => {
                let (op, start) = match name {
                    "sum" => (BinOp::Add(Default::default()), 0),
                    _ => (BinOp::Mul(Default::default()), 1),
                };
                let mut total: Option<Value> = None;
                for element in &elements {
                    let value = self.evaluated(element)?;
                    let before = total.take().unwrap_or_else(|| match &value {
                        Value::Integer(integer) => Integer { value: start, of: integer.of }.into(),
                        _ => Value::plain(start as f64),
                    });
                    total = Some(self.operate(op, &before, &value)?);
                }
                Ok(total.unwrap_or_else(|| Value::plain(start as f64)))
            }
            "fold" => {
                let mut total = argument(arguments, 0)?.clone();
                for element in &elements {
                    let value = self.evaluated(element)?;
                    total = self.apply(argument(arguments, 1)?, vec![total, value])?;
                }
                Ok(total)
            }
            "count" | "len" => Ok(Value::size(elements.len())),
            "collect" => {
                Ok(Value::list(elements.iter().map(|element| self.evaluated(element)).collect::<Outcome<Vec<_>>>()?))
            }
            "any" | "all" => {
                for element in &elements {
                    let value = self.evaluated(element)?;
                    if self.apply(argument(arguments, 0)?, vec![value])?.truth()? == (name == "any") {
                        return Ok(Value::Bool(name == "any"));
                    }
                }
                Ok(Value::Bool(name == "all"))
            }
            _ => foreign(format!("`{name}` of an iterator")),
        }
    }

    /// Methods of slices that are none of iterators.
    fn of_slice(items: &Rc<Vec<Value>>, name: &str, arguments: &[Value]) -> Option<Outcome<Value>> {
        let parts = |parts: Vec<Value>| Ok(Value::Sequence(Rc::new(parts.into_iter().map(Element::Ready).collect())));
        let part = |part: &[Value]| Value::list(part.iter().cloned());
        let size = || match argument(arguments, 0).and_then(Value::index) {
            Ok(0) => panic("windows of no length"),
            size => size,
        };
        Some(match name {
            "len" => Ok(Value::size(items.len())),
            "is_empty" => Ok(Value::Bool(items.is_empty())),
            "has" => argument(arguments, 0).and_then(Value::index).map(|index| Value::Bool(index < items.len())),
            "windows" => size().and_then(|size| parts(items.windows(size).map(part).collect())),
            "chunks_exact" => size().and_then(|size| parts(items.chunks_exact(size).map(part).collect())),
            "chunks" => size().and_then(|size| parts(items.chunks(size).map(part).collect())),
            "first" => Ok(Value::Option(items.first().cloned().map(Rc::new))),
            "last" => Ok(Value::Option(items.last().cloned().map(Rc::new))),
            "get" => match argument(arguments, 0) {
                // All from an index on.
                Ok(Value::Range(from, _)) => {
                    let part = usize::try_from(from.value).ok().and_then(|from| items.get(from..));
                    Ok(Value::Option(part.map(|part| Rc::new(Value::list(part.iter().cloned())))))
                }
                Ok(index) => match index.index() {
                    Ok(index) => Ok(Value::Option(items.get(index).cloned().map(Rc::new))),
                    Err(stop) => Err(stop),
                },
                Err(stop) => Err(stop),
            },
            "as_slice" | "to_vec" => Ok(Value::List(items.clone())),
            _ => return None,
        })
    }
}
