//! Bodies, joints and loads that make no sense.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param crank = 30mm;
        param s = 4mm;
        argument press = 500N;
        input phi = 30deg in 0deg..360deg at omega;
        let p = polar(crank, phi);
        gravity = (0, -9.80665m/s);
        body crank = pin b1 on frame at (0, 0), turns phi, mass 100mm at p / 2, inertia 3g*mm^2;
        body rod = pin on crnk at p, turns crank;
        body a = fixed on b at p;
        body b = fixed on a at p;
        slide b2 = rod on crank at p;
        pin b1 = rod on frame at p * (press / 1N);
        force (0, -press, 0N) on rod at p;
        torque 3N*mm on frame;
        spring 3N/mm on b1;
        damper 0.2N*s/mm from frame at (0, 0) to rod at p;
    }
    impl M {
        pub fn forces(phi, omega) -> Forces {
            f: reaction(rod),
            m: moment(b1),
            t: force(phi),
        }
        pub fn still(phi) -> Still {
            p: power(),
        }
    }
}

fn main() {}
