//! A loop of two components of a vector of space: the picture does not know where it lies.
#![deny(warnings)]

use linkage::mechanism;

mechanism! {
    struct Press {
        unit mm;
        param arm = 60mm;
        param pivot = (100mm, 30mm, 80mm);
        param push = 90mm;
        input psi = 100deg in 80deg..120deg;
        unknown y = 160mm;
        unknown alpha = 120deg;
        unknown z = 150mm;
        let ball = pivot + turn((0, arm, 0), (1, 0, 0), psi);
        loop distance(ball, (20mm, 30mm, z)) = push + 20mm;
        loop (ball.y, ball.z) + polar(push, alpha) = (0, y) + (20mm, 0);
    }
    impl Press {
        fn picture(psi) -> Picture { shape: picture() }
    }
}

fn main() {}
