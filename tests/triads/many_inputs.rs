//! Groups of many inputs, and of ranges that no grid is fine enough for.

use linkage::{AssemblyError, CoupledCause};
use linkage_random::Random;

linkage_interpreted::interpreted! {
    /// Three cranks of a plate on legs of variable length: six inputs, and no dead point in their ranges.
    struct Six {
        unit mm;
        param s = 80mm;
        param g = 200mm;
        input f1 = 90deg in 75deg..105deg;
        input f2 = 210deg in 195deg..225deg;
        input f3 = 330deg in 315deg..345deg;
        input l1 = 90mm in 75mm..105mm;
        input l2 = 90mm in 75mm..105mm;
        input l3 = 90mm in 75mm..105mm;
        unknown x1 = 0deg;
        unknown x2 = 120deg;
        unknown x3 = 240deg;
        unknown t = 40deg;
        let e1 = polar(50mm, f1) + polar(l1, x1);
        loop e1 + polar(s, t) = (g, 0) + polar(50mm, f2) + polar(l2, x2);
        loop e1 + polar(s, t + 60deg) = polar(g, 60deg) + polar(50mm, f3) + polar(l3, x3);
    }

    impl Six { fn plate(f1, f2, f3, l1, l2, l3) -> SixPlate { e1, direction: dir(t) } }
}

linkage_interpreted::interpreted! {
    /// Two pivots that go around sixty times in the ranges of two inputs.
    struct Waves {
        unit mm;
        param wave = 1mm;
        input a = 0deg in -180deg..180deg;
        input b = 0deg in -180deg..180deg;
        unknown x1 = 58deg;
        unknown x2 = 133deg;
        unknown x3 = 200deg;
        unknown t = 40deg;
        let e1 = polar(wave, 60 * a) + polar(90mm, x1);
        loop e1 + polar(80mm, t) = (200mm, 0mm) + polar(wave, 60 * b) + polar(90mm, x2);
        loop e1 + polar(80mm, t + 60deg) = (100mm, 120mm) + polar(60mm, x3);
    }

    impl Waves { fn plate(a, b) -> WavesPlate { e1 } }
}

const HALF: f64 = 15.0 / 180.0 * std::f64::consts::PI;

#[test]
fn six_inputs() {
    let six = Six::default().assemble().expect("it closes");
    let mut random = Random::new(6);
    let mut served = 0;
    for _ in 0..1000 {
        let [f1, f2, f3] =
            [90.0, 210.0, 330.0].map(|at: f64| at.to_radians() + random.between(-HALF, HALF));
        let [l1, l2, l3] = [(); 3].map(|()| random.between(75.0, 105.0));
        served += usize::from(six.plate(f1, f2, f3, l1, l2, l3).e1.x.is_finite());
    }
    println!("{} {served}", six.served());
    assert!(served > 990 && six.served() > 0.99);
}

#[test]
fn ranges_that_would_be_left_out_are_refused() {
    let waves = Waves::default().assemble().expect("small waves are served");
    assert!(waves.served() > 0.999);
    // Polynomials do not follow so many waves: four steps do.
    let method = Waves::structure().groups[0].method;
    assert_eq!(
        method,
        "prepared states, fixed number of Newton steps, certificate"
    );
    let refused = Waves { wave: 15.0 }.assemble();
    let error = refused.expect_err("there are no cells for so many waves");
    let AssemblyError::Coupled(own) = &error else {
        panic!("{error}");
    };
    let CoupledCause::LeavesOut { share, example } = &own.cause else {
        panic!("{error}");
    };
    assert!(*share > 0.01 && *share <= 1.0, "{share}");
    assert_eq!(
        example.0.iter().map(|own| own.name).collect::<Vec<_>>(),
        ["a", "b"]
    );
    assert!(
        example
            .0
            .iter()
            .all(|own| own.value.abs() <= std::f64::consts::PI)
    );
    assert!(error.to_string().contains("this is a limit of linkage"));
}
