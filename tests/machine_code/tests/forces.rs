//! Reactions, torques and energies: in space, with several drives, beside a group without a closed form, with friction.
//!
//! The workspace builds this package with optimisation in every profile.
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

#[macro_use]
mod judge;

use linkage::mechanism;

mechanism! {
    /// A slender rod between two ball joints, a rocker with an inertia matrix.
    pub struct Rssr {
        unit mm;
        param crank = 30mm;
        param coupler = 130mm;
        param rocker = 70mm;
        param pivot = (110mm, 30mm, -50mm);
        param tilt = 20deg;
        param heavy = 200g;
        argument load = 20N;
        input phi = 0deg in 0deg..360deg at omega, epsilon;
        unknown psi = 100deg;
        let pin = turn((0, crank, 0), (1, 0, 0), phi);
        let axis = turn((0, 0, 1), (1, 0, 0), -tilt);
        let end = pivot + turn((rocker, 0, 0), axis, psi);
        loop distance(pin, end) = coupler;
        let arm = frame(pivot, end - pivot, axis);

        gravity = (0, 0, -9.80665m/s^2);
        body wheel = pin shaft on frame at (0, 0, 0) about (1, 0, 0), turns phi, mass 130g at pin / 2, inertia 30kg*mm^2;
        body rod = ball big on wheel at pin, turns end - pin, mass 90g at (pin + end) / 2, inertia 140kg*mm^2;
        body lever = pin bearing on frame at pivot about axis, turns arm, mass heavy at point_in(arm, (rocker / 2, 5mm, -8mm)),
            inertia ((20kg*mm^2, 1kg*mm^2, -1kg*mm^2), (1kg*mm^2, 50kg*mm^2, 2kg*mm^2), (-1kg*mm^2, 2kg*mm^2, 60kg*mm^2));
        ball small = rod on lever at end;
        force (load, -load, load / 2) on lever at end;
        spring 0.2N/mm from frame at (0mm, 100mm, 50mm) to rod at (pin + end) / 2, free 30mm;
        damper 20N*mm*s on bearing;
    }
    impl Rssr {
        pub fn forces(phi, omega, epsilon, load) -> RssrForces {
            shaft: reaction(shaft), big: reaction(big), small: reaction(small), bearing: reaction(bearing),
            tilt: moment(bearing), t: torque(phi),
        }
        pub fn statics(phi, load) -> RssrStatics { t: torque(phi), by_mass: d(torque(phi), heavy) }
        pub fn energy(phi, omega) -> RssrEnergy { k: kinetic_energy(), u: potential_energy(), f: shaking_force() }
    }
}

mechanism! {
    /// Two drives.
    pub struct FiveBar {
        unit mm;
        param upper = 300mm;
        param lower = 400mm;
        param base = 200mm;
        argument payload = 1kg;
        input left = 130deg in 110deg..150deg at left_speed;
        input right = 50deg in 30deg..70deg at right_speed;
        unknown alpha = 55deg;
        unknown beta = 125deg;
        let a = polar(upper, left);
        let b = (base, 0) + polar(upper, right);
        let tip = a + polar(lower, alpha);
        loop tip = b + polar(lower, beta);

        gravity = (0, -9.80665m/s^2);
        body upper_left = pin on frame at (0, 0), turns left, mass 1.2kg at a / 2, inertia 9000kg*mm^2;
        body upper_right = pin on frame at (base, 0), turns right, mass 1.2kg at (b + (base, 0)) / 2, inertia 9000kg*mm^2;
        body lower_left = pin on upper_left at a, turns alpha, mass 0.7kg at (a + tip) / 2, mass payload at tip, inertia 9000kg*mm^2;
        body lower_right = pin on upper_right at b, turns beta, mass 0.7kg at (b + tip) / 2, inertia 9000kg*mm^2;
        pin hand = lower_left on lower_right at tip;
    }
    impl FiveBar {
        pub fn drives(left, right, left_speed, right_speed, payload) -> FiveBarDrives {
            left: torque(left), right: torque(right), p: power(), hand: reaction(hand),
        }
        pub fn hold(left, right, payload) -> FiveBarHold { left: torque(left), right: torque(right) }
        pub fn free(left, right, left_speed, right_speed, payload) -> FiveBarFree {
            m: inertia(), left: driven_acceleration(left), right: driven_acceleration(right),
        }
    }
}

mechanism! {
    /// A ternary link on three legs, one of them driven.
    pub struct Platform {
        unit mm;
        param crank = 40mm;
        param leg = 50mm;
        input phi = 60deg in 20deg..100deg at omega;
        unknown tilt = 20deg;
        unknown leg_a = -37deg;
        unknown leg_b = 100deg;
        unknown leg_c = 290deg;
        let p = polar(crank, phi);
        let a = p + polar(leg, leg_a);
        let b = a + polar(60mm, tilt);
        let c = a + polar(60mm, tilt + 60deg);
        loop b = (120mm, 0) + polar(leg, leg_b);
        loop c = (60mm, 110mm) + polar(leg, leg_c);

        gravity = (0, -9.80665m/s^2);
        body wheel = pin shaft on frame at (0, 0), turns phi;
        body first = pin on wheel at p, turns leg_a, mass 100g at (p + a) / 2;
        body second = pin on frame at (120mm, 0), turns leg_b, mass 100g at b;
        body third = pin on frame at (60mm, 110mm), turns leg_c, mass 100g at c;
        body plate = pin at_a on first at a, turns tilt, mass 400g at (a + b + c) / 3, inertia 300kg*mm^2;
        pin at_b = plate on second at b;
        pin at_c = plate on third at c;
    }
    impl Platform {
        pub fn forces(phi, omega) -> PlatformForces { a: reaction(at_a), b: reaction(at_b), c: reaction(at_c), t: torque(phi) }
    }
}

mechanism! {
    /// Dry pins and a dry guide.
    pub struct Dry {
        unit mm;
        param mu = 0.1;
        argument push = 500N;
        input phi = 40deg in 0deg..360deg at omega;
        unknown theta = -10deg;
        unknown x = 150mm;
        let p = polar(40mm, phi);
        loop p + polar(120mm, theta) = (x, 0);

        body crank = pin on frame at (0, 0), turns phi, inertia 3000kg*mm^2;
        body rod = pin big on crank at p, turns theta, mass 300g at p, inertia 500kg*mm^2;
        body piston = slide guide on frame at (x, 0) along (1, 0), mass 500g at (x, 0);
        pin small = rod on piston at (x, 0);
        force (-push, 0) on piston at (x, 0);
        friction mu on big, radius 10mm;
        friction mu on small, radius 8mm;
        friction mu on guide, length 60mm;
    }
    impl Dry {
        pub fn forces(phi, omega, push) -> DryForces { small: reaction(small), t: torque(phi), eta: efficiency() }
        pub fn free(phi, omega, push) -> DryFree { epsilon: driven_acceleration(phi), by_mu: d(torque(phi), mu) }
    }
}

check!(rssr: Rssr, RssrAssembly:
    forces [forces_sweep forces_sweep_sets] (phi, omega, epsilon, load),
    statics [statics_sweep statics_sweep_sets] (phi, load),
    energy [energy_sweep energy_sweep_sets] (phi, omega));
check!(five_bar: FiveBar, FiveBarAssembly:
    drives [drives_sweep drives_sweep_sets]
        (left, right, left_speed, right_speed, payload),
    hold [hold_sweep hold_sweep_sets] (left, right, payload),
    free [free_sweep free_sweep_sets] (left, right, left_speed, right_speed, payload));
check!(platform: Platform, PlatformAssembly:
    forces [forces_sweep forces_sweep_sets] (phi, omega));
check!(dry: Dry, DryAssembly:
    forces [forces_sweep forces_sweep_sets] (phi, omega, push),
    free [free_sweep free_sweep_sets] (phi, omega, push));
