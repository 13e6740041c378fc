//! Four-bars are returned if they close at all pairs, whatever equations they are from.

use super::super::verify;
use super::{FunctionFourBar, Functions, Pair};

impl Functions {
    /// Those that close at all pairs with the lengths and starts that are returned.
    pub(super) fn verified(mut self, pairs: &[Pair]) -> Self {
        let count = self.four_bars.len();
        self.four_bars.retain(|four_bar| four_bar.closes(pairs));
        let left_out = count - self.four_bars.len();
        self.undecided += left_out;
        self.certified &= left_out == 0;
        self
    }
}

impl FunctionFourBar {
    /// Returns whether the coupler has its length at all pairs.
    fn closes(&self, pairs: &[Pair]) -> bool {
        let lengths = [1.0, self.crank, self.coupler, self.rocker];
        let mut errors = pairs.iter().map(|pair| self.pose(pair).1);
        errors.all(|error| verify::is_nothing(error, &lengths))
    }
}
