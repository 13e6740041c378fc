//! The steps of an identification.

use std::vec::Vec;

use super::determined::Determined;
use super::identified::{self, Identified};
use super::named::Named;
use super::reading::ReadingRow;
use super::setup::Identification;
use super::{check, fit, rows, scale, settled, undetermined};
use crate::error::DesignError;
use linkage_runtime::Dimensions;

impl<M, A, const N: usize> Identification<'_, M, A, N>
where
    M: Dimensions<N> + Copy,
{
    /// Returns the estimate with its errors.
    ///
    /// It is verified without the descent: its sum of squares is not larger than that of the start,
    /// and it has standard errors where no step within the bounds makes the sum smaller; see
    /// [`converged`](Identified::converged).
    ///
    /// # Errors
    ///
    /// All mistakes of the input, together; `StartOpen` if the mechanism does not assemble at an
    /// input, `Unsettled` if no least sum of squares is found.
    pub fn run(&self) -> Result<Identified<M, N>, DesignError> {
        let (unknown, limits) = check::check(self)?;
        let mut start: Vec<f64> = unknown
            .iter()
            .map(|&index| self.start.values()[index])
            .collect();
        limits.clamp(&mut start);
        check::must_assemble(self, &start, &unknown)?;
        let ranges = scale::ranges(self, &limits, &start, &unknown);
        let x = fit::descend(self, &limits, &start, &ranges, &unknown)?;
        let rows = rows::rows(self, &x, &unknown);
        let found = Determined::new(&rows, &ranges, rows::estimates_deviations(self));
        let mut x = fit::polished(self, &limits, x, &ranges, &unknown, &found);
        for ((x, start), range) in x.iter_mut().zip(&start).zip(&ranges) {
            // A parameter that only rounding moved.
            if (*x - start).abs() < 1e-14 * range {
                *x = *start;
            }
        }
        let of = |x: &[f64]| {
            let rows = rows::rows(self, x, &unknown);
            Determined::new(&rows, &ranges, rows::estimates_deviations(self))
        };
        let (mut found, first) = (of(&x), of(&start));
        if found.sum > first.sum {
            (x, found) = (start.clone(), first);
        }
        let converged = settled::settle(self, &limits, &mut x, &ranges, &unknown, &mut found);
        let rows = rows::rows(self, &x, &unknown);
        let parameters = self.start.parameters();
        let mechanism = rows::mechanism(self, &x, &unknown);
        let named = Named {
            parameters: unknown.iter().map(|&index| parameters[index]).collect(),
            places: unknown,
            starts: start,
            values: x,
            ranges,
            limits,
        };
        let mut offers: Vec<ReadingRow> =
            rows::rows_of(self, &self.offers, &mechanism, &named.places);
        offers.extend(scale::unread_rows(self, &mechanism, &named.places, &rows));
        let undetermined = undetermined::undetermined(&named, &found, &offers);
        Ok(identified::identified(
            mechanism,
            &named,
            &rows,
            &found,
            undetermined,
            converged,
        ))
    }
}
