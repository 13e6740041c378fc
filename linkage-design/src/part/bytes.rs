//! Parts of a search as bytes, for other processes and for files.

use std::vec::Vec;

use linkage_core::bytes::{Reader, Writer};

use super::super::DesignError;
use super::super::numbered::{Numbered, read_numbers, write_numbers};
use super::super::optimum::Optimum;
use super::super::refusals::Tally;
use super::super::search::Block;
use super::super::violation::Violation;
use super::DesignPart;

/// The first bytes: the format and its version.
const BEGIN: &[u8; 8] = b"linkDP\0\x01";

impl DesignPart {
    /// The descents as bytes, some hundred for each start that ends at an optimum.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        self.blocks.to_bytes(BEGIN, write)
    }

    /// The descents that another process wrote by [`to_bytes`](Self::to_bytes).
    ///
    /// # Errors
    ///
    /// `NoPart` for other bytes, and for damaged ones.
    pub fn read(bytes: &[u8]) -> Result<Self, DesignError> {
        let blocks = Numbered::read(bytes, BEGIN, block)?;
        Ok(Self { blocks })
    }
}

fn write(out: &mut Writer, block: &Block) {
    let Block {
        optima,
        feasible,
        tally,
        evaluations,
    } = block;
    for list in [optima, feasible] {
        out.varying(list.len() as u64);
        list.iter().for_each(|optimum| write_optimum(out, optimum));
    }
    let Tally {
        refused,
        open,
        broken,
        relations,
        conditions,
        nearest,
    } = tally;
    for count in [refused, open, broken] {
        out.varying(*count as u64);
    }
    for list in [relations, conditions] {
        out.varying(list.len() as u64);
        list.iter().for_each(|&count| out.varying(count as u64));
    }
    match nearest {
        None => out.varying(0),
        Some(Violation {
            objective,
            by,
            part,
        }) => {
            out.varying(*objective as u64 + 1);
            out.float(*by);
            out.float(*part);
        }
    }
    out.varying(*evaluations as u64);
}

fn block(bytes: &mut Reader<'_>) -> Option<Block> {
    let [optima, feasible] = [optima(bytes)?, optima(bytes)?];
    let [refused, open, broken] = [bytes.index()?, bytes.index()?, bytes.index()?];
    let [relations, conditions] = [counts(bytes)?, counts(bytes)?];
    let nearest = match bytes.index()?.checked_sub(1) {
        None => None,
        Some(objective) => Some(Violation {
            objective,
            by: bytes.float()?,
            part: bytes.float()?,
        }),
    };
    Some(Block {
        optima,
        feasible,
        tally: Tally {
            refused,
            open,
            broken,
            relations,
            conditions,
            nearest,
        },
        evaluations: bytes.index()?,
    })
}

fn write_optimum(out: &mut Writer, optimum: &Optimum) {
    let Optimum {
        x,
        sum,
        assembly,
        start,
        hits,
        converged,
        zero,
    } = optimum;
    write_numbers(out, x);
    out.float(*sum);
    for count in [
        *assembly,
        *start,
        *hits,
        usize::from(*converged),
        usize::from(*zero),
    ] {
        out.varying(count as u64);
    }
}

fn optima(bytes: &mut Reader<'_>) -> Option<Vec<Optimum>> {
    // One by one: a number in bytes is no reason to reserve memory.
    let optimum = |bytes: &mut Reader<'_>| {
        Some(Optimum {
            x: read_numbers(bytes)?,
            sum: bytes.float()?,
            assembly: bytes.index()?,
            start: bytes.index()?,
            hits: bytes.index()?,
            converged: bytes.varying()? != 0,
            zero: bytes.varying()? != 0,
        })
    };
    (0..bytes.varying()?).map(|_| optimum(bytes)).collect()
}

fn counts(bytes: &mut Reader<'_>) -> Option<Vec<usize>> {
    (0..bytes.varying()?).map(|_| bytes.index()).collect()
}
