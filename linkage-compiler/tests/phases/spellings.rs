//! Mechanisms in two spellings: loops as a drawing gives them, and loops as an expert writes them. Both have the same
//! groups, the same operations and the same positions.

mod slots;

use linkage_compiler::trace::trace;
use linkage_engine::Mechanism;

/// Results of both spellings differ by roundings of a mechanism of some hundred millimetres.
const ROUNDING: f64 = 1e-12 * 300.0;

/// The operations that a function may take besides those of the short spelling: terms come in another order.
const FURTHER: u32 = 4;

/// A mechanism with loops in two spellings.
struct Pair<'t> {
    /// Items that both have.
    items: &'t str,
    drawn: &'t str,
    short: &'t str,
    /// The positions that are compared.
    fields: &'t str,
    /// A quantity whose velocity is compared.
    rate: &'t str,
    /// The numbers of assemblies of both spellings at the reference.
    assemblies: [usize; 2],
}

/// The text with one of the spellings.
fn text(pair: &Pair, loops: &str) -> String {
    let items = format!("{} {loops}", pair.items);
    let inputs = items.split("input ").skip(1);
    let inputs: Vec<&str> = inputs
        .filter_map(|input| input.split_whitespace().next())
        .collect();
    let (inputs, Pair { fields, rate, .. }) = (inputs.join(", "), pair);
    format!(
        "pub struct M {{ unit mm; {items} }}
         impl M {{
             pub fn position({inputs}) -> Position {{ {fields} }}
             pub fn rates({inputs}) -> Rates {{ v: velocity({rate}) }}
         }}"
    )
}

/// The forms of the groups, in order.
fn groups(text: &str) -> Vec<String> {
    let trace = trace(text.parse().expect("tokens"));
    assert_eq!(trace.messages, Vec::<String>::new(), "{text}");
    let lines = trace.structure.lines();
    let forms = lines.filter_map(|line| {
        let (_, group) = line.strip_prefix("loops")?.split_once(": ")?;
        Some(group.split_once(" for")?.0.to_owned())
    });
    forms.collect()
}

/// The arguments at some positions of the ranges.
fn positions(mechanism: &Mechanism) -> Vec<Vec<f64>> {
    let shares = [0.5, 0.04, 0.31, 0.77, 0.96];
    let position = |step: usize| {
        let inputs = mechanism.compiled().inputs.iter().enumerate();
        let inputs = inputs.map(|(index, input)| {
            let (low, high) = input.range.expect("a range");
            low + (high - low) * shares[(step + index) % shares.len()]
        });
        inputs.collect()
    };
    (0..shares.len()).map(position).collect()
}

#[track_caller]
fn alike(pair: &Pair) {
    let [drawn, short] = [pair.drawn, pair.short].map(|loops| text(pair, loops));
    assert_eq!(groups(&drawn), groups(&short), "{drawn}");
    let compiled =
        |text: &str| Mechanism::compile(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    let [drawn_mechanism, short_mechanism] = [&drawn, &short].map(|text| compiled(text));
    let counts = [&drawn_mechanism, &short_mechanism].map(|mechanism| {
        let functions = mechanism.compiled().functions.iter();
        functions
            .map(|function| function.called.count.total())
            .collect::<Vec<u32>>()
    });
    let mut pairs = counts[0].iter().zip(&counts[1]);
    assert!(
        pairs.all(|(drawn, short)| *drawn <= short + FURTHER),
        "{counts:?}: {drawn}"
    );

    let dimensions = [&drawn_mechanism, &short_mechanism].map(|mechanism| mechanism.dimensions());
    let assemblies = |mechanism: &Mechanism, dimensions: &[f64]| {
        let all = mechanism.assemblies(dimensions, &mechanism.reference());
        all.expect("it can be assembled").len()
    };
    let numbers = [
        assemblies(&drawn_mechanism, &dimensions[0]),
        assemblies(&short_mechanism, &dimensions[1]),
    ];
    assert_eq!(numbers, pair.assemblies, "{drawn}");
    let assemble = |mechanism, dimensions| {
        Mechanism::assemble(mechanism, dimensions).expect("it can be assembled")
    };
    let first = assemble(&drawn_mechanism, &dimensions[0]);
    let second = assemble(&short_mechanism, &dimensions[1]);
    for position in positions(&drawn_mechanism) {
        for function in [0, 1] {
            let [a, b] = [&first, &second].map(|assembled| assembled.call(function, &position));
            for (a, b) in a.into_iter().zip(b) {
                assert!(
                    (a - b).abs() <= ROUNDING,
                    "{a} and {b} at {position:?}: {drawn}"
                );
            }
        }
    }
}

/// A bell crank on a hanger from a rod.
const BELL_CRANK: &str = "input phi = 60deg in 0deg..360deg; input stroke = 150mm in 140mm..170mm;
    let a = polar(20mm, phi); let pivot = (180mm, 100mm);
    unknown k = 0deg; unknown h = 90deg; unknown b = 0deg;
    let c = a + polar(200mm, k); let d = c + polar(100mm, h);";

#[test]
fn a_point_written_the_long_way_round_a_loop() {
    let closed = "loop d = pivot + polar(60mm, b);";
    let end = "loop distance(pivot + polar(80mm, b + 180deg), (100mm, 250mm)) = stroke;";
    for (first, drawn) in [
        (
            closed,
            "loop distance(d - polar(60mm, b) + polar(80mm, b + 180deg), (100mm, 250mm)) = stroke;",
        ),
        (
            closed,
            "loop stroke = distance((100mm, 250mm), d - polar(140mm, b));",
        ),
        (
            "loop pivot + polar(60mm, b) - d = (0mm, 0mm);",
            "loop distance(c + polar(100mm, h) - polar(140mm, b), (100mm, 250mm)) = stroke;",
        ),
        (
            "loop c = pivot + polar(60mm, b) - polar(100mm, h);",
            "loop distance(d - polar(140mm, b), (100mm, 250mm)) = stroke;",
        ),
        (
            "loop a + polar(200mm, k) + polar(100mm, h) - polar(60mm, b) = pivot;",
            "loop norm((100mm, 250mm) - d + polar(140mm, b)) = stroke;",
        ),
    ] {
        alike(&Pair {
            items: BELL_CRANK,
            drawn: &format!("{first} {drawn}"),
            short: &format!("{first} {end}"),
            fields: "c, d, angle: b",
            rate: "d",
            assemblies: [4, 4],
        });
    }
    let square = |end: &str| {
        format!("{closed} let e = {end} - (100mm, 250mm); loop dot(e, e) = stroke * stroke;")
    };
    alike(&Pair {
        items: BELL_CRANK,
        drawn: &square("d - polar(140mm, b)"),
        short: &square("pivot - polar(80mm, b)"),
        fields: "c, d",
        rate: "d",
        assemblies: [4, 4],
    });
    // A guide instead of a cylinder, and a rod to a rocker.
    alike(&Pair {
        items: BELL_CRANK,
        drawn: &format!("{closed} loop dot(d - polar(140mm, b), dir(20deg)) = stroke;"),
        short: &format!("{closed} loop dot(pivot + polar(80mm, b + 180deg), dir(20deg)) = stroke;"),
        fields: "c, d",
        rate: "d",
        assemblies: [4, 4],
    });
    alike(&Pair {
        items: &format!("{BELL_CRANK} unknown r = 60deg; unknown g = 0deg;"),
        drawn: &format!(
            "{closed} loop d - polar(140mm, b) + polar(70mm, r) = (60mm, 100mm) + polar(stroke / 2, g); loop r = 2 * b + 70deg;"
        ),
        short: &format!(
            "{closed} loop pivot - polar(80mm, b) + polar(70mm, r) = (60mm, 100mm) + polar(stroke / 2, g); loop r = 2 * b + 70deg;"
        ),
        fields: "c, d",
        rate: "d",
        assemblies: [4, 4],
    });
}

#[test]
fn two_legs_of_a_triad_in_one_joint() {
    let legs = "input phi = 60deg in 50deg..70deg; let a = polar(30mm, phi);
        unknown u = 10deg; unknown t1 = 70deg; unknown t2 = 120deg; unknown t3 = 95deg;";
    let short = "loop a + polar(90mm, t1) = (90mm, 0mm) + polar(80mm, t2);
        loop (90mm, 0mm) + polar(80mm, t2) + polar(100mm, u) = (170mm, 10mm) + polar(85mm, t3);";
    for drawn in [
        "loop a + polar(90mm, t1) + polar(100mm, u) = (170mm, 10mm) + polar(85mm, t3);
         loop (90mm, 0mm) + polar(80mm, t2) + polar(100mm, u) = (170mm, 10mm) + polar(85mm, t3);",
        "loop (170mm, 10mm) + polar(85mm, t3) - polar(100mm, u) - a = polar(90mm, t1);
         loop (90mm, 0mm) + polar(80mm, t2) + polar(100mm, u) = (170mm, 10mm) + polar(85mm, t3);",
        "loop a + polar(90mm, t1) - polar(100mm, u + 180deg) = (170mm, 10mm) + polar(85mm, t3);
         loop (90mm, 0mm) + polar(80mm, t2) + polar(100mm, u) = (170mm, 10mm) + polar(85mm, t3);",
        "loop a + polar(90mm, t1) + polar(40mm, u) + polar(60mm, u) = (170mm, 10mm) + polar(85mm, t3);
         loop polar(80mm, t2) + polar(100mm, u) = (80mm, 10mm) + polar(85mm, t3);",
    ] {
        alike(&Pair {
            items: legs,
            drawn,
            short,
            fields: "angle: u, end: (90mm, 0mm) + polar(80mm, t2)",
            rate: "u",
            assemblies: [4, 4],
        });
    }
}

/// The joint of two legs is a point of the plate without a name.
#[test]
fn two_legs_by_distances_in_one_joint_of_a_plate() {
    let plate = "input phi = 60deg in 50deg..70deg; let a = polar(30mm, phi);";
    let text = |items: &str| {
        format!(
            "pub struct M {{ unit mm; {plate} {items} }}
             impl M {{ pub fn f(phi) -> F {{ p, end, v: velocity(end) }} }}"
        )
    };
    let drawn = text(
        "unknown p = (30mm, 70mm); unknown u = 10deg;
         let joint = p + polar(50mm, u + 30deg); let end = p + polar(140mm, u);
         loop distance(a, joint) = 90mm; loop distance((90mm, 0mm), joint) = 80mm;
         loop distance((170mm, 10mm), end) = 85mm;",
    );
    let short = text(
        "unknown joint = (70mm, 90mm); unknown u = 10deg;
         let p = joint - polar(50mm, u + 30deg); let end = p + polar(140mm, u);
         loop distance(a, joint) = 90mm; loop distance((90mm, 0mm), joint) = 80mm;
         loop distance((170mm, 10mm), end) = 85mm;",
    );
    let [drawn, short] = [drawn, short].map(|text| Mechanism::compile(&text).expect("a mechanism"));
    let kinds = |mechanism: &Mechanism| -> Vec<String> {
        let groups = mechanism.compiled().groups.iter();
        groups.map(|group| group.kind.clone()).collect()
    };
    assert_eq!(kinds(&drawn), ["RRR", "RRR"]);
    assert_eq!(kinds(&short), kinds(&drawn));
    let dimensions = drawn.dimensions();
    let assembled =
        [&drawn, &short].map(|one| one.assemble(&dimensions).expect("it can be assembled"));
    for position in positions(&drawn) {
        let [a, b] = [0, 1].map(|k| assembled[k].call(0, &position));
        let mut pairs = a.iter().zip(&b);
        assert!(pairs.all(|(a, b)| (a - b).abs() <= ROUNDING), "{a:?} {b:?}");
    }
    let reference = drawn.reference();
    let all =
        [&drawn, &short].map(|one| one.assemblies(&dimensions, &reference).expect("some").len());
    assert_eq!(all[0], all[1]);
}

/// The end of a link from an unknown point is held by two lines.
#[test]
fn a_joint_where_two_lines_cross() {
    for (first, second) in [
        (
            "dot(end, dir(phi + 90deg)) = 0",
            "dot(end - (120mm, 0mm), dir(phi / 4 + 20deg)) = 0",
        ),
        (
            "0 = dot(dir(phi + 90deg), -end)",
            "cross(dir(phi / 4 + 110deg), (120mm, 0mm) - end) = 0",
        ),
    ] {
        let held =
            format!("loop {first}; loop {second}; loop dot(p, dir(phi / 2 - 90deg)) = -20mm;");
        let items = "input phi = 40deg in 20deg..60deg; unknown t = 10deg;";
        let text = |items: &str, point: &str| {
            format!(
                "pub struct M {{ unit mm; {items} {point} {held} }}
                 impl M {{ pub fn f(phi) -> F {{ p, end, v: velocity(p) }} }}"
            )
        };
        let drawn = text(
            items,
            "unknown p = (50mm, 70mm); let end = p + polar(60mm, t);",
        );
        let short = text(
            items,
            "unknown end = (110mm, 80mm); let p = end - polar(60mm, t);",
        );
        assert_eq!(groups(&drawn), groups(&short), "{drawn}");
        let mechanisms =
            [&drawn, &short].map(|text| Mechanism::compile(text).expect("a mechanism"));
        let assembled = mechanisms
            .each_ref()
            .map(|one| one.assemble(&[]).expect("it can be assembled"));
        for position in positions(&mechanisms[0]) {
            let [a, b] = [0, 1].map(|k| assembled[k].call(0, &position));
            let mut pairs = a.iter().zip(&b);
            assert!(pairs.all(|(a, b)| (a - b).abs() <= ROUNDING), "{a:?} {b:?}");
        }
        let counts = mechanisms
            .each_ref()
            .map(|one| one.compiled().functions[0].called.count.total());
        assert!(counts[0] <= counts[1] + FURTHER, "{counts:?}: {drawn}");
    }
}
