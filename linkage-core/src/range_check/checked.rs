//! The input whose range is checked for the dimensions of an assembly.

use core::f64::consts::PI;
use core::fmt;

/// An input, as the check sees it.
#[derive(Clone, Copy, Debug)]
pub struct Driven {
    /// True if it is an angle.
    pub angle: bool,
    /// Its reference.
    pub reference: f64,
    /// Its declared range.
    pub range: Option<(f64, f64)>,
}

/// Why nothing is checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unchecked {
    /// Several inputs have a range.
    SeveralRanges,
    /// No input has a range, and the mechanism is not driven by a single angle.
    NoRange,
}

/// The number of the input that is checked, and its range: the only one that is declared, or a turn
/// about the reference of the only input. `prepared`: whether a group is prepared over ranges only.
///
/// # Errors
///
/// Why no input is checked.
pub fn checked(
    inputs: impl IntoIterator<Item = Driven>,
    prepared: bool,
) -> Result<(usize, (f64, f64)), Unchecked> {
    let mut count = 0;
    let mut declared = None;
    let mut only = None;
    for (index, input) in inputs.into_iter().enumerate() {
        count += 1;
        only = Some(input);
        if let Some(range) = input.range {
            if declared.is_some() {
                return Err(Unchecked::SeveralRanges);
            }
            declared = Some((index, range));
        }
    }
    let turn = only.filter(|input| count == 1 && input.angle && !prepared);
    let turn = turn.map(|input| (0, (input.reference - PI, input.reference + PI)));
    declared.or(turn).ok_or(Unchecked::NoRange)
}

impl fmt::Display for Unchecked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SeveralRanges => {
                "the ranges are not checked: several inputs have one, and only the range of a single input is searched"
            }
            Self::NoRange => {
                "there is no range to check: no input has one, and the mechanism is not driven by a single angle"
            }
        })
    }
}
