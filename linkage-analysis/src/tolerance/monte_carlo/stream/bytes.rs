//! Results as bytes, for other processes and for files.
//!
//! Little-endian numbers; counts and bins have as many bytes as they need, seven bits in each. Data
//! of the study come as a digest only: who reads the bytes has the study. A digest of all bytes is
//! last, so that damaged ones are noticed.

use alloc::vec::Vec;

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
        let mut out = Writer(BEGIN.to_vec());
        out.fixed(self.study.digest());
        out.varying(*done);
        out.varying(*missing);
        out.varying(sums.nodes().len() as u64);
        for node in sums.nodes() {
            out.varying(node.first);
            out.varying(u64::from(node.level));
            for sums in &node.sums {
                out.varying(sums.count);
                sums.powers
                    .iter()
                    .for_each(|power| out.fixed(power.to_bits()));
            }
        }
        for end in ends.iter().flatten() {
            match end {
                None => out.varying(0),
                Some(end) => {
                    out.varying(end.number + 1);
                    out.fixed(end.value.to_bits());
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
        out.fixed(digest(&out.0));
        out.0
    }

    /// The results that another process wrote by [`to_bytes`](Self::to_bytes), of the study that
    /// this one is of.
    ///
    /// # Errors
    ///
    /// `OtherStudy` for bytes of another study, `NoResults` for others, and for damaged ones.
    pub fn read(&self, bytes: &[u8]) -> Result<Self, ToleranceError> {
        let whole = bytes.split_last_chunk();
        let whole = whole.filter(|(bytes, end)| digest(bytes).to_le_bytes() == **end);
        let mut bytes = Reader(whole.ok_or(ToleranceError::NoResults)?.0);
        let study = bytes.begin().ok_or(ToleranceError::NoResults)?;
        if study != self.study.digest() {
            return Err(ToleranceError::OtherStudy);
        }
        let tally = bytes.tally(&self.study.scales);
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

/// FNV-1a of 64 bits: another byte at one place always gives another digest.
fn digest(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

struct Writer(Vec<u8>);

impl Writer {
    fn fixed(&mut self, number: u64) {
        self.0.extend_from_slice(&number.to_le_bytes());
    }

    /// Seven bits a byte, the lowest first; all bytes but the last have the eighth bit.
    fn varying(&mut self, mut number: u64) {
        while number >= 0x80 {
            self.0.push(number as u8 | 0x80);
            number >>= 7;
        }
        self.0.push(number as u8);
    }
}

struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn fixed(&mut self) -> Option<u64> {
        let (bytes, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(u64::from_le_bytes(*bytes))
    }

    fn float(&mut self) -> Option<f64> {
        self.fixed().map(f64::from_bits)
    }

    fn varying(&mut self) -> Option<u64> {
        let mut number = 0;
        for shift in (0..64).step_by(7) {
            let (&byte, rest) = self.0.split_first()?;
            self.0 = rest;
            let bits = u64::from(byte & 0x7f);
            number |= bits << shift;
            if (bits << shift) >> shift != bits {
                return None;
            }
            if byte & 0x80 == 0 {
                return Some(number);
            }
        }
        None
    }

    /// The digest of the study behind the first bytes.
    fn begin(&mut self) -> Option<u64> {
        self.0 = self.0.strip_prefix(BEGIN)?;
        self.fixed()
    }

    fn tally<const K: usize>(&mut self, scales: &[Scale; K]) -> Option<Tally<K>> {
        let mut tally = Tally::new(scales);
        tally.done = self.varying()?;
        tally.missing = self.varying()?;
        let nodes: Option<_> = (0..self.varying()?).map(|_| self.node()).collect();
        tally.sums = Tree::from_nodes(nodes?)?;
        for end in tally.ends.iter_mut().flatten() {
            *end = match self.varying()?.checked_sub(1) {
                None => None,
                Some(number) => Some(End {
                    number,
                    value: self.float()?,
                }),
            };
        }
        for (bins, &scale) in tally.bins.iter_mut().zip(scales) {
            *bins = self.bins(scale)?;
        }
        self.0.is_empty().then_some(tally)
    }

    fn node<const K: usize>(&mut self) -> Option<Node<K>> {
        let (first, level) = (self.varying()?, u32::try_from(self.varying()?).ok()?);
        let mut sums = [Sums::default(); K];
        for sums in &mut sums {
            sums.count = self.varying()?;
            for power in &mut sums.powers {
                *power = self.float()?;
            }
        }
        let blocks = 1_u64.checked_shl(level)?;
        let fits = first.is_multiple_of(blocks) && first.checked_add(blocks).is_some();
        fits.then_some(Node { first, level, sums })
    }

    fn bins(&mut self, scale: Scale) -> Option<Bins> {
        let (count, mut last) = (self.varying()?, i64::MIN);
        // One by one: a number in bytes is no reason to reserve memory.
        let mut bins = Bins::new(scale);
        for _ in 0..count {
            last = last.wrapping_add(self.varying()? as i64);
            bins.add(last, self.varying()?);
        }
        Some(bins)
    }
}
