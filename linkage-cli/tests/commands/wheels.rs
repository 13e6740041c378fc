//! Gears and belts of joints and links: circles of drawings, equations in descriptions of robots.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::{folder, linkage, printed};

/// A crank drives the lever of a four-bar.
const GEARS: &str = "
pub struct M {
    unit mm;
    input phi = 60deg in 0deg..360deg;
    joint a = (0mm, 0mm), d = (60mm, 0mm), p = (10mm, 17.320508075688775mm), q = (60mm, 25mm);
    joint c = (130mm, 40mm), e = (140mm, 0mm);
    link frame: a, d, e;
    link crank: a, p at phi;
    link wheel: d, q;
    link coupler: q, c;
    link rocker: e, c;
    gears crank, wheel teeth 20, 40;
}
impl M { pub fn look(phi) -> Look { shape: picture(), crank: crank.angle, wheel: wheel.angle } }
";

/// Two cranks with a belt, and a wheel of one joint next to them.
const BELT: &str = "
pub struct M {
    unit mm;
    input phi = 60deg in 0deg..360deg;
    joint a = (0mm, 0mm), d = (100mm, 0mm), p = (10mm, 17.320508075688775mm);
    joint q = (110mm, 17.320508075688775mm), c = (60mm, 80mm), i = (0mm, -90mm);
    link frame: a, d, i;
    link crank: a, p at phi;
    link other: d, q;
    link idler: i;
    link left: p, c;
    link right: q, c;
    belt crank, other radii 20mm, 20mm;
    gears crank, idler teeth 40, 20;
}
impl M { pub fn look(phi) -> Look { shape: picture(), crank: crank.angle, idler: idler.angle } }
";

/// A planet in a ring of the frame.
const PLANET: &str = "
pub struct M {
    unit mm;
    input phi = 30deg in 0deg..360deg;
    joint o = (0mm, 0mm), c = (34.64101615137754mm, 20mm), t = (54.64101615137754mm, 20mm);
    link frame: o;
    link arm: o, c at phi;
    link planet: c, t;
    gears planet, frame on arm teeth 20, -60;
}
impl M { pub fn look(phi) -> Look { shape: picture(), arm: arm.angle, planet: planet.angle } }
";

/// A five-bar with gears on its coupler: the second wheel hangs on other links than its carrier.
const GEARED_FIVE_BAR: &str = "
pub struct M {
    unit mm;
    input phi = 60deg in 40deg..80deg;
    joint a = (0mm, 0mm), d = (100mm, 0mm), p = (10mm, 17.320508075688775mm);
    joint e = (110mm, 20mm), c = (55mm, 80mm);
    link frame: a, d;
    link crank: a, p at phi;
    link back: d, e;
    link wheel: e, c;
    link coupler: p, c;
    gears crank, wheel on coupler teeth 20, 20;
}
impl M {
    pub fn look(phi) -> Look {
        crank: crank.angle, back: back.angle, wheel: wheel.angle, coupler: coupler.angle,
    }
}
";

/// The rows of a table from its first one, without the column of the input.
fn turns(folder: &Path, names: &[&str], steps: &str) -> Vec<Vec<f64>> {
    let arguments = ["table", "own.mech", "look", "--steps", steps];
    let table = printed(folder, &arguments);
    let mut lines = table.lines();
    let titles: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let columns = names.iter().map(|name| {
        let title = format!("{name} [rad]");
        let found = titles.iter().position(|other| *other == title);
        found.unwrap_or_else(|| panic!("no {title}: {titles:?}"))
    });
    let columns: Vec<usize> = columns.collect();
    let rows = lines.map(|line| -> Vec<f64> {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |column: &usize| cells[*column].parse().expect("a number");
        columns.iter().map(number).collect()
    });
    let rows: Vec<Vec<f64>> = rows.collect();
    let from_first = |row: &Vec<f64>| row.iter().zip(&rows[0]).map(|(x, x0)| x - x0).collect();
    rows.iter().map(from_first).collect()
}

fn written(name: &str, text: &str) -> PathBuf {
    let folder = folder(name);
    fs::write(folder.join("own.mech"), text).expect("a file");
    folder
}

/// A description of bodies, whose missing masses are noted.
fn described(folder: &Path, arguments: &[&str]) -> String {
    let output = linkage(folder, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(
        said.lines().all(|line| line.starts_with("note: ")),
        "{said}"
    );
    String::from_utf8(output.stdout).expect("text")
}

/// The text of an attribute in a line of a description.
fn attribute<'t>(line: &'t str, name: &str) -> &'t str {
    let (_, rest) = line
        .split_once(&format!(" {name}=\""))
        .unwrap_or_else(|| panic!("no {name}: {line}"));
    rest.split('"').next().unwrap_or_default()
}

fn line_with<'t>(text: &'t str, part: &str) -> &'t str {
    let line = text.lines().find(|line| line.contains(part));
    line.unwrap_or_else(|| panic!("no `{part}` in {text}"))
}

/// The value of a polynomial that is written with the lowest power first.
fn value(polynomial: &str, x: f64) -> f64 {
    let coefficients: Vec<f64> = polynomial
        .split(' ')
        .map(|word| word.parse().expect("a number"))
        .collect();
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// Radii and ratio of each pair of a drawing, and if a belt joins it.
fn pairs(name: &str, text: &str) -> Vec<([f64; 2], f64, bool)> {
    let folder = written(name, text);
    printed(&folder, &["page", "own.mech", "-o", "report"]);
    let data = fs::read_to_string(folder.join("report/data.json")).expect("the data");
    let data: Value = serde_json::from_str(&data).expect("JSON");
    let gears = data["picture"]["gears"].as_array().expect("gears").clone();
    let number = |value: &Value| value.as_f64().expect("a number");
    let pair = |gear: &Value| {
        let radii = [0, 1].map(|wheel| number(&gear["radii"][wheel]));
        let belt = gear["belt"].as_bool().expect("a truth value");
        (radii, number(&gear["ratio"]), belt)
    };
    gears.iter().map(pair).collect()
}

#[track_caller]
fn expect_pairs(found: &[([f64; 2], f64, bool)], expected: &[([f64; 2], f64, bool)]) {
    let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
    let alike = found.len() == expected.len()
        && found.iter().zip(expected).all(|(a, b)| {
            near(a.0[0], b.0[0]) && near(a.0[1], b.0[1]) && near(a.1, b.1) && a.2 == b.2
        });
    assert!(alike, "{found:?}\n{expected:?}");
}

#[test]
fn wheels_are_drawn_as_they_touch() {
    let found = pairs("wheels_gears", GEARS);
    expect_pairs(&found, &[([20.0, 40.0], -0.5, false)]);
    let found = pairs("wheels_belt", BELT);
    expect_pairs(
        &found,
        &[([30.0, 30.0], 1.0, true), ([60.0, 30.0], -2.0, false)],
    );
    // The ring is as large as the planet and the arm together.
    let found = pairs("wheels_planet", PLANET);
    expect_pairs(&found, &[([20.0, 60.0], 1.0 / 3.0, false)]);
}

#[test]
fn gears_are_equations_of_mujoco() {
    for (name, text, angles, joints) in [
        ("mjcf_gears", GEARS, ["crank", "wheel"], ["a", "d"]),
        ("mjcf_idler", BELT, ["crank", "idler"], ["a", "i"]),
    ] {
        let folder = written(name, text);
        let model = described(&folder, &["mjcf", "own.mech"]);
        let part = format!("joint1=\"{}\" joint2=\"{}\"", joints[1], joints[0]);
        let polynomial = attribute(line_with(&model, &part), "polycoef");
        for row in turns(&folder, &angles, "24") {
            let miss = row[1] - value(polynomial, row[0]);
            assert!(miss.abs() < 1e-12, "{miss} of {row:?}: {polynomial}");
        }
    }
}

/// The joint of a planet turns against the arm.
#[test]
fn planets_turn_against_their_arm() {
    let folder = written("mjcf_planet", PLANET);
    let model = described(&folder, &["mjcf", "own.mech"]);
    let polynomial = attribute(line_with(&model, "joint1=\"c\" joint2=\"o\""), "polycoef");
    let robot = described(&folder, &["urdf", "own.mech"]);
    let mimic = line_with(&robot, "<mimic joint=\"o\"");
    let [slope, start]: [f64; 2] =
        ["multiplier", "offset"].map(|name| attribute(mimic, name).parse().expect("a number"));
    for row in turns(&folder, &["arm", "planet"], "24") {
        let against = row[1] - row[0];
        for found in [value(polynomial, row[0]), start + slope * row[0]] {
            assert!((against - found).abs() < 1e-12, "{found} of {row:?}");
        }
    }
}

#[test]
fn wheels_between_other_links_are_a_tendon() {
    let folder = written("mjcf_tendon", GEARED_FIVE_BAR);
    let model = described(&folder, &["mjcf", "own.mech"]);
    let name = attribute(line_with(&model, "<fixed"), "name");
    line_with(
        &model,
        &format!("<tendon tendon1=\"{name}\" polycoef=\"0 0 0 0 0\"/>"),
    );
    let factor = |joint: &str| -> f64 {
        let line = line_with(&model, &format!("<joint joint=\"{joint}\" coef="));
        attribute(line, "coef").parse().expect("a number")
    };
    let factors = ["a", "d", "e", "p"].map(factor);
    for row in turns(&folder, &["crank", "back", "wheel", "coupler"], "8") {
        let [crank, back, wheel, coupler] = row[..] else {
            panic!("{row:?}")
        };
        // Each joint turns a body against the one that it hangs on.
        let joints = [crank, back, wheel - back, coupler - crank];
        let sum: f64 = joints
            .iter()
            .zip(factors)
            .map(|(x, factor)| x * factor)
            .sum();
        assert!(sum.abs() < 1e-9, "{sum} of {row:?}");
    }
}
