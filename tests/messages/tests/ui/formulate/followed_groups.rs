//! Groups whose assemblies cannot be listed, and which are not found from their estimates.

use linkage::mechanism;

// Nothing says where the upper arm is.
mechanism! {
    pub struct WithoutEstimate {
        unit mm;
        input travel = 0mm in -10mm..10mm;
        unknown low = 0deg;
        unknown high;
        unknown rod = (-135mm, 695mm, 258mm);
        unknown wheel = (0mm, 770mm, 320mm);
        let lower = (170mm, 380mm, 225mm) + turn((-160mm, 335mm, -25mm), (-360, 20, -10), low);
        let upper = (95mm, 455mm, 505mm) + turn((-107mm, 225mm, 15mm), (-220, 25, -15), high);
        loop distance(lower, upper) = 322.66mm;
        loop distance(rod, lower) = 157.45mm;
        loop distance(rod, upper) = 289.95mm;
        loop distance(rod, (-125mm, 422mm, 267mm)) = 273.33mm;
        loop distance(wheel, lower) = 132.38mm;
        loop distance(wheel, upper) = 219.65mm;
        loop distance(wheel, rod) = 166.01mm;
        loop wheel.z = 320mm + travel;
    }
    impl WithoutEstimate {
        pub fn wheel(travel) -> Wheel1 { wheel }
    }
}

// The first rod is too short.
mechanism! {
    pub struct OutOfReach {
        unit mm;
        input travel = 0mm;
        unknown p = (0mm, 760mm, 320mm);
        unknown x = (1, 0, 0);
        unknown y = (0, 1, 0);
        let z = cross(x, y);
        loop norm(x) = 1;
        loop norm(y) = 1;
        loop dot(x, y) = 0;
        loop p.z = 320mm + travel;
        loop distance(p + 15mm * x - 70mm * y + 135mm * z, (110mm, 420mm, 430mm)) = 87mm;
        loop distance(p - 30mm * x - 75mm * y + 140mm * z, (-85mm, 435mm, 440mm)) = 257mm;
        loop distance(p + 40mm * x - 60mm * y - 105mm * z, (265mm, 480mm, 265mm)) = 319mm;
        loop distance(p - 25mm * x - 55mm * y - 120mm * z, (-60mm, 255mm, 215mm)) = 452mm;
        loop distance(p - 150mm * x - 70mm * y - 58mm * z, (-190mm, 316mm, 258mm)) = 376mm;
    }
    impl OutOfReach {
        pub fn wheel(travel) -> Wheel2 { p }
    }
}

// All rods are parallel and of one length.
mechanism! {
    pub struct ParallelRods {
        unit mm;
        input travel = 0mm;
        unknown p = (0mm, 760mm, 320mm);
        unknown x = (1, 0, 0);
        unknown y = (0, 1, 0);
        let z = cross(x, y);
        loop norm(x) = 1;
        loop norm(y) = 1;
        loop dot(x, y) = 0;
        loop p.z = 320mm + travel;
        loop distance(p + 15mm * x - 70mm * y + 135mm * z, (15mm, 390mm, 455mm)) = 300mm;
        loop distance(p - 30mm * x - 75mm * y + 140mm * z, (-30mm, 385mm, 460mm)) = 300mm;
        loop distance(p + 40mm * x - 60mm * y - 105mm * z, (40mm, 400mm, 215mm)) = 300mm;
        loop distance(p - 25mm * x - 55mm * y - 120mm * z, (-25mm, 405mm, 200mm)) = 300mm;
        loop distance(p - 150mm * x - 70mm * y - 58mm * z, (-150mm, 390mm, 262mm)) = 300mm;
    }
    impl ParallelRods {
        pub fn wheel(travel) -> Wheel3 { p }
    }
}

fn main() {}
