//! The rocker at the end of a push rod: the travels at which the rod reaches it.

use crate::placement::{Placement, Vector, cross, difference, dot, length, unit};

/// The cosine of the rocker's angle to its dead point that is near enough to be avoided.
const BESIDE: f64 = 0.97;

/// The part that carries the outer end of the push rod, where it is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) enum Outer {
    Carrier(Vector),
    /// Coordinates in the frame of a wishbone, which has two fixed points and one on the carrier.
    Wishbone {
        front: Vector,
        rear: Vector,
        ball: Vector,
        local: Vector,
    },
}

/// A rocker and its push rod.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rocker {
    pub(super) outer: Outer,
    pub(super) pivot: Vector,
    /// Another point on its axis.
    pub(super) axis: Vector,
    /// The end of the push rod on the rocker, where it is drawn.
    pub(super) inner: Vector,
    pub(super) push_rod: f64,
}

/// The axes of a wishbone's frame.
pub(super) fn wishbone_axes(front: Vector, rear: Vector, ball: Vector) -> Option<[Vector; 3]> {
    let x = unit(difference(rear, front))?;
    let y = unit(cross(difference(ball, front), x))?;
    Some([x, y, cross(x, y)])
}

impl Rocker {
    /// True if the push rod reaches the rocker well at a placement of the carrier.
    pub(super) fn is_reached(&self, carrier: &Placement) -> bool {
        self.cosine(carrier)
            .is_some_and(|cosine| cosine.abs() < BESIDE)
    }

    /// The cosine of the angle between the rocker and the direction to the push rod, both seen along
    /// the axis.
    fn cosine(&self, carrier: &Placement) -> Option<f64> {
        let outer = match self.outer {
            Outer::Carrier(at) => carrier.point(at),
            Outer::Wishbone {
                front,
                rear,
                ball,
                local,
            } => {
                let axes = wishbone_axes(front, rear, carrier.point(ball))?;
                let frame = Placement {
                    axes,
                    origin: front,
                };
                frame.point(local)
            }
        };
        let axis = unit(difference(self.axis, self.pivot))?;
        let arm = difference(self.inner, self.pivot);
        let to_outer = difference(outer, self.pivot);
        let [height, far] = [arm, to_outer].map(|vector| dot(axis, vector));
        let [short, long] = [(arm, height), (to_outer, far)].map(|(vector, along)| {
            let square = dot(vector, vector) - along * along;
            square.max(0.0).sqrt()
        });
        // |outer|^2 + |arm|^2 - 2 (heights + short long cosine) = rod^2
        let squares = length(to_outer).powi(2) + length(arm).powi(2) - self.push_rod.powi(2);
        Some((0.5 * squares - height * far) / (short * long))
    }
}
