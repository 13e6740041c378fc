//! A mechanism in the types of the runtime. These are made for generated code and hold constants,
//! so the description of a mechanism lives as long as the process, once for all equal ones.

mod describe;
mod describe_coupled;
pub(crate) mod forever;

use std::sync::OnceLock;

use linkage_compiler::ir::{CompiledMechanism, plain};
use linkage_compiler::{Checked, check_all};
use linkage_runtime::support::{Description, GroupData};
use linkage_runtime::{AssemblyMode, Heading, Input, Parameter, Structure};
use linkage_symbolic::blocks::BlockProgram;

use crate::error::{CompileError, UnknownFunction};
use crate::messages::rendered;
use crate::operations::MultiplyAdds;
use crate::source::Source;
use forever::forever;

/// A mechanism without a mistake: its programs and their description.
///
/// Dimensions are slices of numbers in the order of [`parameters`](Self::parameters), inputs in the
/// order of [`inputs`](Self::inputs).
#[derive(Clone, Debug)]
pub struct Mechanism {
    pub(crate) description: Description,
    pub(crate) group_data: GroupData,
    parameters: Vec<Parameter>,
    pub(crate) compiled: CompiledMechanism,
    structure: &'static Structure,
    headings: Vec<&'static Heading>,
    warnings: String,
    /// The programs of sweeps, made when they are first needed.
    pub(crate) block_programs: Vec<OnceLock<BlockProgram>>,
    pub(crate) multiply_adds: MultiplyAdds,
}

/// Compiles all mechanisms of a text; `name` stands in messages. It is that of the text's file, and
/// says by the ending `.rs` that the text is a Rust file with calls of `mechanism!`.
///
/// # Errors
///
/// All mistakes of the text, each with the source under it.
pub fn compile(name: &str, text: &str) -> Result<Vec<Mechanism>, CompileError> {
    compiled(name, text, |checked| checked)
}

/// Compiles all mechanisms of a text as [`compile`] does, even if declared ranges are refused: the
/// refusal is in [`warnings`](Mechanism::warnings). Assemblies and circuits need no range; functions
/// have values near the reference, and NaN where the mechanism comes apart.
///
/// # Errors
///
/// All other mistakes of the text, each with the source under it.
///
/// ```
/// use linkage_engine::compile_in_any_range;
///
/// let text = "pub struct Rocking { unit mm; input phi = 50deg in 0deg..360deg;
///     unknown theta = 10deg; unknown psi = 60deg;
///     loop polar(90mm, phi) + polar(30mm, theta) = (100mm, 0) + polar(90mm, psi); }
///     impl Rocking { pub fn f(phi) -> F { psi } }";
/// let all = compile_in_any_range("rocking.mech", text)?;
/// assert!(all[0].warnings().contains("comes apart in this range"));
/// assert_eq!(all[0].assemblies(&all[0].dimensions(), &all[0].reference()).unwrap().len(), 2);
/// # Ok::<(), linkage_engine::CompileError>(())
/// ```
pub fn compile_in_any_range(name: &str, text: &str) -> Result<Vec<Mechanism>, CompileError> {
    compiled(name, text, Checked::in_any_range)
}

fn compiled(
    name: &str,
    text: &str,
    accepted: impl Fn(Checked) -> Checked,
) -> Result<Vec<Mechanism>, CompileError> {
    let source = Source::new(name, text)?;
    let mut all = Vec::new();
    let mut mistakes = String::new();
    for call in source.calls() {
        for checked in check_all(call.tokens.clone()).into_iter().map(&accepted) {
            let messages = rendered(&source, call, &checked, false);
            match Mechanism::new(&checked) {
                Some(mechanism) => all.push(Mechanism {
                    warnings: messages,
                    ..mechanism
                }),
                None => mistakes += &messages,
            }
        }
    }
    match mistakes.is_empty() {
        true => Ok(all),
        false => Err(CompileError(mistakes)),
    }
}

impl Mechanism {
    /// Compiles the mechanism of a text that holds one.
    ///
    /// # Errors
    ///
    /// All mistakes of the text, each with the source under it; that it holds several mechanisms,
    /// which [`compile`] returns.
    ///
    /// ```
    /// use linkage_engine::Mechanism;
    ///
    /// let text = "pub struct Crank { unit mm; param r = 30parsec; }";
    /// let error = Mechanism::compile(text).unwrap_err();
    /// assert!(error.to_string().starts_with("error: "), "{error}");
    /// ```
    pub fn compile(text: &str) -> Result<Self, CompileError> {
        let mut all = compile("mechanism", text)?;
        match (all.pop(), &all[..]) {
            (Some(only), []) => Ok(only),
            (last, others) => {
                let names: Vec<&str> = others.iter().chain(&last).map(|one| one.name()).collect();
                Err(CompileError(format!(
                    "the text holds {} mechanisms, `{}`: `linkage_engine::compile` returns all of them",
                    names.len(),
                    names.join("`, `")
                )))
            }
        }
    }

    /// Describes a checked mechanism; `None` if it has mistakes.
    #[must_use]
    pub fn new(checked: &Checked) -> Option<Self> {
        let compiled = checked.unit.clone()?;
        let name = forever(checked.name.as_deref().unwrap_or_default());
        let structure = describe::structure(&compiled);
        Some(Self {
            description: describe::description(name, structure.groups, &compiled),
            group_data: describe::group_data(name, structure.groups, &compiled),
            parameters: describe::parameters(&compiled),
            structure,
            headings: describe::headings(&compiled),
            block_programs: vec![OnceLock::new(); compiled.functions.len()],
            warnings: String::new(),
            multiply_adds: MultiplyAdds::default(),
            compiled,
        })
    }

    /// Returns the same mechanism with multiply-adds that are rounded once on every machine. Its
    /// numbers are those of a machine that has the instruction; they take longer where it is missing.
    /// The accuracy tests compute each written form both ways.
    #[must_use]
    pub fn with_fused_multiply_adds(self) -> Self {
        Self {
            multiply_adds: MultiplyAdds::Fused,
            ..self
        }
    }

    /// Returns the same mechanism with multiply-adds that are rounded twice on every machine. Its
    /// numbers are those of a machine without the instruction, such as WebAssembly.
    #[must_use]
    pub fn with_separate_multiply_adds(self) -> Self {
        Self {
            multiply_adds: MultiplyAdds::Separate,
            ..self
        }
    }

    /// Returns the name of its struct.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.description.name
    }

    /// Returns its inputs, as the constant `INPUTS` of the macro's struct.
    #[must_use]
    pub fn inputs(&self) -> &'static [Input] {
        self.description.inputs
    }

    /// Returns its scalar parameters with defaults and tolerances, as the constant `PARAMETERS`.
    #[must_use]
    pub fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    /// Returns its groups and their solutions, as the constant `STRUCTURE`.
    #[must_use]
    pub fn structure(&self) -> &'static Structure {
        self.structure
    }

    /// Returns name, arguments and columns of each function, by its number.
    #[must_use]
    pub fn headings(&self) -> &[&'static Heading] {
        &self.headings
    }

    /// Returns the number of a function.
    ///
    /// # Errors
    ///
    /// If no function has that name.
    pub fn function(&self, name: &str) -> Result<usize, UnknownFunction> {
        let mut headings = self.headings.iter();
        let found = headings.position(|heading| heading.function == name);
        found.ok_or_else(|| UnknownFunction {
            mechanism: self.description.name,
            name: name.to_owned(),
            functions: self
                .headings
                .iter()
                .map(|heading| heading.function)
                .collect(),
        })
    }

    /// Returns the compiler's warnings, each with the source under it; empty if there are none.
    #[must_use]
    pub fn warnings(&self) -> &str {
        &self.warnings
    }

    /// Returns its programs, for printers of other languages.
    #[must_use]
    pub fn compiled(&self) -> &CompiledMechanism {
        &self.compiled
    }

    /// The dimensions of the declaration.
    #[must_use]
    pub fn dimensions(&self) -> Vec<f64> {
        self.compiled
            .scalars()
            .map(|scalar| scalar.nominal)
            .collect()
    }

    /// Changes the tolerance of a dimension, by its index among the parameters.
    ///
    /// # Panics
    ///
    /// If there is no such parameter.
    pub fn set_tolerance(&mut self, index: usize, tolerance: f64) {
        assert!(index < self.parameters.len(), "one of its parameters");
        self.set_parameters(|parameter, _, declared| {
            if parameter == index {
                *declared = tolerance;
            }
        });
    }

    /// Makes other dimensions those of the declaration, as exported code has them.
    ///
    /// # Panics
    ///
    /// If there is another number of parameters.
    pub fn set_dimensions(&mut self, dimensions: &[f64]) {
        assert_eq!(dimensions.len(), self.parameters.len(), "its parameters");
        self.set_parameters(|parameter, nominal, _| *nominal = dimensions[parameter]);
    }

    /// Changes default and tolerance of each parameter, by its index.
    fn set_parameters(&mut self, change: impl Fn(usize, &mut f64, &mut f64)) {
        for (index, parameter) in self.parameters.iter_mut().enumerate() {
            change(index, &mut parameter.nominal, &mut parameter.tolerance);
        }
        let parameters = self.compiled.parameters.iter_mut();
        let scalars = parameters.flat_map(|parameter| &mut parameter.scalars);
        for (index, scalar) in scalars.enumerate() {
            change(index, &mut scalar.nominal, &mut scalar.tolerance);
        }
    }

    /// The reference inputs.
    #[must_use]
    pub fn reference(&self) -> Vec<f64> {
        let inputs = self.compiled.inputs.iter();
        inputs.map(|input| input.reference).collect()
    }

    /// The groups whose assembly is followed from the estimates, as numbers in `structure`.
    pub fn followed(&self) -> impl Iterator<Item = usize> {
        let followed = self
            .compiled
            .coupled
            .iter()
            .filter(|coupled| coupled.followed);
        followed.map(|followed| followed.group)
    }

    /// The modes that the start estimates choose.
    #[must_use]
    pub fn modes(&self) -> Vec<AssemblyMode> {
        self.description.modes.to_vec()
    }

    /// Returns the default of an argument of functions, by its index among inputs and arguments:
    /// the reference of an input, the declared value of a load. A speed or an acceleration has none.
    ///
    /// # Panics
    ///
    /// If there is no such argument.
    #[must_use]
    pub fn default_argument(&self, index: usize) -> Option<f64> {
        match index.checked_sub(self.inputs().len()) {
            None => Some(self.inputs()[index].reference),
            Some(number) => self.compiled.arguments[number].reference,
        }
    }

    /// Returns name and unit of an argument of functions, by its index among inputs and arguments.
    ///
    /// # Panics
    ///
    /// If there is no such argument.
    #[must_use]
    pub fn argument(&self, index: usize) -> (&str, &str) {
        match index.checked_sub(self.description.inputs.len()) {
            None => (
                self.description.inputs[index].name,
                self.description.inputs[index].unit,
            ),
            Some(number) => {
                let argument = &self.compiled.arguments[number];
                (plain(&argument.name), &argument.unit)
            }
        }
    }
}
