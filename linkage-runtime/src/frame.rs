//! A frame in space: where a body is and how it is turned.

use core::fmt::{self, Debug, Formatter};
#[cfg(feature = "nalgebra")]
use nalgebra::{Isometry3, Matrix3, RealField, Rotation3, Translation3, UnitQuaternion};

use crate::support::named;
use crate::vectors::Vector3;
use linkage_core::Scalar;

/// A frame in space: a point and three perpendicular directions of length 1, right-handed. It is
/// the quantity `frame(origin, x, z)` of the language. The default is the fixed frame.
///
/// Everything is in fixed coordinates: `origin` in the mechanism's length unit, the axes are
/// numbers. Where the body cannot be assembled, or the directions that the frame was made from are
/// parallel, entries are NaN.
///
/// ```
/// use linkage_runtime::{Frame, Vector3};
///
/// // At (1, 0, 0), its x axis upwards.
/// let body = Frame {
///     origin: Vector3::new(1.0, 0.0, 0.0),
///     x: Vector3::new(0.0, 0.0, 1.0),
///     y: Vector3::new(0.0, 1.0, 0.0),
///     z: Vector3::new(-1.0, 0.0, 0.0),
/// };
/// let tip = body.point(Vector3::new(2.0, 0.5, 0.0));
/// assert_eq!(tip, Vector3::new(1.0, 0.5, 2.0));
/// assert_eq!(body.coordinates(tip), Vector3::new(2.0, 0.5, 0.0));
/// # #[cfg(feature = "nalgebra")]
/// assert!((body.isometry() * nalgebra::Point3::new(2.0, 0.5, 0.0) - tip).coords.norm() < 1e-15);
/// ```
#[derive(Clone, Copy, PartialEq)]
pub struct Frame<T = f64> {
    /// The position.
    pub origin: Vector3<T>,
    /// Direction of its x axis.
    pub x: Vector3<T>,
    /// Direction of its y axis.
    pub y: Vector3<T>,
    /// Direction of its z axis.
    pub z: Vector3<T>,
}

impl<T: Debug> Debug for Frame<T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { origin, x, y, z } = self;
        let mut shown = f.debug_struct("Frame");
        for (name, vector) in [("origin", origin), ("x", x), ("y", y), ("z", z)] {
            shown.field(name, &named(vector));
        }
        shown.finish()
    }
}

impl<T: Scalar> Frame<T> {
    /// The point with these coordinates in the frame, in fixed coordinates:
    /// `origin + a x + b y + c z`.
    #[inline]
    #[must_use]
    pub fn point(&self, local: Vector3<T>) -> Vector3<T> {
        let Self { origin, x, y, z } = self;
        let along = |k: usize| origin[k] + (x[k] * local.x + y[k] * local.y + z[k] * local.z);
        Vector3::new(along(0), along(1), along(2))
    }

    /// The coordinates in the frame of a point given in fixed coordinates.
    #[inline]
    #[must_use]
    pub fn coordinates(&self, point: Vector3<T>) -> Vector3<T> {
        let arm = [0, 1, 2].map(|k| point[k] - self.origin[k]);
        let along = |axis: &Vector3<T>| axis.x * arm[0] + axis.y * arm[1] + axis.z * arm[2];
        Vector3::new(along(&self.x), along(&self.y), along(&self.z))
    }
}

#[cfg(feature = "nalgebra")]
impl<T: RealField> Frame<T> {
    /// The rotation that turns the fixed axes into those of the frame: the matrix of its axes.
    #[must_use]
    pub fn rotation(&self) -> Rotation3<T> {
        let axes = [&self.x, &self.y, &self.z].map(Vector3::clone);
        Rotation3::from_matrix_unchecked(Matrix3::from_columns(&axes))
    }

    /// The motion from the fixed frame to this one: it takes coordinates in the frame to fixed
    /// coordinates.
    #[must_use]
    pub fn isometry(&self) -> Isometry3<T> {
        let rotation = UnitQuaternion::from_rotation_matrix(&self.rotation());
        Isometry3::from_parts(Translation3::from(self.origin.clone()), rotation)
    }
}

/// The fixed frame.
impl<T: Scalar> Default for Frame<T> {
    fn default() -> Self {
        let [zero, one] = [0.0, 1.0].map(T::from_f64);
        Self {
            origin: Vector3::new(zero, zero, zero),
            x: Vector3::new(one, zero, zero),
            y: Vector3::new(zero, one, zero),
            z: Vector3::new(zero, zero, one),
        }
    }
}
