//! Parts of a search as bytes, for other processes and for files.

use super::super::super::ball::Ball;
use super::super::super::certificate::Certificate;
use super::super::super::error::Unsolved;
use super::super::cognates::Mark;
use super::super::equations::ALL;
use super::super::search::FoundSolution;
use super::NinePointsPart;
use linkage_core::bytes::{Reader, Writer};
use linkage_core::numeric::complex::Complex;
use linkage_design::internals::{read_results, write_results};
use std::vec::Vec;

/// The first bytes: the format and its version.
const BEGIN: &[u8; 8] = b"linkNP\0\x01";

/// A path without an end of its own, and ends by their kind.
const NO_END: u64 = 0;
const COMPLEX: u64 = 1;
const REAL: u64 = 2;
const UNDECIDED: u64 = 3;

impl NinePointsPart {
    /// The paths as bytes, 600 for each.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Writer::new(BEGIN);
        let coordinates = self.points.iter().flatten();
        coordinates.for_each(|&number| out.float(number));
        write_results(&mut out, &self.ends, |out, end| write(out, end.as_ref()));
        out.finish()
    }

    /// The paths that another process wrote by [`to_bytes`](Self::to_bytes).
    ///
    /// # Errors
    ///
    /// `NoPart` for other bytes, and for damaged ones.
    pub fn read(bytes: &[u8]) -> Result<Self, Unsolved> {
        let part = Reader::new(bytes, BEGIN).and_then(part);
        part.ok_or(Unsolved::NoPart)
    }
}

fn part(mut bytes: Reader<'_>) -> Option<NinePointsPart> {
    let mut points = [[0.0; 2]; 9];
    for number in points.iter_mut().flatten() {
        *number = bytes.float()?;
    }
    let ends = read_results(&mut bytes, read)?;
    bytes.is_empty().then_some(NinePointsPart { points, ends })
}

fn write(out: &mut Writer, end: Option<&FoundSolution>) {
    let Some((Certificate { discs, real }, _)) = end else {
        return out.varying(NO_END);
    };
    out.varying(match real {
        Some(false) => COMPLEX,
        Some(true) => REAL,
        None => UNDECIDED,
    });
    for Ball { middle, radius } in discs {
        for number in [middle.re, middle.im, *radius] {
            out.float(number);
        }
    }
}

/// Reads the end of a path, which may have none.
fn read(bytes: &mut Reader<'_>) -> Option<Option<FoundSolution>> {
    let real = match bytes.varying()? {
        NO_END => return Some(None),
        COMPLEX => Some(false),
        REAL => Some(true),
        UNDECIDED => None,
        _ => return None,
    };
    let mut discs = [Ball::ZERO; ALL];
    for disc in &mut discs {
        let middle = Complex::new(bytes.float()?, bytes.float()?);
        *disc = Ball::new(middle, bytes.float()?);
    }
    let mark = Mark::new(&discs)?;
    Some(Some((Certificate { discs, real }, mark)))
}
