//! Expressions that may have no finite value for finite symbols.

use super::ex::Ex;
use crate::graph::{Graph, Node, NodeId};
use crate::operation::Binary;

impl Ex<'_> {
    /// True if a division, a root or an arc function in it may give no finite number although all
    /// symbols have finite values. Definitions of symbols are not followed.
    pub fn is_partial(self) -> bool {
        let graph = self.graph();
        let below = graph.reachable(&[self.id()]);
        below.iter().any(|&id| may_fail(graph, id))
    }
}

fn may_fail(graph: &Graph, id: NodeId) -> bool {
    match graph.node(id) {
        Node::Constant(bits) => !f64::from_bits(bits).is_finite(),
        Node::Symbol(_) => false,
        // A root of squares.
        Node::Unary(op, _) => op.row().partial && graph.vector_of_length(id).is_none(),
        Node::Binary(Binary::Div, _, divisor) => !graph
            .constant_value(divisor)
            .is_some_and(|value| value != 0.0),
        Node::Binary(op, ..) => op.row().partial,
        Node::Ternary(op, ..) => op.row().partial,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::Source;
    use crate::operation::{Ternary, Unary};

    /// Evaluates every operation at a few finite numbers: an operation that is not partial has a
    /// finite value.
    #[test]
    fn operations_that_are_not_partial_have_finite_values() {
        let numbers = [-3.0, -1.0, -0.5, -0.0, 0.0, 0.5, 1.0, 3.0];
        let finite = |partial: bool, name: &str, value: f64| {
            assert!(partial || value.is_finite(), "{name}: {value}");
        };
        for &a in &numbers {
            for op in Unary::ALL {
                finite(op.row().partial, op.row().name, op.apply([a]));
            }
            for &b in &numbers {
                for op in Binary::ALL {
                    finite(op.row().partial, op.row().name, op.apply([a, b]));
                }
                for op in Ternary::ALL {
                    finite(op.row().partial, op.row().name, op.apply([a, b, 1.0]));
                }
            }
        }
    }

    #[test]
    fn what_may_fail_is_found_anywhere() {
        let graph = Graph::new();
        let [x, y] = [0, 1].map(|index| graph.ex(graph.source(Source::Parameter(index))));
        let length = crate::Vector([x, y]).length();
        for total in [x, x * y - 2.0 * x, x / x.number(2.0), length * x, x.abs()] {
            assert!(!total.is_partial(), "{total:?}");
        }
        let acos = x.unary(Unary::Acos);
        for partial in [x / y, (x - y).sqrt(), acos + y, y - 3.0 * (x * acos)] {
            assert!(partial.is_partial(), "{partial:?}");
        }
    }
}
