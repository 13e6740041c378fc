//! Assembled mechanisms, and the values of their functions.

use std::sync::Arc;

use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray2};
use pyo3::prelude::*;
use self_cell::self_cell;

use crate::analysis::{Curve, Effects, curve, effects};
use crate::circuits::unknowns;
use crate::follower::Follower;
use crate::sweep::{fill, gaps};

type Assemblies<'a> = Vec<linkage_engine::Assembly<'a>>;

self_cell!(
    /// Assemblies together with the mechanism that they borrow.
    pub(crate) struct Cell {
        owner: Arc<linkage_engine::Mechanism>,
        #[covariant]
        dependent: Assemblies,
    }
);

/// An assembled mechanism.
#[pyclass(frozen, module = "linkage._linkage")]
pub(crate) struct Assembly {
    all: Arc<Cell>,
    index: usize,
}

impl Assembly {
    /// One of some assemblies.
    pub(crate) fn new(all: Arc<Cell>, index: usize) -> Self {
        Self { all, index }
    }

    /// Each of some assemblies.
    pub(crate) fn all(cell: &Arc<Cell>) -> Vec<Self> {
        let indices = 0..cell.borrow_dependent().len();
        indices
            .map(|index| Self::new(Arc::clone(cell), index))
            .collect()
    }

    /// The assembly of the engine.
    pub(crate) fn get(&self) -> &linkage_engine::Assembly<'_> {
        &self.all.borrow_dependent()[self.index]
    }

    fn mechanism(&self) -> &linkage_engine::Mechanism {
        self.all.borrow_owner()
    }
}

#[pymethods]
impl Assembly {
    #[getter]
    fn dimensions(&self) -> Vec<f64> {
        self.get().dimensions().to_vec()
    }

    /// A follower at these inputs.
    fn follower(&self, py: Python<'_>, inputs: Vec<f64>) -> PyResult<Follower> {
        Follower::new(py, Self::new(Arc::clone(&self.all), self.index), &inputs)
    }

    #[getter]
    fn modes(&self) -> Vec<i32> {
        let modes = self.get().modes().iter();
        modes.map(|mode| mode.sign() as i32).collect()
    }

    /// Centre and windings of each continuous angle.
    #[getter]
    fn turns(&self) -> Vec<f64> {
        self.get().turns()
    }

    #[getter]
    fn served(&self) -> f64 {
        self.get().served()
    }

    /// Values of the unknowns at these inputs.
    fn unknowns(&self, inputs: Vec<f64>) -> Vec<(&'static str, Vec<f64>)> {
        unknowns(&self.get().unknowns(&inputs))
    }

    /// Whether the declared range has no findings, and the report.
    fn check_range(&self, py: Python<'_>) -> (bool, String) {
        let report = py.detach(|| self.get().check_range());
        (report.is_sound(), report.to_string())
    }

    /// The columns of a function at one position.
    fn call(&self, function: usize, arguments: Vec<f64>) -> Vec<f64> {
        self.get().call(function, &arguments)
    }

    /// Fills the rows of an array, one for each column of a function, at many positions. Arguments
    /// and dimensions are arrays with a number for each position, or one for all of them.
    fn sweep(
        &self,
        py: Python<'_>,
        function: usize,
        dimensions: Option<Vec<PyReadonlyArray1<'_, f64>>>,
        arguments: Vec<PyReadonlyArray1<'_, f64>>,
        mut out: PyReadwriteArray2<'_, f64>,
        threads: usize,
    ) -> PyResult<()> {
        let arguments = slices(&arguments)?;
        let sweep = match &dimensions {
            None => self.get().sweep_in_parts(function, &arguments),
            Some(dimensions) => {
                let dimensions = slices(dimensions)?;
                let assembly = self.get();
                assembly.sweep_sets_in_parts(function, &dimensions, &arguments)
            }
        };
        let positions = sweep.positions().max(1);
        let columns = out.as_slice_mut()?.chunks_mut(positions).collect();
        fill(py, &sweep, columns, threads)
    }

    /// Fills the rows of an array, one for each group, with the gaps by which they miss closing.
    /// Inputs are arrays of the array's length.
    fn gaps(
        &self,
        py: Python<'_>,
        inputs: Vec<PyReadonlyArray1<'_, f64>>,
        mut out: PyReadwriteArray2<'_, f64>,
    ) -> PyResult<()> {
        let inputs = slices(&inputs)?;
        gaps(py, self.get(), &inputs, out.as_slice_mut()?)
    }

    /// Effects of the tolerances on each sensitive quantity of a function, at all positions of an
    /// array of its columns.
    fn effects(
        &self,
        py: Python<'_>,
        function: usize,
        columns: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<Vec<Effects>> {
        let shape = columns.as_array().dim();
        let numbers = columns.as_slice()?;
        effects(py, self.mechanism(), function, numbers, shape.1)
    }

    /// The curve of a quantity over the range of an argument: its column with those of one to three
    /// derivatives.
    #[allow(clippy::too_many_arguments, reason = "all of them are plain numbers")]
    fn curve(
        &self,
        py: Python<'_>,
        function: usize,
        arguments: Vec<f64>,
        running: usize,
        columns: Vec<usize>,
        range: (f64, f64),
        positions: usize,
        band: Option<f64>,
        units: (String, String),
    ) -> PyResult<Curve> {
        let jet = |x: f64| {
            let mut arguments = arguments.clone();
            arguments[running] = x;
            let numbers = self.get().call(function, &arguments);
            columns.iter().map(|&column| numbers[column]).collect()
        };
        curve(py, jet, columns.len(), range, positions, band, &units)
    }
}

/// The numbers of arrays.
fn slices<'a>(arrays: &'a [PyReadonlyArray1<'_, f64>]) -> PyResult<Vec<&'a [f64]>> {
    let slices = arrays.iter().map(|array| Ok(array.as_slice()?));
    slices.collect()
}
