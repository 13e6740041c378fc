//! What is wrong, and the exit status.

use std::fs;

use crate::{refused, slider};

#[test]
fn bad_input_is_told_in_one_message() {
    let folder = slider("bad");
    let table = |more: &[&str]| {
        let all = [&["table", "own.mech", "stroke"], more].concat();
        refused(&folder, &all, 1)
    };
    for (said, expected) in [
        (
            refused(&folder, &["check", "none.mech"], 1),
            "error: cannot read `none.mech`: there is no such file\n",
        ),
        (
            refused(&folder, &["check", "own"], 1),
            "error: cannot read `own`: there is no such file\nhelp: there is `own.mech`\n",
        ),
        (
            refused(&folder, &["check", "."], 1),
            "error: cannot read `.`: it is a folder\n",
        ),
        (
            refused(&folder, &["table", "own.mech", "strike"], 1),
            "error: there is no function `strike` in `own.mech`; there is `stroke`, `accuracy` and `shape`\n\
             help: did you mean `stroke`?\n",
        ),
        (
            table(&["--set", "crank=300mm"]),
            "error: SliderCrank: loop 1 (theta, slide; RRP) cannot close at the reference input: it misses by 25 mm\n",
        ),
        (
            table(&["--set", "crnak=30mm"]),
            "error: there is no dimension `crnak` in SliderCrank; there is `crank`, `rod` and `offset`\n\
             help: did you mean `crank`?\n",
        ),
        (
            table(&["--set", "crank=30"]),
            "error: `crank=30`: this is a number, `crank` is in mm\nhelp: write `30mm`\n",
        ),
        (
            table(&["--set", "crank=30deg"]),
            "error: `crank=30deg`: this is an angle, `30deg`, `crank` is in mm\n",
        ),
        (
            table(&["--set", "crank=(30mm, 2mm)"]),
            "error: `crank=(30mm, 2mm)`: this is a vector of 2 numbers, `crank` is one number\n",
        ),
        (
            table(&["--set", "crank=30mn"]),
            "error: `crank=30mn`: unknown unit `mn`",
        ),
        (
            table(&["--from", "5mm"]),
            "error: `phi=5mm`: this is in mm, `phi` is an angle, `30deg`\n",
        ),
        (
            table(&["--at", "omega=3"]),
            "error: `stroke` does not take `omega`; it takes `phi`\n\
             help: speed and acceleration of an input are declared with it, `input phi = ... at omega, epsilon`, and listed by functions\n",
        ),
        (
            table(&["--from", "90"]),
            "error: `phi=90`: this is a number, `phi` is an angle, `30deg`\n\
             help: write `90deg` for degrees, `90rad` for radians\n",
        ),
        (
            table(&["--at", "phi=3deg"]),
            "error: `phi` runs from one position to the next and cannot be given by `--at`, too\n",
        ),
        (
            table(&["--over", "psi"]),
            "error: `stroke` has no input `psi`; it has `phi`\n",
        ),
        (
            table(&["--mechanism", "Crank"]),
            "error: there is no mechanism `Crank` in `own.mech`; there is `SliderCrank`\n",
        ),
        (
            table(&["-o", "none/own.csv"]),
            "error: cannot write `none/own.csv`: there is no folder `none`\nhelp: make the folder first, or give another name\n",
        ),
        (
            refused(&folder, &["tolerance", "own.mech", "stroke"], 1),
            "error: `stroke` has no sensitivities: ",
        ),
        (
            refused(&folder, &["page", "own.mech", "-o", "own.mech/page"], 1),
            "error: cannot write own.mech/page: ",
        ),
    ] {
        assert!(said.starts_with(expected), "{said}");
        let messages = said.lines().filter(|line| line.starts_with("error"));
        assert_eq!(messages.count(), 1, "{said}");
    }
    // Nothing was written, whole or half.
    let left = fs::read_dir(&folder).expect("the folder is there").count();
    assert_eq!(left, 1);
}

#[test]
fn wrong_usage_has_a_status_of_its_own() {
    let folder = slider("usage");
    for arguments in [
        &["tabel", "own.mech"][..],
        &["table"],
        &["table", "own.mech", "stroke", "--steps", "many"],
        &["table", "own.mech", "stroke", "--steps", "0"],
        &["table", "own.mech", "stroke", "--decimal", ","],
        &["table", "own.mech", "stroke", "--digits", "0"],
        &["check"],
    ] {
        let said = refused(&folder, arguments, 2);
        assert!(said.starts_with("error: "), "{said}");
    }
}
