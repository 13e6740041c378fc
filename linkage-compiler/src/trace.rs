//! Every phase's result as text, for golden files and for reading the work of the compiler.

use std::fmt::Write;

use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;

use crate::algebra::{Algebra, Nominal};
use crate::driver::Driver;
use crate::ir::{self, CompiledMechanism};
use crate::observer::PhaseObserver;
use crate::solve::Formulation;
use crate::structure::Structure;
use crate::{forces, model, syntax};

/// The phases of one mechanism, as text.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    /// The syntax tree.
    pub syntax: String,
    /// The resolved mechanism.
    pub model: String,
    /// The groups and the form in which each is solved.
    pub structure: String,
    /// The choices made at the reference position.
    pub formulate: String,
    /// All programs.
    pub lower: String,
    /// The functions after each pass that changed something: the number of the function, the pass,
    /// the program.
    pub passes: Vec<(usize, &'static str, String)>,
    /// Messages, if there are any.
    pub messages: Vec<String>,
}

/// Runs all phases on a mechanism without the facade's path in front; of several, it returns the
/// results of the last.
pub fn trace(body: TokenStream) -> Trace {
    let mut middle = Middle::default();
    let call = Driver::run(body, &mut middle);
    let mut messages = call.syntax.texts();
    messages.extend(
        call.mechanisms
            .iter()
            .flat_map(|mechanism| mechanism.diagnostics.texts()),
    );
    let mut trace = Trace {
        structure: middle.structure,
        passes: middle.passes,
        messages,
        ..Trace::default()
    };
    let Some(analysed) = call.mechanisms.last() else {
        return trace;
    };
    trace.syntax = syntax::dump(&analysed.definition);
    if let Some(model) = &analysed.model {
        trace.model = model::dump(&model.mechanism);
    }
    if let Some(unit) = &analysed.unit {
        trace.formulate = formulate_text(unit) + &middle.forces;
        trace.lower = ir::dump(unit);
    }
    trace
}

/// The data seen between the phases.
#[derive(Default)]
struct Middle {
    structure: String,
    /// The way in which reactions are found; empty for a mechanism without bodies.
    forces: String,
    passes: Vec<(usize, &'static str, String)>,
}

impl PhaseObserver for Middle {
    fn structure(&mut self, algebra: &Algebra, structure: &Structure) {
        self.structure = structure_text(algebra, structure);
    }

    fn formulated<'m>(&mut self, algebra: &mut Algebra<'m>, _: &Formulation<'m>, _: &Nominal) {
        self.forces = algebra.tried(forces::describe);
    }

    fn pass(&mut self, name: &'static str, function: usize, program: &dyn Fn() -> Program) {
        let text = program().to_string();
        let mut before = self.passes.iter().rev();
        if before
            .find(|(other, ..)| *other == function)
            .is_none_or(|(.., last)| *last != text)
        {
            self.passes.push((function, name, text));
        }
    }
}

fn structure_text(algebra: &Algebra, structure: &Structure) -> String {
    let mut text = format!("mobility {}\n", structure.mobility);
    for group in &structure.groups {
        let loops: Vec<String> = group.loops.iter().map(|k| (k + 1).to_string()).collect();
        let unknowns = group.unknowns.iter();
        let unknowns: Vec<&str> = unknowns
            .map(|&k| algebra.mechanism.unknowns[k].name.as_str())
            .collect();
        let form = group.form.name();
        let _ = writeln!(
            text,
            "loops {}: {form} for {}",
            loops.join(" "),
            unknowns.join(", ")
        );
    }
    for item in &structure.explicit {
        let _ = writeln!(text, "explicit: {}", algebra.graph.symbol(item.symbol).name);
    }
    text
}

fn formulate_text(unit: &CompiledMechanism) -> String {
    let mut text = String::new();
    for group in &unit.groups {
        let mode = match (group.mode, group.plus) {
            _ if group.coupled => "assemblies listed".to_owned(),
            (None, _) => "one solution".to_owned(),
            (Some(mode), plus) => format!("mode {mode} {}", if plus { "+1" } else { "-1" }),
        };
        let kind = &group.kind;
        let _ = writeln!(
            text,
            "{kind}, class {} order {}: {} ({mode}; {})",
            group.class,
            group.order,
            group.unknowns.join(", "),
            group.method
        );
    }
    text
}
