//! The Python class of a kind of system, a subclass of `System`. It is built in Python.

use crate::{
    python::system::PySystem,
    system::{Exported, Function, Kind},
};
use pyo3::{prelude::*, sync::PyOnceLock};
use std::sync::Arc;

/// What a class knows of its systems.
#[pyclass(name = "_Kind", frozen)]
pub(crate) struct PyKind(pub(crate) Arc<Kind>);

#[pymethods]
impl PyKind {
    #[getter]
    fn name(&self) -> &'static str {
        self.0.name
    }
}

/// What is written in Python: `classes.py`.
pub(crate) fn classes(py: Python<'_>) -> PyResult<&Bound<'_, PyModule>> {
    static CLASSES: PyOnceLock<Py<PyModule>> = PyOnceLock::new();
    let classes = CLASSES.get_or_try_init(py, || {
        let text = std::ffi::CString::new(include_str!("../classes.py"))?;
        PyModule::from_code(py, &text, c"classes.py", c"integrator_python").map(Bound::unbind)
    })?;
    Ok(classes.bind(py))
}

/// Adds the class of a kind of system to a module; returns its text in the type stubs.
pub(crate) fn add_class<H: Exported>(module: &Bound<'_, PyModule>) -> PyResult<String> {
    let py = module.py();
    let kind = Arc::new(Kind::of::<H>());
    let functions = H::functions(module)?.into_iter();
    let functions: Vec<_> = functions
        .map(|Function { name, function, arguments, result }| (name, function, arguments.to_vec(), result))
        .collect();
    let (base, shape) = (py.get_type::<PySystem>(), kind.shape.text(false));
    let (fields, compositions) = (kind.fields.map(<[_]>::to_vec), kind.compositions());
    let arguments = (base, module.name()?, PyKind(kind.clone()), kind.doc, shape, fields, compositions, functions);
    let (class, stubs): (Bound<'_, PyAny>, String) =
        classes(py)?.getattr("system_class")?.call1(arguments)?.extract()?;
    module.add(kind.name, class)?;
    Ok(stubs)
}
