//! The interpreter: statements and expressions of Rust, as far as H and what is generated from it need them.
//!
//! References are transparent, since nothing here is changed through one but a motion; lists are copied when they are
//! written. Integers have their types, and overflow as in a debug build.

use crate::{
    calls::names_of,
    drivers::Driven,
    lists::Term,
    number::Number,
    value::{Closure, Integer, IntegerType, Outcome, Stop, USIZE, Value, foreign, panic},
};
use integrator_symbolic::Tally;
use std::{collections::HashMap, rc::Rc};
use syn::{Block, Expr, Ident, ImplItemFn, Item, Lit, Pat, Stmt};

/// A text in the middle of its evaluation.
pub(crate) struct Machine<'t> {
    /// The user's methods and the generated ones, by name.
    pub(crate) functions: HashMap<String, &'t ImplItemFn>,
    /// The fields of generated structs, with their types.
    pub(crate) structs: HashMap<String, &'t syn::ItemStruct>,
    pub(crate) names: Vec<(Ident, Value)>,
    /// The constants of the user's text, by their last name.
    pub(crate) constants: HashMap<String, Value>,
    /// The flows that the runtime carries out.
    pub(crate) driven: Driven<'t>,
    /// The term of the sum over a list that comes next.
    pub(crate) term: Option<Term>,
    /// The type that the present expression has to have, where it is written down.
    pub(crate) expected: Option<syn::Type>,
    /// Whether a branch was taken that rounding may have decided.
    pub(crate) on_edge: bool,
    /// Whether the text is generated, where the indices of loops are indices.
    pub(crate) is_generated: bool,
    /// How many expressions may still be evaluated.
    pub(crate) budget: usize,
    /// What the runtime was told: names of methods, with the arguments.
    pub(crate) told: Vec<(String, Vec<Value>)>,
    /// The operations carried out.
    pub(crate) done: Tally,
    /// How often functions were called.
    pub(crate) calls: HashMap<String, u64>,
    /// Whether lines assign results of a phase, and no components of a gradient.
    pub(crate) keeps_results: bool,
    /// Whether comparisons of numbers hold in some lanes of a vector and not in others, so that both sides are taken.
    pub(crate) takes_both: bool,
}

/// How many expressions an evaluation may take: no generated system needs as many.
const BUDGET: usize = 400_000;

impl<'t> Machine<'t> {
    pub(crate) fn new(functions: impl IntoIterator<Item = &'t ImplItemFn>) -> Self {
        let functions = functions.into_iter().map(|function| (function.sig.ident.to_string(), function)).collect();
        let (structs, names) = (HashMap::new(), Vec::new());
        Self {
            functions,
            structs,
            names,
            constants: HashMap::new(),
            driven: Driven::default(),
            term: None,
            expected: None,
            on_edge: false,
            is_generated: false,
            budget: BUDGET,
            told: Vec::new(),
            done: Tally::default(),
            calls: HashMap::new(),
            keeps_results: false,
            takes_both: false,
        }
    }

    /// Calls a function in names of its own; `self` is seen everywhere.
    pub(crate) fn call(&mut self, function: &ImplItemFn, arguments: Vec<Value>) -> Outcome<Value> {
        Ok(self.run(function, arguments, None)?.0)
    }

    /// Calls a function, and returns what has become of one of its arguments as well.
    pub(crate) fn run(
        &mut self,
        function: &ImplItemFn,
        arguments: Vec<Value>,
        changed: Option<usize>,
    ) -> Outcome<(Value, Value)> {
        *self.calls.entry(function.sig.ident.to_string()).or_default() += 1;
        let own = self.names.iter().find(|(name, _)| name == "self").cloned();
        let outer = std::mem::replace(&mut self.names, own.into_iter().collect());
        let patterns: Vec<&Pat> = function.sig.inputs.iter().filter_map(pattern_of).collect();
        let mut bound = Ok(());
        for (pattern, argument) in patterns.iter().zip(arguments) {
            bound = bound.and_then(|()| self.bind(pattern, argument));
        }
        let result = bound.and_then(|()| match self.block(&function.block) {
            Err(Stop::Return(value)) => Ok(*value),
            result => result,
        });
        let own = std::mem::replace(&mut self.names, outer);
        // A method may change the value that it is called on.
        if let (Some((_, after)), Some((_, before))) =
            (own.iter().find(|(name, _)| name == "self"), self.names.iter_mut().find(|(name, _)| name == "self"))
        {
            *before = after.clone();
        }
        let name = changed.and_then(|place| match patterns.get(place) {
            Some(Pat::Ident(name)) => Some(&name.ident),
            _ => None,
        });
        let changed = own.into_iter().find(|(known, _)| Some(known) == name);
        Ok((result?, changed.map_or(Value::Unit, |(_, value)| value)))
    }

    /// Lets something be done where `self` is another value, which is returned as it is afterwards.
    pub(crate) fn with_self(&mut self, value: Value, run: impl FnOnce(&mut Self) -> Outcome<Value>) -> Outcome<Value> {
        let Some(place) = self.names.iter().position(|(name, _)| name == "self") else { return foreign("no `self`") };
        let outer = std::mem::replace(&mut self.names[place].1, value);
        let result = run(self);
        let value = std::mem::replace(&mut self.names[place].1, outer);
        result.map(|_| value)
    }

    /// Calls a function value.
    pub(crate) fn apply(&mut self, function: &Value, arguments: Vec<Value>) -> Outcome<Value> {
        match function {
            Value::Closure(closure) => {
                let outer = std::mem::replace(&mut self.names, closure.seen.clone());
                let mut bound = Ok(());
                for (pattern, argument) in closure.text.inputs.iter().zip(arguments) {
                    bound = bound.and_then(|()| self.bind_running(pattern, argument));
                }
                let result = bound.and_then(|()| self.expression(&closure.text.body));
                self.names = outer;
                result
            }
            Value::Path(path) => self.call_path(path, arguments),
            other => foreign(format!("a call of {}", other.kind())),
        }
    }

    pub(crate) fn block(&mut self, block: &Block) -> Outcome<Value> {
        let depth = self.names.len();
        let result = self.statements(&block.stmts);
        self.names.truncate(depth);
        result
    }

    fn statements(&mut self, statements: &[Stmt]) -> Outcome<Value> {
        let mut last = Value::Unit;
        for statement in statements {
            last = Value::Unit;
            match statement {
                Stmt::Local(local) => {
                    let Some(init) = &local.init else { return foreign("a variable without a value") };
                    // Slices of the coordinates of a motion are the motion here.
                    if is_in_place(&init.expr) {
                        continue;
                    }
                    let value = self.expression(&init.expr)?;
                    self.count_contribution(&local.pat, &init.expr);
                    self.bind(&local.pat, value)?;
                }
                Stmt::Expr(expression, None) => last = self.expression(expression)?,
                Stmt::Expr(expression, Some(_)) => drop(self.expression(expression)?),
                Stmt::Macro(found) if found.mac.path.segments.iter().any(|name| name.ident == "debug_assert") => {}
                Stmt::Macro(found) => last = self.invoked(&found.mac)?,
                Stmt::Item(Item::Impl(term)) => self.term = Some(Rc::new(term.clone())),
                Stmt::Item(_) => {}
            }
        }
        Ok(last)
    }

    pub(crate) fn expression(&mut self, expression: &Expr) -> Outcome<Value> {
        self.budget = match self.budget.checked_sub(1) {
            Some(left) => left,
            None => return foreign("an evaluation without an end"),
        };
        match expression {
            Expr::Lit(literal) => Self::literal(&literal.lit),
            Expr::Path(path) => self.path(&path.path),
            Expr::Paren(inner) => self.expression(&inner.expr),
            Expr::Group(inner) => self.expression(&inner.expr),
            Expr::Reference(inner) => self.expression(&inner.expr),
            Expr::Block(block) => self.block(&block.block),
            Expr::Unary(unary) => self.unary(unary),
            Expr::Binary(binary) => self.binary(binary),
            Expr::Assign(assign) => {
                let value = self.expression(&assign.right)?;
                self.count_assignment(assign);
                self.store(&assign.left, value)?;
                Ok(Value::Unit)
            }
            Expr::If(choice) => self.choice(choice),
            Expr::ForLoop(each) => self.each(each),
            Expr::Index(index) => {
                let (list, at) = (self.expression(&index.expr)?, self.expression(&index.index)?);
                match at {
                    Value::Range(from, to) => Self::slice(&list, from, to),
                    at => Ok(list.at(at.index()?)?.clone()),
                }
            }
            Expr::Field(field) => {
                let of = self.expression(&field.base)?;
                match (&field.member, of) {
                    (syn::Member::Named(name), of) => Ok(of.field(&name.to_string())?.clone()),
                    (syn::Member::Unnamed(place), Value::Tuple(items)) => match items.get(place.index as usize) {
                        Some(item) => Ok(item.clone()),
                        None => foreign("no such place in a tuple"),
                    },
                    (syn::Member::Unnamed(_), of) => foreign(format!("a place of {}", of.kind())),
                }
            }
            Expr::Array(array) => Ok(Value::list(self.all(array.elems.iter())?)),
            Expr::Tuple(tuple) if tuple.elems.is_empty() => Ok(Value::Unit),
            Expr::Tuple(tuple) => Ok(Value::tuple(self.all(tuple.elems.iter())?)),
            Expr::Repeat(repeat) => {
                let (value, count) = (self.expression(&repeat.expr)?, self.expression(&repeat.len)?.index()?);
                Ok(Value::list(std::iter::repeat_n(value, count)))
            }
            Expr::Range(range) => self.range(range),
            Expr::Cast(cast) => {
                let value = self.expression(&cast.expr)?;
                Self::cast(value, &cast.ty)
            }
            Expr::Closure(closure) => {
                Ok(Value::Closure(Rc::new(Closure { text: closure.clone(), seen: self.names.clone() })))
            }
            Expr::Call(call) => self.called(call),
            Expr::MethodCall(call) => self.method(call),
            Expr::Struct(literal) => self.structure(literal),
            Expr::Macro(found) => self.invoked(&found.mac),
            Expr::Continue(_) => Err(Stop::Continue),
            Expr::Break(_) => Err(Stop::Break),
            Expr::Return(back) => {
                let value = back.expr.as_ref().map_or(Ok(Value::Unit), |value| self.expression(value))?;
                Err(Stop::Return(Box::new(value)))
            }
            Expr::Match(choice) => self.matched(choice),
            other => foreign(format!("the expression {}", quote::quote!(#other))),
        }
    }

    pub(crate) fn all<'e>(&mut self, expressions: impl Iterator<Item = &'e Expr>) -> Outcome<Vec<Value>> {
        expressions.map(|expression| self.expression(expression)).collect()
    }

    fn literal(literal: &Lit) -> Outcome<Value> {
        match literal {
            Lit::Float(float) => Ok(Value::plain(float.base10_parse().map_err(|_| Stop::Foreign("a number".into()))?)),
            Lit::Int(int) if int.suffix() == "f64" => {
                Ok(Value::plain(int.base10_parse().map_err(|_| Stop::Foreign("a number".into()))?))
            }
            Lit::Int(int) => {
                let value = int.base10_parse().map_err(|_| Stop::Foreign("an integer".into()))?;
                Ok(Integer { value, of: IntegerType::named(int.suffix()) }.into())
            }
            Lit::Bool(truth) => Ok(Value::Bool(truth.value)),
            Lit::Str(_) => Ok(Value::Unit),
            _ => foreign("a literal"),
        }
    }

    fn choice(&mut self, choice: &syn::ExprIf) -> Outcome<Value> {
        let depth = self.names.len();
        let holds = match &*choice.cond {
            Expr::Let(pattern) => {
                let value = self.expression(&pattern.expr)?;
                self.matches(&pattern.pat, &value)?
            }
            condition => self.expression(condition)?.truth()?,
        };
        let result = match (holds, &choice.else_branch) {
            (true, _) => self.block(&choice.then_branch),
            (false, Some((_, other))) => self.expression(other),
            (false, None) => Ok(Value::Unit),
        };
        self.names.truncate(depth);
        Ok(match result? {
            Value::Number(number) if is_flag(choice) => Number { is_flag: true, ..number }.into(),
            value => value,
        })
    }

    fn matched(&mut self, choice: &syn::ExprMatch) -> Outcome<Value> {
        let value = self.expression(&choice.expr)?;
        let depth = self.names.len();
        for arm in &choice.arms {
            if self.matches(&arm.pat, &value)? {
                let result = self.expression(&arm.body);
                self.names.truncate(depth);
                return result;
            }
        }
        foreign("no arm matches")
    }

    fn each(&mut self, each: &syn::ExprForLoop) -> Outcome<Value> {
        if let Some((place, other)) = changed_beside(&each.expr) {
            return self.each_changed(each, place, other);
        }
        let source = self.expression(&each.expr)?;
        for element in Self::elements(&source)? {
            let item = self.evaluated(&element)?;
            let depth = self.names.len();
            self.bind_running(&each.pat, item)?;
            let result = self.block(&each.body);
            self.names.truncate(depth);
            match result {
                Ok(_) | Err(Stop::Continue) => {}
                Err(Stop::Break) => break,
                Err(stop) => return Err(stop),
            }
        }
        Ok(Value::Unit)
    }

    /// A loop over the elements of a list that it changes, beside those of another one.
    fn each_changed(&mut self, each: &syn::ExprForLoop, place: &Expr, other: &Expr) -> Outcome<Value> {
        let (mut items, others) = (self.expression(place)?.items()?.to_vec(), self.expression(other)?);
        for (item, other) in items.iter_mut().zip(others.items()?) {
            let depth = self.names.len();
            self.bind(&each.pat, Value::tuple([item.clone(), other.clone()]))?;
            self.block(&each.body)?;
            *item = self.names[depth].1.clone();
            self.names.truncate(depth);
        }
        self.store(place, Value::list(items))?;
        Ok(Value::Unit)
    }

    fn range(&mut self, range: &syn::ExprRange) -> Outcome<Value> {
        let zero = Integer { value: 0, of: None };
        let from = range.start.as_ref().map_or(Ok(zero), |from| self.expression(from)?.integer())?;
        // A range without an end is cut where no sequence gets.
        let to = match &range.end {
            Some(to) => self.expression(to)?.integer()?,
            None => Integer { value: from.value + 100_000, of: from.of },
        };
        let of = from.common(to)?;
        let to = match range.limits {
            syn::RangeLimits::Closed(_) => to.value + 1,
            syn::RangeLimits::HalfOpen(_) => to.value,
        };
        Ok(Value::Range(Integer { of, ..from }, Integer { value: to, of }))
    }

    fn slice(list: &Value, from: Integer, to: Integer) -> Outcome<Value> {
        let items = list.items()?;
        let to = if to.value >= 100_000 { items.len() as i128 } else { to.value };
        match (usize::try_from(from.value), usize::try_from(to)) {
            (Ok(from), Ok(to)) if from <= to && to <= items.len() => Ok(Value::list(items[from..to].iter().cloned())),
            _ => panic("a range of a slice out of bounds"),
        }
    }

    /// The index of a loop or of a closure: an integer of no other type is an index, unless its name says that it is
    /// signed, as rustc infers where it is none.
    pub(crate) fn bind_running(&mut self, pattern: &Pat, value: Value) -> Outcome<()> {
        let value = match (pattern, value) {
            (Pat::Ident(name), Value::Integer(Integer { value, of: None })) => {
                let is_signed = !self.is_generated && name.ident.to_string().starts_with("signed");
                let of = if is_signed { IntegerType::named("i32") } else { Some(USIZE) };
                Integer { value, of }.into()
            }
            (_, value) => value,
        };
        self.bind(pattern, value)
    }
}

/// Whether a choice is `if condition { 1.0 } else { 0.0 }`, by which conditions are prepared.
fn is_flag(choice: &syn::ExprIf) -> bool {
    let is = |text: &dyn quote::ToTokens, number: &str| text.to_token_stream().to_string() == number;
    let otherwise = choice.else_branch.as_ref();
    is(&choice.then_branch, "{ 1.0 }") && otherwise.is_some_and(|(_, other)| is(other, "{ 0.0 }"))
}

/// The list that `zip(list.iter_mut(), &other)` changes, or `zip(list, other)` where `list` is a reference; and the other one.
fn changed_beside(zipped: &Expr) -> Option<(&Expr, &Expr)> {
    let Expr::Call(call) = zipped else { return None };
    let Expr::Path(path) = &*call.func else { return None };
    if path.path.segments.last()?.ident != "zip" {
        return None;
    }
    let changed = match &call.args[0] {
        Expr::MethodCall(elements) if elements.method == "iter_mut" => &*elements.receiver,
        reference => reference,
    };
    Some((changed, call.args.get(1)?))
}

/// The pattern of an argument that is not `self`.
fn pattern_of(input: &syn::FnArg) -> Option<&Pat> {
    match input {
        syn::FnArg::Typed(typed) => Some(&typed.pat),
        syn::FnArg::Receiver(_) => None,
    }
}

/// Whether an expression is `&mut runtime::in_place(...)`.
fn is_in_place(expression: &Expr) -> bool {
    let Expr::Reference(reference) = expression else { return false };
    let Expr::Call(call) = &*reference.expr else { return false };
    matches!(&*call.func, Expr::Path(path) if names_of(&path.path).last().is_some_and(|name| name == "in_place"))
}
