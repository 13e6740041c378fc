//! An unknown frame that rods hold, two and two in a point of it: each of these points runs on a circle.
//!
//! Three such points say where the frame is, so that three angles remain of nine unknowns, and of the loops the distances between the points.

use linkage_symbolic::{Ex, SymbolId, V3, Vector, agree, collect};

use super::Analysis;
use super::circle::Held;
use super::eliminate::System;
use super::equations::{Coordinate, CoordinateKind, Equation};

/// An unknown frame: its origin and two axes `p` and `q`; the third one is `p x q`.
struct Body<'m> {
    coordinates: Vec<Coordinate>,
    symbols: Vec<SymbolId>,
    /// Origin, `p`, `q` and `p x q`.
    origin: V3<'m>,
    axes: [V3<'m>; 3],
    /// The equations of its axes.
    own: Vec<usize>,
}

/// A point of the body, by its coordinates along `p`, `q` and `p x q`, and the rods to it.
struct Joint<'m> {
    local: V3<'m>,
    rods: Vec<Held<'m>>,
}

/// Points of which one is nearer to the line through the others than this share of their distance determine no frame.
const ON_A_LINE: f64 = 1e-3;

impl<'m> Analysis<'_, 'm> {
    /// One body of which points run on circles.
    pub(super) fn body_to_circles(
        &mut self,
        equations: &[Equation<'m>],
        coordinates: &[Coordinate],
    ) -> Option<System<'m>> {
        for (_, unknowns) in self.algebra.mechanism.bodies_of_space() {
            let Some(body) = self.body(&unknowns, equations, coordinates) else {
                continue;
            };
            let joints = self.joints(&body, equations, coordinates);
            if let Some(three) = self.three_of(&joints) {
                return Some(self.on_three_circles(&body, three, equations, coordinates));
            }
        }
        None
    }

    /// A frame of which all nine unknowns are open.
    fn body(
        &self,
        unknowns: &[usize],
        equations: &[Equation<'m>],
        coordinates: &[Coordinate],
    ) -> Option<Body<'m>> {
        let of = |unknown: usize| {
            let own = coordinates
                .iter()
                .filter(move |c| c.unknown == Some(unknown));
            own.cloned()
        };
        let own: Vec<Coordinate> = unknowns.iter().flat_map(|&unknown| of(unknown)).collect();
        let symbols: Vec<SymbolId> = own
            .iter()
            .map(|c| match c.kind {
                CoordinateKind::Length(symbol) => Some(symbol),
                CoordinateKind::Angle(_) => None,
            })
            .collect::<Option<_>>()?;
        if symbols.len() != 9 {
            return None;
        }
        let mechanism = self.algebra.mechanism;
        let is_own = |equation: &Equation<'m>| {
            let written = equation
                .loops
                .iter()
                .all(|&k| mechanism.is_loop_of_frame(k));
            let about = coordinates
                .iter()
                .filter(|c| self.contains(equation.rows[0], c));
            let mut about = about;
            written && equation.rows.len() == 1 && about.all(|c| own[3..].contains(c))
        };
        let places = (0..equations.len()).filter(|&k| is_own(&equations[k]));
        let places: Vec<usize> = places.collect();
        if places.len() != 3 {
            return None;
        }
        let graph = self.algebra.graph;
        let part = |first: usize| {
            Vector([0, 1, 2].map(|k| graph.ex(graph.symbol_node(symbols[first + k]))))
        };
        let [origin, p, q] = [part(0), part(3), part(6)];
        Some(Body {
            coordinates: own,
            axes: [p, q, p.cross(q)],
            origin,
            own: places,
            symbols,
        })
    }

    /// Its points at which two rods from fixed points end.
    fn joints(
        &mut self,
        body: &Body<'m>,
        equations: &[Equation<'m>],
        coordinates: &[Coordinate],
    ) -> Vec<Joint<'m>> {
        let mut joints: Vec<Joint<'m>> = Vec::new();
        for (place, equation) in equations.iter().enumerate() {
            let Some((local, held)) = self.rod(body, place, equation, coordinates) else {
                continue;
            };
            let same = |joint: &&mut Joint<'m>| {
                let mut pairs = joint.local.components().zip(local.components());
                pairs.all(|(a, b)| agree(a, b))
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
    fn rod(
        &mut self,
        body: &Body<'m>,
        place: usize,
        equation: &Equation<'m>,
        coordinates: &[Coordinate],
    ) -> Option<(V3<'m>, Held<'m>)> {
        let [row] = equation.rows[..] else {
            return None;
        };
        let (vector, length) = self.space_distance(row, coordinates)?;
        let (places, factor, known) = self.moved_point(vector, &body.symbols[..3])?;
        let is_whole = factor.constant_value().is_some_and(|own| own.abs() == 1.0);
        if !is_whole || places != [0, 1, 2] {
            return None;
        }
        let (local, end) = self.local(body, known / factor)?;
        let end = -end;
        let is_fixed = local.is_fixed() && end.is_fixed();
        is_fixed.then_some((local, Held { place, end, length }))
    }

    /// `a` and the rest of `a.x p + a.y q + a.z (p x q) + rest`.
    fn local(&mut self, body: &Body<'m>, vector: V3<'m>) -> Option<(V3<'m>, V3<'m>)> {
        let zero = self.algebra.zero();
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
            if !agree(product, -turned_back) || !terms.is_empty() {
                return None;
            }
            for (found, own) in found.iter_mut().zip(along) {
                if !agree(*found.get_or_insert(own), own) {
                    return None;
                }
            }
        }
        let [Some(x), Some(y), Some(z)] = found else {
            return None;
        };
        Some((Vector([x, y, z]), Vector(rest)))
    }

    /// Three joints that are on no line at the defaults.
    fn three_of<'j>(&self, joints: &'j [Joint<'m>]) -> Option<[&'j Joint<'m>; 3]> {
        let [first, second, others @ ..] = joints else {
            return None;
        };
        let along = second.local - first.local;
        let is_beside = |third: &&Joint<'m>| {
            let arm = third.local - first.local;
            let sizes = [along.cross(arm), along, arm].map(|v| v.length());
            let sizes = self.nominal.evaluate(&sizes);
            sizes[0] > ON_A_LINE * sizes[1] * sizes[2]
        };
        let third = others.iter().find(is_beside)?;
        Some([first, second, third])
    }

    /// The frame by three of its points, which run on circles and keep their distances.
    fn on_three_circles(
        &mut self,
        body: &Body<'m>,
        joints: [&Joint<'m>; 3],
        equations: &[Equation<'m>],
        coordinates: &[Coordinate],
    ) -> System<'m> {
        let running = joints.map(|joint| {
            self.running(self.place_of(body, joint), [&joint.rods[0], &joint.rods[1]])
        });
        let points = [0, 1, 2].map(|k| running[k].point);
        let locals = joints.map(|joint| joint.local);
        self.explain(body, frame_of(points, locals));
        let mut kept = self.kept(body, &joints, equations);
        for [a, b] in [[0, 1], [1, 2], [2, 0]] {
            let apart = (points[b] - points[a]).length();
            let wanted = (locals[b] - locals[a]).length();
            let mut equation = equations[joints[a].rods[0].place].clone();
            for rod in joints[a].rods.iter().chain(&joints[b].rods) {
                equation.absorb(&equations[rod.place], &body.coordinates);
            }
            equation.rows = vec![apart - wanted];
            equation.relation = None;
            kept.push(equation);
        }
        let mut left = without(coordinates, &body.coordinates);
        left.extend(running.map(|own| own.angle));
        (kept, left)
    }

    /// Where a joint is by the unknowns of the body.
    fn place_of(&self, body: &Body<'m>, joint: &Joint<'m>) -> V3<'m> {
        let [p, q, r] = body.axes;
        let Vector([x, y, z]) = joint.local;
        body.origin + x * p + y * q + z * r
    }

    /// Makes origin and axes expressions of other unknowns.
    fn explain(&mut self, body: &Body<'m>, parts: [V3<'m>; 3]) {
        let values = parts.into_iter().flat_map(|part| part.0);
        for (&symbol, value) in body.symbols.iter().zip(values) {
            self.make_explicit(symbol, value);
        }
    }

    /// The equations without those of the rods to three points, and of the axes.
    fn kept(
        &mut self,
        body: &Body<'m>,
        joints: &[&Joint<'m>; 3],
        equations: &[Equation<'m>],
    ) -> Vec<Equation<'m>> {
        let rods = joints.iter().flat_map(|joint| &joint.rods);
        let rods: Vec<usize> = rods.map(|rod| rod.place).collect();
        let mut gone = equations[rods[0]].clone();
        for &rod in &rods {
            gone.absorb(&equations[rod], &[]);
        }
        let mut kept = Vec::new();
        for (place, equation) in equations.iter().enumerate() {
            if !rods.contains(&place) && !body.own.contains(&place) {
                let mut equation = equation.clone();
                self.substitute_in(&mut equation, &gone, &body.coordinates);
                kept.push(equation);
            }
        }
        kept
    }
}

fn without(coordinates: &[Coordinate], gone: &[Coordinate]) -> Vec<Coordinate> {
    let left = coordinates.iter().filter(|own| !gone.contains(own));
    left.cloned().collect()
}

/// The origin and the axes `p` and `q` of a frame of which three points are known: the edges of their triangle and its normal are what they are
/// in the frame, turned.
fn frame_of<'m>(points: [V3<'m>; 3], locals: [V3<'m>; 3]) -> [V3<'m>; 3] {
    let edges = |[a, b, c]: [V3<'m>; 3]| {
        let [along, beside] = [b - a, c - a];
        [along, beside, along.cross(beside)]
    };
    let [along, beside, normal] = edges(locals);
    let size = normal.square();
    // The edges and the normal of what is known are 1 along one of these each, and 0 along the others.
    let duals = [beside.cross(normal), normal.cross(along), normal].map(|own| own / size);
    let turned = edges(points);
    let image = |shares: [Ex<'m>; 3]| {
        let parts = [0, 1, 2].map(|k| shares[k] * turned[k]);
        parts[0] + parts[1] + parts[2]
    };
    let axis = |k: usize| image(duals.map(|dual| dual[k]));
    let first = image(duals.map(|dual| dual.dot(locals[0])));
    [points[0] - first, axis(0), axis(1)]
}
