//! What others call: the macro, a program that wants a unit or messages, tests that look between the phases.

use linkage_compiler::ir::CompiledMechanism;
use linkage_compiler::trace::trace;
use linkage_compiler::{Oracle, check, ir};
use linkage_rust::compile;
use proc_macro2::{Group, TokenStream, TokenTree};

/// A mechanism with bodies, whose reactions whoever looks asks for, too.
fn mechanism() -> TokenStream {
    let text = include_str!("../golden/forces.mech");
    text.parse().expect("tokens")
}

/// No programs of a drawn mechanism.
fn printed(_: &str, _: &CompiledMechanism) -> String {
    String::new()
}

#[test]
fn looking_between_the_phases_changes_nothing() {
    let watched = trace(mechanism());
    let (_, by_oracle) = Oracle::new(mechanism());
    for checked in [by_oracle, check(mechanism())] {
        let unit = checked.unit.expect("a mechanism without a mistake");
        assert_eq!(watched.lower, ir::dump(&unit));
    }
}

#[test]
fn a_mistake_is_told_with_its_place() {
    let text = mechanism().to_string().replacen("psi", "phsi", 1);
    let checked = check(text.parse().expect("tokens"));
    assert!(checked.unit.is_none());
    assert!(!checked.messages.is_empty());
    let trace = trace(text.parse().expect("tokens"));
    let texts: Vec<&String> = checked.messages.iter().map(|own| &own.text).collect();
    assert_eq!(texts, trace.messages.iter().collect::<Vec<_>>());
    assert!(checked.messages.iter().all(|own| own.text.contains("psi")));
}

#[test]
fn a_mistake_after_the_names_is_told_by_all() {
    let text = mechanism().to_string().replacen(
        "unknown",
        "let lost = 1mm; unknown never = 1mm; unknown",
        1,
    );
    let tokens = || -> TokenStream { text.parse().expect("tokens") };
    let messages = check(tokens()).messages;
    let (oracle, checked) = Oracle::new(tokens());
    assert!(checked.unit.is_none(), "{oracle:?}");
    assert_eq!(messages.len(), checked.messages.len());
    assert_eq!(errors(compile(tokens(), printed)), messages.len());
}

/// How many `compile_error`s there are.
fn errors(tokens: TokenStream) -> usize {
    let count = |token: TokenTree| match token {
        TokenTree::Ident(word) => usize::from(word == "compile_error"),
        TokenTree::Group(group) => errors(Group::stream(&group)),
        _ => 0,
    };
    tokens.into_iter().map(count).sum()
}
