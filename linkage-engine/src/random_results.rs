//! Results of random mechanisms: sums, extremes and histograms of studies of all sizes.

use std::fmt::Debug;

use linkage_analysis::tolerance::{Estimate, Statistics, Stream, ToleranceError as Refused};

use crate::error::ToleranceError;

/// The least or the largest value of a study, the number of its mechanism, and its dimensions.
#[derive(Clone, Debug, PartialEq)]
pub struct ExtremeMechanism {
    /// The value.
    pub value: f64,
    /// The number of the mechanism in the study, from 0.
    pub number: u64,
    /// Its dimensions.
    pub dimensions: Vec<f64>,
}

/// The results of a study, or of a part of it: in constant memory, 2 MB for each number.
#[derive(Debug)]
pub struct RandomResults {
    stream: Box<dyn Streamed + Send + Sync>,
}

impl RandomResults {
    pub(crate) fn new(stream: Box<dyn Streamed + Send + Sync>) -> Self {
        Self { stream }
    }

    /// Returns the number of mechanisms that are evaluated.
    #[must_use]
    pub fn done(&self) -> u64 {
        self.stream.done()
    }

    /// Returns the number of mechanisms that cannot be assembled.
    #[must_use]
    pub fn missing(&self) -> u64 {
        self.stream.missing()
    }

    /// Reads the results of other parts of the same study, as [`to_bytes`](Self::to_bytes) wrote
    /// them.
    ///
    /// # Errors
    ///
    /// For bytes of another study, and damaged ones.
    pub fn read(&self, bytes: &[u8]) -> Result<Self, ToleranceError> {
        let stream = self.stream.read(bytes).map_err(text)?;
        Ok(Self { stream })
    }

    /// Adds the results of other parts of the same study, as [`to_bytes`](Self::to_bytes) wrote
    /// them. The sum is that of the study as a whole, to the last bit, in any order.
    ///
    /// # Errors
    ///
    /// As [`read`](Self::read), and for mechanisms that are in both.
    pub fn merge(&mut self, bytes: &[u8]) -> Result<(), ToleranceError> {
        self.stream.merge(bytes).map_err(text)
    }

    /// Returns the results as bytes, some hundred kilobytes for each number.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        self.stream.to_bytes()
    }

    /// Returns mean, deviation, skewness and limits of a number, by its index among the columns.
    ///
    /// # Panics
    ///
    /// As all methods with a number, if there is no such number.
    #[must_use]
    pub fn statistics(&self, number: usize) -> Statistics {
        self.stream.statistics(number)
    }

    /// Returns the value below which a part of the mechanisms is, with an interval of this
    /// confidence.
    #[must_use]
    pub fn percentile(&self, number: usize, part: f64, confidence: f64) -> Estimate {
        self.stream.percentile(number, part, confidence)
    }

    /// Returns the part of the mechanisms between two limits, with an interval of this confidence.
    #[must_use]
    pub fn part_within(&self, number: usize, limits: [f64; 2], confidence: f64) -> Estimate {
        self.stream.part_within(number, limits, confidence)
    }

    /// Returns how many values are in each of some bins of equal width between two limits.
    #[must_use]
    pub fn histogram(&self, number: usize, limits: [f64; 2], bins: usize) -> Vec<f64> {
        self.stream.histogram(number, limits, bins)
    }

    /// Returns the mechanisms with the least and with the largest value; `None` if no mechanism can
    /// be assembled.
    #[must_use]
    pub fn extremes(&self, number: usize) -> Option<[ExtremeMechanism; 2]> {
        self.stream.extremes(number)
    }
}

/// The results of a study whose last dimensions have no meaning, or the study.
#[derive(Debug)]
pub(crate) struct Filled<T> {
    pub(crate) inner: T,
    pub(crate) used: usize,
}

/// The methods of results of all sizes.
pub(crate) trait Streamed: Debug {
    fn done(&self) -> u64;
    fn missing(&self) -> u64;
    fn read(&self, bytes: &[u8]) -> Result<Box<dyn Streamed + Send + Sync>, Refused>;
    fn merge(&mut self, bytes: &[u8]) -> Result<(), Refused>;
    fn to_bytes(&self) -> Vec<u8>;
    fn statistics(&self, number: usize) -> Statistics;
    fn percentile(&self, number: usize, part: f64, confidence: f64) -> Estimate;
    fn part_within(&self, number: usize, limits: [f64; 2], confidence: f64) -> Estimate;
    fn histogram(&self, number: usize, limits: [f64; 2], bins: usize) -> Vec<f64>;
    fn extremes(&self, number: usize) -> Option<[ExtremeMechanism; 2]>;
}

impl<const N: usize, const K: usize> Streamed for Filled<Stream<N, K>> {
    fn done(&self) -> u64 {
        self.inner.done()
    }

    fn missing(&self) -> u64 {
        self.inner.missing()
    }

    fn read(&self, bytes: &[u8]) -> Result<Box<dyn Streamed + Send + Sync>, Refused> {
        let (inner, used) = (self.inner.read(bytes)?, self.used);
        Ok(Box::new(Self { inner, used }))
    }

    fn merge(&mut self, bytes: &[u8]) -> Result<(), Refused> {
        let part = self.inner.read(bytes)?;
        self.inner.merge(&part)
    }

    fn to_bytes(&self) -> Vec<u8> {
        self.inner.to_bytes()
    }

    fn statistics(&self, number: usize) -> Statistics {
        self.inner.statistics(number)
    }

    fn percentile(&self, number: usize, part: f64, confidence: f64) -> Estimate {
        self.inner.percentile(number, part, confidence)
    }

    fn part_within(&self, number: usize, [low, high]: [f64; 2], confidence: f64) -> Estimate {
        self.inner.part_within(number, low, high, confidence)
    }

    fn histogram(&self, number: usize, limits: [f64; 2], bins: usize) -> Vec<f64> {
        self.inner.histogram(number, limits, bins)
    }

    fn extremes(&self, number: usize) -> Option<[ExtremeMechanism; 2]> {
        let found = self.inner.extremes(number)?;
        Some(found.map(|one| ExtremeMechanism {
            value: one.value,
            number: one.number,
            dimensions: one.dimensions[..self.used].to_vec(),
        }))
    }
}

pub(crate) fn text(error: Refused) -> ToleranceError {
    ToleranceError(error.to_string())
}
