//! Equations without a root, of what is no number for these dimensions.

use linkage::mechanism;

mechanism! {
    pub struct Arc {
        param k = 1;
        input phi = 30deg in 0deg..60deg;
        unknown t = 10deg;
        loop t = acos(k + 1) + phi;
    }
}

mechanism! {
    pub struct Quotient {
        unit mm;
        param k = 1;
        param m = 5mm;
        unknown t = 10deg;
        loop t = m / (1mm * (k - 1));
    }
}

mechanism! {
    pub struct Slide {
        unit mm;
        input phi = 30deg in 0deg..60deg;
        unknown t = 10deg;
        unknown m = 5mm;
        loop t = 2 * phi;
        loop m = 0 / 0 * t * 1mm;
    }
}

mechanism! {
    pub struct Point {
        unit mm;
        param crank = 50mm;
        unknown p = (10mm, 5mm);
        loop p = (sqrt(crank * (crank - 60mm)), 5mm);
    }
}

mechanism! {
    pub struct InTheRange {
        unit mm;
        param crank = 50mm;
        param reach = 40mm;
        input phi = 30deg in 0deg..60deg;
        unknown t = 50deg;
        loop t = asin(crank * sin(phi) / reach);
    }
}

mechanism! {
    pub struct AtTheReference {
        input phi = 30deg in 0deg..60deg;
        unknown t = 10deg;
        loop t = acos(2 * cos(phi));
    }
}

fn main() {}
