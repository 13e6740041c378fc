//! `linkage mjcf` and `linkage urdf`: anchors that meet, errors that hold, refusals with numbers.

use std::fs;
use std::path::Path;

use crate::{folder, linkage, printed, refused};

const FOUR_BAR: &str = "
pub struct FourBar {
    unit mm;
    param crank = 40mm;
    param coupler = 120mm;
    param rocker = 80mm;
    param frame = 130mm;
    input phi = 60deg in 20deg..100deg;
    unknown theta = 20deg;
    unknown psi = 80deg;
    let a = polar(crank, phi);
    let b = a + polar(coupler, theta);
    let d = (frame, 0);
    loop b = d + polar(rocker, psi);
    gravity = (0, -9.80665m/s^2);
    body arm = pin on frame at (0, 0), turns phi, mass 0.1kg at a / 2, inertia 40kg*mm^2;
    body bar = pin on arm at a, turns theta, mass 0.2kg at (a + b) / 2, inertia 240kg*mm^2;
    body lever = pin p on frame at d, turns psi, mass 0.2kg at (b + d) / 2, inertia 500kg*mm^2 at d;
    pin joint = bar on lever at b;
}
";

/// A crank whose pin slides in a slotted lever.
const SLOT: &str = "
pub struct Slot {
    unit mm;
    param crank = 20mm;
    input phi = 60deg in 0deg..360deg;
    unknown psi = 80deg;
    unknown slide = 70mm;
    let a = polar(crank, phi);
    let f = (0mm, -50mm);
    loop f + polar(slide, psi) = a;
    body wheel = pin on frame at (0, 0), turns phi, mass 0.1kg at a / 2, inertia 40kg*mm^2;
    body lever = pin l on frame at f, turns psi, mass 0.2kg at f + polar(40mm, psi), inertia 140kg*mm^2;
    roller r = wheel on lever at a along dir(psi);
}
";

/// Crank and rocker with crossed axes, and a rod between balls.
const SPACE: &str = "
pub struct Rssr {
    unit mm;
    param rocker = 70mm;
    param pivot = (110mm, 30mm, -50mm);
    input phi = 0deg in 0deg..360deg;
    unknown psi = 100deg;
    let pin = turn((0mm, 30mm, 0mm), (1, 0, 0), phi);
    let axis = turn((0, 0, 1), (1, 0, 0), -20deg);
    let end = pivot + turn((rocker, 0, 0), axis, psi);
    loop distance(pin, end) = 130mm;
    body wheel = pin w on frame at (0, 0, 0) about (1, 0, 0), turns phi, mass 0.1kg at pin / 2, inertia 40kg*mm^2;
    body rod = ball left on wheel at pin, turns end - pin, mass 0.2kg at (pin + end) / 2, inertia 200kg*mm^2;
    body lever = pin p on frame at pivot about axis, turns psi, mass 0.1kg at (pivot + end) / 2, inertia 40kg*mm^2;
    ball right = rod on lever at end;
}
";

/// The four-bar by its joints and links, without masses.
const LINKS: &str = "
pub struct FourBar {
    unit mm;
    input phi = 60deg in 20deg..100deg;
    joint a = (0mm, 0mm), d = (130mm, 0mm), b = (20mm, 34.641mm), c = (131.1mm, 79.99mm);
    link frame: a, d;
    link crank: a, b at phi length 40mm;
    link coupler: b, c length 120mm;
    link rocker: c, d length 80mm;
}
";

/// A folder with a mechanism in it.
fn with(name: &str, text: &str) -> std::path::PathBuf {
    let folder = folder(name);
    fs::write(folder.join("own.mech"), text).expect("a file");
    folder
}

/// The text of an attribute of the first element that contains a text.
fn attribute<'t>(text: &'t str, element: &str, name: &str) -> &'t str {
    let line = text.lines().find(|line| line.contains(element));
    let line = line.unwrap_or_else(|| panic!("no `{element}` in {text}"));
    let (_, rest) = line
        .split_once(&format!(" {name}=\""))
        .unwrap_or_else(|| panic!("no {name}: {line}"));
    rest.split('"').next().unwrap_or_default()
}

fn numbers(text: &str) -> Vec<f64> {
    let words = text.split_whitespace();
    words.map(|word| word.parse().expect("a number")).collect()
}

/// The sum of the positions of nested elements.
fn place(text: &str, elements: &[&str]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for element in elements {
        for (sum, next) in sum.iter_mut().zip(numbers(attribute(text, element, "pos"))) {
            *sum += next;
        }
    }
    sum
}

fn is_near(a: &[f64], b: &[f64], limit: f64) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= limit)
}

/// Directions of coupler and rocker, from the law of cosines.
fn directions(phi: f64) -> [f64; 2] {
    let (x, y) = (0.04 * phi.cos(), 0.04 * phi.sin());
    let distance = (0.13 - x).hypot(y);
    let along = (distance.powi(2) + 0.12_f64.powi(2) - 0.08_f64.powi(2)) / (2.0 * distance);
    let theta = (-y).atan2(0.13 - x) + (along / 0.12).acos();
    let (x, y) = (x + 0.12 * theta.cos(), y + 0.12 * theta.sin());
    [theta, y.atan2(x - 0.13)]
}

#[test]
fn anchors_meet_at_the_reference() {
    let folder = with("mjcf_loops", FOUR_BAR);
    let text = printed(&folder, &["mjcf", "own.mech"]);
    let [a, b] = [
        place(
            &text,
            &["body name=\"arm\"", "body name=\"bar\"", "\"joint_a0\""],
        ),
        place(&text, &["body name=\"lever\"", "\"joint_b0\""]),
    ];
    assert!(is_near(&a, &b, 1e-16), "{a:?} {b:?}");
    assert!(text.contains("<connect site1=\"joint_a0\" site2=\"joint_b0\"/>"));
    assert_eq!(attribute(&text, "<option", "gravity"), "0 -9.80665 0");
    let zero = numbers(attribute(&text, "\"arm_joint\"", "ref"));
    assert_eq!(zero, [std::f64::consts::FRAC_PI_3]);
    let limits = numbers(attribute(&text, "\"arm_joint\"", "range"));
    assert!(is_near(
        &limits,
        &[20_f64.to_radians(), 100_f64.to_radians()],
        1e-15
    ));
    // Given about the bearing, which is 40 mm from the centre.
    let (_, lever) = text.split_once("body name=\"lever\"").expect("the lever");
    let inertia = numbers(attribute(lever, "<inertial", "fullinertia"));
    assert!((inertia[2] - (500.0 - 0.2 * 1600.0) * 1e-6).abs() < 1e-18);
}

#[test]
fn errors_of_polynomials_hold() {
    let folder = with("mjcf_error", FOUR_BAR);
    let text = printed(&folder, &["mjcf", "own.mech", "--error", "2e-4rad"]);
    let start = 60_f64.to_radians();
    for (number, joint) in ["bar_joint", "p"].iter().enumerate() {
        let powers = numbers(attribute(&text, &format!("joint1=\"{joint}\""), "polycoef"));
        assert_eq!(powers.len(), 5);
        let (_, remark) = text
            .split_once(&format!("<!-- {joint}: degree "))
            .expect("its remark");
        let (_, remark) = remark.split_once("at most ").expect("its error");
        let stated: f64 = remark
            .split(' ')
            .next()
            .map_or(0.0, |word| word.parse().expect("a number"));
        let mut most: f64 = 0.0;
        for k in 0..=100_000 {
            let phi = (20.0 + 80.0 * f64::from(k) / 1e5_f64).to_radians();
            let x = phi - start;
            let found = powers.iter().rev().fold(0.0, |sum, power| sum * x + power);
            let parent = if number == 0 { x } else { 0.0 };
            let wanted = directions(phi)[number] - directions(start)[number] - parent;
            most = most.max((found - wanted).abs());
        }
        // Three decimals are printed.
        assert!(
            most <= stated * 1.001 && most > 0.995 * stated,
            "{joint}: {most} of {stated}"
        );
        assert!(stated <= 2e-4);
    }
}

#[test]
fn a_refusal_has_the_range_that_works() {
    let folder = with("urdf_refused", FOUR_BAR);
    let said = refused(&folder, &["urdf", "own.mech", "--error", "1e-3rad"], 1);
    assert!(said.starts_with("error: `mimic` of URDF is linear: the joints cannot follow\n  `bar_joint`: error 3.078e-2 rad; kept from "), "{said}");
    let (_, rest) = said.split_once("--range ").expect("a range");
    let range = rest.split('`').next().expect("its end");
    let text = printed(
        &folder,
        &["urdf", "own.mech", "--error", "1e-3rad", "--range", range],
    );
    let slope: f64 = attribute(&text, "<mimic", "multiplier")
        .parse()
        .expect("a number");
    let [before, after] =
        [-1e-6, 1e-6].map(|step| directions(60_f64.to_radians() + step)[0] - step);
    assert!((slope - (after - before) / 2e-6).abs() < 0.02, "{slope}");
    // A wider one does not.
    refused(
        &folder,
        &[
            "urdf",
            "own.mech",
            "--error",
            "1e-3rad",
            "--range",
            "40deg..80deg",
        ],
        1,
    );
}

#[test]
fn a_pin_in_a_slot_gets_a_block() {
    let folder = with("mjcf_slot", SLOT);
    let text = printed(&folder, &["mjcf", "own.mech"]);
    let [a, b] = [
        place(&text, &["body name=\"wheel\"", "\"r_a0\""]),
        place(&text, &["body name=\"lever\"", "body name=\"r_block\""]),
    ];
    assert!(is_near(&a, &b, 1e-16), "{a:?} {b:?}");
    let axis = numbers(attribute(&text, "\"r_slide\"", "axis"));
    let psi = (50.0 + 20.0 * 60_f64.to_radians().sin()).atan2(10.0);
    assert!(is_near(&axis, &[psi.cos(), psi.sin(), 0.0], 1e-14));
    // No limits for full turns.
    assert!(!text.contains("range="));
}

/// A plate with two slots on pins of the frame.
const PLATE: &str = "
pub struct Plate {
    unit mm;
    input phi = 30deg in 5deg..80deg;
    joint p = (0mm, 0mm), q = (60mm, 0mm), m = (45mm, 25.980762113533mm);
    joint e = (88.301270189222mm, 50.980762113533mm), f = (25mm, 60.621778264911mm);
    link frame: p, q;
    link plate: m, e, f at phi mass 1kg at f;
    slider u: p on plate along m, e;
    slider v: q on plate along m, f;
}
";

#[test]
fn a_link_on_slots_alone_slides_on_a_block() {
    let folder = with("mjcf_plate", PLATE);
    let output = linkage(&folder, &["mjcf", "own.mech"]);
    let text = String::from_utf8(output.stdout).expect("text");
    let plate = place(&text, &["body name=\"u_block\"", "body name=\"plate\""]);
    assert!(is_near(&plate, &[0.045, 0.025980762113533, 0.0], 1e-12));
    let axis = numbers(attribute(&text, "\"plate_joint\"", "axis"));
    let [cos, sin] = [0.75_f64.sqrt(), 0.5];
    assert!(is_near(&axis, &[cos, sin, 0.0], 1e-12), "{axis:?}");
    let [a, b] = [
        place(&text, &["\"v_a0\""]),
        place(
            &text,
            &[
                "body name=\"u_block\"",
                "body name=\"plate\"",
                "body name=\"v_block\"",
            ],
        ),
    ];
    assert!(is_near(&a, &b, 1e-12), "{a:?} {b:?}");
}

#[test]
fn balls_are_balls_or_three_hinges() {
    let folder = with("mjcf_space", SPACE);
    let note = "note: Rssr: `rod` has no moment of inertia about every axis";
    let output = linkage(&folder, &["mjcf", "own.mech"]);
    assert!(output.status.success());
    assert!(String::from_utf8_lossy(&output.stderr).starts_with(note));
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("<joint name=\"left\" type=\"ball\"/>"));
    let [a, b] = [
        place(
            &text,
            &["body name=\"wheel\"", "body name=\"rod\"", "\"right_a0\""],
        ),
        place(&text, &["body name=\"lever\"", "\"right_b0\""]),
    ];
    assert!(is_near(&a, &b, 1e-16), "{a:?} {b:?}");
    let output = linkage(
        &folder,
        &[
            "mjcf",
            "own.mech",
            "--error",
            "1deg",
            "--range",
            "-40deg..40deg",
        ],
    );
    let text = String::from_utf8_lossy(&output.stdout);
    for joint in ["left_x", "left_y", "left_z", "p"] {
        assert!(
            text.contains(&format!("joint1=\"{joint}\" joint2=\"w\"")),
            "{text}"
        );
    }
}

#[test]
fn what_is_missing_is_named() {
    let folder = folder("robot_missing");
    let said = |name: &str, text: &str, arguments: &[&str]| {
        fs::write(folder.join(name), text).expect("a file");
        let all = [&["mjcf", name], arguments].concat();
        refused(Path::new(&folder), &all, 1)
    };
    let without = FOUR_BAR.replace("pin joint = bar on lever at b;", "");
    let text = said("open.mech", &without, &[]);
    assert!(
        text.starts_with(
            "error: the declared joints leave 3 independent motions, but the mechanism has 1\n"
        ),
        "{text}"
    );
    let bodies = "pub struct Crank { unit mm; input phi = 0deg; let a = polar(3mm, phi); }";
    let text = said("bare.mech", bodies, &[]);
    assert!(text.starts_with("error: Crank has no `body`"), "{text}");
    let text = said("range.mech", FOUR_BAR, &["--range", "70deg..90deg"]);
    assert!(
        text.starts_with(
            "error: the range from 70deg to 90deg does not contain the reference `phi = 60deg`"
        ),
        "{text}"
    );
    let text = said("drive.mech", FOUR_BAR, &["--drive", "q"]);
    assert!(
        text.starts_with("error: there is no joint `q`; there is `arm_joint`, `bar_joint` and `p`"),
        "{text}"
    );
}

#[test]
fn links_are_bodies() {
    let folder = with("mjcf_links", LINKS);
    let output = linkage(&folder, &["mjcf", "own.mech", "--error", "2e-4rad"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(
        said,
        "note: FourBar: no body has a mass: 1 kg and 2.359e-3 kg m^2 are written for each\n"
    );
    let text = String::from_utf8_lossy(&output.stdout);
    let of_links = numbers(attribute(&text, "joint1=\"b\"", "polycoef"));
    fs::write(folder.join("bodies.mech"), FOUR_BAR).expect("a file");
    let text = printed(&folder, &["mjcf", "bodies.mech", "--error", "2e-4rad"]);
    let of_bodies = numbers(attribute(&text, "joint1=\"bar_joint\"", "polycoef"));
    assert!(
        is_near(&of_links, &of_bodies, 1e-9),
        "{of_links:?} {of_bodies:?}"
    );
}

/// A model is read again, with the same motion.
#[test]
fn a_model_can_be_imported() {
    let folder = with("mjcf_again", FOUR_BAR);
    let functions =
        format!("{FOUR_BAR}impl FourBar {{ pub fn points(phi) -> Points {{ b, psi }} }}");
    fs::write(folder.join("own.mech"), functions).expect("a file");
    printed(&folder, &["mjcf", "own.mech", "-o", "own.xml"]);
    let output = linkage(&folder, &["import", "own.xml", "-o", "again.mech"]);
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let rows = |name: &str, function: &str, from: &str, to: &str| -> Vec<Vec<f64>> {
        let arguments = [
            "table", name, function, "--steps", "5", "--from", from, "--to", to,
        ];
        let table = printed(&folder, &arguments);
        let lines = table.lines().skip(1);
        lines
            .map(|line| {
                line.split(',')
                    .map(|cell| cell.parse().expect("a number"))
                    .collect()
            })
            .collect()
    };
    let first = rows("own.mech", "points", "20deg", "100deg");
    let table = printed(&folder, &["table", "again.mech", "motion", "--steps", "1"]);
    let titles: Vec<&str> = table
        .lines()
        .next()
        .unwrap_or_default()
        .split(',')
        .collect();
    let column = |title: &str| {
        titles
            .iter()
            .position(|other| *other == title)
            .expect("a column")
    };
    let [x, y] = ["connect_1_a.x [m]", "connect_1_a.y [m]"].map(column);
    let again = rows("again.mech", "motion", "-40deg", "40deg");
    for (first, again) in first.iter().zip(&again) {
        assert!(is_near(
            &[first[1], first[2]],
            &[1e3 * again[x], 1e3 * again[y]],
            1e-10
        ));
    }
}
