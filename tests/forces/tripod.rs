//! Three driven legs in space meet in a point: barrels on ball joints, rods that slide in them, the load in the point.

use linkage::Vector3;
use linkage_interpreted::interpreted;
use nalgebra::Matrix3;

use super::rssr::swing;
use super::{Body, Instant, Kind, NEWTON, Vector, each};

interpreted! {
    pub struct Tripod {
        unit mm;
        param foot = 100mm;
        param m1 = 0.3kg;
        param m2 = 0.2kg;
        param i1 = 200kg*mm^2;
        argument load = 40N;
        input l1 = 200mm in 180mm..220mm at v1, a1;
        input l2 = 200mm in 180mm..220mm at v2, a2;
        input l3 = 200mm in 180mm..220mm at v3, a3;
        unknown tip = (0mm, 0mm, 170mm);
        const up = (0, 0, 1);
        let f1 = (foot, 0mm, 0mm);
        let f2 = turn(f1, up, 120deg);
        let f3 = turn(f1, up, 240deg);
        loop distance(tip, f1) = l1;
        loop distance(tip, f2) = l2;
        loop distance(tip, f3) = l3;
        let c1 = f1 + 60mm * (tip - f1) / l1;
        let c2 = f2 + 60mm * (tip - f2) / l2;
        let c3 = f3 + 60mm * (tip - f3) / l3;
        gravity = (0, 0, -9.80665m/s^2);
        body barrel1 = ball j1 on frame at f1, turns tip - f1, mass m1 at c1, inertia i1;
        body barrel2 = ball j2 on frame at f2, turns tip - f2, mass m1 at c2, inertia i1;
        body barrel3 = ball j3 on frame at f3, turns tip - f3, mass m1 at c3, inertia i1;
        body rod1 = slide s1 on barrel1 at tip along tip - f1, mass m2 at tip;
        body rod2 = slide s2 on barrel2 at tip along tip - f2, mass m2 at tip;
        body rod3 = slide s3 on barrel3 at tip along tip - f3, mass m2 at tip;
        ball k2 = rod2 on rod1 at tip;
        ball k3 = rod3 on rod1 at tip;
        force (load, -load, -2 * load) on rod1 at tip;
    }
    impl Tripod {
        pub fn motion(l1, l2, l3) -> TripodMotion {
            tip, v: velocity(tip), a: acceleration(tip), f1, f2, f3, c1, c2, c3, margin: margin(),
        }
        pub fn forces(l1, l2, l3, v1, a1, v2, a2, v3, a3, load) -> TripodForces {
            j1: reaction(j1), j2: reaction(j2), j3: reaction(j3), s1: reaction(s1), t1: moment(s1), k2: reaction(k2), k3: reaction(k3),
            d1: force(l1), d2: force(l2), d3: force(l3), p: power(),
        }
    }
}

#[test]
fn legs() {
    each(0x131, |m: Tripod, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let lengths = [0, 1, 2].map(|_| random.between(185.0, 215.0));
        let v: [f64; 3] = [0, 1, 2].map(|_| random.load(100.0));
        let a: [f64; 3] = [0, 1, 2].map(|_| random.load(2000.0));
        let load = random.load(40.0);
        let at = linkage.motion(lengths[0], lengths[1], lengths[2]);
        let (mut speed, mut gain): (Vector3<f64>, Vector3<f64>) =
            (Vector::zeros(), Vector::zeros());
        for i in 0..3 {
            speed += at.v[i] * v[i];
            gain += at.v[i] * a[i];
            for j in 0..3 {
                gain += at.a[i][j] * (v[i] * v[j]);
            }
        }
        let mut all = Instant::new(false, 150.0, NEWTON, Vector::new(0.0, 0.0, -9806.65));
        let legs = [(at.f1, at.c1), (at.f2, at.c2), (at.f3, at.c3)];
        for (foot, centre) in legs {
            let turn = swing(at.tip - foot, speed, gain);
            let barrel = Body::new([foot, Vector::zeros(), Vector::zeros()], turn);
            all.body(
                barrel
                    .add_mass(m.m1, centre)
                    .add_inertia(Matrix3::identity() * m.i1),
            );
        }
        for (foot, _) in legs {
            let turn = swing(at.tip - foot, speed, gain);
            all.body(Body::new([at.tip, speed, gain], turn).add_mass(m.m2, at.tip));
        }
        for (leg, (foot, _)) in legs.into_iter().enumerate() {
            all.joint(Kind::Ball, leg, None, foot);
        }
        for (leg, (foot, _)) in legs.into_iter().enumerate() {
            all.driven(Kind::Slide(at.tip - foot), 3 + leg, Some(leg), at.tip);
        }
        all.joint(Kind::Ball, 4, Some(3), at.tip);
        all.joint(Kind::Ball, 5, Some(3), at.tip);
        all.force(
            [Some(3), None],
            at.tip,
            Vector::new(load, -load, -2.0 * load),
        );

        let solution = all.solve();
        let [l1, l2, l3] = lengths;
        let found = linkage.forces(l1, l2, l3, v[0], a[0], v[1], a[1], v[2], a[2], load);
        solution.expect_forces([found.j1, found.j2, found.j3, found.s1]);
        solution.expect_moment(3, found.t1);
        solution.expect_force(6, found.k2);
        solution.expect_force(7, found.k3);
        for (leg, drive) in [found.d1, found.d2, found.d3].into_iter().enumerate() {
            solution.expect_size(Vector::x() * solution.drive(3 + leg), Vector::x() * drive);
        }
        let fastest = v.into_iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        solution.expect_power(solution.power(&all), found.p, fastest / 150.0);
        true
    });
}
