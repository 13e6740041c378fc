//! The table of the joints that close the loops of a URDF.

use std::f64::consts::FRAC_PI_2;

use linkage_engine::Mechanism;
use linkage_import::{Format, Import, Options, import};

use crate::{file, imported};

/// The closure that `four_bar.urdf` has as `loop_joint`.
const FOUR_BAR: &str = "name,kind,link1,x1,y1,z1,link2,x2,y2,z2\n\
    closing,ball,coupler,0.2,0,0,rocker,0.04106729782512121,-0.08910404133226792,0.01\n";

/// A crank, a rod and a ram, which nothing guides.
const CRANK: &str = "<robot name=\"press\">\
    <link name=\"base\"/><link name=\"crank\"/><link name=\"rod\"/><link name=\"ram\"/>\
    <joint name=\"motor\" type=\"continuous\"><parent link=\"base\"/><child link=\"crank\"/>\
    <axis xyz=\"0 0 1\"/></joint>\
    <joint name=\"knee\" type=\"continuous\"><parent link=\"crank\"/><child link=\"rod\"/>\
    <origin xyz=\"0.1 0 0\"/><axis xyz=\"0 0 1\"/></joint>\
    <joint name=\"wrist\" type=\"continuous\"><parent link=\"rod\"/><child link=\"ram\"/>\
    <origin xyz=\"0.3 0 0\"/><axis xyz=\"0 0 1\"/></joint></robot>";

fn closed(urdf: &str, table: &str) -> Result<Import, String> {
    let options = Options {
        format: Some(Format::Urdf),
        closures: Some(table.to_owned()),
        ..Options::default()
    };
    import(urdf.as_bytes(), "four_bar.urdf", &options).map_err(|error| error.to_string())
}

/// The file without its loop, and the table, are the file with its loop.
#[test]
fn a_table_is_the_loop_of_the_file() {
    let whole = String::from_utf8(file("four_bar.urdf")).expect("text");
    let start = whole.find("<loop_joint").expect("a loop");
    let tree = format!("{}</robot>", &whole[..start]);
    let of_table = closed(&tree, FOUR_BAR).expect("a mechanism");
    assert_eq!(of_table, imported("four_bar.urdf", &Options::default()));
    // With other signs between columns and decimals, and the point of the drawing on both links.
    let german = "kind;link1;x1;y1;z1;link2\n# a comment\nball;coupler;0,2;0;0;rocker\n";
    let german = closed(&tree, german).expect("a mechanism").text;
    let point = "param rocker_closure_1 = (";
    let of_table = of_table.text.replace("closing", "closure_1");
    let line = |text: &str| {
        let line = text.lines().find(|line| line.contains(point));
        line.expect("a parameter").to_owned()
    };
    let numbers = |text: &str| -> Vec<f64> {
        let numbers = line(text).replace(['(', ')', 'm', ';'], "");
        let (_, numbers) = numbers.split_once("= ").expect("numbers");
        numbers
            .split(", ")
            .map(|number| number.parse().expect("a number"))
            .collect()
    };
    for (found, wanted) in numbers(&german).iter().zip(numbers(&of_table)) {
        assert!((found - wanted).abs() < 1e-12, "{german}\n{of_table}");
    }
}

/// A slide on the base: the stroke of a slider-crank.
#[test]
fn a_slide_guides_a_ram() {
    let table = "name,kind,link1,x1,y1,z1,link2,axis_x,axis_y,axis_z\n\
                 track,slide,ram,0,0,0,base,1,0,0\n";
    let imported = closed(CRANK, table).expect("a mechanism");
    // A load on the ram, whose guide takes what is across.
    let end = imported
        .text
        .find("}\n\nimpl Press {")
        .expect("the end of the struct");
    let (items, functions) = imported.text.split_at(end);
    let load = "    force (-100N, 30N) on ram at at_wrist;\n";
    let statics = functions.replacen(
        "impl Press {",
        "impl Press {\n    pub fn statics(motor_2) -> Statics { torque: torque(motor_2) }",
        1,
    );
    let text = format!("{items}{load}{statics}");
    let mechanism = Mechanism::compile(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let assembly = mechanism
        .assemble(&mechanism.dimensions())
        .expect("a press");
    for step in 0..=360 {
        let angle = f64::from(step - 180).to_radians();
        let [x, y] = assembly.results("motion", &[angle]).vector::<2>("track_a");
        let (sin, cos) = angle.sin_cos();
        let wanted = 0.1 * cos + (0.09 - 0.01 * sin * sin).sqrt();
        assert!((x - wanted).hypot(y) < 1e-12, "{step}: ({x}, {y})");
        let slope = -0.1 * sin - 0.01 * sin * cos / (0.09 - 0.01 * sin * sin).sqrt();
        let torque = assembly.results("statics", &[angle])["torque"];
        assert!((torque - 100.0 * slope).abs() < 1e-9, "{step}: {torque}");
    }
}

/// The axis of a hinge is in the table, so that a plane mechanism has no equations too many.
#[test]
fn a_hinge_has_its_axis() {
    let whole = String::from_utf8(file("four_bar.urdf")).expect("text");
    let start = whole.find("<loop_joint").expect("a loop");
    let tree = format!("{}</robot>", &whole[..start]);
    let lines = FOUR_BAR.lines().zip([",axis_x,axis_y,axis_z", ",0,0,1"]);
    let table: String = lines
        .map(|(line, axis)| format!("{line}{axis}\n"))
        .collect();
    let ball = closed(&tree, &table).expect("a ball");
    let hinge = closed(&tree, &table.replace("ball", "hinge")).expect("a hinge");
    let in_space = |warning: &&String| warning.contains("holds in space");
    assert_eq!(ball.warnings.iter().filter(in_space).count(), 1);
    assert_eq!(hinge.warnings.iter().filter(in_space).count(), 0);
    let items = |text: &str| text[text.find("pub struct").expect("items")..].to_owned();
    assert_eq!(items(&ball.text), items(&hinge.text));
    let unknown = closed(CRANK, "kind,link1,x1,y1,z1,link2\nglue,ram,0,0,0,base\n");
    assert_eq!(
        unknown.expect_err("no kind"),
        "line 2: there is no kind `glue`; there are `ball`, `hinge`, `slide` and `weld`"
    );
}

#[test]
fn mistakes_of_a_table_have_messages() {
    let heading = "kind,link1,x1,y1,z1,link2\n";
    for (line, message) in [
        (
            "ball,nothing,0,0,0,base",
            "line 2: `link1` is `nothing`, and the file has no such link",
        ),
        (
            "ball,rod,,,,base",
            "line 2: `x1`, `y1` and `z1` are empty: the point of the joint on `link1`",
        ),
        (
            "ball,rod,0,a,0,base",
            "line 2: `y1` is `a`, which is no number",
        ),
        (
            "ball,rod,0,1e12,0,base",
            "line 2: `y1` is `1e12`, which is too large",
        ),
        (
            "ball,rod,0,0,0,rod",
            "line 2: the links `rod` and `rod` do not move against each other",
        ),
        (
            "slide,rod,0,0,0,base",
            "line 2: `axis_x`, `axis_y` and `axis_z` are empty: the axis in the coordinates of `link1`",
        ),
    ] {
        let found = closed(CRANK, &format!("{heading}{line}\n")).expect_err(line);
        assert_eq!(found, message);
    }
    let found = closed(CRANK, "kind,link1,x1,y1,z1\n").expect_err("no column");
    assert!(
        found.starts_with("the table of closures has no column `link2`\nhelp: "),
        "{found}"
    );
    let found = closed(
        CRANK,
        "kind,link1,x1,y1,z1,link2,colour\nball,ram,0,0,0,base,red\n",
    );
    let found = found.expect("a mechanism").warnings;
    assert!(
        found
            .iter()
            .any(|warning| warning.contains("column colour of closures")),
        "{found:?}"
    );
    let options = Options {
        closures: Some(FOUR_BAR.to_owned()),
        ..Options::default()
    };
    let error =
        import(&file("four_bar.sdf"), "four_bar.sdf", &options).expect_err("another format");
    assert!(
        error
            .to_string()
            .starts_with("a file of the format `sdf` takes no table of closures")
    );
}

/// A turret carries a parallelogram: the loop does not depend on the turret, whose range is that of
/// its joint, and has a closed form.
#[test]
fn a_loop_is_seen_from_the_body_that_carries_it() {
    let [urdf, table] = ["palletizer.urdf", "palletizer.csv"]
        .map(|name| String::from_utf8(file(name)).expect("text"));
    let text = closed(&urdf, &table).expect("a mechanism").text;
    let turret = text.lines().find(|line| line.contains("input joint_1"));
    let turret = turret.expect("an input");
    assert!(turret.contains(" in -166.158deg..166.158deg;"), "{turret}");
    let mechanism = Mechanism::compile(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let kinds = mechanism.structure().groups.iter().map(|group| group.kind);
    assert_eq!(kinds.collect::<Vec<_>>(), ["RRR"]);
    let assembly = mechanism
        .assemble(&mechanism.dimensions())
        .expect("a robot");
    for turret in [-2.9, -FRAC_PI_2, 0.4, 2.0] {
        for [arm, crank] in [[0.0, 0.0], [-0.6, 0.4], [1.1, -0.3], [0.5, 0.9]] {
            let results = assembly.results("motion", &[turret, arm, crank]);
            // The upper arm is parallel to the crank.
            let elbow = results["elbow"];
            assert!(
                (elbow - (crank - arm)).abs() < 1e-12,
                "{elbow} at {arm}, {crank}"
            );
            let (sin, cos) = f64::sin_cos(turret);
            let out = 0.1 + 0.45 * f64::sin(arm) - 0.12 * f64::cos(crank);
            let up = 0.4 + 0.45 * f64::cos(arm) + 0.12 * f64::sin(crank);
            let [x, y, z] = results.vector::<3>("parallelogram_a");
            let error = (x - out * cos).hypot(y - out * sin).hypot(z - up);
            assert!(error < 1e-12, "{error} at {turret}, {arm}, {crank}");
        }
    }
}
