//! What is said of assemblies that are found from estimates alone.

use std::fs;

use crate::{folder, linkage, printed, refused};

/// A wheel carrier on five rods: more unknowns than a listing takes.
const AXLE: &str = "
mechanism! {
    pub struct Axle {
        unit mm;
        input travel = 0mm in -10mm..10mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        loop distance(point_in(carrier, (15mm, -70mm, 135mm)), (110mm, 420mm, 430mm)) = 287.3mm;
        loop distance(point_in(carrier, (-30mm, -75mm, 140mm)), (-85mm, 435mm, 440mm)) = 256.8mm;
        loop distance(point_in(carrier, (40mm, -60mm, -105mm)), (265mm, 480mm, 265mm)) = 318.6mm;
        loop distance(point_in(carrier, (-25mm, -55mm, -120mm)), (-60mm, 255mm, 215mm)) = 451.6mm;
        loop distance(point_in(carrier, (-150mm, -70mm, -58mm)), (-190mm, 316mm, 258mm)) = 376.2mm;
        loop carrier.origin.z = 320mm + travel;
    }
    impl Axle {
        pub fn wheel(travel) -> Wheel { carrier }
    }
}
";

#[test]
fn what_was_found_from_estimates_is_said_to_be() {
    let folder = folder("assemblies");
    fs::write(folder.join("axle.mech"), AXLE).expect("it is written");
    let all = printed(&folder, &["assemblies", "axle.mech", "--at", "travel=5mm"]);
    assert!(
        all.starts_with("Axle at travel = 5 mm: 1 assembly\n1  carrier.origin = "),
        "{all}"
    );
    let said = "group 2 is followed from the estimates: only that assembly is found, others of the same loops are not listed\n";
    assert!(all.ends_with(said), "{all}");
    let known = printed(&folder, &["check", "axle.mech"]);
    assert!(
        known.contains(&format!("assemblies at the reference: 1 found; {said}")),
        "{known}"
    );
    // Five rods and a height are six distances.
    let many = "followed from the estimates; up to 40 complex solutions (a body on six distances) not listed; ";
    assert!(known.contains(many), "{known}");
}

/// A crank that cannot turn all the way, a plate on two cylinders, and the same plate on one, whose
/// strokes are too long.
const REFUSED: &str = "
mechanism! {
    pub struct Rocking {
        unit mm;
        input phi = 50deg in 0deg..360deg;
        unknown theta = 10deg;
        unknown psi = 60deg;
        loop polar(90mm, phi) + polar(30mm, theta) = (100mm, 0) + polar(90mm, psi);
    }
    impl Rocking { pub fn f(phi) -> F { psi } }
    pub struct Plate {
        unit mm;
        input left = 260mm in 200mm..320mm;
        input right = 250mm in 200mm..300mm;
        unknown p = (20mm, 260mm);
        unknown t = 5deg;
        let q = p + polar(250mm, t);
        let r = p + polar(430mm, t - 12deg);
        loop distance(p, (0mm, 0mm)) = left;
        loop distance(q, (300mm, -20mm)) = right;
        loop distance(r, (520mm, 60mm)) = 150mm;
    }
    impl Plate { pub fn f(left, right) -> F { p } }
    pub struct Triad {
        unit mm;
        input stroke = 260mm in 20mm..600mm;
        unknown p = (20mm, 260mm);
        unknown t = 5deg;
        loop distance(p, (0mm, 0mm)) = stroke;
        loop distance(p + polar(250mm, t), (300mm, -20mm)) = 250mm;
        loop distance(p + polar(430mm, t - 12deg), (520mm, 60mm)) = 150mm;
    }
    impl Triad { pub fn f(stroke) -> F { p } }
}
";

#[test]
fn assemblies_are_listed_where_the_range_is_refused() {
    let folder = folder("refused_ranges");
    fs::write(folder.join("refused.mech"), REFUSED).expect("it is written");
    let said = refused(&folder, &["check", "refused.mech"], 1);
    assert_eq!(
        said.matches("error: the mechanism comes apart").count(),
        3,
        "{said}"
    );
    let answered = |command: &str| {
        let output = linkage(&folder, &[command, "refused.mech"]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{said}");
        let count = said.matches("warning: the mechanism comes apart").count();
        assert_eq!(count, 3, "{said}");
        String::from_utf8(output.stdout).expect("text")
    };
    let all = answered("assemblies");
    for start in [
        "Rocking at phi = 50 deg: 2 assemblies\n",
        "Plate at left = 260 mm, right = 250 mm: ",
        "Triad at stroke = 260 mm: ",
    ] {
        assert!(all.contains(start), "{all}");
    }
    let circuits = answered("circuits");
    assert!(
        circuits.contains("Rocking\n") && circuits.contains("Triad\n"),
        "{circuits}"
    );
    // The range is the declared one: the crank leaves and enters twice.
    assert!(circuits.lines().count() > 8, "{circuits}");
}

/// A scissor lift of two stages, drawn with rounding errors. Its first stage can fold, and then the
/// links of the second one lie on each other.
const LIFT: &str = "
pub struct Lift {
    unit mm;
    input phi = 30deg in 10deg..70deg;
    joint a = (0mm, 0mm), o = (900mm, 0mm), k = (900mm, 600mm);
    joint b = (519.615242270663mm, 0mm), c = (259.807621135332mm, 150mm);
    joint d = (0mm, 300mm), e = (519.615242270663mm, 300mm), f = (259.807621135332mm, 450mm);
    joint g = (0mm, 600mm), h = (519.615242270663mm, 600mm);
    link frame: a, o;
    link one: a, c, e at phi;
    link two: b, c, d;
    link three: d, f, h;
    link four: e, f, g;
    link top: g, k;
    slider x: b on frame along a, o;
    slider y: h on top along g, k;
}
";

#[test]
fn folded_links_are_one_line() {
    let folder = folder("folded");
    fs::write(folder.join("lift.linkage"), LIFT).expect("it is written");
    let circuits = printed(&folder, &["circuits", "lift.linkage"]);
    let lines: Vec<&str> = circuits.lines().collect();
    assert_eq!(lines.len(), 7, "{circuits}");
    let start = "undetermined from 10 deg to 70 deg, where two.angle = 30deg and x = ";
    let joint =
        "mm at phi = 30 deg: joint `f` of `four` (three.angle, four.angle; RRR), whose links";
    assert!(
        lines[6].starts_with(start) && lines[6].contains(joint),
        "{circuits}"
    );
}

/// A coupled group whose reference is a thousandth of a degree beyond a turning point.
const NEAR_TURNING_POINT: &str = "
pub struct Near {
    unit cm;
    input phi = 157.955201480233deg in 157.9552deg..247.9deg;
    joint j1 = (-2.87544cm, 0.032816cm);
    joint j2 = (-3.960199cm, 0.472074cm);
    joint j3 = (-8.346306cm, 3.068138cm);
    joint j4 = (2.675824cm, 1.869398cm);
    joint j5 = (3.903228cm, 5.228105cm);
    joint j6 = (4.085514cm, -5.223341cm);
    link frame: j1, j6;
    link link1: j1, j2 at phi;
    link link2: j2, j3;
    link link3: j3, j4, j5;
    link link4: j4, j6;
    slider slot_j5: j5 on frame along -0.16093891721521011deg;
}
impl Near { pub fn points(phi) -> Points { j2, j3 } }
";

#[test]
fn ranges_over_a_turning_point_next_to_the_reference_are_refused_only() {
    let folder = folder("near_turning_point");
    let file = folder.join("near.linkage");
    let ranges = ["0deg..360deg", "120deg..247.9deg", "157.9deg..247.9deg"];
    for range in ranges {
        let with = |range: &str| {
            NEAR_TURNING_POINT.replace("in 157.9552deg..247.9deg", &format!("in {range}"))
        };
        fs::write(&file, with(range)).expect("it is written");
        let answered = |command: &str| {
            let output = linkage(&folder, &[command, "near.linkage"]);
            assert!(output.status.success(), "{range}: {command}");
            String::from_utf8(output.stdout).expect("text")
        };
        let all = answered("assemblies");
        assert!(all.contains(": 4 assemblies\n"), "{range}\n{all}");
        let circuits = answered("circuits");
        assert!(circuits.contains("(turning point)"), "{range}\n{circuits}");
        let said = refused(&folder, &["check", "near.linkage"], 1);
        assert!(said.contains("turning point at `phi"), "{range}\n{said}");
        // The range of the refusal can be pasted.
        let (_, named) = said.split_once("help: write `in ").expect("a help");
        let (narrower, _) = named.split_once('`').expect("a range");
        fs::write(&file, with(narrower)).expect("it is written");
        printed(&folder, &["check", "near.linkage"]);
    }
}

const SUSPENSION: &str =
    include_str!("../../../linkage-import/tests/robots/files/double_wishbone.csv");

#[test]
fn a_picture_without_links_stops_no_list_of_assemblies() {
    let folder = folder("range_of_a_picture");
    fs::write(folder.join("points.csv"), SUSPENSION).expect("it is written");
    let import = ["import", "--format", "hard-points", "--length", "mm"];
    let points = ["--axes", "rear,left,up", "--side", "left", "points.csv"];
    let imported = linkage(&folder, &[&import[..], &points].concat());
    let text = String::from_utf8(imported.stdout).expect("text");
    let wide = text.replace("in -49mm..41mm;", "in -300mm..300mm;");
    assert!(wide.contains("picture()") && wide != text, "{text}");
    fs::write(folder.join("wide.linkage"), wide).expect("it is written");
    let output = linkage(&folder, &["assemblies", "wide.linkage"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(said.contains("a turning point at `travel = "), "{said}");
    // The refusal of the range is the reason for this, too.
    assert!(!said.contains("links cannot be told"), "{said}");
}

/// The box of a refusal can be pasted.
#[test]
fn the_box_that_a_refusal_names_is_accepted() {
    let folder = folder("largest_box");
    let start = REFUSED.find("pub struct Plate").expect("a plate");
    let end = REFUSED.find("pub struct Triad").expect("a triad");
    let plate = &REFUSED[start..end];
    fs::write(folder.join("plate.mech"), plate).expect("it is written");
    let said = refused(&folder, &["check", "plate.mech"], 1);
    let (_, named) = said.split_once("help: write ").expect("a help");
    let boxed: Vec<&str> = named.split('`').skip(1).step_by(2).take(4).collect();
    let [left, of_left, right, of_right] = boxed[..] else {
        panic!("{said}");
    };
    assert_eq!([of_left, of_right], ["left", "right"]);
    let narrower = plate
        .replace("in 200mm..320mm", left)
        .replace("in 200mm..300mm", right);
    fs::write(folder.join("narrower.mech"), narrower).expect("it is written");
    let known = printed(&folder, &["check", "narrower.mech"]);
    assert!(known.contains("Plate: mobility 2"), "{known}");
}
