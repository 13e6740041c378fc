//! Links: rods, plates, points of frames, lists of the user.

use super::{FOUR_BAR, FOUR_BAR_PICTURE, compile, expect};

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
            .any(|line| line.starts_with(&format!("link {link}")));
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
        let lines = text
            .lines()
            .map(str::trim)
            .filter(|line| line.starts_with("link"));
        lines.map(str::to_owned).collect()
    };
    let (mut found, mut expected) = (links(&picture), links(&with_tool));
    found.sort();
    expected.sort();
    assert_eq!(found, expected, "{picture}");
}
