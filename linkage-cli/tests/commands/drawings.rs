//! Drawings of mechanisms that were compiled.

use std::fs;

use crate::{folder, printed};

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
