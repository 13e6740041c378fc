//! Drawings of mechanisms that were compiled.

use std::fs;
use std::path::Path;

use crate::{folder, linkage, printed};

const GEARS: &str = "
    struct Gears {
        unit mm;
        param base = 90mm;
        param crank = 20mm;
        param follower = 15mm;
        input phi = 40deg in 0deg..360deg;
        unknown psi = -80deg;
        loop psi = RATIO * phi;
        let a = polar(crank, phi);
        let b = (base, 0) + polar(follower, psi);
    }
    impl Gears { fn look(phi) -> Look { shape: picture() } }";

fn drawing(name: &str, text: &str) -> String {
    let folder = folder(name);
    fs::write(folder.join("it.mech"), text).expect("it can be written");
    printed(&folder, &["page", "it.mech", "-o", "it"]);
    fs::read_to_string(folder.join("it/drawing.svg")).expect("a drawing")
}

fn radii(svg: &str) -> Vec<f64> {
    let wheels = svg.lines().filter(|line| line.contains("class=\"wheel"));
    let radius = |line: &str| {
        let (_, behind) = line.split_once(" r=\"").expect("a radius");
        let (number, _) = behind.split_once('"').expect("a number");
        number.parse::<f64>().expect("a number")
    };
    wheels.map(radius).collect()
}

#[test]
fn gears_roll_on_each_other() {
    let svg = drawing("gear_wheels", &GEARS.replace("RATIO", "-2"));
    let [first, second] = radii(&svg)[..] else {
        panic!("two wheels: {svg}")
    };
    assert!((first - 2.0 * second).abs() < 1e-3, "{first} {second}");
    assert!(svg.contains(">1 : -2<") && !svg.contains("class=\"belt"));
}

#[test]
fn wheels_that_turn_alike_have_a_belt() {
    let svg = drawing(
        "belt_wheels",
        &GEARS.replace("RATIO", "3").replace("-80deg", "120deg"),
    );
    let [first, second] = radii(&svg)[..] else {
        panic!("two wheels: {svg}")
    };
    assert!((first - 3.0 * second).abs() < 1e-3, "{first} {second}");
    assert!(svg.contains(">1 : 3<"));
    assert_eq!(svg.matches("class=\"belt").count(), 2);
}

#[test]
fn what_nothing_carries_is_told() {
    let text = "
    struct Crank {
        unit mm;
        param crank = 20mm;
        input phi = 40deg in 0deg..360deg;
        let a = polar(crank, phi);
        let ghost = (a.x * sin(phi), a.y * cos(phi));
    }
    impl Crank { fn look(phi) -> Look { shape: picture() } }";
    let folder = folder("loose");
    fs::write(folder.join("it.mech"), text).expect("it can be written");
    let output = linkage(&folder, &["page", "it.mech", "-o", "it"]);
    let said = String::from_utf8_lossy(&output.stderr);
    let warning = "warning: `ghost` moves, but no link of the picture carries it";
    assert!(output.status.success() && said.contains(warning), "{said}");
    let told = "No link of the picture carries ghost.";
    let svg = fs::read_to_string(folder.join("it/drawing.svg")).expect("a drawing");
    assert!(svg.contains(told), "{svg}");
    let data = fs::read_to_string(folder.join("it/data.json")).expect("data");
    let data: serde_json::Value = serde_json::from_str(&data).expect("JSON");
    assert_eq!(data["notes"], serde_json::json!([told]));
    assert_eq!(data["picture"]["points"][2]["kind"], "loose");
}

/// Two components of a vector of space are no place in it.
#[test]
fn loops_that_are_not_drawn_are_told() {
    let text = "
    struct Press {
        unit mm;
        param arm = 60mm;
        param pivot = (100mm, 30mm, 80mm);
        param push = 90mm;
        input psi = 100deg in 80deg..120deg;
        unknown y = 160mm;
        unknown alpha = 120deg;
        let ball = pivot + turn((0, arm, 0), (1, 0, 0), psi);
        unknown z = 150mm;
        loop distance(ball, (20mm, 30mm, z)) = push + 20mm;
        loop (ball.y, ball.z) + polar(push, alpha) = (0, y) + (20mm, 0);
    }
    impl Press { fn look(psi) -> Look { shape: picture(LISTS) } }";
    let folder = folder("undrawn");
    let told = "Loop 2 is not drawn: it is not known where in space it lies.";
    // Who lists the links tells what the loop does not.
    for (lists, is_told) in [("", true), ("[pivot, ball]", false)] {
        fs::write(folder.join("it.mech"), text.replace("LISTS", lists)).expect("it can be written");
        let output = linkage(&folder, &["page", "it.mech", "-o", "it"]);
        let said = String::from_utf8_lossy(&output.stderr);
        let warning = "warning: loop 2 is not drawn: components of vectors do not tell where in space it lies";
        assert!(output.status.success(), "{said}");
        assert_eq!(said.contains(warning), is_told, "{said}");
        let svg = fs::read_to_string(folder.join("it/drawing.svg")).expect("a drawing");
        assert_eq!(svg.contains(told), is_told, "{svg}");
        let data = fs::read_to_string(folder.join("it/data.json")).expect("data");
        let data: serde_json::Value = serde_json::from_str(&data).expect("JSON");
        let notes = data["notes"].as_array().expect("notes");
        assert_eq!(notes.iter().any(|note| note == told), is_told, "{notes:?}");
    }
}

#[test]
fn what_an_input_pushes_is_a_cylinder() {
    let text = "
    struct Jack {
        unit mm;
        param arm = 500mm;
        param foot = (100mm, -300mm);
        input length = 450mm in 430mm..600mm;
        unknown psi = 0deg;
        loop distance(polar(arm, psi), foot) = length;
    }
    impl Jack { fn look(length) -> Look { shape: picture() } }";
    let svg = drawing("jack", text);
    let data = Path::new(env!("CARGO_TARGET_TMPDIR")).join("jack/it/data.json");
    let data = fs::read_to_string(data).expect("data");
    let data: serde_json::Value = serde_json::from_str(&data).expect("JSON");
    assert_eq!(data["picture"]["guides"][0]["shape"], "cylinder");
    assert_eq!(svg.matches("class=\"barrel").count(), 1);
    assert_eq!(svg.matches("class=\"drive\"").count(), 1);
    assert!(!svg.contains("class=\"slider"));
    // The slider is on the side that the guide points to, so that lengths are positive.
    let vector = |list: &serde_json::Value, index: usize| {
        [0, 1].map(|axis| {
            let place = &list[index]["at"][axis];
            let [table, column] = ["table", "column"].map(|end| place[end].as_u64());
            let column = &data["tables"][table.expect("a table") as usize]["columns"]
                [column.expect("a column") as usize];
            column["values"][0].as_f64().expect("a number")
        })
    };
    let picture = &data["picture"];
    let guide = &picture["guides"][0];
    let place = |name: &str| guide[name].as_u64().expect("an index") as usize;
    let (foot, eye) = (
        vector(&picture["points"], place("origin")),
        vector(&picture["points"], place("slider")),
    );
    let way = vector(&picture["directions"], place("direction"));
    let length: f64 = (0..2).map(|k| (eye[k] - foot[k]) * way[k]).sum();
    assert!((length - 430.0).abs() < 1e-9, "{length}");
}
