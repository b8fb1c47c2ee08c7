//! The macro that makes a Python module.

use crate::{
    errors::{InputError, RunError},
    python::{
        ensemble::PyEnsemble,
        kind::{add_class, classes},
        run::PyRun,
        system::PySystem,
    },
    system::Exported,
};
use pyo3::{prelude::*, types::PyCFunction};

/// The type stubs of the classes that all modules have.
const CLASSES: &str = include_str!("../classes.pyi");

/// Makes a Python module of a system, or of several.
///
/// ```text
/// integrator_python::module! {
///     /// A flattened logarithmic potential.
///     galaxy: Galaxy,
///     compositions = [Verlet, KahanLi8],
///     methods = {
///         /// The velocity of a circular orbit in the plane.
///         fn circular_velocity(&self, r: f64) -> f64;
///     };
///     /// A harmonic oscillator.
///     Oscillator
/// }
/// ```
///
/// - `galaxy` is the name of the Python module, and of the library in Cargo.toml: `[lib] crate-type = ["cdylib"]`.
/// - Each type derives `Clone`, `serde::Deserialize` and `serde::Serialize`. Its fields are the keyword arguments of the class.
///   `#[serde(default)]` gives a field a default, and `#[serde(skip)]` hides it.
/// - `compositions` lists the methods that runs can choose from, besides that of the annotation: compositions, also your own,
///   and implicit methods. Without a list, they are the usual ones that can integrate the system. A system with
///   `#[hamiltonian(taylor)]` has `Taylor` as well.
/// - `methods` lists functions of the type that Python can call. Arguments are numbers, strings, `Vec`s and whatever else
///   implements `pyo3::FromPyObject`; results are what implements `pyo3::IntoPyObject`.
#[macro_export]
macro_rules! module {
    (
        $(#[doc = $doc:literal])* $module:ident : $first:ident
        $(, compositions = [$($composition:ty),* $(,)?])? $(, methods = {$($methods:tt)*})?
        $(; $(#[doc = $other_doc:literal])* $other:ident
            $(, compositions = [$($other_composition:ty),* $(,)?])? $(, methods = {$($other_methods:tt)*})?)*
        $(;)? $(,)?
    ) => {
        $crate::module!(@exported [$($doc)*] $first [$([$($composition),*])?] [$($($methods)*)?]);
        $($crate::module!(
            @exported [$($other_doc)*] $other [$([$($other_composition),*])?] [$($($other_methods)*)?]
        );)*

        #[$crate::pyo3::pymodule]
        #[pyo3(crate = "integrator_python::pyo3")]
        fn $module(module: &$crate::pyo3::Bound<'_, $crate::pyo3::types::PyModule>) -> $crate::pyo3::PyResult<()> {
            $crate::Contents::new(module).with::<$first>()?$(.with::<$other>()?)*.finish()
        }
    };
    (@exported [$($doc:literal)*] $system:ident $compositions:tt $methods:tt) => {
        impl $crate::Exported for $system {
            const NAME: &'static str = stringify!($system);
            const DOC: &'static str = concat!($($doc, "\n"),*);

            fn rows() -> Vec<$crate::Row> {
                $crate::Row::all::<Self>($crate::module!(@rows $system $compositions))
            }
            fn functions<'py>(
                module: &$crate::pyo3::Bound<'py, $crate::pyo3::types::PyModule>,
            ) -> $crate::pyo3::PyResult<Vec<$crate::Function<'py>>> {
                $crate::module!(@functions module $system $methods)
            }
        }
    };
    (@rows $system:ident []) => { None };
    (@rows $system:ident [[$($composition:ty),*]]) => { Some(vec![$($crate::Row::of::<$system, $composition>(<$composition>::default())),*]) };
    (@functions $module:ident $system:ident []) => {{
        let _ = $module;
        Ok(vec![])
    }};
    (@functions $module:ident $system:ident [$(
        $(#[doc = $doc:literal])* fn $function:ident(&self $(, $argument:ident: $type:ty)* $(,)?) -> $result:ty $(;)?
    )*]) => {
        Ok(vec![$({
            #[$crate::pyo3::pyfunction]
            #[pyo3(crate = "integrator_python::pyo3")]
            $(#[doc = $doc])*
            fn $function(
                system: &$crate::pyo3::Bound<'_, $crate::System>,
                $($argument: $type),*
            ) -> $crate::pyo3::PyResult<$result> {
                Ok(system.get().of::<$system>()?.$function($($argument),*))
            }
            $crate::Function {
                name: stringify!($function),
                arguments: &[$((stringify!($argument), stringify!($type))),*],
                result: stringify!($result),
                function: $crate::pyo3::wrap_pyfunction!($function, $module)?,
            }
        }),*])
    };
}

/// The contents of a module. [`module!`](crate::module) fills it.
pub struct Contents<'m, 'py> {
    module: &'m Bound<'py, PyModule>,
    stubs: String,
}

impl<'m, 'py> Contents<'m, 'py> {
    /// Begins with an empty module.
    pub fn new(module: &'m Bound<'py, PyModule>) -> Self {
        Self { module, stubs: CLASSES.to_owned() }
    }

    /// Adds the class of a system.
    ///
    /// # Errors
    /// Python has no memory left.
    pub fn with<H: Exported>(mut self) -> PyResult<Self> {
        self.stubs.push_str(&add_class::<H>(self.module)?);
        Ok(self)
    }

    /// Adds what all modules have.
    ///
    /// # Errors
    /// Python has no memory left.
    pub fn finish(self) -> PyResult<()> {
        let (module, py, stubs) = (self.module, self.module.py(), self.stubs);
        for (name, class) in [
            ("System", py.get_type::<PySystem>().into_any()),
            ("Run", py.get_type::<PyRun>().into_any()),
            ("Ensemble", py.get_type::<PyEnsemble>().into_any()),
            ("InputError", py.get_type::<InputError>().into_any()),
            ("RunError", py.get_type::<RunError>().into_any()),
            ("Samples", classes(py)?.getattr("Samples")?),
            ("Equations", classes(py)?.getattr("Equations")?),
        ] {
            class.setattr("__module__", module.name()?)?;
            module.add(name, class)?;
        }
        let doc = c"Returns the type stubs of this module, the text of a .pyi file.";
        let stubs = PyCFunction::new_closure(py, Some(c"stubs"), Some(doc), move |_, _| stubs.clone())?;
        module.add("stubs", stubs)
    }
}
