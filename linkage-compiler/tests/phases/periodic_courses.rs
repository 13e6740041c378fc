//! Courses of laws that repeat after a period which is no turn.

use linkage_compiler::check_all;

use super::parts::{checked, defaults, results, unit};

const RACK: &str = "
    struct Rack {
        unit mm;
        param start = 2mm;
        param pitch = 10mm;
        param lift = 30deg;
        input x = 3mm;
        let teeth = piecewise(x, [
            (start, 5deg), (5mm, lift, modified_sine), (8mm, lift), (start + pitch, 5deg, poly345),
        ], periodic);
        let once = piecewise(x, [
            (start, 5deg), (5mm, lift, modified_sine), (8mm, lift), (start + pitch, 5deg, poly345),
        ]);
    }
    impl Rack {
        fn teeth(x) -> Teeth { s: teeth, v: velocity(teeth), a: acceleration(teeth), j: jerk(teeth) }
        fn once(x) -> Once { s: once, v: velocity(once), a: acceleration(once), j: jerk(once) }
        fn accuracy(x) -> Accuracy { e: sensitivity(teeth, [start, pitch, lift]) }
    }";

/// Periods later and earlier the same, with three derivatives, up to the rounding of the place.
#[test]
fn a_course_repeats_after_its_period() {
    let all = checked(RACK);
    let rack = unit(&all, "Rack");
    let own = |function: &str, x: f64| results(rack, function, &defaults(rack), &[x]);
    for step in 0..80 {
        // Thirds of eighths: at no knot, of which the rounding of the place tells the side.
        let x = 2.0 + (f64::from(step) + 1.0 / 3.0) / 8.0;
        let once = own("once", x);
        for periods in [-3.0, -1.0, 0.0, 1.0, 7.0] {
            let again = own("teeth", x + 10.0 * periods);
            for (again, once) in again.iter().zip(&once) {
                assert!(
                    (again - once).abs() < 1e-13,
                    "{again} and {once} at {x}, {periods} periods on"
                );
            }
        }
    }
    // At the knot where it begins anew, and next to it.
    let [seam, before] = [own("teeth", 12.0), own("teeth", 12.0 - 1e-6)];
    assert!((seam[0] - 5f64.to_radians()).abs() < 1e-15 && (before[0] - seam[0]).abs() < 1e-12);
}

/// A longer pitch moves what is periods away by so many times as much.
#[test]
fn the_period_may_be_a_parameter() {
    let all = checked(RACK);
    let rack = unit(&all, "Rack");
    for x in [-27.3, -5.1, 4.1, 10.9, 23.7, 90.4] {
        let found = results(rack, "accuracy", &defaults(rack), &[x]);
        for (index, (found, step)) in found.iter().zip([1e-5, 1e-5, 1e-5]).enumerate() {
            let at = |by: f64| {
                let mut dimensions = defaults(rack);
                dimensions[index] += by;
                results(rack, "teeth", &dimensions, &[x])[0]
            };
            let difference = (at(step) - at(-step)) / (2.0 * step);
            let size = difference.abs().max(1e-2);
            assert!(
                (found - difference).abs() < 1e-7 * size,
                "{found} and {difference}, {index} at {x}"
            );
        }
    }
}

#[test]
fn what_does_not_repeat_is_told() {
    let text = |course: &str| {
        let text = format!(
            "struct Rack {{ unit mm; input x = 3mm; let teeth = {course}; }}
            impl Rack {{ fn teeth(x) -> Teeth {{ teeth }} }}"
        );
        let all = check_all(text.parse().expect("tokens"));
        let messages = all
            .iter()
            .flat_map(|own| own.messages.iter().chain(&own.warnings));
        messages.map(|own| own.text.clone()).collect::<String>()
    };
    let misspelt =
        text("piecewise(x, [(0mm, 0mm), (4mm, 2mm, poly345), (9mm, 0mm, poly345)], perodic)");
    assert!(
        misspelt.contains("found `perodic`") && misspelt.contains("did you mean `periodic`?"),
        "{misspelt}"
    );
    let open =
        text("piecewise(x, [(0mm, 0mm), (4mm, 2mm, poly345), (9mm, 1mm, poly345)], periodic)");
    assert!(
        open.contains("from 1mm at 9mm to 0mm at 0mm, where it repeats"),
        "{open}"
    );
    let jumps =
        text("piecewise(x, [(0mm, 0mm), (4mm, 2mm, line, jump), (9mm, 0mm, poly345)], periodic)");
    assert!(
        jumps.contains("the speed of this course jumps at 9mm, from 0mm/mm to 0.5mm/mm"),
        "{jumps}"
    );
}
