//! Structs of one call, and parts that cannot be read.

use linkage::mechanism;

mechanism! {
    struct Crank {
        input phi = 0deg;
        let tip = polar(12mm, phi);
    }
    struct Crank {
        input psi = 0deg;
    }
    struct Machine {
        input shaft = 0deg;
        part first = Crank { phi = shaft };
        part second: Crank(phi = shaft);
        part third: Crank { phi: shaft };
        part fourth: Crank { phi = shaft } about (0, 0);
        part fifth: Crank { phi = shaft } turned by;
        part: Crank { phi = shaft };
        part sixth: Crank { phi = shaft; };
    }
    impl Machin {
        fn tip(shaft) -> Tip { tip: first.tip }
    }
    impl Crane {
        fn tip(phi) -> CraneTip { tip }
    }
}

fn main() {}
