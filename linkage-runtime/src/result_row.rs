//! Results of functions as numbers.

/// A result of a function as its `W` numbers, in the order of the fields, components innermost.
pub trait ResultRow<T, const W: usize>: Sized {
    /// The result of these numbers.
    fn from_row(row: [T; W]) -> Self;

    /// The numbers of the result.
    fn to_row(&self) -> [T; W];
}
