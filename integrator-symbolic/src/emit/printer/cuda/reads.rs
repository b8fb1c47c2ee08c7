//! The data that lines of device code read besides the state, and the functions that they call.

use super::{functions::native_functions, identifier::identifier};
use crate::{
    emit::printer::fields::Content,
    graph::{ParameterId, index::LoopSet},
    syntax::DeviceFunctions,
};
use proc_macro2::Ident;

/// What lines read beside the state: each becomes a field of the prepared constants on the device.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Read {
    /// A field of the prepared constants.
    Field(Content),
    /// A constant that the user's text names by a path.
    Path(ParameterId),
    /// An integer that it names so.
    IntegerPath(ParameterId),
}

impl Read {
    /// Its name in C++: a user's own one, or that of a path, which no user's becomes.
    pub(crate) fn name(self, name: &Ident) -> String {
        match self {
            Self::Field(_) => identifier(name),
            Self::Path(_) | Self::IntegerPath(_) => name.to_string(),
        }
    }

    /// Whether it is an integer.
    pub(crate) fn is_integer(self) -> bool {
        matches!(self, Self::IntegerPath(_) | Self::Field(Content::Integer(_) | Content::InnerSteps(_)))
    }
}

/// What all lines of a text have in common: whose functions they call, and what they have read so far.
pub(crate) struct Reads {
    functions: DeviceFunctions,
    /// Each with its name and the loops that its elements belong to.
    pub(crate) found: Vec<(Read, Ident, LoopSet)>,
}

impl Reads {
    pub(crate) fn of(functions: DeviceFunctions) -> Self {
        Self { functions, found: Vec::new() }
    }

    pub(crate) fn note(&mut self, read: Read, name: Ident, loops: LoopSet) {
        if self.found.iter().all(|(known, ..)| *known != read) {
            self.found.push((read, name, loops));
        }
    }

    /// The name of a function where the device's own is requested, if it has one.
    pub(super) fn native(&self, name: &str) -> Option<String> {
        (self.functions == DeviceFunctions::Native && native_functions().any(|known| known == name))
            .then(|| format!("library_{name}"))
    }
}
