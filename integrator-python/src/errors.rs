//! Python exceptions with the library's messages.

use integrator_core::{
    Error, Lost,
    check::{CertifyError, CheckError},
};
use pyo3::{
    create_exception,
    exceptions::{PyRuntimeError, PyValueError},
    prelude::*,
};

create_exception!(
    integrator_python,
    InputError,
    PyValueError,
    "Wrong input: the shape or the type of an array, an initial state, a step, or a parameter of the system."
);
create_exception!(
    integrator_python,
    RunError,
    PyRuntimeError,
    "A run that cannot continue, for example because its state diverged, or a certification that failed.\n\n\
     The run stays at its last finite state. `samples` has the samples before the failure, if samples were taken. `members` \
     has the index and the message of each failed member of an ensemble."
);

/// The reason why a call fails.
#[derive(Debug)]
pub enum Fault {
    /// An error of a run.
    Run(Error),
    /// Any other reason, as an exception.
    Raised(PyErr),
}

impl From<Error> for Fault {
    fn from(error: Error) -> Self {
        Self::Run(error)
    }
}

impl From<CheckError> for Fault {
    fn from(error: CheckError) -> Self {
        match error {
            CheckError::Run(error) => Self::Run(error),
            CheckError::TooFewSteps { .. } => Self::Raised(input_error(error.to_string())),
            _ => Self::Raised(RunError::new_err(error.to_string())),
        }
    }
}

impl From<CertifyError> for Fault {
    fn from(error: CertifyError) -> Self {
        match error {
            CertifyError::Run(error) => Self::Run(error),
            _ => Self::Raised(RunError::new_err(error.to_string())),
        }
    }
}

impl From<PyErr> for Fault {
    fn from(error: PyErr) -> Self {
        Self::Raised(error)
    }
}

impl From<Fault> for PyErr {
    fn from(fault: Fault) -> Self {
        let error = match fault {
            Fault::Raised(error) => return error,
            Fault::Run(error) => error,
        };
        let message = error.to_string();
        let members: Vec<_> = match error {
            Error::Lost(Lost { members }) => {
                members.into_iter().map(|(member, reason)| (member, reason.to_string())).collect()
            }
            Error::Strayed { members } => {
                members.into_iter().map(|(member, reason)| (member, reason.to_string())).collect()
            }
            Error::Diverged(_)
            | Error::NotSolved { .. }
            | Error::EnergyStrayed { .. }
            | Error::NoEnergy { .. }
            | Error::Crossing { .. }
            | Error::Vector { .. }
            | Error::WayBack { .. }
            | Error::Misread(_) => vec![],
            _ => return input_error(message),
        };
        let error = RunError::new_err(message);
        Python::attach(|py| error.value(py).setattr("members", members)).err().unwrap_or(error)
    }
}

/// An error of the user's input.
pub(crate) fn input_error(message: String) -> PyErr {
    InputError::new_err(message)
}

/// The error of a word that is not in a list.
pub(crate) fn unknown(py: Python<'_>, what: &str, word: &str, known: &[&str]) -> PyErr {
    let (help, known) = (nearest(py, word, known), known.join(", "));
    input_error(format!("there is no {what} {word:?}{help}\nnote: the known names are {known}"))
}

/// A line that suggests the known word that is most similar to another, if one is.
pub(crate) fn nearest(py: Python<'_>, word: &str, known: &[&str]) -> String {
    let matches = py.import("difflib").and_then(|difflib| difflib.call_method1("get_close_matches", (word, known, 1)));
    let first = matches.and_then(|matches| matches.extract::<Vec<String>>()).ok().and_then(|mut words| words.pop());
    first.map_or(String::new(), |word| format!("\nhelp: write `{word}`"))
}
