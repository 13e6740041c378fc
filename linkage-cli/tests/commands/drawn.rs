//! Contents of pages: paths that functions return, points that are formulas, files without
//! functions.

use std::fs;
use std::path::Path;

use crate::{folder, linkage};

const FOUR_BAR: &str = "
    unit mm;
    param crank = 40mm;
    input t = 30deg in 0deg..360deg;
    unknown theta = 30deg;
    unknown psi = 80deg;
    let b = polar(crank, t);
    let d = (140mm, 0) + polar(100mm, psi);
    loop b + polar(120mm, theta) = d;
";

/// Writes the page of a mechanism, and returns what the command says besides its path.
fn page(folder: &Path, items: &str, functions: &str) -> String {
    let text = format!("struct M {{ {FOUR_BAR} {items} }} {functions}");
    fs::write(folder.join("m.mech"), text).expect("it can be written");
    let output = linkage(folder, &["page", "m.mech"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{said}");
    said
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join("m_page").join(name)).expect("a file of the page")
}

/// The names of the points whose paths the drawing has.
fn traces(folder: &Path) -> Vec<String> {
    let svg = read(folder, "drawing.svg");
    let paths = svg.split("<").skip(1);
    let traces = paths.filter(|path| path.contains("class=\"path\""));
    let names = traces.filter_map(|path| path.split("data-name=\"").nth(1)?.split('"').next());
    names.map(str::to_owned).collect()
}

#[test]
fn the_path_of_a_joint_that_a_function_returns_is_drawn() {
    let folder = folder("drawn_paths");
    let picture = "fn picture(t) -> Shape { shape: picture() }";
    page(&folder, "", &format!("impl M {{ {picture} }}"));
    assert!(traces(&folder).is_empty(), "{:?}", traces(&folder));
    // The function and its result have other names than the point.
    let path = "fn track(t) -> Track { p: d, half: b / 2 }";
    page(&folder, "", &format!("impl M {{ {path} {picture} }}"));
    assert_eq!(traces(&folder), ["d"]);
    let tip = "let tip = b + polar(60mm, theta + 20deg);";
    page(&folder, tip, &format!("impl M {{ {path} {picture} }}"));
    assert_eq!(traces(&folder), ["d", "tip"]);
}

#[test]
fn a_point_that_is_a_formula_has_no_slide() {
    let folder = folder("drawn_formulas");
    let functions = "impl M { fn picture(t) -> Shape { shape: picture() } }";
    let formula = "param arm = 20mm; let c = (0mm, arm * sin(t));";
    let said = page(&folder, formula, functions);
    assert!(
        said.starts_with("warning: `c` moves, but no link of the picture carries it"),
        "{said}"
    );
    let svg = read(&folder, "drawing.svg");
    assert!(
        !svg.contains("class=\"guide\"") && svg.contains("data-point=\"c\""),
        "{svg}"
    );
    // A sliding length that is an unknown is a slide.
    let slide = "unknown s = 150mm; unknown chi = 60deg; loop b + polar(120mm, chi) = (s, 60mm);";
    let said = page(&folder, slide, functions);
    assert!(
        said.is_empty() && read(&folder, "drawing.svg").contains("class=\"guide\""),
        "{said}"
    );
}

#[test]
fn functions_without_a_picture_have_a_drawing() {
    let folder = folder("drawn_pictureless");
    // A function has the name that the derived one would have.
    let functions = "impl M {
        fn motion(t) -> Motion { psi, v: velocity(psi) }
        fn picture(t) -> Lifted { p: d }
    }";
    let said = page(
        &folder,
        "let tip = b + polar(60mm, theta + 20deg);",
        functions,
    );
    assert_eq!(said, "");
    let svg = read(&folder, "drawing.svg");
    assert!(svg.contains("data-point=\"tip\""), "{svg}");
    assert_eq!(traces(&folder), ["d", "tip"]);
    let table = read(&folder, "motion.csv");
    assert!(
        table.starts_with("t [rad],psi [rad],v [rad/rad]"),
        "{table}"
    );
    assert!(!read(&folder, "data.json").contains("AllUnknowns"));
}

#[test]
fn a_file_without_functions_has_a_page_of_its_unknowns() {
    let folder = folder("drawn_unknowns");
    // A second input on which only one of the unknowns depends, and a third one without effect.
    let items = "input lift = 10mm in 0mm..20mm; input idle = 1deg;
        unknown chi = 60deg; loop distance(d + polar(100mm, chi), (150mm, 80mm + lift)) = 120mm;
        let end = d + polar(100mm, chi);";
    let said = page(&folder, items, "");
    assert!(
        said.ends_with("note: M: there are no functions: the page shows all unknowns\n"),
        "{said}"
    );
    let table = read(&folder, "motion.csv");
    let mut lines = table.lines();
    assert_eq!(
        lines.next(),
        Some("t [rad],theta [rad],psi [rad],chi [rad]")
    );
    assert_eq!(lines.count(), 361);
    assert!(read(&folder, "drawing.svg").contains("data-point=\"end\""));
    assert!(read(&folder, "data.json").contains("there are no functions"));
}
