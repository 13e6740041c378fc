//! Unknown frames whose place is open, and the rods that hold them.

use crate::structure::equations;
use crate::structure::point;
use crate::structure::space;
use linkage_symbolic::{Ex, SymbolId, V3, Vector, collect, numerically_equal};

use crate::algebra::Bound;

use super::Analysis;
use super::circle::Held;
use super::equations::{Coordinate, CoordinateKind, Equation};

/// An unknown frame: its origin and two axes `p` and `q`; the third one is `p x q`.
pub(super) struct Body<'m> {
    /// The coordinates of its origin, those that are not known, and of its axes.
    pub(super) open: Vec<Option<Coordinate>>,
    pub(super) of_axes: Vec<Coordinate>,
    /// Those of the origin, of `p` and of `q`.
    pub(super) symbols: Vec<SymbolId>,
    /// Origin, `p`, `q` and `p x q`.
    pub(super) origin: V3<'m>,
    pub(super) axes: [V3<'m>; 3],
    /// The equations of its axes.
    pub(super) own: Vec<usize>,
}

/// A point of the body, by its coordinates along `p`, `q` and `p x q`, and the rods to it.
pub(super) struct Joint<'m> {
    pub(super) local: V3<'m>,
    pub(super) rods: Vec<Held<'m>>,
}

impl<'m> Body<'m> {
    /// The coordinates of its origin that are open.
    pub(super) fn of_origin(&self) -> Vec<Coordinate> {
        self.open.iter().flatten().cloned().collect()
    }

    /// A joint as seen from the origin.
    pub(super) fn arm(&self, joint: &Joint<'m>) -> V3<'m> {
        let [p, q, r] = self.axes;
        let Vector([x, y, z]) = joint.local;
        x * p + y * q + z * r
    }
}

/// A frame of which both axes are open, and two coordinates of the origin at least.
pub(super) fn body<'m>(
    analysis: &Analysis<'_, 'm>,
    unknowns: &[usize],
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<Body<'m>> {
    let symbols = unknowns
        .iter()
        .map(|&k| match &analysis.algebra.names.bound[k] {
            Bound::Lengths(symbols) => symbols.iter().map(|(symbol, _)| *symbol).collect(),
            Bound::Angle(_) => Vec::new(),
        });
    let symbols: Vec<SymbolId> = symbols.collect::<Vec<Vec<_>>>().concat();
    let open = |symbol: &SymbolId| {
        let kind = CoordinateKind::Length(*symbol);
        coordinates.iter().find(|c| c.kind == kind).cloned()
    };
    let (of_origin, of_axes) = symbols.split_at_checked(3)?;
    let axes: Vec<Coordinate> = of_axes.iter().map(open).collect::<Option<_>>()?;
    let open_of_origin: Vec<Option<Coordinate>> = of_origin.iter().map(open).collect();
    // What is no unknown any more is known, or something else by now.
    let mut others = of_origin.iter().zip(&open_of_origin);
    let replaced =
        others.any(|(symbol, open)| open.is_none() && analysis.substitutions.contains_key(symbol));
    let count = open_of_origin.iter().flatten().count();
    if axes.len() != 6 || replaced || count < 2 {
        return None;
    }
    let mechanism = analysis.algebra.mechanism;
    let is_own = |equation: &Equation<'m>| {
        let written = equation
            .loops
            .iter()
            .all(|&k| mechanism.is_loop_of_frame(k));
        let about = coordinates
            .iter()
            .filter(|c| equations::contains(analysis, equation.rows[0], c));
        let mut about = about;
        written && equation.rows.len() == 1 && about.all(|c| axes.contains(c))
    };
    let places = (0..equations.len()).filter(|&k| is_own(&equations[k]));
    let places: Vec<usize> = places.collect();
    if places.len() != 3 {
        return None;
    }
    let graph = analysis.algebra.graph;
    let part =
        |first: usize| Vector([0, 1, 2].map(|k| graph.ex(graph.symbol_node(symbols[first + k]))));
    let [origin, p, q] = [part(0), part(3), part(6)];
    Some(Body {
        open: open_of_origin,
        of_axes: axes,
        axes: [p, q, p.cross(q)],
        origin,
        own: places,
        symbols,
    })
}

/// Its points at which two rods from fixed points end.
pub(super) fn joints<'m>(
    analysis: &mut Analysis<'_, 'm>,
    body: &Body<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Vec<Joint<'m>> {
    let mut joints: Vec<Joint<'m>> = Vec::new();
    for (place, equation) in equations.iter().enumerate() {
        let Some((local, held)) = rod(analysis, body, place, equation, coordinates) else {
            continue;
        };
        let same = |joint: &&mut Joint<'m>| {
            let mut pairs = joint.local.components().zip(local.components());
            pairs.all(|(a, b)| numerically_equal(a, b))
        };
        match joints.iter_mut().find(same) {
            Some(joint) => joint.rods.push(held),
            None => joints.push(Joint {
                local,
                rods: vec![held],
            }),
        }
    }
    // What a third rod holds runs nowhere.
    joints.retain(|joint| joint.rods.len() == 2);
    joints
}

/// The point of the body at which a rod from a fixed point ends, and the rod.
fn rod<'m>(
    analysis: &mut Analysis<'_, 'm>,
    body: &Body<'m>,
    place: usize,
    equation: &Equation<'m>,
    coordinates: &[Coordinate],
) -> Option<(V3<'m>, Held<'m>)> {
    let [row] = equation.rows[..] else {
        return None;
    };
    let (vector, length) = space::space_distance(analysis, row, coordinates)?;
    let (places, factor, known) = point::moved_point(analysis, vector, &body.symbols[..3])?;
    let is_whole = factor.constant_value().is_some_and(|own| own.abs() == 1.0);
    if !is_whole || places != [0, 1, 2] {
        return None;
    }
    let (local, end) = local(analysis, body, known / factor)?;
    let end = -end;
    let is_fixed = local.is_fixed() && end.is_fixed();
    is_fixed.then_some((local, Held { place, end, length }))
}

/// `a` and the rest of `a.x p + a.y q + a.z (p x q) + rest`.
fn local<'m>(
    analysis: &mut Analysis<'_, 'm>,
    body: &Body<'m>,
    vector: V3<'m>,
) -> Option<(V3<'m>, V3<'m>)> {
    let zero = analysis.algebra.zero();
    let mut found: [Option<Ex<'m>>; 3] = [None; 3];
    let mut rest = [zero; 3];
    for (k, row) in vector.components().enumerate() {
        let mut terms = collect(row, &body.symbols[3..], &[])?;
        let mut take = |of: &[usize]| {
            let mut monomial = vec![0; 6];
            of.iter().for_each(|&place| monomial[place] += 1);
            terms.remove(&monomial).unwrap_or(zero)
        };
        let [next, last] = [(k + 1) % 3, (k + 2) % 3];
        let product = take(&[next, 3 + last]);
        let along = [take(&[k]), take(&[3 + k]), product];
        rest[k] = take(&[]);
        let turned_back = take(&[last, 3 + next]);
        if !numerically_equal(product, -turned_back) || !terms.is_empty() {
            return None;
        }
        for (found, own) in found.iter_mut().zip(along) {
            if !numerically_equal(*found.get_or_insert(own), own) {
                return None;
            }
        }
    }
    let [Some(x), Some(y), Some(z)] = found else {
        return None;
    };
    Some((Vector([x, y, z]), Vector(rest)))
}
