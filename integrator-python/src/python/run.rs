//! The Python class of a run.

use crate::{
    arrays::{Shape, array},
    errors::{Fault, input_error, unknown},
    expression::Expression,
    interrupt::{Pulse, count, portions, signalled},
    python::kind::classes,
    run::{AnyRun, Columns, Crossed},
};
use integrator_core::Direction;
use numpy::{PyArray1, PyArrayDyn};
use pyo3::{prelude::*, types::PyDict};

/// A trajectory that is being integrated. `System.run` starts it.
#[pyclass(name = "Run")]
pub(crate) struct PyRun {
    pub(crate) run: Box<dyn AnyRun>,
    pub(crate) shape: Shape,
    pub(crate) composition: &'static str,
}

#[pymethods]
impl PyRun {
    /// The time, the initial time plus the number of steps times h.
    #[getter]
    fn time(&self) -> f64 {
        self.run.time()
    }
    /// The number of steps taken.
    #[getter]
    fn steps(&self) -> u64 {
        self.run.steps()
    }
    /// The step, in units of time.
    #[getter]
    fn h(&self) -> f64 {
        self.run.step()
    }
    /// The name of the composition.
    #[getter]
    fn composition(&self) -> &str {
        self.composition
    }
    /// A copy of the present positions.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let [q, _] = self.run.state();
        array(py, q, &self.shape, None)
    }
    /// A copy of the present momenta.
    #[getter]
    fn p<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let [_, p] = self.run.state();
        array(py, p, &self.shape, None)
    }
    /// The energy of the present state.
    #[getter]
    fn energy(&self) -> f64 {
        self.run.energy()
    }

    /// Takes a number of steps.
    ///
    /// The GIL is released, and Ctrl-C stops the run after a whole step. With `progress=True`, a bar is drawn on stderr.
    /// Raises `RunError` if the state diverges; the run then stays at its last finite state.
    #[pyo3(signature = (steps, *, progress = false))]
    fn advance(
        &mut self,
        py: Python<'_>,
        #[pyo3(from_py_with = count)] steps: u64,
        progress: bool,
    ) -> Result<(), Fault> {
        portions(py, progress, |report| self.run.advance(steps, report))
    }

    /// Integrates up to a time, which need not be the end of a step.
    fn advance_to(&mut self, py: Python<'_>, time: f64) -> Result<(), Fault> {
        py.detach(|| self.run.advance_to(time))
    }

    /// Takes n samples, the first of the present state and each further one after `every` steps.
    ///
    /// Returns a named tuple of NumPy arrays: `t` and `energy` of shape (n,), and `q` and `p` of shape (n, ...) with the shape of
    /// a state; and the dictionary `invariants` with an array for each conserved quantity. The run stays at the last sample.
    /// If it fails, the exception has the samples before in `samples`.
    #[pyo3(signature = (n, *, every = 1, progress = false))]
    fn samples<'py>(
        &mut self,
        py: Python<'py>,
        #[pyo3(from_py_with = count)] n: u64,
        #[pyo3(from_py_with = count)] every: u64,
        progress: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut columns = Columns::default();
        let outcome = portions(py, progress, |report| self.run.sample(n, every, &mut columns, report));
        finished(py, outcome, columns, &self.shape)
    }

    /// Finds at most n zeros of a function of the state: a Poincaré section, or events.
    ///
    /// `function` is a coordinate such as "q[0]" or "p[1] - 0.5", where "q[0, 2]" is the third component of the first point, or
    /// a Python function f(q, p, t) of flat arrays, which is slower. `direction` is "rising", "falling" or "either". At most
    /// `steps` steps are taken. Returns a named tuple like `samples`; the run stays at the end of the step with the last
    /// crossing.
    #[pyo3(signature = (function, *, direction = "rising", n = 100, steps = 1_000_000))]
    fn crossings<'py>(
        &mut self,
        py: Python<'py>,
        function: &Bound<'_, PyAny>,
        direction: &str,
        #[pyo3(from_py_with = count)] n: u64,
        #[pyo3(from_py_with = count)] steps: u64,
    ) -> PyResult<Bound<'py, PyAny>> {
        let direction = match direction {
            "rising" => Direction::Rising,
            "falling" => Direction::Falling,
            "either" => Direction::Either,
            other => return Err(unknown(py, "direction", other, &["rising", "falling", "either"])),
        };
        let mut value = self.crossed(function)?;
        let (mut columns, mut raised, mut pulse) = (Columns::default(), None, Pulse::new());
        let outcome = py.detach(|| {
            // NaN ends the search, and the run stays at a whole step.
            let function: Crossed<'_> = &mut |q, p, t| {
                let interrupt = if pulse.is_due() { signalled() } else { None };
                interrupt.map_or_else(|| value(q, p, t), Err).unwrap_or_else(|error| {
                    raised = Some(error);
                    f64::NAN
                })
            };
            self.run.crossings(n, steps, direction, function, &mut columns)
        });
        finished(py, raised.map_or(outcome, |raised| Err(raised.into())), columns, &self.shape)
    }

    /// Returns a conserved quantity of the present state, by the name of its `#[invariant]` function.
    fn invariant(&self, name: &str) -> Result<f64, Fault> {
        self.run.invariant(name)
    }

    /// Stops the run before a step that changes the energy by more than this fraction of |T| + |V|.
    fn watch_energy(&mut self, bound: f64) -> Result<(), Fault> {
        self.run.watch_energy(bound)
    }

    fn __repr__(&self) -> String {
        let (composition, h, steps, time) = (self.composition, self.h(), self.steps(), self.time());
        format!("Run(composition={composition:?}, h={h:?}, steps={steps}, time={time:?})")
    }
}

type Evaluated = Box<dyn FnMut(&[f64], &[f64], f64) -> PyResult<f64> + Send>;

impl PyRun {
    /// The function of a crossing: a text, or a function of Python.
    fn crossed(&self, function: &Bound<'_, PyAny>) -> PyResult<Evaluated> {
        if let Ok(text) = function.extract::<String>() {
            let [q, _] = self.run.state();
            let expression = Expression::parse(&text, &self.shape.axes(q.len()))?;
            return Ok(Box::new(move |q, p, _| Ok(expression.value(q, p))));
        }
        if !function.is_callable() {
            return Err(input_error(
                "a crossing needs a coordinate such as \"q[0]\", or a function f(q, p, t)".to_owned(),
            ));
        }
        let function = function.clone().unbind();
        Ok(Box::new(move |q, p, t| {
            Python::attach(|py| {
                let [q, p] = [q, p].map(|flat| PyArray1::from_slice(py, flat));
                function.call1(py, (q, p, t))?.extract(py)
            })
        }))
    }
}

/// The samples of a call, or its error with the samples before it.
fn finished<'py>(
    py: Python<'py>,
    outcome: Result<(), Fault>,
    columns: Columns,
    shape: &Shape,
) -> PyResult<Bound<'py, PyAny>> {
    let samples = named_tuple(py, columns, shape)?;
    outcome.map_err(|fault| {
        let error = PyErr::from(fault);
        // Not every exception takes attributes; it is raised all the same.
        let _ = error.value(py).setattr("samples", &samples);
        error
    })?;
    Ok(samples)
}

/// Moves columns into arrays, without copying them.
fn named_tuple<'py>(py: Python<'py>, columns: Columns, shape: &Shape) -> PyResult<Bound<'py, PyAny>> {
    let (count, invariants) = (Some(columns.t.len()), PyDict::new(py));
    for (name, values) in columns.invariants {
        invariants.set_item(name, PyArray1::from_vec(py, values))?;
    }
    let [q, p] = [columns.q, columns.p].map(|flat| array(py, flat, shape, count));
    let [t, energy] = [columns.t, columns.energy].map(|column| PyArray1::from_vec(py, column));
    classes(py)?.getattr("Samples")?.call1((t, q, p, energy, invariants))
}
