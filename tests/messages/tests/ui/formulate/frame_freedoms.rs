//! Bodies on rods that leave them free to move: how, and which rods do not hold.

use linkage::mechanism;

mechanism! {
    /// Five rods, the upper four in one plane.
    pub struct FourInAPlane {
        unit mm;
        input travel = 0mm in -5mm..5mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        loop distance(point_in(carrier, (15mm, -70mm, 135mm)), (110mm, 420mm, 455mm)) = 352.8mm;
        loop distance(point_in(carrier, (-30mm, -75mm, 135mm)), (-85mm, 435mm, 455mm)) = 256.0mm;
        loop distance(point_in(carrier, (40mm, -60mm, 135mm)), (265mm, 480mm, 455mm)) = 314.8mm;
        loop distance(point_in(carrier, (-25mm, -55mm, 135mm)), (-60mm, 255mm, 455mm)) = 451.4mm;
        loop distance(point_in(carrier, (-150mm, -70mm, -58mm)), (-190mm, 316mm, 258mm)) = 376.2mm;
        loop carrier.origin.z = 320mm + travel;
    }
    impl FourInAPlane {
        pub fn wheel(travel) -> Wheel { carrier }
    }
}

mechanism! {
    /// Five rods, parallel.
    pub struct Parallel {
        unit mm;
        input travel = 0mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        loop distance(point_in(carrier, (15mm, -70mm, 135mm)), (15mm, 390mm, 455mm)) = 300mm;
        loop distance(point_in(carrier, (-30mm, -75mm, 140mm)), (-30mm, 385mm, 460mm)) = 300mm;
        loop distance(point_in(carrier, (40mm, -60mm, -105mm)), (40mm, 400mm, 215mm)) = 300mm;
        loop distance(point_in(carrier, (-25mm, -55mm, -120mm)), (-25mm, 405mm, 200mm)) = 300mm;
        loop distance(point_in(carrier, (-150mm, -70mm, -58mm)), (-150mm, 390mm, 262mm)) = 300mm;
        loop carrier.origin.z = 320mm + travel;
    }
    impl Parallel {
        pub fn wheel(travel) -> Wheel2 { carrier }
    }
}

mechanism! {
    /// One rod too short.
    pub struct Short {
        unit mm;
        input travel = 0mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        loop distance(point_in(carrier, (15mm, -70mm, 135mm)), (110mm, 420mm, 430mm)) = 87mm;
        loop distance(point_in(carrier, (-30mm, -75mm, 140mm)), (-85mm, 435mm, 440mm)) = 257mm;
        loop distance(point_in(carrier, (40mm, -60mm, -105mm)), (265mm, 480mm, 265mm)) = 319mm;
        loop distance(point_in(carrier, (-25mm, -55mm, -120mm)), (-60mm, 255mm, 215mm)) = 452mm;
        loop distance(point_in(carrier, (-150mm, -70mm, -58mm)), (-190mm, 316mm, 258mm)) = 376mm;
        loop carrier.origin.z = 320mm + travel;
    }
    impl Short {
        pub fn wheel(travel) -> Wheel3 { carrier }
    }
}

mechanism! {
    /// A body whose rods all end on one line.
    pub struct OneAxis {
        unit mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        loop distance(point_in(carrier, (-100mm, 0mm, 100mm)), (-100mm, 500mm, 420mm)) = 260mm;
        loop distance(point_in(carrier, (100mm, 0mm, 100mm)), (100mm, 500mm, 420mm)) = 260mm;
        loop distance(point_in(carrier, (100mm, 0mm, 100mm)), (300mm, 760mm, 420mm)) = 200mm;
        loop distance(point_in(carrier, (100mm, 0mm, 100mm)), (100mm, 700mm, 200mm)) = 228.0350850198276mm;
        loop distance(point_in(carrier, (0mm, 0mm, 100mm)), (50mm, 650mm, 230mm)) = 225.6102834535700mm;
        loop distance(point_in(carrier, (-100mm, 0mm, 100mm)), (-100mm, 700mm, 200mm)) = 228.0350850198276mm;
    }
    impl OneAxis {
        pub fn wheel() -> Wheel4 { carrier }
    }
}

fn main() {}
