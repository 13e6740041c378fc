//! The motions of the tree's joints that nothing drives: in each, no work may be done.
//!
//! A joint is driven if its motion depends on inputs alone: the drive holds it, with a couple (or a force along the guide) that is no
//! unknown here. Gears tie the turns of several joints; a tie is one motion of them all.

use linkage_symbolic::{NodeId, SymbolId};

use crate::model::JointKind;

use super::Mechanics;
use super::geometry::{Turning, slides_along, turns_about};

/// A way in which a body moves in its own joint.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Way {
    pub(super) body: usize,
    /// Along a guide; else a turn.
    pub(super) slides: bool,
    /// Unit vector; in the plane a turn has the component 1.
    pub(super) direction: Vec<NodeId>,
}

/// One motion: ways with factors.
pub(super) type FreeMotion = Vec<(f64, Way)>;

/// Constants that differ by less are equal: they are ratios of gears.
const RATIO: f64 = 1e-9;

impl Mechanics<'_, '_> {
    /// The motions that nothing drives, and those that are driven. `held` is how many of them reactions of cut joints can hold in the plane. What is beyond
    /// is tied by gears.
    pub(super) fn motions(&mut self, held: usize) -> (Vec<FreeMotion>, Vec<Way>) {
        let unknowns = self.unknown_variables();
        let mut driven = Vec::new();
        let mut free: Vec<(Way, Option<Vec<f64>>)> = Vec::new();
        for body in self.forces.tree.order.clone() {
            for way in self.ways(body) {
                let rates: Vec<NodeId> = unknowns
                    .iter()
                    .map(|&unknown| self.relative_rate(&way, unknown))
                    .collect();
                if rates.iter().all(|&rate| self.algebra.vanishes(rate)) {
                    driven.push(way);
                    continue;
                }
                let constants = rates
                    .iter()
                    .map(|&rate| self.algebra.graph.constant_value(rate));
                let constants = constants.collect::<Option<Vec<f64>>>();
                free.push((way.clone(), constants.filter(|_| !way.slides)));
            }
        }
        let excess = match self.forces.geometry.dimensions {
            2 => free.len().saturating_sub(held),
            _ => 0,
        };
        (self.tied(free, excess), driven)
    }

    /// Joins turns that gears tie, `excess` of them.
    fn tied(&self, free: Vec<(Way, Option<Vec<f64>>)>, excess: usize) -> Vec<FreeMotion> {
        let mut motions: Vec<FreeMotion> = Vec::new();
        // The rates of each motion that may be tied to others.
        let mut basis: Vec<(usize, Vec<f64>)> = Vec::new();
        let mut ties = 0;
        for (way, rates) in free {
            let share = rates
                .as_ref()
                .filter(|_| ties < excess && !self.in_slide(way.body));
            let share = share.and_then(|rates| combination(&basis, rates));
            match share {
                Some(share) => {
                    ties += 1;
                    for (factor, (motion, _)) in share.into_iter().zip(&basis) {
                        if factor != 0.0 {
                            motions[*motion].push((factor, way.clone()));
                        }
                    }
                }
                None => {
                    if let Some(rates) = rates {
                        basis.push((motions.len(), rates));
                    }
                    motions.push(vec![(1.0, way)]);
                }
            }
        }
        motions
    }

    /// True if a cut slide joins a body: it turns as another because of the slide, not because of gears.
    fn in_slide(&self, body: usize) -> bool {
        let joints = &self.algebra.mechanism.joints;
        self.forces.tree.closing.iter().any(|&joint| {
            let joint = &joints[joint];
            let ends = joint.body == body || joint.on == Some(body);
            ends && joint.kind == JointKind::Slide
        })
    }

    fn ways(&mut self, body: usize) -> Vec<Way> {
        let joint = self.algebra.mechanism.bodies[body].joint;
        let kind = self.algebra.mechanism.joints[joint].kind;
        let direction = self.forces.geometry.directions[joint].clone();
        let way = |slides, direction| Way {
            body,
            slides,
            direction,
        };
        let (one, zero) = (self.algebra.graph.one(), self.algebra.graph.zero());
        let mut ways = Vec::new();
        if slides_along(kind) {
            ways.push(way(true, direction.clone().unwrap_or_default()));
        }
        if turns_about(kind) {
            ways.push(way(false, direction.unwrap_or_else(|| vec![one])));
        }
        if kind == JointKind::Ball {
            for axis in 0..3 {
                let unit = (0..3).map(|k| if k == axis { one } else { zero });
                ways.push(way(false, unit.collect()));
            }
        }
        ways
    }

    /// How fast a body moves in its own joint by an input.
    pub(super) fn driven_rate(&mut self, way: &Way, input: usize) -> NodeId {
        let on = self.forces.tree.parent[way.body];
        let [own, other] = [Some(way.body), on].map(|body| match way.slides {
            true => {
                let origin = self.forces.geometry.origins[way.body].clone();
                self.velocity_of(body, &origin, input)
            }
            false => self.turn(body, input),
        });
        let relative = self.algebra.difference(&own, &other);
        self.algebra.dot(&way.direction, &relative)
    }

    /// The same if one unknown of the loops changes and the others do not.
    fn relative_rate(&mut self, way: &Way, unknown: SymbolId) -> NodeId {
        let on = self.forces.tree.parent[way.body];
        let relative = if way.slides {
            let origin = self.forces.geometry.origins[way.body].clone();
            let moved = self.partials(&origin, unknown);
            let carried = match on {
                None => self.algebra.zeros(origin.len()),
                Some(parent) => {
                    let of_parent = self.forces.geometry.origins[parent].clone();
                    let base = self.partials(&of_parent, unknown);
                    let arm = self.algebra.difference(&origin, &of_parent);
                    let turn = self.partial_turn(on, unknown);
                    let swept = self.algebra.swept(&turn, &arm);
                    self.algebra.plus(&base, &swept)
                }
            };
            self.algebra.difference(&moved, &carried)
        } else {
            let own = self.partial_turn(Some(way.body), unknown);
            let other = self.partial_turn(on, unknown);
            self.algebra.difference(&own, &other)
        };
        self.algebra.dot(&way.direction, &relative)
    }

    fn partials(&mut self, v: &[NodeId], unknown: SymbolId) -> Vec<NodeId> {
        v.iter()
            .map(|&x| self.algebra.partial(x, unknown))
            .collect()
    }

    fn partial_turn(&mut self, body: Option<usize>, unknown: SymbolId) -> Vec<NodeId> {
        let Some(number) = body else {
            let count = self.forces.geometry.turns();
            return self.algebra.zeros(count);
        };
        self.turn_by(
            number,
            &mut |mechanics, node| mechanics.algebra.partial(node, unknown),
            &mut |mechanics, on| mechanics.partial_turn(on, unknown),
        )
    }

    fn unknown_variables(&mut self) -> Vec<SymbolId> {
        let counts: Vec<usize> = self
            .algebra
            .solutions
            .iter()
            .map(|own| own.jacobian.len())
            .collect();
        let mut all = Vec::new();
        for (group, count) in counts.into_iter().enumerate() {
            for position in 0..count {
                all.push(self.algebra.unknown_variable(group, position));
            }
        }
        all
    }

    /// True for a rod that may turn about itself between two ball joints.
    pub(super) fn is_rod(&self, body: usize) -> bool {
        matches!(self.forces.geometry.turning[body], Turning::Rod(_))
    }
}

/// Factors that make a list of numbers from others; `None` if there are none.
fn combination(basis: &[(usize, Vec<f64>)], numbers: &[f64]) -> Option<Vec<f64>> {
    // Gauss elimination on [basis | numbers], one row for each number.
    let count = basis.len();
    let mut rows: Vec<Vec<f64>> = (0..numbers.len())
        .map(|k| {
            let row = basis.iter().map(|(_, own)| own[k]);
            row.chain([numbers[k]]).collect()
        })
        .collect();
    let mut pivots = Vec::new();
    for column in 0..count {
        let start = pivots.len();
        let largest = (start..rows.len())
            .max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))?;
        if rows[largest][column].abs() < RATIO {
            return None;
        }
        rows.swap(start, largest);
        let pivot = rows[start].clone();
        for (index, row) in rows.iter_mut().enumerate() {
            if index != start {
                let factor = row[column] / pivot[column];
                row.iter_mut()
                    .zip(&pivot)
                    .for_each(|(x, p)| *x -= factor * p);
            }
        }
        pivots.push(start);
    }
    let rest = rows[pivots.len()..].iter();
    if rest.map(|row| row[count].abs()).any(|x| x > RATIO) {
        return None;
    }
    let share = (0..count).map(|k| rows[k][count] / rows[k][k]);
    Some(
        share
            .map(|x| if x.abs() < RATIO { 0.0 } else { x })
            .collect(),
    )
}
