//! No loop, no input, no parameter, no function, nothing; several mechanisms in one module.

#![deny(warnings)]

use linkage::mechanism;

mechanism! {
    pub struct Gears {
        param ratio = -20 / 60;
        input phi = 0deg in 0deg..3600deg;
        let driven = ratio * phi;
        let mark = dir(driven);
    }

    impl Gears {
        pub fn angles(phi) -> Angles { driven, mark, v: velocity(driven) }
    }
}

mechanism! {
    /// A truss: two bars on two supports.
    pub struct Truss {
        unit mm;
        param left = 60mm;
        param right = 80mm;
        unknown alpha = 40deg;
        unknown beta = 130deg;
        loop polar(left, alpha) = (100mm, 0) + polar(right, beta);
        let top = polar(left, alpha);
    }

    impl Truss {
        pub fn top() -> Top { top, e: sensitivity(top, [left, right]), m: margin() }
    }
}

mechanism! {
    pub struct Fixed {
        unit mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        loop polar(40mm, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi);
    }

    impl Fixed {
        pub fn angle(phi) -> FixedAngle { psi }
    }
}

mechanism! {
    pub struct Silent {
        param crank = 3;
    }
}

mechanism! {
    pub struct Empty {}
    impl Empty {}
}

fn main() {
    let gears = Gears::default().assemble().expect("no loop");
    assert!((gears.angles(3.0).driven + 1.0).abs() < 1e-15);
    let truss = Truss::default().assemble().expect("it closes");
    let top = truss.top();
    assert!((top.top.x - 36.0).abs() < 1e-12 && (top.top.y - 48.0).abs() < 1e-12);
    assert!((top.m - 1.0).abs() < 1e-12);
    assert_eq!(Truss::default().assemblies().expect("it closes").len(), 2);
    assert!(Fixed::PARAMETERS.is_empty());
    assert!(
        Fixed::default()
            .assemble()
            .expect("it closes")
            .angle(0.3)
            .psi
            .is_finite()
    );
    assert_eq!(Silent::default().crank, 3.0);
    assert!(Silent::default().assemble().is_ok() && Empty::default().assemble().is_ok());
}
