//! Groups of space whose angle has a closed form.

use linkage_interpreted::interpreted;

use crate::follow::turns;

interpreted! {
    /// RSSR: a crank about one axis, a rocker about another.
    struct Rssr {
        param crank = 30mm;
        param coupler = 130mm;
        param rocker = 70mm;
        param pivot = (110mm, 30mm, -50mm);
        param tilt = 20deg;
        input phi = 0deg in -360deg..360deg;
        unknown psi = 100deg;
        let pin = turn((0, crank, 0), (1, 0, 0), phi);
        let axis = turn((0, 0, 1), (1, 0, 0), -tilt);
        let end = pivot + turn((rocker, 0, 0), axis, psi);
        loop distance(pin, end) = coupler;
    }
    impl Rssr {
        fn angles(phi) -> RssrAngles { psi, p: dir(psi) }
    }
}
turns!(rssr: Rssr [-360 0 360], 50, psi p 100);

interpreted! {
    /// A universal joint.
    struct Joint {
        param bend = 30deg;
        input phi = 20deg in -720deg..720deg;
        unknown psi = 20deg;
        let driver = (0, cos(phi), sin(phi));
        let driven = turn(turn((0, 1, 0), (1, 0, 0), psi + 90deg), (0, 0, 1), bend);
        loop dot(driver, driven) = 0;
    }
    impl Joint {
        fn angles(phi) -> JointAngles { psi, p: dir(psi) }
    }
}
turns!(universal_joint: Joint [-720 20 720], 50, psi p 20);
