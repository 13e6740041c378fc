//! Short rounds of several candidates in turn: a busy machine disturbs all of them alike.

use std::time::{Duration, Instant};

use crate::evaluators::Evaluator;

/// Nanoseconds for one position, one entry for each round.
pub(crate) struct Times(Vec<f64>);

/// The first quartile, the median and the third quartile.
fn quartiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    [1, 2, 3].map(|part| values[values.len() * part / 4])
}

impl Times {
    /// Quartiles of the nanoseconds.
    pub(crate) fn nanoseconds(&self) -> [f64; 3] {
        quartiles(self.0.clone())
    }

    /// Quartiles of the ratios within a round.
    pub(crate) fn ratios(&self, other: &Self) -> [f64; 3] {
        quartiles(
            self.0
                .iter()
                .zip(&other.0)
                .map(|(own, other)| own / other)
                .collect(),
        )
    }
}

/// Runs all candidates in turn until the time is up.
pub(crate) fn interleave(candidates: &[&Evaluator], angles: &[f64], time: Duration) -> Vec<Times> {
    let mut times: Vec<Times> = candidates.iter().map(|_| Times(Vec::new())).collect();
    let start = Instant::now();
    while start.elapsed() < time {
        for (candidate, times) in candidates.iter().zip(&mut times) {
            let begin = Instant::now();
            (candidate.pass)(angles);
            times
                .0
                .push(begin.elapsed().as_secs_f64() * 1e9 / angles.len() as f64);
        }
    }
    times
}
