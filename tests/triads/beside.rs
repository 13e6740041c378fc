//! A reference of several inputs shortly before a dead point, at which the ranges end.

use linkage::{AssemblyError, CoupledCause};

linkage_interpreted::interpreted! {
    /// Two cranks and a fixed pivot hold a plate; the first crank's angle begins at an offset.
    struct Held {
        unit mm;
        param o1 = 90deg;
        input f1 = 0deg in -5deg..0deg;
        input f2 = -1deg in -1deg..1deg;
        unknown x1 = 0deg;
        unknown x2 = 120deg;
        unknown x3 = 240deg;
        unknown t = 40deg;
        let e1 = polar(50mm, f1 + o1) + polar(90mm, x1);
        let e2 = (200mm, 0mm) + polar(50mm, f2 + 210deg) + polar(90mm, x2);
        let e3 = polar(200mm, 60deg) + polar(50mm, 330deg) + polar(90mm, x3);
        loop e1 + polar(80mm, t) = e2;
        loop e1 + polar(80mm, t + 60deg) = e3;
    }

    impl Held { fn plate(f1, f2) -> Plate { e1, e2, e3, margin: margin() } }
}

/// The dead point, in degrees beyond the offset as declared.
const DEAD: f64 = 121.4517;

#[test]
fn a_reference_beside_a_dead_point() {
    let f2 = -1_f64.to_radians();
    for before in [0.05, 0.01, 0.001] {
        let held = Held {
            o1: (90.0 + DEAD - before).to_radians(),
        };
        // Over its ranges it cannot be prepared, and the reason is not that the reference is a dead point.
        match held.assemble() {
            Err(AssemblyError::Coupled(error)) => {
                let cause = &error.cause;
                let right = matches!(cause, CoupledCause::BesideDeadPoint(_));
                // So near to each other, both assemblies may be equally far from the estimates.
                let close = matches!(cause, CoupledCause::Ambiguous { .. });
                assert!(right || close && before < 0.01, "{before}: {cause}");
            }
            other => panic!("{before}: {other:?}"),
        }
        // For these inputs alone it can, all assemblies: the two that meet in the dead point among them.
        let all = held.assemblies().expect("they are listed");
        let plates: Vec<_> = all.iter().map(|one| one.plate(0.0, f2)).collect();
        assert!(plates.len() >= 2, "{plates:?}");
        for plate in &plates {
            let sides = [
                plate.e2 - plate.e1,
                plate.e3 - plate.e2,
                plate.e1 - plate.e3,
            ];
            let closed = sides.iter().all(|side| (side.norm() - 80.0).abs() < 1e-9);
            assert!(closed && plate.margin > 0.0, "{before}: {plate:?}");
        }
        let near = plates.iter().filter(|plate| plate.margin < 0.1).count();
        assert_eq!(near, 2, "{before}: {plates:?}");
    }
}
