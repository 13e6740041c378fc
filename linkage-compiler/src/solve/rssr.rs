//! RSSR: a link with ball joints between a known point and a point that turns about an axis in space.

use crate::solve::circles;
use crate::solve::plane;
use crate::solve::space;
use linkage_symbolic::{Ex, V3, Vector};

use crate::algebra::{AngleReference, Rod, Term};

use super::circles::Squares;
use super::plane::{defined_gap, gap, guarded};
use super::space::{arm_length, distance_terms, projection};
use super::{Closed, GapIn, Solver};

/// `|K + A cos + B sin| = l`, `A` and `B` perpendicular and of length `r`.
///
/// In the rocker's frame `K = (x, y, z)`, z along its axis. The link spans `z` along the axis; seen along it there remain two
/// links of lengths `r` and `sqrt(l^2 - z^2)` in the plane of the circle, solved as RRR, which needs the second one's square only.
/// So parallel axes give the planar mechanism, and needle triangles stay accurate. The link's vector is put together
/// from both parts, never `K + A cos + B sin`. Derivatives are taken in fixed coordinates, where they have the velocity of
/// the rocker's point in common with what users ask for.
pub(super) fn link_to_rotor<'m>(
    solver: &mut Solver<'_, 'm>,
    angle: usize,
    [cosine, sine]: [V3<'m>; 2],
    known: V3<'m>,
    l: Ex<'m>,
) -> Closed<'m> {
    let (length, along) = cosine.length_and_unit();
    let beside = sine / length;
    let r = arm_length(cosine, length);
    let axis = along.cross(beside);
    let [x, y, z] = [along, beside, axis].map(|e| projection(e, known));
    let seen = -Vector([x, y]);
    let squares = shadow(r, l, z);
    let circles = circles::circles(solver, seen, &squares);
    let h = circles.h;

    let [turned, shadow_vector] = circles.vectors;
    let unit = turned.map(|x| guarded(x / r, h));
    solver.define_angle(angle, 1.0, unit, 0);
    let bearing = AngleReference {
        vector: seen,
        across: true,
        mode: solver.mode_sign(),
        opposite: false,
        z: None,
        sense: 1.0,
    };
    solver.bear(angle, bearing);
    let [cos, sin] = solver.algebra.names.angles[angle].unit.0;
    let back = -shadow_vector;
    let turned = Vector([0, 1, 2].map(|k| cosine[k] * cos + sine[k] * sin));
    let link = Vector([0, 1, 2].map(|k| {
        let value = back[0] * along[k] + back[1] * beside[k] + z * axis[k];
        let equal = known[k] + turned[k];
        solver.alias("coupler", guarded(value, h), equal)
    }));
    let slope = Vector([0, 1, 2].map(|k| sine[k] * cos - cosine[k] * sin));
    let moved = slope;
    let slope = link.dot(slope);
    let determinant = solver.alias("det", -circles.product, slope);
    let mut terms = distance_terms(link, known, l);
    for (vector, factor) in [(cosine, cos), (sine, sin)] {
        terms.extend((0..3).map(|k| Term {
            coefficient: vec![vector[k]],
            factor: link[k] * factor,
        }));
    }
    plane::push_single(solver, terms, determinant);
    // `(V - K)^2 = r^2` and `V^2 = l^2`.
    let across = 0.5 * (l.square() + r.square()) - 0.5 * (seen.square() + z.square());
    let across = solver.alias("product", across, link.dot(turned));
    space::rod(
        solver,
        Rod {
            vector: link,
            known,
            length: l,
            slope: moved,
            arms: [cosine, sine],
            across,
        },
    );

    let distance = seen.length();
    let (far, near) = (distance + r, distance - r);
    let [farthest, nearest] = [far, near].map(|x| Vector([x, z]).length());
    let (short, long) = (nearest - l, l - farthest);
    let gap = gap(circles.q, circles.noise, short.max(long));
    let [r_scaled, l_scaled] = squares.radii;
    let largest = r_scaled * l_scaled;
    Closed {
        kind: "SSR".into(),
        class: 0,
        order: 0,
        method: "intersection of two circles in the rocker's plane",
        two_modes: true,
        gap: defined_gap(gap, circles.m),
        margin: h / largest,
        slack: circles.q / largest.square(),
        slack_scale: solver.algebra.one(),
        gap_in: GapIn::Link,
    }
}

/// The circles of radii `r` and `sqrt(l^2 - z^2)`.
fn shadow<'m>(r: Ex<'m>, l: Ex<'m>, z: Ex<'m>) -> Squares<'m> {
    let mut squares = Squares::of([r, l], r + l);
    if z.is_zero() {
        return squares;
    }
    let [r, l] = squares.radii;
    let half = squares.half_scale2 * z.square();
    squares.imbalance += half;
    let z2 = 4.0 * half;
    let [r2, l2] = [r, l].map(|x| 2.0 * x.square());
    let seen2 = l2 - z2;
    squares.twice = r2.min(seen2);
    squares.noise2 = Some(l * (r + l));
    squares
}
