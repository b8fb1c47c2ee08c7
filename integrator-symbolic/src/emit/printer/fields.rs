//! Prepared constants: a value that depends on parameters only becomes a field, or a table if it depends on loops as
//! well.

use crate::{
    graph::{ExternalId, Graph, Node, NodeId, ParameterId},
    model::{Method, Parameter},
};
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::format_ident;
use std::collections::HashMap;

/// What a field holds.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Content {
    Number(NodeId),
    Integer(ParameterId),
    /// One where a condition of parameters holds, else zero.
    Flag(ParameterId),
    /// A method of the user with this number of arguments.
    External(ExternalId),
    /// The flow of a part that the user wrote, by the number of the part.
    OwnFlow(usize),
    /// How many inner steps parts take, by the number of parentheses around them.
    InnerSteps(usize),
    /// The middle of the current step, which is the same for all lanes.
    Middle,
}

/// The fields of the struct of prepared constants, in order of first use.
#[derive(Default)]
pub(crate) struct Fields {
    order: Vec<(Content, Ident)>,
    names: HashMap<Content, Ident>,
}

impl Fields {
    pub(crate) fn number(&mut self, graph: &Graph, parameters: &[Parameter], id: NodeId) -> Ident {
        let text = match graph.node(id) {
            Node::Parameter(parameter) => Some(&parameters[parameter.0 as usize].own),
            _ => None,
        };
        self.named(Content::Number(id), text)
    }

    pub(crate) fn integer(&mut self, parameters: &[Parameter], id: ParameterId) -> Ident {
        self.named(Content::Integer(id), Some(&parameters[id.0 as usize].own))
    }

    pub(crate) fn flag(&mut self, parameters: &[Parameter], id: ParameterId) -> Ident {
        self.named(Content::Flag(id), Some(&parameters[id.0 as usize].own))
    }

    pub(crate) fn external(&mut self, externals: &[Method], id: ExternalId) -> Ident {
        self.insert(Content::External(id), Some(externals[id.0 as usize].name.clone()))
    }

    pub(crate) fn own_flow(&mut self, part: usize, method: &Ident) -> Ident {
        self.insert(Content::OwnFlow(part), Some(method.clone()))
    }

    pub(crate) fn inner_steps(&mut self, level: usize) -> Ident {
        self.insert(Content::InnerSteps(level), Some(format_ident!("inner_steps")))
    }

    pub(crate) fn middle(&mut self) -> Ident {
        self.insert(Content::Middle, Some(format_ident!("middle")))
    }

    /// The field that holds the middle of the step, if a flow reads it.
    pub(crate) fn known_middle(&self) -> Option<&Ident> {
        self.names.get(&Content::Middle)
    }

    /// A field's name: the user's own where it is `self.name` or `self.name[i]`.
    fn named(&mut self, content: Content, text: Option<&TokenStream>) -> Ident {
        self.insert(content, text.and_then(own_name))
    }

    fn insert(&mut self, content: Content, base: Option<Ident>) -> Ident {
        if let Some(name) = self.names.get(&content) {
            return name.clone();
        }
        let base = base.unwrap_or_else(|| format_ident!("prepared_{}", self.order.len()));
        let mut name = base.clone();
        let mut count = 1;
        while self.order.iter().any(|(_, known)| *known == name) {
            count += 1;
            name = format_ident!("{base}_{count}");
        }
        self.names.insert(content, name.clone());
        self.order.push((content, name.clone()));
        name
    }

    /// What each field holds, and its name, in order of first use.
    pub(crate) fn into_contents(self) -> Vec<(Content, Ident)> {
        self.order
    }
}

impl Content {
    /// The node whose value the field holds.
    pub(crate) fn node(self) -> Option<NodeId> {
        match self {
            Content::Number(id) => Some(id),
            _ => None,
        }
    }
}

/// `name` of `self.name` and of `self.name[...]`.
fn own_name(text: &TokenStream) -> Option<Ident> {
    let tokens: Vec<TokenTree> = text.clone().into_iter().collect();
    match &tokens[..] {
        [TokenTree::Ident(own), TokenTree::Punct(_), TokenTree::Ident(name), rest @ ..]
            if own == "self" && rest.iter().all(|token| matches!(token, TokenTree::Group(_))) =>
        {
            // A call is not a name.
            let indexed = rest.iter().all(|token| token.to_string().starts_with('['));
            indexed.then(|| name.clone())
        }
        _ => None,
    }
}
