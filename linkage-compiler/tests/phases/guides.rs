//! Bodies on several guides: what the guides give without the rest is solved by itself.

use linkage_engine::Mechanism;

/// Roundings of a mechanism of some hundred millimetres.
const ROUNDING: f64 = 1e-12 * 300.0;

/// A body with two pins on parallel guides, which a crank moves.
const LINKED: &str = "
    joint o = (0mm, 0mm), a = (10mm, 17.320508075688775mm);
    joint b = (90mm, 30mm), y = (110mm, 20mm), e = (150mm, 45mm);
    link frame: o;
    link crank: o, a at phi length 20mm;
    link rod: a, b length 81mm;
    link tool: b, y, e;
    slider g: y on frame along 0deg;
    slider h: e on frame along 0deg;";

/// The same by loops. The first loop alone has the slide of the second pin.
const LOOPS: &str = "
    let a = polar(20mm, phi);
    unknown g = 110mm; unknown turned = 0deg; unknown h = 150mm; unknown alpha = 9deg;
    let y = (g, 20mm);
    let b = y - rotate((20mm, -10mm), turned);
    let e = y + rotate((40mm, 25mm), turned);
    loop e = (h, 45mm);
    loop b = a + polar(81mm, alpha);";

#[test]
fn parallel_guides_give_the_angle_of_a_body() {
    for items in [LINKED, LOOPS] {
        let text = format!(
            "pub struct M {{ unit mm; input phi = 60deg in 0deg..360deg; {items} }}
             impl M {{ pub fn position(phi) -> Position {{ a, b, y, e }} }}"
        );
        let mechanism = Mechanism::compile(&text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let compiled = mechanism.compiled();
        let coupled = compiled.groups.iter().filter(|group| group.coupled);
        assert_eq!(coupled.count(), 0, "{text}");
        // The angle is constant. What is left is a slider-crank, and the other slide.
        let count = compiled.functions[0].called.count.total();
        assert!(count <= 22, "{count} operations: {text}");
        let assembly = mechanism.assemble(&mechanism.dimensions());
        let assembly = assembly.unwrap_or_else(|error| panic!("{text}: {error}"));
        for step in 0..24 {
            let phi = f64::from(step) * std::f64::consts::PI / 12.0;
            let [ax, ay, bx, by, yx, yy, ex, ey] = assembly.call(0, &[phi])[..] else {
                panic!("four points: {text}");
            };
            let misses = [
                (bx - ax).hypot(by - ay) - 81.0,
                (yx - bx) - 20.0,
                (yy - by) + 10.0,
                (ex - yx) - 40.0,
                yy - 20.0,
                ey - 45.0,
            ];
            let near = misses.iter().all(|miss| miss.abs() < ROUNDING);
            assert!(near, "{misses:?} at {phi}: {text}");
        }
    }
}
