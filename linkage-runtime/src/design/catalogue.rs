//! Parameters that take some values only: branch and bound from a local optimum.
//!
//! The bound of a branch is what a local optimum of it comes to, so a better one in a branch that is left may be missed where there
//! are several: the result is the best of what is near the optimum, not a proof.

use alloc::vec::Vec;

use super::limits::Limits;

/// What branches end at.
pub(crate) trait Local {
    /// The parameters that vary, first of all variables.
    fn place(&self) -> &[f64];

    /// What is made least.
    fn least(&self) -> f64;
}

/// Parameters, by their place among those that vary, with the values that they take, which ascend.
pub(crate) type Catalogues = [(usize, Vec<f64>)];

/// The best optimum near this one with all catalogue parameters at values of their lists; `None` if there is none.
///
/// `descend` gives the optimum within narrower limits, from that within wider ones.
pub(crate) fn rounded<O: Local>(
    catalogues: &Catalogues,
    limits: &Limits,
    optimum: O,
    mut descend: impl FnMut(&Limits, &O) -> Option<O>,
) -> Option<O> {
    let mut best = None;
    branch(catalogues, limits, optimum, &mut descend, &mut best);
    best
}

/// Sets the first of these parameters to the values below and above, then the others.
fn branch<O: Local>(
    open: &Catalogues,
    limits: &Limits,
    optimum: O,
    descend: &mut impl FnMut(&Limits, &O) -> Option<O>,
    best: &mut Option<O>,
) {
    if best
        .as_ref()
        .is_some_and(|best| best.least() <= optimum.least())
    {
        return;
    }
    let Some(((place, values), open)) = open.split_first() else {
        *best = Some(optimum);
        return;
    };
    let x = optimum.place()[*place];
    let above = values
        .partition_point(|value| *value < x)
        .min(values.len() - 1);
    let mut sides = Vec::from([above, above.saturating_sub(1)]);
    sides.dedup();
    // The nearer value first: its optimum is likely to cut the other one off.
    sides.sort_by(|a, b| (values[*a] - x).abs().total_cmp(&(values[*b] - x).abs()));
    for side in sides {
        let mut limits = limits.clone();
        (limits.lower[*place], limits.upper[*place]) = (values[side], values[side]);
        if let Some(next) = descend(&limits, &optimum) {
            branch(open, &limits, next, descend, best);
        }
    }
}
