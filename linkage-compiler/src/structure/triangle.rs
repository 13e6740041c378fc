//! Triangles: three points of one link with their three distances. Its shape is solved separately,
//! and one of the points is where the other two take it.

use linkage_symbolic::{Ex, V2, Vector, numerically_equal};

use crate::algebra::names::Names;
use crate::algebra::{Nominal, nominal};
use crate::structure::distance::Distance;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation, System};
use crate::structure::reductions::Reductions;
use crate::structure::{distance, equations, set_unknowns};

/// A distance of fixed length in the plane.
struct Side<'m> {
    index: usize,
    vector: V2<'m>,
    length: Ex<'m>,
    contained: Vec<usize>,
}

/// The vectors of three sides: the third one is the sum of the others.
struct Triangle<'m> {
    indices: [usize; 3],
    vectors: [V2<'m>; 3],
    lengths: [Ex<'m>; 3],
}

/// Replaces two distances of a triangle in a coupled set by its shape, and by the vector loop that
/// turns it with the third side; `None` if there is no triangle.
pub(crate) fn by_shape<'m>(
    names: &mut Names<'m>,
    nominal: &Nominal,
    reductions: &Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    if equations.len() < 4 || !set_unknowns::are_estimated(names, equations, coordinates) {
        return None;
    }
    let Triangle {
        indices,
        vectors,
        lengths,
    } = triangle(names, equations, coordinates)?;
    let drawn = vectors.map(|vector| {
        let [x, y] = nominal::at_estimates(names, nominal, &vector.0)[..] else {
            return 0.0;
        };
        y.atan2(x)
    });
    let mut add_angle = |side: usize| {
        let angle = names.add_angle("shape", None);
        let between = drawn[side] - drawn[0];
        names.angles[angle].drawn = if between.is_finite() { between } else { 0.0 };
        angle
    };
    let turned = [1, 2].map(&mut add_angle);
    let [first, second] = turned.map(|angle| names.angles[angle].unit);
    let base = Vector([lengths[0], names.zero()]);
    let shape = base + lengths[1] * first - lengths[2] * second;
    let ratio = lengths[2] / lengths[0];
    let turning = vectors[2] - vectors[0].turned(ratio * second);
    let mut equations = equations.to_vec();
    let all = indices.map(|index| equations[index].clone());
    for (index, rows) in [(indices[1], shape), (indices[2], turning)] {
        let equation = &mut equations[index];
        equation.rows = rows.0.to_vec();
        equation.relation = None;
        for side in &all {
            equation.absorb(side, &[]);
        }
    }
    let mut coordinates = coordinates.to_vec();
    coordinates.extend(turned.map(|angle| Coordinate {
        kind: CoordinateKind::Angle(angle),
        unknown: None,
    }));
    set_unknowns::place_eliminated(names, reductions, &mut equations, &coordinates)?;
    Some((equations, coordinates))
}

fn triangle<'m>(
    names: &Names<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<Triangle<'m>> {
    let sides = equations.iter().enumerate();
    let sides: Vec<Side<'m>> = sides
        .filter_map(|(index, equation)| side(names, index, equation, coordinates))
        .collect();
    let pairs = (0..sides.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
    pairs
        .flat_map(|(a, b)| (b + 1..sides.len()).map(move |c| [a, b, c]))
        .find_map(|three| closed(three.map(|k| &sides[k])))
}

fn side<'m>(
    names: &Names<'m>,
    index: usize,
    equation: &Equation<'m>,
    coordinates: &[Coordinate],
) -> Option<Side<'m>> {
    let [row] = equation.rows[..] else {
        return None;
    };
    let Distance { vector, length } = distance::distance(names, row, coordinates)?;
    let vector: [Ex<'m>; 2] = vector.try_into().ok()?;
    length.is_fixed().then(|| Side {
        index,
        vector: Vector(vector),
        length,
        contained: equations::incidence(names, equation, coordinates),
    })
}

/// Three sides as a triangle, if one of them is the sum or the difference of the others.
fn closed<'m>(sides: [&Side<'m>; 3]) -> Option<Triangle<'m>> {
    let [a, b, c] = sides;
    let count = |k: &usize| {
        sides
            .iter()
            .filter(|side| side.contained.contains(k))
            .count()
    };
    let mut all = sides.iter().flat_map(|side| &side.contained);
    if !all.all(|k| count(k) > 1) {
        return None;
    }
    [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)]
        .into_iter()
        .find_map(|(first, second)| {
            let signed = |sign: f64, side: &Side<'m>| side.vector.map(|x| x.number(sign) * x);
            let vectors = [signed(first, a), signed(second, b), c.vector];
            let sum = vectors[0] + vectors[1];
            let is_closed = (0..2).all(|k| numerically_equal(sum[k], c.vector[k]));
            is_closed.then(|| Triangle {
                indices: sides.map(|side| side.index),
                vectors,
                lengths: sides.map(|side| side.length),
            })
        })
}
