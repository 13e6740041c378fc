//! Grashof's rule: the links of a four-bar that turn fully.

use super::SummaryError;
use core::fmt;
use linkage_core::format::rounded;

/// Rounding of the two sums that are compared, relative to the sum of all lengths.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The types of four-bars by their lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FourBar {
    /// The input turns fully, the output swings: the input is the shortest link.
    CrankRocker,
    /// The output turns fully, the input swings: the output is the shortest link.
    RockerCrank,
    /// Input and output turn fully (a drag link): the frame is the shortest link.
    DoubleCrank,
    /// Input and output swing, the coupler turns fully: the coupler is the shortest link.
    DoubleRocker,
    /// No link turns fully against another: shortest and longest link are longer together than the
    /// other two.
    TripleRocker,
    /// Shortest and longest link are as long as the other two, to rounding: all links can come to
    /// lie on one line, where its two assemblies meet.
    ChangePoint,
    /// The longest link is as long as the other three together, or longer: they cannot be joined,
    /// or cannot move.
    NotClosable,
}

impl fmt::Display for FourBar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::CrankRocker => "crank-rocker",
            Self::RockerCrank => "rocker-crank",
            Self::DoubleCrank => "double crank",
            Self::DoubleRocker => "double rocker",
            Self::TripleRocker => "triple rocker",
            Self::ChangePoint => "change point",
            Self::NotClosable => "cannot be closed",
        })
    }
}

/// The type of a four-bar, and the two sums that determine it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grashof {
    /// Its kind.
    pub kind: FourBar,
    /// The shortest and the longest link together.
    pub extreme: f64,
    /// The other two links together.
    pub middle: f64,
}

impl Grashof {
    /// The excess of the two middle links over the shortest and the longest one: positive if a link
    /// turns fully.
    #[must_use]
    pub fn reserve(&self) -> f64 {
        self.middle - self.extreme
    }
}

/// Such as `crank-rocker: 160 < 180`.
impl fmt::Display for Grashof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = match self.kind {
            FourBar::ChangePoint => "=",
            _ if self.extreme < self.middle => "<",
            _ => ">",
        };
        let (extreme, middle) = (rounded(self.extreme), rounded(self.middle));
        write!(f, "{}: {extreme} {sign} {middle}", self.kind)
    }
}

/// The type of a four-bar with these lengths, by Grashof's rule.
///
/// Sums that differ by less than 8 units in the last place of the sum of all lengths are equal.
///
/// # Errors
///
/// `Length` for a link whose length is not positive and finite.
///
/// ```
/// use linkage_analysis::summary::{FourBar, grashof};
///
/// let found = grashof(100.0, 40.0, 120.0, 80.0)?;
/// assert_eq!(found.kind, FourBar::CrankRocker);
/// assert_eq!(found.to_string(), "crank-rocker: 160 < 180");
/// # Ok::<(), linkage_analysis::summary::SummaryError>(())
/// ```
pub fn grashof(frame: f64, input: f64, coupler: f64, output: f64) -> Result<Grashof, SummaryError> {
    let links = [
        (frame, "frame", FourBar::DoubleCrank),
        (input, "input", FourBar::CrankRocker),
        (coupler, "coupler", FourBar::DoubleRocker),
        (output, "output", FourBar::RockerCrank),
    ];
    for (length, link, _) in links {
        if !(length > 0.0 && length.is_finite()) {
            return Err(SummaryError::Length { link, length });
        }
    }
    let mut sorted = links;
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let [
        (shortest, _, kind),
        (second, ..),
        (third, ..),
        (longest, ..),
    ] = sorted;
    let (extreme, middle) = (shortest + longest, second + third);
    let rounding = ROUNDING * (extreme + middle);
    let kind = if longest - shortest >= middle - rounding {
        FourBar::NotClosable
    } else if (extreme - middle).abs() <= rounding {
        FourBar::ChangePoint
    } else if extreme < middle {
        kind
    } else {
        FourBar::TripleRocker
    };
    Ok(Grashof {
        kind,
        extreme,
        middle,
    })
}
