//! Dimensions of the command line that bring a change point or a gap into the declared range.

use std::fs;
use std::path::PathBuf;

use crate::{folder, linkage, printed, refused, slider};

const FOUR_BAR: &str = "
mechanism! {
    pub struct FourBar {
        unit mm;
        param crank = 50mm +- 0.1mm;
        param coupler = 120mm;
        param rocker = 100mm;
        param frame = 140mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(crank, phi) + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
    }
    impl FourBar {
        pub fn angle(phi) -> Angle { psi, v: velocity(psi), e: sensitivity(psi) }
    }
}
";

/// A parallelogram.
const PARALLEL: [&str; 4] = ["--set", "coupler=140mm", "--set", "rocker=50mm"];

/// What is said of it.
const FACT: &str = "FourBar: the mechanism comes apart in this range: loop 1 (`theta`, `psi`) reaches a change point at `phi = 0deg`, \
                    `phi = 180deg` and `phi = 360deg`; there two of its assemblies meet, and it may go on in either; around the \
                    reference it works from 0.01deg to 179.99deg";
const HELP: &str =
    "help: write `in 0.01deg..179.99deg`, or change a length so that they do not meet";
const PLACE: &str = " --> command line:1:1
  |
1 | --set coupler=140mm --set rocker=50mm
  | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
";

fn four_bar(name: &str) -> PathBuf {
    let folder = folder(name);
    fs::write(folder.join("four.mech"), FOUR_BAR).expect("it is written");
    folder
}

/// A call with the lengths of a parallelogram: its status, and what it prints on both outputs.
fn parallel(name: &str, arguments: &[&str]) -> (bool, String, String) {
    let output = linkage(&four_bar(name), &[arguments, &PARALLEL].concat());
    let [printed, said] =
        [output.stdout, output.stderr].map(|own| String::from_utf8(own).expect("text"));
    (output.status.success(), printed, said)
}

#[test]
fn tables_pages_tolerances_and_c_warn() {
    for (number, arguments) in [
        &[
            "table",
            "four.mech",
            "angle",
            "--steps",
            "2",
            "--from",
            "10deg",
            "--to",
            "20deg",
        ][..],
        &["page", "four.mech"],
        &[
            "tolerance",
            "four.mech",
            "angle",
            "--from",
            "10deg",
            "--to",
            "20deg",
        ],
        &["c", "four.mech"],
    ]
    .into_iter()
    .enumerate()
    {
        let (success, _, said) = parallel(&format!("range_{number}"), arguments);
        assert!(success, "{arguments:?}: {said}");
        let expected = format!("warning: {FACT}\n         {HELP}\n{PLACE}\n");
        assert_eq!(said, expected, "{arguments:?}");
    }
    // The dimensions of the file have been checked, and others without a change point are silent.
    let folder = four_bar("range_silent");
    printed(&folder, &["table", "four.mech", "angle"]);
    printed(
        &folder,
        &["table", "four.mech", "angle", "--set", "crank=50.0001mm"],
    );
    printed(&folder, &["c", "four.mech", "--set", "crank=51mm"]);
}

#[test]
fn a_check_of_other_dimensions_is_one_of_a_file() {
    let (success, known, said) = parallel("range_check", &["check", "four.mech"]);
    assert!(
        !success && known.contains("assemblies at the reference: 2\n"),
        "{known}"
    );
    assert_eq!(said, format!("error: {FACT}\n       {HELP}\n{PLACE}\n"));
    let folder = four_bar("range_checked");
    assert_eq!(
        printed(&folder, &["check", "four.mech", "--set", "crank=50mm"]),
        printed(&folder, &["check", "four.mech"])
    );
    let output = linkage(&folder, &["check", "four.mech", "--set", "crank=90mm"]);
    let said = String::from_utf8(output.stderr).expect("text");
    let dead = "reaches a dead point at `phi = 145.2281deg`, beyond which it misses by up to 10mm; it closes again at `phi = 214.7719deg`";
    assert!(
        output.status.code() == Some(1) && said.contains(dead),
        "{said}"
    );
    let unknown = refused(&folder, &["check", "four.mech", "--set", "rod=90mm"], 1);
    assert!(
        unknown.contains("there is no dimension `rod` in FourBar"),
        "{unknown}"
    );
}

#[test]
fn exported_c_has_the_dimensions_that_are_set() {
    let folder = four_bar("range_c");
    printed(&folder, &["c", "four.mech", "--set", "crank=45mm"]);
    let header = fs::read_to_string(folder.join("four_bar.h")).expect("a header");
    assert!(header.contains("45.0, \\\n    120.0"), "{header}");
}

#[test]
fn equal_assemblies_and_circuits_that_meet_are_told() {
    let (_, all, _) = parallel(
        "range_assemblies",
        &["assemblies", "four.mech", "--at", "phi=180deg"],
    );
    let said = "1 and 2 are equal: they meet here in a change point, from which the mechanism can go on in either\n";
    assert!(all.ends_with(said), "{all}");
    let (_, all, _) = parallel(
        "range_apart",
        &["assemblies", "four.mech", "--at", "phi=179deg"],
    );
    assert!(!all.contains("equal"), "{all}");
    let folder = four_bar("range_circuits");
    let kite = [
        "circuits",
        "four.mech",
        "--set",
        "crank=60mm",
        "--set",
        "rocker=80mm",
    ];
    let said = "circuits 1 and 2 meet at phi = 180 deg (change point): assemblies 1 and 2\n";
    assert!(printed(&folder, &kite).ends_with(said));
    let dead = [
        "assemblies",
        "four.mech",
        "--set",
        "crank=200mm",
        "--at",
        "phi=78.46304096718453deg",
    ];
    let said = "1 and 2 are equal: they meet here in a dead point, where both end\n";
    assert!(printed(&folder, &dead).ends_with(said));
}

/// The circuits of a turn do not depend on where it begins: at a change point, or beside it.
#[test]
fn circuits_do_not_depend_on_the_beginning_of_a_turn() {
    let folder = four_bar("range_beginnings");
    let file = folder.join("four.mech");
    let text = fs::read_to_string(&file).expect("written");
    let parallel = ["--set", "coupler=140mm", "--set", "rocker=50mm"];
    for range in ["0deg..360deg", "-90deg..270deg", "20deg..380deg"] {
        fs::write(&file, text.replace("0deg..360deg", range)).expect("written");
        let all = printed(
            &folder,
            &[&["circuits", "four.mech"], &parallel[..]].concat(),
        );
        let said = all.lines().last().expect("a line");
        assert!(
            said.starts_with("circuits 1 and 2 meet at phi = ")
                && said.ends_with(" (change points): assemblies 1 and 2"),
            "{range}\n{all}"
        );
    }
}

#[test]
fn negative_lengths_are_warned_of() {
    let folder = slider("ranges_negative");
    let table = ["table", "own.mech", "stroke", "--steps", "1", "--set"];
    // The offset of the guide has a sign.
    printed(&folder, &[&table[..], &["offset=-5mm"]].concat());
    for command in [
        &[&table[..], &["crank=-40mm"]].concat()[..],
        &["page", "own.mech", "--set", "crank=-40mm"],
        &["check", "own.mech", "--set", "crank=-40mm"],
        &["assemblies", "own.mech", "--set", "crank=-40mm"],
        &["circuits", "own.mech", "--set", "crank=-40mm"],
        &["c", "own.mech", "--set", "crank=-40mm"],
    ] {
        let output = linkage(&folder, command);
        let said = String::from_utf8_lossy(&output.stderr);
        let expected = "warning: SliderCrank: `crank = -40mm` is negative, but it is the length of a link\n         help: write a positive length\n --> command line:1:1\n";
        assert_eq!(said.matches(expected).count(), 1, "{command:?}: {said}");
    }
}
