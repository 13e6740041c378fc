//! Two bodies that can only be solved together, since rods stand between them: a wheel carrier by the travel of the wheel, and the cradle that its
//! inner rods end on, which hangs on rods itself. Positions against an independent solver, derivatives against differences.

use linkage::Dimensions;
use linkage_interpreted::interpreted;
use linkage_random::Random;
use nalgebra::{UnitQuaternion, Vector3};

use super::independent::Pose;
use super::independent::{End, Held};
use super::long;
use super::{STEP, near};

interpreted! {
    pub struct Cradled {
        unit mm;
        param wheel1 = (-140mm, -60mm, 130mm);    // on the carrier, of the rods to the ground
        param wheel2 = (140mm, -50mm, -20mm);
        param wheel3 = (40mm, -50mm, 10mm);
        param body1 = (-210mm, 400mm, 470mm);     // on the ground
        param body2 = (90mm, 440mm, 350mm);
        param body3 = (120mm, 460mm, 290mm);
        param outer1 = (-90mm, -40mm, -30mm);     // on the carrier, of the rods between both
        param outer2 = (-60mm, -50mm, 130mm);
        param outer3 = (-110mm, -40mm, -50mm);
        param outer4 = (110mm, -60mm, 100mm);
        param inner1 = (-200mm, 60mm, -60mm);     // on the cradle
        param inner2 = (-100mm, 40mm, 20mm);
        param inner3 = (180mm, 90mm, 0mm);
        param inner4 = (140mm, 0mm, 90mm);
        param below1 = (70mm, 110mm, -40mm);      // on the cradle, of the rods that it hangs on
        param below2 = (10mm, -20mm, 50mm);
        param below3 = (-110mm, -20mm, -80mm);
        param below4 = (-100mm, -190mm, 60mm);
        param above1 = (40mm, 440mm, 480mm);      // on the ground
        param above2 = (210mm, 260mm, 340mm);
        param above3 = (60mm, 310mm, 200mm);
        param above4 = (-110mm, 80mm, 540mm);
        param w1 = 308.7mm;
        param w2 = 279.1mm;
        param w3 = 265.5mm;
        param b1 = 379.7mm;
        param b2 = 394.2mm;
        param b3 = 440.3mm;
        param b4 = 402.2mm;
        param m1 = 224.1mm;
        param m2 = 201.2mm;
        param m3 = 173.8mm;
        param m4 = 182.8mm;
        input travel = 0mm in -40mm..40mm;
        input shim = 0mm in -3mm..3mm;            // of a rod between both, and of where it ends on the cradle
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        unknown cradle = frame((0mm, 300mm, 300mm), (1, 0, 0), (0, 0, 1));
        loop carrier.origin.z = 320mm + travel;
        loop distance(point_in(carrier, wheel1), body1) = w1;
        loop distance(point_in(carrier, wheel2), body2) = w2;
        loop distance(point_in(carrier, wheel3), body3) = w3;
        loop distance(point_in(carrier, outer1), point_in(cradle, inner1)) = b1;
        loop distance(point_in(carrier, outer2), point_in(cradle, inner2)) = b2;
        loop distance(point_in(carrier, outer3), point_in(cradle, inner3 + (shim, 0mm, 0mm))) = b3 + 0.5 * shim;
        loop distance(point_in(carrier, outer4), point_in(cradle, inner4)) = b4;
        loop distance(point_in(cradle, below1), above1) = m1;
        loop distance(point_in(cradle, below2), above2) = m2;
        loop distance(point_in(cradle, below3), above3) = m3;
        loop distance(point_in(cradle, below4), above4) = m4;
    }

    impl Cradled {
        pub fn bodies(travel, shim) -> Bodies { p: carrier.origin, x: carrier.x, y: carrier.y, q: cradle.origin, u: cradle.x, v: cradle.y }
        pub fn motion(travel, shim) -> MotionOfTwo {
            p1: velocity(carrier.origin), x1: velocity(carrier.x), w1: omega(carrier),
            q1: velocity(cradle.origin), u1: velocity(cradle.x), o1: omega(cradle),
            p2: acceleration(carrier.origin), x2: acceleration(carrier.x), w2: alpha(carrier),
            q2: acceleration(cradle.origin), u2: acceleration(cradle.x), o2: alpha(cradle),
        }
        pub fn by_dimensions(travel, shim) -> TwoByDimensions {
            q: sensitivity(cradle.origin, [w1, b3, inner3]),
            o: sensitivity(omega(cradle), [w1, b3, inner3]),
        }
    }
}

fn held(own: &Cradled) -> Held {
    let [carrier, cradle] = [0, 1].map(|body| move |place| End::On(body, place));
    let ground = End::Ground;
    Held {
        rods: vec![
            [carrier(own.wheel1), ground(own.body1)],
            [carrier(own.wheel2), ground(own.body2)],
            [carrier(own.wheel3), ground(own.body3)],
            [carrier(own.outer1), cradle(own.inner1)],
            [carrier(own.outer2), cradle(own.inner2)],
            [carrier(own.outer3), cradle(own.inner3)],
            [carrier(own.outer4), cradle(own.inner4)],
            [cradle(own.below1), ground(own.above1)],
            [cradle(own.below2), ground(own.above2)],
            [cradle(own.below3), ground(own.above3)],
            [cradle(own.below4), ground(own.above4)],
        ],
    }
}

fn estimates() -> [Pose; 2] {
    let at = |p| Pose {
        p,
        turn: UnitQuaternion::identity(),
    };
    [
        at(Vector3::new(0.0, 760.0, 320.0)),
        at(Vector3::new(0.0, 300.0, 300.0)),
    ]
}

/// How far both solvers may be apart, in radians and [`RADIUS`].
const APART: f64 = 1e-11;

fn away(poses: &[Pose; 2], found: &Bodies) -> f64 {
    let cradle = poses[1].away(found.q, found.u, found.v);
    poses[0].away(found.p, found.x, found.y).max(cradle)
}

#[test]
fn both_are_where_an_independent_solver_puts_them() {
    let own = Cradled::default();
    let rods = held(&own);
    let lengths = [
        own.w1, own.w2, own.w3, own.b1, own.b2, own.b3, own.b4, own.m1, own.m2, own.m3, own.m4,
    ];
    let reference = rods
        .near(&estimates(), &lengths, 320.0)
        .expect("near the estimates");
    let assembly = own.assemble().expect("it assembles");
    for travel in (-8..=8).map(|k| 5.0 * f64::from(k)) {
        let poses = rods.go(&reference, travel).expect("it gets there");
        let away = away(&poses, &assembly.bodies(travel, 0.0));
        assert!(away < APART, "{away:e} at {travel}");
    }
    let structure = Cradled::structure().groups[1];
    assert!(structure.method.starts_with("followed from the estimates"));
}

const PLACES: [[f64; 2]; 3] = [[0.0, 0.0], [13.0, -2.1], [-27.5, 1.4]];

#[test]
fn derivatives_are_those_of_what_is_differentiated() {
    let assembly = Cradled::default().assemble().expect("it assembles");
    for [travel, shim] in PLACES {
        let found = assembly.motion(travel, shim);
        for (k, [a, b]) in [[STEP, 0.0], [0.0, STEP]].into_iter().enumerate() {
            let ends = [1.0, -1.0].map(|s| [travel + s * a, shim + s * b]);
            let bodies = ends.map(|[travel, shim]| assembly.bodies(travel, shim));
            near(found.p1[k], bodies.map(|own| own.p), 1.0);
            near(found.x1[k], bodies.map(|own| own.x), 1e-2);
            near(found.q1[k], bodies.map(|own| own.q), 1.0);
            near(found.u1[k], bodies.map(|own| own.u), 1e-2);
            let motions = ends.map(|[travel, shim]| assembly.motion(travel, shim));
            for j in 0..2 {
                near(found.p2[j][k], motions.map(|own| own.p1[j]), 1e-2);
                near(found.x2[j][k], motions.map(|own| own.x1[j]), 1e-4);
                near(found.w2[j][k], motions.map(|own| own.w1[j]), 1e-4);
                near(found.q2[j][k], motions.map(|own| own.q1[j]), 1e-2);
                near(found.u2[j][k], motions.map(|own| own.u1[j]), 1e-4);
                near(found.o2[j][k], motions.map(|own| own.o1[j]), 1e-4);
            }
        }
    }
}

/// The dimensions of `by_dimensions` by name, in its order; places are three.
const DIMENSIONS: [&str; 3] = ["w1", "b3", "inner3"];

#[test]
fn sensitivities_are_those_of_other_dimensions() {
    let own = Cradled::default();
    let assembly = own.assemble().expect("it assembles");
    let of_one = |name: &str| {
        let all = Cradled::parameters().iter().enumerate();
        let own = all.filter(|(_, own)| own.name.split('.').next() == Some(name));
        own.map(|(k, _)| k).collect::<Vec<usize>>()
    };
    let places: Vec<usize> = DIMENSIONS.into_iter().flat_map(of_one).collect();
    assert_eq!(places.len(), 5);
    let changed = |index: usize, step: f64| {
        let mut values = own.values();
        values[index] += step;
        let other = <Cradled as Dimensions<77>>::from_values(&values);
        other.assemble_from(&assembly).expect("it is followed")
    };
    for (k, index) in places.into_iter().enumerate() {
        let ends = [STEP, -STEP].map(|step| changed(index, step));
        for [travel, shim] in PLACES {
            let found = assembly.by_dimensions(travel, shim);
            let bodies = ends.each_ref().map(|own| own.bodies(travel, shim));
            near(found.q[k], bodies.map(|own| own.q), 1.0);
            let motions = ends.each_ref().map(|own| own.motion(travel, shim));
            for j in 0..2 {
                near(found.o[k][j], motions.map(|own| own.o1[j]), 1e-4);
            }
        }
    }
}

#[test]
fn random_ones_travel_as_an_independent_solver_says() {
    let own = Cradled::default();
    let mut random = Random::new(7);
    let (mut served, mut refused, mut otherwise) = (0, 0, Vec::new());
    for number in 0..if long() { 1000 } else { 5 } {
        let mut other = own;
        let mut values = other.values();
        // Lengths stand last: they follow from where the bodies are.
        values[..66]
            .iter_mut()
            .for_each(|x| *x += random.between(-15.0, 15.0));
        other = Cradled::from_values(&values);
        let rods = held(&other);
        let mut planted = estimates().map(|pose| pose.moved(&mut random, 3.0, 0.01));
        planted[0].p.z = 320.0;
        values[66..].copy_from_slice(&rods.lengths(&planted));
        match Cradled::from_values(&values).assemble() {
            Ok(assembly) => {
                served += 1;
                for travel in (-4..=4).map(|k| 10.0 * f64::from(k)) {
                    let Some(poses) = rods.go(&planted, travel) else {
                        continue;
                    };
                    let away = away(&poses, &assembly.bodies(travel, 0.0));
                    if away.is_nan() || away > APART {
                        otherwise.push(format!("{number} at {travel}: {away:e}"));
                    }
                }
            }
            Err(error) => {
                let ends = [-40.0, 40.0].map(|travel| rods.go(&planted, travel));
                match ends.iter().all(Option::is_some) {
                    true => otherwise.push(format!("{number}: {error}")),
                    false => refused += 1,
                }
            }
        }
    }
    println!(
        "{served} served, {refused} refused with a dead point near the range, otherwise {otherwise:#?}"
    );
    assert!(served > refused);
    assert_eq!(otherwise, [""; 0]);
}
