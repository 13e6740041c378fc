//! The meaning of the columns of a sweep: for everything that prints, plots or writes them.

use linkage_core::{Meaning, Picture};

/// The results of a sweep with the names and units of their numbers: every generated type of
/// columns implements it (in `f64`, for functions with arguments).
pub trait Table {
    /// The columns.
    fn heading(&self) -> &'static Heading;

    /// The number of positions.
    fn rows(&self) -> usize;

    /// The values of one column, one for each position; NaN where the mechanism cannot be
    /// assembled.
    ///
    /// # Panics
    /// If there is no such column.
    fn column(&self, index: usize) -> &[f64];
}

/// The columns of a function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heading {
    /// The function's name.
    pub function: &'static str,
    /// Its arguments: inputs, speeds, loads.
    pub arguments: &'static [&'static str],
    /// Its numbers in the order of its fields, components innermost.
    pub columns: &'static [Column],
    /// The columns of its `picture()`.
    pub picture: Option<PictureColumns>,
}

/// One number of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// The field's name with indices and component, such as `p.x` or `e[crank].y`.
    pub name: &'static str,
    /// Such as `mm`, `rad`, `mm/rad`; empty for a number.
    pub unit: &'static str,
    /// The meaning.
    pub meaning: Meaning,
}

/// Positions of the columns of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureColumns {
    /// The first column. The components of each point follow, then those of each direction.
    pub first: usize,
    /// Their parts of the picture.
    pub picture: &'static Picture,
}
