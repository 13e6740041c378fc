//! An identification as tables.

use core::fmt;
use std::format;
use std::string::{String, ToString};

use super::Identified;
use super::identified::pairs;
use linkage_core::format::rounded;

/// Correlations above this size are printed: the one parameter alone would be known more than twice
/// as well.
const STRONG: f64 = 0.9;

/// Estimates with standard errors, undetermined combinations, strong correlations, outliers.
impl<M, const N: usize> fmt::Display for Identified<M, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self
            .parameters
            .iter()
            .map(|parameter| parameter.name.len())
            .max()
            .unwrap_or(0)
            .max(9);
        writeln!(
            f,
            "{:<width$} {:>12} {:>12} {:>14}",
            "parameter", "start", "estimate", "standard error"
        )?;
        for parameter in &self.parameters {
            let [start, value] =
                [parameter.start, parameter.value].map(|x| format!("{}", rounded(x)));
            let error = match parameter.standard_error {
                error if error.is_infinite() => String::from("not determined"),
                _ if !self.converged => String::from("not converged"),
                _ => format!(
                    "{:>14} {}",
                    rounded(parameter.standard_error).to_string(),
                    parameter.unit
                ),
            };
            let bound = if parameter.is_at_bound {
                ", at its bound"
            } else {
                ""
            };
            let name = parameter.name;
            writeln!(
                f,
                "{name:<width$} {start:>12} {value:>12} {}{bound}",
                error.trim_end()
            )?;
        }
        writeln!(
            f,
            "{} readings, {} degrees of freedom, sum of squares {}",
            self.residuals.len(),
            self.degrees_of_freedom,
            rounded(self.sum_of_squares)
        )?;
        if !self.converged {
            writeln!(
                f,
                "not converged: the sum of squares still falls where the fit ended, as where the mechanism falls apart beyond it; \
                 begin elsewhere, or look for a reading that the mechanism cannot have"
            )?;
        }
        for combination in &self.undetermined {
            writeln!(f, "not determined: {combination}")?;
        }
        for (a, b, correlation) in
            pairs(self).filter(|(.., correlation)| correlation.abs() > STRONG)
        {
            writeln!(
                f,
                "correlation of {} and {}: {correlation:.3}",
                a.name, b.name
            )?;
        }
        for outlier in self.outliers() {
            writeln!(
                f,
                "outlier: {} at {} is {} {} off, {:.1} standard deviations",
                outlier.number,
                rounded(outlier.input),
                rounded(outlier.difference),
                outlier.unit,
                outlier.standardised
            )?;
        }
        Ok(())
    }
}
