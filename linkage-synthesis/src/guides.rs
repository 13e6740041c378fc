//! Links and sliders that can lead a body through poses.

use super::Pose;

/// A joint of the frame and a joint of the body that keep their distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pivots {
    /// The joint of the frame, a centre point.
    pub fixed: [f64; 2],
    /// The joint of the body, a circle point, in the body's frame.
    pub moving: [f64; 2],
}

impl Pivots {
    /// The distance of the joints in a pose.
    #[must_use]
    pub fn length(&self, pose: &Pose) -> f64 {
        let moving = pose.place(self.moving);
        (self.fixed[0] - moving[0]).hypot(self.fixed[1] - moving[1])
    }
}

/// The guides that can lead a body through poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dyad {
    /// A link with two revolute joints.
    Link(Pivots),
    /// A point of the body on a straight line of the frame: a slider of the frame with a revolute
    /// joint. It is a link whose fixed joint is at infinity.
    PointOnLine {
        /// The point, in the body's frame.
        moving: [f64; 2],
        /// Angle of the line, rad; it goes through the places of the point.
        angle: f64,
    },
    /// A straight line of the body through a point of the frame: a revolute joint of the frame with
    /// a slider. It is a link whose moving joint is at infinity.
    LineThroughPoint {
        /// The point of the frame.
        fixed: [f64; 2],
        /// Angle of the line in the body's frame, rad; it goes through the places of the point.
        angle: f64,
    },
}
