//! Values that are chosen by a place: one for each stretch between borders.

use linkage_symbolic::Ex;

/// Chooses by a place between values from border to border.
pub(crate) struct Choice<'c, 'm> {
    argument: Ex<'m>,
    borders: &'c [Ex<'m>],
}

impl<'c, 'm> Choice<'c, 'm> {
    /// Builds the choice of one value more than there are borders, which are in order.
    pub(crate) fn new(at: Ex<'m>, borders: &'c [Ex<'m>]) -> Self {
        Self {
            argument: at,
            borders,
        }
    }

    /// The value where the place is; at a border that behind it. Equal neighbours are one; the rest
    /// is a balanced tree, which has as many choices as a chain, and waits for few of them.
    pub(crate) fn among_pieces(&self, values: &[Ex<'m>]) -> Ex<'m> {
        let mut runs: Vec<(usize, Ex)> = Vec::new();
        for (index, &value) in values.iter().enumerate() {
            if runs.last().is_none_or(|(_, last)| *last != value) {
                runs.push((index, value));
            }
        }
        self.among(&runs)
    }

    fn among(&self, runs: &[(usize, Ex<'m>)]) -> Ex<'m> {
        if let [(_, value)] = runs {
            return *value;
        }
        let (before, behind) = runs.split_at(runs.len() / 2);
        let border = self.borders[behind[0].0 - 1];
        let [before, value] = [before, behind].map(|part| self.among(part));
        (self.argument - border).select(value, before)
    }
}

/// Returns the values of pieces. A piece without one has that of the last one before it, or else
/// the first one of all.
pub(crate) fn filled<'p, T>(pieces: &'p [Option<T>], first: &'p T) -> Vec<&'p T> {
    let mut last = first;
    let next = |piece: &'p Option<T>| {
        last = piece.as_ref().unwrap_or(last);
        last
    };
    pieces.iter().map(next).collect()
}
