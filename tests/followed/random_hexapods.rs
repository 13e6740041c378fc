//! Random platforms and random walks of the follower against an independent solver. `LINKAGE_LONG=1` takes 1000 platforms and 1e7 steps.

use linkage::mechanism;
use linkage_random::Random;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::hexapod::REFERENCE;
use super::independent::{Pose, Rods};
use super::long;
use super::{FEET, JOINTS};

mechanism! {
    /// As `Hexapod`, with all joints as dimensions.
    pub struct AnyHexapod {
        unit mm;
        param foot1 = (310mm, 40mm, -12mm);
        param foot2 = (180mm, 275mm, 18mm);
        param foot3 = (-120mm, 300mm, -25mm);
        param foot4 = (-325mm, 60mm, 10mm);
        param foot5 = (-150mm, -290mm, 22mm);
        param foot6 = (205mm, -250mm, -8mm);
        param joint1 = (150mm, -60mm, -14mm);
        param joint2 = (130mm, 85mm, 9mm);
        param joint3 = (10mm, 160mm, -11mm);
        param joint4 = (-145mm, 75mm, 16mm);
        param joint5 = (-120mm, -105mm, -7mm);
        param joint6 = (35mm, -155mm, 12mm);
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
        loop distance(p + joint1.x * x + joint1.y * y + joint1.z * z, foot1) = l1;
        loop distance(p + joint2.x * x + joint2.y * y + joint2.z * z, foot2) = l2;
        loop distance(p + joint3.x * x + joint3.y * y + joint3.z * z, foot3) = l3;
        loop distance(p + joint4.x * x + joint4.y * y + joint4.z * z, foot4) = l4;
        loop distance(p + joint5.x * x + joint5.y * y + joint5.z * z, foot5) = l5;
        loop distance(p + joint6.x * x + joint6.y * y + joint6.z * z, foot6) = l6;
    }

    impl AnyHexapod {
        pub fn pose(l1, l2, l3, l4, l5, l6) -> Place { p, x, y }
    }
}

/// How far both solvers may be apart, in radians.
const APART: f64 = 1e-7;
/// Where they do not agree the other solver goes the way again in steps so much finer.
const FINER: f64 = 50.0;
/// Part of the determinant at the beginning of a way, below which it ends at a dead point indeed.
const DEAD: f64 = 0.05;

/// One way of so many may be given up where the pivots of the elimination, whose order was chosen at the estimates, become small.
const GIVEN_UP: usize = 100;

/// What became of ways.
#[derive(Debug, Default)]
struct Ways {
    gone: usize,
    /// Ended, and the other solver's too, at a dead point.
    ended: usize,
    /// Ended by the follower alone: how far, and which part of the determinant is left at the end of the way.
    given_up: Vec<[f64; 2]>,
    /// Not where the other solver is.
    jumps: Vec<String>,
}

fn body(at: &AnyHexapodFollower<'_>) -> Pose {
    let pose = at.pose();
    let matrix = Matrix3::from_columns(&[pose.x, pose.y, pose.x.cross(&pose.y)]);
    Pose {
        p: pose.p,
        turn: UnitQuaternion::from_matrix(&matrix),
    }
}

fn own() -> Rods {
    Rods {
        on_body: JOINTS.map(Vector3::from).to_vec(),
        on_ground: FEET.map(Vector3::from).to_vec(),
    }
}

impl Ways {
    /// Goes a way with both solvers; true if it was gone.
    fn go(
        &mut self,
        at: &mut AnyHexapodFollower<'_>,
        rods: &Rods,
        from: &Pose,
        to: [f64; 6],
    ) -> bool {
        let [a, b, c, d, e, f] = to;
        let followed = at.follow(a, b, c, d, e, f);
        let pose = at.pose();
        let held = |other: &Pose| rods.hold(other) / rods.hold(from);
        let apart = |other: &Pose| other.away(pose.p, pose.x, pose.y);
        let agree = |other: &Result<Pose, (f64, Pose)>| match (&followed, other) {
            (Ok(()), Ok(there)) => apart(there) < APART,
            (Err(_), Err((_, there))) => held(there).abs() < DEAD,
            _ => false,
        };
        let mut other = rods.go(from, &to, 1.0);
        if !agree(&other) {
            other = rods.go(from, &to, FINER);
        }
        match (&followed, &other) {
            _ if agree(&other) => {
                *if followed.is_ok() {
                    &mut self.gone
                } else {
                    &mut self.ended
                } += 1
            }
            (Err(error), Ok(there)) => self.given_up.push([error.share, held(there)]),
            (Err(error), Err((_, there))) => self.given_up.push([error.share, held(there)]),
            (Ok(()), Ok(there)) => self.jumps.push(format!(
                "{} away, {} and {} held",
                apart(there),
                held(&body(at)),
                held(there)
            )),
            (Ok(()), Err((share, there))) => {
                let held = [held(&body(at)), held(there)];
                self.jumps
                    .push(format!("gone, not beyond {share}, {held:?} held"));
            }
        }
        followed.is_ok()
    }
}

/// The slice of the workspace that the program `hexapod` shows: each cell straight from the reference.
#[test]
fn every_cell_of_a_slice_is_reached_or_behind_a_dead_point() {
    let hexapod = AnyHexapod::default().assemble().expect("it assembles");
    let [a, b, c, d, e, f] = REFERENCE;
    let start = hexapod.follower(a, b, c, d, e, f).expect("the reference");
    let (rods, from) = (own(), body(&start));
    let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.08)
        * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), -0.05)
        * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.35);
    let (mut ways, mut others) = (Ways::default(), Vec::new());
    // The row with the cell behind a dead point, or all.
    let rows = if long() { -20..=20 } else { 0..=0 };
    for x in -20..=20 {
        for y in rows.clone() {
            let p = Vector3::new(12.0 * f64::from(x), 12.0 * f64::from(y), 420.0);
            let wanted = Pose { p, turn };
            let to = rods.lengths(&wanted);
            if !to.iter().all(|leg| (370.0..=540.0).contains(leg)) {
                continue;
            }
            let mut at = start;
            let reached = ways.go(&mut at, &rods, &from, to);
            let pose = at.pose();
            let there = reached && wanted.away(pose.p, pose.x, pose.y) < 1e-6;
            if !there {
                let sign = rods.hold(&wanted) / rods.hold(&from);
                others.push((p.x, p.y, reached, sign));
            }
        }
    }
    println!("{ways:?}, at another pose: {others:?}");
    // The one that the lengths do not lead to is held from the other side: a dead point lies between.
    assert_eq!(others.len(), 1);
    assert!(others.iter().all(|(.., held)| *held < 0.0));
    assert_eq!(ways.jumps, [""; 0]);
    assert!(ways.given_up.is_empty());
}

#[test]
fn random_platforms_go_where_an_independent_solver_goes() {
    let mut random = Random::new(11);
    let count = if long() { 1000 } else { 3 };
    let (mut ways, mut platforms, mut refused, mut other) = (Ways::default(), 0, 0, 0);
    while platforms < count {
        // Near the estimates, so that these mean this pose.
        let estimate = Pose {
            p: Vector3::new(10.0, -20.0, 400.0),
            turn: UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.149),
        };
        let planted = estimate.moved(&mut random, 10.0, 0.03);
        let mut near = |place: [f64; 3], by: f64| {
            Vector3::from(place).map(|number| number + random.between(-by, by))
        };
        let joints = JOINTS.map(|joint| near(joint, 40.0));
        let feet: [_; 6] = std::array::from_fn(|k| {
            let joint = planted.p + planted.turn * joints[k];
            joint + REFERENCE[k] * (near(FEET[k], 60.0) - joint).normalize()
        });
        let rods = Rods {
            on_body: joints.to_vec(),
            on_ground: feet.to_vec(),
        };
        // A platform that is hardly held has another assembly beside this one.
        if rods.hold(&planted).abs() < 0.1 * own().hold(&estimate).abs() {
            continue;
        }
        platforms += 1;
        let [foot1, foot2, foot3, foot4, foot5, foot6] = feet;
        let [joint1, joint2, joint3, joint4, joint5, joint6] = joints;
        let hexapod = AnyHexapod {
            foot1,
            foot2,
            foot3,
            foot4,
            foot5,
            foot6,
            joint1,
            joint2,
            joint3,
            joint4,
            joint5,
            joint6,
        };
        let hexapod = match hexapod.assemble() {
            Ok(hexapod) => hexapod,
            Err(_) => {
                refused += 1;
                continue;
            }
        };
        let [a, b, c, d, e, f] = REFERENCE;
        let start = hexapod.follower(a, b, c, d, e, f).expect("the reference");
        let from = body(&start);
        if planted.away(from.p, from.turn * Vector3::x(), from.turn * Vector3::y()) > APART {
            other += 1;
        }
        for _ in 0..10 {
            let mut at = start;
            let to = rods.lengths(&from.moved(&mut random, 100.0, 0.5));
            ways.go(&mut at, &rods, &from, to);
        }
    }
    println!("{platforms} platforms, {refused} refused, {other} at another pose, {ways:?}");
    let all = ways.gone + ways.ended;
    assert_eq!(ways.jumps, [""; 0]);
    assert!(ways.given_up.len() * GIVEN_UP <= all);
    // Estimates that are no pose lead elsewhere, or to a dead point, where other assemblies are near.
    assert!(10 * refused <= platforms && 10 * other <= platforms);
}

/// Steps to random poses near by, wherever the platform may be: beside dead points it is stopped, and nowhere else.
#[test]
fn a_random_walk_stops_at_dead_points_and_never_jumps() {
    let hexapod = AnyHexapod::default().assemble().expect("it assembles");
    let [a, b, c, d, e, f] = REFERENCE;
    let mut at = hexapod.follower(a, b, c, d, e, f).expect("the reference");
    let rods = own();
    let first = body(&at);
    let mut here = first;
    let mut random = Random::new(5);
    let steps = if long() { 10_000_000 } else { 2000 };
    let (mut gone, mut stopped, mut ways) = (0, 0, Ways::default());
    while gone + stopped < steps {
        let there = here.moved(&mut random, 15.0, 0.04);
        let away = (there.p - first.p).norm() > 150.0 || there.turn.angle_to(&first.turn) > 0.8;
        // Poses on the other side of a dead point are another assembly.
        if away || rods.hold(&there) / rods.hold(&first) < 0.01 {
            continue;
        }
        let to = rods.lengths(&there);
        let [a, b, c, d, e, f] = to;
        let mut next = at;
        let followed = next.follow(a, b, c, d, e, f).is_ok();
        let pose = next.pose();
        if followed && there.away(pose.p, pose.x, pose.y) < 1e-7 {
            gone += 1;
            (at, here) = (next, there);
            continue;
        }
        // The straight way of the lengths does not lead to the pose: so it must be for the other solver, from the same pose.
        stopped += 1;
        let mut again = at;
        ways.go(&mut again, &rods, &here, to);
    }
    println!("{gone} steps gone, {stopped} not, of which {ways:?}");
    // Where two dead points follow each other closely small corrections are no proof: the size of the determinant says it.
    assert_eq!(ways.jumps, [""; 0]);
    assert!(ways.given_up.len() * GIVEN_UP <= ways.ended);
}
