// A press with a die cushion, with its masses.

linkage::mechanism! {
    /// A press with a vertical ram, on whose crank two masses may be fixed: along it, and across it.
    #[derive(Clone, Copy)]
    pub struct Press {
        unit mm;
        param crank  = 40mm;
        param rod    = 160mm;
        param offset = 8mm;
        param ahead  = 0kg;
        param across = 0kg;

        input phi = 30deg in 0deg..360deg at omega;
        unknown theta = -100deg;
        unknown ram   = -140mm;
        let p = polar(crank, phi);
        let q = p + polar(rod, theta);
        loop q = (offset, ram);

        gravity = (0, -9.80665m/s^2);
        body wheel = pin on frame at (0, 0), turns phi, mass 3kg at p / 2, inertia 4000kg*mm^2,
            mass ahead at polar(100mm, phi), mass across at polar(100mm, phi + 90deg);
        body link  = pin on wheel at p, turns theta, mass 2kg at p + polar(rod / 3, theta), inertia 5000kg*mm^2;
        body block = slide guide on frame at q along (0, 1), mass 12kg at q;
        pin knee = link on block at q;
        spring 6N/mm from block at q to frame at (offset, -400mm), free 300mm;
    }
    impl Press {
        /// The driving torque, with its derivatives by the crank's angle.
        pub fn drive(phi, omega) -> Drive {
            t: torque(phi), v: velocity(torque(phi)), a: acceleration(torque(phi)),
        }
        /// What the dimensions do to it.
        pub fn effects(phi, omega) -> Effects { e: sensitivity(torque(phi)) }
        /// The force of the guide on the ram, which is horizontal.
        pub fn side(phi, omega) -> Side {
            f: reaction(guide), v: velocity(reaction(guide)), a: acceleration(reaction(guide)), e: sensitivity(reaction(guide)),
        }
        /// The force on the foundation.
        pub fn shaking(phi, omega) -> Shaking {
            f: shaking_force(), v: velocity(shaking_force()), a: acceleration(shaking_force()), e: sensitivity(shaking_force()),
        }
        pub fn motion(phi) -> Motion { ram, v: velocity(ram), a: acceleration(ram), e: sensitivity(ram) }
        pub fn picture(phi) -> Picture { shape: picture() }
    }
}
