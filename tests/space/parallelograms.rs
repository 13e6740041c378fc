//! Chains that move by their dimensions alone: Bennett's linkage, and parallelograms in a row.

use super::close;
use linkage::Vector2;
use linkage_interpreted::interpreted;

// A lamp on a double parallelogram: two in a row keep the shade as it is turned. Each has a third rod, which follows from the other two.

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

// Bennett's linkage: four skew hinges that move by their dimensions alone. One equation determines it, three more follow.

interpreted! {
    pub struct Bennett {
        unit mm;
        // Opposite links are equal, and the sines of their twists are as their lengths.
        param short = 40mm;
        param long = 60mm;
        input phi = 60deg in 20deg..160deg;
        unknown psi = -130deg;
        const z = (0, 0, 1);
        const x = (1, 0, 0);
        const small = 30deg;
        const large = asin(1.5 * sin(30deg));
        let across = turn(z, x, large);
        let first = turn((short, 0, 0), z, phi);
        let first_axis = turn(turn(z, x, small), z, phi);
        let second = (long, 0, 0) + turn((short, 0, 0), across, psi);
        let second_axis = turn(turn(across, x, small), across, psi);
        loop distance(first, second) = long;
        loop dot(first_axis, second_axis) = cos(large) redundant;
        loop dot(first_axis, second - first) = 0 redundant;
        loop dot(second_axis, second - first) = 0 redundant;
    }
    impl Bennett {
        pub fn motion(phi) -> BennettMotion { psi, rate: velocity(psi), left: dot(first_axis, second_axis) - cos(large) }
    }
}

#[test]
fn half_angles_have_a_fixed_ratio() {
    let linkage = Bennett::default().assemble().expect("it assembles");
    let small = 30_f64.to_radians();
    let large = 0.75_f64.asin();
    // G. T. Bennett, "A new mechanism", Engineering 76, 1903.
    let ratio = (0.5 * (large + small)).sin() / (0.5 * (large - small)).sin();
    for k in 0..=14 {
        let phi = 20_f64.to_radians() + 0.17 * f64::from(k);
        let motion = linkage.motion(phi);
        close((0.5 * motion.psi).tan(), -ratio * (0.5 * phi).tan(), 1e-13);
        close(motion.left, 0.0, 1e-14);
        let slope = -ratio * (0.5 * motion.psi).cos().powi(2) / (0.5 * phi).cos().powi(2);
        close(motion.rate, slope, 1e-12);
    }
}
