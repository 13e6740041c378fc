//! What happens in a part of a mechanism that is sound alone.

use linkage::mechanism;

mechanism! {
    pub struct Press {
        unit mm;
        param crank = 30mm;
        param rod = 80mm;
        input phi = 40deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown ram = 100mm;
        loop polar(crank, phi) + polar(rod, theta) = (ram, 0);
    }
    /// The rod is too short for the crank.
    struct Short {
        unit mm;
        input shaft = 0deg in 0deg..360deg;
        part press: Press { phi = shaft, rod = 25mm };
        let way = press.ram;
    }
    impl Short {
        fn way(shaft) -> ShortWay { way }
    }
    /// A press is asked for a position that it does not reach.
    struct Inverse {
        unit mm;
        input way = 120mm;
        unknown phi = 30deg;
        part press: Press { phi = phi };
        loop press.ram = way;
    }
    impl Inverse {
        fn angle(way) -> Angle { phi }
    }
    /// Two parts say one thing.
    struct Repeated {
        unit mm;
        input shaft = 30deg;
        part press: Press { phi = shaft };
        part other: Press { phi = shaft };
        loop press.ram = other.ram;
    }
    impl Repeated {
        fn way(shaft) -> RepeatedWay { way: press.ram }
    }
}

fn main() {}
