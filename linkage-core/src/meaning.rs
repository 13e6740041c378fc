//! The meanings of the numbers of a result.

/// The meaning of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// A quantity as it is.
    Value,
    /// A derivative by the function's only input.
    Rate {
        /// 1 for a velocity, 2 for an acceleration.
        order: u32,
        /// The column of the quantity that is differentiated, if the function has it.
        of: Option<usize>,
    },
    /// A derivative by a parameter.
    Sensitivity {
        /// Its index in `PARAMETERS`.
        parameter: usize,
        /// The column of the quantity that is differentiated, if the function has it.
        of: Option<usize>,
    },
    /// A distance from the dead point: `margin()`.
    Margin,
    /// A component of a point or direction of the picture.
    Picture,
}
