//! The derivatives of as many results as inputs, and their inverse.

use linkage_core::Scalar;

use super::factors::Factors;
use super::singular_values::singular_values;
use super::vectors::{dot, transposed};

/// The derivatives of `N` results by `N` inputs.
///
/// Results and inputs can be chosen freely: for an ankle with two motors, the angles of the foot
/// with respect to those of the motors, or the reverse. At a singular position, quotients are not
/// finite.
///
/// ```
/// use linkage_runtime::jacobian::Jacobian;
///
/// // Two links of length 1 in the plane, one along x, the other along y: the velocities of the end
/// // by both angles.
/// let arm = Jacobian::of_inputs([[-1.0_f64, 1.0], [-1.0, 0.0]]);
/// assert_eq!(arm.results_of([0.1, 0.0]), [-0.1, 0.1]);
/// let [first, second] = arm.inputs_of([-0.1, 0.1]);
/// assert!((first - 0.1).abs() < 1e-15 && second.abs() < 1e-15);
/// // A force of 5 along y on the end: the torques that carry it.
/// assert_eq!(arm.efforts([0.0, 5.0]), [5.0, 0.0]);
/// assert!((arm.manipulability() - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobian<T, const N: usize> {
    /// A row for each result.
    rows: [[T; N]; N],
}

impl<T: Scalar, const N: usize> Jacobian<T, N> {
    /// Builds the Jacobian from the derivatives of each result with respect to all inputs, the
    /// results of `velocity(result)` in a function of several inputs.
    #[must_use]
    pub fn of_results(rows: [[T; N]; N]) -> Self {
        Self { rows }
    }

    /// Builds the Jacobian from the derivatives of all results with respect to each input:
    /// `velocity(point)` of a point of as many components as there are inputs, each converted to an
    /// array by `.into()`.
    #[must_use]
    pub fn of_inputs(columns: [[T; N]; N]) -> Self {
        Self {
            rows: transposed(columns),
        }
    }

    /// A row for each result.
    #[must_use]
    pub fn rows(&self) -> [[T; N]; N] {
        self.rows
    }

    /// The Jacobian without dimensions, for these units of results and inputs. Singular values,
    /// condition and manipulability compare results and inputs, which is only meaningful if they
    /// are of one kind. For an angle next to a length the unit is a length that belongs to the
    /// task.
    #[must_use]
    pub fn in_units(&self, results: [T; N], inputs: [T; N]) -> Self {
        Self {
            rows: core::array::from_fn(|row| {
                core::array::from_fn(|column| {
                    self.rows[row][column] * inputs[column] / results[row]
                })
            }),
        }
    }

    /// The speeds of the results for given speeds of the inputs.
    #[must_use]
    pub fn results_of(&self, inputs: [T; N]) -> [T; N] {
        self.rows.map(|row| dot(row, inputs))
    }

    /// The speeds of the inputs for given speeds of the results.
    #[must_use]
    pub fn inputs_of(&self, results: [T; N]) -> [T; N] {
        Factors::new(self.rows).solve(results)
    }

    /// The derivatives of the inputs by the results.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let factors = Factors::new(self.rows);
        let unit = |k| core::array::from_fn(|row| T::from_f64(if row == k { 1.0 } else { 0.0 }));
        Self::of_inputs(core::array::from_fn(|k| factors.solve(unit(k))))
    }

    /// The determinant; its sign changes where the mechanism passes a singular position.
    #[must_use]
    pub fn determinant(&self) -> T {
        Factors::new(self.rows).determinant()
    }

    /// The forces or torques at the inputs that do the same work as these at the results: `J^T`
    /// times the loads. Drives that carry the loads exert the opposite ones, without friction and
    /// masses.
    #[must_use]
    pub fn efforts(&self, loads: [T; N]) -> [T; N] {
        transposed(self.rows).map(|column| dot(column, loads))
    }

    /// The effect of these forces or torques at the inputs on the results.
    #[must_use]
    pub fn loads(&self, efforts: [T; N]) -> [T; N] {
        Factors::new(transposed(self.rows)).solve(efforts)
    }

    /// The singular values, the largest first: the lengths of the half axes of the ellipsoid of
    /// velocities that inputs of a total of 1 (the root of the sum of their squares) can give, by
    /// which loads are divided.
    #[must_use]
    pub fn singular_values(&self) -> [T; N] {
        singular_values(transposed(self.rows))
    }

    /// The largest singular value over the smallest: 1 where all directions are alike, infinite at
    /// a singular position. Errors and loads grow by at most this factor more in one direction than
    /// in another.
    #[must_use]
    pub fn condition(&self) -> T {
        let values = self.singular_values();
        values[0] / values[N - 1]
    }

    /// Yoshikawa's measure of how well the results can be moved, `sqrt(det(J J^T))`, here the size
    /// of the determinant (T. Yoshikawa, "Manipulability of robotic mechanisms", Int. J. Robotics
    /// Research 4, 1985).
    #[must_use]
    pub fn manipulability(&self) -> T {
        self.determinant().abs()
    }
}
