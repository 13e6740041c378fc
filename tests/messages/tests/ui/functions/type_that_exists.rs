use linkage::mechanism;

mechanism! {
    struct Crank {
        unit mm;
        param crank = 40mm;
        input phi = 40deg;
        let pin = polar(crank, phi);
    }
    impl Crank {
        fn height(phi) -> f64 { y: pin.y }
        fn pin(phi) -> Vector2 { pin }
    }
}

fn main() {}
