//! All solutions of a coupled group over a slab, strand by strand.

use super::curve::{Node, SolutionCurve};
use super::slab::Slab;
use super::trace::Strand;
use crate::error::AssemblyError;
use crate::support::{CoupledGroup, CoupledPrograms, list_solutions};
use alloc::vec::Vec;
use linkage_core::numeric::vector::dot;

/// Newton steps for all curves of a slab.
const CORRECTIONS: usize = 1_000_000;

/// A solution belongs to a strand if its determinant has the same sign and it is this near to the
/// straight line between two nodes, as a part of its length, and anyway: between two strands of one
/// sign there is one of the other.
const ASIDE: f64 = 0.1;
const SAME: f64 = 1e-6;

/// The curves of a coupled group over a slab.
pub(super) struct Followed {
    pub(super) strands: Vec<Strand>,
    /// The number of turning points; strands number them from 0.
    pub(super) turning: usize,
}

/// Follows all solutions that are listed at the parameters `samples`, to both sides and through
/// turning points.
///
/// # Errors
///
/// The first error of the listing if it fails everywhere; at once for a group that is followed from
/// its estimates.
pub(super) fn follow(
    group: &CoupledGroup,
    programs: &mut dyn CoupledPrograms,
    slab: Slab,
    samples: &[f64],
) -> Result<Followed, AssemblyError> {
    if group.is_followed() {
        return Err(group.not_listed());
    }
    let mut found = Followed {
        strands: Vec::new(),
        turning: 0,
    };
    let (mut error, mut listed) = (None, false);
    for &u in samples {
        let solutions = match list_solutions(group, programs, &[slab.x(u)]) {
            Ok(solutions) => solutions,
            Err(new) => {
                listed |= new.is_a_miss();
                error = error.or(Some(new));
                continue;
            }
        };
        listed = true;
        let mut curve = SolutionCurve {
            correction: programs,
            variables: group.variables,
            slab,
            left: CORRECTIONS,
        };
        for solution in solutions {
            let Some(node) = curve.node(u, &solution.state) else {
                continue;
            };
            if !found
                .strands
                .iter()
                .any(|strand| strand.passes(&mut curve, &node))
            {
                found
                    .strands
                    .extend(curve.strands(node, &mut found.turning));
            }
        }
    }
    match error {
        Some(error) if !listed => Err(error),
        _ => Ok(found),
    }
}

impl Strand {
    /// Returns true if a node is on the strand.
    fn passes(&self, curve: &mut SolutionCurve<'_>, node: &Node) -> bool {
        let last = self.nodes.len() - 1;
        if node.u < self.nodes[0].u || node.u > self.nodes[last].u {
            return false;
        }
        let above = self.nodes.partition_point(|other| other.u <= node.u);
        let above = above.clamp(1, last);
        let [below, above] = [&self.nodes[above - 1], &self.nodes[above]];
        let mut chord = curve.difference(&below.state, &above.state);
        chord.insert(0, above.u - below.u);
        let mut way = curve.difference(&below.state, &node.state);
        way.insert(0, node.u - below.u);
        let share = dot(&way, &chord) / dot(&chord, &chord);
        let aside: Vec<f64> = way
            .iter()
            .zip(&chord)
            .map(|(way, chord)| way - share * chord)
            .collect();
        let near = dot(&aside, &aside) <= ASIDE * ASIDE * dot(&chord, &chord) + SAME * SAME;
        near && node.determinant * self.best().determinant > 0.0
    }

    /// The inputs of both ends.
    pub(super) fn inputs(&self, slab: &Slab) -> [f64; 2] {
        let last = self.nodes.len() - 1;
        [0, last].map(|k| slab.x(self.nodes[k].u))
    }

    /// The node to prepare a table from: between the ends, as far from singular as possible. At the
    /// ends of a slab groups before may turn back; the slope of the inputs vanishes there as their
    /// determinants do, and a table from there would go nowhere.
    pub(super) fn best(&self) -> &Node {
        let between = match self.nodes.len() {
            0..3 => &self.nodes[..],
            more => &self.nodes[1..more - 1],
        };
        let regular = |node: &Node| Slab::slope(node.u) * node.determinant.abs();
        let by_size = |a: &&Node, b: &&Node| regular(a).total_cmp(&regular(b));
        between.iter().max_by(by_size).unwrap_or(&self.nodes[0])
    }

    /// The numbers of the state at an end that is no turning point.
    pub(super) fn state(&self, end: usize) -> &[f64] {
        &self.nodes[end * (self.nodes.len() - 1)].state
    }
}
