//! Arrays to which a loop over pairs adds at both of its indices, such as densities of embedded atoms:
//! `rho[i] += f; rho[j] += f;`. The contributions to the inner index become a separate loop, over the outer index.
//!
//! Elements are computed where they are read, so each of them needs the pairs that contain it. The outer and the inner
//! loop are exchanged, and the bounds of the inner one become those of the outer index.

use crate::model::{
    Reader,
    code::assigned::{Assigned, Names, root_name},
    loops::sequence::FEW,
    values::value::Value,
};
use proc_macro2::Ident;
use quote::{ToTokens, quote};
use syn::{
    BinOp, Block, Expr, ExprBinary, ExprForLoop, ExprIf, ExprIndex, ExprLit, ExprMatch, ExprRange, Lit, Pat,
    RangeLimits, Stmt, parse_quote, visit::Visit,
};

impl Reader<'_> {
    /// A loop over pairs as one that adds to arrays at its own index alone, and one for each array that is added to at the
    /// index of the loop inside of it; `None` where it is no such loop.
    pub(crate) fn gathered(&self, repeat: &ExprForLoop) -> Option<Vec<ExprForLoop>> {
        let outer = counted(repeat)?;
        let (at, inner) = outer.body.stmts.iter().enumerate().find_map(|(at, statement)| match statement {
            Stmt::Expr(Expr::ForLoop(inner), _) => {
                let inner = counted(inner)?;
                (!self.scattered(&inner.body, index_of(&inner)?).is_empty()).then_some((at, inner))
            }
            _ => None,
        })?;
        let (i, j) = (index_of(&outer)?.clone(), index_of(&inner)?.clone());
        let names = self.scattered(&inner.body, &j);
        if !self.is_sum_alone(&outer) {
            return None;
        }
        let (own, by_inner) = (bounds(&outer.expr)?, bounds(&inner.expr)?);
        let outside = |name: &Ident| self.lookup(&name.to_string()).is_some();
        let mut whole = outer.clone();
        whole.body.stmts[at] = Stmt::Expr(Expr::ForLoop(inner.clone()), None);
        let rest = ExprForLoop {
            body: without(&whole.body, &|place| at_index(place, &j).is_some_and(|name| names.contains(name))),
            ..whole
        };
        let mut loops = Vec::new();
        if self.adds(&rest.body) {
            loops.push(rest);
        }
        let inside = between(&own, &by_inner, &i, &j)?;
        for name in names {
            let is_kept = |place: &Expr| at_index(place, &j) == Some(&name) || !root_name(place).is_some_and(outside);
            let before = Block { stmts: outer.body.stmts[..at].to_vec(), ..outer.body.clone() };
            let [before, body] = [&before, &inner.body].map(|block| without(block, &|place| !is_kept(place)));
            let (before, body) = (before.stmts, body.stmts);
            let ItsLoop { from, to, range, guard } = &inside;
            let end = to.clone().unwrap_or_else(|| parse_quote!(#name.len()));
            loops.push(parse_quote!(for #j in #from..#end { for #i in #range { #guard #(#before)* #(#body)* } }));
        }
        // What is left adds where a loop can: whatever stands elsewhere is no statement, and was left alone.
        loops.iter().all(|own| self.scattered(&own.body, &j).is_empty() || index_of(own) == Some(&j)).then_some(loops)
    }

    /// The arrays from outside that a body adds to at an index, too long for their loops to be written out.
    fn scattered(&self, body: &Block, index: &Ident) -> Vec<Ident> {
        let mut additions = Additions(Vec::new());
        additions.visit_block(body);
        let mut found: Vec<Ident> = Vec::new();
        for name in additions.0.iter().filter_map(|place| at_index(place, index)) {
            if !found.contains(name) && self.is_long(name) {
                found.push(name.clone());
            }
        }
        found
    }

    /// Whether a variable is a list, or an array with more elements than a loop that is written out has iterations.
    fn is_long(&self, name: &Ident) -> bool {
        match self.lookup(&name.to_string()).map(|id| &self.bindings[id.0].value) {
            Some(Value::List(_)) => true,
            Some(Value::Array(parts)) => parts.len() as u64 > FEW,
            _ => false,
        }
    }

    /// Whether a body adds to a variable from outside.
    fn adds(&self, body: &Block) -> bool {
        let mut assigned = Assigned::default();
        assigned.visit_block(body);
        assigned.names.iter().any(|name| self.lookup(name).is_some())
    }

    /// Whether all that a loop does to variables from outside is to add, and none of these is read in it or has its name
    /// taken.
    fn is_sum_alone(&self, repeat: &ExprForLoop) -> bool {
        let mut assigned = Assigned::default();
        assigned.visit_block(&repeat.body);
        let mut declared = Names(Vec::new());
        declared.visit_expr_for_loop(repeat);
        let outside: Vec<&String> = assigned.names.iter().filter(|name| self.lookup(name).is_some()).collect();
        outside.iter().all(|name| {
            ![&assigned.read, &assigned.replaced, &declared.0].into_iter().any(|names| names.contains(name))
        })
    }
}

/// A loop with the index of its iterations for its pattern: over a range, or `for (i, x) in list.iter().enumerate()`, from
/// some item or up to one.
fn counted(repeat: &ExprForLoop) -> Option<ExprForLoop> {
    if let Pat::Ident(_) = &*repeat.pat {
        bounds(&repeat.expr)?;
        return Some(repeat.clone());
    }
    let Pat::Tuple(parts) = &*repeat.pat else { return None };
    let [Pat::Ident(index), item] = &parts.elems.iter().collect::<Vec<_>>()[..] else { return None };
    let mut call = match &*repeat.expr {
        Expr::MethodCall(call) => call,
        _ => return None,
    };
    let (mut from, mut to): (Expr, Option<Expr>) = (parse_quote!(0), None);
    if call.method == "skip" || call.method == "take" {
        match call.method == "skip" {
            true => from = call.args.first()?.clone(),
            false => to = call.args.first().cloned(),
        }
        let Expr::MethodCall(inner) = &*call.receiver else { return None };
        call = inner;
    }
    let Expr::MethodCall(items) = &*call.receiver else { return None };
    let list = &items.receiver;
    if call.method != "enumerate" || items.method != "iter" || !matches!(&**list, Expr::Path(_)) {
        return None;
    }
    let to = to.unwrap_or_else(|| parse_quote!(#list.len()));
    let (index, body) = (&index.ident, &repeat.body.stmts);
    Some(parse_quote!(for #index in #from..#to { let #item = &#list[#index]; #(#body)* }))
}

/// The name that a loop over a range has for its index.
fn index_of(repeat: &ExprForLoop) -> Option<&Ident> {
    match &*repeat.pat {
        Pat::Ident(name) => Some(&name.ident),
        _ => None,
    }
}

/// The first index of a range, and the one after the last.
fn bounds(range: &Expr) -> Option<(Expr, Expr)> {
    match range {
        Expr::Paren(inner) => bounds(&inner.expr),
        Expr::Range(ExprRange { start: Some(from), end: Some(to), limits, .. }) => Some(match limits {
            RangeLimits::Closed(_) => ((**from).clone(), parse_quote!(#to + 1)),
            RangeLimits::HalfOpen(_) => ((**from).clone(), (**to).clone()),
        }),
        _ => None,
    }
}

/// The loops of an element: over the inner index, which ends with the array where no end is given, and over those outer ones
/// that it is inside of the inner loop for, with a guard where no range says which these are.
struct ItsLoop {
    from: Expr,
    to: Option<Expr>,
    range: Expr,
    guard: Option<Expr>,
}

/// The loops over two indices, changed for each other.
fn between((first, end): &(Expr, Expr), (from, to): &(Expr, Expr), i: &Ident, j: &Ident) -> Option<ItsLoop> {
    let plain = |expression: &Expr| expression.to_token_stream().to_string();
    let is = |expression: &Expr, text: proc_macro2::TokenStream| plain(expression) == text.to_string();
    let from_first = matches!(first, Expr::Lit(ExprLit { lit: Lit::Int(number), .. })
        if matches!(number.base10_digits(), "0" | "1"));
    let (free_from, free_to) = (!mentions(from, i), !mentions(to, i));
    if mentions(first, j) || mentions(end, j) {
        return None;
    }
    // Of the outer ones those that begin before.
    let end_before = |bound: Expr| -> Expr {
        if plain(end) == plain(to) || is(end, quote!(#to - 1)) { bound } else { parse_quote!((#end).min(#bound)) }
    };
    let (mut range, mut guard): (Expr, Option<Expr>) = (parse_quote!((#first)..(#end)), None);
    match (free_from, free_to) {
        (true, true) => {}
        (false, true) if is(from, quote!(#i + 1)) => {
            let end = end_before(parse_quote!(#j));
            range = parse_quote!((#first)..#end);
        }
        (false, true) if is(from, quote!(#i)) => {
            let end = end_before(parse_quote!(#j + 1));
            range = parse_quote!((#first)..#end);
        }
        (true, false) if is(to, quote!(#i)) && from_first => range = parse_quote!(#j + 1..(#end)),
        (true, false) if is(to, quote!(#i + 1)) && is(first, quote!(0)) => range = parse_quote!(#j..(#end)),
        _ => guard = Some(parse_quote!(if #j < #from || #j >= #to { continue; })),
    }
    Some(ItsLoop {
        from: if free_from { from.clone() } else { parse_quote!(0) },
        to: free_to.then(|| to.clone()),
        range,
        guard,
    })
}

fn mentions(expression: &Expr, name: &Ident) -> bool {
    let mut found = Vec::new();
    crate::model::parameters::text::identifiers(expression.to_token_stream(), &mut found);
    found.contains(name)
}

/// The places that a body adds to.
struct Additions(Vec<Expr>);

impl Visit<'_> for Additions {
    fn visit_expr_binary(&mut self, addition: &ExprBinary) {
        if let BinOp::AddAssign(_) | BinOp::SubAssign(_) = addition.op {
            self.0.push((*addition.left).clone());
        }
        syn::visit::visit_expr_binary(self, addition);
    }
}

/// The array of a place that is its element at an index, or a part of that.
fn at_index<'e>(place: &'e Expr, index: &Ident) -> Option<&'e Ident> {
    let Expr::Index(ExprIndex { expr, index: at, .. }) = place else { return None };
    match &**expr {
        Expr::Path(path) => {
            path.path.get_ident().filter(|_| matches!(&**at, Expr::Path(at) if at.path.is_ident(index)))
        }
        inner => at_index(inner, index),
    }
}

/// A block without the statements that add to some places.
fn without(block: &Block, is_left_out: &dyn Fn(&Expr) -> bool) -> Block {
    let stmts = block.stmts.iter().filter_map(|statement| match statement {
        Stmt::Expr(expression, semicolon) => Some(Stmt::Expr(left(expression, is_left_out)?, *semicolon)),
        other => Some(other.clone()),
    });
    Block { stmts: stmts.collect(), ..block.clone() }
}

/// What is left of an expression in the place of a statement.
fn left(expression: &Expr, is_left_out: &dyn Fn(&Expr) -> bool) -> Option<Expr> {
    Some(match expression {
        Expr::Binary(ExprBinary { left, op: BinOp::AddAssign(_) | BinOp::SubAssign(_), .. }) if is_left_out(left) => {
            return None;
        }
        Expr::If(branch) => {
            let mut branch: ExprIf = branch.clone();
            branch.then_branch = without(&branch.then_branch, is_left_out);
            if let Some((_, otherwise)) = &mut branch.else_branch {
                **otherwise = left(otherwise, is_left_out).unwrap_or_else(|| parse_quote!({}));
            }
            Expr::If(branch)
        }
        Expr::Block(block) => {
            let mut block = block.clone();
            block.block = without(&block.block, is_left_out);
            Expr::Block(block)
        }
        Expr::ForLoop(repeat) => {
            Expr::ForLoop(ExprForLoop { body: without(&repeat.body, is_left_out), ..repeat.clone() })
        }
        Expr::Match(choice) => {
            let mut choice: ExprMatch = choice.clone();
            for arm in &mut choice.arms {
                *arm.body = left(&arm.body, is_left_out).unwrap_or_else(|| parse_quote!({}));
            }
            Expr::Match(choice)
        }
        other => other.clone(),
    })
}
