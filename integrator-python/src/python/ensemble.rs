//! The Python class of an ensemble.

use crate::{
    arrays::{Shape, array},
    ensemble::AnyEnsemble,
    errors::{Fault, input_error},
    interrupt::{count, portions},
    python::run::PyRun,
};
use numpy::{PyArray1, PyArrayDyn};
use pyo3::prelude::*;

/// Many trajectories that are integrated together, on all cores. `System.ensemble` starts them.
#[pyclass(name = "Ensemble")]
pub(crate) struct PyEnsemble {
    pub(crate) ensemble: Box<dyn AnyEnsemble>,
    pub(crate) shape: Shape,
    pub(crate) composition: &'static str,
}

impl PyEnsemble {
    fn array<'py>(&self, py: Python<'py>, flat: Vec<f64>) -> Bound<'py, PyArrayDyn<f64>> {
        array(py, flat, &self.shape, Some(self.ensemble.members()))
    }
}

#[pymethods]
impl PyEnsemble {
    /// The time of the active members.
    #[getter]
    fn time(&self) -> f64 {
        self.ensemble.time()
    }
    /// The number of steps that the active members have taken.
    #[getter]
    fn steps(&self) -> u64 {
        self.ensemble.steps()
    }
    /// The number of steps of each member, of shape (n,). Failed members have fewer steps than the others.
    #[getter]
    fn steps_of_members<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u64>> {
        PyArray1::from_vec(py, self.ensemble.steps_of_members())
    }
    /// The number of members that have not failed.
    #[getter]
    fn active(&self) -> usize {
        self.ensemble.active()
    }
    /// The name of the composition.
    #[getter]
    fn composition(&self) -> &str {
        self.composition
    }
    /// A copy of the positions: one row for each member.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let [q, _] = self.ensemble.states();
        self.array(py, q)
    }
    /// A copy of the momenta: one row for each member.
    #[getter]
    fn p<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let [_, p] = self.ensemble.states();
        self.array(py, p)
    }
    /// The energies, of shape (n,).
    #[getter]
    fn energy<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.ensemble.energies())
    }

    /// Takes a number of steps with every active member.
    ///
    /// The GIL is released, and Ctrl-C stops all members after the same step. With `progress=True`, a bar is drawn on stderr.
    /// Raises `RunError` with `members` if members fail; the others have then taken all steps.
    #[pyo3(signature = (steps, *, progress = false))]
    fn advance(
        &mut self,
        py: Python<'_>,
        #[pyo3(from_py_with = count)] steps: u64,
        progress: bool,
    ) -> Result<(), Fault> {
        portions(py, progress, |report| self.ensemble.advance(steps, report))
    }

    /// Returns an active member as a run of its own, from its present state.
    fn run_of(&self, member: usize) -> PyResult<PyRun> {
        let run = self.ensemble.run_of(member).ok_or_else(|| {
            let members = self.ensemble.members();
            input_error(format!(
                "member {member} is not active: there are {members} members, and failed ones are not active"
            ))
        })?;
        Ok(PyRun { run, shape: self.shape.clone(), composition: self.composition })
    }

    /// Stops a member before a step that changes its energy by more than this fraction of |T| + |V|.
    fn watch_energy(&mut self, bound: f64) -> Result<(), Fault> {
        self.ensemble.watch_energy(bound)
    }

    fn __len__(&self) -> usize {
        self.ensemble.members()
    }
    fn __repr__(&self) -> String {
        let (composition, members, steps, time) = (self.composition, self.__len__(), self.steps(), self.time());
        format!("Ensemble(composition={composition:?}, members={members}, steps={steps}, time={time:?})")
    }
}
