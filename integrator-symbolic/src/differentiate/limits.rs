//! Products of an adjoint and a slope if one is zero and the other is infinite.
//!
//! Far from a step such as `1 / (1 + eˣ)`, the slope of the reciprocal is zero when `eˣ` overflows. If all items of a
//! sum have the factor zero, the slope of its square root is infinite. The product is zero in both cases. This value is
//! selected if the divisor, or without one the slope, exceeds [`HUGE`](crate::graph::function::HUGE), or if the slope is exactly
//! zero; all other products are bitwise unchanged, but for those of [`quotient`].

use super::quotient;
use crate::graph::{Comparison, Graph, Node, NodeId};

/// The limits that the adjoint of a node may have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Limits {
    /// Whether the adjoint falls to zero faster than the node grows where this overflows.
    vanishes: bool,
    diverges: Divergence,
}

/// How the adjoint of a radicand becomes infinite.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
enum Divergence {
    /// It is finite where the value is.
    #[default]
    Never,
    /// It is infinite where the radicand is zero.
    ByMask,
    /// The same, and slower than the reciprocal of a slope that is zero there: the root of a square has the slope zero.
    BySlope,
}

impl Limits {
    /// Those of a node that is used in several places.
    pub(super) fn with(self, other: Self) -> Self {
        Self { vanishes: self.vanishes && other.vanishes, diverges: self.diverges.max(other.diverges) }
    }

    /// Those of the children of a node with these.
    pub(super) fn below(self, graph: &Graph, id: NodeId) -> Self {
        match graph.node(id) {
            Node::Power(base, halves) if halves < 0 => self.far_from(graph, base),
            Node::Power(base, 1) => self.under_root(graph, base, 0.5),
            Node::Unary(function, base) if function.row().levels_off => self.far_from(graph, base),
            Node::Unary(function, base) if function.name() == "exp" && graph.falls(base) => self.far_from(graph, base),
            Node::Unary(function, base) if function.name() == "cbrt" => self.under_root(graph, base, 1.0 / 3.0),
            // Of any exponent: where it is negative, the value is infinite as well.
            Node::Binary(function, base, exponent) if function.name() == "powf" => {
                self.under_root(graph, base, graph.as_constant(exponent).unwrap_or(0.5))
            }
            _ => self,
        }
    }

    fn far_from(self, graph: &Graph, base: NodeId) -> Self {
        Self { vanishes: self.vanishes || graph.grows(base), ..self }
    }

    fn under_root(self, graph: &Graph, base: NodeId, exponent: f64) -> Self {
        let diverges = match exponent {
            _ if !graph.may_be_zero(base) => Divergence::Never,
            // d|x|^(2e) = 2e |x|^(2e-1) dx, which is zero with x for an e above one half.
            _ if exponent > 0.5 && exponent < 1.0 => Divergence::BySlope,
            _ if exponent > 0.0 && exponent < 1.0 => Divergence::ByMask,
            _ => Divergence::Never,
        };
        Self { diverges: self.diverges.max(diverges), ..self }
    }

    /// The product of an adjoint with these and a slope.
    pub(super) fn product(self, graph: &mut Graph, adjoint: NodeId, slope: NodeId) -> NodeId {
        if let Some(quotient) = quotient::of_exponentials(graph, adjoint, slope) {
            return quotient;
        }
        let product = graph.mul(adjoint, slope);
        if self.vanishes && graph.grows(slope) {
            if let Some(divisor) = quotient::growing_divisor(graph, adjoint) {
                return graph.zero_beyond(divisor, product);
            }
            let (_, factor) = quotient::scaled(graph, slope);
            let size = if graph.is_never_negative(factor) { factor } else { graph.call("abs", factor) };
            return graph.zero_beyond(size, product);
        }
        let may_be_zero = match self.diverges {
            Divergence::Never => false,
            Divergence::ByMask => is_mask(graph, slope),
            Divergence::BySlope => !graph.is_never_zero(slope),
        };
        if may_be_zero {
            let (factor, zero) = (graph.without_sign(slope), graph.constant(0.0));
            let is_zero = graph.compare(Comparison::Equal, factor, zero);
            return graph.select(is_zero, zero, product);
        }
        product
    }
}

/// Whether a slope has a factor that may be zero wherever coordinates are: a parameter or a choice. A distance has none, whose root
/// has a kink where it is zero.
fn is_mask(graph: &Graph, id: NodeId) -> bool {
    let of = |id| is_mask(graph, id);
    match graph.node(id) {
        Node::Parameter(_) | Node::External(..) | Node::Select(..) | Node::FromIndex(_) => true,
        Node::Neg(a) => of(a),
        Node::Mul(a, b) => of(a) || of(b),
        Node::Div(a, _) => of(a),
        Node::Power(a, halves) => halves > 0 && of(a),
        Node::Add(a, b) => (of(a) || of(b)) && !graph.moves(id),
        Node::Binary(function, ..) => function.row().chooses.is_some(),
        _ => false,
    }
}
