//! Patterns, and places that values are written to.

use crate::{
    machine::Machine,
    number::Number,
    value::{Outcome, Value, foreign, panic},
};
use std::rc::Rc;
use syn::{Expr, Pat};

/// A step from a variable to a part of it.
enum Step {
    Field(String),
    Index(usize),
}

impl Machine<'_> {
    /// Binds the names of a pattern, which is known to match.
    pub(crate) fn bind(&mut self, pattern: &Pat, value: Value) -> Outcome<()> {
        if self.matches(pattern, &value)? { Ok(()) } else { foreign("a pattern that does not match") }
    }

    /// Whether a pattern matches; binds its names if so.
    pub(crate) fn matches(&mut self, pattern: &Pat, value: &Value) -> Outcome<bool> {
        match (pattern, value) {
            (Pat::Wild(_), _) => Ok(true),
            (Pat::Ident(name), Value::Option(option)) if name.ident == "None" => Ok(option.is_none()),
            (Pat::Ident(name), value) => {
                self.names.push((name.ident.clone(), value.clone()));
                Ok(true)
            }
            (Pat::Reference(inner), value) => self.matches(&inner.pat, value),
            (Pat::Paren(inner), value) => self.matches(&inner.pat, value),
            (Pat::Type(typed), value) => self.matches(&typed.pat, value),
            (Pat::Tuple(tuple), Value::Tuple(items)) if tuple.elems.len() == items.len() => {
                self.all_match(tuple.elems.iter(), items)
            }
            (Pat::Slice(slice), Value::List(items)) if slice.elems.len() == items.len() => {
                self.all_match(slice.elems.iter(), items)
            }
            (Pat::TupleStruct(some), Value::Option(option)) => match option {
                Some(value) => self.all_match(some.elems.iter(), std::slice::from_ref(&**value)),
                None => Ok(false),
            },
            (Pat::Lit(literal), value) => {
                let literal = self.expression(&Expr::Lit(literal.clone()))?;
                Ok(literal.integer()?.value == value.integer()?.value)
            }
            (Pat::Or(either), value) => {
                for case in &either.cases {
                    if self.matches(case, value)? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
            (_, value) => foreign(format!("a pattern for {}", value.kind())),
        }
    }

    fn all_match<'p>(&mut self, patterns: impl Iterator<Item = &'p Pat>, items: &[Value]) -> Outcome<bool> {
        for (pattern, item) in patterns.zip(items) {
            if !self.matches(pattern, item)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Writes to a place.
    pub(crate) fn store(&mut self, place: &Expr, value: Value) -> Outcome<()> {
        let place = self.place(place)?;
        *place = match (&*place, value) {
            (Value::Slot(_), Value::Number(number)) => Value::Slot(number),
            (Value::Number(before), Value::Number(number)) if before.kind != number.kind => {
                return foreign(format!("{:?} is stored as {:?}", number.kind, before.kind));
            }
            (_, value) => value,
        };
        Ok(())
    }

    /// Changes a coordinate of a motion.
    pub(crate) fn update(&mut self, place: &Expr, by: &Number) -> Outcome<()> {
        match self.place(place)? {
            Value::Slot(slot) if slot.kind == by.kind => {
                *slot = slot.add(by);
                Ok(())
            }
            Value::Slot(slot) => foreign(format!("{:?} is added to {:?}", by.kind, slot.kind)),
            other => foreign(format!("an update of {}", other.kind())),
        }
    }

    /// Adds a product to a coordinate of a motion.
    pub(crate) fn fuse(&mut self, place: &Expr, a: &Number, b: &Number) -> Outcome<()> {
        match self.place(place)? {
            Value::Slot(slot) if slot.kind == a.kind => {
                *slot = Number { kind: slot.kind, ..a.fma(b, slot) };
                Ok(())
            }
            Value::Slot(slot) => foreign(format!("{:?} is added to {:?}", a.kind, slot.kind)),
            other => foreign(format!("an update of {}", other.kind())),
        }
    }

    fn place(&mut self, place: &Expr) -> Outcome<&mut Value> {
        let mut steps = Vec::new();
        let mut inner = place;
        let root = loop {
            match inner {
                Expr::Path(path) => match path.path.get_ident() {
                    Some(name) => break name,
                    None => return foreign("a place"),
                },
                Expr::Field(field) => {
                    let syn::Member::Named(name) = &field.member else { return foreign("a place of a tuple") };
                    steps.push(Step::Field(name.to_string()));
                    inner = &field.base;
                }
                Expr::Index(index) => {
                    steps.push(Step::Index(self.expression(&index.index)?.index()?));
                    inner = &index.expr;
                }
                Expr::Paren(paren) => inner = &paren.expr,
                Expr::Unary(unary) => inner = &unary.expr,
                _ => return foreign("a place"),
            }
        };
        let Some((_, mut value)) = self.names.iter_mut().rev().find(|(name, _)| name == root).map(|(n, v)| (n, v))
        else {
            return foreign(format!("`{root}` is not known"));
        };
        for step in steps.into_iter().rev() {
            value = match (step, value) {
                (Step::Field(name), Value::Struct(fields)) => {
                    match Rc::make_mut(fields).iter_mut().find(|(known, _)| *known == name) {
                        Some((_, field)) => field,
                        None => return foreign(format!("no field `{name}`")),
                    }
                }
                (Step::Index(index), Value::List(items)) => match Rc::make_mut(items).get_mut(index) {
                    Some(item) => item,
                    None => return panic("an index out of bounds"),
                },
                (_, value) => return foreign(format!("a place in {}", value.kind())),
            };
        }
        Ok(value)
    }
}
