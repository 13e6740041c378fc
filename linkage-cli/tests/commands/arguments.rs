//! Loads with a declared value, and `--at` in files of several mechanisms.

use std::fs;
use std::path::Path;

use crate::{folder, linkage, printed, refused};

/// A loaded slider, whose drive needs `load * length`.
const PRESS: &str = "
struct Press {
    unit mm;
    param lever = 40mm;
    argument load = 2kN;
    input phi = 30deg in 10deg..80deg at omega;
    let p = polar(lever, phi);
    body arm = pin a on frame at (0, 0), turns phi, mass 1kg at p;
    force (0, -load) on arm at p;
}
impl Press {
    fn forces(phi, load) -> Forces { t: torque(phi), a: reaction(a) }
    fn energy(phi, omega) -> Energy { e: kinetic_energy() }
}
";

const DOOR: &str = "
struct Door {
    unit mm;
    param width = 900mm;
    argument wind = 50N;
    input psi = 45deg in 0deg..90deg;
    let p = polar(width, psi);
    body leaf = pin hinge on frame at (0, 0), turns psi;
    force (wind, 0) on leaf at p;
}
impl Door { fn hold(psi, wind) -> Hold { t: torque(psi) } }
";

fn data(page: &Path) -> serde_json::Value {
    let data = fs::read_to_string(page.join("data.json")).expect("data");
    serde_json::from_str(&data).expect("JSON")
}

/// Values of a column of a table of a page, in order.
fn column(page: &Path, function: &str, column: usize) -> Vec<f64> {
    let lines = fs::read_to_string(page.join(function).with_extension("csv")).expect("a table");
    let cell = |line: &str| {
        line.split(',')
            .nth(column)
            .and_then(|cell| cell.parse().ok())
    };
    lines.lines().skip(1).filter_map(cell).collect()
}

#[test]
fn a_declared_load_is_the_default() {
    let folder = folder("arguments_default");
    fs::write(folder.join("press.mech"), PRESS).expect("it can be written");
    let table = [
        "table",
        "press.mech",
        "forces",
        "--steps",
        "2",
        "--digits",
        "6",
    ];
    let declared = printed(&folder, &table);
    assert!(
        declared.contains("\r\n0.174533,78784.6,0.00000,2000.00\r\n"),
        "{declared}"
    );
    let given = |load: &str| printed(&folder, &[&table[..], &["--at", load]].concat());
    assert_eq!(given("load=2000N"), declared);
    assert!(given("load=1kN").contains("\r\n0.174533,39392.3,0.00000,1000.00\r\n"));
}

#[test]
fn a_page_has_the_forces_of_the_declared_load() {
    let folder = folder("arguments_page");
    fs::write(folder.join("press.mech"), PRESS).expect("it can be written");
    let output = linkage(&folder, &["page", "press.mech"]);
    // A speed has no declared value.
    assert_eq!(
        String::from_utf8_lossy(&output.stderr),
        "note: Press: `energy` is not shown: it takes `omega`, too, which is given by `--at omega=VALUE`\n"
    );
    let page = folder.join("press_page");
    assert!((column(&page, "forces", 1)[0] - 78_784.6).abs() < 1.0);
    // The slider of the page begins there.
    let html = fs::read_to_string(page.join("index.html")).expect("a page");
    assert!(
        html.contains(r#""given":{"load":2000.0}"#) || html.contains(r#""given":{"load":2000}"#)
    );
    assert_eq!(data(&page)["title"], "Press");
}

#[test]
fn an_argument_goes_to_the_mechanisms_that_take_it() {
    let folder = folder("arguments_two");
    let two = format!("{PRESS}{DOOR}");
    fs::write(folder.join("two.mech"), two).expect("it can be written");
    let page = |options: &[&str]| {
        let output = linkage(&folder, &[&["page", "two.mech"], options].concat());
        assert!(output.status.success(), "{output:?}");
        let first = |name: &str, function: &str| {
            column(&folder.join("two_page").join(name), function, 1)[9]
        };
        [first("Press", "forces"), first("Door", "hold")]
    };
    let declared = page(&[]);
    let given = page(&[
        "--at",
        "wind=150N",
        "--at",
        "omega=2rad/s",
        "--set",
        "width=450mm",
    ]);
    assert_eq!(declared[0], given[0]);
    // Three times the wind on half of the width.
    assert!(declared[1] != 0.0 && (1.5 * declared[1] - given[1]).abs() < 1e-9 * given[1].abs());
    assert!(folder.join("two_page/Press/energy.csv").is_file());
    let said = refused(&folder, &["page", "two.mech", "--at", "laod=1kN"], 1);
    assert_eq!(
        said,
        "error: no function of `Press` and `Door` takes `laod`; they take `load`, `omega`, `phi`, `psi` and `wind`\n\
         help: did you mean `load`?\n"
    );
    let said = refused(&folder, &["page", "two.mech", "--at", "psi=10deg"], 1);
    assert!(
        said.starts_with("error: `psi` runs from one position to the next"),
        "{said}"
    );
    let said = refused(&folder, &["page", "two.mech", "--set", "heigth=1mm"], 1);
    assert!(
        said.starts_with("error: there is no dimension `heigth` in Press"),
        "{said}"
    );
}

#[test]
fn assemblies_take_the_inputs_of_any_mechanism() {
    let folder = folder("arguments_assemblies");
    fs::write(folder.join("two.mech"), format!("{PRESS}{DOOR}")).expect("it can be written");
    let all = printed(
        &folder,
        &[
            "assemblies",
            "two.mech",
            "--at",
            "psi=60deg",
            "--set",
            "width=1m",
        ],
    );
    assert!(
        all.contains("Press at phi = 30 deg") && all.contains("Door at psi = 60 deg"),
        "{all}"
    );
    let said = refused(&folder, &["assemblies", "two.mech", "--at", "chi=60deg"], 1);
    assert_eq!(
        said,
        "error: none of `Press` and `Door` has an input `chi`; they have `phi` and `psi`\n"
    );
}
