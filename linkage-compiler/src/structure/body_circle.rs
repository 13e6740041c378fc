//! An unknown frame that rods hold, two and two in a point of it: each of these points runs on a
//! circle.
//!
//! Three such points say where the frame is, so that three angles remain of nine unknowns, and of
//! the loops the distances between the points. Of fewer, one says where the origin is: an angle
//! instead of its coordinates, and two loops less.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, Graph, V3, Vector, substitute};

use crate::algebra::{Names, Nominal};
use crate::model::unknown_frames;
use crate::structure::body::{Body, Joint};
use crate::structure::equations::{Coordinate, Equation, System};
use crate::structure::reductions::{Reductions, Substitutions};
use crate::structure::{body, circle, explicit};

/// Points of which one is nearer to the line through the others than this share of their distance
/// determine no frame.
const ON_A_LINE: f64 = 1e-3;

/// One body of which points run on circles: three, or the first.
pub(crate) fn body_to_circles<'m>(
    names: &mut Names<'m>,
    nominal: &Nominal,
    reductions: &mut Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    for (_, unknowns) in unknown_frames::bodies_of_space(names.mechanism) {
        let Some(body) = body::body(
            names,
            &reductions.substitutions,
            &unknowns,
            equations,
            coordinates,
        ) else {
            continue;
        };
        let joints = body::joints(names, &body, equations, coordinates);
        if body.of_origin().len() == 3
            && let Some(three) = three_of(nominal, &joints)
        {
            return Some(on_three_circles(
                names,
                nominal,
                reductions,
                &body,
                three,
                equations,
                coordinates,
            ));
        }
        if let Some(joint) = joints.first() {
            return Some(on_one_circle(
                names,
                nominal,
                reductions,
                &body,
                joint,
                equations,
                coordinates,
            ));
        }
    }
    None
}

/// Three joints that are on no line at the defaults.
fn three_of<'m, 'j>(nominal: &Nominal, joints: &'j [Joint<'m>]) -> Option<[&'j Joint<'m>; 3]> {
    let [first, second, others @ ..] = joints else {
        return None;
    };
    let along = second.local - first.local;
    let is_beside = |third: &&Joint<'m>| {
        let arm = third.local - first.local;
        let sizes = [along.cross(arm), along, arm].map(|v| v.length());
        let sizes = nominal.evaluate(&sizes);
        sizes[0] > ON_A_LINE * sizes[1] * sizes[2]
    };
    let third = others.iter().find(is_beside)?;
    Some([first, second, third])
}

/// The frame by three of its points, which run on circles and keep their distances.
fn on_three_circles<'m>(
    names: &mut Names<'m>,
    nominal: &Nominal,
    reductions: &mut Reductions<'m>,
    body: &Body<'m>,
    joints: [&Joint<'m>; 3],
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> System<'m> {
    let running = joints.map(|joint| {
        let point = body.origin + body.arm(joint);
        circle::running(names, nominal, point, [&joint.rods[0], &joint.rods[1]])
    });
    let points = [0, 1, 2].map(|k| running[k].point);
    let locals = joints.map(|joint| joint.local);
    let parts = frame_of(points, locals).into_iter();
    let values = parts.flat_map(|part| part.0);
    for (&symbol, value) in body.symbols.iter().zip(values) {
        explicit::make_explicit(reductions, symbol, value);
    }
    let explained = [body.of_origin(), body.of_axes.clone()].concat();
    let rods = joints.iter().flat_map(|joint| &joint.rods);
    let solved = rods.map(|rod| rod.index).chain(body.rows_of_body.clone());
    let mut kept = kept(
        names.graph,
        &reductions.substitutions,
        solved.collect(),
        &explained,
        equations,
    );
    for [a, b] in [[0, 1], [1, 2], [2, 0]] {
        let apart = (points[b] - points[a]).length();
        let wanted = (locals[b] - locals[a]).length();
        let mut equation = equations[joints[a].rods[0].index].clone();
        for rod in joints[a].rods.iter().chain(&joints[b].rods) {
            equation.absorb(&equations[rod.index], &explained);
        }
        equation.rows = vec![apart - wanted];
        equation.relation = None;
        kept.push(equation);
    }
    let mut left = without(coordinates, &explained);
    left.extend(running.map(|circle| circle.angle));
    (kept, left)
}

/// Replaces the origin by one of its points, which runs on a circle; the axes stay unknowns.
fn on_one_circle<'m>(
    names: &mut Names<'m>,
    nominal: &Nominal,
    reductions: &mut Reductions<'m>,
    body: &Body<'m>,
    joint: &Joint<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> System<'m> {
    let [first, second] = [0, 1].map(|k| &joint.rods[k]);
    let arm = body.arm(joint);
    let running = circle::running(names, nominal, body.origin + arm, [first, second]);
    let origin = running.point - arm;
    let of_origin = body.of_origin();
    // The rest of the position is no unknown: where it is an expression by now, a row that
    // remembers it would be about itself.
    let zero = names.zero();
    let given = Vector([0, 1, 2].map(|k| match body.open[k] {
        Some(_) => zero,
        None => body.origin[k],
    }));
    let mut known = Map::new();
    let mut rows = Vec::new();
    for (index, open) in body.open.iter().enumerate() {
        let (symbol, component) = (body.symbols[index], origin[index]);
        match open {
            Some(_) => explicit::make_explicit(reductions, symbol, component),
            None => {
                known.insert(symbol, component);
                rows.push(circle::along(names.graph, index).product(origin - given));
            }
        }
    }
    reductions.kept_axes.extend(&body.symbols[3..]);
    let mut rod = equations[first.index].clone();
    rod.absorb(&equations[second.index], &of_origin);
    let mut kept = kept(
        names.graph,
        &reductions.substitutions,
        vec![first.index, second.index],
        &of_origin,
        equations,
    );
    for equation in &mut kept {
        // The point counts as unknown: the body carries all points of the loops together.
        names.graph.substitute_lengths(&equation.rows, &known);
        equation.rows = substitute(&equation.rows, &known);
    }
    kept.extend(rows.into_iter().map(|row| Equation {
        rows: vec![row],
        relation: None,
        ..rod.clone()
    }));
    let mut left = without(coordinates, &of_origin);
    left.push(running.angle);
    (kept, left)
}

/// The equations without those that were solved, in which some unknowns are expressions now.
fn kept<'m>(
    graph: &'m Graph,
    substitutions: &Substitutions<'m>,
    solved: Vec<usize>,
    explained: &[Coordinate],
    equations: &[Equation<'m>],
) -> Vec<Equation<'m>> {
    let mut gone = equations[solved[0]].clone();
    for &index in &solved {
        gone.absorb(&equations[index], &[]);
    }
    let mut kept = Vec::new();
    for (index, equation) in equations.iter().enumerate() {
        if !solved.contains(&index) {
            let mut equation = equation.clone();
            explicit::substitute_in(graph, substitutions, &mut equation, &gone, explained);
            kept.push(equation);
        }
    }
    kept
}

fn without(coordinates: &[Coordinate], gone: &[Coordinate]) -> Vec<Coordinate> {
    let left = coordinates
        .iter()
        .filter(|coordinate| !gone.contains(coordinate));
    left.cloned().collect()
}

/// Returns the origin and the axes `p` and `q` of a frame of which three points are known: the
/// edges of their triangle and its normal are those in the frame, turned.
fn frame_of<'m>(points: [V3<'m>; 3], locals: [V3<'m>; 3]) -> [V3<'m>; 3] {
    let edges = |[a, b, c]: [V3<'m>; 3]| {
        let [along, beside] = [b - a, c - a];
        [along, beside, along.cross(beside)]
    };
    let [along, beside, normal] = edges(locals);
    let size = normal.square();
    // The edges and the normal of the known points are 1 along one of these each, and 0 along the
    // others.
    let duals = [beside.cross(normal), normal.cross(along), normal].map(|v| v / size);
    let turned = edges(points);
    let image = |shares: [Ex<'m>; 3]| {
        let parts = [0, 1, 2].map(|k| shares[k] * turned[k]);
        parts[0] + parts[1] + parts[2]
    };
    let axis = |k: usize| image(duals.map(|dual| dual[k]));
    let first = image(duals.map(|dual| dual.dot(locals[0])));
    [points[0] - first, axis(0), axis(1)]
}
