//! Values on the command line, numbers of assemblies, and numbers in messages.

use std::fs;

use crate::{IN_LINE, folder, printed, refused, slider};

/// The rows of a text, as words.
fn rows(text: &str) -> Vec<Vec<&str>> {
    text.lines()
        .map(|line| line.split_whitespace().collect())
        .collect()
}

#[test]
fn tolerances_are_set() {
    let folder = slider("set_tolerances");
    let figures = |set: &[&str]| {
        let all = [&["tolerance", "own.mech", "accuracy"], &IN_LINE[..], set].concat();
        let text = printed(&folder, &all);
        let row = rows(&text)[2]
            .iter()
            .map(|cell| cell.parse().expect("a number"))
            .collect();
        let row: Vec<f64> = row;
        row
    };
    // In line with the guide, crank and rod count fully.
    assert_eq!(figures(&[])[1..], [0.03, 0.022_360_7, 0.01, 0.02, 0.0]);
    let three = figures(&["--set", "crank=40mm +- 3mm"]);
    assert_eq!(three[1], 3.02);
    assert_eq!(three[3..5], [3.0, 0.02]);
    // Without a tolerance that of the file stays; 0 is none.
    assert_eq!(figures(&["--set", "crank=40mm"])[3], 0.01);
    assert_eq!(figures(&["--set", "crank=40mm + - 0mm"])[1], 0.02);
    // The page has it, too.
    printed(
        &folder,
        &[
            "page",
            "own.mech",
            "--steps",
            "3",
            "--set",
            "crank=40mm +- 3mm",
        ],
    );
    let data = fs::read_to_string(folder.join("own_page/data.json")).expect("data");
    let data: serde_json::Value = serde_json::from_str(&data).expect("JSON");
    assert!(data.to_string().contains("\"tolerance\":3.0"), "{data}");
    let said = refused(
        &folder,
        &["table", "own.mech", "stroke", "--from", "0deg +- 1deg"],
        1,
    );
    assert_eq!(
        said,
        "error: `phi=0deg +- 1deg`: only dimensions have tolerances, by `--set`\n"
    );
    let said = refused(
        &folder,
        &["table", "own.mech", "stroke", "--set", "offset=0 +- 1deg"],
        1,
    );
    assert!(said.contains("this is an angle"), "{said}");
}

/// A lid of 56 lb whose weight has an arm of 16 inches, and a strut of 32 lb that holds it at 28.
#[test]
fn inches_and_pounds_are_units() {
    let folder = folder("pounds");
    let text = "pub struct Lid { unit inch; argument strut = 32lbf; input door = 0deg in 0deg..80deg at omega; \
        gravity = (0, -9.80665m/s^2); let tip = polar(28inch, door); \
        body lid = pin hinge on frame at (0, 0), turns door, mass 56lb at polar(16inch, door); \
        force (0, strut) on lid at tip; } \
        impl Lid { pub fn hold(door, strut) -> Hold { t: torque(door) } pub fn tip(door, omega) -> Tip { v: omega * velocity(tip) } }";
    fs::write(folder.join("lid.mech"), text).expect("written");
    let values = |function: &str, at: &[&str]| {
        let all = [
            &[
                "table", "lid.mech", function, "--from", "0deg", "--to", "1deg", "--steps", "2",
            ],
            at,
        ]
        .concat();
        let text = printed(&folder, &all);
        let cells = text.lines().nth(1).expect("a row").split(',');
        let numbers = cells.map(|cell| cell.parse().expect("a number"));
        (text.clone(), numbers.collect::<Vec<f64>>())
    };
    let (text, row) = values("hold", &[]);
    assert_eq!(text.lines().next(), Some("door [rad],t [N*inch]"));
    assert!(row[1].abs() < 1e-9, "{text}");
    // 16 lbf less with an arm of 28 inches.
    let (text, row) = values("hold", &["--at", "strut=16lbf"]);
    assert!(
        (row[1] - 448.0 * 4.448_221_615_260_5).abs() < 1e-9,
        "{text}"
    );
    // 33 feet and 4 inches in a second.
    let (text, row) = values("tip", &["--at", "omega=30rpm"]);
    assert!(
        (row[2] - 28.0 * std::f64::consts::PI).abs() < 1e-9,
        "{text}"
    );
}

#[test]
fn assemblies_and_circuits_number_alike() {
    let folder = slider("alike_numbers");
    let text = fs::read_to_string(folder.join("own.mech")).expect("the mechanism");
    // The other estimates choose the other assembly, which is the first then.
    let start = text.find("unknown theta = ").expect("an estimate");
    let end = start + text[start..].find("unknown slide").expect("the next");
    let mut other = text.clone();
    other.replace_range(start..end, "unknown theta = -170deg; ");
    let start = other.find("unknown slide = ").expect("an estimate");
    let end = start + other[start..].find(';').expect("an end");
    other.replace_range(start..end, "unknown slide = -84mm");
    fs::write(folder.join("other.mech"), other).expect("written");
    for file in ["own.mech", "other.mech"] {
        let assemblies = printed(&folder, &["assemblies", file]);
        let circuits = printed(&folder, &["circuits", file]);
        let listed = rows(&assemblies);
        let reached = rows(&circuits);
        assert_eq!(
            (listed.len(), reached.len()),
            (3, 4),
            "{assemblies}{circuits}"
        );
        for number in 1..3 {
            let [one, other] = [&listed[number], &reached[number + 1]];
            assert_eq!([one[0], other[0]], [number.to_string().as_str(); 2]);
            let slide = one.last().expect("the slide");
            assert_eq!(other.last(), Some(slide), "{assemblies}{circuits}");
            assert_eq!(other[1], number.to_string(), "circuits as they come");
        }
    }
}

#[test]
fn assemblies_that_do_not_reach_the_reference_are_numbered_after_the_others() {
    let folder = folder("beyond");
    let text = "pub struct Rocking { unit mm; param ground = 100mm; param crank = 90mm; param rod = 30mm; \
        param rocker = 90mm; input phi = 50deg; unknown theta; unknown psi = 60deg; \
        loop polar(crank, phi) + polar(rod, theta) = (ground, 0) + polar(rocker, psi); } \
        impl Rocking { pub fn f(phi) -> F { theta, psi } }";
    fs::write(folder.join("own.mech"), text).expect("written");
    let assemblies = printed(&folder, &["assemblies", "own.mech"]);
    let circuits = printed(&folder, &["circuits", "own.mech"]);
    let listed = assemblies.lines().count() - 1;
    let reached = rows(&circuits);
    let numbers: Vec<&str> = reached[2..].iter().map(|row| row[0]).collect();
    let expected: Vec<String> = (1..=numbers.len())
        .map(|number| number.to_string())
        .collect();
    assert_eq!(numbers, expected, "{circuits}");
    assert!(numbers.len() > listed, "{assemblies}{circuits}");
    for (number, line) in assemblies.lines().skip(1).enumerate() {
        let psi = line.rsplit_once(" = ").expect("psi").1;
        assert_eq!(
            reached[number + 2].last(),
            Some(&psi),
            "{assemblies}{circuits}"
        );
    }
}

/// A unit has its letters behind a number, whatever the mechanism calls its input.
#[test]
fn units_are_not_names() {
    let folder = folder("units");
    let text = "pub struct Ram { unit mm; input s = 100mm in 90mm..110mm at v; let y = s / 2; }
        impl Ram { pub fn motion(s, v) -> Motion { speed: velocity(y) * v } }";
    fs::write(folder.join("ram.mech"), text).expect("a file");
    let at = ["table", "ram.mech", "motion"];
    let said = printed(&folder, &[&at[..], &["--at", "v=-0.7m/s"]].concat());
    assert!(said.contains("-350"), "{said}");
    let said = refused(&folder, &[&at[..], &["--at", "v=-7*s"]].concat(), 1);
    assert!(said.contains("`s` of Ram cannot be used here"), "{said}");
}

#[test]
fn values_are_refused_in_words_of_the_command_line() {
    let folder = slider("values");
    for (set, expected) in [
        (
            "crank=1mm/0",
            "error: `crank=1mm/0`: the value of `crank` is not a finite number\n",
        ),
        (
            "crank=rod",
            "error: `crank=rod`: `rod` of SliderCrank cannot be used here\n\
             help: a value may use numbers with units, functions and constants only\n",
        ),
        (
            "crank=2 * other",
            "error: `crank=2 * other`: unknown name `other`\n\
             help: a value or tolerance may use numbers, functions and constants only\n",
        ),
        (
            "crank=50,5mm",
            "error: `crank=50,5mm`: a comma stands between the components of a vector only\n\
             help: write `50.5mm`\n",
        ),
        (
            "crank=40mm +- 0,1mm",
            "error: `crank=40mm +- 0,1mm`: a comma stands between the components of a vector only\n\
             help: write `40mm +- 0.1mm`\n",
        ),
        (
            "crank=1.050,5mm",
            "error: `crank=1.050,5mm`: a comma stands between the components of a vector only\n\
             help: write a point before the decimals, and nothing between thousands\n",
        ),
        ("crank=min(50mm, 5)", "error: `crank=min(50mm, 5)`: "),
    ] {
        let said = refused(&folder, &["table", "own.mech", "stroke", "--set", set], 1);
        assert!(said.starts_with(expected), "{said}");
    }
}

#[test]
fn zero_is_printed_without_sign_and_noise() {
    let folder = slider("zero");
    let text = printed(&folder, &["assemblies", "own.mech", "--at", "phi=-0deg"]);
    assert!(text.starts_with("SliderCrank at phi = 0 deg: 2"), "{text}");
    let mirrored = ["--set", "offset=0mm", "--from", "-0deg", "--to", "90deg"];
    let table = [
        "table",
        "own.mech",
        "stroke",
        "--steps",
        "2",
        "--digits",
        "6",
        "--degrees",
    ];
    let text = printed(&folder, &[&table[..], &mirrored].concat());
    assert!(text.contains("\r\n0.00000,160.000,0.00000,"), "{text}");
    // The least margin is at 0 deg, found as the place of a smallest value.
    fs::write(folder.join("least.mech"), LEAST).expect("written");
    let text = printed(&folder, &["circuits", "least.mech"]);
    for row in &rows(&text)[2..] {
        assert!(!row.iter().any(|word| word.contains("e-")), "{text}");
        assert_eq!(row[7..9], ["0", "deg"], "{text}");
    }
}

/// A four-bar whose transmission angle is worst where the crank lies on the frame, amid its range.
const LEAST: &str = "pub struct S { unit mm; param ground = 100mm; param crank = 30mm; param rod = 80mm; \
    param rocker = 70mm; input phi = 30deg in -50deg..60deg; unknown theta = 50deg; unknown psi = 100deg; \
    loop polar(crank, phi) + polar(rod, theta) = (ground, 0) + polar(rocker, psi); } \
    impl S { pub fn f(phi) -> F { theta, psi } }";

#[test]
fn lengths_are_printed_in_the_unit_that_they_were_written_in() {
    let folder = folder("written_units");
    let text = "pub struct S { unit inch; input s = 3mm in 2mm..0.5inch; let p = (s, 1inch); } \
        impl S { pub fn f(s) -> F { p } }";
    fs::write(folder.join("own.mech"), text).expect("written");
    let known = printed(&folder, &["check", "own.mech"]);
    assert!(
        known.contains("input s = 3 mm, in 2 mm .. 0.5 inch\n"),
        "{known}"
    );
    fs::write(folder.join("own.mech"), text.replace("2mm..", "4mm..")).expect("written");
    let said = refused(&folder, &["check", "own.mech"], 1);
    let expected =
        "error: the range of `s` from 4mm to 0.5inch does not contain its reference value 3mm\n";
    assert!(said.starts_with(expected), "{said}");
}
