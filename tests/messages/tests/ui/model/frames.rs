//! Where a frame cannot stand, and what it cannot be made of.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param crank = 50mm;
        param place = (10mm, 20mm, 30mm);
        param start = frame((0, 0, 0), (1, 0, 0), (0, 0, 1));
        input phi = 30deg;
        unknown angle = 10deg;
        let pin = polar(crank, phi);
        let flat = frame(pin, (1, 0, 0), (0, 0, 1));
        let nowhere = frame((1, 2, 3), (1, 0, 0), (0, 0, 1));
        let body = frame(place, (cos(phi), sin(phi), 0), (0, 0, 1));
        let sum = body + place;
        let part = body.w;
        let swapped = point_in(place, body);
        let number = point_in(body, (1, 2, 3));
        loop body = frame(place, (cos(angle), sin(angle), 0), (0, 0, 1));
    }

    impl M {
        fn derivatives(phi) -> Derivatives { v: velocity(body), e: sensitivity(body), d: d(body, crank) }
    }
}

fn main() {}
