//! Unknown frames whose place is open, and the rods that hold them.

use linkage_symbolic::{Ex, Graph, SymbolId, V3, Vector, collect, numerically_equal};

use crate::algebra::Bound;
use crate::algebra::names::Names;
use crate::model::unknown_frames;
use crate::structure::circle::Held;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::reductions::Substitutions;
use crate::structure::{distance, equations, point};

/// An unknown frame: its origin and two axes `p` and `q`; the third one is `p x q`.
pub(crate) struct Body<'m> {
    /// The coordinates of its origin, those that are not known, and of its axes.
    pub(crate) open: Vec<Option<Coordinate>>,
    pub(crate) of_axes: Vec<Coordinate>,
    /// Those of the origin, of `p` and of `q`.
    pub(crate) symbols: Vec<SymbolId>,
    /// Origin, `p`, `q` and `p x q`.
    pub(crate) origin: V3<'m>,
    pub(crate) axes: [V3<'m>; 3],
    /// The equations of its axes.
    pub(crate) rows_of_body: Vec<usize>,
}

/// A point of the body, by its coordinates along `p`, `q` and `p x q`, and the rods to it.
pub(crate) struct Joint<'m> {
    pub(crate) local: V3<'m>,
    pub(crate) rods: Vec<Held<'m>>,
}

impl<'m> Body<'m> {
    /// The coordinates of its origin that are open.
    pub(crate) fn of_origin(&self) -> Vec<Coordinate> {
        self.open.iter().flatten().cloned().collect()
    }

    /// A joint as seen from the origin.
    pub(crate) fn arm(&self, joint: &Joint<'m>) -> V3<'m> {
        let [p, q, r] = self.axes;
        let Vector([x, y, z]) = joint.local;
        x * p + y * q + z * r
    }
}

/// A frame of which both axes are open, and two coordinates of the origin at least.
pub(crate) fn body<'m>(
    names: &Names<'m>,
    substitutions: &Substitutions<'m>,
    unknowns: &[usize],
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<Body<'m>> {
    let symbols = unknowns.iter().map(|&k| match &names.bound[k] {
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
    // A coordinate that is no unknown any more is known, or another expression by now.
    let mut others = of_origin.iter().zip(&open_of_origin);
    let replaced =
        others.any(|(symbol, open)| open.is_none() && substitutions.contains_key(symbol));
    let count = open_of_origin.iter().flatten().count();
    if axes.len() != 6 || replaced || count < 2 {
        return None;
    }
    let mechanism = names.mechanism;
    let is_own = |equation: &Equation<'m>| {
        let written = equation
            .loops
            .iter()
            .all(|&k| unknown_frames::is_loop_of_frame(mechanism, k));
        let about = coordinates
            .iter()
            .filter(|c| equations::contains(names, equation.rows[0], c));
        let mut about = about;
        written && equation.rows.len() == 1 && about.all(|c| axes.contains(c))
    };
    let places = (0..equations.len()).filter(|&k| is_own(&equations[k]));
    let places: Vec<usize> = places.collect();
    if places.len() != 3 {
        return None;
    }
    let graph = names.graph;
    let part =
        |first: usize| Vector([0, 1, 2].map(|k| graph.ex(graph.symbol_node(symbols[first + k]))));
    let [origin, p, q] = [part(0), part(3), part(6)];
    Some(Body {
        open: open_of_origin,
        of_axes: axes,
        axes: [p, q, p.cross(q)],
        origin,
        rows_of_body: places,
        symbols,
    })
}

/// Its points at which two rods from fixed points end.
pub(crate) fn joints<'m>(
    names: &Names<'m>,
    body: &Body<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Vec<Joint<'m>> {
    let mut joints: Vec<Joint<'m>> = Vec::new();
    for (index, equation) in equations.iter().enumerate() {
        let Some((local, held)) = rod(names, body, index, equation, coordinates) else {
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
    // A point that a third rod holds runs nowhere.
    joints.retain(|joint| joint.rods.len() == 2);
    joints
}

/// The point of the body at which a rod from a fixed point ends, and the rod.
fn rod<'m>(
    names: &Names<'m>,
    body: &Body<'m>,
    index: usize,
    equation: &Equation<'m>,
    coordinates: &[Coordinate],
) -> Option<(V3<'m>, Held<'m>)> {
    let [row] = equation.rows[..] else {
        return None;
    };
    let (vector, length) = distance::space_distance(names, row, coordinates)?;
    let (places, factor, known) = point::moved_point(names.graph, vector, &body.symbols[..3])?;
    let is_whole = factor.constant_value().is_some_and(|x| x.abs() == 1.0);
    if !is_whole || places != [0, 1, 2] {
        return None;
    }
    let (local, end) = local(names.graph, body, known / factor)?;
    let end = -end;
    let is_fixed = local.is_fixed() && end.is_fixed();
    is_fixed.then_some((local, Held { index, end, length }))
}

/// `a` and the rest of `a.x p + a.y q + a.z (p x q) + rest`.
fn local<'m>(graph: &'m Graph, body: &Body<'m>, vector: V3<'m>) -> Option<(V3<'m>, V3<'m>)> {
    let zero = graph.number(0.0);
    let mut found: [Option<Ex<'m>>; 3] = [None; 3];
    let mut rest = [zero; 3];
    for (k, row) in vector.components().enumerate() {
        let mut terms = collect(row, &body.symbols[3..], &[])?;
        let mut take = |of: &[usize]| {
            let mut monomial = vec![0; 6];
            of.iter().for_each(|&index| monomial[index] += 1);
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
        for (found, component) in found.iter_mut().zip(along) {
            if !numerically_equal(*found.get_or_insert(component), component) {
                return None;
            }
        }
    }
    let [Some(x), Some(y), Some(z)] = found else {
        return None;
    };
    Some((Vector([x, y, z]), Vector(rest)))
}
