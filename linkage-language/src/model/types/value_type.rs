//! Types of values: scalars, vectors, arrays, frames.

use super::dimension::Dimension;

#[derive(Clone, Debug, PartialEq)]
pub enum Type {
    Scalar(Dimension),
    /// Two or three components of one dimension.
    Vector(usize, Dimension),
    /// `velocity` with several inputs, `sensitivity`: entries that may differ in dimension.
    Array(Vec<Type>),
    /// A point and three perpendicular directions in space, as entries 0 (the origin) to 3.
    Frame,
    /// A point and a direction in the plane; its parts are the origin, the axes and the angle of
    /// the first.
    PlaneFrame,
    /// The literal `0` (or a vector of such): fits every dimension. The count is 1 for a scalar.
    Zero(usize),
    /// Follows from a mistake already reported.
    Error,
}

impl Type {
    pub(in crate::model) const NUMBER: Type = Type::Scalar(Dimension::NUMBER);

    /// Returns zero as a number, and any other type as it is.
    pub(in crate::model) fn settled(&self) -> Type {
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
            Type::Array(_) | Type::Frame | Type::PlaneFrame | Type::Error => None,
        }
    }

    /// Dimension of a scalar or of each component; zero counts as a number.
    pub fn dimension(&self) -> Option<Dimension> {
        match self {
            Type::Scalar(dimension) | Type::Vector(_, dimension) => Some(*dimension),
            Type::Zero(_) => Some(Dimension::NUMBER),
            Type::Array(_) | Type::Frame | Type::PlaneFrame | Type::Error => None,
        }
    }

    /// The same shape with another dimension.
    pub(in crate::model) fn with(&self, dimension: Dimension) -> Type {
        match self.components() {
            Some(1) => Type::Scalar(dimension),
            Some(count) => Type::Vector(count, dimension),
            None => Type::Error,
        }
    }

    pub(in crate::model) fn is_error(&self) -> bool {
        match self {
            Type::Error => true,
            Type::Array(entries) => entries.iter().any(Type::is_error),
            Type::Scalar(_) | Type::Vector(..) | Type::Frame | Type::PlaneFrame | Type::Zero(_) => {
                false
            }
        }
    }

    /// A frame of the plane or of space.
    pub fn is_frame(&self) -> bool {
        matches!(self, Type::Frame | Type::PlaneFrame)
    }

    /// The type of a sum of the two; `None` if they cannot be added.
    pub(in crate::model) fn common(left: &Type, right: &Type) -> Option<Type> {
        match (left, right) {
            (Type::Array(_) | Type::Frame | Type::PlaneFrame | Type::Error, _)
            | (_, Type::Array(_) | Type::Frame | Type::PlaneFrame | Type::Error) => None,
            (Type::Zero(1), other) | (other, Type::Zero(1)) => Some(other.clone()),
            _ if left.components() != right.components() => None,
            (Type::Zero(_), other) | (other, Type::Zero(_)) => Some(other.clone()),
            _ => {
                let (left_dimension, right_dimension) = (left.dimension()?, right.dimension()?);
                let fits = left_dimension.fits(right_dimension);
                fits.then(|| left.with(left_dimension.or(right_dimension)))
            }
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
}
