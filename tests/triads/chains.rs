//! Coupled groups behind each other, and behind angles that count their turns.

use linkage_interpreted::interpreted;
use std::f64::consts::TAU;

interpreted! {
    /// A platform hangs on another.
    struct Two {
        unit mm;
        param reach = 50mm;
        input phi = 60deg in 58deg..62deg;
        unknown tilt = 20deg;
        unknown leg_a = 20deg;
        unknown leg_b = 100deg;
        unknown leg_c = 290deg;
        unknown second = 20deg;
        unknown second_a = 20deg;
        unknown second_b = 100deg;
        unknown second_c = 290deg;
        let a = polar(40mm, phi) + polar(50mm, leg_a);
        loop a + polar(60mm, tilt) = (120mm, 0) + polar(50mm, leg_b);
        loop a + polar(60mm, tilt + 60deg) = (60mm, 110mm) + polar(50mm, leg_c);
        let b = a + polar(reach, second_a);
        loop b + polar(60mm, second) = (167mm, 17mm) + polar(reach, second_b);
        loop b + polar(60mm, second + 60deg) = (107mm, 127mm) + polar(reach, second_c);
    }
    impl Two {
        fn places(phi) -> Places { a, b }
    }
}

#[test]
fn an_assembly_of_the_first_group_alone_hides_no_other() {
    // With short legs, the second platform reaches the first in one of its assemblies only.
    for reach in [37.5, 38.0, 50.0] {
        let two = Two { reach };
        let chosen = two.assemble().expect("it closes").places(1.05);
        let all = two.assemblies().expect("they can be listed");
        let near = |one: &TwoAssembly| (one.places(1.05).b - chosen.b).norm() < 1e-9;
        assert!(all.iter().any(near), "{reach}: {} assemblies", all.len());
    }
}

interpreted! {
    /// A triad driven by half of an angle that turns fully.
    struct Geared {
        unit mm;
        param crank = 4mm;
        input phi = 60deg in 0deg..720deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        unknown tilt = 20deg;
        unknown leg_a = 20deg;
        unknown leg_b = 100deg;
        unknown leg_c = 290deg;
        loop polar(60mm, phi) + polar(50mm, theta) = (20mm, 0) + polar(55mm, psi);
        let a = (35mm, 35mm) + polar(crank, psi / 2) + polar(50mm, leg_a);
        loop a + polar(60mm, tilt) = (120mm, 0) + polar(50mm, leg_b);
        loop a + polar(60mm, tilt + 60deg) = (60mm, 110mm) + polar(50mm, leg_c);
    }
    impl Geared {
        fn motion(phi) -> Motion { psi, tilt, v: velocity(tilt) }
    }
}

#[test]
fn turns_of_an_angle_are_counted_before_a_group_that_needs_them() {
    let linkage = Geared::default().assemble().expect("it closes");
    let step = 1e-3;
    for row in 1..2000 {
        let phi = 2.0 * TAU * f64::from(row) / 2001.0;
        let [before, here, after] = [phi - step, phi, phi + step].map(|x| linkage.motion(x));
        let slope = (after.tilt - before.tilt) / (2.0 * step);
        assert!(
            (slope - here.v).abs() < 1e-5,
            "{phi}: {slope}, not {}",
            here.v
        );
    }
    let turns = linkage.motion(2.0 * TAU).psi - linkage.motion(0.0).psi;
    assert!((turns - 2.0 * TAU).abs() < 1e-12);
}
