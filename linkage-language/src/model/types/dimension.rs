//! Dimensions: powers of length, force and time, and their arithmetic.

/// Powers beyond this (in halves) are taken for a mistake; sums of two stay far from overflow.
const LIMIT: i32 = 64;

/// Powers of length, force and time of a quantity, in halves so that square roots stay exact (`2`
/// is a length, `4` an area).
///
/// A mass is force times time squared over length. Numbers and angles convert freely, so all powers
/// of both are 0. `angle` only chooses words in messages, units in docs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    pub half_lengths: i32,
    pub half_forces: i32,
    pub half_times: i32,
    /// Power of kilograms in the unit in which it is given and printed. The other powers are
    /// newtons, seconds and the length unit. It does not matter for [`Dimension::fits`]. See
    /// [`Dimension::internal_per_unit`].
    pub half_kilograms: i32,
    pub angle: bool,
}

impl Dimension {
    /// A bare number.
    pub const NUMBER: Dimension = Dimension {
        half_lengths: 0,
        half_forces: 0,
        half_times: 0,
        half_kilograms: 0,
        angle: false,
    };
    /// An angle; converts freely to and from a number.
    pub const ANGLE: Dimension = Dimension {
        angle: true,
        ..Dimension::NUMBER
    };
    /// A length.
    pub const LENGTH: Dimension = Dimension::from_powers(1, 0, 0);
    /// A force.
    pub const FORCE: Dimension = Dimension::from_powers(0, 1, 0);
    /// A moment; energy is of the same dimension.
    pub const MOMENT: Dimension = Dimension::from_powers(1, 1, 0);
    /// Work in a time.
    pub const POWER: Dimension = Dimension::from_powers(1, 1, -1);
    /// Length over time squared.
    pub const ACCELERATION: Dimension = Dimension::from_powers(1, 0, -2);
    /// In kilograms.
    pub const MASS: Dimension = Dimension {
        half_kilograms: 2,
        ..Dimension::from_powers(-1, 1, 2)
    };
    /// In kilograms times the length unit squared.
    pub const INERTIA: Dimension = Dimension {
        half_kilograms: 2,
        ..Dimension::from_powers(1, 1, 2)
    };

    /// Makes a dimension of whole powers of length, force and time.
    pub(in crate::model) const fn from_powers(lengths: i32, forces: i32, times: i32) -> Dimension {
        Dimension {
            half_lengths: 2 * lengths,
            half_forces: 2 * forces,
            half_times: 2 * times,
            half_kilograms: 0,
            angle: false,
        }
    }

    /// Returns true if the two can be added: numbers and angles are alike, and units do not matter.
    pub fn fits(self, other: Dimension) -> bool {
        self.powers() == other.powers()
    }

    /// Halves of length, force and time.
    pub(in crate::model) fn powers(self) -> (i32, i32, i32) {
        (self.half_lengths, self.half_forces, self.half_times)
    }

    pub(in crate::model) fn is_number_or_angle(self) -> bool {
        self.fits(Dimension::NUMBER)
    }

    /// Returns true if it consists of lengths and angles alone.
    pub(in crate::model) fn is_geometric(self) -> bool {
        self.half_forces == 0 && self.half_times == 0
    }

    /// Returns the dimension of a sum: an angle if one of the two is.
    pub(in crate::model) fn or(self, other: Dimension) -> Dimension {
        Dimension {
            angle: self.angle || other.angle,
            ..self
        }
    }

    /// Returns the dimension of a product; `None` for powers that are too large.
    pub(in crate::model) fn times(self, other: Dimension) -> Option<Dimension> {
        self.combined(other, 1, self.angle != other.angle)
    }

    /// Returns the dimension of a quotient, or of a derivative.
    pub(in crate::model) fn over(self, other: Dimension) -> Option<Dimension> {
        self.combined(other, -1, self.angle && !other.angle)
    }

    /// Returns the dimension of a speed (`order` 1) or an acceleration (2).
    pub(in crate::model) fn rate(self, order: i32) -> Dimension {
        Dimension {
            half_times: self.half_times - 2 * order,
            ..self
        }
    }

    /// Returns the dimension as results of arithmetic are printed: in kilograms for a mass times
    /// lengths, such as a moment of inertia, otherwise in newtons.
    pub(in crate::model) fn of_arithmetic(self) -> Dimension {
        let mass = self.half_kilograms;
        let is_mass = self.half_forces == mass && self.half_times == 2 * mass;
        Dimension {
            half_kilograms: if is_mass { mass } else { 0 },
            ..self
        }
    }

    /// Returns the dimension of a whole power.
    pub(in crate::model) fn to_the(self, power: i32) -> Option<Dimension> {
        let factor = Some(power).filter(|power| power.abs() <= LIMIT)?;
        Dimension::NUMBER.combined(self, factor, self.angle && power == 1)
    }

    /// Returns the dimension of a square root; `None` if that is not a half power.
    pub(in crate::model) fn root(self) -> Option<Dimension> {
        let halved = |halves: i32| (halves % 2 == 0).then_some(halves / 2);
        Some(Dimension {
            half_lengths: halved(self.half_lengths)?,
            half_forces: halved(self.half_forces)?,
            half_times: halved(self.half_times)?,
            half_kilograms: halved(self.half_kilograms)?,
            angle: false,
        })
    }

    /// Adds `factor` times the powers of `other`. Only angles, and products of angles and times,
    /// remember `angle`.
    fn combined(self, other: Dimension, factor: i32, angle: bool) -> Option<Dimension> {
        let power = |halves: i32, other: i32| {
            let power = halves + factor * other;
            (power.abs() <= LIMIT).then_some(power)
        };
        let half_lengths = power(self.half_lengths, other.half_lengths)?;
        let half_forces = power(self.half_forces, other.half_forces)?;
        Some(Dimension {
            half_lengths,
            half_forces,
            half_times: power(self.half_times, other.half_times)?,
            half_kilograms: power(self.half_kilograms, other.half_kilograms)?,
            angle: angle && half_lengths == 0 && half_forces == 0,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_survive_numbers_only() {
        let angle = Dimension::ANGLE;
        assert_eq!(angle.times(Dimension::NUMBER), Some(angle));
        assert_eq!(angle.over(angle), Some(Dimension::NUMBER));
        assert_eq!(angle.times(Dimension::LENGTH), Some(Dimension::LENGTH));
        assert_eq!(angle.over(Dimension::NUMBER), Some(angle));
        assert_eq!(Dimension::LENGTH.over(angle), Some(Dimension::LENGTH));
    }
}
