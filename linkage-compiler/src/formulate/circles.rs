//! Where two circles meet: the numbers behind RRR, and behind RSSR seen along the rocker's axis.

use linkage_symbolic::NodeId;
use linkage_symbolic::program::{Binary, Unary};

use super::Solver;
use super::vector::Vector;

/// Two circles as their radii enter: squares, scaled.
pub(super) struct Squares {
    /// What lengths are multiplied by, and half its square.
    pub(super) scale: NodeId,
    pub(super) half_scale2: NodeId,
    /// `(r1^2 - r2^2)/2`
    pub(super) imbalance: NodeId,
    /// Twice the smaller of both.
    pub(super) twice: NodeId,
    /// What rounding of the second one's is measured by, if it is not given as a length.
    pub(super) noise2: Option<NodeId>,
}

/// Two links between points at distance `C`.
pub(super) struct Circles {
    /// The links' vectors, whose sum is `C`.
    pub(super) vectors: [Vector; 2],
    /// Scaled, 0 at the dead point.
    pub(super) h: NodeId,
    /// `first x second`
    pub(super) product: NodeId,
    /// The square of `h`, and the size of what it was computed from.
    pub(super) q: NodeId,
    pub(super) noise: NodeId,
    /// Half the square of the distance, scaled.
    pub(super) m: NodeId,
}

impl Solver<'_, '_> {
    /// Squares of lengths, scaled by a power of two near `reach`, so that extreme units neither overflow nor underflow; and the
    /// scaled lengths.
    pub(super) fn squares(
        &mut self,
        [r1, r2]: [NodeId; 2],
        reach: NodeId,
    ) -> (Squares, [NodeId; 2]) {
        let graph = &mut self.algebra.graph;
        let scale = graph.unary(Unary::InverseScale, reach);
        let [r1s, r2s] = [graph.mul(scale, r1), graph.mul(scale, r2)];
        let smaller = graph.binary(Binary::Min, r1s, r2s);
        let scale2 = graph.square(scale);
        let half_scale2 = self.half(scale2);
        let imbalance = self.difference_of_squares(r1s, r2s);
        let imbalance = self.half(imbalance);
        let graph = &mut self.algebra.graph;
        let (smaller2, two) = (graph.square(smaller), graph.constant(2.0));
        let squares = Squares {
            scale,
            half_scale2,
            imbalance,
            twice: graph.mul(two, smaller2),
            noise2: None,
        };
        (squares, [r1s, r2s])
    }

    /// `v1 + v2 = C` with `|v1| = r1`, `|v2| = r2`.
    ///
    /// With `L2 = C.C` the links' vectors are `(n1 C + w h C_perp)/L2` and `(n2 C - w h C_perp)/L2`, where
    /// `n1,2 = (L2 +- (r1 - r2)(r1 + r2))/2`. The root `h = sqrt(r^2 L2 - n^2)` is taken for the smaller circle, which
    /// keeps it accurate in needle triangles; `|r1^2 - r2^2|` selects that one without a choice.
    pub(super) fn circles(&mut self, c: Vector, squares: &Squares) -> Circles {
        let w = self.mode_sign();
        let &Squares {
            scale,
            half_scale2,
            imbalance,
            twice,
            noise2,
        } = squares;
        let size = self.abs(imbalance);

        let distance2 = self.square(c);
        let graph = &mut self.algebra.graph;
        let m = graph.mul(half_scale2, distance2);
        let n1 = graph.add(m, imbalance);
        let n2 = graph.sub(m, imbalance);
        let n = graph.sub(m, size);
        let t = graph.mul(twice, m);
        let n_squared = graph.square(n);
        let q = graph.sub(t, n_squared);
        let noise = graph.add(m, size);
        let mut noise = graph.mul(noise, n);
        if let Some(noise2) = noise2 {
            // The derivative of `h^2` by the second circle's square is `n1`.
            let own = graph.mul(noise2, n1);
            let sizes = [noise, own].map(|x| graph.abs(x));
            noise = graph.add(sizes[0], sizes[1]);
        }
        let h = self.root(q, noise);

        let graph = &mut self.algebra.graph;
        let half = graph.constant(0.5);
        let inverse = graph.div(half, m);
        let [a1, a2, signed] = [n1, n2, w].map(|x| graph.mul(x, inverse));
        // The root comes last: what does not need it is ready by then.
        let b = graph.mul(signed, h);
        let minus_b = graph.neg(b);
        let across = self.perp(c);
        let vectors = [
            self.combine(a1, c, b, across),
            self.combine(a2, c, minus_b, across),
        ];

        let graph = &mut self.algebra.graph;
        let signed = graph.neg(w);
        let scale2 = graph.square(scale);
        let unscaled = graph.div(signed, scale2);
        let product = graph.mul(unscaled, h);
        Circles {
            vectors,
            h,
            product,
            q,
            noise,
            m,
        }
    }
}
