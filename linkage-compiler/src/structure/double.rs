//! An angle of which only products of two of cosine and sine occur: vectors turn with its double,
//! which is solved for.

use linkage_symbolic::{Ex, V2, collect};

use crate::algebra::names::Names;
use crate::algebra::{Atom, StandsFor, scalar};
use crate::structure::distance::Distance;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation, System};
use crate::structure::reductions::Reductions;
use crate::structure::{classify, distance, explicit, polynomials};

/// An angle that turns vectors twice as fast only: they turn with its double, which is solved for.
pub(crate) fn double_angle<'m>(
    names: &mut Names<'m>,
    reductions: &mut Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    let [equation] = equations else { return None };
    by_double_angle(names, reductions, equation, coordinates)
}

/// A distance between points that go around one centre on ellipses, as the foot of scissors and a
/// point of an arm: its square contains products of two of cosine and sine only.
pub(crate) fn distance_of_double_angle<'m>(
    names: &mut Names<'m>,
    reductions: &mut Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    let ([equation], [_]) = (equations, coordinates) else {
        return None;
    };
    let &[row] = &equation.rows[..] else {
        return None;
    };
    let Distance { vector, length } = distance::distance(names, row, coordinates)?;
    let polynomials = polynomials::polynomials(names, &vector, coordinates)?;
    let mut monomials = polynomials.rows.iter().flat_map(|row| row.keys());
    if !monomials.all(|powers| powers.iter().sum::<u8>() == 1) {
        return None;
    }
    let zero = names.zero();
    let square = vector.iter().fold(zero, |sum, x| sum + x.square());
    let squared = Equation {
        rows: vec![0.5 * (square / length - length)],
        relation: None,
        ..equation.clone()
    };
    by_double_angle(names, reductions, &squared, coordinates)
}

fn by_double_angle<'m>(
    names: &mut Names<'m>,
    reductions: &mut Reductions<'m>,
    equation: &Equation<'m>,
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    for (index, coordinate) in coordinates.iter().enumerate() {
        let CoordinateKind::Angle(half) = coordinate.kind else {
            continue;
        };
        let Some(rows) = squares_of(names, half, equation) else {
            continue;
        };
        let double = names.add_angle("double", None);
        let angle = &names.angles[half];
        let summands = angle.summands().into_iter();
        let summands = summands
            .map(|(unknown, sign)| (unknown, 2.0 * sign))
            .collect();
        let stands_for = angle.meant().map(|unknown| StandsFor { unknown, summands });
        names.angles[double].stands_for = stands_for;
        let unit = names.angles[double].unit;
        let rows = rows.into_iter().map(|row| row.turned_with(unit));
        let mut changed = Equation {
            rows: rows.collect(),
            relation: None,
            ..equation.clone()
        };
        changed.eliminated.extend(coordinate.unknown);
        let mut coordinates = coordinates.to_vec();
        coordinates[index] = Coordinate {
            kind: CoordinateKind::Angle(double),
            unknown: None,
        };
        if classify::classify(names, &changed, &coordinates).is_some() {
            let value = scalar::atom(names.graph, Atom::Angle(double)).scaled(0.5);
            explicit::replace_angle(names, reductions, half, &value);
            return Some((vec![changed], coordinates));
        }
    }
    None
}

/// The rows of an equation, if they contain nothing of an angle but products of two of its cosine
/// and sine.
fn squares_of<'m>(
    names: &Names<'m>,
    angle: usize,
    equation: &Equation<'m>,
) -> Option<Vec<SquaresOf<'m>>> {
    let angle = &names.angles[angle];
    let symbols = angle.symbols();
    let zero = names.zero();
    let rows = equation.rows.iter().map(|&row| {
        let mut terms = collect(row, &symbols, &[])?;
        let mut take = |cos, sin| terms.remove(&vec![cos, sin, 0]).unwrap_or(zero);
        let squares = SquaresOf {
            cosine: take(2, 0),
            sine: take(0, 2),
            product: take(1, 1),
            rest: take(0, 0),
        };
        terms.is_empty().then_some(squares)
    });
    let rows: Vec<SquaresOf> = rows.collect::<Option<_>>()?;
    let turns = rows
        .iter()
        .any(|row| !row.product.is_zero() || row.cosine != row.sine);
    turns.then_some(rows)
}

/// `cosine c^2 + sine s^2 + product c s + rest`
struct SquaresOf<'m> {
    cosine: Ex<'m>,
    sine: Ex<'m>,
    product: Ex<'m>,
    rest: Ex<'m>,
}

impl<'m> SquaresOf<'m> {
    /// The same by cosine and sine of the double angle.
    fn turned_with(&self, unit: V2<'m>) -> Ex<'m> {
        let [cos, sin] = unit.0;
        let (sum, difference) = (self.cosine + self.sine, self.cosine - self.sine);
        0.5 * difference * cos + 0.5 * self.product * sin + (self.rest + 0.5 * sum)
    }
}
