//! Groups of class III, IV and more, and a polynomial without a closed form.

use linkage::mechanism;

mechanism! {
    /// A ternary link on three legs behind a dyad.
    pub struct Triad {
        unit mm;
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        loop polar(40mm, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi);
        unknown a1 = -24deg;
        unknown a2 = 100deg;
        unknown a3 = 290deg;
        unknown a4 = 10deg;
        let a = polar(30mm, psi) + polar(50mm, a1);
        loop a + polar(60mm, a4) = (120mm, 0) + polar(50mm, a2);
        loop a + polar(60mm, a4 + 60deg) = (60mm, 110mm) + polar(50mm, a3);
    }

    impl Triad {
        pub fn link(phi) -> Link { a4, v: velocity(a4) }
    }
}

mechanism! {
    /// Two ternary links joined by two binary ones: a closed contour of four links.
    pub struct Contour {
        unit mm;
        param base = (200mm, 0);
        input phi = 60deg;
        unknown first = -60deg;
        unknown second = 160deg;
        unknown upper = 20deg;
        unknown lower = 10deg;
        let a = polar(40mm, phi);
        loop a + polar(60mm, first) + polar(100mm, upper) = base + polar(60mm, second);
        loop a + polar(50mm, first + 40deg) + polar(110mm, lower) = base + polar(50mm, second - 40deg);
    }

    impl Contour {
        pub fn links(phi) -> Links { first, second }
    }
}

mechanism! {
    /// Three coupled loops.
    pub struct ThreeLoops {
        unit mm;
        input phi = 60deg;
        unknown platform = -90deg;
        unknown a1 = 20deg;
        unknown a2 = 190deg;
        unknown a3 = 270deg;
        unknown b1 = 150deg;
        unknown b2 = -10deg;
        let a = polar(40mm, phi) + polar(50mm, a1);
        let b = a + polar(70mm, b1);
        loop a + polar(60mm, platform) = (120mm, 0) + polar(50mm, a2);
        loop b + polar(60mm, platform + 60deg) = (60mm, 110mm) + polar(50mm, a3);
        loop b + polar(20mm, b1 + 30deg) = (-60mm, 110mm) + polar(50mm, b2) + polar(10mm, platform);
    }

    impl ThreeLoops {
        pub fn turned(phi) -> Turned { platform }
    }
}

mechanism! {
    pub struct Cubic {
        unit mm;
        input phi = 60deg;
        unknown s = 1mm;
        loop s * s * s = 1mm * 1mm * 1mm * phi;
    }

    impl Cubic {
        pub fn root(phi) -> Root { s, v: velocity(s) }
    }
}

fn main() {
    let classes = [
        Triad::STRUCTURE.groups[1],
        Contour::STRUCTURE.groups[0],
        ThreeLoops::STRUCTURE.groups[0],
    ]
    .map(|group| (group.class, group.order));
    assert_eq!(classes, [(3, 3), (4, 2), (3, 4)]);

    let triad = Triad::default().assemble().expect("it closes").link(2.0);
    assert!(triad.a4.is_finite() && triad.v.is_finite());
    let contour = Contour::default().assemble().expect("it closes").links(1.0);
    assert!(contour.first.is_finite() && contour.second.is_finite());
    assert!(
        ThreeLoops::default()
            .assemble()
            .expect("it closes")
            .turned(1.0)
            .platform
            .is_finite()
    );

    let cubic = Cubic::default().assemble().expect("it closes").root(1.2);
    assert!((cubic.s.powi(3) - 1.2).abs() < 1e-15);
    assert!((3.0 * cubic.s * cubic.s * cubic.v - 1.0).abs() < 1e-14);
}
