//! Plane and space in one mechanism: a planar four-bar drives a rocker in space, which drives a planar slider.

use linkage::{Vector2, Vector3};
use linkage_interpreted::interpreted;

use super::{close, differences, turned};

interpreted! {
    pub struct Mixed {
        unit mm;
        param crank = 20mm;
        param coupler = 70mm;
        param rocker = 50mm;
        param ground = 75mm;
        param rod = 120mm;
        param arm = 60mm;
        param pivot = (100mm, 30mm, 80mm);
        param tilt = 60deg;
        param push = 90mm;
        input phi = 30deg in 0deg..720deg;
        unknown theta = 40deg;
        unknown chi = 90deg;
        unknown psi = 100deg;
        unknown y = 160mm;
        unknown alpha = 120deg;
        loop polar(crank, phi) + polar(coupler, theta) = (ground, 0) + polar(rocker, chi);
        let tip = (ground, 0) + polar(1.2 * rocker, chi);
        let axis = turn((0, 0, 1), (0, 1, 0), tilt);
        let ball = pivot + turn((0, arm, 0), axis, psi);
        loop distance((tip.x, tip.y, 0), ball) = rod;
        loop (ball.y, ball.z) + polar(push, alpha) = (0, y) + (20mm, 0);
    }

    impl Mixed {
        pub fn place(phi) -> Place { tip, ball, y, psi }
        pub fn motion(phi) -> Motion { v: velocity(y), a: acceleration(y) }
        pub fn accuracy(phi) -> Accuracy { s: sensitivity(y, [crank, tilt, pivot.z]) }
    }
}

#[test]
fn all_links_keep_their_lengths() {
    let mixed = Mixed::default().assemble().expect("it assembles");
    let mut strokes: Vec<f64> = Vec::new();
    for k in 0..72 {
        let phi = f64::from(10 * k).to_radians();
        let place = mixed.place(phi);
        let tip = Vector3::new(place.tip.x, place.tip.y, 0.0);
        close((place.ball - tip).norm(), 120.0, 1e-13);
        let axis = turned(Vector3::z(), Vector3::y(), 60f64.to_radians());
        let arm = turned(Vector3::y() * 60.0, axis, place.psi);
        let pivot = Vector3::new(100.0, 30.0, 80.0);
        assert!((pivot + arm - place.ball).norm() < 1e-11);
        let push = Vector2::new(20.0 - place.ball.y, place.y - place.ball.z);
        close(push.norm(), 90.0, 1e-13);
        let motion = mixed.motion(phi);
        let inside = phi.clamp(0.01, 12.5);
        let [v, a] = differences(|x| mixed.place(x).y, inside, 1e-4);
        if inside == phi {
            close(motion.v, v, 1e-5);
            close(motion.a, a, 1e-4);
        }
        strokes.push(place.y);
    }
    // The second turn repeats the first.
    (0..36).for_each(|k| close(strokes[k + 36], strokes[k], 1e-12));
}

#[test]
fn sensitivities_are_differences() {
    let found = Mixed::default()
        .assemble()
        .expect("it assembles")
        .accuracy(1.0)
        .s;
    let at = |change: [f64; 3]| {
        let mut changed = Mixed::default();
        changed.crank += change[0];
        changed.tilt += change[1];
        changed.pivot.z += change[2];
        changed.assemble().expect("it assembles").place(1.0).y
    };
    for (k, found) in found.into_iter().enumerate() {
        let step = |size: f64| std::array::from_fn(|i| if i == k { size } else { 0.0 });
        close(found, (at(step(1e-5)) - at(step(-1e-5))) / 2e-5, 1e-7);
    }
}
