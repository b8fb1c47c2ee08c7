//! Products of an adjoint and a slope, and sums of two of them, in a form that has a value wherever the derivative has one.
//!
//! `eᵘ / (c + eᵘ)`, the derivative of `ln(c + eᵘ)`, is ∞/∞ where `eᵘ` overflows; it equals `1 / (1 + c e⁻ᵘ)`. `sinh u / cosh u`
//! equals `tanh u`. `b^n - x b^(n-1)`, with `x = b - c`, is `∞ - ∞` or has lost its digits where `x` is large; it equals
//! `c b^(n-1)`.

use crate::graph::{Graph, Node, NodeId, function::HUGE};

/// Most exponentials in a denominator: each slope takes one for each other addend.
const MOST_EXPONENTIALS: usize = 2;

/// The product of an adjoint that has the factor `1 / cosh u`, or one over a sum of exponentials and prepared addends, and of the
/// slope `sinh u`, or one of the exponentials.
pub(super) fn of_exponentials(graph: &mut Graph, adjoint: NodeId, slope: NodeId) -> Option<NodeId> {
    if !graph.grows(slope) {
        return None;
    }
    let (scale, exponential) = scaled(graph, slope);
    let Node::Unary(function, argument) = graph.node(exponential) else { return None };
    let (sign, factors) = factors(graph, adjoint);
    for (place, factor) in factors.iter().enumerate() {
        let Node::Power(divisor, -2) = graph.node(*factor) else { continue };
        let quotient = match function.name() {
            "exp" => divided(graph, divisor, argument).map(|divisor| graph.power(divisor, -2)),
            "sinh" => (graph.call("cosh", argument) == divisor).then(|| graph.call("tanh", argument)),
            _ => None,
        };
        if let Some(quotient) = quotient {
            let others = factors.iter().enumerate().filter(|(other, _)| *other != place).map(|(_, factor)| *factor);
            let product = product(graph, sign, others);
            let scaled = graph.mul(product, scale);
            return Some(graph.mul(scaled, quotient));
        }
    }
    None
}

/// A sum of exponentials and prepared addends, divided by the one with this argument.
fn divided(graph: &mut Graph, sum: NodeId, by: NodeId) -> Option<NodeId> {
    let addends: Vec<(NodeId, Option<NodeId>)> =
        addends(graph, sum).into_iter().map(|addend| argument(graph, addend)).collect::<Option<_>>()?;
    let arguments = || addends.iter().filter_map(|(_, argument)| *argument);
    if arguments().count() > MOST_EXPONENTIALS || !arguments().any(|argument| argument == by) {
        return None;
    }
    let zero = graph.constant(0.0);
    Some(addends.into_iter().fold(zero, |sum, (scale, argument)| {
        if argument == Some(by) {
            return graph.add(sum, scale);
        }
        let difference = graph.sub(argument.unwrap_or(zero), by);
        // Beyond the bound the quotient is zero, and the product of derivatives in it is zero times infinity without one.
        let (exponential, huge) = (graph.call("exp", difference), graph.constant(HUGE));
        let exponential = graph.call_two("min", exponential, huge);
        let addend = graph.mul(scale, exponential);
        graph.add(sum, addend)
    }))
}

/// An addend as a prepared factor and the argument of an exponential, if there is one.
fn argument(graph: &mut Graph, addend: NodeId) -> Option<(NodeId, Option<NodeId>)> {
    if graph.is_prepared(addend) {
        return Some((addend, None));
    }
    let (scale, exponential) = scaled(graph, addend);
    match graph.node(exponential) {
        Node::Unary(function, argument) if function.name() == "exp" => Some((scale, Some(argument))),
        _ => None,
    }
}

/// The sum of `b^n a` and `-x b^(n-1) a`, where `b` is `x` and a prepared addend.
pub(super) fn complement(graph: &mut Graph, first: NodeId, second: NodeId) -> Option<NodeId> {
    complement_of(graph, first, second).or_else(|| complement_of(graph, second, first))
}

fn complement_of(graph: &mut Graph, higher: NodeId, lower: NodeId) -> Option<NodeId> {
    let ((sign, above), (other_sign, below)) = (factors(graph, higher), factors(graph, lower));
    if sign == other_sign {
        return None;
    }
    for (place, factor) in below.iter().enumerate() {
        let Node::Power(base, halves) = graph.node(*factor) else { continue };
        let Node::Add(a, b) = graph.node(base) else { continue };
        let raised = graph.power(base, halves.checked_add(2)?);
        let Some(other) = above.iter().position(|factor| *factor == raised) else { continue };
        let (kept, moving) = if graph.is_prepared(a) { (a, b) } else { (b, a) };
        let without = |factors: &[NodeId], place: usize| [&factors[..place], &factors[place + 1..]].concat();
        let rest = product(graph, sign, without(&above, other));
        let subtrahend = product(graph, sign, without(&below, place));
        if graph.is_prepared(kept) && graph.mul(rest, moving) == subtrahend {
            let kept = graph.mul(rest, kept);
            return Some(graph.mul(kept, *factor));
        }
    }
    None
}

/// The product of the powers that a product is divided by and that overflow far out.
pub(super) fn growing_divisor(graph: &mut Graph, id: NodeId) -> Option<NodeId> {
    let (_, factors) = factors(graph, id);
    let mut divisors = Vec::new();
    for factor in factors {
        if let Node::Power(base, halves) = graph.node(factor)
            && halves < 0
            && graph.grows(base)
        {
            divisors.push(graph.power(base, -halves));
        }
    }
    (!divisors.is_empty()).then(|| product(graph, false, divisors))
}

/// A value as a prepared factor and the rest.
pub(super) fn scaled(graph: &mut Graph, id: NodeId) -> (NodeId, NodeId) {
    let (negative, factors) = factors(graph, id);
    let (prepared, moving): (Vec<_>, Vec<_>) = factors.into_iter().partition(|factor| graph.is_prepared(*factor));
    (product(graph, negative, prepared), product(graph, false, moving))
}

/// The sign and the factors of a product.
fn factors(graph: &Graph, id: NodeId) -> (bool, Vec<NodeId>) {
    let (mut negative, mut factors, mut open) = (false, Vec::new(), vec![id]);
    while let Some(id) = open.pop() {
        match graph.node(id) {
            Node::Neg(inner) => {
                negative = !negative;
                open.push(inner);
            }
            Node::Mul(a, b) => open.extend([b, a]),
            _ => factors.push(id),
        }
    }
    (negative, factors)
}

fn product(graph: &mut Graph, negative: bool, factors: impl IntoIterator<Item = NodeId>) -> NodeId {
    let one = graph.constant(1.0);
    let product = factors.into_iter().fold(one, |product, factor| graph.mul(product, factor));
    if negative { graph.neg(product) } else { product }
}

fn addends(graph: &Graph, id: NodeId) -> Vec<NodeId> {
    let (mut addends, mut open) = (Vec::new(), vec![id]);
    while let Some(id) = open.pop() {
        match graph.node(id) {
            Node::Add(a, b) => open.extend([b, a]),
            _ => addends.push(id),
        }
    }
    addends
}
