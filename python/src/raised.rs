//! Exceptions of the package, which are classes of its file `_errors.py`.

use pyo3::prelude::*;
use pyo3::{IntoPyObject, call::PyCallArgs};

/// Returns an exception of this class.
pub(crate) fn raised<'py>(py: Python<'py>, class: &str, arguments: impl PyCallArgs<'py>) -> PyErr {
    let made = py
        .import("linkage._errors")
        .and_then(|module| module.getattr(class))
        .and_then(|class| class.call1(arguments));
    match made {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}

/// Returns the exception of a mechanism that cannot be assembled.
pub(crate) fn not_assembled(py: Python<'_>, error: &linkage_engine::AssemblyError) -> PyErr {
    raised(py, "AssemblyError", (error.to_string(),))
}

/// Returns the exception of figures that do not exist.
pub(crate) fn no_figures<'py>(py: Python<'py>, text: impl IntoPyObject<'py>) -> PyErr {
    raised(py, "AnalysisError", (text,))
}
