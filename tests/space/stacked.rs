//! A point that is unknown together with two rockers: distances about one point are subtracted from each other.

use linkage::Vector3;
use linkage_interpreted::interpreted;

use super::{close, differences};

interpreted! {
    pub struct Stacked {
        unit mm;
        param l = 100mm;
        input h = 0mm in 0mm..5mm;
        unknown p = (40mm, 30mm, 80mm);
        unknown psi = 40deg;
        unknown chi = 120deg;
        let a = (0, 0, h) + 60mm * (cos(psi), 0, sin(psi));
        let b = (180mm, 10mm, 0) + 60mm * (cos(chi), 0.6 * sin(chi), 0.8 * sin(chi));
        loop distance(p, (0, 0, h)) = l;
        loop distance(p, (0, 70mm, 0)) = l;
        loop distance(p, a) = l;
        loop distance(b, p) = 1.2 * l;
        loop distance(a, b) = 1.1 * l;
    }

    impl Stacked {
        pub fn place(h) -> Place { p, a, b }
        pub fn motion(h) -> Motion { v: velocity(p), s: sensitivity(b) }
    }
}

#[test]
fn every_assembly_keeps_its_distances() {
    let assemblies = Stacked::default().assemblies().expect("they are listed");
    assert!(assemblies.len() >= 2);
    for assembly in assemblies {
        let place = assembly.place(0.0);
        let foot = Vector3::new(0.0, 70.0, 0.0);
        for (link, length) in [
            (place.p, 100.0),
            (place.p - foot, 100.0),
            (place.p - place.a, 100.0),
            (place.p - place.b, 120.0),
            (place.a - place.b, 110.0),
        ] {
            close(link.norm(), length, 1e-13);
        }
    }
}

#[test]
fn rates_are_differences() {
    let stacked = Stacked::default().assemble().expect("it assembles");
    let motion = stacked.motion(2.0);
    let changed = |l: f64| {
        let stacked = Stacked { l }.assemble().expect("it assembles");
        stacked.place(2.0).b
    };
    let slope = (changed(100.0 + 1e-4) - changed(100.0 - 1e-4)) / 2e-4;
    for axis in 0..3 {
        let [v, _] = differences(|h| stacked.place(h).p[axis], 2.0, 1e-4);
        close(motion.v[axis], v, 1e-7);
        close(motion.s[0][axis], slope[axis], 1e-6);
    }
}

interpreted! {
    /// The same, driven by the length of a rod between the rockers.
    pub struct Driven {
        unit mm;
        param l = 100mm;
        input rod = 110mm in 109mm..111mm;
        unknown p = (40mm, 30mm, 80mm);
        unknown psi = 40deg;
        unknown chi = 120deg;
        let a = 60mm * (cos(psi), 0, sin(psi));
        let b = (180mm, 10mm, 0) + 60mm * (cos(chi), 0.6 * sin(chi), 0.8 * sin(chi));
        loop distance(p, (0, 0, 0)) = l;
        loop distance(p, (0, 70mm, 0)) = l;
        loop distance(p, a) = l;
        loop distance(b, p) = 1.2 * l;
        loop distance(a, b) = rod;
    }

    impl Driven {
        pub fn rods(rod) -> Rods { between: distance(a, b), v: velocity(p), p }
    }
}

#[test]
fn a_driven_length_is_kept() {
    // Estimates grow with the links that are not driven.
    for l in [100.0, 100.2] {
        let driven = Driven { l }.assemble().expect("it assembles");
        for rod in [109.2, 110.0, 110.7] {
            let rods = driven.rods(rod);
            close(rods.between, rod, 1e-13);
            for axis in 0..3 {
                let [v, _] = differences(|x| driven.rods(x).p[axis], rod, 1e-4);
                close(rods.v[axis], v, 1e-7);
            }
        }
    }
}
