//! Lines of the report: how often each is carried out for a system, a state and a time.

use crate::{
    judge::{Case, machine},
    machine::Machine,
    value::{Outcome, Value, foreign},
};
use integrator_symbolic::Place;
use quote::{ToTokens, format_ident};
use syn::{
    BinOp, Expr, Ident, ImplItemFn, Pat, parse_quote,
    visit_mut::{self, VisitMut},
};

/// How many iterations the loops around a line of the report have.
pub(crate) fn iterations(
    methods: &[&ImplItemFn],
    case: &Case,
    constants: &[(String, Value)],
    place: &Place,
) -> Outcome<u64> {
    let mut machine = machine(methods, case);
    machine.constants = constants.iter().cloned().collect();
    let fields = match &case.fields {
        Value::Struct(fields) => fields.iter().map(|(name, _)| name.clone()).collect(),
        _ => Vec::new(),
    };
    for name in ["n", "length"] {
        machine.names.push((format_ident!("{name}"), Value::size(case.state[0].len())));
    }
    machine.names.push((format_ident!("q"), case.shaped(&case.state[0], Value::plain)));
    within(&mut machine, &mut Names { fields, running: Vec::new() }, &place.loops, &place.conditions)
}

/// The names in lines of the report, where fields of the system have no `self`.
struct Names {
    fields: Vec<String>,
    running: Vec<Ident>,
}

impl Names {
    fn is_field(&self, expression: &Expr) -> Option<Expr> {
        let Expr::Path(path) = expression else { return None };
        let name = path.path.get_ident().filter(|name| self.fields.contains(&name.to_string()))?;
        Some(parse_quote!(self.#name))
    }
}

impl VisitMut for Names {
    fn visit_expr_mut(&mut self, expression: &mut Expr) {
        let base = match expression {
            Expr::MethodCall(call) => Some(&mut call.receiver),
            Expr::Index(index) => Some(&mut index.expr),
            Expr::Field(field) => Some(&mut field.base),
            _ => None,
        };
        // The index of a loop has neither methods nor elements.
        if let Some(base) = base
            && let Some(field) = self.is_field(base)
        {
            **base = field;
        }
        match expression {
            Expr::Path(path) if self.running.iter().any(|name| path.path.is_ident(name)) => {}
            path @ Expr::Path(_) => *path = self.is_field(path).unwrap_or_else(|| path.clone()),
            other => visit_mut::visit_expr_mut(self, other),
        }
    }
}

fn within(machine: &mut Machine<'_>, names: &mut Names, loops: &[String], conditions: &[String]) -> Outcome<u64> {
    let [outermost, inner @ ..] = loops else {
        for condition in conditions {
            if !holds(machine, names, condition)? {
                return Ok(0);
            }
        }
        return Ok(1);
    };
    let text = format!("for {outermost} {{}}");
    let Ok(Expr::ForLoop(each)) = syn::parse_str(&text) else { return foreign(text) };
    let (Pat::Ident(index), Expr::Range(range)) = (&*each.pat, &*each.expr) else { return foreign(text) };
    let (Some(from), Some(to)) = (&range.start, &range.end) else { return foreign(text) };
    let (from, to) = (integer(machine, names, from)?, integer(machine, names, to)?);
    let mut count = 0;
    names.running.push(index.ident.clone());
    for number in from..to {
        machine.names.push((index.ident.clone(), Value::size(usize::try_from(number).unwrap_or_default())));
        count += within(machine, names, inner, conditions)?;
        machine.names.pop();
    }
    names.running.pop();
    Ok(count)
}

/// Whether a condition holds, as the report writes it.
fn holds(machine: &mut Machine<'_>, names: &mut Names, text: &str) -> Outcome<bool> {
    for (word, is_and) in [(" or ", false), (" and ", true)] {
        if let Some((a, b)) = split(text, word) {
            let (a, b) = (holds(machine, names, a)?, holds(machine, names, b)?);
            return Ok(if is_and { a && b } else { a || b });
        }
    }
    if let Some(inner) = text.strip_prefix("not ") {
        return Ok(!holds(machine, names, inner)?);
    }
    if let Some(inner) = text.strip_prefix('(').and_then(|text| text.strip_suffix(')'))
        && is_closed(inner)
    {
        return holds(machine, names, inner);
    }
    let Ok(condition) = syn::parse_str::<Expr>(text) else { return foreign(text) };
    match &condition {
        Expr::Binary(binary) => {
            let sides = (integer(machine, names, &binary.left), integer(machine, names, &binary.right));
            let (Ok(a), Ok(b)) = sides else { return value(machine, names, &condition)?.truth() };
            Ok(match binary.op {
                BinOp::Lt(_) => a < b,
                BinOp::Le(_) => a <= b,
                BinOp::Gt(_) => a > b,
                BinOp::Ge(_) => a >= b,
                BinOp::Eq(_) => a == b,
                BinOp::Ne(_) => a != b,
                _ => return value(machine, names, &condition)?.truth(),
            })
        }
        _ => value(machine, names, &condition)?.truth(),
    }
}

/// The text in front of a word outside of parentheses, and after it.
fn split<'t>(text: &'t str, word: &str) -> Option<(&'t str, &'t str)> {
    text.match_indices(word).find_map(|(at, _)| {
        let (before, after) = (&text[..at], &text[at + word.len()..]);
        (before.matches('(').count() == before.matches(')').count()).then_some((before, after))
    })
}

/// Whether each parenthesis that is closed in a text was opened there.
fn is_closed(text: &str) -> bool {
    let mut open = 0;
    text.chars().all(|next| {
        open += i32::from(next == '(') - i32::from(next == ')');
        open >= 0
    })
}

fn value(machine: &mut Machine<'_>, names: &mut Names, expression: &Expr) -> Outcome<Value> {
    let mut expression = expression.clone();
    names.visit_expr_mut(&mut expression);
    machine.expression(&expression)
}

/// A bound of a loop, as the report writes it.
fn integer(machine: &mut Machine<'_>, names: &mut Names, expression: &Expr) -> Outcome<i128> {
    Ok(match expression {
        Expr::Paren(inner) => integer(machine, names, &inner.expr)?,
        Expr::Cast(cast) => integer(machine, names, &cast.expr)?,
        Expr::Binary(binary) => {
            let (a, b) = (integer(machine, names, &binary.left)?, integer(machine, names, &binary.right)?);
            match binary.op {
                BinOp::Add(_) => a + b,
                BinOp::Sub(_) => a - b,
                BinOp::Mul(_) => a * b,
                BinOp::Div(_) => a / b,
                BinOp::Rem(_) => a % b,
                _ => return foreign("an operator of integers"),
            }
        }
        Expr::Call(call) if call.func.to_token_stream().to_string() == "min" => {
            integer(machine, names, &call.args[0])?.min(integer(machine, names, &call.args[1])?)
        }
        other => value(machine, names, other)?.integer()?.value,
    })
}
