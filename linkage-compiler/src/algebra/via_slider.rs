//! A point at the end of a link by the other side of the loop that the link closes: along the guide that carries a slider there.

use crate::algebra::rotating_frame;
use linkage_symbolic::{Ex, NodeId, V2, Vector};

use super::Algebra;
use super::parts::spread;
use super::rotating_frame::{Carrier, Turns};

/// A loop `z u + slide * guide + known = 0`, the guide on a link that turns.
#[derive(Clone, Debug)]
pub(crate) struct ViaSlider<'m> {
    /// The angle of `u`, and whether it turns against that.
    pub(crate) angle: usize,
    pub(crate) sense: f64,
    pub(crate) z: V2<'m>,
    /// The slide times the guide's length.
    pub(crate) slide: Ex<'m>,
    pub(crate) known: V2<'m>,
    pub(crate) carrier: Carrier<'m>,
    pub(crate) carried: Turns,
}

/// A vector with every link that leads to a slider on a turning guide replaced by the way along the guide.
pub(crate) fn by_other_sides<'m>(algebra: &mut Algebra<'m>, vector: V2<'m>) -> V2<'m> {
    let sides = algebra.solutions.other_sides.clone().into_iter().rev();
    sides.fold(vector, |vector, side| {
        by_other_side(algebra, &side, vector).unwrap_or(vector)
    })
}

fn by_other_side<'m>(
    algebra: &mut Algebra<'m>,
    side: &ViaSlider<'m>,
    vector: V2<'m>,
) -> Option<V2<'m>> {
    let [cos, sin] = algebra.names.angles[side.angle].unit.ids();
    let link = Turns {
        angles: vec![(cos, sin)],
        backward: usize::from(side.sense < 0.0),
    };
    let (z, rest) = rotating_frame::split(algebra, vector, &link)?;
    let sign = if z == side.z {
        1.0
    } else if z == -side.z {
        -1.0
    } else {
        return None;
    };
    let sign = algebra.graph.number(sign);
    let rest = Vector([0, 1].map(|k| difference(algebra, rest[k], sign * side.known[k])));
    let zero = Vector([algebra.zero(); 2]);
    let (arm, rest) = rotating_frame::split(algebra, rest, &side.carried).unwrap_or((zero, rest));
    let arm = arm.turned(side.carrier.start.conjugate());
    let vector = Vector([arm[0] - sign * side.slide, arm[1]]);
    Some(rotating_frame::shown(algebra, side.carrier, vector, rest))
}

/// The difference of two sums without the terms that both have.
fn difference<'m>(algebra: &Algebra<'m>, a: Ex<'m>, b: Ex<'m>) -> Ex<'m> {
    let mut terms: Vec<(NodeId, Ex)> = Vec::new();
    for (sum, sign) in [(a, 1.0), (b, -1.0)] {
        for (known, term) in spread(sum) {
            let known = algebra.graph.number(sign) * known;
            match terms.iter_mut().find(|(own, _)| *own == term.id()) {
                Some((_, factor)) => *factor += known,
                None => terms.push((term.id(), known)),
            }
        }
    }
    let terms = terms.into_iter();
    let (early, late): (Vec<Ex>, Vec<Ex>) = terms
        .map(|(term, factor)| factor * algebra.graph.ex(term))
        .partition(|term| term.is_fixed());
    let all = early.into_iter().chain(late);
    all.fold(algebra.zero(), |sum, term| sum + term)
}
