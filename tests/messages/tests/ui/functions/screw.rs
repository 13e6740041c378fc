//! The axis of a body at one moment: of a frame, by one input, in the plane a point.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 30deg;
        input lift = 20mm;
        let body = frame((0mm, 0mm, lift), (cos(phi), sin(phi), 0), (0, 0, 1));
    }

    impl M {
        pub fn both(phi, lift) -> Both { p: screw_point(body) }
        pub fn vector(phi) -> OfVector { p: screw_pitch(body.x) }
        pub fn nothing() -> Nothing { p: screw_direction(body) }
    }
}

mechanism! {
    pub struct Flat {
        unit mm;
        input phi = 30deg;
        let body = frame(polar(20mm, phi), dir(phi));
    }

    impl Flat {
        pub fn pitch(phi) -> Pitch { p: screw_pitch(body) }
    }
}

fn main() {}
