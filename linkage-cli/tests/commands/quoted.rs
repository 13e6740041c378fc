//! How much of what a user wrote a message repeats.

use std::fs;

use crate::{folder, refused, slider};

/// No more than 80 characters of a run of this letter, with an ellipsis.
fn is_brief(said: &str, letter: char) {
    let title = said.lines().filter(|line| !line.contains('|'));
    for line in title {
        let longest = line.split(|c| c != letter).map(str::len).max();
        assert!(longest.is_some_and(|longest| longest <= 80), "{line}");
    }
    assert!(said.contains('…') && said.len() < 1500, "{said}");
}

#[test]
fn a_message_repeats_at_most_80_characters() {
    let folder = slider("quoted");
    let long = "x".repeat(5000);
    let pair = format!("{long}=3mm");
    let value = format!("crank={long}");
    let sum = format!("crank=1mm{}", " + x".repeat(2000));
    for arguments in [
        &["table", "own.mech", &long][..],
        &["table", "own.mech", "stroke", "--set", &long],
        &["table", "own.mech", "stroke", "--set", &pair],
        &["table", "own.mech", "stroke", "--set", &value],
        &["table", "own.mech", "stroke", "--set", &sum],
        &["table", "own.mech", "stroke", "--at", &pair],
        &["table", "own.mech", "stroke", "--over", &long],
        &["table", "own.mech", "stroke", "--from", &long],
        &["table", "own.mech", "stroke", "--mechanism", &long],
        &["page", "own.mech", "--at", &pair],
        &["assemblies", "own.mech", "--at", &pair],
    ] {
        is_brief(&refused(&folder, arguments, 1), 'x');
    }
    let option = format!("--{long}");
    for arguments in [
        &[long.as_str()][..],
        &["table", "own.mech", "stroke", &option],
        &["table", "own.mech", "stroke", "--steps", &long],
    ] {
        is_brief(&refused(&folder, arguments, 2), 'x');
    }
}

#[test]
fn names_and_numbers_of_a_file_are_repeated_briefly() {
    let folder = folder("quoted_file");
    let long = "x".repeat(5000);
    for (name, body) in [
        (
            "unknown",
            format!("param a = 3mm; let h = a * {long} * sin(phi);"),
        ),
        (
            "number",
            format!("param a = {}mm; let h = a * sin(phi);", "1".repeat(5000)),
        ),
        (
            "twice",
            format!("param {long} = 3mm; param {long} = 4mm; let h = {long} * sin(phi);"),
        ),
        ("item", format!("{long} a = 3mm; let h = 3mm * sin(phi);")),
    ] {
        let text = format!(
            "pub struct S {{ unit mm; input phi = 30deg; {body} }} impl S {{ pub fn f(phi) -> F {{ h }} }}"
        );
        fs::write(folder.join("own.mech"), text).expect("written");
        let said = refused(&folder, &["check", "own.mech"], 1);
        is_brief(&said, if name == "number" { '1' } else { 'x' });
    }
    // Of a mechanism without a mistake, too: its name, and those of its unknowns.
    let text = format!(
        "pub struct X{long} {{ unit mm; param crank = 30mm; param rod = 80mm; input phi = 60deg; \
         unknown {long} = -20deg; unknown s = 90mm; \
         loop polar(crank, phi) + polar(rod, {long}) = (s, 0); }} \
         impl X{long} {{ pub fn f(phi) -> F {{ s }} }}"
    );
    fs::write(folder.join("own.mech"), text).expect("written");
    is_brief(
        &refused(
            &folder,
            &["table", "own.mech", "f", "--set", "crank=300mm"],
            1,
        ),
        'x',
    );
}
