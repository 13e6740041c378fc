//! Order statistics that enclose a quantile.

/// Ranks, from 1, of two of `count` ordered samples that enclose the quantile of `part` with at
/// least this confidence; 0 and `count + 1` where there are too few samples.
///
/// The number of samples below the quantile is binomial. The quantile is below the sample of rank
/// `r` if fewer than `r` samples are below it.
pub(super) fn ranks(count: usize, part: f64, confidence: f64) -> [usize; 2] {
    let outside = 0.5 * (1.0 - confidence);
    let weights = Weights::new(count, part);
    // The largest rank `low` with P(fewer than `low` below) <= outside.
    let (mut low, mut below) = (weights.first, 0.0);
    for weight in &weights.parts {
        below += weight;
        if below > outside {
            break;
        }
        low += 1;
    }
    // The least rank `high` with P(`high` or more below) <= outside.
    let (mut high, mut above) = (weights.first + weights.parts.len(), 0.0);
    for weight in weights.parts.iter().rev() {
        above += weight;
        if above > outside {
            break;
        }
        high -= 1;
    }
    [low, high]
}

/// The binomial probabilities that matter: those of `first`, `first + 1` and so on.
struct Weights {
    first: usize,
    parts: alloc::vec::Vec<f64>,
}

impl Weights {
    /// Computes the probabilities by the ratio of neighbours, from the most probable number to both
    /// sides, normalised at the end.
    fn new(count: usize, part: f64) -> Self {
        const NEGLIGIBLE: f64 = 1e-18;
        let odds = part / (1.0 - part);
        let top = (((count + 1) as f64 * part) as usize).min(count);
        let (mut first, mut weight) = (top, 1.0);
        let mut parts = alloc::vec![1.0];
        while first > 0 && weight > NEGLIGIBLE {
            weight *= first as f64 / ((count - first + 1) as f64 * odds);
            parts.push(weight);
            first -= 1;
        }
        parts.reverse();
        let (mut last, mut weight) = (top, 1.0);
        while last < count && weight > NEGLIGIBLE {
            weight *= (count - last) as f64 * odds / (last + 1) as f64;
            parts.push(weight);
            last += 1;
        }
        let total: f64 = parts.iter().sum();
        parts.iter_mut().for_each(|part| *part /= total);
        Self { first, parts }
    }
}

#[cfg(test)]
mod tests {
    use super::ranks;

    /// Tables of order statistics for the median, and small counts by hand.
    #[test]
    fn known_ranks() {
        assert_eq!(ranks(5, 0.5, 0.95), [0, 6]);
        assert_eq!(ranks(6, 0.5, 0.95), [1, 6]);
        assert_eq!(ranks(10, 0.5, 0.95), [2, 9]);
        assert_eq!(ranks(20, 0.5, 0.95), [6, 15]);
        assert_eq!(ranks(100, 0.5, 0.95), [40, 61]);
        assert_eq!(ranks(1, 0.5, 0.95), [0, 2]);
    }

    #[test]
    fn many_samples_are_nearly_normal() {
        let (count, part) = (1_000_000, 0.99);
        let [low, high] = ranks(count, part, 0.95);
        let (mean, half) = (0.99e6, 1.96 * (1e6_f64 * 0.99 * 0.01).sqrt());
        assert!((low as f64 - (mean - half)).abs() < 3.0, "{low}");
        assert!((high as f64 - (mean + half)).abs() < 3.0, "{high}");
    }
}
