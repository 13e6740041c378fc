//! Guides of slides, on the frame and on links, and cylinders.

use super::expect;

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
fn a_point_by_a_formula_slides_on_nothing() {
    let items = "param arm = 40mm; input phi = 30deg in 0deg..360deg;";
    let formula = "let c = (5mm, arm * sin(phi)); let e = polar(arm * cos(phi), 20deg);";
    let loose = "point c: Loose
        point e: Loose";
    expect(&format!("{items} {formula}"), "picture()", loose);
    // A length that drives is written, and so is the guide.
    expect(
        "param arm = 40mm; input phi = 30mm in 0mm..50mm; let c = (phi, arm);",
        "picture()",
        "point guide of phi: Construction
         point c: Joint
         guide phi: c from guide of phi, on frame",
    );
    // The formula of a point at which a loop closes is that of a cam.
    expect(
        "param arm = 40mm; input phi = 30deg in 0deg..360deg; unknown theta = 80deg;
         unknown psi = 150deg; let c = (0, arm * sin(phi));
         loop c + polar(120mm, theta) = (90mm, 60mm) + polar(100mm, psi);",
        "picture()",
        "point guide of arm: Construction
         point c: Joint
         point theta/psi: Joint
         point psi/frame: Ground
         link theta: c, theta/psi
         link psi: psi/frame, theta/psi
         guide arm: c from guide of arm, on frame",
    );
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

/// Loops may keep a cylinder in line with a slot of the frame or of a link. A driven length along
/// a direction that is written is a slot itself.
#[test]
fn a_cylinder_may_be_in_line_with_a_slot() {
    expect(
        "input phi = 80mm in 70mm..110mm; unknown theta = 10deg; unknown t = 80mm;
         let end = polar(phi, theta); loop end = (t, 0mm);",
        "picture()",
        "point phi/frame: Ground
         point end: Joint
         cylinder phi: end from phi/frame, on itself
         guide t: end from phi/frame, on frame",
    );
    expect(
        "input phi = 80mm in 70mm..110mm; param l = 150mm; param n = 85mm;
         unknown theta = 30deg; unknown psi = 30deg; unknown t = 80mm;
         let end = polar(phi, theta); loop end = polar(t, psi);
         let tip = polar(l, psi); loop distance(end, (140mm, 0mm)) = n;",
        "picture()",
        "point l/phi/frame: Ground
         point end: Joint
         point tip: Tip
         point n/frame: Ground
         link l: l/phi/frame, tip
         link n: end, n/frame
         cylinder phi: end from l/phi/frame, on itself
         guide t: end from l/phi/frame, on l",
    );
    expect(
        "input phi = 80mm in 70mm..110mm; unknown theta = 30deg; loop theta = 30deg;
         let end = polar(phi, theta);",
        "picture()",
        "point guide of phi: Construction
         point end: Joint
         guide phi: end from guide of phi, on frame",
    );
}

/// The bar of the loop becomes a slot, and is left out unless it is listed.
#[test]
fn an_arc_is_a_slot_in_place_of_a_bar() {
    let items = "param crank = 30mm; param rod = 90mm; param r = 70mm; param c = (110mm, 0mm);
        input phi = 30deg in 0deg..360deg; unknown psi = 20deg; unknown theta = 120deg;
        let o = polar(crank, phi); let p = o + polar(rod, psi); loop p = c + polar(r, theta);";
    let slot = "point crank/frame: Ground
        point o: Joint
        point p: Joint
        point c: Construction
        link crank: crank/frame, o
        link rod: o, p
        arc slot: p from c, on frame";
    expect(&format!("{items} arc slot: p around c;"), "picture()", slot);
    expect(
        &format!("{items} arc slot: c around p turned by psi;"),
        "picture([c, p])",
        "point crank/frame: Ground
         point o: Joint
         point p: Joint
         point c: Ground
         link r: c, p
         link crank: crank/frame, o
         link rod: o, p
         arc slot: c from p, on rod",
    );
}
