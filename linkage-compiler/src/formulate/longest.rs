//! How long a vector of the plane can become when all that turns in it turns: what a margin is measured by.

use linkage_symbolic::{Ex, V2};

use super::Solver;

/// How long a vector can become.
struct Longest<'m> {
    length: Ex<'m>,
    /// Whether its parts can all point the same way: each turns, and keeps its length.
    reached: bool,
}

impl<'m> Solver<'_, 'm> {
    /// The margin of a group whose determinant is `h = sqrt(vector.vector - level^2)`: over the largest value that it has for these lengths. Where
    /// nothing moves, and where it is not known how far (in space), over the vector's length.
    ///
    /// `h` is scaled, the others are not.
    pub(super) fn root_margin(
        &self,
        h: Ex<'m>,
        vector: V2<'m>,
        level: Ex<'m>,
        scale: Ex<'m>,
    ) -> Ex<'m> {
        let longest = self.longest(vector);
        if vector.is_fixed() || !longest.reached {
            return h / (scale * vector).length();
        }
        let longest = scale * longest.length;
        let largest = match level.is_fixed() {
            true => longest.difference_of_squares(scale * level).sqrt(),
            false => longest,
        };
        // Where all is in line both are equal but for rounding.
        (h / largest).min(h.number(1.0))
    }

    /// The sum of the lengths of a vector's parts.
    fn longest(&self, vector: V2<'m>) -> Longest<'m> {
        let parts = self.algebra.parts(vector);
        let rotors = parts.turning.iter().all(|(_, part)| part.is_rotor());
        let arms = parts.turning.iter().map(|(_, part)| part.arm().length());
        Longest {
            length: arms.fold(parts.fixed.length(), |sum, length| sum + length),
            reached: parts.rest_is_fixed && rotors,
        }
    }
}
