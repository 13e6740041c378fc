//! Parts of a search as bytes, for other processes and for files.

use std::collections::BTreeMap;
use std::vec::Vec;

use linkage_core::bytes::{Reader, Writer};

use super::super::DesignError;
use super::super::optimum::Optimum;
use super::super::refusals::Tally;
use super::super::search::Block;
use super::super::violation::Violation;
use super::{DesignPart, Identity};

/// The first bytes: the format and its version.
const BEGIN: &[u8; 8] = b"linkDP\0\x01";

impl DesignPart {
    /// The descents as bytes, some hundred for each start that ends at an optimum.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let Identity {
            starts,
            digest,
            probes,
        } = &self.problem;
        let mut out = Writer::new(BEGIN);
        out.varying(*starts as u64);
        out.fixed(*digest);
        numbers(&mut out, probes);
        out.varying(self.blocks.len() as u64);
        for (&number, block) in &self.blocks {
            out.varying(number as u64);
            write(&mut out, block);
        }
        out.finish()
    }

    /// The descents that another process wrote by [`to_bytes`](Self::to_bytes).
    ///
    /// # Errors
    ///
    /// `NoPart` for other bytes, and for damaged ones.
    pub fn read(bytes: &[u8]) -> Result<Self, DesignError> {
        let part = Reader::new(bytes, BEGIN).and_then(|mut bytes| part(&mut bytes));
        part.ok_or(DesignError::NoPart)
    }
}

fn part(bytes: &mut Reader<'_>) -> Option<DesignPart> {
    let problem = Identity {
        starts: bytes.index()?,
        digest: bytes.fixed()?,
        probes: read_numbers(bytes)?,
    };
    let blocks: Option<BTreeMap<_, _>> = (0..bytes.varying()?)
        .map(|_| Some((bytes.index()?, block(bytes)?)))
        .collect();
    let blocks = blocks?;
    bytes.is_empty().then_some(DesignPart { problem, blocks })
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
    numbers(out, x);
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

fn numbers(out: &mut Writer, numbers: &[f64]) {
    out.varying(numbers.len() as u64);
    numbers.iter().for_each(|&number| out.float(number));
}

fn read_numbers(bytes: &mut Reader<'_>) -> Option<Vec<f64>> {
    (0..bytes.varying()?).map(|_| bytes.float()).collect()
}

fn counts(bytes: &mut Reader<'_>) -> Option<Vec<usize>> {
    (0..bytes.varying()?).map(|_| bytes.index()).collect()
}
