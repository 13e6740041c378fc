//! Times of methods to given errors, and the ratio of ours to the best of the others.

use std::ops::RangeInclusive;

/// A run of a method: the error of its result, and its time in s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    pub(crate) error: f64,
    pub(crate) seconds: f64,
}

/// A method over its settings.
#[derive(Debug)]
pub(crate) struct Method {
    pub(crate) name: String,
    pub(crate) is_ours: bool,
    pub(crate) runs: Vec<Run>,
}

impl Method {
    /// Runs one of our methods with tolerances by their digits.
    pub(crate) fn ours(
        name: &str,
        digits: RangeInclusive<i32>,
        run: impl Fn(f64) -> Option<Run>,
    ) -> Self {
        Self {
            name: name.to_owned(),
            is_ours: true,
            runs: digits
                .filter_map(|digits| run(10_f64.powi(-digits)))
                .collect(),
        }
    }

    /// Returns the least time of a run that is as accurate as wished; infinite without one.
    pub(crate) fn time_to(&self, error: f64) -> f64 {
        let reached = self.runs.iter().filter(|run| run.error <= error);
        reached.map(|run| run.seconds).fold(f64::INFINITY, f64::min)
    }

    /// Returns the runs of which no other one is faster and as accurate, the fastest first.
    pub(crate) fn front(&self) -> Vec<Run> {
        let mut runs = self.runs.clone();
        runs.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
        let mut least = f64::INFINITY;
        runs.retain(|run| {
            let is_better = run.error < least;
            least = least.min(run.error);
            is_better
        });
        runs
    }
}

/// A problem with all methods.
#[derive(Debug)]
pub(crate) struct Panel {
    pub(crate) title: &'static str,
    pub(crate) methods: Vec<Method>,
}

/// Errors of the table, rad.
const ERRORS: [i32; 10] = [-3, -4, -5, -6, -7, -8, -9, -10, -11, -12];

impl Panel {
    /// Returns the fastest of our methods, or of the others, with its time to an error.
    fn fastest(&self, is_ours: bool, error: f64) -> Option<(&Method, f64)> {
        let methods = self
            .methods
            .iter()
            .filter(|method| method.is_ours == is_ours);
        let times = methods.map(|method| (method, method.time_to(error)));
        let reached = times.filter(|(_, time)| time.is_finite());
        reached.min_by(|(_, a), (_, b)| a.total_cmp(b))
    }

    /// Prints the times of all methods in ms, and the ratios.
    pub(crate) fn print(&self) {
        println!(
            "{}: ms to an error of the first coordinate, rad",
            self.title
        );
        print!("  {:<40}", "");
        ERRORS
            .iter()
            .for_each(|digits| print!("{:>9}", format!("1e{digits}")));
        println!();
        for method in &self.methods {
            print!("  {:<40}", method.name);
            for digits in ERRORS {
                let time = method.time_to(10_f64.powi(digits));
                let text = if time.is_finite() {
                    format!("{:.3}", 1e3 * time)
                } else {
                    "-".into()
                };
                print!("{text:>9}");
            }
            println!();
        }
        print!("  {:<40}", "best of the others / ours");
        for digits in ERRORS {
            let error = 10_f64.powi(digits);
            let text = match (self.fastest(true, error), self.fastest(false, error)) {
                (Some((_, ours)), Some((_, others))) => format!("{:.0}", others / ours),
                _ => "-".into(),
            };
            print!("{text:>9}");
        }
        println!();
    }
}
