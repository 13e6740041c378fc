//! A compiled mechanism on plain numbers: by its programs, and by the expression graph behind them.

use linkage_compiler::ir::CompiledMechanism;
use linkage_compiler::{Checked, Oracle, check};
use linkage_symbolic::interpret::run;
use linkage_symbolic::program::Source;
use proc_macro2::TokenStream;

/// Parameters and inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    /// All scalar parameters in the mechanism's unit.
    pub parameters: Vec<f64>,
    /// All inputs.
    pub inputs: Vec<f64>,
}

/// What a mechanism's text is after lowering.
///
/// # Errors
/// The compiler's messages.
pub fn unit(text: &str) -> Result<CompiledMechanism, Vec<String>> {
    let checked = check(tokens(text)?);
    let messages = checked.messages.into_iter();
    checked
        .unit
        .ok_or_else(|| messages.map(|own| own.text).collect())
}

fn tokens(text: &str) -> Result<TokenStream, Vec<String>> {
    text.parse().map_err(|error| vec![format!("{error}")])
}

/// A mechanism that the compiler accepts.
#[derive(Debug)]
pub struct Subject {
    /// What the compiler found, and its programs.
    pub unit: CompiledMechanism,
    oracle: Oracle,
}

impl Subject {
    /// Compiles a mechanism's text.
    ///
    /// # Errors
    /// The compiler's messages.
    pub fn new(text: &str) -> Result<Self, Vec<String>> {
        let (oracle, Checked { unit, messages, .. }) = Oracle::new(tokens(text)?);
        match unit {
            Some(unit) => Ok(Self { unit, oracle }),
            None => Err(messages.into_iter().map(|message| message.text).collect()),
        }
    }

    /// Default dimensions and reference inputs.
    pub fn reference(&self) -> Position {
        let inputs = self.unit.inputs.iter();
        Position {
            parameters: self.unit.scalars().map(|own| own.nominal).collect(),
            inputs: inputs.map(|input| input.reference).collect(),
        }
    }

    /// The results of a function by its program, near the reference inputs.
    pub fn by_program(&self, function: usize, at: &Position) -> Vec<f64> {
        let prepared = run(&self.unit.prepare, |source| self.load(source, at, &[]));
        let program = &self.unit.functions[function].called.program;
        run(program, |source| self.load(source, at, &prepared))
    }

    /// The results of a function by the expression graph, near the reference inputs.
    pub fn by_graph(&self, function: usize, at: &Position) -> Vec<f64> {
        self.oracle
            .evaluate(function, |source| self.load(source, at, &[]))
    }

    /// By how much each group misses closing; positive if it cannot be assembled.
    pub fn gaps(&self, at: &Position) -> Vec<f64> {
        let prepared = run(&self.unit.prepare, |source| self.load(source, at, &[]));
        run(&self.unit.gaps, |source| self.load(source, at, &prepared))
    }

    fn load(&self, source: Source, at: &Position, prepared: &[f64]) -> f64 {
        match source {
            Source::Parameter(index) => at.parameters[index],
            Source::Input(index) => at.inputs[index],
            Source::Mode(index) => self.mode(index),
            // Near the reference an angle is the one nearest to its estimate.
            Source::Centre(angle) => self.unit.angles[angle].estimate,
            Source::Winding(..) => 0.0,
            Source::Prepared(slot) => prepared[slot],
            Source::Carried(_) | Source::State(..) | Source::Limit => f64::NAN,
        }
    }

    fn mode(&self, index: usize) -> f64 {
        let groups = &self.unit.groups;
        match groups.iter().find(|group| group.mode == Some(index)) {
            Some(group) if !group.plus => -1.0,
            _ => 1.0,
        }
    }
}
