//! The Python class of a kind of system, a subclass of `System`.

use crate::{
    python::system::PySystem,
    system::{Exported, Function, Kind},
};
use pyo3::{
    prelude::*,
    types::{PyDict, PyTuple, PyType},
};
use std::sync::Arc;

/// What a class knows of its systems.
#[pyclass(name = "_Kind", frozen)]
pub(crate) struct PyKind(pub(crate) Arc<Kind>);

/// A function of the user as a method of a class: functions that are not written in Python do not bind to instances themselves.
#[pyclass(name = "_Method", frozen)]
struct PyMethod(Py<PyAny>);

#[pymethods]
impl PyMethod {
    fn __get__<'py>(
        &self,
        instance: Option<&Bound<'py, PyAny>>,
        _class: &Bound<'py, PyAny>,
        py: Python<'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        match instance {
            Some(instance) => py.import("types")?.getattr("MethodType")?.call1((&self.0, instance)),
            None => Ok(self.0.bind(py).clone()),
        }
    }
}

/// Adds the class of a kind of system to a module; returns its text in the type stubs.
pub(crate) fn add_class<H: Exported>(module: &Bound<'_, PyModule>) -> PyResult<String> {
    let py = module.py();
    let kind = Arc::new(Kind::of::<H>());
    let (contents, functions) = (PyDict::new(py), H::functions(module)?);
    contents.set_item("_kind", PyKind(kind.clone()))?;
    contents.set_item("__doc__", documentation(&kind))?;
    contents.set_item("__module__", module.name()?)?;
    contents.set_item("__slots__", PyTuple::empty(py))?;
    contents.set_item("__signature__", signature(py, &kind)?)?;
    for Function { name, function, .. } in &functions {
        contents.set_item(name, PyMethod(function.clone().into_any().unbind()))?;
    }
    let bases = PyTuple::new(py, [PyType::new::<PySystem>(py)])?;
    module.add(kind.name, py.get_type::<PyType>().call1((kind.name, bases, contents))?)?;
    Ok(stub(&kind, &functions))
}

fn documentation(kind: &Kind) -> String {
    let (doc, shape, compositions) = (kind.doc.trim(), kind.shape.text(false), kind.compositions().join(", "));
    let fields = kind.fields.map_or("those of its Rust type".to_owned(), |fields| fields.join(", "));
    format!(
        "{doc}\n\nParameters: {fields}\nShape of q and of p: {shape}\nCompositions: {compositions}\n\nTimes, q, p and energies \
         have the units of the Hamiltonian, which `equations()` shows."
    )
}

/// The signature that `help` and completion show.
fn signature<'py>(py: Python<'py>, kind: &Kind) -> PyResult<Bound<'py, PyAny>> {
    let inspect = py.import("inspect")?;
    let parameter = inspect.getattr("Parameter")?;
    let (names, how) = match kind.fields {
        Some(fields) => (fields, "KEYWORD_ONLY"),
        None => (&["parameters"][..], "VAR_KEYWORD"),
    };
    let how = parameter.getattr(how)?;
    let parameters = names.iter().map(|name| parameter.call1((*name, &how))).collect::<PyResult<Vec<_>>>()?;
    inspect.getattr("Signature")?.call1((parameters,))
}

/// The class in the type stubs of the module.
fn stub(kind: &Kind, functions: &[Function<'_>]) -> String {
    let fields = kind.fields.unwrap_or_default();
    let arguments: String = match kind.fields {
        None => ", **parameters: Any".to_owned(),
        Some([]) => String::new(),
        Some(fields) => {
            [", *"].into_iter().map(str::to_owned).chain(fields.iter().map(|name| format!(", {name}: Any"))).collect()
        }
    };
    let mut stub = format!("\nclass {}(System):\n    def __init__(self{arguments}) -> None: ...\n", kind.name);
    for name in fields {
        stub.push_str(&format!("    @property\n    def {name}(self) -> Any: ...\n"));
    }
    for Function { name, arguments, result, .. } in functions {
        let arguments: String =
            arguments.iter().map(|(name, rust)| format!(", {name}: {}", python_type(rust))).collect();
        stub.push_str(&format!("    def {name}(self{arguments}) -> {}: ...\n", python_type(result)));
    }
    stub
}

/// The Python type for a Rust type of a signature.
fn python_type(rust: &str) -> String {
    let name = match rust {
        "f64" | "f32" => "float",
        "u8" | "u16" | "u32" | "u64" | "usize" | "i8" | "i16" | "i32" | "i64" | "isize" => "int",
        "bool" => "bool",
        "String" => "str",
        "()" => "None",
        _ => match rust.strip_prefix("Vec<").and_then(|rest| rest.strip_suffix('>')) {
            Some(inner) => return format!("list[{}]", python_type(inner.trim())),
            None => "Any",
        },
    };
    name.to_owned()
}
