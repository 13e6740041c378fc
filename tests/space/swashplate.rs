//! The swashplate of a helicopter: a plate on a ball that slides along the mast, tilted by three servos with an arm and a rod each. Both ways.

use linkage::mechanism;
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::close;

mechanism! {
    /// Plate to servos: three closed forms.
    pub struct ToServos {
        unit mm;
        param radius = 40mm;
        param arm = 18mm;
        param rod = 55mm;
        const up = (0, 0, 1);
        input height = 60mm in 54mm..66mm;
        input pitch = 0deg in -10deg..10deg;
        input roll = 0deg in -10deg..10deg;
        unknown s1 = 0deg;
        unknown s2 = 0deg;
        unknown s3 = 0deg;
        let lift = (0mm, 0mm, height);
        let joint = (radius, 0mm, 0mm);
        let tilted1 = lift + turn(turn(joint, (1, 0, 0), roll), (0, 1, 0), pitch);
        let tilted2 = lift + turn(turn(turn(joint, up, 120deg), (1, 0, 0), roll), (0, 1, 0), pitch);
        let tilted3 = lift + turn(turn(turn(joint, up, 240deg), (1, 0, 0), roll), (0, 1, 0), pitch);
        // The servos turn about axes that point to the mast.
        let shaft = (45mm, -17mm, 5mm);
        let horn1 = shaft + turn((0, arm, 0), (1, 0, 0), s1);
        let horn2 = turn(shaft + turn((0, arm, 0), (1, 0, 0), s2), up, 120deg);
        let horn3 = turn(shaft + turn((0, arm, 0), (1, 0, 0), s3), up, 240deg);
        loop distance(horn1, tilted1) = rod;
        loop distance(horn2, tilted2) = rod;
        loop distance(horn3, tilted3) = rod;
    }
    impl ToServos {
        pub fn servos(height, pitch, roll) -> Servos { s1, s2, s3 }
        pub fn speeds(height, pitch, roll) -> Speeds { s1: velocity(s1), s2: velocity(s2), s3: velocity(s3) }
    }
}

mechanism! {
    /// Servos to plate: height and both tilts together.
    pub struct ToPlate {
        unit mm;
        param radius = 40mm;
        param arm = 18mm;
        param rod = 55mm;
        const up = (0, 0, 1);
        input s1 = 0deg;
        input s2 = 0deg;
        input s3 = 0deg;
        unknown height = 60mm;
        unknown pitch = 0deg;
        unknown roll = 0deg;
        let lift = (0mm, 0mm, height);
        let joint = (radius, 0mm, 0mm);
        let tilted1 = lift + turn(turn(joint, (1, 0, 0), roll), (0, 1, 0), pitch);
        let tilted2 = lift + turn(turn(turn(joint, up, 120deg), (1, 0, 0), roll), (0, 1, 0), pitch);
        let tilted3 = lift + turn(turn(turn(joint, up, 240deg), (1, 0, 0), roll), (0, 1, 0), pitch);
        let shaft = (45mm, -17mm, 5mm);
        let horn1 = shaft + turn((0, arm, 0), (1, 0, 0), s1);
        let horn2 = turn(shaft + turn((0, arm, 0), (1, 0, 0), s2), up, 120deg);
        let horn3 = turn(shaft + turn((0, arm, 0), (1, 0, 0), s3), up, 240deg);
        loop distance(horn1, tilted1) = rod;
        loop distance(horn2, tilted2) = rod;
        loop distance(horn3, tilted3) = rod;
    }
    impl ToPlate {
        pub fn plate(s1, s2, s3) -> Plate { height, pitch, roll }
        pub fn tilts(s1, s2, s3) -> Tilts { height: velocity(height), pitch: velocity(pitch), roll: velocity(roll) }
    }
}

/// Where the arm of a servo points: seen from its own third of a turn the rod ends on a circle in the plane of the arm, which that of the arm meets
/// twice; of the two places the outer one, where the arm lies along y.
fn servo(third: f64, [height, pitch, roll]: [f64; 3]) -> f64 {
    let about_mast = Rotation3::from_axis_angle(&Vector3::z_axis(), third);
    let tilt = Rotation3::from_axis_angle(&Vector3::y_axis(), pitch)
        * Rotation3::from_axis_angle(&Vector3::x_axis(), roll);
    let joint = Vector3::new(0.0, 0.0, height) + tilt * (about_mast * Vector3::new(40.0, 0.0, 0.0));
    let seen = about_mast.inverse() * joint - Vector3::new(45.0, -17.0, 5.0);
    let rod = 55.0_f64 * 55.0 - seen.x * seen.x;
    let far = seen.y.hypot(seen.z);
    let between = (18.0 * 18.0 + far * far - rod) / (2.0 * 18.0 * far);
    seen.z.atan2(seen.y) - between.acos()
}

const THIRD: f64 = std::f64::consts::TAU / 3.0;

/// Heights and tilts all over the ranges.
fn plates() -> impl Iterator<Item = [f64; 3]> {
    (0..40).map(|k| {
        let t = 0.37 * f64::from(k);
        [
            60.0 + 5.5 * (2.0 * t).sin(),
            0.16 * t.sin(),
            0.16 * (3.0 * t).cos(),
        ]
    })
}

#[test]
fn servos_stand_where_circles_meet_and_lead_back_to_the_plate() {
    let to_servos = ToServos::default().assemble().expect("it assembles");
    let to_plate = ToPlate::default().assemble().expect("it assembles");
    let mut at = to_plate.follower(0.0, 0.0, 0.0).expect("the reference");
    for plate in plates() {
        let known = [0.0, 1.0, 2.0].map(|k| servo(k * THIRD, plate));
        let [height, pitch, roll] = plate;
        let found = to_servos.servos(height, pitch, roll);
        let pairs = [found.s1, found.s2, found.s3].into_iter().zip(known);
        pairs.for_each(|(found, known)| close(found, known, 1e-14));
        let [s1, s2, s3] = known;
        at.follow(s1, s2, s3).expect("it is followed");
        let back = at.plate();
        let pairs = [back.height, back.pitch, back.roll].into_iter().zip(plate);
        pairs.for_each(|(found, known)| close(found, known, 1e-14));
        // Each way undoes the other.
        let (there, back) = (to_servos.speeds(height, pitch, roll), at.tilts());
        let [there, back] = [
            [there.s1, there.s2, there.s3],
            [back.height, back.pitch, back.roll],
        ]
        .map(|rows| Matrix3::from_fn(|i, k| rows[i][k]));
        close((there * back - Matrix3::identity()).norm(), 0.0, 1e-13);
    }
}

#[test]
fn servos_turn_as_differences_say() {
    let to_servos = ToServos::default().assemble().expect("it assembles");
    for plate in plates().step_by(5) {
        let [height, pitch, roll] = plate;
        let speeds = to_servos.speeds(height, pitch, roll);
        for (servo_of, speed) in [speeds.s1, speeds.s2, speeds.s3].into_iter().enumerate() {
            let third = servo_of as f64 * THIRD;
            for (input, found) in speed.into_iter().enumerate() {
                let along = |x: f64| {
                    let mut moved = plate;
                    moved[input] = x;
                    servo(third, moved)
                };
                let [known, _] = super::differences(along, plate[input], 1e-5);
                close(found, known, 1e-8);
            }
        }
    }
}
