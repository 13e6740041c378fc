//! Plane vectors of nodes, as complex numbers, for the closed forms.

use linkage_symbolic::NodeId;
use linkage_symbolic::program::{Binary, Ternary, Unary};

use crate::algebra::{Solution, Term};

use super::Solver;

pub(super) type Vector = [NodeId; 2];

impl Solver<'_, '_> {
    pub(super) fn negative(&mut self, v: Vector) -> Vector {
        v.map(|x| self.algebra.graph.neg(x))
    }

    /// Turned by +90 degrees.
    pub(super) fn perp(&mut self, v: Vector) -> Vector {
        [self.algebra.graph.neg(v[1]), v[0]]
    }

    pub(super) fn square(&mut self, v: Vector) -> NodeId {
        self.algebra.dot(&v, &v)
    }

    /// `a u + b v`
    pub(super) fn combine<const N: usize>(
        &mut self,
        a: NodeId,
        u: [NodeId; N],
        b: NodeId,
        v: [NodeId; N],
    ) -> [NodeId; N] {
        std::array::from_fn(|k| {
            let first = self.algebra.graph.mul(a, u[k]);
            let second = self.algebra.graph.mul(b, v[k]);
            self.algebra.graph.add(first, second)
        })
    }

    /// `v / z` of complex numbers.
    pub(super) fn complex_quotient(&mut self, v: Vector, z: Vector) -> Vector {
        let graph = &mut self.algebra.graph;
        if graph.is_zero(z[1]) {
            return v.map(|x| graph.div(x, z[0]));
        }
        let square = self.square(z);
        let factor = z.map(|x| self.algebra.graph.div(x, square));
        let conjugate = [factor[0], self.algebra.graph.neg(factor[1])];
        self.algebra.complex_product(v, conjugate)
    }

    pub(super) fn half(&mut self, x: NodeId) -> NodeId {
        let half = self.algebra.graph.constant(0.5);
        self.algebra.graph.mul(half, x)
    }

    /// `(a - b)(a + b)`
    pub(super) fn difference_of_squares(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let graph = &mut self.algebra.graph;
        let difference = graph.sub(a, b);
        let sum = graph.add(a, b);
        graph.mul(difference, sum)
    }

    pub(super) fn abs(&mut self, x: NodeId) -> NodeId {
        self.algebra.graph.unary(Unary::Abs, x)
    }

    pub(super) fn root(&mut self, q: NodeId, scale: NodeId) -> NodeId {
        self.algebra.graph.binary(Binary::Root, q, scale)
    }

    /// A value that is NaN where the root `h` is, also where `h` drops out of its formula: a guide along an axis leaves
    /// the other component of a link free of the root, but not of the assembly. Whether `h` stays is known only
    /// when definitions are gone (a direction may turn out to be constant): the inliner removes a guard without use.
    pub(super) fn guarded(&mut self, value: NodeId, h: NodeId) -> NodeId {
        self.algebra.graph.ternary(Ternary::Select, h, value, h)
    }

    /// 0 where the root of `q` is a number (see [`Binary::Root`]), else `miss`, which is then made positive.
    pub(super) fn gap(&mut self, q: NodeId, scale: NodeId, miss: NodeId) -> NodeId {
        let scale = self.abs(scale);
        let graph = &mut self.algebra.graph;
        let rounding = graph.constant(8.0 * f64::EPSILON);
        let noise = graph.mul(rounding, scale);
        let closes = graph.add(q, noise);
        let tiny = graph.constant(f64::MIN_POSITIVE);
        let miss = graph.binary(Binary::Max, miss, tiny);
        let zero = graph.zero();
        graph.ternary(Ternary::Select, closes, zero, miss)
    }

    /// 0 where `determinant` is not 0, else NaN: a linear group has nothing to measure a gap by.
    pub(super) fn linear_gap(&mut self, determinant: NodeId) -> NodeId {
        let zero = self.algebra.graph.zero();
        self.defined_gap(zero, determinant)
    }

    /// A gap that is NaN where `size` is 0: parallel guides, or pivots that coincide, which any angle would suit.
    pub(super) fn defined_gap(&mut self, gap: NodeId, size: NodeId) -> NodeId {
        let size = self.abs(size);
        let graph = &mut self.algebra.graph;
        let tiny = graph.constant(f64::MIN_POSITIVE);
        let regular = graph.sub(size, tiny);
        let nan = graph.constant(f64::NAN);
        graph.ternary(Ternary::Select, regular, gap, nan)
    }

    /// The terms `z (c, s')` of a rotating vector.
    pub(super) fn rotor_terms(&mut self, z: Vector, factors: Vector) -> Vec<Term> {
        let across = self.perp(z);
        vec![
            Term {
                coefficient: z.to_vec(),
                factor: factors[0],
            },
            Term {
                coefficient: across.to_vec(),
                factor: factors[1],
            },
        ]
    }

    pub(super) fn known_term(&mut self, known: &[NodeId]) -> Term {
        Term {
            coefficient: known.to_vec(),
            factor: self.algebra.graph.one(),
        }
    }

    /// Records a group of two equations. The determinant's closed value is `determinant`.
    pub(super) fn push_pair(
        &mut self,
        terms: Vec<Term>,
        columns: [Vector; 2],
        determinant: NodeId,
    ) {
        let product = self.algebra.cross(columns[0], columns[1]);
        let determinant = self.alias("det", determinant, product);
        let jacobian = columns.iter().map(|column| column.to_vec()).collect();
        self.push_solution(Solution {
            terms,
            jacobian,
            determinant,
            elimination: None,
        });
    }
}
