//! The mechanisms of one call: parts first, all phases for each, items or messages as the result.

use std::rc::Rc;

use proc_macro2::TokenStream;

use crate::assembly::AssembledPart;
use crate::diagnostic::{Diagnostics, Message};
use crate::ir::CompiledMechanism;
use crate::model::{Library, Model};
use crate::observer::PhaseObserver;
use crate::part_order::part_order;
use crate::pipeline::PhaseResults;
use crate::syntax::{Attribute, MechanismDef};
use crate::{model, pipeline};

/// The result of [`check`](crate::check) for one mechanism.
#[derive(Clone, Debug)]
pub struct Checked {
    /// Its name, if it has one.
    pub name: Option<String>,
    /// Its names and types, if there is no mistake in them.
    pub model: Option<Rc<Model>>,
    /// Its programs, if there is no mistake.
    pub unit: Option<CompiledMechanism>,
    /// Its programs, if its declared ranges are refused and there is no other mistake: its
    /// assemblies can be listed, and functions have values near the reference.
    pub out_of_range: Option<CompiledMechanism>,
    /// The mistakes, in the order in which phases found them.
    pub messages: Vec<Message>,
    /// Messages about text that is valid, but hardly meant, unless the mechanism allows it.
    pub warnings: Vec<Message>,
}

impl Checked {
    /// Returns the same mechanism with the refusal of its declared ranges as a warning, if there is
    /// no other mistake.
    #[must_use]
    pub fn in_any_range(self) -> Self {
        match self.out_of_range {
            Some(unit) => Self {
                unit: Some(unit),
                out_of_range: None,
                messages: Vec::new(),
                warnings: self.messages,
                ..self
            },
            None => self,
        }
    }
}

/// All mechanisms of a call after the phases before emission, as far as mistakes permit.
#[doc(hidden)]
pub struct Driver {
    /// Mistakes in the text.
    pub syntax: Diagnostics,
    /// In the order in which they are written.
    pub mechanisms: Vec<Analysed>,
}

/// One mechanism after these phases.
#[doc(hidden)]
pub struct Analysed {
    /// Its text.
    pub definition: MechanismDef,
    /// Its names and types, if they are resolved.
    pub model: Option<Rc<Model>>,
    /// Its programs, as far as there is no mistake.
    pub unit: Option<CompiledMechanism>,
    /// True if there is no mistake but that of declared ranges.
    closes: bool,
    /// Its messages.
    pub diagnostics: Diagnostics,
}

/// Results of the phases for one mechanism, as far as they have run.
#[derive(Default)]
struct Progress {
    model: Option<Rc<Model>>,
    unit: Option<CompiledMechanism>,
    closes: bool,
    /// The assembly of the mechanism without the mechanisms around it.
    closed: Option<Rc<AssembledPart>>,
    diagnostics: Diagnostics,
}

impl Driver {
    /// Runs the phases for all mechanisms of a call.
    pub fn analyse(body: TokenStream) -> Self {
        Self::run(body, &mut ())
    }

    /// Resolves the names of all mechanisms of a call, without messages: those with a mistake in
    /// them have no model.
    pub fn resolve(body: TokenStream) -> Vec<(MechanismDef, Option<Rc<Model>>)> {
        let definitions = model::read(body, &mut Diagnostics::default());
        let (order, _) = part_order(&definitions);
        let mut progress: Vec<Progress> = Vec::new();
        progress.resize_with(definitions.len(), Progress::default);
        for (rank, &index) in order.iter().enumerate() {
            let library = library(&definitions, &progress, &order[..rank]);
            let model = model::resolve(&definitions[index], &library, &mut Diagnostics::default());
            progress[index].model = model.map(Rc::new);
        }
        let models = progress.into_iter().map(|progress| progress.model);
        definitions.into_iter().zip(models).collect()
    }

    /// Reads all mechanisms of a call and resolves their names. Nothing is solved, and there are no
    /// programs.
    pub(crate) fn names(body: TokenStream) -> Self {
        Self::each(body, |_, _, _, _| None)
    }

    /// Runs the phases for all mechanisms. The observer sees those of the last one.
    pub(crate) fn run(body: TokenStream, observer: &mut dyn PhaseObserver) -> Self {
        Self::each(body, |model, parts, diagnostics, is_last| {
            let observer: &mut dyn PhaseObserver = if is_last { &mut *observer } else { &mut () };
            Some(pipeline::run(model, parts, diagnostics, observer))
        })
    }

    /// Resolves the names of all mechanisms, and compiles each whose parts have been compiled; the
    /// last argument is true for the last one as they are written.
    fn each(
        body: TokenStream,
        mut compiled: impl FnMut(
            &Model,
            &[Rc<AssembledPart>],
            &mut Diagnostics,
            bool,
        ) -> Option<PhaseResults>,
    ) -> Self {
        let mut syntax = Diagnostics::default();
        let definitions = model::read(body, &mut syntax);
        let (order, circles) = part_order(&definitions);
        let mut progress: Vec<Progress> = circles
            .into_iter()
            .map(|diagnostics| Progress {
                diagnostics,
                ..Progress::default()
            })
            .collect();
        let last = definitions.len().wrapping_sub(1);
        for (rank, &index) in order.iter().enumerate() {
            let library = library(&definitions, &progress, &order[..rank]);
            let definition = &definitions[index];
            let mut diagnostics = std::mem::take(&mut progress[index].diagnostics);
            diagnostics.append(definition.warnings.clone());
            let model = model::resolve(definition, &library, &mut diagnostics);
            let model = model.filter(|_| syntax.is_empty()).map(Rc::new);
            // A part that cannot be assembled has been reported for the part itself.
            if let Some(model) = &model
                && let Some(parts) = closed_parts(&definitions, &progress, model)
                && let Some(results) = compiled(model, &parts, &mut diagnostics, index == last)
            {
                let part = results.part.filter(|_| diagnostics.is_empty());
                progress[index].unit = Some(results.compiled);
                progress[index].closes = results.closes;
                progress[index].closed = part.map(Rc::new);
            }
            progress[index].model = model;
            progress[index].diagnostics = diagnostics;
        }
        let mechanisms = definitions.into_iter().zip(progress);
        let mechanisms = mechanisms.map(|(definition, progress)| Analysed {
            definition,
            model: progress.model,
            unit: progress.unit,
            closes: progress.closes,
            diagnostics: progress.diagnostics,
        });
        Self {
            mechanisms: mechanisms.collect(),
            syntax,
        }
    }

    /// Returns the messages of each mechanism. Mistakes of the text are with the first one.
    pub(crate) fn checked(self) -> Vec<Checked> {
        let (mut syntax, _) = self.syntax.into_messages();
        let sound = syntax.is_empty();
        if self.mechanisms.is_empty() {
            return vec![Checked {
                name: None,
                model: None,
                unit: None,
                out_of_range: None,
                messages: syntax,
                warnings: Vec::new(),
            }];
        }
        let mut results = Vec::new();
        for mechanism in self.mechanisms {
            let mut checked = mechanism.checked();
            checked.unit = checked.unit.filter(|_| sound);
            checked.out_of_range = checked.out_of_range.filter(|_| sound);
            checked.messages.splice(0..0, syntax.drain(..));
            results.push(checked);
        }
        results
    }

    /// Returns the last mechanism, with the messages of all.
    pub(crate) fn last(self) -> Checked {
        let mut results = self.checked();
        let mut last = results.pop().expect("there is always one");
        let before = results.into_iter().flat_map(|checked| checked.messages);
        last.messages.splice(0..0, before.collect::<Vec<_>>());
        last
    }
}

/// Returns the mechanisms that others can be made of: those before, and the names of all others.
fn library<'a>(
    definitions: &'a [MechanismDef],
    progress: &[Progress],
    before: &[usize],
) -> Library<'a> {
    let mut library = Library::default();
    for &index in before {
        library.add(&definitions[index], progress[index].model.clone());
    }
    // Mechanisms of a circle, and those that come later, have names but no model.
    for (index, definition) in definitions.iter().enumerate() {
        if !before.contains(&index) {
            library.add(definition, None);
        }
    }
    library
}

/// Returns the assemblies of all parts; `None` if one of them has none.
fn closed_parts(
    definitions: &[MechanismDef],
    progress: &[Progress],
    model: &Model,
) -> Option<Vec<Rc<AssembledPart>>> {
    let parts = model.mechanism.parts.iter();
    let closed = parts.map(|part| {
        let mut names = definitions.iter();
        let index = names.position(|definition| definition.name == part.mechanism)?;
        progress[index].closed.clone()
    });
    closed.collect()
}

impl Analysed {
    fn checked(self) -> Checked {
        let (messages, mut warnings) = self.diagnostics.into_messages();
        let mut attributes = self.definition.attributes.iter();
        if attributes.any(Attribute::allows_warnings) {
            warnings.clear();
        }
        let (unit, out_of_range) = match messages.is_empty() {
            true => (self.unit, None),
            false => (None, self.unit.filter(|_| self.closes)),
        };
        Checked {
            name: Some(self.definition.title()),
            model: self.model,
            unit,
            out_of_range,
            messages,
            warnings,
        }
    }
}
