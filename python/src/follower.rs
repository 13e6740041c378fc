//! Followers.

use std::sync::Mutex;

use pyo3::prelude::*;
use self_cell::self_cell;

use crate::assembly::Assembly;
use crate::raised::raised;

type Followers<'a> = linkage_engine::Follower<'a>;

self_cell!(
    /// A follower together with the assembly that it borrows.
    struct Cell {
        owner: Assembly,
        #[covariant]
        dependent: Followers,
    }
);

/// A follower of an assembly. Its position changes, so one thread at a time has it.
#[pyclass(frozen, module = "linkage._linkage")]
pub(crate) struct Follower {
    cell: Mutex<Cell>,
}

impl Follower {
    /// A follower at these inputs.
    ///
    /// # Errors
    ///
    /// Where the assembly does not serve.
    pub(crate) fn new(py: Python<'_>, assembly: Assembly, inputs: &[f64]) -> PyResult<Self> {
        let made = Cell::try_new(assembly, |assembly| assembly.get().follower(inputs));
        let cell = made.map_err(|error| raised(py, "AssemblyError", (error.to_string(),)))?;
        Ok(Self {
            cell: Mutex::new(cell),
        })
    }

    /// Runs something with the follower, without the lock of the interpreter.
    fn with<R: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut linkage_engine::Follower<'_>) -> R + Send,
    ) -> R {
        py.detach(|| {
            let mut cell = self.cell.lock().expect("no thread panics");
            cell.with_dependent_mut(|_, follower| work(follower))
        })
    }
}

#[pymethods]
impl Follower {
    #[getter]
    fn inputs(&self, py: Python<'_>) -> Vec<f64> {
        self.with(py, |follower| follower.inputs().to_vec())
    }

    /// Goes to other inputs.
    fn follow(&self, py: Python<'_>, inputs: Vec<f64>) -> PyResult<()> {
        let followed = self.with(py, |follower| follower.follow(&inputs));
        followed.map_err(|error| raised(py, "AssemblyError", (error.to_string(),)))
    }

    /// The columns of a function at the position.
    fn call(&self, py: Python<'_>, function: usize, arguments: Vec<f64>) -> Vec<f64> {
        self.with(py, |follower| follower.call(function, &arguments))
    }
}
