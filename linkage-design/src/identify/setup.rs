//! Inputs of an identification: the start, the unknown parameters and the readings.

use core::marker::PhantomData;
use std::boxed::Box;
use std::string::ToString;
use std::vec::Vec;

use super::reading::{Direct, Readings, Sources};
use crate::varied::Freedom;
use linkage_runtime::{Dimensions, Table};

/// An identification: dimensions of a mechanism that exists, from readings of its positions, by
/// least squares.
///
/// It begins with dimensions that are nearly right, and stays in their assembly. Sums of squares
/// are of differences over standard deviations, so that for normally distributed errors the
/// estimate is the most likely one.
pub struct Identification<'a, M, A, const N: usize> {
    pub(super) start: M,
    pub(super) assembly: A,
    /// The parameters that are unknown, with bounds that may be infinite.
    pub(super) freedom: Freedom,
    pub(super) sources: Sources<'a, M, A>,
    pub(super) offers: Sources<'a, M, A>,
    pub(super) direct: Vec<Direct>,
    pub(super) of: PhantomData<[f64; N]>,
}

impl<'a, M, A, const N: usize> Identification<'a, M, A, N>
where
    M: Dimensions<N> + Copy,
{
    /// Starts from these dimensions, in this assembly of them. All parameters are taken to be right
    /// unless they are [`unknown`](Self::unknown).
    #[must_use]
    pub fn new(start: M, assembly: A) -> Self {
        Self {
            start,
            assembly,
            freedom: Freedom::default(),
            sources: Vec::new(),
            offers: Vec::new(),
            direct: Vec::new(),
            of: PhantomData,
        }
    }

    /// These parameters are to be found, each named as in `PARAMETERS`, `pivot.x` for a component.
    #[must_use]
    pub fn unknown<'n>(mut self, names: impl IntoIterator<Item = &'n str>) -> Self {
        for name in names {
            self.freedom.vary(name, f64::NEG_INFINITY, f64::INFINITY);
        }
        self
    }

    /// This parameter is to be found between bounds, both included.
    #[must_use]
    pub fn vary(mut self, name: &str, low: f64, high: f64) -> Self {
        self.freedom.vary(name, low, high);
        self
    }

    /// Adds readings. There may be several quantities.
    #[must_use]
    pub fn measured<C, F>(mut self, readings: Readings<M, A, C, F, N>) -> Self
    where
        M: 'a,
        A: 'a,
        F: Fn(&A, &[M], &[f64], &mut C) + 'a,
        C: Table + Default + 'a,
    {
        self.sources.push(Box::new(readings));
        self
    }

    /// Adds possible readings: [`Measured::offer`](super::Measured::offer). The result lists those
    /// that would determine the undetermined combinations.
    #[must_use]
    pub fn offered<C, F>(mut self, readings: Readings<M, A, C, F, N>) -> Self
    where
        M: 'a,
        A: 'a,
        F: Fn(&A, &[M], &[f64], &mut C) + 'a,
        C: Table + Default + 'a,
    {
        self.offers.push(Box::new(readings));
        self
    }

    /// The parameter itself was measured, with this standard deviation.
    #[must_use]
    pub fn measured_itself(mut self, name: &str, value: f64, deviation: f64) -> Self {
        let name = name.to_string();
        self.direct.push(Direct {
            name,
            value,
            deviation,
        });
        self
    }
}
