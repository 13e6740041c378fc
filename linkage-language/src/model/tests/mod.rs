//! Tests of the way from source text to the model.

mod bare;
mod derivatives;
mod dimensions;
mod frames;
mod golden;
mod item_messages;
mod links;
mod mechanics;
mod messages;
mod mutations;
mod units;

use std::rc::Rc;

use super::{Library, Mechanism, read, resolve};
use crate::diagnostic::Diagnostics;

/// The model, if there is no mistake, and the messages.
pub(super) fn model(source: &str) -> (Option<Mechanism>, Vec<String>) {
    let mut diagnostics = Diagnostics::default();
    let tokens = source.parse().expect("the source has tokens");
    let definition = read(tokens, &mut diagnostics).pop();
    let library = Library::default();
    let model = definition.and_then(|definition| resolve(&definition, &library, &mut diagnostics));
    let mechanism = model.map(|model| model.mechanism);
    let messages: Vec<String> = diagnostics.texts();
    assert_eq!(mechanism.is_none(), !messages.is_empty(), "{messages:#?}");
    (mechanism, messages)
}

/// The model of the last mechanism of a call, and the messages of all.
fn last_of(source: &str) -> (Option<Mechanism>, Vec<String>) {
    let mut diagnostics = Diagnostics::default();
    let tokens = source.parse().expect("the source has tokens");
    let definitions = read(tokens, &mut diagnostics);
    let mut library = Library::default();
    let mut last = None;
    for definition in &definitions {
        let model = resolve(definition, &library, &mut diagnostics).map(Rc::new);
        library.add(definition, model.clone());
        last = model;
    }
    let mechanism = last.map(|model| model.mechanism.clone());
    (mechanism, diagnostics.texts())
}

/// Each message must contain its part.
fn check(source: &str, expected: &[&str]) {
    let (_, messages) = model(source);
    assert_eq!(messages.len(), expected.len(), "{source}: {messages:#?}");
    for (message, expected) in messages.iter().zip(expected) {
        assert!(
            message.contains(expected),
            "{source}:\n{message}\nlacks\n{expected}"
        );
    }
}

const CRANK_ROCKER: &str = include_str!("crank_rocker.mech");
const TWO_INPUTS: &str = include_str!("two_inputs.mech");
const SPATIAL: &str = include_str!("spatial.mech");
const PRESS: &str = include_str!("press.mech");
const SPACE_FORCES: &str = include_str!("space_forces.mech");
const LINKS: &str = include_str!("links.mech");

#[test]
fn the_largest_expressions_fit_the_stack() {
    let nested = format!("{}1rad{}", "sin(".repeat(60), ")".repeat(60));
    let chain = vec![nested; 16].join(" + ");
    let long = vec!["1"; 980].join(" + ");
    let (mechanism, messages) = model(&format!("struct A {{ let a = {chain}; let b = {long}; }}"));
    assert!(mechanism.is_some(), "{messages:#?}");
}
