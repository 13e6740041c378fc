//! A lamp on a double parallelogram: two in a row keep the shade as it is turned. Each has a third rod, which follows from the other two.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::close;

interpreted! {
    pub struct Lamp {
        unit mm;
        param lower = 300mm;
        param upper = 250mm;
        param foot = (40mm, 12mm);
        param head = (-15mm, 45mm);
        input phi = 60deg in 20deg..150deg;
        input psi = 20deg in -60deg..80deg;
        unknown knee = 0deg;
        unknown rod = 60deg;
        unknown shade = 0deg;
        unknown far_rod = 20deg;
        let joint = polar(lower, phi);
        loop joint + rotate(foot, knee) = foot + polar(lower, rod);
        let top = joint + polar(upper, psi);
        loop top + rotate(head, shade) = joint + rotate(head, knee) + polar(upper, far_rod);
        // Spare rods: of the lower one the length, of the upper one both ends.
        loop distance(joint + rotate((70mm, -20mm), knee), (70mm, -20mm)) = lower redundant;
        loop top + rotate((30mm, 10mm), shade) = joint + rotate((30mm, 10mm), knee) + polar(upper, psi) redundant;
        loop shade = 0deg redundant;
    }
    impl Lamp {
        pub fn motion(phi, psi) -> Motion {
            top, knee, rod, shade, far_rod, left: distance(joint + rotate((70mm, -20mm), knee), (70mm, -20mm)) - lower,
        }
    }
}

#[test]
fn the_shade_stays_as_it_is_turned_and_spare_rods_hold() {
    let lamp = Lamp::default().assemble().expect("it assembles");
    for k in 0..=26 {
        // Between the positions in which a parallelogram is flat.
        let phi = (22.0 + 4.7 * f64::from(k)).to_radians();
        let psi = (-55.0 + 5.1 * f64::from(k)).to_radians();
        let motion = lamp.motion(phi, psi);
        let top = Vector2::new(
            300.0 * phi.cos() + 250.0 * psi.cos(),
            300.0 * phi.sin() + 250.0 * psi.sin(),
        );
        close((motion.top - top).norm(), 0.0, 1e-12);
        for (found, known) in [
            (motion.knee, 0.0),
            (motion.rod, phi),
            (motion.shade, 0.0),
            (motion.far_rod, psi),
        ] {
            close(found, known, 1e-13);
        }
        close(motion.left, 0.0, 1e-12);
    }
}
