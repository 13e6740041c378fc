//! Mechanisms within mechanisms: a part costs and gives what it does alone.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use linkage_compiler::unit::{Coupled, Start, Unit};
use linkage_compiler::{Checked, check_all};
use linkage_core::Scalar;
use linkage_symbolic::interpret::run;
use linkage_symbolic::program::Source;

use super::speed::time;

fn golden(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/golden/{name}.mech"));
    fs::read_to_string(path).expect("the mechanism can be read")
}

pub(super) fn checked(text: &str) -> Vec<Checked> {
    let all = check_all(text.parse().expect("tokens"));
    for own in &all {
        assert!(own.messages.is_empty(), "{:#?}", own.messages);
    }
    all
}

pub(super) fn unit<'c>(all: &'c [Checked], name: &str) -> &'c Unit {
    let mut named = all.iter().filter(|own| own.name.as_deref() == Some(name));
    let unit = named.next().and_then(|own| own.unit.as_ref());
    unit.expect("a mechanism of that name without a mistake")
}

/// The results of a function, by its name; angles are those nearest to their estimates.
pub(super) fn results(unit: &Unit, function: &str, dimensions: &[f64], inputs: &[f64]) -> Vec<f64> {
    results_of(unit, function, dimensions, inputs, &[])
}

/// With arguments behind the inputs.
pub(super) fn results_of(
    unit: &Unit,
    function: &str,
    dimensions: &[f64],
    inputs: &[f64],
    arguments: &[f64],
) -> Vec<f64> {
    let places = [inputs, arguments].concat();
    let modes = unit.modes();
    let states: Vec<Vec<f64>> = unit.coupled.iter().map(|own| state(own, inputs)).collect();
    let load = |source, prepared: &[f64]| match source {
        Source::Parameter(index) => dimensions[index],
        Source::Input(index) => places[index],
        Source::Mode(index) if modes[index] => 1.0,
        Source::Mode(_) => -1.0,
        Source::Prepared(slot) => prepared[slot],
        Source::Centre(angle) => unit.angles[angle].estimate,
        Source::Winding(..) => 0.0,
        Source::State(group, component) => states[group][component],
        Source::Limit => <f64 as Scalar>::CORRECTION_LIMIT,
        Source::Carried(_) => f64::NAN,
    };
    let prepared = run(&unit.prepare, |source| load(source, &[]));
    let results = run(&own(unit, function).called.program, |source| {
        load(source, &prepared)
    });
    assert!(
        results.iter().all(|x| x.is_finite()),
        "{function} at {inputs:?}: {results:?}"
    );
    results
}

/// What is prepared of a coupled group near some inputs, behind it the least determinant that is certified.
fn state(group: &Coupled, inputs: &[f64]) -> Vec<f64> {
    let mut numbers = vec![0.0; group.size];
    let own: Vec<f64> = group.inputs.iter().map(|&input| inputs[input]).collect();
    let floor = match group.start.as_ref().expect("it is closed") {
        Start::Table(table) => table.state(own[0], &mut numbers),
        Start::Grid(grid) => grid.state(&own, &mut numbers),
    };
    numbers.push(floor);
    numbers
}

fn own<'u>(unit: &'u Unit, function: &str) -> &'u linkage_compiler::unit::Function {
    let mut functions = unit.functions.iter();
    let found = functions.find(|own| own.name == function);
    found.expect("a function of that name")
}

pub(super) fn defaults(unit: &Unit) -> Vec<f64> {
    unit.scalars().map(|own| own.nominal).collect()
}

const OF_PARTS: &str = "
    pub struct Machine {
        unit mm;
        param lead = 30deg +- 0.5deg;
        input shaft = 0deg in 0deg..360deg;
        part rocker: CrankRocker { phi = shaft };
        part needle: EyeNeedle { phi = shaft };
        part favorit: Favorit { phi12 = shaft };
        part ahead: EyeNeedle { phi = shaft + lead };
        let gap = needle.p8 - ahead.p8;
    }
    impl Machine {
        pub fn rocker(shaft) -> Rocker { tracer: rocker.tracer, v: velocity(rocker.tracer), a: acceleration(rocker.tracer) }
        pub fn eye(shaft) -> Eye { p8: needle.p8, v: velocity(needle.p8) }
        pub fn accuracy(shaft) -> EyeAccuracy { e: sensitivity(needle.p8, [needle.l12, needle.p7.y]) }
        pub fn needle(shaft) -> Hook { p10: favorit.p10, v: velocity(favorit.p10), a: acceleration(favorit.p10) }
        pub fn between(shaft) -> Between { gap, e: d(gap, lead), all: sensitivity(gap) }
        pub fn look(shaft) -> Look { shape: picture() }
    }";

/// Four organs on one shaft: what is asked of one costs and gives, to the last bit, what it does in its own mechanism.
#[test]
fn a_part_costs_and_gives_what_it_does_alone() {
    let rocker = golden("crank_rocker").replace(
        "path(phi) -> Path { tracer }",
        "path(phi) -> Path { tracer, v: velocity(tracer), a: acceleration(tracer) }",
    );
    let text = [&rocker, &golden("eye_needle"), &golden("favorit"), OF_PARTS]
        .map(String::from)
        .concat();
    let all = checked(&text);
    let machine = unit(&all, "Machine");
    for (part, of, alone, here) in [
        ("rocker", "CrankRocker", "path", "rocker"),
        ("needle", "EyeNeedle", "motion", "eye"),
        ("needle", "EyeNeedle", "accuracy", "accuracy"),
        ("favorit", "Favorit", "needle", "needle"),
    ] {
        let of = unit(&all, of);
        assert_eq!(
            own(of, alone).called.count,
            own(machine, here).called.count,
            "{here}"
        );
        // Dimensions are behind the lead, under the names of the part.
        let names: Vec<&str> = machine.scalars().map(|own| own.name.as_str()).collect();
        let places: Vec<usize> = of
            .scalars()
            .map(|own| {
                let name = format!("{part}.{}", own.name);
                let place = names.iter().position(|own| *own == name);
                place.expect("it came along")
            })
            .collect();
        let dimensions = defaults(machine);
        assert_eq!(
            defaults(of),
            places
                .iter()
                .map(|&own| dimensions[own])
                .collect::<Vec<_>>()
        );
        for step in 0..=72 {
            let shaft = [f64::from(step) * 0.0872];
            let [alone, here] = [
                results(of, alone, &defaults(of), &shaft),
                results(machine, here, &dimensions, &shaft),
            ];
            let bits = |all: &[f64]| all.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            assert_eq!(
                bits(&alone),
                bits(&here),
                "{part} at {shaft:?}: {alone:?} and {here:?}"
            );
        }
    }
    // Two needles by 30 degrees: the way between them, and what the lead does to it.
    let needle = unit(&all, "EyeNeedle");
    let at = |shaft| results(needle, "motion", &defaults(needle), &[shaft]);
    let between = results(machine, "between", &defaults(machine), &[1.2]);
    let (late, early) = (at(1.2), at(1.2 + defaults(machine)[0]));
    for axis in 0..2 {
        let way = late[axis] - early[axis];
        assert!(
            (between[axis] - way).abs() < 1e-11,
            "{} and {way}",
            between[axis]
        );
        assert!(
            (between[2 + axis] + early[2 + axis]).abs() < 1e-10 * early[2 + axis].abs().max(1.0)
        );
    }
    assert_eq!(between.len(), 4 + 2 * machine.scalars().count());
    // Cranks of rocker and needle are equally long and turn together, and are two all the same.
    let picture = machine.picture.as_ref().expect("a picture");
    let points: Vec<&str> = picture.names().collect();
    for name in ["rocker.a", "needle.p2", "ahead.p2", "favorit.p2"] {
        assert!(points.contains(&name), "{name} of {points:?}");
    }
    let parts = picture.parts.iter();
    let links: Vec<usize> = parts.map(|part| part.links.len()).collect();
    assert_eq!(links, [3, 5, 6, 5], "{picture}");
}

/// A machine of this many crank-rockers on one shaft, each with a lead of its own.
fn machine(parts: usize) -> String {
    let mut text = golden("crank_rocker");
    text.push_str("pub struct Machine { unit mm; input shaft = 0deg in 0deg..360deg;");
    for part in 0..parts {
        let _ = writeln!(
            text,
            "param lead{part} = {part}deg; part rocker{part}: CrankRocker {{ phi = shaft + lead{part} }};"
        );
    }
    let last = parts - 1;
    let _ = writeln!(
        text,
        "}} impl Machine {{ pub fn first(shaft) -> First {{ p: rocker0.tracer, v: velocity(rocker0.tracer) }}
           pub fn gap(shaft) -> Gap {{ way: distance(rocker0.tracer, rocker{last}.tracer), e: sensitivity(rocker{last}.tracer) }} }}"
    );
    text
}

#[test]
fn a_machine_of_ten_parts_computes_what_is_asked() {
    let [small, large] = [2, 10].map(|parts| checked(&machine(parts)));
    let [small, large] = [unit(&small, "Machine"), unit(&large, "Machine")];
    assert_eq!(large.groups.len(), 10);
    for function in ["first", "gap"] {
        // The results that are zero for the parts between are no operations.
        let [small, large] = [small, large].map(|unit| own(unit, function).called.count);
        assert_eq!(small, large, "{function}");
    }
}

#[test]
fn time_grows_linearly_with_the_number_of_parts() {
    let (small, large) = (time(&machine(4), 3), time(&machine(20), 2));
    let ratio = large.as_secs_f64() / small.as_secs_f64();
    println!("4 parts {small:?}, 20 parts {large:?}: {ratio:.1} times");
    // Functions of one part look at the others no more than to find that they are not needed.
    assert!(
        ratio < 10.0,
        "4 parts {small:?}, 20 parts {large:?}: {ratio:.1} times"
    );
}

const ARM: &str = "
    struct Arm {
        unit mm;
        param long = 40mm;
        input phi = 10deg in 0deg..360deg at omega;
        unknown psi = 20deg;
        loop psi = 2 * phi;
        let elbow = polar(long, phi);
        let tip = elbow + polar(25mm, psi);
        let along = dir(psi);
        body upper = pin shoulder on frame at (0, 0), turns phi, mass 2kg at elbow / 2;
        body lower = pin hinge on upper at elbow, turns psi, mass 1kg at tip, inertia 10kg*mm^2;
    }
    impl Arm {
        fn tip(phi) -> ArmTip { tip, along }
        fn forces(phi, omega) -> ArmForces { t: torque(phi), hinge: reaction(hinge) }
    }
    struct Pair {
        unit m;
        param way = 30mm;
        input turn = 0deg;
        part first: Arm { phi = turn };
        part second: Arm { phi = turn / 2, long = 2 * first.long } on first.lower at first.tip, turned by turn + 15deg;
        let both = second.tip - first.tip;
    }
    struct Whole {
        unit cm;
        input shaft = 30deg in 0deg..360deg at omega;
        part pair: Pair { turn = shaft } at (1cm, pair_lift), turned by 40deg;
        param pair_lift = 2cm;
        part beside: Arm { phi = shaft } at (50mm, 0), turned by 70deg;
    }
    impl Whole {
        fn tips(shaft) -> WholeTips {
            tip: pair.second.tip, along: pair.second.along, angle: pair.second.psi, both: pair.both, v: velocity(pair.second.tip.x),
            e: d(pair.second.tip, pair.first.long),
        }
        fn hinges(shaft, omega) -> WholeForces { beside: reaction(beside.hinge), inner: reaction(pair.second.hinge) }
    }";

/// Parts of parts, on each other's bodies, in other units: every frame by hand.
#[test]
fn parts_stand_in_frames() {
    let all = checked(ARM);
    let (arm, whole) = (unit(&all, "Arm"), unit(&all, "Whole"));
    let names: Vec<&str> = whole.scalars().map(|own| own.name.as_str()).collect();
    assert_eq!(
        names,
        ["pair_lift", "pair.way", "pair.first.long", "beside.long"]
    );
    let turned = |[x, y]: [f64; 2], angle: f64| {
        let (sin, cos) = angle.sin_cos();
        [cos * x - sin * y, sin * x + cos * y]
    };
    let tip = |long: f64, phi: f64| {
        let found = results(arm, "tip", &[long], &[phi]);
        ([found[0] / 10.0, found[1] / 10.0], [found[2], found[3]])
    };
    for step in 0..12 {
        let shaft = 0.1 + 0.5 * f64::from(step);
        let (first, _) = tip(40.0, shaft);
        let (second, along) = tip(80.0, shaft / 2.0);
        let inner = shaft + 15f64.to_radians();
        let outer = 40f64.to_radians();
        let way = turned(second, inner);
        let there = turned([first[0] + way[0], first[1] + way[1]], outer);
        let along = turned(along, inner + outer);
        let found = results(whole, "tips", &defaults(whole), &[shaft]);
        // A difference of points is a point by its type: that of the part's origin and the place of the part.
        let both = turned(way, outer);
        let expected = [
            1.0 + there[0],
            2.0 + there[1],
            along[0],
            along[1],
            shaft,
            1.0 + both[0],
            2.0 + both[1],
        ];
        for (found, expected) in found.iter().zip(expected) {
            assert!(
                (found - expected).abs() < 1e-12,
                "{found} and {expected} at {shaft}"
            );
        }
        let difference = |at: usize, dimension: usize, by: f64| {
            let mut all = [defaults(whole), defaults(whole)];
            let mut shafts = [shaft; 2];
            match dimension {
                usize::MAX => shafts = [shaft - by, shaft + by],
                _ => {
                    all[0][dimension] -= by;
                    all[1][dimension] += by;
                }
            }
            let ends = [0, 1].map(|k| results(whole, "tips", &all[k], &[shafts[k]])[at]);
            (ends[1] - ends[0]) / (2.0 * by)
        };
        for (at, by, of) in [(7, usize::MAX, 0), (8, 2, 0), (9, 2, 1)] {
            let expected = difference(of, by, 1e-5);
            assert!(
                (found[at] - expected).abs() < 1e-7,
                "{} and {expected}",
                found[at]
            );
        }
        // Without gravity a frame at rest turns what its joints transmit, and nothing else.
        let omega = 3.0;
        let alone = results_of(arm, "forces", &[40.0], &[shaft], &[omega]);
        let here = results_of(whole, "hinges", &defaults(whole), &[shaft], &[omega]);
        let hinge = turned([alone[1], alone[2]], 70f64.to_radians());
        for axis in 0..2 {
            assert!(
                (here[axis] - hinge[axis]).abs() < 1e-9 * hinge[axis].abs().max(1.0),
                "{here:?} {hinge:?}"
            );
        }
    }
}

/// A part of space in a frame: its points and directions along the axes of that frame.
#[test]
fn parts_of_space_stand_in_frames() {
    let text = "
        struct Arm { unit mm; param r = 20mm; input phi = 0deg; let tip = (r * cos(phi), r * sin(phi), 5mm); let up = (0, 0, 1); let own = frame(tip, (1, 0, 0), up); }
        struct Robot {
            unit mm;
            param base = (10mm, 20mm, 30mm);
            input q = 0deg; input p = 0deg;
            part first: Arm { phi = q } at base;
            part second: Arm { phi = p } at frame(first.tip, turn((1, 0, 0), (0, 0, 1), q), (0, 1, 0));
        }
        impl Robot { fn hand(q, p) -> Hand { tip: second.tip, up: second.up, origin: second.own.origin, z: second.own.z } }";
    let all = checked(text);
    let robot = unit(&all, "Robot");
    let (q, p): (f64, f64) = (0.3, 1.1);
    // x is as it is given, z is made square to it; y is z times x.
    let (sin, cos) = q.sin_cos();
    let [x, y, z] = [[cos, sin, 0.0], [0.0, 0.0, -1.0], [-sin, cos, 0.0]];
    let origin = [10.0 + 20.0 * q.cos(), 20.0 + 20.0 * q.sin(), 35.0];
    let own = [20.0 * p.cos(), 20.0 * p.sin(), 5.0];
    let tip: Vec<f64> = (0..3)
        .map(|k| origin[k] + own[0] * x[k] + own[1] * y[k] + own[2] * z[k])
        .collect();
    let expected = [&tip[..], &z, &tip, &z].concat();
    let found = results(robot, "hand", &defaults(robot), &[q, p]);
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() < 1e-12, "{found} and {expected}");
    }
}

/// A part's angles count the turns that they would alone, on the way from its own reference to where the machine has it.
#[test]
fn angles_of_parts_count_the_turns_from_their_own_reference() {
    let estimates = |shaft: &str| {
        let text = format!(
            "struct Drag {{
                unit mm;
                param base = 20mm; param crank = 60mm; param coupler = 50mm; param driven = 55mm;
                input phi = 10deg in 0deg..360deg;
                unknown theta = 100deg; unknown psi = 60deg;
                loop polar(crank, phi) + polar(coupler, theta) = (base, 0) + polar(driven, psi);
            }}
            struct Machine {{
                unit cm;
                input shaft = {shaft};
                part first: Drag {{ phi = shaft }};
                part second: Drag {{ phi = first.psi, crank = 61mm }};
            }}
            impl Machine {{ fn angle(shaft) -> Angle {{ first: first.psi, second: second.psi }} }}"
        );
        let all = checked(&text);
        let angles = unit(&all, "Machine").angles.iter();
        angles.map(|own| own.estimate).collect::<Vec<f64>>()
    };
    let (near, far) = (estimates("15deg"), estimates("-705deg"));
    assert_eq!(near.len(), 2);
    for (near, far) in near.into_iter().zip(far) {
        assert!(
            (near - far - 2.0 * std::f64::consts::TAU).abs() < 1e-9,
            "{near} and {far}"
        );
    }
}

/// A law of motion within a part, whose knots are the part's dimensions, and one as the input of a part.
#[test]
fn laws_of_motion_come_along_and_drive_parts() {
    let text = "
        struct Press {
            unit mm;
            param lift = 20mm;
            param crank = 30mm;
            input phi = 10deg in 0deg..360deg;
            let rise = piecewise(phi, [(0deg, 0mm), (120deg, lift, modified_sine), (200deg, lift), (360deg, 0mm, poly345)]);
            let tip = polar(crank, phi) + (0, rise);
        }
        impl Press { fn tip(phi) -> Tip { tip, v: velocity(tip), a: acceleration(tip), e: sensitivity(tip) } }
        struct Machine {
            unit mm;
            input shaft = 10deg in 0deg..360deg;
            part press: Press { phi = shaft };
            part servo: Press { phi = piecewise(shaft, [(0deg, 0deg), (180deg, 90deg, cycloidal), (360deg, 0deg, cycloidal)]) };
        }
        impl Machine {
            fn tip(shaft) -> PressTip {
                tip: press.tip, v: velocity(press.tip), a: acceleration(press.tip), e: sensitivity(press.tip, [press.lift, press.crank])
            }
            fn servo(shaft) -> Servo { phi: servo.phi, tip: servo.tip, v: velocity(servo.tip) }
        }";
    let all = checked(text);
    let [press, machine] = ["Press", "Machine"].map(|name| unit(&all, name));
    let quarter = std::f64::consts::FRAC_PI_2;
    for step in 0..72 {
        let shaft = [f64::from(step) * 0.0873];
        let alone = results(press, "tip", &defaults(press), &shaft);
        assert_eq!(
            alone,
            results(machine, "tip", &defaults(machine), &shaft),
            "{shaft:?}"
        );
        // The cycloidal law forth and back within a turn.
        let x = (shaft[0] / (2.0 * quarter)) % 2.0;
        let rise = |x: f64| x - (4.0 * quarter * x).sin() / (4.0 * quarter);
        let phi = quarter
            * if x < 1.0 {
                rise(x)
            } else {
                1.0 - rise(x - 1.0)
            };
        let servo = results(machine, "servo", &defaults(machine), &shaft);
        assert!((servo[0] - phi).abs() < 1e-14, "{servo:?}, {phi}");
        let there = results(press, "tip", &defaults(press), &[servo[0]]);
        for axis in 0..2 {
            assert!((servo[1 + axis] - there[axis]).abs() < 1e-12 * 50.0);
        }
    }
}
