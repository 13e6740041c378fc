//! Imported texts, compiled and moved: their points at 361 positions against the solver. The places
//! of joints are those of MuJoCo, Pinocchio and a calculation by matrices.

mod suspensions;

use linkage_engine::Mechanism;
use linkage_import::Options;

use crate::imported;
use crate::solver::{Condition, Point, Points, cross, dot, minus};

const POSITIONS: usize = 361;
/// Of the size of the mechanism.
const TOLERANCE: f64 = 1e-9;

/// The components of the file that the coordinates of the text are; three for a text of space.
type Axes<'a> = &'a [Point];

/// Compares all points of a text that the facts name, over the range of the text.
fn compare(file: &str, options: &Options, facts: &Points, axes: Axes) {
    let text = imported(file, options).text;
    let mechanism = Mechanism::compile(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert!(mechanism.warnings().is_empty(), "{}", mechanism.warnings());
    let assembly = mechanism.assemble(&mechanism.dimensions());
    let assembly = assembly.unwrap_or_else(|error| panic!("{error}\n{text}"));
    let input = &mechanism.inputs()[0];
    let (low, high) = input.range.expect("a range");
    let size = facts
        .drawn
        .iter()
        .flatten()
        .fold(0.0, |most: f64, x| most.max(x.abs()));
    // From the drawn position to both sides.
    for end in [low, high] {
        let mut at = facts.drawn.clone();
        for number in 0..=POSITIONS / 2 {
            let x = end * number as f64 / (POSITIONS / 2) as f64;
            let error = facts.solve(&mut at, x);
            assert!(error < 1e-12, "{file}: the solver leaves {error} at {x}");
            let results = assembly.results("motion", &[x]);
            for (name, wanted) in facts
                .names
                .iter()
                .zip(&at)
                .filter(|(name, _)| !name.is_empty())
            {
                let found = results.field(name);
                let wanted: Vec<f64> = axes.iter().map(|axis| dot(*axis, *wanted)).collect();
                assert_eq!(found.len(), wanted.len(), "{file}: {name}");
                for (found, wanted) in found.iter().zip(&wanted) {
                    assert!(
                        (found - wanted).abs() < TOLERANCE * size,
                        "{file}: {name} at {x}: {found} for {wanted}\n{text}"
                    );
                }
            }
        }
    }
}

/// A four-bar: its pivots and its joints, with names of the text.
fn four_bar(names: [&str; 4], [a, b, c, d]: [Point; 4], axis: Point) -> Points {
    let mut facts = Points::default();
    let pivot = facts.add(names[0], a, true);
    let knee = facts.add(names[1], b, false);
    let ankle = facts.add(names[2], c, false);
    let other = facts.add(names[3], d, true);
    facts.conditions.push(Condition::Turned {
        point: knee,
        pivot: a,
        axis,
        factor: 1.0,
    });
    // In the plane across the axis: far points on the normal of both pivots keep the others there.
    let far = |from: Point| [0, 1, 2].map(|k| from[k] + 10.0 * axis[k]);
    let on_axis = facts.add("", far(d), true);
    facts.rigid(&[knee, ankle]);
    facts.rigid(&[ankle, other]);
    facts.conditions.push(Condition::Distance(ankle, on_axis));
    let _ = pivot;
    facts
}

const SPACE: [Point; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

#[test]
fn mjcf_with_sites() {
    // Joints are beside each other; the plane has no third coordinate.
    let flat = |p: Point| [p[0], 0.0, p[2]];
    let facts = four_bar(
        ["at_hip", "at_knee", "closing_a", "at_pivot"],
        [
            flat([0.1, 0.3, 0.5]),
            flat([0.19829824531467904, 0.32, 0.5688291723621255]),
            flat([0.5035886487484635, 0.27, 0.6226601074388739]),
            flat([0.46, 0.27, 0.47]),
        ],
        [0.0, 1.0, 0.0],
    );
    compare(
        "four_bar.xml",
        &Options::default(),
        &facts,
        &[SPACE[2], SPACE[0]],
    );
}

#[test]
fn urdf_with_a_loop_joint() {
    let root = std::f64::consts::FRAC_1_SQRT_2;
    let axis = [root, root, 0.0];
    // The normal is upwards; axes across it as the text names them.
    let text = imported("four_bar.urdf", &Options::default()).text;
    let axes = axes_of(&text);
    assert!(dot(cross(axes[0], axes[1]), axis) > 1.0 - 1e-12);
    // The closing is 10 mm beside the pivots.
    let flat = |p: Point| {
        let off = dot(minus(p, [0.2, 0.0, 0.1]), axis);
        [0, 1, 2].map(|k| p[k] - off * axis[k])
    };
    let facts = four_bar(
        ["at_motor_2", "at_elbow", "closing_a", "at_swing"],
        [
            [0.2, 0.0, 0.1],
            flat([0.1929289321881345, 0.02121320343559645, 0.0]),
            flat([
                0.23472180060971112,
                -0.020579664985980173,
                -0.1910672978251213,
            ]),
            flat([0.1646446609406726, 0.0353553390593274, -0.15]),
        ],
        axis,
    );
    let mut facts = facts;
    rename(&mut facts, &text);
    // Distances across are left out, those along the axis too.
    let origin = [0.2, 0.0, 0.1];
    let off: Vec<f64> = axes.iter().map(|axis| dot(*axis, origin)).collect();
    assert!(off.iter().all(|number| number.is_finite()));
    compare("four_bar.urdf", &Options::default(), &facts, &axes);
}

/// The joint of a name in the text: `motor` is a word of the language in some versions.
fn rename(facts: &mut Points, text: &str) {
    for name in &mut facts.names {
        let plain = name.trim_end_matches("_2").to_owned();
        let is_plain = text.contains(&format!("let {plain} ="));
        if is_plain {
            *name = plain;
        }
    }
}

/// The axes of the plane, from the comment of the text.
fn axes_of(text: &str) -> Vec<Point> {
    // Comments are wrapped.
    let text = text.replace("\n//", "");
    let (_, words) = text
        .split_once("All hinges are parallel: ")
        .expect("a comment of the plane");
    let lists = words.split('(').skip(1).take(2);
    lists
        .map(|list| {
            let numbers = list.split(')').next().unwrap_or_default();
            let numbers: Vec<f64> = numbers
                .split(',')
                .map(|number| number.trim().parse().expect("a number"))
                .collect();
            [numbers[0], numbers[1], numbers[2]]
        })
        .collect()
}

#[test]
fn sdf_with_a_loop() {
    let text = imported("four_bar.sdf", &Options::default()).text;
    let flat = |p: Point| [p[0], p[1], 0.0];
    let mut facts = four_bar(
        ["at_motor_2", "at_elbow", "last_a", "at_bearing"],
        [
            [0.1, 0.2, 0.0],
            [0.1683770965097731, 0.28616596005902317, 0.0],
            flat([0.4382025990867247, 0.4366577056626858, 0.1]),
            flat([0.4, 0.22, 0.1]),
        ],
        [0.0, 0.0, 1.0],
    );
    rename(&mut facts, &text);
    compare(
        "four_bar.sdf",
        &Options::default(),
        &facts,
        &[SPACE[0], SPACE[1]],
    );
}

#[test]
fn mjcf_with_slides_and_a_polynomial() {
    let mut facts = Points::default();
    let pivot = facts.add("at_shaft", [0.0; 3], true);
    let pin = facts.add("at_pin", [0.04, 0.03, 0.0], false);
    let ram = facts.add("at_guide", [0.2, -0.01, 0.0], false);
    let _ = pivot;
    // The axis of the shaft points down.
    facts.conditions.push(Condition::Turned {
        point: pin,
        pivot: [0.0; 3],
        axis: [0.0, 0.0, -1.0],
        factor: 1.0,
    });
    facts.rigid(&[pin, ram]);
    facts.conditions.push(Condition::Coordinate(ram, 1, 0.0));
    facts.conditions.push(Condition::Coordinate(ram, 2, 0.0));
    let text = imported("press.xml", &Options::default()).text;
    let name = if text.contains("at_guide_2") {
        "at_guide_2"
    } else {
        "at_guide"
    };
    facts.names[2] = name.to_owned();
    compare(
        "press.xml",
        &Options::default(),
        &facts,
        &[SPACE[0], SPACE[1]],
    );
    // The follower goes by the polynomial of the file.
    let mechanism = Mechanism::compile(&text).expect("a mechanism");
    let assembly = mechanism
        .assemble(&mechanism.dimensions())
        .expect("it closes");
    for x in [-1.3, 0.0, 0.4, 2.9] {
        let [_, y] = assembly.results("motion", &[x]).vector("at_valve");
        let wanted = 0.2 + 0.01 * x + 0.002 * x * x - 0.0003 * x * x * x * x;
        assert!((y - wanted).abs() < 1e-15, "{x}: {y}");
    }
}

#[test]
fn mjcf_with_balls() {
    let mut facts = Points::default();
    let ball = facts.add("at_ball", [0.0, 0.03, 0.0], false);
    let end = facts.add("connect_1_end", [0.09, 0.09, -0.07], false);
    let pivot = [0.11, 0.03, -0.05];
    let on_axis = facts.add("", [0.11, 0.33, 0.85], true);
    let foot = facts.add("at_driven", pivot, true);
    facts.conditions.push(Condition::Turned {
        point: ball,
        pivot: [0.0; 3],
        axis: [1.0, 0.0, 0.0],
        factor: 1.0,
    });
    facts.rigid(&[ball, end]);
    facts.rigid(&[end, on_axis]);
    facts.rigid(&[end, foot]);
    compare("crossed.xml", &Options::default(), &facts, &SPACE);
}

#[test]
fn urdf_with_mimic() {
    let text = imported("gripper.urdf", &Options::default()).text;
    let mechanism = Mechanism::compile(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let assembly = mechanism
        .assemble(&mechanism.dimensions())
        .expect("it closes");
    for x in [0.0_f64, 0.3, 0.8] {
        let results = assembly.results("motion", &[x]);
        // The plane is y and z.
        let (sine, cosine) = x.sin_cos();
        let [y, z] = results.vector("at_left_tip");
        assert!((y - (0.03 + 0.02 * cosine - 0.08 * sine)).abs() < 1e-15);
        assert!((z - (0.05 + 0.02 * sine + 0.08 * cosine)).abs() < 1e-15);
        assert!((results["turn_right"] + x).abs() < 1e-15);
        // About the opposite axis.
        assert!((results["turn_pad"] - (x - (1.5 * x + 0.1))).abs() < 1e-15);
    }
}

/// A flag that follows the rocker, which is no input, and a gripper whose ranges fit together.
#[test]
fn joints_follow_passive_ones() {
    let text = String::from_utf8(crate::file("four_bar.xml")).expect("text");
    let flag = "<body name=\"flag\" pos=\"0 0 1\"><joint name=\"wave\" axis=\"0 1 0\"/></body></worldbody>";
    let text = text.replace("</worldbody>", flag).replace(
        "</equality>",
        "<joint joint1=\"wave\" joint2=\"pivot\" polycoef=\"0 2 0 0 0\"/></equality>",
    );
    let found = linkage_import::import(text.as_bytes(), "a.xml", &Options::default());
    let text = found.expect("a mechanism").text;
    let mechanism = Mechanism::compile(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let assembly = mechanism
        .assemble(&mechanism.dimensions())
        .expect("it closes");
    for x in [-0.4, 0.2, 0.9] {
        let results = assembly.results("motion", &[x]);
        let (flag, rocker) = (results["turn_flag"], results["turn_rocker"]);
        assert!(rocker.abs() > 0.01 && (flag - 2.0 * rocker).abs() < 1e-14);
    }
}

/// Two cranks on the frame and two links between them: the box of both ranges is shortened.
#[test]
fn ranges_of_several_inputs_fit_together() {
    let arm = |name: &str, x: f64, lean: f64, inner: &str| {
        format!(
            "<body name=\"{name}\" pos=\"{x} 0 0\"><joint name=\"{name}\" axis=\"0 0 1\"/><body name=\"{name}_rod\" pos=\"{lean} 0.1 0\"><joint name=\"{name}_knee\" axis=\"0 0 1\"/>{inner}</body></body>"
        )
    };
    let left = arm("left", 0.0, -0.05, "<site name=\"l\" pos=\"0.1 0.1 0\"/>");
    let right = arm("right", 0.1, 0.05, "<site name=\"r\" pos=\"-0.1 0.1 0\"/>");
    let text = format!(
        "<mujoco><worldbody>{left}{right}</worldbody><equality><connect site1=\"l\" site2=\"r\"/></equality><actuator><motor joint=\"left\"/><motor joint=\"right\"/></actuator></mujoco>"
    );
    let found = linkage_import::import(text.as_bytes(), "a.xml", &Options::default());
    let found = found.expect("a mechanism");
    let mechanism = Mechanism::compile(&found.text);
    let mechanism = mechanism.unwrap_or_else(|error| panic!("{error}\n{}", found.text));
    let names: Vec<&str> = mechanism.inputs().iter().map(|input| input.name).collect();
    assert_eq!(names, ["left", "right"]);
    assert!(
        found
            .warnings
            .iter()
            .any(|warning| warning.contains("are shortened"))
    );
    let assembly = mechanism
        .assemble(&mechanism.dimensions())
        .expect("it closes");
    for corner in 0..4 {
        let end = |k: usize| {
            let (low, high) = mechanism.inputs()[k].range.expect("a range");
            [low, high][corner >> k & 1]
        };
        let results = assembly.results("motion", &[end(0), end(1)]);
        assert!(results.numbers().iter().all(|number| number.is_finite()));
    }
}
