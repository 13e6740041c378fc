//! `linkage loops`: what is printed is a mechanism with the same programs and numbers.

use std::fs;

use crate::{folder, linkage, printed, refused};

const LINKS: &str = include_str!("../../../linkage-language/src/model/tests/links.mech");

#[test]
fn printed_loops_are_the_same_mechanism() {
    let folder = folder("printed_loops");
    // Examples whose purpose are their items alone need not close.
    let moving = ["FourBar", "Press", "QuickReturn", "Lift", "TwoPins"];
    let mechanisms = LINKS.split_inclusive("\n}\n");
    let mut source = String::new();
    for text in mechanisms {
        let name = |name: &&str| text.contains(&format!("struct {name} "));
        if let Some(name) = moving.iter().find(|wanted| name(wanted)) {
            source.push_str(text);
            let input = if *name == "Lift" { "stroke" } else { "phi" };
            source.push_str(&format!(
                "impl {name} {{ fn shape({input}) -> {name}Shape {{ shape: picture() }} }}\n"
            ));
        } else if text.starts_with("impl Press") || text.starts_with("impl Lift") {
            source.push_str(text);
        }
    }
    fs::write(folder.join("links.mech"), source).expect("it can be written");
    let loops = printed(&folder, &["loops", "links.mech"]);
    assert!(!loops.contains("link ") && !loops.contains("joint "));
    fs::write(folder.join("loops.mech"), &loops).expect("it can be written");
    let check = |file| {
        let text = printed(&folder, &["check", file]);
        text.lines().map(without_loops).collect::<Vec<_>>()
    };
    assert_eq!(check("links.mech"), check("loops.mech"));
    let table = |file| {
        let torque = [
            "table",
            file,
            "torque",
            "--at",
            "omega=20rad/s",
            "--steps",
            "24",
        ];
        let hold = ["table", file, "hold", "--steps", "24"];
        printed(&folder, &torque) + &printed(&folder, &hold)
    };
    assert_eq!(table("links.mech"), table("loops.mech"));
    // Loops stand for themselves.
    assert_eq!(printed(&folder, &["loops", "loops.mech"]), loops);
}

/// A line of a table of groups without the cell of their loops, which joints are in the other text.
fn without_loops(line: &str) -> String {
    let cells = line.split("  ").map(str::trim);
    let mut cells: Vec<&str> = cells.filter(|cell| !cell.is_empty()).collect();
    let is_row = cells.len() > 5;
    if is_row {
        cells.remove(cells.len() - 3);
    }
    cells.join("  ")
}

#[test]
fn mistakes_are_reported() {
    let folder = folder("mistakes_in_loops");
    let text = "struct A { unit mm; input phi = 0deg; joint a = (0mm, 0mm); link frame: b; }";
    fs::write(folder.join("a.mech"), text).expect("it can be written");
    let told = refused(&folder, &["loops", "a.mech"], 1);
    assert!(told.contains("unknown joint `b`"), "{told}");
}

#[test]
fn loops_that_cannot_be_solved_are_shown() {
    let folder = folder("loops_unsolved");
    let text = "struct A {
        unit mm;
        input phi = 90deg;
        joint a = (0mm, 0mm), b = (0mm, 20mm), c = (50mm, 60mm);
        link frame: a;
        link crank: a, b at phi;
        link rod: b, c;
    }";
    fs::write(folder.join("a.mech"), text).expect("it can be written");
    let output = linkage(&folder, &["loops", "a.mech"]);
    assert_eq!(output.status.code(), Some(1));
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(told.contains("`rod` still moves"), "{told}");
    let shown = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(shown.contains("unknown rod.angle = "), "{shown}");
}

#[test]
fn misspelt_dimensions_of_links_are_recognised() {
    let folder = folder("misspelt_links");
    let text = "struct A {
        unit mm;
        input phi = 90deg;
        joint a = (0mm, 0mm), b = (0mm, 20mm), c = (50mm, 60mm), d = (50mm, 0mm);
        link frame: a, d;
        link crank: a, b at phi;
        link coupler: b, c;
        link rocker: d, c;
    }
    impl A { fn f(phi) -> F { c } }";
    fs::write(folder.join("a.mech"), text).expect("it can be written");
    for misspelt in ["couppler.length", "coupler.lenght"] {
        let set = format!("{misspelt}=70mm");
        let output = linkage(&folder, &["table", "a.mech", "f", "--set", &set]);
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(
            told.ends_with("help: did you mean `coupler.length`?\n"),
            "{told}"
        );
    }
}
