//! What is not asked for of a frame is not computed.

use linkage::{Operations, Structure, mechanism};

use crate::Coupler;

mechanism! {
    pub struct Sliced {
        unit mm;
        param out = 30mm;
        input phi = 20deg;
        input s = 10mm;
        let origin = (s, 0, 40mm);
        let x = (s, 20mm * cos(phi), 30mm);
        let z = (sin(phi), 2, 1);
        let body = frame(origin, x, z);
    }

    impl Sliced {
        pub fn origin(s) -> SlicedOrigin { o: body.origin }
        pub fn plain_origin(s) -> SlicedPlainOrigin { o: origin }
        pub fn x(phi, s) -> SlicedX { x: body.x }
        pub fn unit_x(phi, s) -> SlicedUnit { x: unit(x) }
        pub fn on_x(phi, s) -> SlicedOnX { p: point_in(body, (out, 0, 0)) }
        pub fn on_x_plain(phi, s) -> SlicedOnXPlain { p: origin + out * unit(x) }
        pub fn z(phi, s) -> SlicedZ { z: body.z }
        pub fn whole(phi, s) -> SlicedWhole { body }
        pub fn height(phi, s) -> SlicedHeight { h: point_in(body, (out, out, out)).z }
        pub fn twice(phi, s) -> SlicedTwice { body, again: body, x: body.x, o: body.origin }
        pub fn at_origin(s) -> SlicedAtOrigin { p: point_in(body, 0), c: origin }
    }
}

fn cost(structure: &Structure, name: &str) -> Operations {
    let function = structure.functions.iter().find(|f| f.name == name);
    function.expect("the function is listed").operations
}

fn sliced(name: &str) -> Operations {
    cost(Sliced::STRUCTURE, name)
}

#[test]
fn parts_cost_what_they_need() {
    assert_eq!(sliced("origin").total(), 0);
    assert_eq!(sliced("at_origin").total(), 0);
    assert_eq!(sliced("origin"), sliced("plain_origin"));
    assert_eq!(sliced("x"), sliced("unit_x"));
    assert_eq!(sliced("on_x"), sliced("on_x_plain"));
    assert_eq!((sliced("x").sqrt, sliced("z").sqrt), (1, 2));
    assert!(sliced("height").total() < sliced("whole").total());
    assert_eq!(sliced("twice"), sliced("whole"));
}

#[test]
fn a_frame_of_the_plane_costs_its_angle() {
    let [body, by_hand] = ["body", "by_hand"].map(|name| cost(Coupler::STRUCTURE, name));
    // Minus the sine, that of a link with its length in it.
    assert!(body.mul <= by_hand.mul + 1);
    assert_eq!(
        Operations {
            mul: by_hand.mul,
            ..body
        },
        by_hand
    );
    assert_eq!(cost(Coupler::STRUCTURE, "constant").total(), 0);
}
