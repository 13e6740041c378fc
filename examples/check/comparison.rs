//! Comparisons of computed values with known ones, each with a line of its own.

#![allow(dead_code, reason = "no example needs every kind of comparison")]

/// Prints comparisons and counts those that fail.
#[derive(Default)]
pub(crate) struct Check {
    failed: usize,
}

impl Check {
    /// Compares a number with the known answer; `tolerance` is absolute.
    pub(crate) fn near(&mut self, what: &str, value: f64, known: f64, tolerance: f64) {
        let good = (value - known).abs() <= tolerance;
        self.report(
            good,
            &format!("{what:<40} {value:>16.9}   known {known:>16.9}"),
        );
    }

    /// Compares many numbers with their known answers and prints the largest difference only.
    pub(crate) fn all_near(
        &mut self,
        what: &str,
        pairs: impl IntoIterator<Item = (f64, f64)>,
        tolerance: f64,
    ) {
        let differences = pairs
            .into_iter()
            .map(|(value, known)| (value - known).abs());
        // Not `f64::max`, which would let a NaN pass.
        let largest = differences.fold(0.0, |a: f64, b| if a.is_nan() || b <= a { a } else { b });
        let good = largest <= tolerance;
        self.report(
            good,
            &format!("{what:<40} {largest:>16.1e}   largest difference"),
        );
    }

    /// Notes a statement that must be true.
    pub(crate) fn holds(&mut self, what: &str, good: bool) {
        self.report(good, what);
    }

    /// An error if a comparison failed, so that the example ends with exit status 1.
    pub(crate) fn finish(self) -> Result<(), Box<dyn std::error::Error>> {
        match self.failed {
            0 => Ok(()),
            failed => Err(format!("{failed} comparisons failed").into()),
        }
    }

    fn report(&mut self, good: bool, line: &str) {
        println!("  {} {line}", if good { "ok  " } else { "FAIL" });
        self.failed += usize::from(!good);
    }
}
