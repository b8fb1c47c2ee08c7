//! The sides of a branch: what the user wrote, and what they give.

use crate::graph::{Graph, NodeId};
use crate::model::{code::assigned::Assigned, values::value::Value};
use syn::{BinOp, Block, Expr, ExprBinary, Stmt, visit::Visit};

/// Where a branch stands.
#[derive(Clone, Copy)]
pub(crate) enum Flow {
    /// In an expression, out of which nothing returns.
    Value,
    /// In the body of a function, which its sides may return from.
    Function,
}

/// What a part of a function gives: its value, unless it returned before.
pub(crate) struct Outcome {
    pub(crate) value: Value,
    /// What was returned: the first value whose condition holds.
    pub(crate) returned: Vec<(NodeId, Value)>,
}

impl Outcome {
    /// A value, where nothing returns.
    pub(crate) fn of(value: Value) -> Self {
        Self { value, returned: Vec::new() }
    }

    /// Whether it returns in any case.
    pub(crate) fn leaves(&self, graph: &Graph) -> bool {
        self.returned.last().is_some_and(|(condition, _)| graph.as_truth(*condition) == Some(true))
    }
}

/// One side of a branch.
#[derive(Clone, Copy)]
pub(crate) enum Body<'a> {
    Expression(&'a Expr),
    Block(&'a Block),
    /// The rest of a block, in its scope.
    Statements(&'a [Stmt]),
    Nothing,
}

impl<'a> Body<'a> {
    pub(crate) fn visit(self, assigned: &mut Assigned) {
        match self {
            Body::Expression(expression) => assigned.visit_expr(expression),
            Body::Block(block) => assigned.visit_block(block),
            Body::Statements(statements) => statements.iter().for_each(|statement| assigned.visit_stmt(statement)),
            Body::Nothing => {}
        }
    }
}

/// Whether a condition matches a pattern, alone or among others.
pub(crate) fn has_let(condition: &Expr) -> bool {
    let mut conditions = Vec::new();
    joined_by_and(condition, &mut conditions);
    conditions.iter().any(|condition| matches!(condition, Expr::Let(_)))
}

/// The conditions that `&&` joins, in their order.
pub(crate) fn joined_by_and<'e>(condition: &'e Expr, found: &mut Vec<&'e Expr>) {
    match condition {
        Expr::Binary(ExprBinary { left, op: BinOp::And(_), right, .. }) => {
            joined_by_and(left, found);
            joined_by_and(right, found);
        }
        other => found.push(other),
    }
}
