// A knuckle-joint press with friction in its pins and in the guide of its ram.

linkage::mechanism! {
    /// A crank moves the knuckle `k`, and the two links from there press the ram down against the load.
    pub struct TogglePress {
        unit mm;
        param mu = 0.1;                      // of all pins and of the guide
        argument load = 50kN;
        input phi = 120deg in 0deg..360deg at omega;

        joint top = (0mm, 0mm), o = (-260mm, -215mm), p = (-275mm, -189mm), k = (-45mm, -195mm);
        joint r = (0mm, -390mm), tool = (0mm, -450mm);
        link frame: top, o;
        link crank: o, p at phi length 30mm, mass 8kg at o, inertia 40000kg*mm^2;
        link rod: p, k length 230mm, mass 6kg at (p + k) / 2, inertia 30000kg*mm^2;
        link upper: top, k length 200mm, mass 9kg at (top + k) / 2, inertia 40000kg*mm^2;
        link lower: k, r length 200mm, mass 9kg at (k + r) / 2, inertia 40000kg*mm^2;
        link ram: r, tool, mass 60kg at tool;
        slider guide: r on frame along 90deg through top, block ram;

        gravity = (0, -9.80665m/s^2);
        force (0N, load) on ram at tool;
        friction mu on o, radius 20mm;
        friction mu on p, radius 15mm;
        friction mu on top, radius 25mm;
        friction mu on k_upper, radius 25mm;
        friction mu on k_lower, radius 25mm;
        friction mu on r, radius 25mm;
        friction mu on guide, length 150mm;
    }
    impl TogglePress {
        /// Torque of the crank in N*mm, the stroke of the tool, and the force in its upper bearing.
        pub fn forces(phi, omega, load) -> Forces { t: torque(phi), tool, bearing: reaction(top) }
        /// Power that becomes heat, in N*mm/s, and the efficiency.
        pub fn losses(phi, omega, load) -> Losses { heat: friction_power(), eta: efficiency() }
        /// The motion that the load makes.
        pub fn free(phi, omega, load) -> Free { epsilon: driven_acceleration(phi), j: inertia(phi) }
        /// Effect of the coefficient on the torque.
        pub fn effect(phi, omega, load) -> Effect { t: sensitivity(torque(phi), [mu]) }
        pub fn shape(phi) -> Shape { shape: picture() }
    }
}
