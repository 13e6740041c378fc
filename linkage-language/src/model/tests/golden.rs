//! The whole model as text.

use super::{CRANK_ROCKER, PRESS, SPACE_FORCES, SPATIAL, TWO_INPUTS, model};
use crate::model::dump;

/// Compares with the file, or rewrites it if `UPDATE` is set.
fn check(name: &str, source: &str, expected: &str) {
    let (mechanism, messages) = model(source);
    let text = dump(&mechanism.unwrap_or_else(|| panic!("{messages:#?}")));
    if std::env::var_os("UPDATE").is_some() {
        let path = format!(
            "{}/src/model/tests/{name}.model",
            env!("CARGO_MANIFEST_DIR")
        );
        std::fs::write(path, text).expect("the golden file can be written");
        return;
    }
    assert_eq!(text, expected, "run with UPDATE=1 if the change is wanted");
}

#[test]
fn crank_rocker() {
    check(
        "crank_rocker",
        CRANK_ROCKER,
        include_str!("crank_rocker.model"),
    );
}

#[test]
fn two_inputs() {
    check("two_inputs", TWO_INPUTS, include_str!("two_inputs.model"));
}

#[test]
fn spatial() {
    check("spatial", SPATIAL, include_str!("spatial.model"));
}

#[test]
fn press() {
    check("press", PRESS, include_str!("press.model"));
}

#[test]
fn space_forces() {
    check(
        "space_forces",
        SPACE_FORCES,
        include_str!("space_forces.model"),
    );
}
