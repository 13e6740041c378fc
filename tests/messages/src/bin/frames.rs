//! Frames by every road: fields, constants, arrays, attributes, names of their own, sweeps.

#![deny(warnings)]

use linkage::{Vector3, mechanism};

mechanism! {
    /// A wrist.
    pub struct Wrist {
        unit mm;
        const base = frame((0, 0, 100mm), (1, 1, 0), (0, 0, 1));
        param frame = (30mm, 0mm, 10mm);
        param origin = point_in(base, (1mm, 2mm, 3mm)) +- 0.1mm;
        param point_in = 2mm;
        input yaw = 10deg;
        input roll = 20deg;
        let z = turn((0, 0, 1), base.x, roll);
        let hand = frame(origin, turn((1, 0, 0), (0, 0, 1), yaw), z);
        let again = hand;
        let tool = point_in(again, frame + (point_in, 0, 0));
    }

    impl Wrist {
        /// Where the hand is.
        #[derive(Debug, Clone)]
        pub fn hand(yaw, roll) -> Hand {
            /// The hand.
            hand,
            tool,
            axes: velocity(hand.x),
            local: coordinates_in(base, tool),
        }
        pub fn fixed() -> Fixed { base }
        pub fn frame(yaw, roll) -> Pose { frame: hand, x: hand.x.x, origin: hand.origin }
    }
}

fn main() {
    let wrist = Wrist::default().assemble().expect("nothing has to close");
    let hand = wrist.hand(0.3, 0.2);
    let base = wrist.fixed().base;
    assert!((base.point(hand.local) - hand.tool).norm() < 1e-12);
    assert!((hand.hand.point(Vector3::new(32.0, 0.0, 10.0)) - hand.tool).norm() < 1e-12);
    assert_eq!(hand.axes[1], Vector3::zeros());
    assert_eq!(hand.axes[0].z, 0.0);
    let copy = hand;
    assert_eq!(copy.hand, wrist.frame(0.3, 0.2).frame);
    let columns = wrist.frame_sweep(&[0.3, 0.4], &[0.2, 0.2]);
    let [origin, x, _, _] = columns.frame();
    assert_eq!((origin, x[0]), (columns.origin(), columns.x()));
    assert_eq!(
        linkage::Frame::<f64>::default().isometry(),
        Default::default()
    );
}
