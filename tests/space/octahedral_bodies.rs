//! Platforms whose six legs meet in three points of it, as one unknown body: all real assemblies, and what each of the legs does to each of them,
//! against those of a published method, computed with 80 digits.

use linkage::Vector3;
use linkage_interpreted::interpreted;
use serde_json::Value;

interpreted! {
    /// The same platform on flat feet as one unknown body.
    pub struct FlatBody {
        unit mm;
        param leg2 = 355.3487mm;
        param leg3 = 360.3196mm;
        param leg4 = 352.8634mm;
        param leg5 = 340.0531mm;
        param leg6 = 327.7981mm;
        input leg = 360.5723mm in 356mm..366mm;
        unknown body = frame((10mm, -14mm, 310mm), (1, 0.1, 0.1), (-0.1, -0.1, 1));
        let p1 = point_in(body, (150.0mm, 8.0mm, 0.0mm));
        let p2 = point_in(body, (-80.0mm, 125.0mm, 0.0mm));
        let p3 = point_in(body, (-70.0mm, -135.0mm, 0.0mm));
        loop distance(p1, (300.0mm, -55.0mm, 0.0mm)) = leg;
        loop distance(p1, (290.0mm, 70.0mm, 0.0mm)) = leg2;
        loop distance(p2, (-95.0mm, 285.0mm, 0.0mm)) = leg3;
        loop distance(p2, (-205.0mm, 220.0mm, 0.0mm)) = leg4;
        loop distance(p3, (-190.0mm, -235.0mm, 0.0mm)) = leg5;
        loop distance(p3, (-85.0mm, -290.0mm, 0.0mm)) = leg6;
    }
    impl FlatBody {
        pub fn pose(leg) -> FlatBodyPose { p1, p2, p3 }
        pub fn legs(leg) -> FlatBodyLegs {
            v1: velocity(p1), v2: velocity(p2), v3: velocity(p3),
            s1: sensitivity(p1), s2: sensitivity(p2), s3: sensitivity(p3),
        }
    }
}

interpreted! {
    /// Three feet, each of two legs.
    pub struct OctahedralBody {
        unit mm;
        param leg2 = 319.1792mm;
        param leg3 = 357.1694mm;
        param leg4 = 378.7893mm;
        param leg5 = 369.2077mm;
        param leg6 = 341.5146mm;
        input leg = 383.7916mm in 379mm..388mm;
        unknown body = frame((-8mm, 12mm, 260mm), (1, 0.1, -0.1), (0.1, 0.05, 1));
        let p1 = point_in(body, (75.0mm, 150.0mm, 0.0mm));
        let p2 = point_in(body, (-165.0mm, 5.0mm, 0.0mm));
        let p3 = point_in(body, (80.0mm, -140.0mm, 0.0mm));
        loop distance(p1, (280.0mm, -15.0mm, 0.0mm)) = leg;
        loop distance(p1, (-150.0mm, 245.0mm, 12.0mm)) = leg2;
        loop distance(p2, (-150.0mm, 245.0mm, 12.0mm)) = leg3;
        loop distance(p2, (-130.0mm, -250.0mm, -9.0mm)) = leg4;
        loop distance(p3, (-130.0mm, -250.0mm, -9.0mm)) = leg5;
        loop distance(p3, (280.0mm, -15.0mm, 0.0mm)) = leg6;
    }
    impl OctahedralBody {
        pub fn pose(leg) -> OctahedralBodyPose { p1, p2, p3 }
        pub fn legs(leg) -> OctahedralBodyLegs {
            v1: velocity(p1), v2: velocity(p2), v3: velocity(p3),
            s1: sensitivity(p1), s2: sensitivity(p2), s3: sensitivity(p3),
        }
    }
}

/// The three points of an assembly, and of each leg how it moves them.
struct Moving {
    points: [Vector3<f64>; 3],
    by_legs: [[Vector3<f64>; 3]; 6],
}

/// The assemblies of a platform: a column of the Jacobian has the velocity of the platform's origin and its angular velocity.
fn known(platform: &str) -> Vec<Moving> {
    let text = include_str!("octahedral.json");
    let all: Value = serde_json::from_str(text).expect("JSON");
    let all = all[platform].as_array().expect("a list");
    all.iter()
        .map(|own| {
            let origin = vector(&own["origin"]);
            let points = [0, 1, 2].map(|k| vector(&own["points"][k]));
            let by_legs = std::array::from_fn(|leg| {
                let column: [f64; 6] =
                    std::array::from_fn(|row| number(&own["jacobian"][row][leg]));
                let [v, w] = [0, 3].map(|k| Vector3::new(column[k], column[k + 1], column[k + 2]));
                points.map(|p| v + w.cross(&(p - origin)))
            });
            Moving { points, by_legs }
        })
        .collect()
}

fn number(value: &Value) -> f64 {
    let digits = value.as_str().expect("a string of digits");
    digits.parse().expect("a number")
}

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from_fn(|k, _| number(&value[k]))
}

fn apart(a: &[Vector3<f64>; 3], b: &[Vector3<f64>; 3]) -> f64 {
    let pairs = a.iter().zip(b);
    pairs.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

fn compare(found: &[Moving], platform: &str) {
    let known = known(platform);
    assert_eq!((found.len(), known.len()), (8, 8));
    for known in known {
        let mut all = found.iter();
        let same = all.find(|own| apart(&own.points, &known.points) < 1e-10);
        let same = same.unwrap_or_else(|| panic!("{:?} is missing", known.points));
        for (leg, (found, known)) in same.by_legs.iter().zip(&known.by_legs).enumerate() {
            let off = apart(found, known);
            assert!(off < 1e-11, "leg {}: {off:e}", leg + 1);
        }
    }
}

/// What an assembly does at the lengths that are known.
macro_rules! moving {
    ($assembly:expr, $leg:expr) => {{
        let (pose, legs) = ($assembly.pose($leg), $assembly.legs($leg));
        let others = |k: usize| [legs.s1[k], legs.s2[k], legs.s3[k]];
        Moving {
            points: [pose.p1, pose.p2, pose.p3],
            by_legs: [
                [legs.v1, legs.v2, legs.v3],
                others(0),
                others(1),
                others(2),
                others(3),
                others(4),
            ],
        }
    }};
}

/// Two rods meet in each of three points of the body, so that three angles remain of its nine unknowns.
#[test]
fn a_body_on_pairs_of_legs_has_all_assemblies_of_its_points() {
    let group = &FlatBody::structure().groups[0];
    assert_eq!((group.kind, group.loops.len()), ("3 loops in space", 6));
    let all = FlatBody::default().assemblies().expect("they are listed");
    let found = all.iter().map(|own| moving!(own, 360.5723));
    compare(&found.collect::<Vec<_>>(), "flat");
}

#[test]
fn a_body_on_three_feet_has_all_assemblies_that_are_known() {
    let all = OctahedralBody::default()
        .assemblies()
        .expect("they are listed");
    let found = all.iter().map(|own| moving!(own, 383.7916));
    compare(&found.collect::<Vec<_>>(), "octahedral");
}
