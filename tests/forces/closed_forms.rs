//! Equations of motion against formulas: arm, parallelogram, aligned and equal links, ankle, masses of zero.

use linkage_interpreted::interpreted;

use super::NEWTON;

interpreted! {
    /// Two links in a row: the textbook's robot.
    pub struct Arm {
        unit mm;
        param l1 = 300mm;
        param r1 = 140mm;
        param r2 = 120mm;
        param m1 = 1.2kg;
        param m2 = 0.8kg;
        param i1 = 9000kg*mm^2;
        param i2 = 4000kg*mm^2;
        argument t1 = 1N*m;
        argument t2 = 1N*m;
        input q1 = 20deg in -180deg..180deg at w1;
        input q2 = 40deg in -180deg..180deg at w2;
        let elbow = polar(l1, q1);
        gravity = (0, -9.80665m/s^2);
        body upper = pin on frame at (0mm, 0mm), turns q1, mass m1 at polar(r1, q1), inertia i1;
        body lower = pin on upper at elbow, turns q1 + q2, mass m2 at elbow + polar(r2, q1 + q2), inertia i2;
        torque t1 on upper;
        torque t2 on lower from upper;
    }
    impl Arm {
        pub fn matrix(q1, q2) -> ArmMatrix { m: inertia(), mixed: inertia(q2, q1) }
        pub fn turned(q2, q1) -> ArmTurned { m: inertia() }
        pub fn terms(q1, q2, w1, w2, t1, t2) -> ArmTerms {
            h1: bias(q1), h2: bias(q2), f1: generalised_force(q1), f2: generalised_force(q2),
            a1: driven_acceleration(q1), a2: driven_acceleration(q2),
        }
        pub fn second(q1, q2, w1, w2, t1, t2) -> ArmSecond { a2: driven_acceleration(q2) }
    }
}

#[test]
fn arm_of_the_textbook() {
    let mechanism = Arm::default();
    let Arm {
        l1,
        r1,
        r2,
        m1,
        m2,
        i1,
        i2,
    } = mechanism;
    let arm = mechanism.assemble().expect("it assembles");
    for k in 0..20 {
        let (q1, q2) = (0.3 * f64::from(k) - 3.0, 2.9 - 0.31 * f64::from(k));
        let (w1, w2, t1, t2) = (3.0, -5.0, 700.0, -200.0);
        let at = arm.matrix(q1, q2);
        let last = i2 + m2 * r2 * r2;
        let mixed = last + m2 * l1 * r2 * q2.cos();
        let first = i1 + m1 * r1 * r1 + m2 * l1 * l1 + 2.0 * mixed - last;
        let expected = [[first, mixed], [mixed, last]];
        for (row, expected) in at.m.iter().zip(expected) {
            for (&found, expected) in row.iter().zip(expected) {
                close(found, expected, 1e-14 * first);
            }
        }
        assert_eq!(at.mixed.to_bits(), at.m[0][1].to_bits());
        // Rows and columns have the order of the function's list.
        let turned = arm.turned(q2, q1).m;
        assert_eq!(turned, [[at.m[1][1], at.m[1][0]], [at.m[0][1], at.m[0][0]]]);

        let (across, g) = (m2 * l1 * r2 * q2.sin() * NEWTON, 9.80665);
        let (c1, c12) = (q1.cos(), (q1 + q2).cos());
        let weight = m2 * g * r2 * c12;
        let h1 = -across * (2.0 * w1 * w2 + w2 * w2) + (m1 * r1 + m2 * l1) * g * c1 + weight;
        let h2 = across * w1 * w1 + weight;
        let found = arm.terms(q1, q2, w1, w2, t1, t2);
        close(found.h1, h1, 1e-11);
        close(found.h2, h2, 1e-11);
        close(found.f1, t1, 0.0);
        close(found.f2, t2, 1e-12);
        let determinant = (first * last - mixed * mixed) * NEWTON;
        let a1 = (last * (t1 - h1) - mixed * (t2 - h2)) / determinant;
        let a2 = (first * (t2 - h2) - mixed * (t1 - h1)) / determinant;
        close(found.a1, a1, 1e-12 * a1.hypot(a2));
        close(found.a2, a2, 1e-12 * a1.hypot(a2));
        let alone = arm.second(q1, q2, w1, w2, t1, t2).a2;
        assert_eq!(alone.to_bits(), found.a2.to_bits());
    }
}

interpreted! {
    /// Both cranks turn alike, and the coupler does not turn.
    pub struct Parallelogram {
        unit mm;
        param crank = 50mm;
        param base = 120mm;
        param heavy = 0.7kg;
        param inertia = 300kg*mm^2;
        argument drive = 3N*m;
        input phi = 60deg in 5deg..175deg at omega;
        unknown theta = 0deg;
        unknown psi = 60deg;
        let p = polar(crank, phi);
        let q = p + polar(base, theta);
        loop q = (base, 0mm) + polar(crank, psi);
        gravity = (0, -9.80665m/s^2);
        body left = pin on frame at (0mm, 0mm), turns phi, inertia inertia;
        body coupler = pin on left at p, turns theta, mass heavy at (p + q) / 2, inertia 80kg*mm^2;
        body right = pin on frame at (base, 0mm), turns psi, inertia 2 * inertia;
        pin end = coupler on right at q;
        torque drive on left;
    }
    impl Parallelogram {
        pub fn motion(phi, omega, drive) -> ParallelogramMotion {
            j: inertia(phi), slope: velocity(inertia(phi)), h: bias(phi), a: driven_acceleration(phi),
        }
    }
}

/// Its coupler has no height of its own, which a pivot chosen by formula would divide by.
#[test]
fn parallelogram() {
    let mechanism = Parallelogram::default();
    let Parallelogram {
        crank,
        heavy,
        inertia,
        ..
    } = mechanism;
    let linkage = mechanism.assemble().expect("it assembles");
    for degrees in [5.0, 5.1, 30.0, 90.0, 91.0, 150.0, 175.0f64] {
        let phi = degrees.to_radians();
        let at = linkage.motion(phi, 30.0, 3000.0);
        let j = 3.0 * inertia + heavy * crank * crank;
        let weight = heavy * 9.80665 * crank * phi.cos();
        close(at.j, j, 1e-11 * j);
        close(at.slope, 0.0, 1e-9 * j);
        close(
            at.h,
            weight,
            1e-9 * heavy * 9.80665 * crank + 1e-9 * j * 900.0 * NEWTON,
        );
        close(
            at.a,
            (3000.0 - weight) / (j * NEWTON),
            1e-8 * 3000.0 / (j * NEWTON),
        );
    }
}

interpreted! {
    /// A slider-crank with bodies that may be without mass.
    pub struct Piston {
        unit mm;
        param crank = 40mm;
        param rod = 130mm;
        param wheel = 900kg*mm^2;
        param middle = 0.3kg;
        param ram = 1.1kg;
        argument drive = 3N*m;
        input phi = 60deg in -80deg..80deg at omega;
        unknown theta = -15deg;
        unknown x = 140mm;
        let p = polar(crank, phi);
        let q = p + polar(rod, theta);
        loop q = (x, 0mm);
        body wheel = pin on frame at (0mm, 0mm), turns phi, inertia wheel;
        body rod = pin on wheel at p, turns theta, mass middle at (p + q) / 2;
        body ram = slide on frame at q along (1, 0), mass ram at q;
        pin end = rod on ram at q;
        torque drive on wheel;
    }
    impl Piston {
        pub fn motion(phi, omega, drive) -> PistonMotion { j: inertia(phi), h: bias(phi), a: driven_acceleration(phi) }
    }
}

/// Crank and rod in line: the ram rests, and the rod turns about it.
#[test]
fn aligned_links() {
    let mechanism = Piston::default();
    let Piston {
        crank,
        wheel,
        middle,
        ..
    } = mechanism;
    let at = mechanism
        .assemble()
        .expect("it assembles")
        .motion(0.0, 20.0, 3000.0);
    let j = wheel + middle * crank * crank / 4.0;
    close(at.j, j, 1e-13 * j);
    // Centripetal accelerations along the line do no work.
    assert!(at.h.abs() < 1e-9, "{}", at.h);
    close(at.a, 3000.0 / (j * NEWTON), 1e-12 * 3000.0 / (j * NEWTON));
}

/// A rod as long as the crank: the ram is at twice the cosine.
#[test]
fn equal_lengths() {
    let mechanism = Piston {
        rod: 40.0,
        ..Piston::default()
    };
    let Piston {
        crank,
        wheel,
        middle,
        ram,
        ..
    } = mechanism;
    let linkage = mechanism.assemble().expect("it assembles");
    for phi in [-1.2, -0.5, 0.0, 0.7, 1.3f64] {
        let at = linkage.motion(phi, 20.0, 3000.0);
        let (x, y) = (1.5 * crank * phi.sin(), 0.5 * crank * phi.cos());
        let j = wheel + middle * (x * x + y * y) + 4.0 * ram * (crank * phi.sin()).powi(2);
        let slope = (2.0 * middle + 4.0 * ram) * crank * crank * (2.0 * phi).sin();
        let h = slope / 2.0 * 400.0 * NEWTON;
        close(at.j, j, 1e-12 * j);
        close(at.h, h, 1e-10 * j * 400.0 * NEWTON);
        close(
            at.a,
            (3000.0 - h) / (j * NEWTON),
            1e-10 * 3000.0 / (j * NEWTON),
        );
    }
}

/// Without inertia a torque has no finite acceleration: NaN, not an infinity of any sign.
#[test]
fn masses_of_zero() {
    let still = Piston {
        wheel: 0.0,
        middle: 0.0,
        ..Piston::default()
    };
    let linkage = still.assemble().expect("it assembles");
    // The ram rests except for rounding.
    let at = linkage.motion(0.0, 20.0, 3000.0);
    assert!(at.j.abs() < 1e-25, "{}", at.j);
    assert!(at.a.is_nan() || at.a > 1e25, "{}", at.a);
    assert!(linkage.motion(0.5, 20.0, 3000.0).a.is_finite());
    let nothing = Piston { ram: 0.0, ..still };
    let linkage = nothing.assemble().expect("it assembles");
    for phi in [0.0, 0.5] {
        let at = linkage.motion(phi, 20.0, 3000.0);
        assert!(
            at.j == 0.0 && at.h == 0.0 && at.a.is_nan(),
            "{} {}",
            at.h,
            at.a
        );
    }
}

interpreted! {
    /// An ankle: two motors in the shank turn a foot by rods without mass.
    pub struct Ankle {
        unit mm;
        param rotor = 900kg*mm^2;
        param ixx = 2100kg*mm^2;
        param iyy = 5200kg*mm^2;
        param izz = 6300kg*mm^2;
        argument left_motor = 2N*m;
        argument right_motor = 1N*m;
        input pitch = 0deg in -45deg..25deg at v;
        input roll = 0deg in -20deg..20deg at w;
        unknown left = 0deg;
        unknown right = 0deg;
        const x = (1, 0, 0);
        const y = (0, 1, 0);
        let foot = frame((0mm, 0mm, 0mm), turn(turn(x, x, roll), y, pitch), turn(turn((0, 0, 1), x, roll), y, pitch));
        let heel_left = point_in(foot, (-50mm, 45mm, 10mm));
        let heel_right = point_in(foot, (-50mm, -45mm, 10mm));
        let pin_left = (0mm, 45mm, 230mm) + turn((-60mm, 0mm, 0mm), y, left);
        let pin_right = (0mm, -45mm, 230mm) + turn((-60mm, 0mm, 0mm), y, right);
        loop distance(pin_left, heel_left) = 230mm;
        loop distance(pin_right, heel_right) = 230mm;
        body foot = ball on frame at (0mm, 0mm, 0mm), turns foot, inertia (ixx, iyy, izz);
        body left = pin on frame at (0mm, 45mm, 230mm) about y, turns left, inertia rotor;
        body right = pin on frame at (0mm, -45mm, 230mm) about y, turns right, inertia rotor;
        torque left_motor * y on left;
        torque right_motor * y on right;
    }
    impl Ankle {
        pub fn motors(pitch, roll) -> AnkleMotors { l: velocity(left), r: velocity(right) }
        pub fn terms(pitch, roll, left_motor, right_motor) -> AnkleTerms {
            m: inertia(), f: generalised_force(pitch), g: generalised_force(roll),
            a: driven_acceleration(pitch), b: driven_acceleration(roll),
        }
    }
}

#[test]
fn ankle() {
    let mechanism = Ankle::default();
    let Ankle {
        rotor,
        ixx,
        iyy,
        izz,
    } = mechanism;
    let linkage = mechanism.assemble().expect("it assembles");
    for k in 0..8 {
        let (pitch, roll) = (0.12 * f64::from(k) - 0.6, 0.3 - 0.08 * f64::from(k));
        let motors = linkage.motors(pitch, roll);
        let at = linkage.terms(pitch, roll, 2000.0, -1000.0);
        let (sin, cos) = roll.sin_cos();
        let foot = [[iyy * cos * cos + izz * sin * sin, 0.0], [0.0, ixx]];
        let matrix = [0, 1].map(|i| {
            [0, 1].map(|j| {
                foot[i][j] + rotor * (motors.l[i] * motors.l[j] + motors.r[i] * motors.r[j])
            })
        });
        let forces = [0, 1].map(|i| 2000.0 * motors.l[i] - 1000.0 * motors.r[i]);
        for (i, row) in matrix.iter().enumerate() {
            for (j, &entry) in row.iter().enumerate() {
                close(at.m[i][j], entry, 1e-12 * iyy);
            }
            close([at.f, at.g][i], forces[i], 1e-9);
            // From rest.
            let sum = (row[0] * at.a + row[1] * at.b) * NEWTON;
            close(sum, forces[i], 1e-8);
        }
    }
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    let good = (found - expected).abs() <= tolerance;
    assert!(
        good,
        "{found:e} instead of {expected:e}, within {tolerance:e}"
    );
}
