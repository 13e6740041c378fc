//! Scalar loops that need no root: linear equations and angle relations.

use linkage_symbolic::program::Binary;
use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{Rule, Scalar, Solution, Term};

use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `a x + b = 0`
    pub(super) fn linear(&mut self, symbol: SymbolId, a: NodeId, b: NodeId) -> Closed {
        let graph = &mut self.algebra.graph;
        let quotient = graph.div(b, a);
        let value = graph.neg(quotient);
        self.define_length(symbol, value, 0);
        let x = self.algebra.graph.symbol_node(symbol);
        let terms = vec![
            Term {
                coefficient: vec![a],
                factor: x,
            },
            self.known_term(&[b]),
        ];
        self.push_solution(Solution {
            terms,
            jacobian: vec![vec![a]],
            determinant: a,
            elimination: None,
        });

        // The factor's largest value is not known; a direction's component reaches 1.
        let one = self.algebra.graph.one();
        let size = self.abs(a);
        let (margin, slack, slack_scale) = if self.algebra.is_fixed(a) {
            (one, one, one)
        } else {
            (self.algebra.graph.binary(Binary::Min, size, one), a, size)
        };
        Closed {
            kind: "linear".into(),
            class: 0,
            order: 0,
            method: "linear equation",
            two_modes: false,
            margin,
            slack,
            slack_scale,
            gap: self.linear_gap(a),
            gap_in: GapIn::Loop,
        }
    }

    /// An angle given by others.
    pub(super) fn relation(&mut self, angle: usize, value: &Scalar) -> Closed {
        let [cos, sin] = self.algebra.direction(value);
        let node = self.algebra.node(value);
        let symbols = self.algebra.angles[angle].clone();
        for (symbol, value) in [
            (symbols.cos, cos),
            (symbols.sin, sin),
            (symbols.value, node),
        ] {
            self.algebra.graph.define(symbol, value);
            self.algebra.rules.insert(symbol, Rule::Follow(value));
            self.defined.push(symbol);
        }
        let zero = self.algebra.graph.zero();
        let one = self.algebra.graph.one();
        let solution = Solution {
            terms: Vec::new(),
            jacobian: vec![vec![one]],
            determinant: one,
            elimination: None,
        };
        self.push_solution(solution);
        Closed {
            kind: "angle relation".into(),
            class: 0,
            order: 0,
            method: "sum of angles",
            two_modes: false,
            margin: one,
            slack: one,
            slack_scale: one,
            gap: zero,
            gap_in: GapIn::Loop,
        }
    }
}
