//! A platform on six legs whose lengths are the inputs, without ranges: nine unknowns remain, forty solutions. It is followed from position to
//! position.

use linkage::mechanism;
use nalgebra::{Matrix3, Matrix6, UnitQuaternion, Vector3, Vector6};

use super::{FEET, JOINTS, close, number, numbers, path_of_platform};

mechanism! {
    /// The platform's origin is `p`, its directions are `x`, `y` and `z`.
    pub struct Hexapod {
        unit mm;
        input l1 = 454.35742mm;
        input l2 = 468.552604mm;
        input l3 = 488.341676mm;
        input l4 = 461.66999mm;
        input l5 = 410.067397mm;
        input l6 = 458.630351mm;
        unknown p = (10mm, -20mm, 400mm);
        unknown x = (1, 0.15, 0.05);
        unknown y = (-0.15, 1, 0.1);
        let z = cross(x, y);
        loop norm(x) = 1;
        loop norm(y) = 1;
        loop dot(x, y) = 0;
        loop distance(p + 150mm * x - 60mm * y - 14mm * z, (310mm, 40mm, -12mm)) = l1;
        loop distance(p + 130mm * x + 85mm * y + 9mm * z, (180mm, 275mm, 18mm)) = l2;
        loop distance(p + 10mm * x + 160mm * y - 11mm * z, (-120mm, 300mm, -25mm)) = l3;
        loop distance(p - 145mm * x + 75mm * y + 16mm * z, (-325mm, 60mm, 10mm)) = l4;
        loop distance(p - 120mm * x - 105mm * y - 7mm * z, (-150mm, -290mm, 22mm)) = l5;
        loop distance(p + 35mm * x - 155mm * y + 12mm * z, (205mm, -250mm, -8mm)) = l6;
    }

    impl Hexapod {
        pub fn pose(l1, l2, l3, l4, l5, l6) -> Pose { p, x, y }
        pub fn jacobian(l1, l2, l3, l4, l5, l6) -> Jacobian { p: velocity(p), x: velocity(x), y: velocity(y) }
    }
}

pub(super) const REFERENCE: [f64; 6] = [
    454.35742, 468.552604, 488.341676, 461.66999, 410.067397, 458.630351,
];

fn legs(p: Vector3<f64>, turn: UnitQuaternion<f64>) -> [f64; 6] {
    std::array::from_fn(|k| (p + turn * Vector3::from(JOINTS[k]) - Vector3::from(FEET[k])).norm())
}

/// The determinant of what the legs do, in mm and 100 mm.
fn regular(p: Vector3<f64>, turn: UnitQuaternion<f64>) -> f64 {
    let rows = (0..6).map(|k| {
        let arm = turn * Vector3::from(JOINTS[k]);
        let leg = (p + arm - Vector3::from(FEET[k])).normalize();
        let moment = arm.cross(&leg) / 100.0;
        Vector6::new(leg.x, leg.y, leg.z, moment.x, moment.y, moment.z).transpose()
    });
    Matrix6::from_rows(&rows.collect::<Vec<_>>()).determinant()
}

/// The follower of the engine has the numbers of the macro's, to the last bit, and its messages.
#[test]
fn the_engine_follows_to_the_same_positions() {
    let hexapod = Hexapod::default().assemble().expect("it assembles");
    let [a, b, c, d, e, f] = REFERENCE;
    let mut at = hexapod.follower(a, b, c, d, e, f).expect("the reference");
    let all = linkage_engine::compile("hexapod.rs", include_str!("hexapod.rs"));
    let all = all.expect("it has no mistake");
    let assembly = all[0].assemble(&[]).expect("it assembles");
    let mut same = assembly.follower(&REFERENCE).expect("the reference");
    let mut stops = 0;
    for step in 0..400 {
        let time = 0.05 * f64::from(step);
        let legs: [f64; 6] = std::array::from_fn(|k| {
            let rate = 1.0 + 0.3 * f64::from(k as u8);
            REFERENCE[k] + 40.0 * (time * rate).sin()
        });
        let [a, b, c, d, e, f] = legs;
        let followed = at.follow(a, b, c, d, e, f);
        assert_eq!(followed, same.follow(&legs), "step {step}");
        stops += usize::from(followed.is_err());
        let (pose, jacobian) = (at.pose(), at.jacobian());
        let derivatives = [jacobian.p, jacobian.x, jacobian.y];
        let rows = [vec![pose.p, pose.x, pose.y], derivatives.concat()];
        for (function, row) in rows.iter().enumerate() {
            let expected = row.iter().flat_map(|vector| vector.iter());
            let expected: Vec<u64> = expected.map(|x| x.to_bits()).collect();
            let found = same.call(function, &legs);
            let found: Vec<u64> = found.iter().map(|x| x.to_bits()).collect();
            assert_eq!(found, expected, "step {step}");
        }
    }
    assert!(stops > 0 && stops < 400, "{stops} stops");
}

#[test]
fn a_path_of_poses_is_where_it_was_computed_with_80_digits() {
    let hexapod = Hexapod::default().assemble().expect("it assembles");
    let [a, b, c, d, e, f] = REFERENCE;
    let mut at = hexapod.follower(a, b, c, d, e, f).expect("the reference");
    let path = path_of_platform();
    assert_eq!(path.len(), 20);
    for known in path {
        let [a, b, c, d, e, f] = numbers::<6>(&known["legs"]);
        at.follow(a, b, c, d, e, f).expect("it is followed");
        let pose = at.pose();
        for (found, known) in pose.p.iter().zip(numbers::<3>(&known["p"])) {
            close(*found, known, 420.0, 1e-14);
        }
        for row in 0..3 {
            let [x, y, _] = numbers::<3>(&known["R"][row]);
            close(pose.x[row], x, 1.0, 1e-14);
            close(pose.y[row], y, 1.0, 1e-14);
        }
        let jacobian = at.jacobian();
        for leg in 0..6 {
            let column: [f64; 6] = std::array::from_fn(|row| number(&known["jacobian"][row][leg]));
            for (found, known) in jacobian.p[leg].iter().zip(&column) {
                close(*found, *known, 1.0, 1e-12);
            }
            let omega = Vector3::new(column[3], column[4], column[5]);
            assert!((jacobian.x[leg] - omega.cross(&pose.x)).norm() < 1e-14);
            assert!((jacobian.y[leg] - omega.cross(&pose.y)).norm() < 1e-14);
        }
    }
}

/// Single precision has 24 bits. Of 7 digits a platform whose condition is 60 (`body.rs`) leaves 5, elimination some 4 of derivatives.
#[test]
fn the_same_path_in_single_precision() {
    let hexapod = Hexapod::default().cast::<f32>();
    let hexapod = hexapod.assemble().expect("it assembles");
    let [a, b, c, d, e, f] = REFERENCE.map(|leg| leg as f32);
    let mut at = hexapod.follower(a, b, c, d, e, f).expect("the reference");
    for known in path_of_platform() {
        let [a, b, c, d, e, f] = numbers::<6>(&known["legs"]).map(|leg| leg as f32);
        at.follow(a, b, c, d, e, f).expect("it is followed");
        assert_eq!(at.inputs(), [a, b, c, d, e, f]);
        let (pose, jacobian) = (at.pose(), at.jacobian());
        for (found, known) in pose.p.iter().zip(numbers::<3>(&known["p"])) {
            close(f64::from(*found), known, 420.0, 3e-6);
        }
        for leg in 0..6 {
            let column: [f64; 3] = std::array::from_fn(|row| number(&known["jacobian"][row][leg]));
            for (found, known) in jacobian.p[leg].iter().zip(column) {
                close(f64::from(*found), known, 1.0, 5e-4);
            }
        }
    }
    // Where it cannot go on it stays.
    let before = at;
    assert!(at.follow(a, b, c, d, e, 2.0 * f).is_err());
    assert_eq!(at.inputs(), before.inputs());
}

/// Legs of random poses, each near the one before, while the platform stays regular: no pose is lost, none is another one.
#[test]
fn random_walks_stay_on_the_assembly() {
    let hexapod = Hexapod::default().assemble().expect("it assembles");
    let [a, b, c, d, e, f] = REFERENCE;
    let mut at = hexapod.follower(a, b, c, d, e, f).expect("the reference");
    let own = at.pose();
    let matrix = Matrix3::from_columns(&[own.x, own.y, own.x.cross(&own.y)]);
    let first = UnitQuaternion::from_matrix(&matrix);
    let (mut p, mut turn) = (own.p, first);
    let at_reference = regular(p, turn);
    let mut random = linkage_random::Random::new(7);
    let (mut steps, mut lost) = (0, 0);
    while steps < 20_000 {
        let mut number = || random.between(-1.0, 1.0);
        let shift = Vector3::new(number(), number(), number()) * 15.0;
        let way = Vector3::new(number(), number(), number()) * 0.04;
        let (q, next) = (p + shift, UnitQuaternion::new(way) * turn);
        let away = (q - own.p).norm() > 120.0 || next.angle_to(&first) > 0.5;
        if away || regular(q, next) / at_reference < 0.2 {
            continue;
        }
        steps += 1;
        let [a, b, c, d, e, f] = legs(q, next);
        lost += usize::from(at.follow(a, b, c, d, e, f).is_err());
        let pose = at.pose();
        assert!((pose.p - q).norm() < 1e-9, "step {steps}");
        assert!(
            (pose.x - next * Vector3::x()).norm() < 1e-11,
            "step {steps}"
        );
        (p, turn) = (q, next);
    }
    assert_eq!(lost, 0);
}

#[test]
fn a_way_out_of_reach_stops_and_says_where() {
    let hexapod = Hexapod::default().assemble().expect("it assembles");
    let [a, b, c, d, e, f] = REFERENCE;
    let at = hexapod.follower(a, b, c, d, e, f).expect("the reference");
    let mut beyond = at;
    let error = beyond
        .follow(2.0 * a, b, c, d, e, f)
        .expect_err("out of reach");
    assert!(error.share > 0.05 && error.share < 0.95, "{error}");
    assert_eq!(beyond.inputs(), REFERENCE);
    assert_eq!(beyond.pose(), at.pose());
    // Inputs alone are served at the reference only.
    assert!(hexapod.pose(a, b, c, d, e, f).p.x.is_finite());
    assert!(hexapod.pose(a + 40.0, b, c, d, e, f).p.x.is_nan());
}
