//! Mechanisms.

use std::sync::Arc;

use linkage_c::{ColumnSweeps, Real, Sources, column_sweeps};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::assembly::{Assembly, Cell};
use crate::circuits::{Branch, Circuits, branch};
use crate::derivatives::derivatives;
use crate::description::{ArgumentOf, FunctionOf, InputOf, ParameterOf, functions};
use crate::page::page;
use crate::raised::not_assembled;
use crate::text::{File, Fused, Located, rounded};

/// Files with their texts, the one to compile, names of functions, and names of sweeps over
/// positions and over mechanisms.
type CompiledC = (
    Vec<(String, String)>,
    String,
    [String; 3],
    Vec<Option<String>>,
    Vec<Option<String>>,
);

/// A compiled mechanism.
#[pyclass(frozen, module = "linkage._linkage")]
pub(crate) struct Mechanism {
    compiled: Arc<linkage_engine::Mechanism>,
    file: Arc<File>,
    messages: Vec<Located>,
    warnings: String,
    fused: Fused,
}

impl Mechanism {
    /// A mechanism of a text, with its warnings: each with its position, and all as a text.
    pub(crate) fn new(
        compiled: linkage_engine::Mechanism,
        file: Arc<File>,
        messages: Vec<Located>,
        warnings: String,
        fused: Fused,
    ) -> Self {
        Self {
            compiled: Arc::new(compiled),
            file,
            messages,
            warnings,
            fused,
        }
    }

    /// The mechanism of the engine.
    pub(crate) fn compiled(&self) -> &Arc<linkage_engine::Mechanism> {
        &self.compiled
    }
}

#[pymethods]
impl Mechanism {
    #[getter]
    fn name(&self) -> &str {
        self.compiled.name()
    }

    #[getter]
    fn documentation(&self) -> &str {
        &self.compiled.compiled().documentation
    }

    #[getter]
    fn messages(&self) -> Vec<Located> {
        self.messages.clone()
    }

    #[getter]
    fn warnings(&self) -> &str {
        &self.warnings
    }

    #[getter]
    fn structure(&self) -> String {
        self.compiled.structure().to_string()
    }

    #[getter]
    fn mobility(&self) -> i32 {
        self.compiled.structure().mobility as i32
    }

    #[getter]
    fn groups(&self) -> Vec<(Vec<&'static str>, &'static str, String)> {
        let groups = self.compiled.structure().groups.iter();
        groups
            .map(|group| (group.unknowns.to_vec(), group.kind, group.loop_names()))
            .collect()
    }

    #[getter]
    fn parameters(&self) -> Vec<ParameterOf> {
        let parameters = self.compiled.parameters().iter();
        parameters
            .map(|one| (one.name, one.unit, one.nominal, one.tolerance))
            .collect()
    }

    #[getter]
    fn inputs(&self) -> Vec<InputOf> {
        let inputs = self.compiled.inputs().iter();
        inputs
            .map(|one| (one.name, one.unit, one.reference, one.range, one.ends()))
            .collect()
    }

    #[getter]
    fn arguments(&self) -> Vec<ArgumentOf> {
        let count = self.compiled.inputs().len() + self.compiled.compiled().arguments.len();
        let argument = |index| {
            let (name, unit) = self.compiled.argument(index);
            let default = self.compiled.default_argument(index);
            (name.to_owned(), unit.to_owned(), default)
        };
        (0..count).map(argument).collect()
    }

    #[getter]
    fn functions(&self) -> Vec<FunctionOf> {
        functions(&self.compiled)
    }

    /// The assembly that the estimates choose.
    fn assemble(&self, py: Python<'_>, dimensions: Vec<f64>) -> PyResult<Assembly> {
        let made = py.detach(|| {
            Cell::try_new(Arc::clone(&self.compiled), |mechanism| {
                mechanism.assemble(&dimensions).map(|one| vec![one])
            })
        });
        let cell = made.map_err(|error| not_assembled(py, &error))?;
        Ok(Assembly::new(Arc::new(cell), 0))
    }

    /// All assemblies at these inputs.
    fn assemblies(
        &self,
        py: Python<'_>,
        dimensions: Vec<f64>,
        at: Vec<f64>,
    ) -> PyResult<Vec<Assembly>> {
        let made = py.detach(|| {
            Cell::try_new(Arc::clone(&self.compiled), |mechanism| {
                mechanism.assemblies(&dimensions, &at)
            })
        });
        let cell = Arc::new(made.map_err(|error| not_assembled(py, &error))?);
        Ok(Assembly::all(&cell))
    }

    /// The same assembly for other dimensions.
    fn assemble_from(
        &self,
        py: Python<'_>,
        dimensions: Vec<f64>,
        from: &Assembly,
    ) -> PyResult<Assembly> {
        let made = py.detach(|| {
            Cell::try_new(Arc::clone(&self.compiled), |mechanism| {
                let found = mechanism.assemble_from(&dimensions, from.get());
                found.map(|one| vec![one])
            })
        });
        let cell = made.map_err(|error| not_assembled(py, &error))?;
        Ok(Assembly::new(Arc::new(cell), 0))
    }

    /// All assemblies over the range of the input, and the table of them.
    fn circuits(&self, py: Python<'_>, dimensions: Vec<f64>) -> PyResult<Option<Circuits>> {
        let mut branches: Vec<Branch> = Vec::new();
        let mut text = String::new();
        let mut is_searched = true;
        let made = py.detach(|| {
            Cell::try_new(Arc::clone(&self.compiled), |mechanism| {
                let Some(found) = mechanism.circuits(&dimensions) else {
                    is_searched = false;
                    return Ok(Vec::new());
                };
                let found = found?;
                text = found.to_string();
                branches = found.branches.iter().map(branch).collect();
                let assemblies = found.branches.into_iter();
                Ok(assemblies.map(|branch| branch.assembly).collect())
            })
        });
        let cell = Arc::new(made.map_err(|error| not_assembled(py, &error))?);
        Ok(is_searched.then(|| (text, branches, Assembly::all(&cell))))
    }

    /// The same mechanism with other tolerances.
    fn with_tolerances(&self, tolerances: Vec<f64>) -> Self {
        let mut compiled = (*self.compiled).clone();
        for (index, tolerance) in tolerances.into_iter().enumerate() {
            compiled.set_tolerance(index, tolerance);
        }
        Self {
            compiled: Arc::new(compiled),
            file: Arc::clone(&self.file),
            messages: self.messages.clone(),
            warnings: self.warnings.clone(),
            fused: self.fused,
        }
    }

    /// Name, header and source in C99, with doubles, fused doubles or floats.
    fn to_c(&self, scalar: &str) -> PyResult<(String, String, String)> {
        let real = match scalar {
            "double" => Real::Double,
            "fused" => Real::Fused,
            "float" => Real::Single,
            other => {
                let text = format!("no scalar `{other}`\nhelp: write `double`, `fused` or `float`");
                return Err(PyValueError::new_err(text));
            }
        };
        let printed = linkage_c::sources(self.compiled.name(), self.compiled.compiled(), real);
        let Sources {
            name,
            header,
            source,
            ..
        } = printed.map_err(|refused| PyValueError::new_err(refused.to_string()))?;
        Ok((name, header, source))
    }

    /// C with sweeps into columns: the files by their names, the one to compile, the functions that
    /// assemble, return the size of an assembly and the text of an error, and the sweeps.
    fn column_sweeps(&self) -> PyResult<CompiledC> {
        let (name, unit) = (self.compiled.name(), self.compiled.compiled());
        let printed = column_sweeps(name, unit, Real::Double);
        let ColumnSweeps {
            sources,
            header,
            columns,
            assemble,
            assembly_size,
            error,
            sweeps,
            sets,
        } = printed.map_err(|refused| PyValueError::new_err(refused.to_string()))?;
        let main = format!("{}_columns.c", sources.name);
        let files = vec![
            (format!("{}.h", sources.name), sources.header),
            (format!("{}.c", sources.name), sources.source),
            (format!("{}_columns.h", sources.name), header),
            (main.clone(), columns),
        ];
        let functions = [assemble, assembly_size, error];
        Ok((files, main, functions, sweeps, sets))
    }

    /// The mechanism with one more function, the last one: the fields of a function, and after them
    /// the derivatives of these fields with respect to each of these inputs and dimensions. `None`
    /// if a field has none.
    fn with_derivatives(
        &self,
        py: Python<'_>,
        function: &str,
        fields: Vec<String>,
        variables: Vec<String>,
    ) -> Option<Self> {
        let compiled = py.detach(|| {
            derivatives(
                &self.file,
                self.compiled.name(),
                function,
                &fields,
                &variables,
            )
        })?;
        Some(Self {
            compiled: Arc::new(rounded(compiled, self.fused)),
            file: Arc::clone(&self.file),
            messages: self.messages.clone(),
            warnings: self.warnings.clone(),
            fused: self.fused,
        })
    }

    /// The page with drawing, plots and tables as HTML.
    fn page(&self, py: Python<'_>, dimensions: Vec<f64>, positions: usize) -> PyResult<String> {
        let made = py.detach(|| page(&self.file, &self.compiled, &dimensions, positions));
        made.map_err(PyValueError::new_err)
    }
}
