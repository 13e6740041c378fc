//! Vectors, rotations and positions of space.

/// A vector.
pub(crate) type Vector = [f64; 3];

/// The axes of coordinates.
pub(crate) const AXES: [Vector; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

pub(crate) fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn difference(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn scaled(a: Vector, factor: f64) -> Vector {
    a.map(|component| component * factor)
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(crate) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The vector of length 1; `None` for a vector without length.
pub(crate) fn unit(a: Vector) -> Option<Vector> {
    let size = length(a);
    (size > 1e-10 && size.is_finite()).then(|| scaled(a, 1.0 / size))
}

/// Two unit vectors across a unit vector; the three are right-handed.
pub(crate) fn normals(axis: Vector) -> [Vector; 2] {
    let size = axis.map(f64::abs);
    let least = (0..3).min_by(|i, j| size[*i].total_cmp(&size[*j]));
    let first = unit(cross(AXES[least.unwrap_or_default()], axis)).unwrap_or(AXES[0]);
    [first, cross(axis, first)]
}

/// A position: the axes of a frame as columns, and its origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Placement {
    pub(crate) axes: [Vector; 3],
    pub(crate) origin: Vector,
}

/// The fixed frame.
pub(crate) const FIXED: Placement = Placement {
    axes: AXES,
    origin: [0.0; 3],
};

impl Placement {
    /// A shift and a rotation about a unit vector.
    pub(crate) fn turned(axis: Vector, angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let axes = AXES.map(|a| {
            let along = scaled(axis, dot(axis, a) * (1.0 - cosine));
            sum(sum(scaled(a, cosine), along), scaled(cross(axis, a), sine))
        });
        Self {
            axes,
            origin: [0.0; 3],
        }
    }

    pub(crate) fn shifted(origin: Vector) -> Self {
        Self { origin, ..FIXED }
    }

    /// A direction of the frame in fixed axes.
    pub(crate) fn direction(&self, local: Vector) -> Vector {
        let [x, y, z] = self.axes;
        sum(
            sum(scaled(x, local[0]), scaled(y, local[1])),
            scaled(z, local[2]),
        )
    }

    /// A point of the frame in fixed coordinates.
    pub(crate) fn point(&self, local: Vector) -> Vector {
        sum(self.origin, self.direction(local))
    }

    /// A position within this frame.
    pub(crate) fn then(&self, inner: &Self) -> Self {
        Self {
            axes: inner.axes.map(|axis| self.direction(axis)),
            origin: self.point(inner.origin),
        }
    }

    /// The position in which this one is undone.
    pub(crate) fn inverse(&self) -> Self {
        let row = |k: usize| [self.axes[0][k], self.axes[1][k], self.axes[2][k]];
        let axes = [row(0), row(1), row(2)];
        let back = Self {
            axes,
            origin: [0.0; 3],
        };
        Self {
            origin: scaled(back.direction(self.origin), -1.0),
            ..back
        }
    }

    /// Roll, pitch and yaw: about the fixed x, y and z axis, one after the other.
    pub(crate) fn roll_pitch_yaw(origin: Vector, angles: Vector) -> Self {
        let [x, y, z] = [0, 1, 2].map(|k| Self::turned(AXES[k], angles[k]));
        Self {
            origin,
            ..z.then(&y).then(&x)
        }
    }

    /// A quaternion, its real part first.
    pub(crate) fn quaternion(origin: Vector, [w, x, y, z]: [f64; 4]) -> Option<Self> {
        let axis = unit([x, y, z]);
        let size = length([x, y, z]);
        if w.hypot(size) <= 1e-10 || size.is_nan() || w.is_nan() {
            return None;
        }
        let turned = match axis {
            Some(axis) => Self::turned(axis, 2.0 * size.atan2(w)),
            None => FIXED,
        };
        Some(Self { origin, ..turned })
    }

    /// A symmetric tensor of the frame in fixed axes.
    pub(crate) fn tensor(&self, local: &[Vector; 3]) -> [Vector; 3] {
        let inner = |axis: Vector| {
            let components = [0, 1, 2].map(|k| dot(self.axes[k], axis));
            let product = [0, 1, 2].map(|k| dot(local[k], components));
            self.direction(product)
        };
        AXES.map(inner)
    }
}
