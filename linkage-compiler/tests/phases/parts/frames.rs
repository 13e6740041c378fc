//! Parts on bodies of others, placed and turned, in other units.

use super::{checked, defaults, results, results_of, unit};

const ARM: &str = "
    struct Arm {
        unit mm;
        param long = 40mm;
        input phi = 10deg in 0deg..360deg at omega;
        unknown psi = 20deg;
        loop psi = 2 * phi;
        let elbow = polar(long, phi);
        let tip = elbow + polar(25mm, psi);
        let along = dir(psi);
        body upper = pin shoulder on frame at (0, 0), turns phi, mass 2kg at elbow / 2;
        body lower = pin hinge on upper at elbow, turns psi, mass 1kg at tip, inertia 10kg*mm^2;
    }
    impl Arm {
        fn tip(phi) -> ArmTip { tip, along }
        fn forces(phi, omega) -> ArmForces { t: torque(phi), hinge: reaction(hinge) }
    }
    struct Pair {
        unit m;
        param way = 30mm;
        input turn = 0deg;
        part first: Arm { phi = turn };
        part second: Arm { phi = turn / 2, long = 2 * first.long } on first.lower at first.tip, turned by turn + 15deg;
        let both = second.tip - first.tip;
    }
    struct Whole {
        unit cm;
        input shaft = 30deg in 0deg..360deg at omega;
        part pair: Pair { turn = shaft } at (1cm, pair_lift), turned by 40deg;
        param pair_lift = 2cm;
        part beside: Arm { phi = shaft } at (50mm, 0), turned by 70deg;
    }
    impl Whole {
        fn tips(shaft) -> WholeTips {
            tip: pair.second.tip, along: pair.second.along, angle: pair.second.psi, both: pair.both, v: velocity(pair.second.tip.x),
            e: d(pair.second.tip, pair.first.long),
        }
        fn hinges(shaft, omega) -> WholeForces { beside: reaction(beside.hinge), inner: reaction(pair.second.hinge) }
    }";

/// Parts of parts, on each other's bodies, in other units: every frame by hand.
#[test]
fn parts_stand_in_frames() {
    let all = checked(ARM);
    let (arm, whole) = (unit(&all, "Arm"), unit(&all, "Whole"));
    let names: Vec<&str> = whole.scalars().map(|own| own.name.as_str()).collect();
    assert_eq!(
        names,
        ["pair_lift", "pair.way", "pair.first.long", "beside.long"]
    );
    let turned = |[x, y]: [f64; 2], angle: f64| {
        let (sin, cos) = angle.sin_cos();
        [cos * x - sin * y, sin * x + cos * y]
    };
    let tip = |long: f64, phi: f64| {
        let found = results(arm, "tip", &[long], &[phi]);
        ([found[0] / 10.0, found[1] / 10.0], [found[2], found[3]])
    };
    for step in 0..12 {
        let shaft = 0.1 + 0.5 * f64::from(step);
        let (first, _) = tip(40.0, shaft);
        let (second, along) = tip(80.0, shaft / 2.0);
        let inner = shaft + 15f64.to_radians();
        let outer = 40f64.to_radians();
        let way = turned(second, inner);
        let there = turned([first[0] + way[0], first[1] + way[1]], outer);
        let along = turned(along, inner + outer);
        let found = results(whole, "tips", &defaults(whole), &[shaft]);
        // A difference of points is a point by its type: that of the part's origin and the place of the part.
        let both = turned(way, outer);
        let expected = [
            1.0 + there[0],
            2.0 + there[1],
            along[0],
            along[1],
            shaft,
            1.0 + both[0],
            2.0 + both[1],
        ];
        for (found, expected) in found.iter().zip(expected) {
            assert!(
                (found - expected).abs() < 1e-12,
                "{found} and {expected} at {shaft}"
            );
        }
        let difference = |at: usize, dimension: usize, by: f64| {
            let mut all = [defaults(whole), defaults(whole)];
            let mut shafts = [shaft; 2];
            match dimension {
                usize::MAX => shafts = [shaft - by, shaft + by],
                _ => {
                    all[0][dimension] -= by;
                    all[1][dimension] += by;
                }
            }
            let ends = [0, 1].map(|k| results(whole, "tips", &all[k], &[shafts[k]])[at]);
            (ends[1] - ends[0]) / (2.0 * by)
        };
        for (at, by, of) in [(7, usize::MAX, 0), (8, 2, 0), (9, 2, 1)] {
            let expected = difference(of, by, 1e-5);
            assert!(
                (found[at] - expected).abs() < 1e-7,
                "{} and {expected}",
                found[at]
            );
        }
        // Without gravity a frame at rest turns what its joints transmit, and nothing else.
        let omega = 3.0;
        let alone = results_of(arm, "forces", &[40.0], &[shaft], &[omega]);
        let here = results_of(whole, "hinges", &defaults(whole), &[shaft], &[omega]);
        let hinge = turned([alone[1], alone[2]], 70f64.to_radians());
        for axis in 0..2 {
            assert!(
                (here[axis] - hinge[axis]).abs() < 1e-9 * hinge[axis].abs().max(1.0),
                "{here:?} {hinge:?}"
            );
        }
    }
}

/// A part of space in a frame: its points and directions along the axes of that frame.
#[test]
fn parts_of_space_stand_in_frames() {
    let text = "
        struct Arm { unit mm; param r = 20mm; input phi = 0deg; let tip = (r * cos(phi), r * sin(phi), 5mm); let up = (0, 0, 1); let own = frame(tip, (1, 0, 0), up); }
        struct Robot {
            unit mm;
            param base = (10mm, 20mm, 30mm);
            input q = 0deg; input p = 0deg;
            part first: Arm { phi = q } at base;
            part second: Arm { phi = p } at frame(first.tip, turn((1, 0, 0), (0, 0, 1), q), (0, 1, 0));
        }
        impl Robot { fn hand(q, p) -> Hand { tip: second.tip, up: second.up, origin: second.own.origin, z: second.own.z } }";
    let all = checked(text);
    let robot = unit(&all, "Robot");
    let (q, p): (f64, f64) = (0.3, 1.1);
    // x is as it is given, z is made square to it; y is z times x.
    let (sin, cos) = q.sin_cos();
    let [x, y, z] = [[cos, sin, 0.0], [0.0, 0.0, -1.0], [-sin, cos, 0.0]];
    let origin = [10.0 + 20.0 * q.cos(), 20.0 + 20.0 * q.sin(), 35.0];
    let own = [20.0 * p.cos(), 20.0 * p.sin(), 5.0];
    let tip: Vec<f64> = (0..3)
        .map(|k| origin[k] + own[0] * x[k] + own[1] * y[k] + own[2] * z[k])
        .collect();
    let expected = [&tip[..], &z, &tip, &z].concat();
    let found = results(robot, "hand", &defaults(robot), &[q, p]);
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() < 1e-12, "{found} and {expected}");
    }
}
