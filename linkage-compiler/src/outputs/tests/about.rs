//! Tests of the descriptions of quantities in docs.

use crate::check;

/// The words for each quantity of a function.
fn descriptions(items: &str, function: &str) -> Vec<String> {
    let text = format!("pub struct M {{ {items} }} impl M {{ pub fn f{function} }}");
    let checked = check(text.parse().expect("tokens"));
    let unit = checked.unit.expect("a mechanism without a mistake");
    let fields = unit.functions[0].fields.iter();
    fields
        .map(|field| format!("{}: {}", field.name, field.description()))
        .collect()
}

const CRANK: &str = "unit mm; param l = 40mm; param lift = 25deg; input phi = 40deg in 0deg..80deg;
    let p = polar(l, phi + lift);";

#[test]
fn derivatives_say_of_what_by_what_and_in_which_unit() {
    let descriptions = descriptions(
        CRANK,
        "(phi) -> F {
            p, x: p.x, twice: 2 * p.x - l, n: p.x / l,
            v: velocity(p), w: velocity(p.x - l), a: acceleration(p), j: jerk(p),
            s: sensitivity(p), one: sensitivity(p, [l]), c: sensitivity(velocity(p)),
            d: d(p, l), m: d(p.y, phi, lift), r: velocity(phi),
            speed: velocity(p.x) * 3, back: -velocity(p), left: -p.x, length: d(p.x, l) * l,
        }",
    );
    let expected = [
        "p: in mm",
        "x: `p.x`, in mm",
        "twice: `(2 * p.x) - l`, in mm",
        "n: `p.x / l`",
        "v: derivative of `p` by `phi`, in mm/rad",
        "w: derivative of `p.x - l` by `phi`, in mm/rad",
        "a: second derivative of `p` by `phi`, in mm/rad^2",
        "j: third derivative of `p` by `phi`, in mm/rad^3",
        "s: derivatives of `p` by each of `PARAMETERS`, in mm/mm and mm/rad",
        "one: derivatives of `p` by `l`, in mm/mm",
        "c: derivatives by each of `PARAMETERS` of the derivative of `p` by `phi`, in mm/(mm*rad) and mm/rad^2",
        "d: derivative of `p` by `l`, in mm/mm",
        "m: second derivative of `p.y` by `phi` and `lift`, in mm/rad^2",
        "r: derivative of `phi` by `phi`, in rad/rad",
        "speed: `velocity(p.x) * 3`",
        "back: `-velocity(p)`",
        "left: `-p.x`, in mm",
        "length: `d(p.x, l) * l`, in mm",
    ];
    assert_eq!(descriptions, expected);
}

#[test]
fn arrays_say_what_their_entries_are() {
    let items = "unit mm; param a = 1mm; param b = 2mm; param c = 3mm; param d = 4mm; param e = 5mm; param f = 6mm;
        input phi = 40deg; input s = 10mm; let p = polar(s + a + b + c + d + e + f, phi);";
    let descriptions = descriptions(
        items,
        "(phi, s) -> F { v: velocity(p), a: acceleration(p.x), s: sensitivity(p, [a, b, c]), t: sensitivity(p, [a, b, c, d, e]) }",
    );
    let expected = [
        "v: derivatives of `p` by `phi` and `s`, in mm/rad and mm/mm",
        "a: second derivatives of `p.x` by each two of `phi` and `s`, in mm/rad^2, mm/(mm*rad) and mm/mm^2",
        "s: derivatives of `p` by `a`, `b` and `c`, in mm/mm",
        "t: derivatives of `p` by 5 of `PARAMETERS`, in mm/mm",
    ];
    assert_eq!(descriptions, expected);
}
