//! The motions of the tree's joints that nothing drives: in each, no work may be done.
//!
//! A joint is driven if its motion depends on inputs alone: the drive holds it, with a couple (or a force along the guide) that is no
//! unknown here. Gears tie the turns of several bodies, by couples that are unknowns of their own.

use linkage_symbolic::{NodeId, SymbolId};

use crate::model::{JointKind, Variable};

use super::Mechanics;
use super::geometry::{slides_along, turns_about};

/// A way in which a body moves in its own joint.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Way {
    pub(super) body: usize,
    /// Along a guide; else a turn.
    pub(super) slides: bool,
    /// Unit vector; in the plane a turn has the component 1.
    pub(super) direction: Vec<NodeId>,
}

/// Turns that gears tie: their couples on bodies, in proportion, which the frame takes up.
#[derive(Clone, Debug)]
pub(super) struct Tie {
    pub(super) couples: Vec<(usize, f64)>,
}

/// All motions of the tree's joints.
#[derive(Clone, Debug, Default)]
pub(super) struct Motions {
    pub(super) free: Vec<Way>,
    pub(super) driven: Vec<Way>,
    pub(super) ties: Vec<Tie>,
}

/// Constants that differ by less are equal: they are ratios of gears.
const RATIO: f64 = 1e-9;

impl Mechanics<'_, '_> {
    /// All motions. `held` is how many of them reactions of cut joints can hold in the plane: what is beyond is tied by gears.
    pub(super) fn motions(&mut self, held: usize) -> Motions {
        let unknowns = self.unknown_variables();
        let mut motions = Motions::default();
        for body in self.forces.tree.order.clone() {
            for way in self.ways(body) {
                let is_held = unknowns.iter().all(|&unknown| {
                    let rate = self.relative_rate(&way, unknown);
                    self.algebra.vanishes(rate)
                });
                match is_held {
                    true => motions.driven.push(way),
                    false => motions.free.push(way),
                }
            }
        }
        if self.forces.geometry.dimensions == 2 && motions.free.len() > held {
            motions.ties = self.ties(&motions.free, motions.free.len() - held, &unknowns);
        }
        motions
    }

    /// Up to `count` turns that are determined by others, all of them against the frame. Bodies that turn as another because of their
    /// joints are no case for gears.
    fn ties(&mut self, free: &[Way], count: usize, unknowns: &[SymbolId]) -> Vec<Tie> {
        let alike = self.alike();
        let mut seen = vec![alike[self.forces.tree.parent.len()]];
        let mut basis: Vec<(usize, Vec<f64>)> = Vec::new();
        let mut ties = Vec::new();
        for way in free.iter().filter(|way| !way.slides) {
            if ties.len() == count || seen.contains(&alike[way.body]) {
                continue;
            }
            seen.push(alike[way.body]);
            let Some(rates) = self.constant_rates(way.body, unknowns) else {
                continue;
            };
            let Some(shares) = combination(&basis, &rates) else {
                basis.push((way.body, rates));
                continue;
            };
            let others = basis.iter().zip(shares).filter(|(_, share)| *share != 0.0);
            let others = others.map(|((body, _), share)| (*body, -share));
            ties.push(Tie {
                couples: std::iter::once((way.body, 1.0)).chain(others).collect(),
            });
        }
        ties
    }

    /// By body and, last, for the frame: a number that those share which slides and `fixed` joints let turn alike only.
    fn alike(&self) -> Vec<usize> {
        let frame = self.forces.tree.parent.len();
        let mut alike: Vec<usize> = (0..=frame).collect();
        for joint in &self.algebra.mechanism.joints {
            if matches!(joint.kind, JointKind::Slide | JointKind::Fixed) {
                let [own, other] = [joint.body, joint.on.unwrap_or(frame)].map(|k| alike[k]);
                for number in alike.iter_mut().filter(|number| **number == other) {
                    *number = own;
                }
            }
        }
        alike
    }

    /// How fast a body of the plane turns by each unknown, if these are constants.
    fn constant_rates(&mut self, body: usize, unknowns: &[SymbolId]) -> Option<Vec<f64>> {
        let mut rates = Vec::new();
        for &unknown in unknowns {
            let rate = self.partial_turn(Some(body), unknown)[0];
            rates.push(self.algebra.graph.constant_value(rate)?);
        }
        Some(rates)
    }

    /// How fast what is tied would come apart by an input if it were not for the unknowns.
    pub(super) fn tie_rate(&mut self, tie: &Tie, input: usize) -> NodeId {
        let variable = self.algebra.variable(Variable::Input(input));
        let zero = self.algebra.graph.zero();
        tie.couples.iter().fold(zero, |sum, &(body, share)| {
            let turn = self.partial_turn(Some(body), variable)[0];
            let share = self.algebra.graph.constant(share);
            let part = self.algebra.graph.mul(share, turn);
            self.algebra.graph.add(sum, part)
        })
    }

    pub(super) fn ways(&mut self, body: usize) -> Vec<Way> {
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

    pub(super) fn is_rod(&self, body: usize) -> bool {
        self.forces.geometry.rod(body).is_some()
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
