//! Sarrus' linkage: two legs of three parallel hinges each, in different planes, guide a plate straight. Five of the six equations of its closed
//! chain determine it, the last one follows.

use linkage::Vector3;
use linkage_interpreted::interpreted;

use super::close;

interpreted! {
    /// The legs' planes go through the axis of z, at 70 degrees to each other. With these lengths two other assemblies, mirror images of each
    /// other, meet at the reference.
    pub struct Sarrus {
        unit mm;
        param foot = 90mm;
        param lower = 70mm;
        param upper = 80mm;
        param plate = 85mm;
        input phi = 60deg in 20deg..85deg;
        // Of the first leg's upper link and of its plate, then of the links and the plate of the second one.
        unknown first = 140deg;
        unknown tilt = 0deg;
        unknown second = 60deg;
        unknown third = 140deg;
        unknown lean = 0deg;
        const x = (1, 0, 0);
        const y = (0, 1, 0);
        const z = (0, 0, 1);
        const out = turn(x, z, 70deg);
        const hinge = turn(y, z, 70deg);
        let knee = foot * x + lower * turn(x, -y, phi);
        let top = knee + upper * turn(x, -y, first);
        let other_top = foot * out + lower * turn(out, -hinge, second) + upper * turn(out, -hinge, third);
        // The plate's directions by one leg and by the other.
        let plate_x = turn(x, -y, tilt);
        let plate_z = turn(z, -hinge, lean);
        let plate_y = turn(y, -hinge, lean);
        let middle = top - plate * plate_x;
        loop middle = other_top - plate * turn(out, -hinge, lean);
        loop dot(y, plate_z) = 0;
        loop dot(plate_x, plate_z) = 0;
        loop dot(plate_x, plate_y) = 0 redundant;
    }
    impl Sarrus {
        pub fn motion(phi) -> Motion {
            middle, rise: velocity(middle), tilt, lean, second, third, left: dot(plate_x, plate_y),
        }
    }
}

/// Lengths of the upper links: that at whose reference others meet, its neighbours, and those far from it.
const UPPER: [f64; 6] = [80.0, 80.0 - 1e-9, 80.0 + 1e-4, 80.3, 78.0, 90.0];

#[test]
fn the_plate_goes_straight_and_the_last_equation_holds() {
    for upper in UPPER {
        let linkage = Sarrus {
            upper,
            ..Sarrus::default()
        };
        let linkage = linkage.assemble();
        let linkage = linkage.unwrap_or_else(|error| panic!("{upper}: {error}"));
        for k in 0..=13 {
            let phi = (20.0 + 5.0 * f64::from(k)).to_radians();
            compare(&linkage.motion(phi), phi, upper);
        }
    }
}

fn compare(motion: &Motion, phi: f64, upper: f64) {
    // In the plane of a leg: the plate's hinge is 85 from the axis, the lower link 70 long.
    let across = 90.0 + 70.0 * phi.cos() - 85.0;
    let root = (upper * upper - across * across).sqrt();
    let height = 70.0 * phi.sin() + root;
    close(
        (motion.middle - Vector3::new(0.0, 0.0, height)).norm(),
        0.0,
        2e-13,
    );
    let slope = 70.0 * phi.cos() + across * 70.0 * phi.sin() / root;
    close(
        (motion.rise - Vector3::new(0.0, 0.0, slope)).norm(),
        0.0,
        1e-12,
    );
    // Both legs do the same.
    close(motion.second, phi, 1e-14);
    let angle = root.atan2(-across);
    close(motion.third, angle, 1e-14);
    for nothing in [motion.tilt, motion.lean, motion.left] {
        close(nothing, 0.0, 1e-15);
    }
}
