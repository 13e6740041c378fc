//! Which way an angle points, as long as its group can be assembled: what its turns are counted by.

use crate::algebra::parts;
use linkage_symbolic::program::{Binary, Source, Unary};
use linkage_symbolic::{Ex, Node, V2, Vector, numerically_equal};

use super::Algebra;
use super::parts::{Part, Turning};

/// A vector that an angle keeps within a quarter turn of, wherever its group can be assembled.
///
/// A closed form says that the vector `z u`, which the angle turns, is `a B + w h C` with a root `h`, where `B` and `C` are perpendicular: it never
/// gets from the side of `w C` to the other one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AngleReference<'m> {
    /// `C`, or where that is `across`, `C` turned by -90 degrees.
    pub(crate) vector: V2<'m>,
    pub(crate) across: bool,
    /// `w`, 1 or -1 by the assembly, and whether its opposite is meant.
    pub(crate) mode: Ex<'m>,
    pub(crate) opposite: bool,
    /// What `u` turns; its direction is that of `z u` where there is none.
    pub(crate) z: Option<V2<'m>>,
    /// -1 if `u` turns with the negative angle.
    pub(crate) sense: f64,
}

/// A vector `coefficient e^(i a)`, where `a` is a sum of angles.
#[derive(Clone, Debug)]
pub(crate) struct Phasor<'m> {
    pub(crate) coefficient: V2<'m>,
    /// By how much each input turns it; `None` where something else turns it, too.
    pub(crate) rates: Option<Vec<(usize, f64)>>,
}

impl<'m> AngleReference<'m> {
    /// As a sum of vectors of fixed lengths, each turning with a sum of angles; `None` if a length changes.
    pub(crate) fn phasors(&self, algebra: &Algebra<'m>) -> Option<Vec<Phasor<'m>>> {
        let vector = match self.across {
            true => self.vector.perp(),
            false => self.vector,
        };
        let vector = match self.z {
            Some(z) => vector.turned(z.conjugate()),
            None => vector,
        };
        let vector = match self.sense < 0.0 {
            true => vector.conjugate(),
            false => vector,
        };
        let sign = if self.opposite { -self.mode } else { self.mode };
        let mut phasors = phasors(algebra, vector)?;
        for own in &mut phasors {
            own.coefficient = sign * own.coefficient;
        }
        Some(phasors)
    }
}

/// A vector as a sum of vectors of fixed lengths, each turning with a sum of angles; `None` if a length changes.
fn phasors<'m>(algebra: &Algebra<'m>, vector: V2<'m>) -> Option<Vec<Phasor<'m>>> {
    /// Products of more directions would be sums of too many.
    const MOST_ANGLES: usize = 3;

    let parts = parts::parts(algebra, vector);
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
            .map(|&angle| rate_of(algebra, angle))
            .collect();
        phasors.extend(part.phasors(&rates));
    }
    let fixed = phasors.iter().all(|own| own.coefficient.is_fixed());
    fixed.then_some(phasors)
}

/// The input that an angle is a multiple of, and the factor.
fn rate_of(algebra: &Algebra<'_>, (cosine, _): Turning) -> Option<(usize, f64)> {
    let Node::Unary(Unary::Cos, argument) = algebra.graph.ex(cosine).node() else {
        return None;
    };
    let (mut factor, mut argument) = (1.0, algebra.graph.ex(argument));
    loop {
        let ex = |id| algebra.graph.ex(id);
        match argument.node() {
            Node::Symbol(symbol) => {
                return match algebra.graph.symbol(symbol).source {
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

impl<'m> Part<'m> {
    /// The vectors that it is the sum of: as `cos a = (e^(i a) + e^(-i a))/2` and `sin a = (e^(i a) - e^(-i a))/(2 i)`, one for each choice of
    /// the angles' signs. Those that vanish, as half of a rotor's do, are left out.
    fn phasors(&self, rates: &[Option<(usize, f64)>]) -> Vec<Phasor<'m>> {
        let zero = self.rows[0][0].number(0.0);
        let choices = 0..self.rows[0].len();
        let share = 1.0 / choices.len() as f64;
        let phasors = choices.clone().map(|backward| {
            let mut sum = Vector([zero; 2]);
            for sines in choices.clone() {
                let own = Vector([self.rows[0][sines], self.rows[1][sines]]);
                // Each sine divides by i, and turns the other way round for an angle taken backward.
                let turned = (0..sines.count_ones()).fold(own, |own, _| -own.perp());
                let negative = (sines & backward).count_ones() % 2 == 1;
                sum = sum + if negative { -turned } else { turned };
            }
            let own = rates.iter().enumerate().map(|(k, rate)| {
                let sign = if backward >> k & 1 == 1 { -1.0 } else { 1.0 };
                rate.map(|(input, rate)| (input, sign * rate))
            });
            Phasor {
                coefficient: zero.number(share) * sum,
                rates: own.collect(),
            }
        });
        let vanishes = |x: Ex| numerically_equal(x, zero);
        phasors
            .filter(|own| !own.coefficient.components().all(vanishes))
            .collect()
    }
}
