//! Dimensions from measured positions: estimates, how good they are, and what the readings cannot tell.

mod determined;
mod directions;
mod error;
mod identified;
mod print;
mod reading;
mod scale;
mod settled;
mod words;

use alloc::boxed::Box;
use alloc::string::ToString;
use alloc::vec::Vec;
use core::marker::PhantomData;

pub use identified::{Identified, Residual, Unknown};
pub use reading::{Measured, Readings};
pub use words::{Remedy, Undetermined};

use self::determined::Determined;
use self::reading::{Direct, Row, Sources};
use super::DesignError;
use super::least_squares::{State, minimise};
use super::limits::Limits;
use super::normal::Normal;
use super::varied::Freedom;
use crate::{Dimensions, Table};

/// The most evaluations of a fit: a hundred times what one near its start takes.
const STEPS: usize = 1000;
/// What a change of all parameters over their ranges counts, in standard deviations of readings, while the sum of
/// squares is made least: it keeps what readings do not determine near its start. It is taken out again afterwards.
const HOLD: f64 = 0.1;
/// Steps without it: one takes out all but the curvature.
const POLISH: usize = 3;

/// An identification: dimensions of a mechanism that exists, from readings of its positions, by least squares.
///
/// It begins with dimensions that are nearly right, and stays in their assembly. Sums of squares are of differences
/// over standard deviations, so that for normally distributed errors the estimate is the most likely one.
pub struct Identification<'a, M, A, const N: usize> {
    start: M,
    assembly: A,
    /// The parameters that are unknown, with bounds that may be infinite.
    freedom: Freedom,
    sources: Sources<'a, M, A>,
    offers: Sources<'a, M, A>,
    direct: Vec<Direct>,
    of: PhantomData<[f64; N]>,
}

impl<'a, M, A, const N: usize> Identification<'a, M, A, N>
where
    M: Dimensions<N> + Copy,
{
    /// From these dimensions, in this assembly of them; all parameters are taken to be right unless they are
    /// [`unknown`](Self::unknown).
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

    /// What was measured. There may be several quantities.
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

    /// What could be measured, too: [`Measured::offer`]. Of these is told which would determine what the readings do
    /// not.
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

    /// The estimate, with all that can be told of it.
    ///
    /// It is verified without the descent: its sum of squares is not larger than that of the start, and it has standard errors where
    /// no step within the bounds makes the sum smaller; see [`converged`](Identified::converged).
    ///
    /// # Errors
    ///
    /// All that is wrong with what was given, together; `StartOpen` if the mechanism does not assemble at an input,
    /// `Unsettled` if no least sum of squares is found.
    pub fn run(&self) -> Result<Identified<M, N>, DesignError> {
        let (unknown, limits) = self.check()?;
        let mut start: Vec<f64> = unknown
            .iter()
            .map(|&index| self.start.values()[index])
            .collect();
        limits.clamp(&mut start);
        self.must_assemble(&start, &unknown)?;
        let ranges = self.ranges(&limits, &start, &unknown);
        let x = self.descend(&limits, &start, &ranges, &unknown)?;
        let rows = self.rows(&x, &unknown);
        let found = Determined::new(&rows, &ranges, self.estimates_deviations());
        let mut x = self.polished(&limits, x, &ranges, &unknown, &found);
        for ((x, start), range) in x.iter_mut().zip(&start).zip(&ranges) {
            // What nothing moved but rounding.
            if (*x - start).abs() < 1e-14 * range {
                *x = *start;
            }
        }
        let of = |x: &[f64]| {
            let rows = self.rows(x, &unknown);
            Determined::new(&rows, &ranges, self.estimates_deviations())
        };
        let (mut found, first) = (of(&x), of(&start));
        if found.sum > first.sum {
            (x, found) = (start.clone(), first);
        }
        let converged = self.settle(&limits, &mut x, &ranges, &unknown, &mut found);
        let rows = self.rows(&x, &unknown);
        let parameters = self.start.parameters();
        let mechanism = self.mechanism(&x, &unknown);
        let named = words::Named {
            parameters: unknown.iter().map(|&index| parameters[index]).collect(),
            places: unknown,
            starts: start,
            values: x,
            ranges,
            limits,
        };
        let mut offers: Vec<Row> = self.rows_of(&self.offers, &mechanism, &named.places);
        offers.extend(self.beside(&mechanism, &named.places, &rows));
        let undetermined = words::undetermined(&named, &found, &offers);
        Ok(identified::identified(
            mechanism,
            &named,
            &rows,
            &found,
            undetermined,
            converged,
        ))
    }

    /// The least sum of squares, with a hold on what readings do not determine.
    fn descend(
        &self,
        limits: &Limits,
        start: &[f64],
        ranges: &[f64],
        unknown: &[usize],
    ) -> Result<Vec<f64>, DesignError> {
        let places: Vec<usize> = (0..unknown.len()).collect();
        let evaluate = |x: &[f64], normal: &mut Normal| {
            for row in self.rows(x, unknown) {
                let slopes: Vec<f64> = row
                    .slopes
                    .iter()
                    .map(|slope| slope / row.deviation)
                    .collect();
                normal.add(row.difference / row.deviation, &places, &slopes);
            }
            for (j, range) in ranges.iter().enumerate() {
                normal.add(HOLD * (x[j] - start[j]) / range, &[j], &[HOLD / range]);
            }
        };
        match minimise(start.to_vec(), limits, STEPS, evaluate) {
            (descent, State::Converged) => Ok(descent.x),
            _ => Err(DesignError::Unsettled { steps: STEPS }),
        }
    }

    /// Without the hold on what is determined; what is at a bound stays there, and so does all the rest then.
    fn polished(
        &self,
        limits: &Limits,
        mut x: Vec<f64>,
        ranges: &[f64],
        unknown: &[usize],
        found: &Determined,
    ) -> Vec<f64> {
        let mut found = found.clone();
        for _ in 0..POLISH {
            let step = found.step();
            let next: Vec<f64> = (0..x.len()).map(|j| x[j] - ranges[j] * step[j]).collect();
            if !limits.hold(&next) {
                break;
            }
            let rows = self.rows(&next, unknown);
            if rows.iter().any(|row| row.difference.is_nan()) {
                break;
            }
            let there = Determined::new(&rows, ranges, self.estimates_deviations());
            // The same number of combinations is determined, and the sum of squares grows by rounding at most.
            if there.rank != found.rank || there.sum > found.sum * (1.0 + 1e-9) {
                break;
            }
            (x, found) = (next, there);
        }
        x
    }

    fn mechanism(&self, x: &[f64], unknown: &[usize]) -> M {
        let mut values = self.start.values();
        for (&index, &x) in unknown.iter().zip(x) {
            values[index] = x;
        }
        M::from_values(&values)
    }

    fn rows(&self, x: &[f64], unknown: &[usize]) -> Vec<Row> {
        let mechanism = self.mechanism(x, unknown);
        let mut rows = self.rows_of(&self.sources, &mechanism, unknown);
        let parameters = M::PARAMETERS;
        for direct in &self.direct {
            let place = unknown
                .iter()
                .position(|&index| parameters[index].name == direct.name);
            let Some(place) = place else { continue };
            let mut slopes = alloc::vec![0.0; unknown.len()];
            slopes[place] = 1.0;
            rows.push(Row {
                number: parameters[unknown[place]].name,
                unit: parameters[unknown[place]].unit,
                input_name: "",
                input: f64::NAN,
                reading: direct.value,
                difference: x[place] - direct.value,
                deviation: direct.deviation,
                slopes,
            });
        }
        rows
    }

    fn rows_of(&self, sources: &Sources<'a, M, A>, mechanism: &M, unknown: &[usize]) -> Vec<Row> {
        let rows = sources
            .iter()
            .map(|source| source.rows(&self.assembly, mechanism, unknown));
        rows.flatten().collect()
    }

    /// Without any standard deviations they are found from the scatter of the readings.
    fn estimates_deviations(&self) -> bool {
        !self.sources.iter().any(|source| source.has_deviations()) && self.direct.is_empty()
    }
}
