//! What a file does not say is asked for, and what is not taken is named.

use linkage_engine::Mechanism;
use linkage_import::{Format, Options};

use crate::{file, hard_points, imported, refused};

fn text_of(name: &str) -> String {
    String::from_utf8(file(name)).expect("text")
}

#[test]
fn axes_unit_and_side_are_asked_for() {
    let table = text_of("double_wishbone.csv");
    let plain = Options {
        format: Some(Format::HardPoints),
        ..Options::default()
    };
    let said = refused(&table, "a.csv", &plain);
    assert!(
        said.starts_with("a table of points does not say its axes, its unit and its side"),
        "{said}"
    );
    for choice in [
        "--axes forward,left,up",
        "SAE J670",
        "`inch`",
        "--side left",
    ] {
        assert!(said.contains(choice), "{said}");
    }
    let said = refused(&table, "a.csv", &hard_points("forward,left,up", "right"));
    assert!(
        said.starts_with("with these axes the wheel centre is left of the middle"),
        "{said}"
    );
    let said = refused(&table, "a.csv", &hard_points("forward,left,left", "left"));
    assert!(
        said.starts_with("`forward,left,left` are no three axes"),
        "{said}"
    );
    // The same points with the axes of SAE are on the right.
    let text = imported(
        "double_wishbone.csv",
        &hard_points("forward,right,up", "right"),
    )
    .text;
    assert!(
        text.contains("joint lower_front    = ( 180mm,   -250mm,   125mm);"),
        "{text}"
    );
}

#[test]
fn roles_are_asked_for() {
    let table = text_of("five_rods.csv");
    let said = refused(&table, "a.csv", &hard_points("forward,left,up", "left"));
    assert!(said.starts_with("no point has a role: p1, q1"), "{said}");
    assert!(
        said.contains("\n  rod1_inner: first rod on the chassis\n"),
        "{said}"
    );
    let mut options = hard_points("forward,left,up", "left");
    options.roles.push("rod1_inner=P1".to_owned());
    let said = refused(&table, "a.csv", &options);
    assert!(said.contains("; points without a role: q1, "), "{said}");
    options.roles = vec!["rod6_inner=P1".to_owned()];
    let said = refused(&table, "a.csv", &options);
    assert!(
        said.starts_with("there is no role `rod6_inner`; there are\n"),
        "{said}"
    );
}

#[test]
fn steering_is_a_shift_and_no_sense() {
    let text = imported(
        "double_wishbone.csv",
        &hard_points("forward,left,up", "left"),
    )
    .text;
    assert!(text.contains("param rack = 0mm;"));
    assert!(text.contains("let tie_inner = (76mm, 230mm, 201mm) + (0mm, rack, 0mm);"));
    assert!(text.contains("link tie_rod: tie_inner, tie_outer;"));
    // The rack becomes an input by its declaration alone.
    let steered = text
        .replace("param rack = 0mm;", "input rack = 0mm in -20mm..20mm;")
        .replace("(travel)", "(travel, rack)");
    let mechanism = Mechanism::compile(&steered).unwrap_or_else(|error| panic!("{error}"));
    let assembly = mechanism
        .assemble(&mechanism.dimensions())
        .expect("a suspension");
    let ends = [-15.0, 15.0].map(|rack| {
        let results = assembly.results("motion", &[10.0, rack]);
        let [x, y, z] = results.vector::<3>("tie_outer");
        let length = (x - 76.0).hypot(y - 230.0 - rack).hypot(z - 201.0);
        let drawn = 322f64.hypot(40.0);
        assert!((length - drawn).abs() < 1e-9, "{length} for {drawn}");
        results["toe"]
    });
    assert!((ends[0] - ends[1]).abs() > 0.1, "{ends:?}");
}

#[test]
fn what_is_not_taken_is_named() {
    let warnings = imported("four_bar.xml", &Options::default()).warnings;
    let all = warnings.join("\n");
    for name in ["2 geom", "light", "sensor", "timestep of option"] {
        assert!(all.contains(name), "{name}: {all}");
    }
    assert!(
        all.contains("the loop `closing` holds in space; in the plane its other equations"),
        "{all}"
    );
    // Comments are wrapped.
    let text = imported("four_bar.xml", &Options::default()).text;
    let words: Vec<&str> = text
        .split_whitespace()
        .filter(|word| *word != "//")
        .collect();
    let words = words.join(" ");
    for warning in &warnings {
        assert!(words.contains(&format!("- {warning}")), "{warning}\n{text}");
    }
}

#[test]
fn loops_of_urdf_are_explained() {
    let text = text_of("four_bar.urdf").replace(
        "<loop_joint name=\"closing\" type=\"spherical\">",
        "<joint name=\"closing\" type=\"fixed\"><parent link=\"rocker\"/><child link=\"coupler\"/></joint><loop_joint name=\"c\" type=\"spherical\">",
    );
    let said = refused(&text, "a.urdf", &Options::default());
    assert!(
        said.starts_with("the link `coupler` is the child of two joints"),
        "{said}"
    );
    assert!(said.contains("<loop_joint name="), "{said}");
}

#[test]
fn inputs_can_be_chosen() {
    let chosen = |name: &str| Options {
        inputs: vec![name.to_owned()],
        ..Options::default()
    };
    let text = imported("four_bar.xml", &chosen("pivot")).text;
    assert!(text.contains("\n    input pivot = 0deg in "), "{text}");
    assert!(text.contains("\n    unknown turn_crank = 0deg;"), "{text}");
    let said = refused(&text_of("four_bar.xml"), "a.xml", &chosen("wrist"));
    assert!(
        said.starts_with("there is no hinge or slide `wrist` to be an input; there is `hip`"),
        "{said}"
    );
    let mut both = chosen("pivot");
    both.inputs.push("hip".to_owned());
    let said = refused(&text_of("four_bar.xml"), "a.xml", &both);
    assert!(said.contains("the mechanism has one freedom"), "{said}");
}

#[test]
fn equations_that_follow_are_left_out() {
    // A parallelogram with a third crank in the middle: one of its equations follows.
    let bar = |name: &str, x: f64| {
        format!(
            "<body name=\"{name}\" pos=\"{x} 0 0\"><joint name=\"{name}\"/><site name=\"{name}\" pos=\"0.05 0.1 0\"/></body>"
        )
    };
    let coupler = "<body name=\"c\" pos=\"0.05 0.1 0\"><joint name=\"j\"/><site name=\"m\" pos=\"0.1 0 0\"/><site name=\"e\" pos=\"0.2 0 0\"/></body>";
    let text = format!(
        "<mujoco><worldbody><body name=\"a\"><joint name=\"a\"/>{coupler}</body>{}{}</worldbody><equality><connect site1=\"e\" site2=\"d\"/><connect name=\"third\" site1=\"m\" site2=\"b\"/></equality></mujoco>",
        bar("b", 0.1),
        bar("d", 0.2)
    );
    let found = linkage_import::import(text.as_bytes(), "a.xml", &Options::default());
    let found = found.expect("a mechanism");
    let warnings = found.warnings.join("\n");
    assert!(
        warnings.contains("1 of the equations of the loop `third` follow from the others"),
        "{warnings}"
    );
    assert!(
        linkage_engine::Mechanism::compile(&found.text).is_ok(),
        "{}",
        found.text
    );
}

#[test]
fn limits_are_held() {
    let deep = "<a>".repeat(100);
    let said = refused(&format!("<mujoco>{deep}"), "a.xml", &Options::default());
    assert!(said.contains("nested too deeply"), "{said}");
    let bomb = "<?xml version=\"1.0\"?><!DOCTYPE r [<!ENTITY a \"b\">]><robot name=\"&a;\"/>";
    let said = refused(bomb, "a.urdf", &Options::default());
    assert!(said.contains("a document type"), "{said}");
    let mut options = hard_points("forward,left,up", "left");
    options.format = Some(Format::HardPoints);
    let said = refused("a: &x [1, 2, 3]\nb: *x\n", "a.yaml", &options);
    assert!(said.contains("which is not read"), "{said}");
    let text = text_of("press.xml").replace("0.04 0.03 0.01", "1e300 0 0");
    let said = refused(&text, "a.xml", &Options::default());
    assert!(said.contains("too large"), "{said}");
}

#[test]
fn names_that_the_file_lacks_are_in_the_message() {
    let renamed = |file: &str, from: &str, to: &str| {
        let text = text_of(file);
        assert!(text.contains(from), "{file}");
        refused(&text.replacen(from, to, 1), file, &Options::default())
    };
    let said = renamed("four_bar.xml", "site1=\"", "site1=\"no_");
    assert!(said.contains("names the site `no_"), "{said}");
    let said = renamed("four_bar.urdf", "<link1 link=\"", "<link1 link=\"no_");
    assert!(said.contains("names the link `no_"), "{said}");
}

#[test]
fn points_may_have_decimal_commas() {
    let table = text_of("five_rods.csv");
    let options = hard_points("forward,left,up", "left");
    let plain = refused(&table, "a.csv", &options);
    let with_commas = table.replacen("110;420;430", "110,5;420,25;430,0", 1);
    assert_ne!(table, with_commas);
    // The first row is no heading.
    assert_eq!(refused(&with_commas, "a.csv", &options), plain);
}

#[test]
fn points_with_two_coordinates_are_named_with_their_line() {
    let options = hard_points("forward,left,up", "left");
    let table = text_of("double_wishbone.csv");
    let short = table.replace("lower_ball,9,560,140", "lower_ball,560,140");
    assert_eq!(
        refused(&short, "a.csv", &options),
        "line 5: the point `lower_ball` has two coordinates instead of three"
    );
    let wrong = table.replace("lower_ball,9,560,140", "lower_ball,,560,140");
    let said = refused(&wrong, "a.csv", &options);
    assert!(
        said.starts_with("line 5: a coordinate of `lower_ball` is ``"),
        "{said}"
    );
}

#[test]
fn tables_of_points_are_recognised_without_their_format() {
    for name in ["double_wishbone.csv", "five_rods.csv"] {
        let said = refused(&text_of(name), name, &Options::default());
        assert!(
            said.contains("\nhelp: its rows are points of a suspension"),
            "{said}"
        );
        assert!(said.contains("`--format hard-points`"), "{said}");
    }
}

/// The pin that closes a loop is a joint between bodies, as their forces need it.
#[test]
fn bodies_of_loops_have_the_closing_pin() {
    for (name, bodies) in [
        ("four_bar.xml", "rocker on coupler"),
        ("four_bar.urdf", "coupler on rocker"),
    ] {
        let text = imported(name, &Options::default()).text;
        let pin = format!("    pin closing = {bodies} at closing_a;\n");
        assert!(text.contains(&pin), "{text}");
        assert!(linkage_engine::Mechanism::compile(&text).is_ok(), "{text}");
    }
}

/// Every attribute of a default, an actuator, an equality or the compiler is read or named.
#[test]
fn settings_that_are_not_read_are_named() {
    let text = text_of("four_bar.xml");
    assert!(text.contains("<worldbody>") && text.contains("</mujoco>"));
    let joint = "<default><default class=\"a\"><joint stiffness=\"2\" axis=\"0 0 1\"/>\
                 <geom rgba=\"1 0 0 1\"/></default></default><worldbody>";
    let actuator = "<actuator><position joint=\"crank\" gear=\"3\"/></actuator></mujoco>";
    let changed = text
        .replacen("<worldbody>", joint, 1)
        .replacen("</mujoco>", actuator, 1);
    let warnings = |text: &str| {
        let imported = linkage_import::import(text.as_bytes(), "a.xml", &Options::default());
        imported.expect("a model").warnings.join("\n")
    };
    let [plain, named] = [warnings(&text), warnings(&changed)];
    for part in [
        "stiffness of default joints",
        "default geom",
        "gear of actuators",
    ] {
        assert!(named.contains(part), "{named}");
        assert!(!plain.contains(part), "{plain}");
    }
    assert!(!named.contains("axis of"), "{named}");
}

#[test]
fn wheels_on_the_middle_are_on_no_side() {
    let table = text_of("double_wishbone.csv");
    let mut centre = table
        .lines()
        .filter(|line| line.starts_with("wheel_centre,"));
    let line = centre.next().expect("the wheel centre");
    let cells: Vec<&str> = line.split(',').collect();
    let on_middle = line.replacen(&format!(",{},", cells[2]), ",0,", 1);
    let table = table.replace(line, &on_middle);
    let said = refused(&table, "a.csv", &hard_points("forward,left,up", "left"));
    assert!(
        said.starts_with(
            "with these axes the wheel centre is on the middle, which is not the left side"
        ),
        "{said}"
    );
}

#[test]
fn tables_without_any_role_are_named() {
    let table = "point,x,y,z\np1,0,420,200\np2,10,430,300\np3,20,440,400\n";
    let said = refused(table, "a.csv", &hard_points("forward,left,up", "left"));
    assert!(
        said.starts_with("no point has a role: p1, p2, p3\nhelp: rename the points"),
        "{said}"
    );
}

/// A joint that is equal to another one, or its opposite, is written without a factor.
#[test]
fn equal_joints_have_no_factor() {
    let lets = |power: &str| {
        let model = format!(
            "<mujoco><worldbody><body><joint name=\"left\" axis=\"0 0 1\" range=\"-30 30\"/><geom size=\"1\"/></body>\
             <body pos=\"1 0 0\"><joint name=\"right\" axis=\"0 0 1\"/><geom size=\"1\"/></body></worldbody>\
             <equality><joint joint1=\"right\" joint2=\"left\" polycoef=\"0 {power} 0 0 0\"/></equality>\
             <actuator><motor joint=\"left\"/></actuator></mujoco>"
        );
        let imported = linkage_import::import(model.as_bytes(), "a.xml", &Options::default());
        let text = imported.expect("a model").text;
        assert!(Mechanism::compile(&text).is_ok(), "{text}");
        text
    };
    assert!(lets("-1").contains("let right = -left;"), "{}", lets("-1"));
    assert!(lets("1").contains("let right = left;"), "{}", lets("1"));
    assert!(
        lets("2").contains("let right = 2rad * (left);"),
        "{}",
        lets("2")
    );
}
