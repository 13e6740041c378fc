//! What is recognised, however a mechanism is written.

use crate::unit::Unit;
use crate::{Checked, check, check_all};

fn compile(items: &str, functions: &str) -> (Unit, Vec<String>) {
    let text = format!("struct M {{ unit mm; {items} }} impl M {{ {functions} }}");
    let Checked { unit, messages, .. } = check(text.parse().expect("tokens"));
    let texts = messages.into_iter().map(|message| message.text).collect();
    (unit.unwrap_or_default(), texts)
}

#[track_caller]
fn expect(items: &str, call: &str, expected: &str) {
    let (unit, messages) = compile(items, &format!("fn look(phi) -> Look {{ shape: {call} }}"));
    assert!(messages.is_empty(), "{messages:?}");
    let picture = unit.picture.expect("a picture");
    let numbers = unit.functions[0].called.program.outputs.len();
    assert_eq!(
        numbers,
        picture.dimension * picture.vectors(),
        "\n{picture}"
    );
    let picture = picture.to_string();
    // Joints, gears and drives are those of `tests/drawings`.
    let lines = |text: &str| -> Vec<String> {
        let words = ["point", "link", "guide", "cylinder", "axis"];
        let told = |line: &&str| {
            words
                .iter()
                .any(|word| line.starts_with(&format!("{word} ")))
        };
        let lines = text.lines().map(str::trim).filter(told);
        lines.map(str::to_owned).collect()
    };
    assert_eq!(lines(&picture), lines(expected), "\n{picture}");
}

#[track_caller]
fn expect_message(items: &str, functions: &str, part: &str) {
    let (_, messages) = compile(items, functions);
    assert!(
        messages.len() == 1 && messages[0].contains(part),
        "{messages:?}"
    );
}

const FOUR_BAR: &str =
    "param crank = 50mm; param coupler = 120mm; param rocker = 100mm; param base = 140mm;
    input phi = 30deg in 0deg..360deg; unknown theta = 40deg; unknown psi = 80deg;";

const FOUR_BAR_PICTURE: &str = "
    point crank/frame: Ground
    point crank/coupler: Joint
    point coupler/rocker: Joint
    point rocker/frame: Ground
    link crank: crank/frame, crank/coupler
    link coupler: crank/coupler, coupler/rocker
    link rocker: rocker/frame, coupler/rocker";

#[test]
fn a_vector_loop_tells_all_links() {
    let closed = "loop polar(crank, phi) + polar(coupler, theta) = (base, 0) + polar(rocker, psi);";
    expect(
        &format!("{FOUR_BAR} {closed}"),
        "picture()",
        FOUR_BAR_PICTURE,
    );
    // The same the other way round, and as multiples of directions.
    for closed in [
        "loop polar(crank, phi) + coupler * dir(theta) - polar(rocker, psi) = (base, 0);",
        "loop polar(coupler, theta) = (base, 0) + polar(rocker, psi) - polar(crank, phi);",
        "loop polar(crank, phi) + polar(coupler, theta) - polar(rocker, psi) - (base, 0) = 0;",
    ] {
        expect_links(
            closed,
            [
                "crank: crank/frame",
                "coupler: crank/coupler",
                "rocker: rocker/frame",
            ],
        );
    }
    let points = "let p = polar(crank, phi); let q = polar(rocker, psi) + (base, 0);";
    for closed in [
        "loop q - p = polar(coupler, theta);",
        "let v = q - p; loop v = polar(coupler, theta);",
        "loop p + polar(coupler, theta) - q = 0;",
        "loop -p - polar(coupler, theta) = -q;",
    ] {
        let links = [
            "crank: crank/frame, p",
            "coupler: p, q",
            "rocker: rocker/frame, q",
        ];
        expect_links(&format!("{points} {closed}"), links);
    }
    let steps = "let r1 = (base, 0mm); let r2 = polar(crank, phi); let r3 = polar(coupler, theta); let r4 = polar(rocker, psi);";
    for closed in ["loop r3 = r1 + r4 - r2;", "loop r2 + r3 - r4 - r1 = 0;"] {
        let links = ["crank: crank/frame, r2", "r3: r2, r3/r4", "r4: r1, r3/r4"];
        expect_links(&format!("{steps} {closed}"), links);
    }
}

/// The four-bar has these links, in any order; of each the beginning is given.
#[track_caller]
fn expect_links(closed: &str, expected: [&str; 3]) {
    let items = format!("{FOUR_BAR} {closed}");
    let (unit, messages) = compile(&items, "fn look(phi) -> Look { shape: picture() }");
    assert!(messages.is_empty(), "{messages:?}");
    let picture = unit.picture.expect("a picture").to_string();
    let links: Vec<&str> = picture
        .lines()
        .filter(|line| line.starts_with("link"))
        .collect();
    assert_eq!(links.len(), 3, "{closed}\n{picture}");
    for link in expected {
        let found = links
            .iter()
            .any(|own| own.starts_with(&format!("link {link}")));
        assert!(found, "{link} of {closed}\n{picture}");
    }
}

#[test]
fn pivots_may_be_written_last() {
    expect(
        "param crank = 50mm; param o = (10mm, 20mm); input phi = 30deg in 0deg..360deg; let p = polar(crank, phi) + o;",
        "picture()",
        "point o: Ground
         point p: Tip
         link crank: o, p",
    );
}

#[test]
fn what_lies_elsewhere_spoils_nothing() {
    let items = "let p = polar(crank, phi); let q = (base, 0) + polar(rocker, psi); loop p + polar(coupler, theta) = q;
        let above = (p.x, p.y, 12mm); let nowhere = p + polar(sqrt(-1mm * 1mm - p.y * p.y), theta);
        let middle = (p + q) / 2; let tip = 0.5 * (p + q) + polar(10mm, theta + 90deg);";
    expect(
        &format!("{FOUR_BAR} {items}"),
        "picture()",
        "point crank/frame: Ground
         point p: Joint
         point rocker/frame: Ground
         point q: Joint
         point middle: Tip
         point tip: Tip
         link crank: crank/frame, p
         link rocker: rocker/frame, q
         link coupler: middle, tip, p, q",
    );
}

#[test]
fn a_length_from_the_origin_is_a_rod() {
    expect(
        "param arm = 80mm; param rod = 60mm; param crank = 10mm; param o = (60mm, 0mm);
         input phi = 30deg in 0deg..360deg; unknown a = (70mm, 40mm);
         loop norm(a) = arm; loop distance(a, o + polar(crank, phi)) = rod;",
        "picture()",
        "point a: Joint
         point arm/frame: Ground
         point o: Ground
         point crank/rod: Joint
         link arm: arm/frame, a
         link crank: o, crank/rod
         link rod: a, crank/rod",
    );
}

#[test]
fn a_rod_may_slide_through_a_pivot() {
    expect(
        "param crank = 30mm; param d = (100mm, 0mm); input phi = 30deg in 0deg..360deg; unknown theta = 0deg; unknown s = 80mm;
         let p = polar(crank, phi); loop p + polar(s, theta) = d; let tip = p + polar(160mm, theta);",
        "picture()",
        "point crank/frame: Ground
         point p: Joint
         point tip: Tip
         point d: Ground
         link crank: crank/frame, p
         link theta: p, tip
         guide s: d from p, on theta",
    );
}

#[test]
fn a_named_step_is_no_point() {
    let items = "let arm = polar(crank, phi); let rod = polar(coupler, theta);
        loop arm + rod = (base, 0) + polar(rocker, psi);";
    let expected = FOUR_BAR_PICTURE.replace("coupler", "rod");
    let expected = expected.replace("crank/rod", "arm");
    expect(&format!("{FOUR_BAR} {items}"), "picture()", &expected);
}

#[test]
fn an_unknown_point_hangs_on_two_rods() {
    expect(
        "param crank = 50mm; param coupler = 120mm; param rocker = 100mm; param base = (140mm, 0mm);
         input phi = 30deg in 0deg..360deg; unknown pin = (120mm, 98mm);
         loop distance(pin, polar(crank, phi)) = coupler; loop norm(pin - base) = rocker;",
        "picture()",
        "point pin: Joint
         point crank/frame: Ground
         point crank/coupler: Joint
         point base: Ground
         link crank: crank/frame, crank/coupler
         link coupler: pin, crank/coupler
         link rocker: base, pin",
    );
}

#[test]
fn points_that_turn_together_make_plates() {
    let items = "let pin = polar(crank, phi);
        let tip = pin + rotate((70mm, 30mm), theta); let tool = tip + polar(5mm, theta + 10deg);
        loop pin + polar(coupler, theta) = (base, 0) + polar(rocker, psi);
        let other = (base, 0) + polar(30mm, psi - 40deg);";
    expect(
        &format!("{FOUR_BAR} {items}"),
        "picture()",
        "point crank/frame: Ground
         point pin: Joint
         point tip: Tip
         point tool: Tip
         point rocker/frame: Ground
         point other: Tip
         point coupler/rocker: Joint
         link crank: crank/frame, pin
         link coupler: pin, tip, tool, coupler/rocker
         link rocker: rocker/frame, other, coupler/rocker",
    );
}

#[test]
fn a_slide_has_a_guide_on_the_frame() {
    let items = "param crank = 40mm; param rod = 120mm; param offset = 5mm;
        input phi = 30deg in 0deg..360deg; unknown theta = -10deg; unknown slide = 150mm;";
    let expected = "
        point crank/frame: Ground
        point crank/rod: Joint
        point rod/slide: Joint
        point guide of slide: Construction
        link crank: crank/frame, crank/rod
        link rod: crank/rod, rod/slide
        guide slide: rod/slide from guide of slide, on frame";
    let written = "loop polar(crank, phi) + polar(rod, theta) = (slide, offset);";
    expect(&format!("{items} {written}"), "picture()", expected);
    let turned = "loop polar(crank, phi) + polar(rod, theta) = rotate((slide, offset), 20deg);";
    expect(&format!("{items} {turned}"), "picture()", expected);
}

#[test]
fn guides_belong_to_links_or_turn_by_themselves() {
    let crank = "param crank = 40mm; param base = (0mm, -80mm); input phi = 30deg in 0deg..360deg;
        unknown theta = 70deg; unknown s = 100mm; let pin = polar(crank, phi);";
    expect(
        &format!("{crank} loop base + polar(s, theta) = pin;"),
        "picture()",
        "point crank/frame: Ground
         point pin: Joint
         point base: Ground
         link crank: crank/frame, pin
         guide s: pin from base, on itself",
    );
    expect(
        &format!(
            "{crank} loop base + rotate((s, 5mm), theta) = pin; let tip = base + polar(150mm, theta);"
        ),
        "picture()",
        "point crank/frame: Ground
         point pin: Joint
         point base: Ground
         point tip: Tip
         point guide of s: Construction
         link crank: crank/frame, pin
         link theta: base, tip, guide of s
         guide s: pin from guide of s, on theta",
    );
}

#[test]
fn a_line_may_be_an_equation() {
    expect(
        "param crank = 40mm; param rod = 120mm; param foot = (0mm, 5mm); input phi = 30deg in 0deg..360deg;
         unknown q = (150mm, 20mm);
         loop distance(q, polar(crank, phi)) = rod; loop dot(q - foot, dir(95deg)) = 0;",
        "picture()",
        "point q: Joint
         point crank/frame: Ground
         point crank/rod: Joint
         point foot: Construction
         link crank: crank/frame, crank/rod
         link rod: q, crank/rod
         guide q: q from foot, on frame",
    );
}

#[test]
fn a_cylinder_hangs_on_its_fixed_end() {
    expect(
        "param arm = 500mm; param foot = (100mm, -300mm); input phi = 450mm in 430mm..600mm;
         unknown psi = 0deg; loop distance(polar(arm, psi), foot) = phi;",
        "picture()",
        "point arm/frame: Ground
         point arm/phi: Joint
         point foot: Ground
         link arm: arm/frame, arm/phi
         cylinder phi: arm/phi from foot, on itself",
    );
}

#[test]
fn bodies_and_joints_are_links_and_points() {
    expect(
        "param crank = 30mm; param rod = 120mm; input phi = 30deg in 0deg..360deg;
         unknown theta = -10deg; unknown x = 140mm;
         let p = polar(crank, phi); let q = p + polar(rod, theta); loop q = (x, 0);
         let centre = p + polar(rod / 2, theta) + polar(4mm, theta + 90deg);
         body wheel = pin a on frame at (0, 0), turns phi;
         body link = pin b on wheel at p, turns theta, mass 200g at centre;
         body piston = slide c on frame at q along (1, 0), mass 1kg at q;
         pin d = link on piston at q;",
        "picture()",
        "point a: Ground
         point p: Joint
         point q: Joint
         link wheel: a, p
         link link: p, q
         guide x: q from a, on frame",
    );
}

#[test]
fn space_has_axes() {
    expect(
        "param crank = 30mm; param rod = 150mm; param foot = (60mm, 40mm, -30mm);
         input phi = 0deg in 0deg..360deg; unknown s = 115mm;
         let pin = turn((crank, 0, 0), (0, 0, 1), phi);
         let along = (cos(25deg), 0, sin(25deg)); let slide = foot + s * along;
         loop distance(pin, slide) = rod;",
        "picture()",
        "point crank/frame: Ground
         point pin: Joint
         point foot: Construction
         point slide: Joint
         link crank: crank/frame, pin
         link rod: pin, slide
         guide s: slide from foot, on frame
         axis in crank/frame: axis at crank/frame",
    );
}

#[test]
fn a_tool_in_a_frame_belongs_to_the_coupler() {
    let (unit, messages) = compile(
        "param crank = 40mm; input phi = 20deg in 0deg..360deg;
         let pin = (crank * cos(phi), crank * sin(phi), 0);
         let body = frame(pin, (1, 0, 0) * 1mm, (0, 0, 1)); let tip = point_in(body, (60mm, 0mm, 15mm));",
        "fn look(phi) -> Look { shape: picture() }",
    );
    assert!(messages.is_empty(), "{messages:?}");
    let picture = unit.picture.expect("a picture");
    assert_eq!(picture.links.len(), 2, "{picture}");
}

#[test]
fn the_user_adds_what_loops_do_not_tell() {
    let items = format!(
        "{FOUR_BAR} let p = polar(crank, phi); loop p + polar(coupler, theta) = (base, 0) + polar(rocker, psi);"
    );
    let with_tool = FOUR_BAR_PICTURE.replace("crank/coupler", "p").replace(
        "link coupler: p, coupler/rocker",
        "link coupler: p, end of coupler, coupler/rocker",
    );
    let (unit, messages) = compile(
        &items,
        "fn look(phi) -> Look { shape: picture([p, p + polar(9mm, theta + 90deg)]) }",
    );
    assert!(messages.is_empty(), "{messages:?}");
    let picture = unit.picture.expect("a picture").to_string();
    let links = |text: &str| -> Vec<String> {
        let own = text
            .lines()
            .map(str::trim)
            .filter(|line| line.starts_with("link"));
        own.map(str::to_owned).collect()
    };
    let (mut found, mut expected) = (links(&picture), links(&with_tool));
    found.sort();
    expected.sort();
    assert_eq!(found, expected, "{picture}");
}

/// A slotted lever of the plane beside a linkage in space: its guide is a direction in space, too.
#[test]
fn a_guide_of_the_plane_lies_in_space() {
    expect(
        "param r = 40mm; param pivot = (0mm, -100mm); param l12 = 30mm; param l43 = 70mm; param l23 = 130mm;
         input phi = 0deg in 0deg..360deg; unknown theta = 70deg; unknown slide = 125mm; unknown psi = 100deg;
         loop polar(r, phi) = pivot + polar(slide, theta);
         let p2 = (0mm, 0mm, 90mm) + turn((0, l12, 0), (1, 0, 0), phi);
         let p3 = (110mm, 30mm, 40mm) + turn((l43, 0, 0), (0, 0, 1), psi);
         loop distance(p2, p3) = l23;",
        "picture()",
        "point l12/frame: Ground
         point p2: Joint
         point l43/frame: Ground
         point p3: Joint
         point r/frame: Ground
         point r/slide: Joint
         point pivot: Ground
         link l12: l12/frame, p2
         link l43: l43/frame, p3
         link r: r/frame, r/slide
         link l23: p2, p3
         guide slide: r/slide from pivot, on itself
         axis in l12/frame: axis at l12/frame
         axis in l43/frame: axis at l43/frame
         axis in r/frame: axis at l43/frame
         axis in r/slide: axis at l43/frame
         axis in pivot: axis at l43/frame",
    );
}

#[test]
fn a_link_that_stretches_is_refused() {
    let items = format!(
        "{FOUR_BAR} let p = polar(crank, phi); let q = (base, 0) + polar(rocker, psi); loop p + polar(coupler, theta) = q;"
    );
    let stretched = "fn look(phi) -> Look { shape: picture([(base, 0), p]) }";
    expect_message(&items, stretched, "a link that stretches: from");
    let same = "fn look(phi) -> Look { shape: picture([p, polar(crank, phi)]) }";
    expect_message(&items, same, "these points are always at the same place");
    let fixed = "fn look(phi) -> Look { shape: picture([(base, 0), (0, 0)]) }";
    expect_message(&items, fixed, "this is no link, but the frame");
}

#[test]
fn a_picture_stands_alone() {
    let items = format!(
        "{FOUR_BAR} loop polar(crank, phi) + polar(coupler, theta) = (base, 0) + polar(rocker, psi);"
    );
    let within = "fn look(phi) -> Look { shape: 2 * picture() }";
    expect_message(&items, within, "`picture` within an expression");
    let derived = "fn look(phi) -> Look { shape: velocity(picture()) }";
    expect_message(&items, derived, "`picture` within an expression");
    let list = "fn look(phi) -> Look { shape: picture(crank) }";
    expect_message(&items, list, "expected a link, found no list");
    let short = "fn look(phi) -> Look { shape: picture([polar(crank, phi)]) }";
    expect_message(&items, short, "a link joins at least two points");
    let angle = "fn look(phi) -> Look { shape: picture([polar(crank, phi), theta]) }";
    expect_message(&items, angle, "a link joins points, found an angle");
    let twice =
        "fn look(phi) -> Look { shape: picture() } fn again(phi) -> Again { shape: picture() }";
    expect_message(&items, twice, "a mechanism has one picture");
}

#[test]
fn without_links_there_is_nothing_to_draw() {
    expect_message(
        "input phi = 0deg in 0deg..360deg; let psi = 2 * phi;",
        "fn look(phi) -> Look { psi, shape: picture() }",
        "there is nothing to draw",
    );
}

#[test]
fn other_functions_stay_as_they_are() {
    let items = format!(
        "{FOUR_BAR} let p = polar(crank, phi); loop p + polar(coupler, theta) = (base, 0) + polar(rocker, psi);
         let tip = p + polar(70mm, theta + 25deg);"
    );
    let motion = "fn motion(phi) -> Motion { tip, v: velocity(tip), a: acceleration(tip), e: sensitivity(tip), m: margin() }";
    let look = "fn look(phi) -> Look { shape: picture() }";
    let (alone, _) = compile(&items, motion);
    for functions in [format!("{motion} {look}"), format!("{look} {motion}")] {
        let (beside, messages) = compile(&items, &functions);
        assert!(messages.is_empty(), "{messages:?}");
        let find = |unit: &Unit| {
            let own = unit.functions.iter().find(|own| own.fields.len() == 5);
            let program = &own.expect("the function").called.program;
            let operations = program
                .instructions
                .iter()
                .map(|one| format!("{one:?}").split('(').next().map(str::to_owned));
            (program.outputs.clone(), operations.collect::<Vec<_>>())
        };
        assert_eq!(find(&beside), find(&alone));
    }
    assert!(alone.picture.is_none());
}

/// Points in which parts meet belong to both; cranks on one shaft are two links, and one that is called after the shaft is known by its points.
#[test]
fn parts_of_a_machine_have_what_they_bring_along() {
    let text = "
        struct Crank {
            unit mm;
            const pivot = (0mm, 0mm);
            param rod = 120mm;
            input phi = 30deg in 0deg..360deg;
            unknown s = 160mm;
            unknown theta = -10deg;
            let pin = pivot + polar(50mm, phi);
            loop pin + polar(rod, theta) = (s, 0mm);
            let slide = pin + polar(rod, theta);
        }
        struct M {
            unit mm;
            param arm = 30mm;
            input shaft = 30deg in 0deg..360deg;
            part one: Crank { phi = shaft };
            part two: Crank { phi = shaft + 90deg };
            let end = one.pin + polar(arm, one.theta);
        }
        impl M { fn look(shaft) -> Look { shape: picture() } }";
    let all = check_all(text.parse().expect("tokens"));
    let machine = all.into_iter().next_back().expect("the machine");
    assert!(machine.messages.is_empty(), "{:#?}", machine.messages);
    let picture = machine.unit.and_then(|own| own.picture);
    let picture = picture.expect("a picture").to_string();
    let parts: Vec<&str> = picture
        .lines()
        .filter(|line| line.starts_with("part "))
        .collect();
    let expected = [
        "part one: one.pivot, one.pin, one.slide, end; shaft, one.rod; one.s",
        "part two: one.pivot, two.pin, two.slide; two.phi, two.rod; two.s",
    ];
    assert_eq!(parts, expected, "\n{picture}");
}

/// Cranks of two parts that turn unlike each other are driven by the shaft, not by each other; those of one part are wheels.
#[test]
fn wheels_are_of_one_part() {
    let text = |second: &str| {
        format!(
            "
        struct Crank {{
            unit mm;
            param pivot = (0mm, 0mm);
            input phi = 30deg in 0deg..360deg;
            let pin = pivot + polar(50mm, phi);
        }}
        struct M {{
            unit mm;
            param far = (300mm, 0mm);
            input shaft = 30deg in 0deg..360deg;
            part one: Crank {{ phi = shaft }};
            {second}
        }}
        impl M {{ fn look(shaft) -> Look {{ shape: picture() }} }}"
        )
    };
    let gears = |second: &str| {
        let all = check_all(text(second).parse().expect("tokens"));
        let machine = all.into_iter().next_back().expect("the machine");
        let picture = machine.unit.and_then(|own| own.picture);
        picture.expect("a picture").gears.len()
    };
    assert_eq!(gears("let pin = far + polar(40mm, -2 * shaft);"), 1);
    assert_eq!(
        gears("part two: Crank { phi = -2 * shaft, pivot = far };"),
        0
    );
}

/// Pivots of two parts that happen to stand at one place, where no other dimensions close: they are two points, unless they are shared.
#[test]
fn pivots_of_coupled_parts_that_coincide_by_chance_are_two_points() {
    let pivots = |given: &str| {
        let text = format!(
            "
        struct Platform {{
            unit mm;
            param pivot = (0mm, 0mm);
            param right = (120mm, 0mm);
            param top = (60mm, 110mm);
            param crank = 40mm;
            param leg = 50mm;
            input phi = 60deg in 40deg..80deg;
            unknown tilt = 20deg;
            unknown leg_a = 20deg;
            unknown leg_b = 100deg;
            unknown leg_c = 290deg;
            let a = pivot + polar(crank, phi) + polar(leg, leg_a);
            loop a + polar(60mm, tilt) = right + polar(leg, leg_b);
            loop a + polar(60mm, tilt + 60deg) = top + polar(leg, leg_c);
        }}
        struct M {{
            unit mm;
            input shaft = 60deg in 50deg..70deg;
            part one: Platform {{ phi = shaft }};
            part two: Platform {{ phi = shaft + 5deg{given} }};
        }}
        impl M {{ fn look(shaft) -> Look {{ shape: picture() }} }}"
        );
        let all = check_all(text.parse().expect("tokens"));
        let machine = all.into_iter().next_back().expect("the machine");
        assert!(machine.messages.is_empty(), "{:#?}", machine.messages);
        let picture = machine.unit.and_then(|own| own.picture);
        let picture = picture.expect("a picture").to_string();
        let ground = picture
            .lines()
            .filter(|line| line.starts_with("point ") && line.ends_with("Ground"));
        ground.map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(pivots("").len(), 6, "{:?}", pivots(""));
    let shared = ", pivot = one.pivot, right = one.right, top = one.top";
    assert_eq!(pivots(shared).len(), 3, "{:?}", pivots(shared));
}
