//! Results of numbered searches of one problem, which several processes made.

use std::collections::BTreeMap;
use std::vec::Vec;

use linkage_core::bytes::{Reader, Writer, digest};

use super::DesignError;

/// Equal values differ by no more than this part, by rounding on different processors.
const SAME: f64 = 1e-6;

/// All searches: the first part of one.
pub const WHOLE: [usize; 2] = [0, 1];

/// Results of some searches, by their numbers.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Numbered<R> {
    pub(crate) problem: Identity,
    pub(crate) results: BTreeMap<usize, R>,
}

/// Properties that all parts of a problem have in common.
#[derive(Clone, Debug)]
pub(crate) struct Identity {
    /// All starts.
    pub(crate) starts: usize,
    /// A digest of settings, variables and bounds.
    digest: u64,
    /// Values at some starts; NaN where there is none.
    probes: Vec<f64>,
}

impl Identity {
    /// The identity of a problem with so many starts, with all of its settings as text.
    pub(crate) fn new(starts: usize, settings: &str, probes: Vec<f64>) -> Self {
        Self {
            starts,
            digest: digest(settings.as_bytes()),
            probes,
        }
    }
}

impl PartialEq for Identity {
    fn eq(&self, other: &Self) -> bool {
        let same = |(a, b): (&f64, &f64)| {
            (a.is_nan() && b.is_nan()) || (a - b).abs() <= SAME * a.abs().max(b.abs())
        };
        (self.starts, self.digest) == (other.starts, other.digest)
            && self.probes.len() == other.probes.len()
            && self.probes.iter().zip(&other.probes).all(same)
    }
}

impl<R: Clone> Numbered<R> {
    /// No results of a problem.
    pub(crate) fn new(problem: Identity) -> Self {
        Self {
            problem,
            results: BTreeMap::new(),
        }
    }

    /// Adds other results of the same problem. Nothing changes after an error.
    pub(crate) fn merge(&mut self, other: &Self) -> Result<(), DesignError> {
        if self.problem != other.problem {
            return Err(DesignError::OtherProblem);
        }
        match unite(&mut self.results, &other.results) {
            true => Ok(()),
            false => Err(DesignError::Repeated),
        }
    }

    /// Problem and results as bytes, after those of the format.
    pub(crate) fn to_bytes(&self, begin: &[u8; 8], write: impl Fn(&mut Writer, &R)) -> Vec<u8> {
        let Identity {
            starts,
            digest,
            probes,
        } = &self.problem;
        let mut out = Writer::new(begin);
        out.varying(*starts as u64);
        out.fixed(*digest);
        write_numbers(&mut out, probes);
        write_results(&mut out, &self.results, write);
        out.finish()
    }

    /// Reads the bytes of [`to_bytes`](Self::to_bytes); `NoPart` for others.
    pub(crate) fn read(
        bytes: &[u8],
        begin: &[u8; 8],
        read: impl Fn(&mut Reader<'_>) -> Option<R>,
    ) -> Result<Self, DesignError> {
        let all = move |mut bytes: Reader<'_>| {
            let problem = Identity {
                starts: bytes.index()?,
                digest: bytes.fixed()?,
                probes: read_numbers(&mut bytes)?,
            };
            let results = read_results(&mut bytes, read)?;
            bytes.is_empty().then_some(Self { problem, results })
        };
        let found = Reader::new(bytes, begin).and_then(all);
        found.ok_or(DesignError::NoPart)
    }
}

/// Adds other results. Returns false if some search has two, and then nothing changes.
#[must_use]
pub fn unite<R: Clone>(results: &mut BTreeMap<usize, R>, others: &BTreeMap<usize, R>) -> bool {
    let separate = others.keys().all(|number| !results.contains_key(number));
    if separate {
        let others = others.iter();
        results.extend(others.map(|(&number, result)| (number, result.clone())));
    }
    separate
}

/// The numbers of a part, given with the number of parts, of so many searches that have no result.
/// Parts have nearly as many searches each.
pub fn missing<R>(
    results: &BTreeMap<usize, R>,
    [part, of]: [usize; 2],
    count: usize,
) -> Vec<usize> {
    let numbers = count * part / of..count * (part + 1) / of;
    numbers
        .filter(|number| !results.contains_key(number))
        .collect()
}

/// Writes results with their numbers.
pub fn write_results<R>(
    out: &mut Writer,
    results: &BTreeMap<usize, R>,
    write: impl Fn(&mut Writer, &R),
) {
    out.varying(results.len() as u64);
    for (&number, result) in results {
        out.varying(number as u64);
        write(out, result);
    }
}

/// Reads the bytes of [`write_results`].
pub fn read_results<R>(
    bytes: &mut Reader<'_>,
    read: impl Fn(&mut Reader<'_>) -> Option<R>,
) -> Option<BTreeMap<usize, R>> {
    (0..bytes.varying()?)
        .map(|_| Some((bytes.index()?, read(bytes)?)))
        .collect()
}

/// Writes a list with its length.
pub(crate) fn write_numbers(out: &mut Writer, numbers: &[f64]) {
    out.varying(numbers.len() as u64);
    numbers.iter().for_each(|&number| out.float(number));
}

/// Reads a list of [`write_numbers`]: one by one, since a length in bytes is no reason to reserve
/// memory.
pub(crate) fn read_numbers(bytes: &mut Reader<'_>) -> Option<Vec<f64>> {
    (0..bytes.varying()?).map(|_| bytes.float()).collect()
}
