// Andrews' squeezing mechanism, a test problem of multibody dynamics, with its masses, spring and motor.

linkage::mechanism! {
    /// Seven bodies that a motor with a constant torque turns against a spring; the crank turns about the origin.
    ///
    /// Names and numbers are those of the publication (Schiehlen, Multibody Systems Handbook, 1990; Hairer and Wanner,
    /// Solving Ordinary Differential Equations II), where the bodies have numbers.
    pub struct Andrews {
        unit m;

        // The fixed points A, B and C.
        param a = (-0.06934m, -0.00227m);
        param b = (-0.03635m, 0.03273m);
        param c = (0.014m, 0.072m);
        // Lengths between pins, and the places of the centres of mass.
        param rr = 0.007m;   param ra = 0.00092m;
        param d = 0.028m;    param da = 0.0115m;
        param ss = 0.035m;   param sa = 0.01874m;  param sb = 0.01043m;
        param sc = 0.018m;   param sd = 0.02m;
        param e = 0.02m;     param ea = 0.01421m;
        param zt = 0.04m;    param ta = 0.02308m;  param tb = 0.00916m;
        param zf = 0.02m;    param fa = 0.01421m;
        param u = 0.04m;     param ua = 0.01228m;  param ub = 0.00449m;
        param m1 = 0.04325kg;  param i1 = 2.194e-6kg*m^2;
        param m2 = 0.00365kg;  param i2 = 4.410e-7kg*m^2;
        param m3 = 0.02373kg;  param i3 = 5.255e-6kg*m^2;
        param m4 = 0.00706kg;  param i4 = 5.667e-7kg*m^2;
        param m5 = 0.07050kg;  param i5 = 1.169e-5kg*m^2;
        param m6 = 0.00706kg;  param i6 = 5.667e-7kg*m^2;
        param m7 = 0.05498kg;  param i7 = 1.912e-5kg*m^2;
        param stiffness = 4530N/m;
        param l0 = 0.07785m;

        argument mom = 0.033N*m;             // the motor
        input beta = -0.06171389rad in -360deg..1080deg at speed;

        // Three links meet in P: K2 from the crank, K4 and K6 from A. K3 from B closes the first loop. The publication
        // measures K2, K4 and K6 against the links before them: theta, phi and Omega.
        unknown k2 = -4deg;
        unknown gamma = 26deg;               // of K3
        let f = polar(rr, beta);
        let p = f - polar(d, k2);
        loop p = b + polar(ss, gamma - 90deg);
        unknown k4 = 41deg;
        unknown delta = 28deg;               // of K5
        let h = a + polar(zt, delta);
        loop p = h + polar(e, k4 - 90deg);
        unknown k6 = 58deg;
        unknown epsilon = 70deg;             // of K7
        let g = a + polar(u, epsilon - 90deg);
        loop p = g + polar(zf, k6);

        body k1 = pin on frame at (0, 0), turns beta, mass m1 at polar(ra, beta), inertia i1;
        body k2 = pin on k1 at f, turns k2, mass m2 at f - polar(da, k2), inertia i2;
        body k3 = pin on frame at b, turns gamma, mass m3 at b + rotate((sb, -sa), gamma), inertia i3;
        body k5 = pin on frame at a, turns delta, mass m5 at a + rotate((ta, tb), delta), inertia i5;
        body k4 = pin on k5 at h, turns k4, mass m4 at h + polar(e - ea, k4 - 90deg), inertia i4;
        body k7 = pin on frame at a, turns epsilon, mass m7 at a + rotate((-ub, -ua), epsilon), inertia i7;
        body k6 = pin on k7 at g, turns k6, mass m6 at g + polar(zf - fa, k6), inertia i6;
        pin p3 = k2 on k3 at p;
        pin p4 = k4 on k2 at p;
        pin p6 = k6 on k2 at p;
        torque mom on k1;
        spring stiffness from frame at c to k3 at b + rotate((sd, -sc), gamma), free l0;
    }

    impl Andrews {
        /// The angles of the publication.
        pub fn position(beta) -> Position { theta: k2 - beta, gamma, phi: k4 - delta, delta, omega: k6 - epsilon, epsilon }
        /// The acceleration of the crank, which is the whole equation of motion.
        pub fn motion(beta, speed, mom) -> Motion { acceleration: driven_acceleration(beta) }
        /// The terms of that equation, and the rate of the inertia.
        pub fn terms(beta, speed, mom) -> Terms {
            inertia: inertia(beta), rate: velocity(inertia(beta)), bias: bias(beta), force: generalised_force(beta),
        }
        /// Both energies; the motor's work is their change.
        pub fn energy(beta, speed) -> Energy { kinetic: kinetic_energy(), potential: potential_energy() }
        /// All links, for drawings.
        pub fn picture(beta) -> Picture { shape: picture() }
    }
}
