//! The screw of a body: the axis about which it turns and along which it shifts at one moment.

use core::array::from_fn;
use core::fmt::{self, Debug, Formatter};

use crate::support::named;
use crate::vectors::Vector3;
use linkage_core::Scalar;

/// The motion of a body at one moment: it turns about an axis and shifts along it, as a screw does
/// (theorem of Mozzi and Chasles: G. Mozzi, "Discorso matematico sopra il rotamento momentaneo dei
/// corpi", 1763; R. S. Ball, "A treatise on the theory of screws", 1900).
///
/// Everything is in fixed coordinates and per unit of the input, like `omega(body)` and
/// `velocity(body.origin)`: per radian of a crank, per millimetre of a travel. With the true
/// velocities it is per second. A body that does not turn has no axis: `turn` is 0, see
/// [`is_shift`](Self::is_shift). NaN in any argument makes everything NaN.
///
/// ```
/// use linkage_runtime::{Screw, Vector3};
///
/// // The origin of the body is at (5, 0, 0); it turns about a vertical axis and rises by 3 per
/// // radian.
/// let (omega, velocity) = (Vector3::new(0.0, 0.0, 2.0), Vector3::new(0.0, 4.0, 6.0));
/// let screw: Screw = Screw::of(omega, velocity, Vector3::new(5.0, 0.0, 0.0));
/// assert_eq!(screw.direction, Vector3::new(0.0, 0.0, 1.0));
/// assert_eq!(screw.point, Vector3::new(3.0, 0.0, 0.0));
/// assert_eq!((screw.turn, screw.shift, screw.pitch()), (2.0, 6.0, 3.0));
/// // A point of the axis moves along it only.
/// assert_eq!(screw.velocity(Vector3::new(3.0, 0.0, 70.0)), Vector3::new(0.0, 0.0, 6.0));
/// ```
#[derive(Clone, Copy, PartialEq)]
pub struct Screw<T = f64> {
    /// Direction of the axis, of length 1: that of the angular velocity, of a body that does not
    /// turn that of its velocity. Zero if it rests.
    pub direction: Vector3<T>,
    /// The point of the axis that is nearest to the point whose velocity was given; that point
    /// itself if the body does not turn.
    pub point: Vector3<T>,
    /// The angular speed about the axis, counter-clockwise seen against the direction: radians per
    /// unit of the input, never negative.
    pub turn: T,
    /// The speed along the axis, negative against the direction: length per unit of the input.
    pub shift: T,
}

impl<T: Scalar> Screw<T> {
    /// Builds the screw from the angular velocity of a body and the velocity of its point `at`,
    /// both with respect to the same input or both true ones: for a frame `omega(body)`,
    /// `velocity(body.origin)` and `body.origin`.
    ///
    /// With `w` for `omega` and `v` for `velocity` the axis goes through `at + w x v / w^2`, and
    /// the body shifts by `w . v / |w|`. Their errors are those of some roundings of `v`, at any
    /// size of the numbers; the axis of a body that hardly turns is far away. If it is farther than
    /// the largest number, turning makes no difference anywhere, and the motion is a shift.
    #[must_use]
    pub fn of(omega: Vector3<T>, velocity: Vector3<T>, at: Vector3<T>) -> Self {
        let (turning, moving) = (Scaled::new(omega), Scaled::new(velocity));
        let (axis, way) = (turning.direction(), moving.direction());
        // Powers of two are kept out of the products, which can neither overflow nor vanish.
        let ratio = turning.scale / moving.scale;
        let arm = cross(axis, moving.vector).map(|x| x / turning.length * ratio);
        let turns = T::from_lanes(|lane| {
            let lengths = [turning.length, moving.length].map(|length| length.lane(lane));
            if !lengths.iter().all(|length| length.is_finite()) {
                return f64::NAN;
            }
            if arm.iter().all(|x| x.lane(lane).is_finite()) {
                1.0
            } else {
                -1.0
            }
        });
        let choose = |turning, shifting| T::select(turns, turning, shifting);
        Self {
            direction: vector(from_fn(|k| choose(axis[k], way[k]))),
            point: vector(from_fn(|k| choose(at[k] + arm[k], at[k]))),
            turn: choose(turning.size(), T::from_f64(0.0)),
            shift: choose(dot(axis, moving.vector) / moving.scale, moving.size()),
        }
    }

    /// Returns true if the body does not turn: all its points move alike, by `shift` along
    /// `direction`, or not at all. For several motions side by side (lanes): true if none of them
    /// turns.
    #[must_use]
    pub fn is_shift(&self) -> bool {
        (0..T::LANES).all(|lane| self.turn.lane(lane) == 0.0)
    }

    /// The shift of the body for a turn by a radian, positive for a right-handed screw; infinite if
    /// it does not turn, NaN if it rests.
    #[must_use]
    pub fn pitch(&self) -> T {
        self.shift / self.turn
    }

    /// The velocity of the body at a point.
    #[must_use]
    pub fn velocity(&self, at: Vector3<T>) -> Vector3<T> {
        let direction = array(self.direction);
        let across = cross(direction, from_fn(|k| at[k] - self.point[k]));
        vector(from_fn(|k| {
            direction[k] * self.shift + across[k] * self.turn
        }))
    }

    /// The point of the axis that is nearest to a point; if the body does not turn, of the line on
    /// which `point` moves.
    #[must_use]
    pub fn nearest(&self, to: Vector3<T>) -> Vector3<T> {
        let direction = array(self.direction);
        let along = dot(direction, from_fn(|k| to[k] - self.point[k]));
        vector(from_fn(|k| self.point[k] + direction[k] * along))
    }
}

impl<T: Debug> Debug for Screw<T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("Screw")
            .field("direction", &named(&self.direction))
            .field("point", &named(&self.point))
            .field("turn", &self.turn)
            .field("shift", &self.shift)
            .finish()
    }
}

/// A vector brought to a size of about 1.
struct Scaled<T> {
    vector: [T; 3],
    /// The power of two that it was multiplied by.
    scale: T,
    /// Length of the scaled vector.
    length: T,
}

impl<T: Scalar> Scaled<T> {
    fn new(vector: Vector3<T>) -> Self {
        let [x, y, z] = array(vector);
        let scale = x.abs().max(y.abs()).max(z.abs()).inverse_scale();
        let vector = [x, y, z].map(|x| x * scale);
        Self {
            vector,
            scale,
            length: dot(vector, vector).sqrt(),
        }
    }

    /// Zero of a vector that is zero.
    fn direction(&self) -> [T; 3] {
        let zero = T::from_f64(0.0);
        self.vector
            .map(|x| T::select(-self.length, zero, x / self.length))
    }

    /// The length of the vector as it was.
    fn size(&self) -> T {
        self.length / self.scale
    }
}

fn array<T: Scalar>(v: Vector3<T>) -> [T; 3] {
    [v.x, v.y, v.z]
}

fn vector<T: Scalar>([x, y, z]: [T; 3]) -> Vector3<T> {
    Vector3::new(x, y, z)
}

fn dot<T: Scalar>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross<T: Scalar>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[cfg(test)]
mod tests;
