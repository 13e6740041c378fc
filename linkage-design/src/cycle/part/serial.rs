//! Parts of a search of a whole cycle as bytes, for other processes and for files.

use std::vec::Vec;

use linkage_core::bytes::{Reader, Writer};

use super::super::super::DesignError;
use super::super::super::numbered::{Numbered, read_numbers, write_numbers};
use super::{CyclePart, Descended, Refusal, SearchEnd};

/// The first bytes: the format and its version.
const BEGIN: &[u8; 8] = b"linkCP\0\x01";

impl CyclePart {
    /// The descents as bytes, some hundred for each start that ends at an optimum.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        self.descents.to_bytes(BEGIN, write)
    }

    /// The descents that another process wrote by [`to_bytes`](Self::to_bytes).
    ///
    /// # Errors
    ///
    /// `NoPart` for other bytes, and for damaged ones.
    pub fn read(bytes: &[u8]) -> Result<Self, DesignError> {
        let descents = Numbered::read(bytes, BEGIN, read)?;
        Ok(Self { descents })
    }
}

/// Begins an optimum; refusals begin with the numbers after it.
const OPTIMUM: u64 = 0;
const NO_VALUES: u64 = 1;
const NOT_WHOLE: u64 = 2;
const NO_START: u64 = 3;
const UNKNOWN_OBJECTIVE: u64 = 4;
/// The first objective; the others follow.
const OBJECTIVE: u64 = 5;

fn write(out: &mut Writer, end: &Descended) {
    match end {
        Descended::Optimum(optimum) => {
            out.varying(OPTIMUM);
            write_end(out, optimum);
        }
        Descended::Refused(refusal) => out.varying(match refusal {
            Refusal::NoValues => NO_VALUES,
            Refusal::NotWhole => NOT_WHOLE,
            Refusal::NoStart => NO_START,
            Refusal::OutOfReach(None) => UNKNOWN_OBJECTIVE,
            Refusal::OutOfReach(Some(objective)) => OBJECTIVE + *objective as u64,
        }),
    }
}

fn read(bytes: &mut Reader<'_>) -> Option<Descended> {
    Some(Descended::Refused(match bytes.varying()? {
        OPTIMUM => return Some(Descended::Optimum(read_end(bytes)?)),
        NO_VALUES => Refusal::NoValues,
        NOT_WHOLE => Refusal::NotWhole,
        NO_START => Refusal::NoStart,
        UNKNOWN_OBJECTIVE => Refusal::OutOfReach(None),
        objective => Refusal::OutOfReach((objective - OBJECTIVE).try_into().ok()),
    }))
}

fn write_end(out: &mut Writer, end: &SearchEnd) {
    let SearchEnd {
        x,
        bounds: [lower, upper],
        reach,
        auxiliary,
        added,
        least,
        steps,
        evaluations,
        converged,
    } = end;
    for list in [x, lower, upper, reach] {
        write_numbers(out, list);
    }
    out.varying(auxiliary.len() as u64);
    auxiliary
        .iter()
        .for_each(|&count| out.varying(count as u64));
    out.varying(added.len() as u64);
    for conditions in added {
        out.varying(conditions.len() as u64);
        conditions.iter().for_each(|list| write_numbers(out, list));
    }
    out.float(*least);
    for count in [*steps, *evaluations, usize::from(*converged)] {
        out.varying(count as u64);
    }
}

fn read_end(bytes: &mut Reader<'_>) -> Option<SearchEnd> {
    Some(SearchEnd {
        x: read_numbers(bytes)?,
        bounds: [read_numbers(bytes)?, read_numbers(bytes)?],
        reach: read_numbers(bytes)?,
        auxiliary: listed(bytes, |bytes| bytes.index())?,
        added: listed(bytes, |bytes| listed(bytes, read_numbers))?,
        least: bytes.float()?,
        steps: bytes.index()?,
        evaluations: bytes.index()?,
        converged: bytes.varying()? != 0,
    })
}

/// Reads a list that begins with its length.
fn listed<T>(
    bytes: &mut Reader<'_>,
    read: impl Fn(&mut Reader<'_>) -> Option<T>,
) -> Option<Vec<T>> {
    (0..bytes.varying()?).map(|_| read(bytes)).collect()
}
