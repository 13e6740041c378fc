//! Results as bytes, for other processes and for files.
//!
//! Data of the study come as a digest only: who reads the bytes has the study.

use alloc::vec::Vec;

use linkage_core::bytes::{Reader, Writer, digest};

use super::bins::{Bins, Scale};
use super::sums::{Node, Sums, Tree};
use super::tally::{End, Tally};
use super::{Stream, Study};
use crate::tolerance::ToleranceError;

/// The first bytes: the format and its version.
const BEGIN: &[u8; 8] = b"linkMC\0\x01";

impl<const N: usize, const K: usize> Stream<N, K> {
    /// The results as bytes, some hundred kilobytes for each number. [`read`](Self::read) of the
    /// same study has them back, to the last bit.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let Tally {
            sums,
            done,
            missing,
            ends,
            bins,
        } = &self.tally;
        let mut out = Writer::new(BEGIN);
        out.fixed(self.study.digest());
        out.varying(*done);
        out.varying(*missing);
        out.varying(sums.nodes().len() as u64);
        for node in sums.nodes() {
            out.varying(node.first);
            out.varying(u64::from(node.level));
            for sums in &node.sums {
                out.varying(sums.count);
                sums.powers.iter().for_each(|&power| out.float(power));
            }
        }
        for end in ends.iter().flatten() {
            match end {
                None => out.varying(0),
                Some(end) => {
                    out.varying(end.number + 1);
                    out.float(end.value);
                }
            }
        }
        for bins in bins {
            out.varying(bins.numbered().count() as u64);
            let mut last = i64::MIN;
            for (bin, count) in bins.numbered() {
                out.varying(bin.wrapping_sub(last) as u64);
                out.varying(count);
                last = bin;
            }
        }
        out.finish()
    }

    /// The results that another process wrote by [`to_bytes`](Self::to_bytes), of the study that
    /// this one is of.
    ///
    /// # Errors
    ///
    /// `OtherStudy` for bytes of another study, `NoResults` for others, and for damaged ones.
    pub fn read(&self, bytes: &[u8]) -> Result<Self, ToleranceError> {
        let bytes = Reader::new(bytes, BEGIN);
        let mut bytes = bytes.ok_or(ToleranceError::NoResults)?;
        let study = bytes.fixed().ok_or(ToleranceError::NoResults)?;
        if study != self.study.digest() {
            return Err(ToleranceError::OtherStudy);
        }
        let tally = tally(&mut bytes, &self.study.scales);
        Ok(Self {
            study: self.study.clone(),
            tally: tally.ok_or(ToleranceError::NoResults)?,
        })
    }
}

impl<const N: usize, const K: usize> Study<N, K> {
    /// A number that two studies with different data do not have in common.
    fn digest(&self) -> u64 {
        let Self {
            count,
            draw,
            scales,
        } = self;
        // Rust's notation of numbers is exact.
        digest(alloc::format!("{N} {K} {count} {draw:?} {scales:?}").as_bytes())
    }
}

fn tally<const K: usize>(bytes: &mut Reader<'_>, scales: &[Scale; K]) -> Option<Tally<K>> {
    let mut tally = Tally::new(scales);
    tally.done = bytes.varying()?;
    tally.missing = bytes.varying()?;
    let nodes: Option<_> = (0..bytes.varying()?).map(|_| node(bytes)).collect();
    tally.sums = Tree::from_nodes(nodes?)?;
    for end in tally.ends.iter_mut().flatten() {
        *end = match bytes.varying()?.checked_sub(1) {
            None => None,
            Some(number) => Some(End {
                number,
                value: bytes.float()?,
            }),
        };
    }
    for (bins, &scale) in tally.bins.iter_mut().zip(scales) {
        *bins = bins_of(bytes, scale)?;
    }
    bytes.is_empty().then_some(tally)
}

fn node<const K: usize>(bytes: &mut Reader<'_>) -> Option<Node<K>> {
    let (first, level) = (bytes.varying()?, u32::try_from(bytes.varying()?).ok()?);
    let mut sums = [Sums::default(); K];
    for sums in &mut sums {
        sums.count = bytes.varying()?;
        for power in &mut sums.powers {
            *power = bytes.float()?;
        }
    }
    let blocks = 1_u64.checked_shl(level)?;
    let fits = first.is_multiple_of(blocks) && first.checked_add(blocks).is_some();
    fits.then_some(Node { first, level, sums })
}

fn bins_of(bytes: &mut Reader<'_>, scale: Scale) -> Option<Bins> {
    let (count, mut last) = (bytes.varying()?, i64::MIN);
    // One by one: a number in bytes is no reason to reserve memory.
    let mut bins = Bins::new(scale);
    for _ in 0..count {
        last = last.wrapping_add(bytes.varying()? as i64);
        bins.add(last, bytes.varying()?);
    }
    Some(bins)
}
