//! The equations of motion, as text and as LaTeX.

use crate::latex;
use pyo3::prelude::*;

/// The energies and the equations of motion of a system. `print` shows text; a notebook shows formulas.
#[pyclass(name = "Equations", frozen)]
pub(crate) struct PyEquations {
    pub(crate) lines: Vec<&'static str>,
}

#[pymethods]
impl PyEquations {
    /// The formulas as text, one for each equation.
    #[getter]
    fn lines(&self) -> Vec<&'static str> {
        self.lines.clone()
    }
    fn __str__(&self) -> String {
        match self.lines.is_empty() {
            true => "The equations of this system are too long to be shown.".to_owned(),
            false => self.lines.join("\n"),
        }
    }
    fn __repr__(&self) -> String {
        self.__str__()
    }
    /// Returns the formulas as LaTeX, which notebooks show.
    fn _repr_latex_(&self) -> Option<String> {
        let lines: Vec<_> = self.lines.iter().map(|line| latex::line(line)).collect();
        (!lines.is_empty()).then(|| format!("$$\\begin{{aligned}}\n{}\n\\end{{aligned}}$$", lines.join(" \\\\\n")))
    }
}
