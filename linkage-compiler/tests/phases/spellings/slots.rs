//! Pins in slots.

use super::{Pair, alike};

/// A bar on a crank and a rocker.
const BAR: &str = "input phi = 90deg in 90deg..450deg; input s = 230mm in 200mm..260mm;
    let a = (0mm, 100mm) + polar(20mm, phi);
    unknown tb = -2deg; unknown tr = 90deg;
    loop a + polar(250mm, tb) = (250mm, 20mm) + polar(80mm, tr);";

/// A plate on that bar, held by a rod.
const PLATE: &str = "unknown p = (60mm, 120mm); unknown t = -2deg;
    let q = p + rotate((30mm, 70mm), t);
    loop distance(q, (s, 60mm)) = 190mm;";

/// Half a turn of the plate is another assembly, of which the short spelling knows nothing.
fn pins(pins: &str, short: &str) {
    alike(&Pair {
        items: &format!("{BAR} {PLATE}"),
        drawn: pins,
        short,
        fields: "p, q",
        rate: "q",
        assemblies: [8, 4],
    });
}

#[test]
fn two_pins_of_one_plate_in_a_slot_give_its_angle() {
    let short = "loop dot(p - a, dir(tb + 90deg)) = 0; loop t = tb;";
    for drawn in [
        "loop dot(p - a, dir(tb + 90deg)) = 0; loop dot(p + polar(60mm, t) - a, dir(tb + 90deg)) = 0;",
        "loop dot(p - a, dir(tb + 90deg)) = 0; loop 0 = dot(a - p - polar(60mm, t), dir(tb + 90deg));",
        "loop dot(p - a, dir(tb + 90deg)) = 0; loop dot(dir(tb - 90deg), polar(60mm, t) + (p - a)) = 0;",
        "loop dot(p - a, dir(tb + 90deg)) = 0; loop dot(a + polar(60mm, t + 180deg) - p, dir(tb + 90deg)) = 0;",
        "loop dot(p - a, dir(tb + 90deg)) = 0; loop cross(dir(tb), p + polar(60mm, t) - a) = 0;",
        "loop dot(p - a, dir(tb + 90deg)) = 0; loop dot(p - a, dir(tb + 90deg)) = 60mm * sin(tb - t);",
        "loop dot(p - a, dir(tb + 90deg)) = 0; loop 2 * dot(p + polar(60mm, t) - a, dir(tb + 90deg)) = 0;",
    ] {
        pins(drawn, short);
    }
}

#[test]
fn pins_in_slots_of_all_places() {
    // The plate's own axes, and the slot at an angle to the bar.
    pins(
        "loop dot(p - a, dir(tb + 95deg)) = 0; loop dot(p + polar(60mm, t) - a, dir(tb + 95deg)) = 0;",
        "loop dot(p - a, dir(tb + 95deg)) = 0; loop t = tb + 5deg;",
    );
    pins(
        "loop dot(p - a, dir(tb + 90deg)) = 0; loop dot(p + rotate((60mm, 5mm), t) - a, dir(tb + 90deg)) = 0;",
        "loop dot(p - a, dir(tb + 90deg)) = 0; loop t = tb - atan(5 / 60);",
    );
    // A slot beside the pins' first one.
    pins(
        "loop dot(p - a, dir(tb + 90deg)) = 4mm; loop dot(p + polar(60mm, t) - a, dir(tb + 90deg)) = 4mm;",
        "loop dot(p - a, dir(tb + 90deg)) = 4mm; loop t = tb;",
    );
    // The slot on the crank, and on the frame.
    for (slot, angle) in [
        ("phi", "phi"),
        ("phi - 10deg", "phi - 10deg"),
        ("15deg", "15deg"),
    ] {
        alike(&Pair {
            items: &format!(
                "input phi = 30deg in 20deg..35deg; input s = 230mm in 220mm..240mm;
                 unknown p = (60mm, 40mm); unknown t = 40deg;
                 let q = p + rotate((30mm, 70mm), t);
                 loop distance(q, (s, 60mm)) = 190mm;
                 loop dot(p, dir({slot} + 90deg)) = 0;"
            ),
            drawn: &format!("loop dot(p + polar(60mm, t), dir({slot} + 90deg)) = 0;"),
            short: &format!("loop t = {angle};"),
            fields: "p, q, crank: polar(10mm, phi)",
            rate: "q",
            assemblies: [4, 2],
        });
    }
}

#[test]
fn a_pin_of_a_third_link_in_the_slot() {
    // The second pin is the end of a rod whose other end is a joint of the plate.
    alike(&Pair {
        items: &format!(
            "{BAR} {PLATE} unknown k = 32deg; unknown m = 82deg;
             let r = p + polar(60mm, t);
             loop dot(p - a, dir(tb + 90deg)) = 0;
             loop r + polar(70mm, k) = (150mm, 20mm) + polar(130mm, m);"
        ),
        drawn: "loop dot((150mm, 20mm) + polar(130mm, m) - polar(70mm, k) - a, dir(tb + 90deg)) = 0;",
        short: "loop t = tb;",
        fields: "p, q, r",
        rate: "r",
        assemblies: [10, 4],
    });
}

#[test]
fn several_plates_in_one_slot() {
    alike(&Pair {
        items: &format!(
            "{BAR} {PLATE} unknown p2 = (150mm, 105mm); unknown t2 = -2deg;
             let q2 = p2 + rotate((10mm, 60mm), t2);
             loop distance(q, q2) = 90mm;
             loop dot(p - a, dir(tb + 90deg)) = 0; loop dot(p2 - a, dir(tb + 90deg)) = 0;"
        ),
        drawn: "loop dot(p + polar(60mm, t) - a, dir(tb + 90deg)) = 0;
                loop dot(p2 + polar(40mm, t2) - a, dir(tb + 90deg)) = 0;",
        short: "loop t = tb; loop t2 = tb;",
        fields: "p, q, p2, q2",
        rate: "q2",
        assemblies: [16, 8],
    });
}

/// A slide for each pin: the loop of the second one gives its slide, which nothing else contains, and the angle.
#[test]
fn half_of_a_vector_loop_gives_a_slide_only() {
    for drawn in [
        "loop p = a + polar(s1, tb); loop p + polar(60mm, t) = a + polar(s2, tb);",
        "loop a - p + polar(s1, tb) = (0mm, 0mm); loop a + polar(s2, tb) - polar(60mm, t) = p;",
        "loop a + polar(s2, tb) = polar(60mm, t) + p; loop p - polar(s1, tb) = a;",
    ] {
        alike(&Pair {
            items: &format!("{BAR} {PLATE} unknown s1 = 60mm; unknown s2 = 120mm;"),
            drawn,
            short: "loop t = tb; loop p = a + polar(s1, tb); loop s2 = dot(p + polar(60mm, t) - a, dir(tb));",
            fields: "p, q, s1, s2",
            rate: "s2",
            assemblies: [8, 4],
        });
    }
}

/// A plate with a slot on two pins, one of them on a lever.
const SLOTTED: &str =
    "input stroke1 = 149mm in 125mm..190mm; input stroke2 = 189mm in 120mm..260mm;
    unknown k = 169deg;
    let c3 = (298mm, -240.75mm);
    let c4 = (398mm, -253mm) + polar(44.86mm, k);
    let c14 = (398mm, -253mm) + polar(45.04mm, k + 103.8deg);
    loop distance((549mm, -298mm), c14) = stroke1;
    unknown c0 = (240mm, -240mm); unknown t = 19deg;
    let c1 = c0 + polar(117.65mm, t);
    loop distance((538.5mm, -197mm), c1) = stroke2;";

#[test]
fn a_slot_of_one_plate_on_two_pins_gives_its_angle() {
    for (drawn, short) in [
        (
            "loop dot(c3 - c0, dir(t + 67deg)) = 0; loop dot(c4 - c0, dir(t + 67deg)) = 0;",
            "t + 67deg",
        ),
        (
            "loop dot(c0 - c3, dir(t + 67deg)) = 0; loop dot(c4 - c0, dir(t + 67deg)) = 0;",
            "t + 67deg",
        ),
        (
            "loop dot(c3 - c0, dir(t + 67deg)) = 0; loop 0 = dot(dir(t - 113deg), c4 - c0);",
            "t + 67deg",
        ),
        (
            "loop cross(c3 - c0, dir(t - 23deg)) = 0; loop cross(c4 - c0, dir(t - 23deg)) = 0;",
            "t + 67deg",
        ),
        (
            "loop dot(c3 - c0, dir(t + 67deg)) = 0; loop cross(dir(t - 23deg), c4 - c0) = 0;",
            "t + 67deg",
        ),
        (
            "loop dot(c4 - c0, dir(t + 67deg)) = 0; loop dot(c3 - c0, dir(t + 67deg)) = 0;",
            "t + 67deg",
        ),
    ] {
        alike(&Pair {
            items: SLOTTED,
            drawn,
            short: &format!(
                "loop dot(c3 - c0, dir({short})) = 0; loop dot(c4 - c3, dir({short})) = 0;"
            ),
            fields: "c0, c1, c4, angle: t",
            rate: "c1",
            assemblies: [8, 8],
        });
    }
}
