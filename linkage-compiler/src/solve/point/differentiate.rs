//! What differentiation needs of a point on spheres and planes.

use crate::algebra::elimination;
use linkage_symbolic::{Ex, SymbolId, V3, Vector};

use crate::algebra::{CoreRow, Elimination, Solution, Term};
use crate::solve::Solver;
use crate::solve::plane::guarded;
use crate::structure::Plane;

use super::{Ball, Place};

/// Coefficients and factors of one equation.
type Row<'m> = Vec<(Ex<'m>, Ex<'m>)>;

/// Records what differentiation needs. `volume` is the determinant of the first sphere's arm and the normals, scaled.
///
/// The equations are the first sphere's and how the others differ from it: three nearly equal rows would cancel. They are
/// multiplied by the scale, so that the matrix consists of scaled lengths.
pub(super) fn push_point<'m>(
    solver: &mut Solver<'_, 'm>,
    coordinates: &[(SymbolId, usize)],
    planes: &[Plane<'m>],
    balls: &[Ball<'m>],
    place: &Place<'m>,
    volume: Ex<'m>,
) {
    let count = coordinates.len();
    let (zero, one) = (solver.algebra.zero(), solver.algebra.one());
    let symbols = coordinates
        .iter()
        .map(|(symbol, _)| solver.unknown(*symbol));
    let point: Vec<Ex> = symbols.collect();
    let first = Vector([0, 1, 2].map(|k| {
        let value = guarded(place.arm[k], place.h);
        let moved = coordinates.iter().zip(&point).find(|((_, c), _)| *c == k);
        let moved = moved.map_or(zero, |(_, &p)| p);
        let equal = place.scale * (moved - balls[0].centre[k]);
        solver.alias("leg", value, equal)
    }));
    let mut rows = vec![(sphere_terms(first, &balls[0]), first, one)];
    for ball in &balls[1..] {
        let terms = difference_terms(first - ball.apart, &balls[0], ball);
        rows.push((terms, ball.apart, one));
    }
    for plane in planes {
        let mut terms = vec![(plane.offset, one)];
        for (&(_, k), &coordinate) in coordinates.iter().zip(&point) {
            terms.push((plane.normal[k], coordinate));
        }
        let (length, _) = plane.normal.length_and_unit();
        rows.push((terms, plane.normal, one / length));
    }

    let mut terms = Vec::new();
    let mut jacobian = vec![vec![zero; count]; count];
    let mut core = Vec::new();
    let mut matrix = Vec::new();
    for (row, (own, slope, factor)) in rows.into_iter().enumerate() {
        terms.extend(own.into_iter().map(|(own, factor)| {
            let mut coefficient = vec![zero; count];
            coefficient[row] = own;
            Term {
                coefficient,
                factor,
            }
        }));
        for (column, &(_, k)) in coordinates.iter().enumerate() {
            jacobian[column][row] = slope[k];
        }
        let entries = coordinates.iter().map(|&(_, k)| factor * slope[k]);
        matrix.push(entries.collect());
        core.push(CoreRow {
            first: row,
            factors: vec![factor],
        });
    }
    // With two coordinates the third row is an axis.
    let missing = (0..3).find(|k| coordinates.iter().all(|(_, component)| component != k));
    let value = match missing {
        Some(1) => -volume,
        _ => volume,
    };
    let product = elimination::determinant(solver.algebra, &matrix);
    let determinant = solver.alias("det", value, product);
    solver.push_solution(Solution {
        terms,
        jacobian,
        determinant,
        elimination: Some(Elimination {
            rows: core,
            matrix,
            units: vec![one; count],
            privates: Vec::new(),
            scheme: None,
        }),
        links: [None; 2],
        rod: None,
        rows: Vec::new(),
    });
}

/// `((p - c).(p - c) - r^2)/2`
fn sphere_terms<'m>(leg: V3<'m>, ball: &Ball<'m>) -> Row<'m> {
    let mut terms: Row = (0..3).map(|k| (ball.centre[k], -leg[k])).collect();
    terms.push((ball.radius, -ball.scaled));
    terms
}

/// `a . (p - c) - (a . a + r^2 - r'^2)/2`, where `a` leads from the first sphere's centre `c` to that of the other.
fn difference_terms<'m>(leg: V3<'m>, base: &Ball<'m>, ball: &Ball<'m>) -> Row<'m> {
    let mut terms = Row::new();
    for k in 0..3 {
        terms.push((ball.centre[k] - base.centre[k], leg[k]));
        terms.push((base.centre[k], -ball.apart[k]));
    }
    terms.push((base.radius, -base.scaled));
    terms.push((ball.radius, ball.scaled));
    terms
}
