//! Values counted in bins: a histogram from which percentiles come with a known error.
//!
//! Bins are of equal width around the centre, far finer than the spread of the values, and of
//! equal width relative to their distance beyond. So each real number has a bin, whatever the
//! first values were that gave centre and width.

use alloc::collections::BTreeMap;
use alloc::vec;
use alloc::vec::Vec;

/// Binary logarithm of the number of bins on each side of the centre.
const SIDE_BITS: u32 = 17;
/// Bins on each side of the centre.
const SIDE: u32 = 1 << SIDE_BITS;
/// Bins in the spread of the values.
const IN_SPREAD: f64 = 16_384.0;
/// Binary logarithm of the number of bins between a distance beyond the sides and its double.
const FAR_BITS: u32 = 13;

/// Where the bins are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    /// The middle of the bin in the middle.
    pub(super) centre: f64,
    /// The width of the bins around it.
    pub(super) width: f64,
}

impl Scale {
    /// The scale for values like these: their median, and a width that is a small part of their
    /// spread. NaN is left out.
    pub(super) fn fitting(values: &[f64]) -> Self {
        let mut sorted: Vec<f64> = values.iter().copied().filter(|x| x.is_finite()).collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let quantile = |part: f64| {
            let rank = part * sorted.len().saturating_sub(1) as f64;
            sorted.get(rank as usize).copied().unwrap_or(0.0)
        };
        let centre = quantile(0.5);
        // One standard deviation, if they are normal.
        let spread = 0.5 * (quantile(0.841_344_746_068_543) - quantile(0.158_655_253_931_457));
        // Roundoffs of the values are not resolved, and neither is nothing at all.
        let least = (centre.abs() * f64::EPSILON).max(f64::MIN_POSITIVE);
        Self {
            centre,
            width: (spread / IN_SPREAD).max(least),
        }
    }

    /// The bin of a number that is not NaN, in the order of the numbers; 0 is in the middle.
    fn bin(self, x: f64) -> i64 {
        let t = (x - self.centre) * (1.0 / self.width);
        let size = t.abs();
        let index = if size < f64::from(SIDE) {
            i64::from((size + 0.5) as u32)
        } else {
            let beyond = (size.to_bits() - f64::from(SIDE).to_bits()) >> (52 - FAR_BITS);
            i64::from(SIDE) + 1 + beyond as i64
        };
        if t < 0.0 { -index } else { index }
    }

    /// The ends of a bin.
    fn ends(self, bin: i64) -> [f64; 2] {
        let size = bin.unsigned_abs();
        let beyond = size.checked_sub(u64::from(SIDE) + 1);
        let ends = match beyond {
            None => {
                let size = size as f64;
                [size - 0.5, (size + 0.5).min(f64::from(SIDE))]
            }
            Some(beyond) => [beyond, beyond + 1]
                .map(|k| f64::from_bits(f64::from(SIDE).to_bits() + (k << (52 - FAR_BITS)))),
        };
        // Beyond all numbers is no number.
        let ends = ends.map(|t| if t.is_nan() { f64::INFINITY } else { t });
        let [low, high] = if bin < 0 { [-ends[1], -ends[0]] } else { ends };
        [low, high].map(|t| self.centre + self.width * t)
    }
}

/// How many values are in each bin.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Bins {
    pub(super) scale: Scale,
    /// Those within `SIDE` widths of the centre.
    near: Vec<u64>,
    /// Those beyond.
    far: BTreeMap<i64, u64>,
}

/// Values in one bin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bin {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) count: u64,
}

impl Bins {
    pub(super) fn new(scale: Scale) -> Self {
        Self {
            scale,
            near: vec![0; 2 * SIDE as usize + 1],
            far: BTreeMap::new(),
        }
    }

    /// Counts the values of a block that are not NaN.
    pub(super) fn count(&mut self, values: &[f64]) {
        for chunk in values.chunks(CHUNK) {
            let mut indices = [OUTSIDE; CHUNK];
            crate::tolerance::monte_carlo::wide::run(Indices {
                values: chunk,
                scale: self.scale,
                indices: &mut indices,
            });
            let mut outside = false;
            for &index in &indices[..chunk.len()] {
                match self.near.get_mut(index as usize) {
                    Some(count) => *count += 1,
                    None => outside = true,
                }
            }
            if outside {
                self.count_outside(chunk, &indices);
            }
        }
    }

    #[cold]
    fn count_outside(&mut self, values: &[f64], indices: &[u32]) {
        for (&x, &index) in values.iter().zip(indices) {
            if index == OUTSIDE && !x.is_nan() {
                self.add(self.scale.bin(x), 1);
            }
        }
    }

    /// Adds values to a bin.
    pub(super) fn add(&mut self, bin: i64, count: u64) {
        let near = usize::try_from(bin + i64::from(SIDE)).ok();
        match near.and_then(|index| self.near.get_mut(index)) {
            Some(entry) => *entry += count,
            None => *self.far.entry(bin).or_default() += count,
        }
    }

    /// Adds the counts of other bins of the same scale.
    pub(super) fn merge(&mut self, other: &Self) {
        for (count, more) in self.near.iter_mut().zip(&other.near) {
            *count += more;
        }
        for (&bin, &count) in &other.far {
            *self.far.entry(bin).or_default() += count;
        }
    }

    /// Bins with their counts by number, those that have some, in order.
    pub(super) fn numbered(&self) -> impl Iterator<Item = (i64, u64)> {
        let near = (-i64::from(SIDE)..).zip(self.near.iter().copied());
        let near = near.filter(|&(_, count)| count > 0);
        let far =
            |low: i64, high: i64| self.far.range(low..high).map(|(&bin, &count)| (bin, count));
        far(i64::MIN, 0).chain(near).chain(far(0, i64::MAX))
    }

    /// Those that have some values, in the order of the numbers.
    pub(super) fn filled(&self) -> impl Iterator<Item = Bin> {
        self.numbered().map(|(bin, count)| {
            let [low, high] = self.scale.ends(bin);
            Bin { low, high, count }
        })
    }
}

/// Values that are sorted into bins at a time.
const CHUNK: usize = 256;
/// The index of a value without a bin near the centre.
const OUTSIDE: u32 = u32::MAX;

/// Finds the indices of bins near the centre.
struct Indices<'a> {
    values: &'a [f64],
    scale: Scale,
    indices: &'a mut [u32; CHUNK],
}

impl crate::tolerance::monte_carlo::wide::Loop for Indices<'_> {
    type Result = ();

    #[inline(always)]
    fn run(self) {
        /// Added to a number, its integer is in the low bits.
        const INTEGERS: f64 = 4_503_599_627_370_496.0;
        let Scale { centre, width } = self.scale;
        let inverse = 1.0 / width;
        for (index, &x) in self.indices.iter_mut().zip(self.values) {
            let t = (x - centre) * inverse;
            // As in `Scale::bin`: halves away from 0.
            let size = t.abs();
            let whole = {
                let rounded = (size + 0.5) + INTEGERS - INTEGERS;
                if rounded > size + 0.5 {
                    rounded - 1.0
                } else {
                    rounded
                }
            };
            let shifted = if t < 0.0 {
                f64::from(SIDE) - whole
            } else {
                f64::from(SIDE) + whole
            };
            let bits = (shifted + INTEGERS).to_bits() as u32;
            *index = if size < f64::from(SIDE) {
                bits
            } else {
                OUTSIDE
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCALE: Scale = Scale {
        centre: 10.0,
        width: 0.01,
    };

    #[test]
    fn each_number_is_in_its_bin() {
        let far = [
            1e5,
            1e9,
            -1e9,
            3e300,
            -f64::MAX,
            f64::INFINITY,
            f64::NEG_INFINITY,
        ];
        let near = (-40..40).map(|k| 10.0 + 52.7 * f64::from(k) + 0.003);
        let halves = (-20..20).map(|k| 10.0 + 0.01 * (f64::from(k) + 0.5));
        for x in far.into_iter().chain(near).chain(halves) {
            let [low, high] = SCALE.ends(SCALE.bin(x));
            let slack = if x.is_finite() {
                4.0 * f64::EPSILON * x.abs()
            } else {
                0.0
            };
            assert!(
                low <= x + slack && x - slack <= high,
                "{x}: {low} to {high}"
            );
            let mut bins = Bins::new(SCALE);
            bins.count(&[f64::NAN, x]);
            let numbered: Vec<_> = bins.numbered().collect();
            assert_eq!(numbered, [(SCALE.bin(x), 1)], "{x}");
        }
    }

    #[test]
    fn bins_follow_each_other() {
        let first = -i64::from(SIDE) - 20_000;
        for bin in first..-first {
            let [[_, end], [begin, _]] = [bin, bin + 1].map(|bin| SCALE.ends(bin));
            assert_eq!(end, begin, "{bin}");
        }
        let relative = |x: f64| {
            let [low, high] = SCALE.ends(SCALE.bin(x));
            (high - low) / (x - SCALE.centre).abs()
        };
        assert!(relative(1e7) < 1.3e-4 && relative(-1e250) < 1.3e-4);
    }

    #[test]
    fn the_scale_is_that_of_the_values() {
        let values: Vec<f64> = (0..=1000).map(|k| 5.0 + 1e-3 * f64::from(k)).collect();
        let scale = Scale::fitting(&values);
        assert!((scale.centre - 5.5).abs() < 1e-9, "{scale:?}");
        assert!((scale.width * IN_SPREAD - 0.3415).abs() < 2e-3, "{scale:?}");
        // All equal, one, none.
        let equal = Scale::fitting(&[3.0; 9]);
        assert!(equal.centre == 3.0 && equal.width > 0.0 && equal.width < 1e-15);
        assert!(Scale::fitting(&[f64::NAN]).width > 0.0);
        assert!(Scale::fitting(&[0.0]).width > 0.0);
    }

    #[test]
    fn merged_counts() {
        let values: Vec<f64> = (0..5000).map(|k| f64::from(k * k % 991) - 300.0).collect();
        let mut whole = Bins::new(SCALE);
        whole.count(&values);
        let (mut one, mut other) = (Bins::new(SCALE), Bins::new(SCALE));
        one.count(&values[..1700]);
        other.count(&values[1700..]);
        other.merge(&one);
        assert_eq!(other, whole);
        let mut again = Bins::new(SCALE);
        whole
            .numbered()
            .for_each(|(bin, count)| again.add(bin, count));
        assert_eq!(again, whole);
        assert_eq!(whole.filled().map(|bin| bin.count).sum::<u64>(), 5000);
    }
}
