//! Joints and links, and the items that they stand for.

use super::LINKS;
use crate::diagnostic::Diagnostics;
use crate::model::{Library, read, resolve};
use crate::syntax::dump;

/// The mechanisms as text, without joints and links, and all messages.
fn expanded(source: &str) -> (String, Vec<String>) {
    let mut diagnostics = Diagnostics::default();
    let tokens = source.parse().expect("the source has tokens");
    let definitions = read(tokens, &mut diagnostics);
    let text: String = definitions.iter().map(dump).collect();
    let library = Library::default();
    for definition in &definitions {
        resolve(definition, &library, &mut diagnostics);
    }
    (text, diagnostics.texts())
}

#[test]
fn links_are_loops() {
    let (text, messages) = expanded(LINKS);
    assert_eq!(messages, Vec::<String>::new());
    if std::env::var_os("UPDATE").is_some() {
        let path = format!("{}/src/model/tests/links.items", env!("CARGO_MANIFEST_DIR"));
        std::fs::write(path, text).expect("the golden file can be written");
        return;
    }
    let expected = include_str!("links.items");
    assert_eq!(text, expected, "run with UPDATE=1 if the change is wanted");
}

/// `Moving` has a rod too many, and a loop of `Knuckle` drives it.
#[test]
fn links_and_joints_are_counted() {
    let mut diagnostics = Diagnostics::default();
    let tokens = LINKS.parse().expect("the source has tokens");
    let mut counts = Vec::new();
    for definition in read(tokens, &mut diagnostics) {
        let links = definition.links.as_ref().expect("it has links");
        counts.push(format!(
            "{}: {}, {} = {}, {} driven",
            definition.name,
            links.counts(),
            links.formula(),
            links.mobility(),
            links.driven.len()
        ));
    }
    assert_eq!(
        counts,
        [
            "FourBar: 4 links with the frame and 4 pins, 3 * 3 - 2 * 4 = 1, 1 driven",
            "Press: 4 links with the frame, 3 pins and 1 sliding block, 3 * 3 - 2 * 3 - 2 * 1 = 1, 1 driven",
            "QuickReturn: 4 links with the frame, 3 pins and 2 sliding pins, 3 * 3 - 2 * 3 - 1 * 2 = 1, 1 driven",
            "Lift: 4 links with the frame, 3 pins and 1 telescopic joint, 3 * 3 - 2 * 3 - 2 * 1 = 1, 1 driven",
            "TwoPins: 6 links with the frame, 6 pins and 2 sliding pins, 3 * 5 - 2 * 6 - 1 * 2 = 1, 1 driven",
            "Slots: 3 links with the frame, 1 pin and 3 sliding pins, 3 * 2 - 2 * 1 - 1 * 3 = 1, 1 driven",
            "Wheels: 7 links with the frame, 7 pins, 1 gear pair and 1 belt, 3 * 6 - 2 * 7 - 1 * 1 - 1 * 1 = 2, 2 driven",
            "Moving: 4 links with the frame and 4 pins, 3 * 3 - 2 * 4 = 1, 2 driven",
            "Rssr: 4 links with the frame, 2 hinges and 2 ball joints, 6 * 3 - 5 * 2 - 3 * 2 - 1 for idle turns of rods = 1, 1 driven",
            "Tripod: 5 links with the frame, 5 ball joints and 1 telescopic joint, 6 * 4 - 3 * 5 - 5 * 1 - 3 for idle turns of rods = 1, 1 driven",
            "Arm: 3 links with the frame and 2 hinges, 6 * 2 - 5 * 2 = 2, 2 driven",
            "Knuckle: 7 links with the frame and 10 ball joints, 6 * 6 - 3 * 10 - 5 for idle turns of rods = 1, 0 driven",
            "Two: 4 links with the frame, 2 hinges and 2 ball joints, 6 * 3 - 5 * 2 - 3 * 2 - 1 for idle turns of rods = 1, 1 driven",
        ]
    );
}

#[test]
fn mistakes_in_links() {
    const JOINTS: &str = "unit mm; input phi = 90deg; joint a = (0mm, 0mm), b = (0mm, 20mm), c = (50mm, 60mm), d = (50mm, 0mm);";
    const FRAME: &str = "link frame: a, d;";
    const CRANK: &str = "link crank: a, b at phi;";
    const REST: &str = "link coupler: b, c; link rocker: c, d;";
    for (parts, expected) in [
        (
            [FRAME, CRANK, "link coupler: b, e; link rocker: b, c, d;"],
            "unknown joint `e`\nhelp: write where it is drawn: `joint e = (x, y);`",
        ),
        (
            [
                FRAME,
                "joint self = (0mm, 0mm); link crank: a, b at phi;",
                REST,
            ],
            "`self` is a keyword of Rust and cannot be a name",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c c; link rocker: c, d length coupler.length;",
            ],
            "expected `,` and a joint, a clause or `;`, found `c`",
        ),
        (
            [FRAME, "link crank: a, b at phi, at phi;", REST],
            "a second `at`\nhelp: a link has one",
        ),
        (
            [FRAME, "link crank: a, b mass 1kg;", REST],
            "expected `at` and the centre of the mass",
        ),
        (
            [FRAME, "link crank: a, b angle phi;", REST],
            "clauses of a link are `at`, `length`, `about`, `mass` and `inertia`",
        ),
        (
            [FRAME, CRANK, "link coupler: b, c; link rocker: b, d;"],
            "no",
        ),
        (
            [FRAME, CRANK, "link coupler: b, c, b; link rocker: c, d;"],
            "the link `coupler` has the joint `b` twice",
        ),
        (
            [FRAME, CRANK, "link crank: b, c; link rocker: c, d;"],
            "the link `crank` is declared twice",
        ),
        (
            ["link frame: a, d length 3mm;", CRANK, REST],
            "the frame does not move",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; joint k = (1mm, 1mm); link rocker: c, d;",
            ],
            "the joint `k` belongs to no link",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; joint c = (1mm, 1mm); link rocker: c, d;",
            ],
            "the joint `c` is drawn twice",
        ),
        (
            [FRAME, "link crank: a, b at phi - 30deg;", REST],
            "`crank` is drawn at 90 deg, but its input is 60 deg at the reference",
        ),
        (
            [
                "link frame: d;",
                "joint k = (1mm, 1mm); link far: a, k;",
                "link rocker: b, c, d;",
            ],
            "no way leads from the frame to the link `far`",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; link rocker: c, d; slider s: b on rocker along c, a;",
            ],
            "`a` is no joint of the link `rocker`",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; slider s: d on coupler along 0deg; link rocker: c, d;",
            ],
            "the line of `s` has no place on `coupler`",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; slider s: c on frame along a, d, block crank;",
            ],
            "`c` is no joint of the link `crank`",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; slider s: c on frame along a, d, at phi, at phi;",
            ],
            "a second `at`\nhelp: a slider has one",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; link rocker: c, d; gears crank, wheel teeth 1, 2;",
            ],
            "unknown link `wheel`",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; link rocker: c, d; gears crank, rocker 1, 2;",
            ],
            "expected `teeth` or `radii`",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; link rocker: c, d; weld crank;",
            ],
            "write `weld LINK, LINK`",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; link rocker: c, d; link disc: d;",
            ],
            "the link `disc` has one joint, and nothing gives its direction",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b = (1mm, 2mm), c; link rocker: c, d;",
            ],
            "the first two joints of `coupler` are its axis",
        ),
        (
            [
                FRAME,
                CRANK,
                "unknown k; link coupler: b, k; link rocker: c, d; link last: b, c;",
            ],
            "the length of the link `coupler` is not known",
        ),
        (
            [
                FRAME,
                CRANK,
                "joint g = 3mm; link coupler: b, c; link rocker: c, d;",
            ],
            "a joint is drawn at a point",
        ),
        (
            [
                FRAME,
                CRANK,
                "joint g = (3mm +- 1mm, 0mm); link coupler: b, c, g; link rocker: c, d;",
            ],
            "the joint `g` moves, and is only drawn here",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; link rocker: c, d; slider s: c on rocker along c, d;",
            ],
            "`c` is a joint of `rocker`, and cannot slide on it",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; link rocker: c, d; weld rocker, rocker;",
            ],
            "the link `rocker` is welded to itself",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; joint length = (3mm, 3mm); link rocker: c, d, length;",
            ],
            "a joint cannot be called `length`, which is a word of links",
        ),
        (
            [FRAME, CRANK, "link coupler: b, c; link d: c, d;"],
            "`d` is a joint already",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; slider c: c on frame along a, d;",
            ],
            "`c` is a joint already",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; slider s: c on frame along a, d;",
            ],
            "`c` is drawn 60 mm beside the line that it slides on",
        ),
        (
            [
                FRAME,
                CRANK,
                "input s = 100mm; link coupler: b, c; link rocker: c, d length s;",
            ],
            "`rocker` is drawn with a length of 60 mm, but has 100 mm at the reference of its input",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; link rocker: c, d; gears crank, coupler teeth 1, 2;",
            ],
            "the wheel `coupler` has no pivot on `frame`",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; link rocker: c, d; gears crank, crank teeth 1, 2;",
            ],
            "both wheels are one body",
        ),
        (
            [
                FRAME,
                CRANK,
                "link coupler: b, c; link rocker: c, d; gears crank, rocker teeth 0, 2;",
            ],
            "a wheel of no size",
        ),
        (
            [
                FRAME,
                CRANK,
                "joint k = (50mm, 60mm); link coupler: c, k; link rocker: c, d;",
            ],
            "`c` and `k` of `coupler` are drawn at one place",
        ),
        (
            [FRAME, "link crank: a, b about (0, 0, 1) at phi;", REST],
            "the link `crank` turns about an axis, but is drawn in the plane",
        ),
        (
            ["link frame a, d;", CRANK, REST],
            "expected `:` after `frame`",
        ),
    ] {
        let source = format!("struct A {{ {JOINTS} {} }}", parts.join(" "));
        let (_, messages) = expanded(&source);
        match expected {
            "no" => assert_eq!(messages.len(), 0, "{source}: {messages:#?}"),
            _ => {
                assert!(
                    messages.iter().any(|message| message.contains(expected)),
                    "{source}:\n{messages:#?}\nlack\n{expected}"
                );
                // Nothing else follows from a mistake.
                assert!(messages.len() <= 2, "{source}: {messages:#?}");
            }
        }
    }
}

#[test]
fn mistakes_in_links_of_space() {
    const JOINTS: &str = "unit mm; input phi = 0deg; joint a = (0mm, 0mm, 0mm), b = (0mm, 20mm, 0mm), c = (50mm, 60mm, 9mm), d = (50mm, 0mm, 0mm);";
    const FRAME: &str = "link frame: a, d; link crank: a, b about (1, 0, 0) at phi;";
    for (parts, expected) in [
        (
            "link rod: b, c; link rocker: d, c; slider s: c on frame along 0deg;",
            "sliders, gears, belts and welds belong to the plane",
        ),
        (
            "link rod: b, c mass 1kg at b; link rocker: d, c;",
            "links of space have no masses",
        ),
        (
            "link rod: b, c; link rocker: c, d about (0, 0, 1);",
            "the hinge of the link `rocker` is in no joint that is reached",
        ),
        (
            "joint k = (5mm, 6mm); link rod: b, c; link rocker: d, c, k about (1, 0, 0);",
            "`k` has two coordinates, but other joints have three",
        ),
        (
            "link rod: b, c; link rocker: c;",
            "the link `rocker` has one joint",
        ),
        (
            "unknown k; link rod: b, c; link rocker: c, k;",
            "the length of the link `rocker` is not known",
        ),
    ] {
        let source = format!("struct A {{ {JOINTS} {FRAME} {parts} }}");
        let (_, messages) = expanded(&source);
        assert!(
            messages.len() == 1 && messages[0].contains(expected),
            "{source}:\n{messages:#?}\nlack\n{expected}"
        );
    }
}

/// Each arc names the angle of its link, and those of the frame name none.
#[test]
fn curved_slots_turn_with_their_links() {
    const JOINTS: &str = "unit mm; input phi = 60deg; joint o = (0mm, 0mm), a = (10mm, 17.3mm), \
        p = (90mm, 40mm), t = (60mm, 0mm), c = (90mm, 90mm); link frame: o, t, c; \
        link crank: o, a at phi; link rod: a, p;";
    let arcs = |items: &str| -> Vec<String> {
        let (text, messages) = expanded(&format!("struct M {{ {JOINTS} {items} }}"));
        assert_eq!(messages, Vec::<String>::new());
        let lines = text.lines().map(str::trim);
        let arcs = lines.filter(|line| line.starts_with("arc "));
        arcs.map(str::to_owned).collect()
    };
    let on_frame = arcs("slider s: p on frame around c;");
    assert_eq!(on_frame, ["arc s: p around c"]);
    let lever =
        "joint m = (120mm, 10mm); link lever: t, m; slider s: p on lever around m; link tie: p, c;";
    assert_eq!(arcs(lever), ["arc s: p around m, turned by lever.angle"]);
    // A link that joins both is drawn itself.
    let joined = "link arm: c, p; slider s: p on frame around c;";
    assert_eq!(arcs(joined), Vec::<String>::new());
}

/// A link that its slot alone holds slides on a block: one that turns on the pin, or the link after
/// `block`.
#[test]
fn links_that_slots_hold_slide_on_blocks() {
    const JOINTS: &str = "unit mm; input phi = 60deg; joint o = (0mm, 0mm), a = (10mm, 17.3mm), \
        q = (60mm, 17.3mm), m = (20mm, 17.3mm), e = (90mm, 17.3mm), f = (20mm, 90mm); \
        link frame: o, q; link crank: o, a at phi; link plate: m, e, f mass 2kg at e;";
    let mechanics = |items: &str| -> Vec<String> {
        let (text, messages) = expanded(&format!("struct M {{ {JOINTS} {items} }}"));
        assert_eq!(messages, Vec::<String>::new());
        let lines = text.lines().map(str::trim);
        let kinds = ["body plate", "body s_block", "roller", "slide"];
        let found = lines.filter(|line| kinds.iter().any(|kind| line.starts_with(kind)));
        found.map(str::to_owned).collect()
    };
    let pin = mechanics("slider s: a on plate along m, e; slider t: q on plate along m, e;");
    let block = mechanics("slider s: a on plate along m, e, block crank;");
    assert_eq!(
        pin,
        [
            "body s_block = pin s on crank at a, turns plate.angle",
            "body plate = slide on s_block at m along dir(plate.angle), turns plate.angle, mass 2kg at e",
            "roller t = plate on frame at q along dir(plate.angle)",
        ]
    );
    assert_eq!(
        block,
        [
            "body plate = slide s on crank at m along dir(plate.angle), turns plate.angle, mass 2kg at e"
        ]
    );
}
