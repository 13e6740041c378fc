//! RSSP: a link with ball joints between a known point and a slider on a line in space.

use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{Solution, Term};

use super::space::Space;
use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `|K + s G| = l`: the point is at distance `X = |g x K|` from the line, the link reaches `h = sqrt((l - X)(l + X))` along it. The
    /// link's vector is `K - (g.K) g + w h g`, never `K + s G`.
    pub(super) fn link_to_slide(
        &mut self,
        slide: SymbolId,
        guide: Space,
        known: Space,
        l: NodeId,
    ) -> Closed {
        let w = self.mode_sign();
        let (stretch, g) = self.algebra.length_and_unit(guide);
        let along = self.projection(g, known);
        let moment = self.algebra.cross3(g, known);
        let x = self.algebra.length(&moment);
        let q = self.difference_of_squares(l, x);
        let reach = self.abs(along);
        let graph = &mut self.algebra.graph;
        let far = graph.mul(l, reach);
        let near = graph.square(l);
        let noise = graph.add(far, near);
        let h = self.root(q, noise);
        let hw = self.algebra.graph.mul(w, h);
        let graph = &mut self.algebra.graph;
        let position = graph.sub(hw, along);
        let position = graph.div(position, stretch);
        self.define_length(slide, position, 0);

        // (g x K) x g is K without its part along the line.
        let across = self.algebra.cross3(moment, g);
        let s = self.algebra.graph.symbol_node(slide);
        let link = [0, 1, 2].map(|k| {
            let graph = &mut self.algebra.graph;
            let forth = graph.mul(hw, g[k]);
            let value = graph.add(across[k], forth);
            let value = self.guarded(value, h);
            let graph = &mut self.algebra.graph;
            let moved = graph.mul(guide[k], s);
            let equal = graph.add(known[k], moved);
            self.alias("rod", value, equal)
        });
        let slope = self.algebra.dot(&link, &guide);
        let determinant = self.algebra.graph.mul(stretch, hw);
        let determinant = self.alias("det", determinant, slope);
        let mut terms = self.distance_terms(link, known, l);
        terms.extend((0..3).map(|k| Term {
            coefficient: vec![guide[k]],
            factor: self.algebra.graph.mul(link[k], s),
        }));
        self.push_solution(Solution {
            terms,
            jacobian: vec![vec![determinant]],
            determinant,
            elimination: None,
        });

        let miss = self.algebra.graph.sub(x, l);
        let gap = self.gap(q, noise, miss);
        let graph = &mut self.algebra.graph;
        let largest2 = graph.square(l);
        Closed {
            kind: "SSP".into(),
            class: 0,
            order: 0,
            method: "intersection of a sphere and a line, by the distance from the line",
            two_modes: true,
            margin: graph.div(h, l),
            slack: graph.div(q, largest2),
            slack_scale: graph.one(),
            gap,
            gap_in: GapIn::Link,
        }
    }
}
