//! A point at given distances from known points and on known planes, a direction at given angles to known directions.

mod differentiate;

use linkage_symbolic::{Ex, SymbolId, V3, Vector};

use crate::structure::{Plane, Sphere};

use super::plane::{defined_gap, gap, guarded};
use super::{Closed, GapIn, Solver};

/// About what a vector's length is of the sum of its components, which needs no root: it is 0.58 to 1.
const SUM_OF_COMPONENTS: f64 = 0.625;

/// A sphere `|f (p - centre)| = radius`, with its own numbers.
struct Ball<'m> {
    centre: V3<'m>,
    /// As a distance from the centre, and scaled.
    radius: Ex<'m>,
    scaled: Ex<'m>,
    /// From the first sphere's centre, scaled.
    apart: V3<'m>,
}

/// A plane `normal . (p - centre of the first sphere) = offset`, scaled; the normal is that of the user of length 1, or the
/// distance of two centres.
struct Level<'m> {
    normal: V3<'m>,
    offset: Ex<'m>,
    /// What the offset's rounding is measured by.
    size: Ex<'m>,
    /// What the normal's length is measured by in the margin.
    largest: Ex<'m>,
}

/// Where a point lies.
struct Place<'m> {
    /// From the first sphere's centre, scaled.
    arm: V3<'m>,
    /// What lengths are multiplied by.
    scale: Ex<'m>,
    /// Scaled, 0 at the dead point.
    h: Ex<'m>,
}

/// The difference of two spheres is a plane, so there are two planes `u.y = a`, `v.y = b` and a sphere. Their line goes along
/// `n = u x v`; its foot is `t x n / n.n` with `t = a v - b u`, at the distance `|t|/|n|`, and the root is
/// `h = sqrt(r^2 - t.t/n.n)`. Lengths are scaled by a power of two, so that products of many do not
/// overflow.
pub(super) fn point<'m>(
    solver: &mut Solver<'_, 'm>,
    coordinates: &[(SymbolId, usize)],
    spheres: &[Sphere<'m>],
    planes: &[Plane<'m>],
) -> Closed<'m> {
    let mut coordinates = coordinates.to_vec();
    coordinates.sort_by_key(|(_, component)| *component);
    let missing = (0..3).find(|k| coordinates.iter().all(|(_, component)| component != k));

    let (scale, balls) = balls(spheres);
    let base = &balls[0];
    let mut levels: Vec<Level> = Vec::new();
    levels.extend(balls[1..].iter().map(|ball| radical_plane(base, ball)));
    levels.extend(planes.iter().map(|plane| level(base, plane, scale)));
    levels.extend(missing.map(|component| level(base, &axis(solver, component), scale)));
    let [first, second] = &levels[..] else {
        unreachable!("three conditions: a sphere and two planes");
    };

    let w = solver.mode_sign();
    let normal = first.normal.cross(second.normal);
    let sine2 = normal.square();
    let sine = normal.length();
    let minus = -second.offset;
    let inverse = 1.0 / sine2;
    let between = first.offset * second.normal + minus * first.normal;
    let radius = base.scaled;
    let radius2 = radius.square();
    let distance2 = between.square() * inverse;
    let q = radius2 - distance2;
    let reach = lengths_of(first, second);
    let shallow = sine * inverse;
    let sizes = reach * shallow;
    let noise = SUM_OF_COMPONENTS * radius * sizes + radius2;
    let h = q.root(noise);
    let hw = w * h;
    let volume = hw * sine;
    let rise = hw * shallow;
    let arm = inverse * between.cross(normal) + rise * normal;

    for (position, &(symbol, component)) in coordinates.iter().enumerate() {
        let value = base.centre[component] + arm[component] / scale;
        solver.define_length(symbol, guarded(value, h), position);
    }
    let place = Place { arm, scale, h };
    differentiate::push_point(solver, &coordinates, planes, &balls, &place, volume);

    let mut margin = h / radius * sine;
    for level in &levels {
        margin = margin / level.largest;
    }
    let miss = distance2.sqrt() / scale - base.radius;
    let gap = gap(q, noise, miss);
    let (words, method) = words(spheres.len());
    Closed {
        kind: words.into(),
        class: 0,
        order: 0,
        method,
        two_modes: true,
        margin,
        slack: q / radius2,
        slack_scale: solver.algebra.one(),
        gap: defined_gap(gap, sine2),
        gap_in: GapIn::Unknown,
    }
}

/// The plane in which a component is 0.
fn axis<'m>(solver: &Solver<'_, 'm>, component: usize) -> Plane<'m> {
    let (zero, one) = (solver.algebra.zero(), solver.algebra.one());
    let mut normal = Vector([zero; 3]);
    normal.0[component] = one;
    Plane {
        normal,
        offset: zero,
    }
}

/// What the line's distance from the first centre consists of, times `|n|`; lengths as sums of components.
fn lengths_of<'m>(first: &Level<'m>, second: &Level<'m>) -> Ex<'m> {
    let [u, v] = [first, second].map(|level| {
        let [x, y, z] = level.normal.map(Ex::abs).0;
        x + y + z
    });
    first.size * v + second.size * u
}

/// The power of two by which lengths are scaled, and the spheres.
fn balls<'m>(spheres: &[Sphere<'m>]) -> (Ex<'m>, Vec<Ball<'m>>) {
    let own: Vec<(V3, Ex)> = spheres
        .iter()
        .map(|sphere| {
            let centre = sphere.known.map(|x| -(x / sphere.factor));
            (centre, sphere.radius / sphere.factor.abs())
        })
        .collect();
    let (base, first) = own[0];
    let sum = own[1..].iter().fold(first, |sum, (_, r)| sum + *r);
    let scale = sum.inverse_scale();
    let balls = own.into_iter().map(|(centre, radius)| {
        let apart = Vector([0, 1, 2].map(|k| scale * (centre[k] - base[k])));
        Ball {
            centre,
            radius,
            scaled: scale * radius,
            apart,
        }
    });
    let balls = balls.collect();
    (scale, balls)
}

/// The plane of the circle in which two spheres meet: `a . y = (a.a + (r0 - r)(r0 + r))/2` for the distance `a` of the centres.
fn radical_plane<'m>(base: &Ball<'m>, ball: &Ball<'m>) -> Level<'m> {
    let square = ball.apart.square();
    let imbalance = base.scaled.difference_of_squares(ball.scaled);
    Level {
        normal: ball.apart,
        offset: 0.5 * (square + imbalance),
        size: square + imbalance.abs(),
        largest: ball.scaled,
    }
}

fn level<'m>(base: &Ball<'m>, plane: &Plane<'m>, scale: Ex<'m>) -> Level<'m> {
    let (length, normal) = plane.normal.length_and_unit();
    let offset = plane.offset / length;
    let here = normal.dot(base.centre);
    let sum = offset + here;
    let size = offset.abs() + here.abs();
    let offset = -sum;
    Level {
        normal,
        offset: scale * offset,
        size: scale * size,
        largest: offset.number(1.0),
    }
}

fn words(spheres: usize) -> (&'static str, &'static str) {
    match spheres {
        1 => (
            "one distance, two planes",
            "intersection of a sphere and a line",
        ),
        2 => (
            "two distances, one plane",
            "intersection of a sphere and two planes",
        ),
        _ => (
            "three distances",
            "trilateration, root along the normal of the centres",
        ),
    }
}
