//! A vector of the plane as a sum of parts that turn.

use std::collections::BTreeMap;

use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Ex, Node, V2, Vector, numerically_equal};

use crate::algebra::equations::AnglePair;
use crate::algebra::names::Names;

/// A vector as a sum.
#[derive(Clone, Debug)]
pub(crate) struct Parts<'m> {
    /// The part without a cosine or sine as a factor.
    pub(crate) fixed: V2<'m>,
    /// True if that part is known before a call.
    pub(crate) rest_is_fixed: bool,
    /// The parts that turn, by their angles.
    pub(crate) turning: Vec<(Vec<AnglePair>, TurningPart<'m>)>,
}

/// The coefficients of the products of cosines and sines of some angles: the first bit of an index
/// is set for the sine of the first angle.
#[derive(Clone, Debug)]
pub(crate) struct TurningPart<'m> {
    pub(crate) rows: [Vec<Ex<'m>>; 2],
}

/// The parts of a vector, by the angles that they turn with.
pub(crate) fn parts<'m>(names: &Names<'m>, vector: V2<'m>) -> Parts<'m> {
    let zero = names.zero();
    let mut fixed = Vector([zero; 2]);
    let mut rest_is_fixed = true;
    let mut turning: BTreeMap<Vec<AnglePair>, TurningPart<'m>> = BTreeMap::new();
    for (row, x) in vector.components().enumerate() {
        for (known, term) in terms_of_sum(x) {
            let (angles, sines, factor) = factors(names, term);
            let signed = known * factor;
            if angles.is_empty() {
                rest_is_fixed &= signed.is_fixed();
                fixed.0[row] += signed;
                continue;
            }
            let count = 1 << angles.len();
            let part = turning.entry(angles).or_insert_with(|| TurningPart {
                rows: [vec![zero; count], vec![zero; count]],
            });
            part.rows[row][sines] += signed;
        }
    }
    Parts {
        fixed,
        rest_is_fixed,
        turning: turning.into_iter().collect(),
    }
}

/// A product's angles, in order, which of them it has the sines of, and its other factors. A power
/// of a cosine is no direction: it stays among the factors.
pub(crate) fn factors<'m>(names: &Names<'m>, term: Ex<'m>) -> (Vec<AnglePair>, usize, Ex<'m>) {
    let mut angles: Vec<(AnglePair, bool)> = Vec::new();
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
            _ => match angle_pair_of(names, x) {
                Some((angle, sine)) if angles.iter().all(|(found, _)| *found != angle) => {
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
fn angle_pair_of<'m>(names: &Names<'m>, x: Ex<'m>) -> Option<(AnglePair, bool)> {
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
            let mut angles = names.angles.iter();
            let angle = angles.find(|angle| angle.cos == symbol || angle.sin == symbol)?;
            let [cos, sin] = angle.unit.0.map(Ex::id);
            Some(((cos, sin), angle.sin == symbol))
        }
        _ => None,
    }
}

/// The terms of a sum with factors that are known before a call, which may stand before a sum
/// themselves.
pub(crate) fn terms_of_sum(x: Ex) -> Vec<(Ex, Ex)> {
    let ex = |id| x.graph().ex(id);
    let mut found = Vec::new();
    let mut open = vec![(x.number(1.0), x)];
    while let Some((known, x)) = open.pop() {
        match x.node() {
            Node::Unary(Unary::Neg, a) => open.push((-known, ex(a))),
            Node::Binary(Binary::Add, a, b) => open.extend([(known, ex(b)), (known, ex(a))]),
            Node::Binary(Binary::Sub, a, b) => open.extend([(-known, ex(b)), (known, ex(a))]),
            Node::Binary(Binary::Mul, a, b) if ex(a).is_fixed() => {
                open.push((known * ex(a), ex(b)))
            }
            Node::Binary(Binary::Mul, a, b) if ex(b).is_fixed() => {
                open.push((known * ex(b), ex(a)))
            }
            Node::Binary(Binary::Div, a, b) if ex(b).is_fixed() => {
                open.push((known / ex(b), ex(a)))
            }
            _ => found.push((known, x)),
        }
    }
    found
}

impl<'m> TurningPart<'m> {
    /// Returns its vector where all angles are 0.
    pub(crate) fn arm(&self) -> V2<'m> {
        Vector([self.rows[0][0], self.rows[1][0]])
    }

    /// True if it is its arm, turned by the sum of its angles, some of them with the other sign.
    pub(crate) fn is_rotor(&self) -> bool {
        self.backward().is_some()
    }

    /// Returns a bit for each angle with the other sign, if it is its arm, turned by a sum of its
    /// angles.
    pub(crate) fn backward(&self) -> Option<usize> {
        let all = 0..self.rows[0].len();
        all.clone().find(|conjugate| {
            all.clone().all(|sines| {
                let turned = (0..sines.count_ones()).fold(self.arm(), |arm, _| arm.perp());
                let back = (sines & conjugate).count_ones() % 2 == 1;
                (0..2).all(|row| {
                    let expected = if back { -turned[row] } else { turned[row] };
                    numerically_equal(self.rows[row][sines], expected)
                })
            })
        })
    }
}
