//! Times several pieces of work in turn, round by round, so that a machine that is busy or changes
//! its clock disturbs all of them alike; compares them by the medians of the ratios within rounds.

use std::fmt;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Whether a benchmark should only show that it works: `cargo test` runs it, which does not pass
/// `--bench`, or `--test` was passed.
#[must_use]
pub fn only_tested() -> bool {
    let has = |option: &str| std::env::args().any(|argument| argument == option);
    has("--test") || !has("--bench")
}

/// A piece of work to time.
pub struct Candidate<'a> {
    name: String,
    /// Items (positions) in one run.
    items: usize,
    run: Box<dyn FnMut() + 'a>,
}

impl<'a> Candidate<'a> {
    /// `run` handles `items` items.
    pub fn new(name: impl Into<String>, items: usize, run: impl FnMut() + 'a) -> Self {
        Self {
            name: name.into(),
            items,
            run: Box::new(run),
        }
    }
}

/// Times of one candidate.
#[derive(Clone, Debug)]
pub struct Times {
    /// Its name.
    pub name: String,
    /// Nanoseconds per item, one entry per round.
    pub rounds: Vec<f64>,
}

/// The middle half of several numbers.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// The first quartile.
    pub low: f64,
    /// The median.
    pub median: f64,
    /// The third quartile.
    pub high: f64,
}

impl Spread {
    /// Quartiles of the numbers; NaN if there are none.
    pub fn of(numbers: impl IntoIterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = numbers.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        let at = |part: f64| {
            let index = (sorted.len() as f64 * part) as usize;
            sorted.get(index).copied().unwrap_or(f64::NAN)
        };
        Self {
            low: at(0.25),
            median: at(0.5),
            high: at(0.75),
        }
    }
}

/// Median and, in parentheses, the quartiles.
impl fmt::Display for Spread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = f.precision().unwrap_or(2);
        let Self { low, median, high } = self;
        let text = format!("{median:.digits$} ({low:.digits$}-{high:.digits$})");
        // Not `pad`: it would cut the text off at the precision.
        let width = f.width().unwrap_or(0);
        write!(f, "{text:<width$}")
    }
}

impl Times {
    /// Nanoseconds per item.
    #[must_use]
    pub fn spread(&self) -> Spread {
        Spread::of(self.rounds.iter().copied())
    }

    /// Time of this one over that of another, round by round.
    #[must_use]
    pub fn ratio(&self, other: &Self) -> Spread {
        let pairs = self.rounds.iter().zip(&other.rounds);
        Spread::of(pairs.map(|(a, b)| a / b))
    }
}

/// Runs all candidates in turn until the time is up, at least 5 rounds after one to warm up.
pub fn interleave(mut candidates: Vec<Candidate<'_>>, time: Duration) -> Vec<Times> {
    let mut times: Vec<Times> = candidates
        .iter()
        .map(|candidate| Times {
            name: candidate.name.clone(),
            rounds: Vec::new(),
        })
        .collect();
    candidates
        .iter_mut()
        .for_each(|candidate| (candidate.run)());
    let start = Instant::now();
    let mut round = 0;
    while round < 5 || start.elapsed() < time {
        for (candidate, times) in candidates.iter_mut().zip(&mut times) {
            let begin = Instant::now();
            (candidate.run)();
            let nanoseconds = begin.elapsed().as_secs_f64() * 1e9;
            times.rounds.push(nanoseconds / candidate.items as f64);
        }
        round += 1;
    }
    times
}

/// A chain of operations whose length in core cycles is known: one item is one cycle, so its time
/// tells the clock.
///
/// A product of integers takes 3 cycles and a bit operation 1 on every x86-64 and 64-bit ARM core of
/// the last decade, and neither can be combined with the next.
#[must_use]
pub fn clock() -> Candidate<'static> {
    const STEPS: usize = 4000;
    Candidate::new("clock", 4 * STEPS, || {
        let mut x = black_box(0x9e37_79b9_7f4a_7c15_u64);
        for _ in 0..STEPS {
            x = x.wrapping_mul(x) ^ 0x2545_f491;
        }
        black_box(x);
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_are_those_of_the_sorted_numbers() {
        let spread = Spread::of([5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!([spread.low, spread.median, spread.high], [2.0, 3.0, 4.0]);
        assert_eq!(format!("{spread:<14.1}|"), "3.0 (2.0-4.0) |");
        assert!(Spread::of([]).median.is_nan());
    }

    #[test]
    fn ratios_are_taken_within_rounds() {
        let times = |rounds: &[f64]| Times {
            name: String::new(),
            rounds: rounds.to_vec(),
        };
        let ratio = times(&[1.0, 20.0, 3.0]).ratio(&times(&[2.0, 40.0, 6.0]));
        assert_eq!([ratio.low, ratio.median, ratio.high], [0.5; 3]);
    }

    #[test]
    fn candidates_take_turns() {
        let order = std::cell::RefCell::new(Vec::new());
        let candidates = ["a", "b"].map(|name| {
            let order = &order;
            Candidate::new(name, 1, move || order.borrow_mut().push(name))
        });
        let times = interleave(candidates.into(), Duration::ZERO);
        assert_eq!(
            times.iter().map(|t| t.rounds.len()).collect::<Vec<_>>(),
            [5, 5]
        );
        assert_eq!(order.borrow()[..4], ["a", "b", "a", "b"]);
    }
}
