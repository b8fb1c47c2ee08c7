//! Systems without their types: what the Python class `System` calls.

use crate::{
    arrays::Shape,
    methods::{Row, Tangents},
    parameters::{self, Parameters},
};
use integrator_core::{Hamiltonian, InLanes};
use pyo3::{
    prelude::*,
    types::{PyCFunction, PyDict},
};
use std::{any::Any, sync::Arc};

/// A system with a class in a Python module. [`module!`](crate::module) implements this trait.
pub trait Exported: Hamiltonian<Compose: InLanes<Self>> + Parameters {
    /// The name of the Python class.
    const NAME: &'static str;
    /// The documentation of the Python class.
    const DOC: &'static str;

    /// Returns the rows of all methods that runs can choose from, the default first.
    fn rows() -> Vec<Row>;
    /// Returns the user's functions that Python can call.
    ///
    /// # Errors
    /// Python has no memory left.
    fn functions<'py>(module: &Bound<'py, PyModule>) -> PyResult<Vec<Function<'py>>>;
}

/// A function of the user's type that Python can call.
pub struct Function<'py> {
    /// The name.
    pub name: &'static str,
    /// Names and Rust types of the arguments.
    pub arguments: &'static [(&'static str, &'static str)],
    /// The Rust type of the result.
    pub result: &'static str,
    /// The function of the system and the arguments.
    pub function: Bound<'py, PyCFunction>,
}

/// A system of any type.
pub(crate) type AnySystem = Arc<dyn Any + Send + Sync>;

/// A system, and its parameters by their names.
type Built<'py> = (AnySystem, Bound<'py, PyDict>);

/// A kind of system: what is known without parameters.
pub(crate) struct Kind {
    pub(crate) name: &'static str,
    pub(crate) doc: &'static str,
    pub(crate) shape: Shape,
    pub(crate) fields: Option<&'static [&'static str]>,
    pub(crate) equations: &'static [&'static str],
    pub(crate) invariants: &'static [&'static str],
    pub(crate) sensitive: &'static [&'static str],
    pub(crate) rows: Vec<Row>,
    pub(crate) tangents: Tangents,
    /// Builds a system from keyword arguments; returns it with its parameters.
    pub(crate) build: for<'py> fn(&Bound<'py, PyDict>) -> PyResult<Built<'py>>,
}

impl Kind {
    pub(crate) fn of<H: Exported>() -> Self {
        Self {
            name: H::NAME,
            doc: H::DOC,
            shape: Shape::of::<H::Coords>(),
            fields: parameters::field_names::<H>(),
            equations: H::EQUATIONS,
            invariants: H::INVARIANTS,
            sensitive: H::SENSITIVE,
            rows: H::rows(),
            tangents: Tangents::of::<H>(),
            build: |keywords| {
                let system = parameters::build::<H>(H::NAME, keywords)?;
                let parameters = parameters::listed(keywords.py(), &system)?;
                Ok((Arc::new(system), parameters))
            },
        }
    }

    /// The names of all methods.
    pub(crate) fn compositions(&self) -> Vec<&'static str> {
        self.rows.iter().map(|row| row.name).collect()
    }
}
