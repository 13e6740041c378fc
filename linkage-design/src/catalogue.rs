//! Parameters that take some values only: branch and bound from a local optimum.
//!
//! Where a parameter is between two values of its list, one branch has all values up to the lower
//! one and the other one all from the upper one on, and everything is optimised again in each. The
//! bound of a branch is the value of a local optimum of it: where each branch has one optimum, the
//! result is the best of all combinations; where there are several, a better combination may be
//! missed.

use core::ops::RangeInclusive;
use std::vec::Vec;

use super::limits::Limits;

#[cfg(test)]
mod tests;

/// An end of a branch.
pub(crate) trait Local {
    /// The parameters that vary, first of all variables.
    fn varied(&self) -> &[f64];

    /// The minimised value.
    fn least(&self) -> f64;
}

/// Parameters, by their place among those that vary, with the values that they take, which ascend.
pub(crate) type Catalogues = [(usize, Vec<f64>)];

/// The best optimum near this one with all catalogue parameters at values of their lists; `None` if
/// there is none.
///
/// `descend` gives the optimum within narrower limits, from that within wider ones. No branch is
/// begun once `ended`: the best until then is the result.
pub(crate) fn rounded<O: Local>(
    catalogues: &Catalogues,
    limits: &Limits,
    optimum: O,
    descend: impl FnMut(&Limits, &O) -> Option<O>,
    ended: &dyn Fn() -> bool,
) -> Option<O> {
    let mut branches = Branches {
        catalogues,
        descend,
        ended,
        best: None,
    };
    let all = |(_, values): &(usize, Vec<f64>)| 0..=values.len().saturating_sub(1);
    let open = catalogues.iter().map(all).collect();
    branches.branch(open, limits, optimum);
    branches.best
}

struct Branches<'c, O, F> {
    catalogues: &'c Catalogues,
    descend: F,
    ended: &'c dyn Fn() -> bool,
    best: Option<O>,
}

impl<O: Local, F: FnMut(&Limits, &O) -> Option<O>> Branches<'_, O, F> {
    /// The best of a branch, whose optimum between the values is known; `open` are the numbers of
    /// the values of each list that it has.
    fn branch(&mut self, open: Vec<RangeInclusive<usize>>, limits: &Limits, optimum: O) {
        let best = self.best.as_ref();
        if best.is_some_and(|best| best.least() <= optimum.least()) {
            return;
        }
        let Some((number, above)) = self.farthest(&open, &optimum) else {
            self.best = Some(optimum);
            return;
        };
        let (index, values) = &self.catalogues[number];
        let (index, x) = (*index, optimum.varied()[*index]);
        let [first, last] = [*open[number].start(), *open[number].end()];
        let mut sides = [first..=above - 1, above..=last];
        // The nearer side first: its optimum is likely to cut the other one off.
        if values[above] - x < x - values[above - 1] {
            sides.reverse();
        }
        for side in sides {
            if (self.ended)() {
                return;
            }
            let (mut limits, mut open) = (limits.clone(), open.clone());
            (limits.lower[index], limits.upper[index]) =
                (values[*side.start()], values[*side.end()]);
            open[number] = side;
            if let Some(next) = (self.descend)(&limits, &optimum) {
                self.branch(open, &limits, next);
            }
        }
    }

    /// The parameter that is farthest from a value of its list, as a part of the gap between two,
    /// and the number of the value above it; `None` if all are at one.
    fn farthest(&self, open: &[RangeInclusive<usize>], optimum: &O) -> Option<(usize, usize)> {
        let between = |(number, (index, values)): (usize, &(usize, Vec<f64>))| {
            let x = optimum.varied()[*index];
            let above = values.partition_point(|value| *value < x);
            let inside = *open[number].start() < above && above <= *open[number].end();
            (inside && values[above] != x).then(|| {
                let gap = values[above] - values[above - 1];
                let far = (values[above] - x).min(x - values[above - 1]) / gap;
                (far, (number, above))
            })
        };
        let all = self.catalogues.iter().enumerate().filter_map(between);
        let farthest = all.max_by(|a, b| a.0.total_cmp(&b.0));
        farthest.map(|(_, found)| found)
    }
}
