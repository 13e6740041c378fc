//! Bennett's linkage: four skew hinges that move by their dimensions alone. One equation determines it, three more follow.

use linkage_interpreted::interpreted;

use super::close;

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
        pub fn motion(phi) -> Motion { psi, rate: velocity(psi), left: dot(first_axis, second_axis) - cos(large) }
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
