//! Every phase's result as text, for golden files and for reading what the compiler did.

use std::fmt::Write;

use linkage_symbolic::Graph;
use proc_macro2::TokenStream;

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::{Diagnostics, Origins};
use crate::lower::Lowered;
use crate::model::Mechanism;
use crate::structure::Structure;
use crate::{Analysis, analyse, forces, formulate, model, structure, syntax};

/// The phases of one mechanism, as text.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    /// The syntax tree.
    pub syntax: String,
    /// The resolved mechanism.
    pub model: String,
    /// The groups and the form in which each is solved.
    pub structure: String,
    /// What the reference position chose.
    pub formulate: String,
    /// All programs.
    pub lower: String,
    /// The generated items.
    pub emit: TokenStream,
    /// Messages, if there are any.
    pub messages: Vec<String>,
}

/// Runs all phases on a mechanism without the facade's path in front.
pub fn trace(body: TokenStream) -> Trace {
    let mut trace = Trace::default();
    let mut diagnostics = Diagnostics::default();
    let mut origins = Origins::default();
    if let Some(definition) = syntax::parse(body.clone(), &mut diagnostics) {
        trace.syntax = syntax::dump(&definition);
        if let Some(mechanism) = model::resolve(&definition, &mut origins, &mut diagnostics) {
            trace.model = model::dump(&mechanism);
            trace.structure = structure_text(&mechanism, &origins);
            let analysis = analyse(&mechanism, &origins, &mut diagnostics);
            trace.formulate = formulate_text(&analysis) + &forces_text(&mechanism, &origins);
            trace.lower = lower_text(&mechanism, &analysis.lowered);
        }
    }
    trace.messages = diagnostics.iter().map(|d| d.message.clone()).collect();
    trace.emit = crate::compile(quote::quote!([::linkage] #body));
    trace
}

fn structure_text(mechanism: &Mechanism, origins: &Origins) -> String {
    let graph = Graph::new();
    let mut algebra = Algebra::new(mechanism, &graph);
    let nominal = Nominal::of(&mut algebra);
    let Structure {
        groups,
        explicit,
        mobility,
    } = structure::decompose(&mut algebra, &nominal, origins, &mut Diagnostics::default());
    let mut text = format!("mobility {mobility}\n");
    for group in groups {
        let loops: Vec<String> = group.loops.iter().map(|k| (k + 1).to_string()).collect();
        let unknowns: Vec<&str> = group
            .unknowns
            .iter()
            .map(|&k| mechanism.unknowns[k].name.as_str())
            .collect();
        let form = group.form.name();
        let _ = writeln!(
            text,
            "loops {}: {form} for {}",
            loops.join(" "),
            unknowns.join(", ")
        );
    }
    for item in explicit {
        let _ = writeln!(text, "explicit: {}", algebra.graph.symbol(item.symbol).name);
    }
    text
}

fn formulate_text(analysis: &Analysis) -> String {
    let mut text = String::new();
    for group in &analysis.facts.groups {
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

/// How reactions are found; nothing for a mechanism without bodies.
fn forces_text(mechanism: &Mechanism, origins: &Origins) -> String {
    let graph = Graph::new();
    let mut algebra = Algebra::new(mechanism, &graph);
    let nominal = Nominal::of(&mut algebra);
    let mut diagnostics = Diagnostics::default();
    let structure = structure::decompose(&mut algebra, &nominal, origins, &mut diagnostics);
    formulate::formulate(&mut algebra, structure);
    forces::describe(&mut algebra)
}

fn lower_text(mechanism: &Mechanism, lowered: &Lowered) -> String {
    let mut text = format!("prepare\n{}\ngaps\n{}", lowered.prepare, lowered.gaps);
    let _ = write!(text, "\nsurvey\n{}", lowered.survey);
    if !lowered.continuous_angles.is_empty() {
        let _ = write!(text, "\nangles\n{}", lowered.angles);
    }
    for (number, group) in lowered.coupled.iter().enumerate() {
        let _ = write!(text, "\nterms of coupled group {number}\n");
        for (equation, exponents) in &group.terms {
            let _ = writeln!(text, "equation {equation}: {exponents:?}");
        }
        for (what, program) in [
            ("coefficients", &group.system),
            ("correction", &group.correct),
            ("unknowns", &group.placed),
        ] {
            let _ = write!(text, "\n{what} of coupled group {number}\n{program}");
        }
    }
    for evaluator in &lowered.evaluators {
        let name = &mechanism.evaluators[evaluator.index].name;
        let fields: Vec<String> = evaluator
            .fields
            .iter()
            .map(|f| format!("{}: {:?} {}", f.name, f.shape, f.unit))
            .collect();
        let _ = write!(
            text,
            "\n{name} ({})\n{}",
            fields.join(", "),
            evaluator.program
        );
        if let Some(beside) = &evaluator.beside {
            let _ = write!(text, "\n{name}, for what the table does not know\n{beside}");
        }
    }
    if let Some(picture) = &lowered.picture {
        let _ = write!(text, "\npicture\n{picture}");
    }
    text
}
