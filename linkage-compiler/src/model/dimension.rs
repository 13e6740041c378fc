//! Arithmetic of dimensions and their names in messages.

use std::fmt::{self, Display, Formatter};

use super::types::{Dimension, Type};

/// Powers of length beyond this are taken for a mistake; sums of two stay far from overflow.
const HALF_LENGTHS_LIMIT: i32 = 64;

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
    pub const LENGTH: Dimension = Dimension {
        half_lengths: 2,
        ..Dimension::NUMBER
    };

    /// Whether the two may be added: numbers and angles are alike.
    pub fn fits(self, other: Dimension) -> bool {
        self.half_lengths == other.half_lengths
    }

    pub(super) fn is_number_or_angle(self) -> bool {
        self.half_lengths == 0
    }

    /// Of a sum: an angle if one of the two is.
    pub(super) fn or(self, other: Dimension) -> Dimension {
        Dimension {
            angle: self.angle || other.angle,
            ..self
        }
    }

    /// Of a product; `None` for a power of length beyond all use.
    pub(super) fn times(self, other: Dimension) -> Option<Dimension> {
        Self::new(
            self.half_lengths + other.half_lengths,
            self.angle != other.angle,
        )
    }

    /// Of a quotient, a derivative too.
    pub(super) fn over(self, other: Dimension) -> Option<Dimension> {
        Self::new(
            self.half_lengths - other.half_lengths,
            self.angle && !other.angle,
        )
    }

    /// Of a square root; `None` if that is not a half power.
    pub(super) fn root(self) -> Option<Dimension> {
        (self.half_lengths % 2 == 0).then_some(Dimension {
            half_lengths: self.half_lengths / 2,
            ..Dimension::NUMBER
        })
    }

    fn new(half_lengths: i32, angle: bool) -> Option<Dimension> {
        let in_range = half_lengths.abs() <= HALF_LENGTHS_LIMIT;
        in_range.then_some(Dimension {
            half_lengths,
            angle: angle && half_lengths == 0,
            ..Dimension::NUMBER
        })
    }

    /// In the plural, for the components of a vector.
    fn plural(self) -> String {
        match (self.half_lengths, self.angle) {
            (0, false) => "numbers".to_owned(),
            (0, true) => "angles".to_owned(),
            (2, _) => "lengths".to_owned(),
            _ => self.power(),
        }
    }

    fn power(self) -> String {
        match self.half_lengths {
            halves if halves % 2 != 0 => format!("length^({halves}/2)"),
            halves => format!("length^{}", halves / 2),
        }
    }
}

/// With its article: `a number`, `an angle`, `a length`, `a length^2`.
impl Display for Dimension {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match (self.half_lengths, self.angle) {
            (0, false) => f.write_str("a number"),
            (0, true) => f.write_str("an angle"),
            (2, _) => f.write_str("a length"),
            _ => write!(f, "a {}", self.power()),
        }
    }
}

/// With its article: `a length`, `a plane vector of lengths`.
impl Display for Type {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Type::Scalar(dimension) => write!(f, "{dimension}"),
            Type::Vector(3, dimension) => write!(f, "a space vector of {}", dimension.plural()),
            Type::Vector(_, dimension) => write!(f, "a plane vector of {}", dimension.plural()),
            Type::Array(entries) if entries.len() == 1 => f.write_str("an array of 1 entry"),
            Type::Array(entries) => write!(f, "an array of {} entries", entries.len()),
            Type::Frame => f.write_str("a frame"),
            Type::Zero(1) => f.write_str("zero"),
            Type::Zero(3) => f.write_str("a space vector of zeros"),
            Type::Zero(_) => f.write_str("a plane vector of zeros"),
            Type::Error => f.write_str("an error"),
        }
    }
}

impl Type {
    pub(super) const NUMBER: Type = Type::Scalar(Dimension::NUMBER);

    /// Zero as a number: what it is where nothing says otherwise.
    pub(super) fn settled(&self) -> Type {
        match self {
            Type::Zero(1) => Type::NUMBER,
            Type::Zero(count) => Type::Vector(*count, Dimension::NUMBER),
            Type::Array(entries) => Type::Array(entries.iter().map(Type::settled).collect()),
            other => other.clone(),
        }
    }

    /// Number of components; `None` for arrays, frames and errors.
    pub fn components(&self) -> Option<usize> {
        match self {
            Type::Scalar(_) => Some(1),
            Type::Vector(count, _) | Type::Zero(count) => Some(*count),
            Type::Array(_) | Type::Frame | Type::Error => None,
        }
    }

    /// Dimension of a scalar or of each component; zero counts as a number.
    pub fn dimension(&self) -> Option<Dimension> {
        match self {
            Type::Scalar(dimension) | Type::Vector(_, dimension) => Some(*dimension),
            Type::Zero(_) => Some(Dimension::NUMBER),
            Type::Array(_) | Type::Frame | Type::Error => None,
        }
    }

    /// The same shape with another dimension.
    pub(super) fn with(&self, dimension: Dimension) -> Type {
        match self.components() {
            Some(1) => Type::Scalar(dimension),
            Some(count) => Type::Vector(count, dimension),
            None => Type::Error,
        }
    }

    pub(super) fn is_error(&self) -> bool {
        match self {
            Type::Error => true,
            Type::Array(entries) => entries.iter().any(Type::is_error),
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words() {
        let area = Dimension::LENGTH
            .times(Dimension::LENGTH)
            .expect("in range");
        let root = Dimension::LENGTH.root().expect("a half power");
        assert_eq!(area.to_string(), "a length^2");
        assert_eq!(root.to_string(), "a length^(1/2)");
        assert!(root.root().is_none());
        assert_eq!(
            Type::Vector(2, Dimension::LENGTH).to_string(),
            "a plane vector of lengths"
        );
    }

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
