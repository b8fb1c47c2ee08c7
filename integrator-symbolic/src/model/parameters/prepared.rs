//! The prepared constants that flows read, and the values that flows compute.

use crate::graph::{Graph, Node, NodeId};
use crate::model::{Parameter, parameters::parameter_text::COUNT};
use proc_macro2::{TokenStream, TokenTree};

/// Whether a node is read from a prepared constant: it depends on parameters, and on one loop at most unless it is a
/// parameter itself (a table over two loops is only made where the user has one).
pub(crate) fn is_field(graph: &Graph, parameters: &[Parameter], id: NodeId) -> bool {
    match graph.node(id) {
        Node::Constant(_) | Node::FromIndex(_) | Node::Neg(_) => false,
        condition if condition.is_condition() => false,
        Node::Parameter(parameter) => !is_constant(&parameters[parameter.0 as usize].text),
        _ => graph.is_prepared(id) && graph.loops_of(id).iter().count() <= 1,
    }
}

/// Whether a node is read rather than computed by a flow.
pub(crate) fn is_leaf(graph: &Graph, parameters: &[Parameter], id: NodeId) -> bool {
    matches!(
        graph.node(id),
        Node::Constant(_) | Node::FromIndex(_) | Node::Parameter(_) | Node::Time | Node::Middle | Node::Step
    ) || is_field(graph, parameters, id)
}

/// Whether a text is the path of a constant, which needs no preparation.
pub(crate) fn is_constant(text: &TokenStream) -> bool {
    text.clone().into_iter().all(|token| match token {
        TokenTree::Ident(name) => name != "self" && name != "length" && name != COUNT,
        TokenTree::Punct(mark) => mark.as_char() == ':',
        TokenTree::Literal(_) | TokenTree::Group(_) => false,
    })
}
