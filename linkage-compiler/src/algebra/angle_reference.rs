//! Directions near which an angle stays as long as its group can be assembled. Turns are counted
//! from them.

use linkage_symbolic::program::{Binary, Source, Unary};
use linkage_symbolic::{Ex, Graph, Node, V2, Vector, numerically_equal};

use crate::algebra::equations::AnglePair;
use crate::algebra::names::{AngleReference, Names, Phasor};
use crate::algebra::turning_parts;
use crate::algebra::turning_parts::TurningPart;

impl<'m> AngleReference<'m> {
    /// Returns the vector as a sum of vectors of fixed lengths, each turning with a sum of angles.
    /// `None` if a length changes.
    pub(crate) fn phasors(&self, names: &Names<'m>) -> Option<Vec<Phasor<'m>>> {
        let vector = if self.across {
            self.vector.perp()
        } else {
            self.vector
        };
        let vector = match self.z {
            Some(z) => vector.turned(z.conjugate()),
            None => vector,
        };
        let vector = if self.sense < 0.0 {
            vector.conjugate()
        } else {
            vector
        };
        let sign = if self.opposite { -self.mode } else { self.mode };
        let mut phasors = phasors(names, vector)?;
        for phasor in &mut phasors {
            phasor.coefficient = sign * phasor.coefficient;
        }
        Some(phasors)
    }
}

/// A vector as a sum of vectors of fixed lengths, each turning with a sum of angles; `None` if a
/// length changes.
fn phasors<'m>(names: &Names<'m>, vector: V2<'m>) -> Option<Vec<Phasor<'m>>> {
    /// Products of more directions would be sums of too many.
    const MOST_ANGLES: usize = 3;

    let parts = turning_parts::parts(names, vector);
    let few = parts
        .turning
        .iter()
        .all(|(angles, _)| angles.len() <= MOST_ANGLES);
    if !(parts.rest_is_fixed && few) {
        return None;
    }
    let mut phasors = Vec::new();
    if !parts.fixed.is_zero() {
        phasors.push(Phasor {
            coefficient: parts.fixed,
            rates: Some(Vec::new()),
        });
    }
    for (angles, part) in &parts.turning {
        let rates: Vec<_> = angles
            .iter()
            .map(|&angle| rate_of(names.graph, angle))
            .collect();
        phasors.extend(part.phasors(&rates));
    }
    let fixed = phasors.iter().all(|phasor| phasor.coefficient.is_fixed());
    fixed.then_some(phasors)
}

/// The input that an angle is a multiple of, and the factor.
fn rate_of(graph: &Graph, (cosine, _): AnglePair) -> Option<(usize, f64)> {
    let Node::Unary(Unary::Cos, argument) = graph.ex(cosine).node() else {
        return None;
    };
    let (mut factor, mut argument) = (1.0, graph.ex(argument));
    loop {
        let ex = |id| graph.ex(id);
        match argument.node() {
            Node::Symbol(symbol) => {
                return match graph.symbol(symbol).source {
                    Some(Source::Input(input)) => Some((input, factor)),
                    _ => None,
                };
            }
            Node::Unary(Unary::Neg, x) => {
                factor = -factor;
                argument = ex(x);
            }
            Node::Binary(Binary::Mul, x, y) => {
                let [x, y] = [x, y].map(ex);
                let (known, other) = match x.constant_value() {
                    Some(known) => (known, y),
                    None => (y.constant_value()?, x),
                };
                factor *= known;
                argument = other;
            }
            _ => return None,
        }
    }
}

impl<'m> TurningPart<'m> {
    /// The vectors that it is the sum of, one for each choice of the angles' signs, with
    /// `cos a = (e^(i a) + e^(-i a))/2` and `sin a = (e^(i a) - e^(-i a))/(2 i)`. Those that
    /// vanish, as half of a rotor's do, are left out.
    fn phasors(&self, rates: &[Option<(usize, f64)>]) -> Vec<Phasor<'m>> {
        let zero = self.rows[0][0].number(0.0);
        let choices = 0..self.rows[0].len();
        let share = 1.0 / choices.len() as f64;
        let phasors = choices.clone().map(|backward| {
            let mut sum = Vector([zero; 2]);
            for sines in choices.clone() {
                let vector = Vector([self.rows[0][sines], self.rows[1][sines]]);
                // Each sine divides by i, and turns the other way round for an angle taken
                // backward.
                let turned = (0..sines.count_ones()).fold(vector, |vector, _| -vector.perp());
                let negative = (sines & backward).count_ones() % 2 == 1;
                sum = sum + if negative { -turned } else { turned };
            }
            let signed = rates.iter().enumerate().map(|(k, rate)| {
                let sign = if backward >> k & 1 == 1 { -1.0 } else { 1.0 };
                rate.map(|(input, rate)| (input, sign * rate))
            });
            Phasor {
                coefficient: zero.number(share) * sum,
                rates: signed.collect(),
            }
        });
        let vanishes = |x: Ex| numerically_equal(x, zero);
        phasors
            .filter(|phasor| !phasor.coefficient.components().all(vanishes))
            .collect()
    }
}
