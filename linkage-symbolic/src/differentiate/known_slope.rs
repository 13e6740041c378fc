//! Slopes that are known beforehand: of a function of one number whose derivative has a shorter
//! formula, or one with fewer roundings, than the rules make of the function's own. A polynomial is
//! an example: rules differentiate each step of its scheme, which doubles it with every derivative.

use crate::expression::Ex;
use crate::graph::Node;

impl<'g> Ex<'g> {
    /// Remembers the slope of this by `argument`, through which alone it depends on anything that
    /// one differentiates by: [`differentiate`](crate::differentiate()) takes it instead of the
    /// rules.
    pub fn with_slope(self, argument: Self, slope: Self) -> Self {
        let is_operation = !matches!(self.node(), Node::Constant(_) | Node::Symbol(_));
        if is_operation && self != argument {
            let known = (argument.id(), slope.id());
            self.graph().store_mut().slopes.insert(self.id(), known);
        }
        self
    }
}
