//! Results as bytes, for other processes and for files: writer, reader and digest.
//!
//! Little-endian numbers; counts have as many bytes as they need, seven bits in each. A digest of
//! all bytes is last, so that damaged ones are noticed.

use alloc::vec::Vec;

/// FNV-1a of 64 bits: another byte at one place always gives another digest.
#[must_use]
pub fn digest(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// Writes numbers behind each other.
#[derive(Debug)]
pub struct Writer(Vec<u8>);

impl Writer {
    /// Begins with the format and its version.
    #[must_use]
    pub fn new(begin: &[u8; 8]) -> Self {
        Self(begin.to_vec())
    }

    /// Writes a number of eight bytes.
    pub fn fixed(&mut self, number: u64) {
        self.0.extend_from_slice(&number.to_le_bytes());
    }

    /// Writes the bits of a number.
    pub fn float(&mut self, number: f64) {
        self.fixed(number.to_bits());
    }

    /// Writes a count: seven bits a byte, the lowest first; all bytes but the last have the eighth
    /// bit.
    pub fn varying(&mut self, mut number: u64) {
        while number >= 0x80 {
            self.0.push(number as u8 | 0x80);
            number >>= 7;
        }
        self.0.push(number as u8);
    }

    /// Writes the digest of all bytes, and returns them with it.
    #[must_use]
    pub fn finish(mut self) -> Vec<u8> {
        self.fixed(digest(&self.0));
        self.0
    }
}

/// Reads what a [`Writer`] wrote, in the same order. Each method returns `None` behind the last
/// byte.
#[derive(Debug)]
pub struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    /// Reads bytes that begin and end as they should; `None` for others, and for damaged ones.
    #[must_use]
    pub fn new(bytes: &'a [u8], begin: &[u8; 8]) -> Option<Self> {
        let (bytes, end) = bytes.split_last_chunk()?;
        let is_whole = digest(bytes).to_le_bytes() == *end;
        let rest = bytes.strip_prefix(begin)?;
        is_whole.then_some(Self(rest))
    }

    /// Reads a number of eight bytes.
    pub fn fixed(&mut self) -> Option<u64> {
        let (bytes, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(u64::from_le_bytes(*bytes))
    }

    /// Reads a number by its bits.
    pub fn float(&mut self) -> Option<f64> {
        self.fixed().map(f64::from_bits)
    }

    /// Reads a count; `None` also where it has more than 64 bits.
    pub fn varying(&mut self) -> Option<u64> {
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

    /// Reads a count as an index.
    pub fn index(&mut self) -> Option<usize> {
        self.varying()?.try_into().ok()
    }

    /// Returns true behind the last byte.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BEGIN: &[u8; 8] = b"numbers1";

    #[test]
    fn numbers_come_back() {
        let counts = [0, 1, 0x7f, 0x80, 300, u64::MAX / 2, u64::MAX];
        let mut out = Writer::new(BEGIN);
        out.float(-0.1);
        counts.iter().for_each(|&count| out.varying(count));
        let bytes = out.finish();
        let mut reader = Reader::new(&bytes, BEGIN).expect("whole");
        assert_eq!(reader.float(), Some(-0.1));
        for count in counts {
            assert_eq!(reader.varying(), Some(count));
        }
        assert!(reader.is_empty());
        assert_eq!((reader.fixed(), reader.varying()), (None, None));
    }

    #[test]
    fn each_damaged_byte_is_noticed() {
        let mut out = Writer::new(BEGIN);
        out.varying(70_000);
        let whole = out.finish();
        for index in 0..whole.len() {
            let mut bytes = whole.clone();
            bytes[index] ^= 1;
            assert!(Reader::new(&bytes, BEGIN).is_none(), "byte {index}");
        }
        assert!(Reader::new(&whole[1..], BEGIN).is_none());
        assert!(Reader::new(&[], BEGIN).is_none());
    }

    #[test]
    fn a_count_of_more_bits_is_refused() {
        let mut out = Writer::new(BEGIN);
        out.0.extend([0xff; 9]);
        out.0.push(2);
        assert_eq!(
            Reader::new(&out.finish(), BEGIN).and_then(|mut reader| reader.varying()),
            None
        );
    }
}
