//! A budget as a table.

use alloc::format;
use alloc::string::String;
use core::fmt;

use super::Budget;
use linkage_core::format::rounded;

/// A table for each component: quantity, value, standard uncertainty, distribution, degrees of
/// freedom, sensitivity coefficient, contribution and share; then the combined uncertainty and the
/// correlations.
impl<const N: usize, const K: usize> fmt::Display for Budget<N, K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for k in 0..K {
            if K > 1 {
                writeln!(
                    f,
                    "{}component {}",
                    if k > 0 { "\n" } else { "" },
                    ["x", "y", "z"][k]
                )?;
            }
            self.print_component(f, k)?;
        }
        self.print_correlations(f)
    }
}

impl<const N: usize, const K: usize> Budget<N, K> {
    fn print_component(&self, f: &mut fmt::Formatter<'_>, k: usize) -> fmt::Result {
        let lines = self.lines(k);
        let width = lines.iter().map(|line| line.name.len()).max().unwrap_or(0);
        let width = width.max("standard uncertainty".len());
        writeln!(
            f,
            "{:<width$} {:>12} {:>12} {:<5}{:<11} {:>7} {:>12} {:>12} {:>9}",
            "quantity",
            "value",
            "uncertainty",
            "",
            "distributed",
            "freedom",
            "sensitivity",
            "contribution",
            "share"
        )?;
        for line in &lines {
            let [value, standard, sensitivity, contribution] = [
                line.value,
                line.standard,
                line.sensitivity,
                line.contribution,
            ]
            .map(|x| format!("{}", rounded(x)));
            writeln!(
                f,
                "{:<width$} {value:>12} {standard:>12} {:<5}{:<11} {:>7} {sensitivity:>12} {contribution:>12} {:>7.1} %",
                line.name,
                line.unit,
                line.distribution,
                freedom(line.degrees_of_freedom),
                100.0 * line.share,
            )?;
        }
        let standard = format!("{}", rounded(self.standard()[k]));
        let degrees = freedom(self.degrees_of_freedom(k));
        // Under the contributions, and under the degrees of freedom.
        writeln!(
            f,
            "{:<width$} {:>50} {:>25}",
            "standard uncertainty", degrees, standard
        )?;
        let factor = self.coverage_factor(k, 0.95);
        if factor.is_nan() {
            return writeln!(
                f,
                "no coverage factor: degrees of freedom are not defined where a quantity with a finite number of them is correlated"
            );
        }
        let expanded = format!("{}", rounded(self.expanded(k, 0.95)));
        let name = format!("{:<width$} {:>50}", "at 95 %", format!("times {factor:.3}"));
        writeln!(f, "{name} {expanded:>25}")
    }

    fn print_correlations(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let uncertain = &self.uncertainties;
        let names = uncertain
            .tolerances()
            .parameters()
            .map(|parameter| parameter.name);
        for i in 0..N {
            for j in i + 1..N {
                let coefficient = uncertain.correlation_matrix()[i][j];
                if coefficient != 0.0 {
                    writeln!(
                        f,
                        "correlation of {} and {}: {}",
                        names[i],
                        names[j],
                        rounded(coefficient)
                    )?;
                }
            }
        }
        Ok(())
    }
}

fn freedom(degrees: f64) -> String {
    if degrees.is_infinite() {
        String::from("inf")
    } else if degrees.is_nan() {
        String::from("-")
    } else {
        format!("{degrees:.1}")
    }
}
