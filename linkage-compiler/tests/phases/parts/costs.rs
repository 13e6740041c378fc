//! A part costs what it does alone, in operations and in the time of the compiler.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use super::{checked, defaults, own, results, unit};
use crate::compiled;
use crate::growth::count;
use crate::speed::time;

pub(super) fn golden(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/golden/{name}.mech"));
    fs::read_to_string(path).expect("the mechanism can be read")
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

/// A machine of this many crank-rockers on one shaft, each with a lead of its own, with these functions.
fn machine(parts: usize, functions: &str) -> String {
    let mut text = golden("crank_rocker");
    text.push_str("pub struct Machine { unit mm; input shaft = 0deg in 0deg..360deg;");
    for part in 0..parts {
        let _ = writeln!(
            text,
            "param lead{part} = {part}deg; part rocker{part}: CrankRocker {{ phi = shaft + lead{part} }};"
        );
    }
    text + &format!("}} impl Machine {{ {functions} }}")
}

/// What is between the first and the last part, beside the first one alone.
fn ends(parts: usize) -> String {
    let last = parts - 1;
    let functions = format!(
        "pub fn first(shaft) -> First {{ p: rocker0.tracer, v: velocity(rocker0.tracer) }}
         pub fn gap(shaft) -> Gap {{ way: distance(rocker0.tracer, rocker{last}.tracer), e: sensitivity(rocker{last}.tracer) }}"
    );
    machine(parts, &functions)
}

/// A function of each part, and a picture of all of them.
fn all_functions(parts: usize) -> String {
    let mut functions = String::from("pub fn look(shaft) -> Look { shape: picture() }");
    for part in 0..parts {
        let point = format!("rocker{part}.tracer");
        let _ = writeln!(
            functions,
            "pub fn f{part}(shaft) -> F{part} {{ p: {point}, v: velocity({point}), e: sensitivity({point}, [rocker{part}.crank, lead{part}]) }}"
        );
    }
    machine(parts, &functions)
}

#[test]
fn what_lies_between_two_parts_costs_nothing() {
    let [small, large] = [2, 10].map(|parts| checked(&ends(parts)));
    let [small, large] = [unit(&small, "Machine"), unit(&large, "Machine")];
    assert_eq!(large.groups.len(), 10);
    for function in ["first", "gap"] {
        // The results that are zero for the parts between are no operations.
        let [small, large] = [small, large].map(|unit| own(unit, function).called.count);
        assert_eq!(small, large, "{function}");
    }
}

/// What rustc gets: each part adds as much as the one before, its field, its function, its links.
#[test]
fn tokens_grow_linearly_with_the_number_of_parts() {
    let tokens = |parts| {
        let output = compiled(all_functions(parts).parse().expect("tokens"));
        assert!(!output.to_string().contains("compile_error !"), "{output}");
        count(output) as f64
    };
    let [five, ten, twenty] = [5, 10, 20].map(tokens);
    let [first, second] = [ten - five, twenty - ten];
    println!("5 parts {five} tokens, 10 parts {ten}, 20 parts {twenty}");
    let exponent = (second / first).log2();
    println!("exponent of what is added: {exponent:.2}");
    // Where each function named what is prepared for others it was 1.24.
    assert!(
        exponent < 1.15,
        "{five}, {ten}, {twenty}: exponent {exponent:.2}"
    );
}

/// By the clock of this thread, the shortest of several runs: five times as many parts, each with a function, take at most that to the power 1.2.
#[test]
fn time_grows_linearly_with_the_number_of_parts() {
    let (small, large) = (time(&all_functions(4), 4), time(&all_functions(20), 3));
    let ratio = large.as_secs_f64() / small.as_secs_f64();
    let exponent = ratio.ln() / 5f64.ln();
    println!("4 parts {small:?}, 20 parts {large:?}: {ratio:.1} times, exponent {exponent:.2}");
    assert!(
        exponent < 1.2,
        "4 parts {small:?}, 20 parts {large:?}: {ratio:.1} times, exponent {exponent:.2}"
    );
}
