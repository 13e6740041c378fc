//! How long a vector of the plane can become when all that turns in it turns: what a margin is measured by.

use std::collections::BTreeMap;

use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Ex, Node, NodeId, V2, Vector, agree};

use super::Solver;

/// An angle by the nodes of its cosine and sine.
type Turning = (NodeId, NodeId);

/// The coefficients of the products of cosines and sines of some angles: the first bit of an index is set for the sine of the first angle.
struct Part<'m> {
    rows: [Vec<Ex<'m>>; 2],
}

impl<'m> Solver<'_, 'm> {
    /// The sum of the lengths of a vector's parts. What is known only in a call and does not turn has the length that it has there.
    pub(super) fn longest(&self, vector: V2<'m>) -> Ex<'m> {
        let zero = self.algebra.zero();
        let mut fixed = Vector([zero; 2]);
        let mut moved = Vector([zero; 2]);
        let mut turning: BTreeMap<Vec<Turning>, Part<'m>> = BTreeMap::new();
        for (row, x) in vector.components().enumerate() {
            for (positive, term) in x.summands() {
                let (angles, sines, factor) = self.factors(term);
                let signed = if positive { factor } else { -factor };
                if angles.is_empty() {
                    let rest = match signed.is_fixed() {
                        true => &mut fixed,
                        false => &mut moved,
                    };
                    rest.0[row] += signed;
                    continue;
                }
                let count = 1 << angles.len();
                let part = turning.entry(angles).or_insert_with(|| Part {
                    rows: [vec![zero; count], vec![zero; count]],
                });
                part.rows[row][sines] += signed;
            }
        }
        let parts = turning.values().map(|part| part.longest(zero));
        parts.fold(fixed.length() + moved.length(), |sum, length| sum + length)
    }

    /// A product's angles, in order, which of them it has the sines of, and its other factors. A power of a cosine is no direction: it stays
    /// among the factors.
    fn factors(&self, term: Ex<'m>) -> (Vec<Turning>, usize, Ex<'m>) {
        let mut angles: Vec<(Turning, bool)> = Vec::new();
        let mut factor = term.number(1.0);
        let mut open = vec![term];
        while let Some(x) = open.pop() {
            let ex = |id| x.graph().ex(id);
            match x.node() {
                Node::Binary(Binary::Mul, a, b) => open.extend([ex(a), ex(b)]),
                Node::Unary(Unary::Neg, a) => {
                    factor = -factor;
                    open.push(ex(a));
                }
                _ => match self.direction_of(x) {
                    Some((angle, sine)) if angles.iter().all(|(own, _)| *own != angle) => {
                        angles.push((angle, sine));
                    }
                    _ => factor = factor * x,
                },
            }
        }
        angles.sort_unstable();
        let sines = angles.iter().enumerate();
        let sines = sines.map(|(k, (_, sine))| usize::from(*sine) << k).sum();
        let angles = angles.into_iter().map(|(angle, _)| angle).collect();
        (angles, sines, factor)
    }

    /// The angle whose cosine or, then true, sine this is, if it is known only in a call.
    fn direction_of(&self, x: Ex<'m>) -> Option<(Turning, bool)> {
        if x.is_fixed() {
            return None;
        }
        match x.node() {
            Node::Unary(Unary::Cos | Unary::Sin, argument) => {
                let argument = x.graph().ex(argument);
                let [cos, sin] = [Unary::Cos, Unary::Sin].map(|op| argument.unary(op).id());
                Some(((cos, sin), x.id() == sin))
            }
            Node::Symbol(symbol) => {
                let mut angles = self.algebra.names.angles.iter();
                let angle = angles.find(|own| own.cos == symbol || own.sin == symbol)?;
                let [cos, sin] = angle.unit.0.map(Ex::id);
                Some(((cos, sin), angle.sin == symbol))
            }
            _ => None,
        }
    }
}

impl<'m> Part<'m> {
    /// The length of a vector that turns with the sum or difference of its angles; of others, what no position exceeds.
    fn longest(&self, zero: Ex<'m>) -> Ex<'m> {
        let squares = self.rows.iter().flatten().map(|x| x.square());
        let sum = squares.fold(zero, |sum, x| sum + x);
        let count = self.rows[0].len();
        let senses = 0..count;
        match senses.into_iter().any(|senses| self.is_rotor(senses)) {
            true => Vector([self.rows[0][0], self.rows[1][0]]).length(),
            // The squares of the products of cosines and sines add up to 1.
            false => sum.sqrt(),
        }
    }

    /// Whether it is `z` times the unit vectors of its angles, those whose bits are set conjugate.
    fn is_rotor(&self, conjugate: usize) -> bool {
        let z = Vector([self.rows[0][0], self.rows[1][0]]);
        (0..self.rows[0].len()).all(|sines| {
            let turned = (0..sines.count_ones()).fold(z, |z, _| z.perp());
            let back = (sines & conjugate).count_ones() % 2 == 1;
            (0..2).all(|row| {
                let expected = if back { -turned[row] } else { turned[row] };
                agree(self.rows[row][sines], expected)
            })
        })
    }
}
