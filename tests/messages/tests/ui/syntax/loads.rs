//! Mistakes in loads, springs and dampers.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 30deg;
        let p = polar(10mm, phi);
        gravity (0, -9.81m/s^2);
        body crank = pin j on frame at (0, 0), turns phi;
        force (0, 3N) on crank;
        force f = (0, 3N) on crank at p;
        torque 3N*mm crank;
        torque 3N*mm on crank at p;
        spring 2N/mm from frame to crank at p;
        spring 2N/mm from frame at (0, 0);
        spring 2N*mm on j, length 20deg;
        damper 3N*mm*s
        mass 3kg at p;
        force (0, 3N) onn crank at p + 3mm^2;
    }
}

fn main() {}
