//! Two platforms on a common pin: positions, and one of them over the whole cycle.

use crate::legs::turned;
use crate::newton;
use crate::platforms::Platforms;
use crate::{alike, effort};
use linkage_random::Random;
use std::f64::consts::TAU;

const REFERENCE: f64 = 30.0 / 180.0 * std::f64::consts::PI;
/// Loops are missed by less than this.
const ROUNDING: f64 = 4e-13;

linkage_interpreted::interpreted! {
    /// Two platforms.
    struct Six {
        unit mm;
        param crank = 10mm;
        param a2 = (109mm, 1mm);
        param a3 = (195mm, 20mm);
        param a4 = (105mm, 172mm);
        param l1 = 60mm;
        param l2 = 73mm;
        param l3 = 61mm;
        param l4 = 84mm;
        param b = 80mm;
        param c = 90mm;
        param at_c = 75deg;
        param d = 96mm;
        param e = 80mm;
        param at_e = 90deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 92deg;
        unknown x2 = -172deg;
        unknown x3 = -153deg;
        unknown x4 = -43deg;
        unknown one = -68deg;
        unknown two = -62deg;
        let e1 = polar(crank, phi) + polar(l1, x1);
        let pin = e1 + polar(c, one + at_c);
        loop e1 + polar(b, one) = a2 + polar(l2, x2);
        loop pin + polar(d, two) = a3 + polar(l3, x3);
        loop pin + polar(e, two + at_e) = a4 + polar(l4, x4);
    }

    impl Six {
        fn position(phi) -> SixPosition {
            e1, one: dir(one), two: dir(two),
            miss_1: e1 + polar(b, one) - a2 - polar(l2, x2),
            miss_2: pin + polar(d, two) - a3 - polar(l3, x3),
            miss_3: pin + polar(e, two + at_e) - a4 - polar(l4, x4),
        }
    }
}

fn platforms(m: &Six, phi: f64) -> Platforms {
    Platforms {
        pivots: [
            turned([m.crank, 0.0], phi),
            m.a2.into(),
            m.a3.into(),
            m.a4.into(),
        ],
        lengths: [m.l1, m.l2, m.l3, m.l4],
        ends: [
            [m.b, 0.0],
            turned([m.c, 0.0], m.at_c),
            [m.d, 0.0],
            turned([m.e, 0.0], m.at_e),
        ],
    }
}

#[test]
fn two_platforms_on_a_pin() {
    let pose = |assembly: &SixAssembly, phi: f64| {
        let p = assembly.position(phi);
        let misses = [p.miss_1, p.miss_2, p.miss_3].map(|miss| miss.norm());
        let angles = [p.one, p.two].map(|v| v.y.atan2(v.x));
        (
            [
                p.e1.x / Platforms::SIZE,
                p.e1.y / Platforms::SIZE,
                angles[0],
                angles[1],
            ],
            crate::largest(misses),
        )
    };
    let mut random = Random::new(22);
    let mut counts = [0; 19];
    for set in 0..6 * effort() {
        let m = Six::default();
        let [crank, l1, l2, l3, l4, b, c, d, e] = random.near(
            [m.crank, m.l1, m.l2, m.l3, m.l4, m.b, m.c, m.d, m.e],
            [0.0, 0.05, 0.2][set % 3],
        );
        let m = Six {
            crank,
            l1,
            l2,
            l3,
            l4,
            b,
            c,
            d,
            e,
            ..m
        };
        let phi = if set == 0 {
            REFERENCE
        } else {
            random.between(0.0, TAU)
        };
        let Some(poses) = platforms(&m, phi).poses() else {
            continue;
        };
        let found = m.assemblies_at(phi).expect("it can be listed");
        let places: Vec<_> = found.iter().map(|assembly| pose(assembly, phi)).collect();
        let listed = |expected: &[f64; 4]| {
            places
                .iter()
                .filter(|(at, _)| alike(expected, at, 1e-9))
                .count()
                == 1
        };
        let right = poses.len() == found.len() && poses.iter().all(listed);
        assert!(
            right,
            "{m:?} at {phi}: expected {poses:?}, found {places:?}"
        );
        assert!(
            places.iter().all(|(_, miss)| *miss < ROUNDING),
            "{places:?}"
        );
        counts[found.len()] += 1;
    }
    println!("two platforms with 0, 1, .. assemblies: {counts:?}");

    // Over the whole cycle as fine steps lead.
    let m = Six::default();
    let linkage = m.assemble().expect("it closes");
    let misses = |phi: f64, x: &[f64; 4]| platforms(&m, phi).misses(x);
    let (mut at, mut here) = (REFERENCE, pose(&linkage, REFERENCE).0);
    for step in 1..=60 {
        let next = REFERENCE + TAU * f64::from(step) / 60.0;
        here = newton::follow(&misses, here, (at, next)).expect("no turning point");
        at = next;
        let (found, miss) = pose(&linkage, next);
        assert!(
            alike(&found, &here, 1e-10) && miss < ROUNDING,
            "{found:?}, not {here:?}"
        );
    }
}
