//! A machine of ten parts of seven kinds, by values: each gives to the last bit what it gives alone.

use linkage_compiler::Checked;
use linkage_compiler::ir::CompiledMechanism;

use super::costs::golden;
use super::places::{Organ, organs};
use super::{checked, defaults, own, results, unit};

const ARM: &str = "
    pub struct Arm {
        unit mm;
        param long = 40mm;
        input phi = 10deg in 0deg..360deg;
        unknown psi = 20deg;
        loop psi = 2 * phi;
        let elbow = polar(long, phi);
        let tip = elbow + polar(25mm, psi);
        body upper = pin shoulder on frame at (0, 0), turns phi, mass 2kg at elbow / 2;
        body lower = pin hinge on upper at elbow, turns psi, mass 1kg at tip, inertia 10kg*mm^2;
    }
    impl Arm { }";

/// A part of the machine: what its input is given, and where it stands.
struct Member {
    organ: Organ,
    given: &'static str,
    behind: &'static str,
    /// A point of it, and where that is seen, with `@` for it.
    seen: Option<(&'static str, &'static str)>,
}

const LAW: &str = "piecewise(main, [(0deg, 20deg), (150deg, 130deg, modified_sine), (200deg, 130deg), (360deg, 20deg, poly4567)])";

fn members() -> Vec<Member> {
    let named = |of: &str, name: &'static str| {
        let mut found = organs().into_iter().find(|own| own.of == of);
        let organ = found.as_mut().expect("one of the four");
        organ.name = name;
        found.expect("just found")
    };
    let arm = Organ {
        name: "arm",
        of: "Arm",
        text: ARM.to_owned(),
        input: "phi",
        reference: 30.0,
        asked: &[
            "p: @tip, v: velocity(@tip), e: sensitivity(@tip, [@long])",
            "psi: @psi",
        ],
        is_closed: true,
    };
    let spatial = Organ {
        name: "spatial",
        of: "Rssr",
        // In the machine's unit: in another one numbers are rounded otherwise.
        text: golden("rssr").replace("struct Rssr {\n", "struct Rssr { unit mm;\n"),
        input: "phi",
        reference: 60.0,
        asked: &[
            "psi: @psi, v: velocity(@psi), a: acceleration(@psi)",
            "s: sensitivity(@psi, [@crank, @pivot.y, @tilt]), m: margin()",
            "p: @end, v: velocity(@end)",
        ],
        is_closed: true,
    };
    // The reference of the machine is that of each: what `alone` takes off comes back.
    let member = |organ, given, behind, seen| Member {
        organ: Organ {
            reference: 30.0,
            ..organ
        },
        given,
        behind,
        seen,
    };
    let placed = "at (80mm, 5mm), turned by 10deg";
    let by_hand = "((80mm, 5mm) + rotate(@, 10deg))";
    vec![
        member(named("CrankRocker", "rocker"), "main + 30deg", "", None),
        member(
            named("CrankRocker", "beside"),
            "main + 30deg",
            placed,
            Some(("tracer", by_hand)),
        ),
        member(named("EyeNeedle", "eye"), "main", "", None),
        member(
            named("Favorit", "hook"),
            "2 * main - 90deg",
            placed,
            Some(("p10", by_hand)),
        ),
        member(named("CamPress", "press"), "main + 30deg", "", None),
        member(named("CrankRocker", "servo"), LAW, "", None),
        member(arm, "main + 30deg", "", None),
        member(named("CamPress", "late"), "main - lag", "", None),
        member(
            named("CrankRocker", "ridden"),
            "main - lag",
            "on arm.lower at arm.tip, turned by arm.psi",
            Some(("tracer", "")),
        ),
        member(spatial, "main + lag", "", None),
    ]
}

const BEFORE: &str = "param lag = 12deg;";

fn machine(members: &[Member]) -> String {
    let mut text = String::new();
    for member in members {
        if !text.contains(&format!("struct {} ", member.organ.of)) {
            text += &member.organ.text;
        }
    }
    text +=
        &format!("pub struct Machine {{ unit mm; {BEFORE} input main = 0deg in 0deg..360deg;\n");
    let mut functions = String::new();
    for Member {
        organ,
        given,
        behind,
        ..
    } in members
    {
        let (name, of, input) = (organ.name, organ.of, organ.input);
        text += &format!("part {name}: {of} {{ {input} = {given} }} {behind};\n");
        functions += &organ.functions(&format!("{name}."), "main");
    }
    text + &format!(
        "}} impl Machine {{ {functions} pub fn look(main) -> Look {{ shape: picture() }} }}"
    )
}

/// The mechanism of a part with what its input is given, seen from where it stands.
fn alone(member: &Member) -> Vec<Checked> {
    let mut text = member.organ.alone(BEFORE, member.given);
    if let Some((point, seen)) = member.seen
        && !seen.is_empty()
    {
        let start = text.rfind("impl ").expect("functions");
        let functions = text.split_off(start);
        text += &functions.replace(point, &seen.replace('@', point));
    }
    checked(&text)
}

fn close(here: &[f64], there: &[f64], bits: bool) -> bool {
    let mut all = here.iter().zip(there);
    here.len() == there.len()
        && all.all(|(a, b)| match bits {
            true => a.to_bits() == b.to_bits(),
            false => (a - b).abs() < 1e-11 * b.abs().max(1.0),
        })
}

#[test]
fn ten_parts_give_what_they_give_alone() {
    let members = members();
    assert_eq!(members.len(), 10);
    let all = checked(&machine(&members));
    let machine = unit(&all, "Machine");
    assert_eq!(machine.groups.len(), 11);
    for member in &members {
        let own_all = alone(member);
        let alone = unit(&own_all, member.organ.of);
        let rides = member.seen.is_some_and(|(_, seen)| seen.is_empty());
        for (k, asked) in member.organ.asked.iter().enumerate() {
            // Where it rides on another, its points are compared below.
            if rides && asked.contains("@tracer") {
                continue;
            }
            let function = format!("{}_{k}", member.organ.name);
            let [here, there] = [machine, alone].map(|unit| own(unit, &function).called.count);
            assert_eq!(here, there, "{function}");
            for step in 0..16 {
                let main = [0.05 + 0.39 * f64::from(step)];
                let [here, there] =
                    [machine, alone].map(|unit| results(unit, &function, &defaults(unit), &main));
                // The eye needle's reference and range are its own: its table is the same.
                assert!(
                    close(&here, &there, true),
                    "{function} at {main:?}: {here:?} {there:?}"
                );
            }
        }
    }
    rides(machine, &members);
    picture(machine, &members);
}

/// A part on a body of another: seen by hand.
fn rides(machine: &CompiledMechanism, members: &[Member]) {
    let member = members
        .iter()
        .find(|own| own.organ.name == "ridden")
        .expect("it is there");
    let all = alone(member);
    let alone = unit(&all, member.organ.of);
    for step in 0..16 {
        let main = [0.05 + 0.39 * f64::from(step)];
        let [here, arm, turned] = ["ridden_0", "arm_0", "arm_1"]
            .map(|name| results(machine, name, &defaults(machine), &main));
        let own = results(alone, "ridden_0", &defaults(alone), &main);
        let (sin, cos) = turned[0].sin_cos();
        let expected = [
            arm[0] + cos * own[0] - sin * own[1],
            arm[1] + sin * own[0] + cos * own[1],
        ];
        assert!(close(&here[..2], &expected, false), "{here:?} {expected:?}");
    }
}

/// Every part has the links that it has alone.
fn picture(machine: &CompiledMechanism, members: &[Member]) {
    let picture = machine.picture.as_ref().expect("it is asked for");
    let parts = picture.parts.iter();
    let links: Vec<(&str, usize)> = parts
        .map(|own| (own.name.as_str(), own.links.len()))
        .collect();
    assert_eq!(links.len(), members.len(), "{links:?}");
    let of = |name: &str| links.iter().find(|own| own.0 == name).map(|own| own.1);
    // Equal mechanisms have equally many, wherever they stand and whatever drives them.
    assert_eq!(of("rocker"), of("beside"));
    assert_eq!(of("press"), of("late"));
    assert_eq!(of("rocker"), of("servo"));
    assert!(links.iter().all(|own| own.1 > 0), "{links:?}");
}
