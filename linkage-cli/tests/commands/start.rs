//! From a new file to its assemblies and tolerances.

use std::fs;

use crate::{IN_LINE, printed, refused, slider};

#[test]
fn the_mechanism_to_start_from_has_everything() {
    let folder = slider("start");
    let again = refused(&folder, &["new", "own.mech"], 1);
    assert!(
        again.starts_with("error: cannot write `own.mech`: "),
        "{again}"
    );
    let known = printed(&folder, &["check", "own.mech"]);
    for line in [
        "SliderCrank: mobility 1",
        "1      RRP   2      2      0     1      theta, slide  ",
        "input phi = 30 deg, in 0 deg .. 360 deg",
        "assemblies at the reference: 2",
    ] {
        assert!(known.contains(line), "{line} in {known}");
    }
    let all = printed(&folder, &["assemblies", "own.mech", "--at", "phi=90deg"]);
    assert_eq!(
        all,
        "SliderCrank at phi = 90 deg: 2 assemblies\n\
         1  modes -: theta = -16.9578deg, slide = 114.782mm\n\
         2  modes +: theta = -163.042deg, slide = -114.782mm\n"
    );
    let circuits = printed(&folder, &["circuits", "own.mech"]);
    assert_eq!(
        circuits.matches("360 deg (closed)").count(),
        2,
        "{circuits}"
    );
}

#[test]
fn tolerances_add_up() {
    let folder = slider("tolerances");
    // In line with the guide crank and rod count fully, and the offset not at all.
    let all = [&["tolerance", "own.mech", "accuracy"], &IN_LINE[..]].concat();
    let text = printed(&folder, &all);
    assert!(text.starts_with("e [mm]\nphi [deg]  worst case"), "{text}");
    let row: Vec<f64> = text
        .lines()
        .nth(2)
        .into_iter()
        .flat_map(|line| line.split_whitespace())
        .map(|cell| cell.parse().expect("a number"))
        .collect();
    assert_eq!(row, [0.0, 0.03, 0.022_360_7, 0.01, 0.02, 0.0]);
    let (_, worst) = text
        .split_once("worst at phi = ")
        .expect("the worst position");
    for name in ["worst case", "root sum square", "crank", "rod", "offset"] {
        assert!(worst.contains(&format!("\n{name} ")), "{text}");
    }
    assert_eq!(worst.matches(" %").count(), 6, "{text}");
}

#[test]
fn one_of_several_mechanisms_is_chosen_by_its_name() {
    let folder = slider("chosen");
    let text = fs::read_to_string(folder.join("own.mech")).expect("the mechanism");
    let other = text.replace("SliderCrank", "Other").replace("40mm", "45mm");
    fs::write(folder.join("two.mech"), text + &other).expect("it can be written");
    let table = ["table", "two.mech", "stroke", "--steps", "1"];
    assert_eq!(
        refused(&folder, &table, 1),
        "error: the function `stroke` is in `SliderCrank` and `Other` in `two.mech`: choose one by `--mechanism NAME`\n"
    );
    let by_name = |name| printed(&folder, &[&table[..], &["--mechanism", name]].concat());
    assert!(by_name("SliderCrank").contains("\r\n0,159.8957"));
    assert!(by_name("Other").contains("\r\n0,164.8957"));
}
