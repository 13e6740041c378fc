// The hook-needle drive of the Favorit warp-knitting machine, with its masses.

linkage::mechanism! {
    /// The two-crank drive of the hook needle, with masses.
    pub struct Favorit {
        unit mm;

        param pivot_1 = (0mm, 0mm);
        param pivot_4 = (5mm, 150mm);
        param pivot_7 = (112.5mm, 3.5mm);
        param l12 = 5mm;
        param l23 = 46.5mm;
        param l34 = 123mm;
        param l45 = 13.5mm;
        param l78 = 10mm;
        param l89 = 160mm;
        param angle_345 = -62.5deg;
        param angle_456 = 90deg;
        param start_78 = 60deg;

        input phi12 = -90deg in -90deg..630deg at omega;
        let phi78 = start_78 - (phi12 + 90deg) / 2;

        // Main crank, coupler and rocker.
        unknown phi23 = 48deg;
        unknown phi43 = -78deg;
        let p2 = pivot_1 + polar(l12, phi12);
        let p3 = p2 + polar(l23, phi23);
        loop p3 = pivot_4 + polar(l34, phi43);

        // The guide, fixed on the rocker.
        let phi45 = phi43 + angle_345;
        let phi56 = phi45 + angle_456;
        let p5 = pivot_4 + polar(l45, phi45);

        // Second crank, rod and slider; the needle points back along the guide.
        unknown phi89 = 134deg;
        unknown slide = 18mm;
        let p8 = pivot_7 + polar(l78, phi78);
        let p9 = p8 + polar(l89, phi89);
        loop p9 = p5 + polar(slide, phi56);
        let phi910 = phi56 + 180deg;

        // Masses, moments of inertia about the pivots and the centres of mass, and the latter's places.
        param m1 = 129.94g;   param i1 = 31114.78g*mm^2;    param r1 = 1.32mm;
        param m2 = 91.15g;    param i2 = 49663.7g*mm^2;     param r2 = 12.96mm;
        param m3 = 2388.95g;  param i3 = 8352890.86g*mm^2;  param r3 = 50.56mm;  param angle_3 = 14.08deg;
        param m4 = 165.48g;   param i4 = 50362.38g*mm^2;    param r4 = 2.36mm;
        param m5 = 481.9g;    param i5 = 2093364.67g*mm^2;  param r5 = 47.84mm;
        param m6 = 4905.36g;  param i6 = 48083553.35g*mm^2; param r6 = 53.45mm;  param angle_6 = 6.34deg;
        let c1 = pivot_1 + polar(r1, phi12);
        let c2 = p2 + polar(r2, phi23);
        let c3 = pivot_4 + polar(r3, phi43 + angle_3);
        let c4 = pivot_7 + polar(r4, phi78);
        let c5 = p8 + polar(r5, phi89);
        let c6 = p9 + polar(r6, phi910 + angle_6);

        gravity = (0, -9.80665m/s^2);
        body crank_1 = pin b1 on frame at pivot_1, turns phi12, mass m1 at c1, inertia i1 at pivot_1;
        body coupler = pin b2 on crank_1 at p2, turns phi23, mass m2 at c2, inertia i2;
        body rocker = pin b4 on frame at pivot_4, turns phi43, mass m3 at c3, inertia i3;
        body crank_7 = pin b7 on frame at pivot_7, turns phi78, mass m4 at c4, inertia i4 at pivot_7;
        body rod = pin b8 on crank_7 at p8, turns phi89, mass m5 at c5, inertia i5;
        body slider = slide b11 on rocker at p9 along dir(phi56), turns phi910, mass m6 at c6, inertia i6;
        pin b3 = coupler on rocker at p3;
        pin b9 = rod on slider at p9;

        // By how much a weight is larger than that of the mass that resists acceleration: 0, but for the publication.
        param lift_5 = 0N;
        param lift_6 = 0N;
        force (0, lift_5) on rod at c5;
        force (0, lift_6) on slider at c6;

        // Places for counterweights on both cranks: 30 mm from the pivot, along the crank and across it.
        param along_1 = 0g;
        param across_1 = 0g;
        param along_7 = 0g;
        param across_7 = 0g;
        body weights_1 = fixed on crank_1 at pivot_1,
            mass along_1 at pivot_1 + polar(30mm, phi12), mass across_1 at pivot_1 + polar(30mm, phi12 + 90deg);
        body weights_7 = fixed on crank_7 at pivot_7,
            mass along_7 at pivot_7 + polar(30mm, phi78), mass across_7 at pivot_7 + polar(30mm, phi78 + 90deg);
    }

    impl Favorit {
        /// The reactions of all joints and the driving torque, at a constant speed.
        pub fn forces(phi12, omega) -> Forces {
            r1: reaction(b1), r2: reaction(b2), r3: reaction(b3), r4: reaction(b4),
            r7: reaction(b7), r8: reaction(b8), r9: reaction(b9), r11: reaction(b11),
            torque: torque(phi12),
        }

        /// The accelerations that the forces come from.
        pub fn accelerations(phi12) -> Accelerations {
            a1: acceleration(c1), a2: acceleration(c2), a3: acceleration(c3),
            a4: acceleration(c4), a5: acceleration(c5), a6: acceleration(c6),
            e23: acceleration(phi23), e43: acceleration(phi43), e89: acceleration(phi89),
        }

        /// What the drive puts in, and the energy that takes it up: its slope is that by the crank angle.
        pub fn energy(phi12, omega) -> Energy {
            power: power(),
            slope: d(kinetic_energy() + potential_energy(), phi12),
        }

        /// The equation of motion of the main crank, and the energies that check it.
        pub fn motion(phi12, omega) -> Motion {
            inertia: inertia(phi12), bias: bias(phi12), force: generalised_force(phi12),
            kinetic: kinetic_energy(), potential: potential_energy(),
        }

        /// What a page draws, and computes with.
        pub fn picture(phi12) -> Picture { shape: picture() }

        /// What the machine's bed feels, and what counterweights of 1 kg would add to it.
        pub fn shaking(phi12, omega) -> Shaking {
            force: shaking_force(), moment: shaking_moment(),
            effects: sensitivity(shaking_force(), [along_1, across_1, along_7, across_7]),
        }
    }
}
