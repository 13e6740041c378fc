//! Mechanisms that are parts of themselves, beside one that only uses them.

use linkage::mechanism;

mechanism! {
    struct Own {
        input phi = 0deg;
        part own: Own { phi = phi };
    }
    struct First {
        input phi = 0deg;
        part second: Second { phi = phi };
    }
    struct Second {
        input phi = 0deg;
        part third: Third { phi = 2 * phi };
        let angle = phi + phy;
    }
    struct Third {
        input phi = 0deg;
        part first: First { phi = phi / 2 };
    }
    struct User {
        input phi = 0deg;
        part first: First { phi = phi };
        let angle = first.angle;
    }
    impl User {
        fn angle(phi) -> Angle { angle }
    }
}

fn main() {}
