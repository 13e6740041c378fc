//! A point at the end of a link by the other side of the loop that the link closes: along the guide
//! that carries a slider there.

use linkage_symbolic::{Ex, Graph, NodeId, V2, Vector};

use crate::algebra::equations::{AngleSum, ViaSlider};
use crate::algebra::names::Names;
use crate::algebra::rotating_frame;
use crate::algebra::solutions::Solutions;
use crate::algebra::turning_parts::terms_of_sum;

/// A vector with every link that leads to a slider on a turning guide replaced by the way along the
/// guide.
pub(crate) fn via_sliders<'m>(
    names: &Names<'m>,
    solutions: &mut Solutions<'m>,
    vector: V2<'m>,
) -> V2<'m> {
    let sides = solutions.via_sliders.clone().into_iter().rev();
    sides.fold(vector, |vector, side| {
        via_slider(names, solutions, &side, vector).unwrap_or(vector)
    })
}

fn via_slider<'m>(
    names: &Names<'m>,
    solutions: &mut Solutions<'m>,
    side: &ViaSlider<'m>,
    vector: V2<'m>,
) -> Option<V2<'m>> {
    let [cos, sin] = names.angles[side.angle].unit.ids();
    let link = AngleSum {
        angles: vec![(cos, sin)],
        backward: usize::from(side.sense < 0.0),
    };
    let (z, rest) = rotating_frame::split(names, vector, &link)?;
    let sign = if z == side.z {
        1.0
    } else if z == -side.z {
        -1.0
    } else {
        return None;
    };
    let sign = names.graph.number(sign);
    let rest = Vector([0, 1].map(|k| difference(names.graph, rest[k], sign * side.known[k])));
    let zero = Vector([names.zero(); 2]);
    let (arm, rest) = rotating_frame::split(names, rest, &side.carried).unwrap_or((zero, rest));
    let arm = arm.turned(side.link_frame.start.conjugate());
    let vector = Vector([arm[0] - sign * side.slide, arm[1]]);
    Some(rotating_frame::from_frame(
        names.graph,
        solutions,
        side.link_frame,
        vector,
        rest,
    ))
}

/// The difference of two sums without the terms that both have.
fn difference<'m>(graph: &'m Graph, a: Ex<'m>, b: Ex<'m>) -> Ex<'m> {
    let mut terms: Vec<(NodeId, Ex)> = Vec::new();
    for (sum, sign) in [(a, 1.0), (b, -1.0)] {
        for (known, term) in terms_of_sum(sum) {
            let known = graph.number(sign) * known;
            match terms
                .iter_mut()
                .find(|(known_term, _)| *known_term == term.id())
            {
                Some((_, factor)) => *factor += known,
                None => terms.push((term.id(), known)),
            }
        }
    }
    let terms = terms.into_iter();
    let (early, late): (Vec<Ex>, Vec<Ex>) = terms
        .map(|(term, factor)| factor * graph.ex(term))
        .partition(|term| term.is_fixed());
    let all = early.into_iter().chain(late);
    all.fold(graph.number(0.0), |sum, term| sum + term)
}
