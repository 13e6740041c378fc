//! The mechanisms of one call: which is a part of which, and what is made of each.

use std::rc::Rc;

use proc_macro2::TokenStream;
use quote::quote;

use crate::assembly::Closed;
use crate::diagnostic::{Diagnostics, Message, SourceSpan};
use crate::ir::CompiledMechanism;
use crate::model::{Library, Model};
use crate::observer::PhaseObserver;
use crate::pipeline::analyse;
use crate::syntax::{Attribute, Item, MechanismDef, PartItem};
use crate::{emit, model, syntax};

/// What [`check`](crate::check) says of a mechanism.
#[derive(Clone, Debug)]
pub struct Checked {
    /// Its name, if it has one.
    pub name: Option<String>,
    /// Its programs, if there is no mistake.
    pub unit: Option<CompiledMechanism>,
    /// The mistakes, in the order in which phases found them.
    pub messages: Vec<Message>,
    /// What is no mistake, but hardly meant, unless the mechanism allows it.
    pub warnings: Vec<Message>,
}

/// What the phases before emission made of all mechanisms of a call, as far as mistakes let them.
#[derive(Default)]
pub(crate) struct Call {
    /// What is wrong with the text.
    pub(crate) syntax: Diagnostics,
    /// In the order in which they are written.
    pub(crate) mechanisms: Vec<Analysed>,
}

/// What they made of one mechanism.
pub(crate) struct Analysed {
    pub(crate) definition: MechanismDef,
    pub(crate) model: Option<Rc<Model>>,
    pub(crate) unit: Option<CompiledMechanism>,
    pub(crate) diagnostics: Diagnostics,
}

/// What is known of a mechanism that was looked at.
#[derive(Default)]
struct Found {
    model: Option<Rc<Model>>,
    unit: Option<CompiledMechanism>,
    /// As it is assembled alone.
    closed: Option<Rc<Closed>>,
    diagnostics: Diagnostics,
}

impl Call {
    /// The last mechanism is watched.
    pub(crate) fn new(body: TokenStream, watch: &mut dyn PhaseObserver) -> Self {
        let mut syntax = Diagnostics::default();
        let definitions = syntax::parse(body, &mut syntax);
        let mut found: Vec<Found> = definitions.iter().map(|_| Found::default()).collect();
        let order = order(&definitions, &mut found);
        let last = definitions.len().wrapping_sub(1);
        for (rank, &own) in order.iter().enumerate() {
            let mut library = Library::default();
            for &before in &order[..rank] {
                library.add(&definitions[before], found[before].model.clone());
            }
            // Those of a circle, and what comes later, have names but nothing behind them.
            for (other, definition) in definitions.iter().enumerate() {
                if !order[..rank].contains(&other) {
                    library.add(definition, None);
                }
            }
            let definition = &definitions[own];
            let mut diagnostics = std::mem::take(&mut found[own].diagnostics);
            let model = model::resolve(definition, &library, &mut diagnostics);
            let model = model.filter(|_| syntax.is_empty()).map(Rc::new);
            if let Some(model) = &model {
                let parts = model.mechanism.parts.iter();
                let closed = parts.map(|part| {
                    let mut names = definitions.iter();
                    let of = names.position(|other| other.name == part.mechanism);
                    of.and_then(|of| found[of].closed.clone())
                });
                let closed: Option<Vec<Rc<Closed>>> = closed.collect();
                // Of a part that cannot be assembled, it is told where it is alone.
                if let Some(parts) = closed {
                    let watch: &mut dyn PhaseObserver = match own == last {
                        true => &mut *watch,
                        false => &mut (),
                    };
                    let (unit, closed) = analyse(model, &parts, &mut diagnostics, watch);
                    found[own].unit = Some(unit);
                    found[own].closed = closed.filter(|_| diagnostics.is_empty()).map(Rc::new);
                }
            }
            found[own].model = model;
            found[own].diagnostics = diagnostics;
        }
        let mechanisms = definitions.into_iter().zip(found);
        let mechanisms = mechanisms.map(|(definition, found)| Analysed {
            definition,
            model: found.model,
            unit: found.unit,
            diagnostics: found.diagnostics,
        });
        Self {
            mechanisms: mechanisms.collect(),
            syntax,
        }
    }

    /// All items of all mechanisms, or mistakes and skeletons.
    pub(crate) fn emitted(&self, krate: &TokenStream, printed: &emit::Printer) -> TokenStream {
        let mut items = self.syntax.to_tokens();
        for own in &self.mechanisms {
            items.extend(own.emitted(krate, printed, self.syntax.is_empty()));
        }
        items
    }

    /// What there is to say of each mechanism; mistakes of the text stand with the first.
    pub(crate) fn checked(self) -> Vec<Checked> {
        let (mut syntax, _) = self.syntax.into_messages();
        let sound = syntax.is_empty();
        if self.mechanisms.is_empty() {
            return vec![Checked {
                name: None,
                unit: None,
                messages: syntax,
                warnings: Vec::new(),
            }];
        }
        let mut all = Vec::new();
        for own in self.mechanisms {
            let mut checked = own.checked();
            checked.unit = checked.unit.filter(|_| sound);
            checked.messages.splice(0..0, syntax.drain(..));
            all.push(checked);
        }
        all
    }

    /// What there is to say of the last mechanism, with the messages of all.
    pub(crate) fn last(self) -> Checked {
        let mut all = self.checked();
        let mut last = all.pop().expect("there is always one");
        let before = all.into_iter().flat_map(|own| own.messages);
        last.messages.splice(0..0, before.collect::<Vec<_>>());
        last
    }
}

impl Analysed {
    fn emitted(&self, krate: &TokenStream, printed: &emit::Printer, sound: bool) -> TokenStream {
        let errors = self.diagnostics.to_tokens();
        match &self.unit {
            Some(unit) if sound && self.diagnostics.is_empty() => {
                let items = emit::emit(krate, &self.definition, unit, printed);
                let warnings = self
                    .diagnostics
                    .warnings_to_tokens(&self.definition.allows());
                quote!(#items #warnings)
            }
            _ => {
                let mechanism = self.model.as_ref().map(|own| &own.mechanism);
                let skeleton = emit::skeleton(krate, &self.definition, mechanism);
                quote!(#errors #skeleton)
            }
        }
    }

    fn checked(self) -> Checked {
        let (messages, mut warnings) = self.diagnostics.into_messages();
        let mut attributes = self.definition.attributes.iter();
        if attributes.any(Attribute::allows_warnings) {
            warnings.clear();
        }
        Checked {
            name: Some(self.definition.title()),
            unit: self.unit.filter(|_| messages.is_empty()),
            messages,
            warnings,
        }
    }
}

/// The mechanisms so that each stands behind its parts; circles are reported.
fn order(definitions: &[MechanismDef], found: &mut [Found]) -> Vec<usize> {
    let mut order = Vec::new();
    let mut open: Vec<usize> = (0..definitions.len()).collect();
    loop {
        let before = open.len();
        let ready: Vec<usize> = open
            .iter()
            .copied()
            .filter(|&own| parts(definitions, own).all(|(_, part)| !open.contains(&part)))
            .collect();
        open.retain(|own| !ready.contains(own));
        order.extend(ready);
        if open.len() == before {
            break;
        }
    }
    // What remains leads into a circle; each is told once, where it begins first.
    let mut told: Vec<usize> = Vec::new();
    for &start in &open {
        let Some(circle) = circle(definitions, start) else {
            continue;
        };
        if circle.iter().any(|(own, _)| told.contains(own)) {
            continue;
        }
        let names: Vec<String> = circle
            .iter()
            .map(|(own, item)| {
                format!(
                    "`{}` has the part `{}: {}`",
                    definitions[*own].name, item.name, item.mechanism
                )
            })
            .collect();
        let fact = match &names[..] {
            [_] => format!("`{}` is a part of itself", definitions[start].name),
            _ => format!(
                "`{}` is a part of itself: {}",
                definitions[start].name,
                names.join(", ")
            ),
        };
        let help = "a mechanism that contains itself never ends: take one of these parts out";
        let item = circle[0].1;
        let span = SourceSpan::from(&item.name).to((&item.mechanism).into());
        found[start].diagnostics.error_with_help(span, fact, help);
        told.extend(circle.iter().map(|(own, _)| own));
    }
    // They are resolved all the same: other mistakes are told with the circle.
    order.extend(open);
    order
}

/// The parts of a mechanism that are mechanisms of the call, by their numbers.
fn parts(definitions: &[MechanismDef], own: usize) -> impl Iterator<Item = (&PartItem, usize)> {
    let items = definitions[own].items.iter();
    items.filter_map(|item| match item {
        Item::Part(item) => {
            let mut names = definitions.iter();
            let part = names.position(|other| other.name == item.mechanism)?;
            Some((item, part))
        }
        _ => None,
    })
}

/// The shortest way from a mechanism over its parts back to it: who has which part.
fn circle(definitions: &[MechanismDef], start: usize) -> Option<Vec<(usize, &PartItem)>> {
    let mut ways: Vec<(Vec<(usize, &PartItem)>, usize)> = vec![(Vec::new(), start)];
    let mut seen = Vec::new();
    while !ways.is_empty() {
        let mut longer = Vec::new();
        for (way, at) in ways {
            for (item, part) in parts(definitions, at) {
                let next: Vec<_> = way.iter().copied().chain([(at, item)]).collect();
                if part == start {
                    return Some(next);
                }
                if !seen.contains(&part) {
                    seen.push(part);
                    longer.push((next, part));
                }
            }
        }
        ways = longer;
    }
    None
}
