//! Joints on the axis about which they turn, loops that an angle does not change.

use linkage::mechanism;

mechanism! {
    pub struct OnTheAxis {
        unit mm;
        param arm = (0mm, 30mm, 0mm);
        input phi = 30deg;
        unknown psi = 10deg;
        let pin = turn((20mm, 0, 0), (0, 0, 1), phi);
        loop distance(pin, (60mm, 0mm, 0mm) + turn(arm, (0, 1, 0), psi)) = 50mm;
    }
    impl OnTheAxis {
        pub fn angle(phi) -> RockerAngle { psi }
    }
}

mechanism! {
    pub struct OtherEndOnTheAxis {
        unit mm;
        param high = 20mm;
        unknown psi = 10deg;
        loop distance((0mm, 0mm, high), turn((30mm, 0mm, 0mm), (0, 0, 1), psi)) = 50mm;
    }
    impl OtherEndOnTheAxis {
        pub fn angle() -> RockerAngle2 { psi }
    }
}

mechanism! {
    pub struct UniversalJoint {
        param pin = (0, 1, 1);
        input phi = 70deg;
        unknown psi = 10deg;
        loop dot(turn((1, 0, 0), (0, 0, 1), phi), turn(pin, (0, 1, 1), psi)) = 0;
    }
    impl UniversalJoint {
        pub fn angle(phi) -> OutputAngle { psi }
    }
}

mechanism! {
    pub struct ConstantJoint {
        input phi = 70deg;
        unknown psi = 10deg;
        let pin = turn((0, 1, 1), (0, 1, 1), psi);
        loop dot(turn((1, 0, 0), (0, 0, 1), phi), pin) = 0;
    }
    impl ConstantJoint {
        pub fn angle(phi) -> OutputAngle2 { psi }
    }
}

fn main() {}
