//! A point at given distances from known points and on known planes, a direction at given angles to
//! known directions.

mod differentiate;
mod geometry;
use linkage_symbolic::{Ex, SymbolId, V3, Vector};

use crate::algebra::Algebra;
use crate::solve::closed::{ClosedForm, GapIn};
use crate::solve::definitions;
use crate::solve::group_context::GroupContext;
use crate::structure::{Plane, Sphere};

use super::plane::{defined_gap, gap, guarded};
use geometry::{Ball, Level, PointOnSpheres};

/// The length of a vector as a share of the sum of its components, which needs no root: it is 0.58
/// to 1.
const SUM_OF_COMPONENTS: f64 = 0.625;

/// The difference of two spheres is a plane, so there are two planes `u.y = a`, `v.y = b` and a
/// sphere. Their line goes along `n = u x v`; its foot is `t x n / n.n` with `t = a v - b u`, at
/// the distance `|t|/|n|`, and the root is `h = sqrt(r^2 - t.t/n.n)`. Lengths are scaled by a power
/// of two, so that products of many do not overflow.
pub(super) fn point<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    coordinates: &[(SymbolId, usize)],
    spheres: &[Sphere<'m>],
    planes: &[Plane<'m>],
) -> ClosedForm<'m> {
    let mut coordinates = coordinates.to_vec();
    coordinates.sort_by_key(|(_, component)| *component);
    let missing = (0..3).find(|k| coordinates.iter().all(|(_, component)| component != k));

    let (scale, balls) = balls(spheres);
    let base = &balls[0];
    let mut levels: Vec<Level> = Vec::new();
    levels.extend(balls[1..].iter().map(|ball| radical_plane(base, ball)));
    levels.extend(planes.iter().map(|plane| level(base, plane, scale)));
    levels.extend(missing.map(|component| level(base, &axis(algebra, component), scale)));
    let [first, second] = &levels[..] else {
        unreachable!("three conditions: a sphere and two planes");
    };

    let w = definitions::mode_sign(algebra, group);
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
        definitions::define_length(algebra, group, symbol, guarded(value, h), position);
    }
    let solution = PointOnSpheres { arm, scale, h };
    differentiate::push_point(
        algebra,
        group,
        &coordinates,
        planes,
        &balls,
        &solution,
        volume,
    );

    let mut margin = h / radius * sine;
    for level in &levels {
        margin = margin / level.largest;
    }
    let miss = distance2.sqrt() / scale - base.radius;
    let gap = gap(q, noise, miss);
    let (kind, method) = kind_and_method(spheres.len());
    ClosedForm {
        kind: kind.into(),
        class: 0,
        order: 0,
        method,
        two_modes: true,
        margin,
        slack: q / radius2,
        slack_scale: algebra.one(),
        gap: defined_gap(gap, sine2),
        gap_in: GapIn::Unknown,
    }
}

/// The plane in which a component is 0.
fn axis<'m>(algebra: &Algebra<'m>, component: usize) -> Plane<'m> {
    let (zero, one) = (algebra.zero(), algebra.one());
    let mut normal = Vector([zero; 3]);
    normal.0[component] = one;
    Plane {
        normal,
        offset: zero,
    }
}

/// The terms of the line's distance from the first centre, times `|n|`; lengths as sums of
/// components.
fn lengths_of<'m>(first: &Level<'m>, second: &Level<'m>) -> Ex<'m> {
    let [u, v] = [first, second].map(|level| {
        let [x, y, z] = level.normal.map(Ex::abs).0;
        x + y + z
    });
    first.size * v + second.size * u
}

/// The power of two by which lengths are scaled, and the spheres.
fn balls<'m>(spheres: &[Sphere<'m>]) -> (Ex<'m>, Vec<Ball<'m>>) {
    let centres_and_radii: Vec<(V3, Ex)> = spheres
        .iter()
        .map(|sphere| {
            let centre = sphere.known.map(|x| -(x / sphere.factor));
            (centre, sphere.radius / sphere.factor.abs())
        })
        .collect();
    let (base, first) = centres_and_radii[0];
    let sum = centres_and_radii[1..]
        .iter()
        .fold(first, |sum, (_, r)| sum + *r);
    let scale = sum.inverse_scale();
    let balls = centres_and_radii.into_iter().map(|(centre, radius)| {
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

/// The plane of the circle in which two spheres meet: `a . y = (a.a + (r0 - r)(r0 + r))/2` for the
/// distance `a` of the centres.
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

/// The names of the kind and of the method, by the number of spheres.
fn kind_and_method(spheres: usize) -> (&'static str, &'static str) {
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
