//! A frame of the plane: where a body is and how it is turned.

use core::fmt::{self, Debug, Formatter};
#[cfg(feature = "nalgebra")]
use nalgebra::{Isometry2, Matrix2, RealField, Rotation2, Translation2, UnitComplex};

use crate::support::named;
use crate::vectors::Vector2;
use linkage_core::Scalar;

/// A frame of the plane: a point and two perpendicular directions of length 1, the second one a
/// quarter of a turn from the first. It is the quantity `frame(origin, x)` of the language. The
/// default is the fixed frame.
///
/// Everything is in fixed coordinates: `origin` in the mechanism's length unit, the axes are
/// numbers. Where the body cannot be assembled entries are NaN. The angle with its turns is a
/// quantity of its own, `body.angle`.
///
/// ```
/// use linkage_runtime::{PlaneFrame, Vector2};
///
/// // At (1, 0), its x axis upwards.
/// let body = PlaneFrame {
///     origin: Vector2::new(1.0, 0.0),
///     x: Vector2::new(0.0, 1.0),
///     y: Vector2::new(-1.0, 0.0),
/// };
/// let tip = body.point(Vector2::new(2.0, 0.5));
/// assert_eq!(tip, Vector2::new(0.5, 2.0));
/// assert_eq!(body.coordinates(tip), Vector2::new(2.0, 0.5));
/// # #[cfg(feature = "nalgebra")]
/// assert!((body.isometry() * nalgebra::Point2::new(2.0, 0.5) - tip).coords.norm() < 1e-15);
/// ```
#[derive(Clone, Copy, PartialEq)]
pub struct PlaneFrame<T = f64> {
    /// The position.
    pub origin: Vector2<T>,
    /// Direction of its x axis.
    pub x: Vector2<T>,
    /// Direction of its y axis.
    pub y: Vector2<T>,
}

impl<T: Debug> Debug for PlaneFrame<T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { origin, x, y } = self;
        let mut shown = f.debug_struct("PlaneFrame");
        for (name, vector) in [("origin", origin), ("x", x), ("y", y)] {
            shown.field(name, &named(vector));
        }
        shown.finish()
    }
}

impl<T: Scalar> PlaneFrame<T> {
    /// The point with these coordinates in the frame, in fixed coordinates: `origin + a x + b y`.
    #[inline]
    #[must_use]
    pub fn point(&self, local: Vector2<T>) -> Vector2<T> {
        let Self { origin, x, y } = self;
        let along = |k: usize| origin[k] + (x[k] * local.x + y[k] * local.y);
        Vector2::new(along(0), along(1))
    }

    /// The coordinates in the frame of a point given in fixed coordinates.
    #[inline]
    #[must_use]
    pub fn coordinates(&self, point: Vector2<T>) -> Vector2<T> {
        let arm = [0, 1].map(|k| point[k] - self.origin[k]);
        let along = |axis: &Vector2<T>| axis.x * arm[0] + axis.y * arm[1];
        Vector2::new(along(&self.x), along(&self.y))
    }
}

#[cfg(feature = "nalgebra")]
impl<T: RealField> PlaneFrame<T> {
    /// The rotation that turns the fixed axes into those of the frame: the matrix of its axes.
    #[must_use]
    pub fn rotation(&self) -> Rotation2<T> {
        let axes = [&self.x, &self.y].map(Vector2::clone);
        Rotation2::from_matrix_unchecked(Matrix2::from_columns(&axes))
    }

    /// The motion from the fixed frame to this one: it takes coordinates in the frame to fixed
    /// coordinates.
    #[must_use]
    pub fn isometry(&self) -> Isometry2<T> {
        let rotation = UnitComplex::from_rotation_matrix(&self.rotation());
        Isometry2::from_parts(Translation2::from(self.origin.clone()), rotation)
    }
}

/// The fixed frame.
impl<T: Scalar> Default for PlaneFrame<T> {
    fn default() -> Self {
        let [zero, one] = [0.0, 1.0].map(T::from_f64);
        Self {
            origin: Vector2::new(zero, zero),
            x: Vector2::new(one, zero),
            y: Vector2::new(zero, one),
        }
    }
}
