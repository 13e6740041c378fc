//! A point that is unknown together with two rockers: distances about one point are subtracted from each other.

use linkage::{Vector3, mechanism};

use super::{close, differences};

mechanism! {
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
