//! The meaning of the columns of a sweep: for everything that prints, plots or writes them.

#[cfg(feature = "alloc")]
use crate::result_columns::ResultColumns;
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

/// Columns of a function that have a heading: generated code states it.
#[doc(hidden)]
#[cfg(feature = "alloc")]
pub trait Headed {
    /// The heading.
    const HEADING: &'static Heading;
}

#[cfg(feature = "alloc")]
impl<C, R: 'static, const W: usize> Table for C
where
    C: Headed + core::ops::Deref<Target = ResultColumns<f64, R, W>>,
{
    fn heading(&self) -> &'static Heading {
        C::HEADING
    }

    fn rows(&self) -> usize {
        self.len()
    }

    fn column(&self, index: usize) -> &[f64] {
        ResultColumns::column(self, index)
    }
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
