//! `picture()` stands alone, once; the links that it lists join points.

use linkage::mechanism;

mechanism! {
    struct FourBar {
        unit mm;
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        let pin = polar(crank, phi);
        loop pin + polar(coupler, theta) = (140mm, 0) + polar(rocker, psi);
    }
    impl FourBar {
        fn one(phi) -> One { shape: picture([pin, theta], [pin], crank) }
        fn two(phi) -> Two { shape: picture(), again: picture() }
        fn three(phi) -> Three { speed: velocity(picture()) }
    }
}

fn main() {
    let shape = FourBar::default().assemble().unwrap().two(1.0).shape;
    let _ = (shape[3].x, FourBar::PICTURE.points);
}
