//! A scalar loop with one unknown angle.

use crate::solve::longest;
use crate::solve::plane;
use linkage_symbolic::{Ex, Vector};

use crate::algebra::{AngleReference, Term};

use super::plane::{gap, guarded, known_term};
use super::{Closed, GapIn, Solver};

/// `A cos + B sin = C`: with `R = sqrt(A^2 + B^2)` and `h = sqrt((R - C)(R + C))` the unit vector is
/// `(A C - w B h, B C + w A h) / R^2`.
pub(super) fn trigonometric<'m>(
    solver: &mut Solver<'_, 'm>,
    angle: usize,
    a: Ex<'m>,
    b: Ex<'m>,
    known: Ex<'m>,
) -> Closed<'m> {
    let w = solver.mode_sign();
    let written = (Vector([a, b]), known);
    let ([a, b, known], scale) = scaled(solver, [a, b, known]);
    let c = -known;
    let normal = Vector([a, b]);
    let r = normal.length();
    let q = r.difference_of_squares(c);
    let r2 = normal.square();
    let h = q.root(r2);
    let hw = w * h;
    // The division stands beside the root.
    let direction = (1.0 / r2) * normal;
    let unit = c * direction + hw * direction.perp();
    solver.define_angle(angle, 1.0, unit.map(|x| guarded(x, h)), 0);

    let bearing = AngleReference {
        vector: written.0,
        across: true,
        mode: w,
        opposite: false,
        z: None,
        sense: 1.0,
    };
    solver.bear(angle, bearing);

    let unit = solver.algebra.names.angles[angle].unit;
    let slope = unit.cross(normal);
    let determinant = solver.alias("det", -hw, slope);
    let [cos, sin] = unit.0;
    let terms = vec![
        Term {
            coefficient: vec![a],
            factor: cos,
        },
        Term {
            coefficient: vec![b],
            factor: sin,
        },
        known_term(&[known]),
    ];
    plane::push_single(solver, terms, determinant);

    let miss = (c.abs() - r) / scale;
    Closed {
        kind: "A cos x + B sin x = C".into(),
        class: 0,
        order: 0,
        method: "unit vector from the tangent to a circle",
        two_modes: true,
        gap: gap(q, r2, miss),
        margin: longest::root_margin(solver, h, written.0, written.1, scale),
        slack: q,
        slack_scale: r2,
        gap_in: GapIn::Loop,
    }
}

/// An equation between areas, times a power of two near 1 over its size: the squares of areas would leave the range of numbers early.
fn scaled<'m>(solver: &Solver<'_, 'm>, equation: [Ex<'m>; 3]) -> ([Ex<'m>; 3], Ex<'m>) {
    if solver.dimension.is_none_or(|d| d.half_lengths <= 2) {
        return (equation, solver.algebra.one());
    }
    let [a, b, _] = equation;
    let scale = Vector([a, b]).length().inverse_scale();
    (equation.map(|x| scale * x), scale)
}
