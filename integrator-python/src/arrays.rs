//! Positions and momenta as NumPy arrays, in the shape that the user's functions have.

use crate::errors::input_error;
use integrator_core::Coords;
use numpy::{
    PyArrayDyn, PyArrayMethods, ToPyArray,
    ndarray::{ArrayD, IxDyn},
};
use pyo3::{prelude::*, types::PyTuple};

/// The shape of the positions, and of the momenta, of a system.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    /// The number of scalars, points or planes, if the type fixes it.
    length: Option<usize>,
    /// The axes of a point or of a plane; none for scalars.
    inner: Vec<usize>,
}

impl Shape {
    /// Returns the shape of coordinates.
    pub(crate) fn of<C: Coords>() -> Self {
        let inner = match (C::COMPONENTS, C::ROWS) {
            (1, None) => vec![],
            (components, None) => vec![components],
            (components, Some(rows)) => vec![rows, components.checked_div(rows).unwrap_or(0)],
        };
        Self { length: C::LENGTH, inner }
    }

    /// The axes of an array with this number of coordinates.
    pub(crate) fn axes(&self, coordinates: usize) -> Vec<usize> {
        let of_point: usize = self.inner.iter().product();
        let length = coordinates.checked_div(of_point).unwrap_or(0);
        [length].into_iter().chain(self.inner.iter().copied()).collect()
    }

    /// Returns the shape as Python writes it: `(3,)`, `(N, 3)`, or `(n, N, 3)` with one row for each of n members.
    pub(crate) fn text(&self, of_members: bool) -> String {
        let length = self.length.map_or("N".to_owned(), |length| length.to_string());
        let members = of_members.then(|| "n".to_owned());
        let axes: Vec<_> = members.into_iter().chain([length]).chain(self.inner.iter().map(usize::to_string)).collect();
        in_parentheses(&axes)
    }

    fn admits(&self, axes: &[usize], of_members: bool) -> bool {
        let axes = match (of_members, axes) {
            (true, [_, axes @ ..]) => axes,
            (true, []) => return false,
            (false, axes) => axes,
        };
        matches!(axes, [length, inner @ ..] if inner == self.inner && self.length.is_none_or(|fixed| fixed == *length))
    }

    /// What to write in place of an array with the wrong axes.
    fn help(&self, name: &str, axes: &[usize], of_members: bool) -> String {
        let transposed: Vec<_> = axes.iter().rev().copied().collect();
        if self.admits(axes, !of_members) {
            return match of_members {
                true => format!("\nhelp: write `{name}[None]` for one member, or use `run` for a single trajectory"),
                false => "\nhelp: `ensemble` integrates one trajectory for each row".to_owned(),
            };
        }
        match axes.len() > 1 && self.admits(&transposed, of_members) {
            true => format!("\nhelp: write `{name}.T`"),
            false => String::new(),
        }
    }
}

fn in_parentheses(axes: &[String]) -> String {
    match axes {
        [axis] => format!("({axis},)"),
        axes => format!("({})", axes.join(", ")),
    }
}

/// Numbers of one state, or of one state for each member, in the order of C.
#[derive(Clone, Debug)]
pub(crate) struct Numbers {
    /// All numbers.
    pub(crate) flat: Vec<f64>,
    /// The number of rows; one for a single state.
    pub(crate) rows: usize,
}

/// Reads an array, or a list of lists, of a given shape.
///
/// # Errors
/// The object is not an array of real numbers, or has another shape. The message contains both shapes.
pub(crate) fn read(name: &str, object: &Bound<'_, PyAny>, shape: &Shape, of_members: bool) -> PyResult<Numbers> {
    let py = object.py();
    let numpy = py.import("numpy")?;
    let expected = shape.text(of_members);
    let array = numpy.call_method1("asarray", (object,)).map_err(|error| {
        let reason = error.value(py);
        input_error(format!("{name} is not an array: expected numbers of shape {expected}\nnote: NumPy says: {reason}"))
    })?;
    let dtype = array.getattr("dtype")?;
    let kind: String = dtype.getattr("kind")?.extract()?;
    let bytes: usize = dtype.getattr("itemsize")?.extract()?;
    if !["f", "i", "u"].contains(&&*kind) || bytes > size_of::<f64>() {
        return Err(input_error(format!("{name} has the dtype {dtype}: expected real numbers, such as float64")));
    }
    let axes: Vec<usize> = array.getattr("shape")?.extract()?;
    if !shape.admits(&axes, of_members) {
        let axes_text: Vec<_> = axes.iter().map(usize::to_string).collect();
        let (given, help) = (in_parentheses(&axes_text), shape.help(name, &axes, of_members));
        return Err(input_error(format!("{name} has the shape {given}: expected {expected}{help}")));
    }
    // Any order in memory and any strides; this copies unless the array is float64 in the order of C.
    let array = numpy.call_method1("ascontiguousarray", (array, "f8"))?;
    let flat = array.cast::<PyArrayDyn<f64>>()?.to_vec()?;
    Ok(Numbers { flat, rows: if of_members { axes[0] } else { 1 } })
}

/// Makes an array of numbers without copying them. `count` is the length of the first axis, in front of those of a state.
pub(crate) fn array<'py>(
    py: Python<'py>,
    flat: Vec<f64>,
    shape: &Shape,
    count: Option<usize>,
) -> Bound<'py, PyArrayDyn<f64>> {
    let of_state = flat.len().checked_div(count.unwrap_or(1)).unwrap_or(0);
    let axes: Vec<_> = count.into_iter().chain(shape.axes(of_state)).collect();
    match ArrayD::from_shape_vec(IxDyn(&axes), flat) {
        Ok(array) => PyArrayDyn::from_owned_array(py, array),
        // No numbers: the other axes of a state without coordinates are unknown.
        Err(_) => ArrayD::zeros(IxDyn(&[0])).to_pyarray(py),
    }
}

/// Returns a copy of an array, or of a list of numbers, that cannot be written; other objects as they are.
pub(crate) fn frozen<'py>(object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = object.py();
    if !object.is_instance_of::<pyo3::types::PyList>() {
        return Ok(object.clone());
    }
    let Ok(array) = py.import("numpy")?.call_method1("array", (object,)) else {
        return Ok(PyTuple::new(py, object.try_iter()?.collect::<PyResult<Vec<_>>>()?)?.into_any());
    };
    array.call_method1("setflags", (false,))?;
    Ok(array)
}
