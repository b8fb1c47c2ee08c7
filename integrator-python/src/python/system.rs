//! The Python class of a system. The class of each kind of system is a subclass.

use crate::{
    arrays::{Shape, array, read},
    errors::{Fault, input_error, nearest, unknown},
    interrupt::{count, interruptible},
    methods::{Derivatives, Row, SCALARS, Start, of},
    python::{
        ensemble::PyEnsemble,
        kind::{PyKind, classes},
        run::PyRun,
    },
    system::{AnySystem, Exported, Kind},
};
use integrator_core::chaos::Indicator;
use numpy::{PyArray1, PyArrayDyn};
use pyo3::{
    exceptions::{PyAttributeError, PyTypeError},
    prelude::*,
    types::{PyDict, PyTuple, PyType},
};
use std::sync::Arc;

/// A Hamiltonian with its parameters, which are attributes.
#[pyclass(name = "System", subclass, frozen)]
pub struct PySystem {
    system: AnySystem,
    kind: Arc<Kind>,
    parameters: Py<PyDict>,
}

/// How an orbit starts: a method, a scalar, a step, a time and a seed.
struct How<'h> {
    composition: Option<&'h str>,
    scalar: &'h str,
    h: f64,
    time: f64,
    seed: u64,
}

impl PySystem {
    /// Returns the system itself.
    ///
    /// # Errors
    /// It has another type.
    pub fn of<H: Exported>(&self) -> PyResult<&H> {
        of(&self.system)
    }

    /// The method of an orbit, and its start.
    fn start(
        &self,
        q: &Bound<'_, PyAny>,
        p: &Bound<'_, PyAny>,
        how: &How<'_>,
        of_members: bool,
    ) -> PyResult<(&Row, Start)> {
        let (py, names) = (q.py(), self.kind.compositions());
        let row = how.composition.map_or(Some(0), |name| names.iter().position(|known| *known == name));
        let row = row.and_then(|row| self.kind.rows.get(row));
        let row = row.ok_or_else(|| unknown(py, "composition", how.composition.unwrap_or_default(), &names))?;
        let scalar = SCALARS.iter().find(|(name, _)| *name == how.scalar).map(|(_, scalar)| *scalar);
        let scalar = scalar.ok_or_else(|| unknown(py, "scalar", how.scalar, &SCALARS.map(|(name, _)| name)))?;
        let state = [read("q", q, &self.kind.shape, of_members)?, read("p", p, &self.kind.shape, of_members)?];
        let [of_q, of_p] = [state[0].rows, state[1].rows];
        if of_q != of_p {
            let message = format!("q has {of_q} rows, but p has {of_p}: expected one row each for every member");
            return Err(input_error(message));
        }
        Ok((row, Start { state, scalar, h: how.h, time: how.time, seed: how.seed }))
    }

    /// The systems of members whose parameters are arrays with one row for each member.
    fn members(&self, py: Python<'_>, count: usize, parameters: &Bound<'_, PyDict>) -> PyResult<Vec<AnySystem>> {
        for (name, values) in parameters {
            let length = values.len().map_or("one value".to_owned(), |length| format!("{length} values"));
            if !length.starts_with(&format!("{count} ")) {
                let message = format!("the parameter `{name}` has {length}: expected one for each of {count} members");
                return Err(input_error(message));
            }
        }
        let of_member = |member: usize| {
            let keywords = self.parameters.bind(py).copy()?;
            for (name, values) in parameters {
                keywords.set_item(name, values.get_item(member)?)?;
            }
            Ok((self.kind.build)(&keywords)?.0)
        };
        (0..count).map(of_member).collect()
    }
}

type Array<'py> = Bound<'py, PyArrayDyn<f64>>;
type Gradient<'py> = (f64, (Array<'py>, Array<'py>, Bound<'py, PyDict>));

/// The value of a function of Python at the end of a run, and its derivatives there.
fn cotangent(loss: &Bound<'_, PyAny>, q: &[f64], p: &[f64], shape: &Shape) -> PyResult<(f64, [Vec<f64>; 2])> {
    let [at_q, at_p] = [q, p].map(|half| array(loss.py(), half.to_vec(), shape, None));
    let returned = loss.call1((at_q, at_p))?;
    let (value, (by_q, by_p)): (f64, (Bound<'_, PyAny>, Bound<'_, PyAny>)) = returned.extract().map_err(|_| {
        input_error(format!("loss(q, p) returned {returned}: expected (value, (derivatives by q, derivatives by p))"))
    })?;
    let derivatives = [("the derivatives by q", by_q, q), ("the derivatives by p", by_p, p)];
    let [by_q, by_p] = derivatives.map(|(name, object, half)| {
        let numbers = read(name, &object, shape, false)?.flat;
        let (given, expected) = (numbers.len(), half.len());
        let wrong = || input_error(format!("{name} have {given} numbers: expected {expected}"));
        if given == expected { Ok(numbers) } else { Err(wrong()) }
    });
    Ok((value, [by_q?, by_p?]))
}

#[pymethods]
impl PySystem {
    #[new]
    #[classmethod]
    #[pyo3(signature = (*arguments, **keywords))]
    fn new(
        class: &Bound<'_, PyType>,
        arguments: &Bound<'_, PyTuple>,
        keywords: Option<Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let py = class.py();
        let Ok(kind) = class.getattr("_kind") else {
            return Err(PyTypeError::new_err("System is the base of the systems of a module: create one of those"));
        };
        let kind = kind.cast::<PyKind>()?.get().0.clone();
        if !arguments.is_empty() {
            let (name, fields) = (kind.name, kind.fields.unwrap_or_default());
            let example: Vec<_> = fields.iter().map(|field| format!("{field}=...")).collect();
            let message = format!("the parameters of {name} have names\nhelp: write `{name}({})`", example.join(", "));
            return Err(PyTypeError::new_err(message));
        }
        let (system, parameters) = (kind.build)(&keywords.unwrap_or_else(|| PyDict::new(py)))?;
        Ok(Self { system, kind, parameters: parameters.unbind() })
    }

    /// Starts a run from positions q and momenta p with steps of h, which is negative for a run backwards.
    ///
    /// q and p have the shape of the arguments of the Hamiltonian, which the class documents. `composition` is the name of a
    /// method of `compositions`; the default is that of the `#[hamiltonian]` annotation. `scalar` is "f64" or "compensated",
    /// which carries the rounding errors of updates. `time` is the initial time. `seed` is that of the random numbers of a system
    /// with a temperature.
    #[allow(clippy::too_many_arguments, reason = "Python writes most of them as keywords, or leaves them out")]
    #[pyo3(signature = (q, p, h, *, composition = None, scalar = "f64", time = 0.0, seed = 0))]
    fn run(
        &self,
        q: &Bound<'_, PyAny>,
        p: &Bound<'_, PyAny>,
        h: f64,
        composition: Option<&str>,
        scalar: &str,
        time: f64,
        seed: u64,
    ) -> Result<PyRun, Fault> {
        let (row, start) = self.start(q, p, &How { composition, scalar, h, time, seed }, false)?;
        let run = (row.run)(&self.system, start)?;
        Ok(PyRun { run, shape: self.kind.shape.clone(), composition: row.name })
    }

    /// Starts an ensemble: one trajectory for each row of q and p, integrated together on all cores.
    ///
    /// Each member is bitwise identical to a run of its own; member 0 of a system with a temperature, to a run with its seed. Further keyword arguments are parameters with one value for each
    /// member, such as `mass=[1.0, 2.0]`; all other parameters are those of this system.
    #[allow(clippy::too_many_arguments, reason = "Python writes most of them as keywords, or leaves them out")]
    #[pyo3(signature = (q, p, h, *, composition = None, time = 0.0, seed = 0, **parameters))]
    fn ensemble(
        &self,
        q: &Bound<'_, PyAny>,
        p: &Bound<'_, PyAny>,
        h: f64,
        composition: Option<&str>,
        time: f64,
        seed: u64,
        parameters: Option<Bound<'_, PyDict>>,
    ) -> Result<PyEnsemble, Fault> {
        let py = q.py();
        let (row, start) = self.start(q, p, &How { composition, scalar: "f64", h, time, seed }, true)?;
        let members = match parameters {
            Some(parameters) => self.members(py, start.state[0].rows, &parameters)?,
            None => vec![self.system.clone()],
        };
        let ensemble = py.detach(|| (row.ensemble)(&members, start))?;
        Ok(PyEnsemble { ensemble, shape: self.kind.shape.clone(), composition: row.name })
    }

    /// Verifies by measurement that a composition integrates this system from q and p as it claims.
    ///
    /// Returns the text of the certificate. Raises `RunError` with all measurements if a property does not hold.
    #[pyo3(signature = (q, p, h, *, composition = None, time = 0.0))]
    fn certify(
        &self,
        py: Python<'_>,
        q: &Bound<'_, PyAny>,
        p: &Bound<'_, PyAny>,
        h: f64,
        composition: Option<&str>,
        time: f64,
    ) -> Result<String, Fault> {
        let (row, start) = self.start(q, p, &How { composition, scalar: "f64", h, time, seed: 0 }, false)?;
        py.detach(|| (row.certify)(&self.system, start))
    }

    /// Computes all Lyapunov exponents of an orbit, in units of 1 / time.
    ///
    /// Returns the exponents in descending order and their uncertainties, two arrays with as many numbers as q and p.
    #[pyo3(signature = (q, p, h, steps))]
    fn lyapunov_spectrum<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'_, PyAny>,
        p: &Bound<'_, PyAny>,
        h: f64,
        #[pyo3(from_py_with = count)] steps: u64,
    ) -> Result<[Bound<'py, PyArray1<f64>>; 2], Fault> {
        let (_, start) = self.start(q, p, &How { composition: None, scalar: "f64", h, time: 0.0, seed: 0 }, false)?;
        let spectrum = py.detach(|| (self.kind.tangents.spectrum)(&self.system, start, steps))?;
        Ok([spectrum.exponents, spectrum.uncertainties].map(|numbers| PyArray1::from_vec(py, numbers)))
    }

    /// Computes an indicator of chaos for the orbit from each row of q and p; returns an array of shape (n,).
    ///
    /// `indicator` is "megno" (2 on regular orbits), "exponent" (the largest Lyapunov exponent) or "fli". An orbit that
    /// diverges has the indicator of its last sample. Ctrl-C stops the computation.
    #[pyo3(signature = (q, p, h, steps, *, indicator = "megno"))]
    fn chaos_map<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'_, PyAny>,
        p: &Bound<'_, PyAny>,
        h: f64,
        #[pyo3(from_py_with = count)] steps: u64,
        indicator: &str,
    ) -> Result<Bound<'py, PyArray1<f64>>, Fault> {
        let indicator = match indicator {
            "megno" => Indicator::Megno,
            "exponent" => Indicator::Exponent,
            "fli" => Indicator::Fli,
            other => return Err(unknown(py, "indicator", other, &["megno", "exponent", "fli"]).into()),
        };
        let (_, start) = self.start(q, p, &How { composition: None, scalar: "f64", h, time: 0.0, seed: 0 }, true)?;
        let found =
            interruptible(py, |goes_on| (self.kind.tangents.map)(&self.system, start, steps, indicator, goes_on))?;
        Ok(PyArray1::from_vec(py, found))
    }

    /// Computes a function of the end of a run, and its derivatives by a run back, whatever their number.
    ///
    /// `loss(q, p)` returns its value at the end of the run, and its derivatives with respect to q and p there, as a pair of
    /// arrays in the shape of q: `(value, (by_q, by_p))`. The method is the composition of the annotation, which has to be
    /// symmetric. Returns `(value, (by_q, by_p, by_parameters))`: the derivatives with respect to the start, and a dictionary of
    /// those with respect to the parameters in `sensitive(...)` of the annotation. They are exact for the steps taken.
    fn value_and_grad<'py>(
        &self,
        py: Python<'py>,
        loss: &Bound<'py, PyAny>,
        q: &Bound<'_, PyAny>,
        p: &Bound<'_, PyAny>,
        h: f64,
        #[pyo3(from_py_with = count)] steps: u64,
    ) -> Result<Gradient<'py>, Fault> {
        let (_, start) = self.start(q, p, &How { composition: None, scalar: "f64", h, time: 0.0, seed: 0 }, false)?;
        let (mut raised, loss, shape) = (None, loss.clone().unbind(), &self.kind.shape);
        let mut at_end = |q: &[f64], p: &[f64]| {
            // NaN ends the computation.
            Python::attach(|py| cotangent(loss.bind(py), q, p, shape)).unwrap_or_else(|error| {
                raised = Some(error);
                (f64::NAN, [q, p].map(|half| vec![f64::NAN; half.len()]))
            })
        };
        let found = py.detach(|| (self.kind.tangents.gradient)(&self.system, start, steps, &mut at_end));
        let Derivatives { value, by_start: [q, p], by_parameters } = match raised {
            Some(raised) => return Err(raised.into()),
            None => found?,
        };
        let parameters = PyDict::new(py);
        for (name, derivative) in self.kind.sensitive.iter().zip(by_parameters) {
            parameters.set_item(name, derivative)?;
        }
        Ok((value, (array(py, q, shape, None), array(py, p, shape, None), parameters)))
    }

    /// Returns the energies and the equations of motion, which notebooks show as formulas.
    fn equations<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        classes(py)?.getattr("Equations")?.call1((self.kind.equations.to_vec(),))
    }

    /// Returns a system with some parameters changed.
    #[pyo3(signature = (**parameters))]
    fn replace<'py>(slf: &Bound<'py, Self>, parameters: Option<Bound<'py, PyDict>>) -> PyResult<Bound<'py, PyAny>> {
        let all = slf.get().parameters.bind(slf.py()).copy()?;
        if let Some(parameters) = parameters {
            all.update(parameters.as_mapping())?;
        }
        slf.get_type().call((), Some(&all))
    }

    /// The names of the methods that runs can choose from; the default is the first.
    #[getter]
    fn compositions(&self) -> Vec<&'static str> {
        self.kind.compositions()
    }
    /// The names of the conserved quantities.
    #[getter]
    fn invariants(&self) -> Vec<&'static str> {
        self.kind.invariants.to_vec()
    }
    /// The parameters by their names.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.parameters.bind(py).copy()
    }

    fn __getattr__(&self, py: Python<'_>, name: &str) -> PyResult<Py<PyAny>> {
        let value = self.parameters.bind(py).get_item(name)?;
        value.map(Bound::unbind).ok_or_else(|| {
            let help = nearest(py, name, self.kind.fields.unwrap_or_default());
            PyAttributeError::new_err(format!("{} has no attribute `{name}`{help}", self.kind.name))
        })
    }
    fn __setattr__(&self, name: &str, _value: &Bound<'_, PyAny>) -> PyResult<()> {
        let message =
            format!("the parameters of a system are fixed\nhelp: write `system.replace({name}=...)`, a new system");
        Err(PyAttributeError::new_err(message))
    }
    fn __delattr__(&self, name: &str) -> PyResult<()> {
        Err(PyAttributeError::new_err(format!("`{name}` cannot be deleted: the parameters of a system are fixed")))
    }
    fn __dir__(slf: &Bound<'_, Self>) -> PyResult<Vec<String>> {
        let mut names: Vec<String> = slf.get_type().dir()?.extract()?;
        names.extend(slf.get().parameters.bind(slf.py()).keys().extract::<Vec<String>>()?);
        Ok(names)
    }
    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let parameters = self.parameters.bind(py).iter();
        let shown =
            parameters.map(|(name, value)| Ok(format!("{name}={}", value.repr()?))).collect::<PyResult<Vec<_>>>()?;
        Ok(format!("{}({})", self.kind.name, shown.join(", ")))
    }
    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        Ok((PyTuple::empty(py), self.parameters(py)?))
    }
}
