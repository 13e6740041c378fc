//! Recognising a group by its mathematics: its loop as a polynomial in its unknowns.

use crate::structure::eliminate;
use crate::structure::equations;
use crate::structure::space;
use linkage_symbolic::{
    Ex, Polynomial, SymbolId, V2, V3, Vector, collect, numerically_equal, numerically_equal_within,
};

use super::equations::{Coordinate, CoordinateKind, Equation};
use super::space::Distance;
use super::{Analysis, Form, Rotor};

/// Coefficients below this share of the others are rounding.
const NEGLIGIBLE: f64 = 1e-14;

/// The equations of a group as polynomials in the symbols of its coordinates.
#[derive(Clone, Debug)]
pub(super) struct Polynomials<'m> {
    pub(super) rows: Vec<Polynomial<'m>>,
    symbols: Vec<SymbolId>,
}

impl<'m> Polynomials<'m> {
    fn monomial(&self, symbols: &[SymbolId]) -> Vec<u8> {
        let mut exponents = vec![0; self.symbols.len()];
        for symbol in symbols {
            if let Some(place) = self.symbols.iter().position(|s| s == symbol) {
                exponents[place] += 1;
            }
        }
        exponents
    }

    /// Removes and returns the coefficients of a product of symbols, one for each row; 0 where there is none.
    fn take(&mut self, symbols: &[SymbolId], zero: Ex<'m>) -> Vec<Ex<'m>> {
        let monomial = self.monomial(symbols);
        self.rows
            .iter_mut()
            .map(|row| row.remove(&monomial).unwrap_or(zero))
            .collect()
    }

    fn take_pair(&mut self, symbols: &[SymbolId], zero: Ex<'m>) -> V2<'m> {
        let pair = self.take(symbols, zero);
        Vector([pair[0], pair[1]])
    }

    pub(super) fn take_space(&mut self, symbols: &[SymbolId], zero: Ex<'m>) -> V3<'m> {
        let taken = self.take(symbols, zero);
        Vector([taken[0], taken[1], taken[2]])
    }

    /// True if a term contains the symbol at `place`.
    pub(super) fn mention(&self, place: usize) -> bool {
        let mut monomials = self.rows.iter().flat_map(|row| row.keys());
        monomials.any(|monomial| monomial[place] > 0)
    }

    /// A monomial as powers of symbols.
    pub(super) fn powers(&self, monomial: &[u8]) -> Vec<(SymbolId, u8)> {
        let all = self.symbols.iter().copied().zip(monomial.iter().copied());
        all.filter(|&(_, power)| power > 0).collect()
    }

    /// True if every term has been taken.
    pub(super) fn is_exhausted(&self) -> bool {
        self.rows.iter().all(Polynomial::is_empty)
    }
}

/// The rows of an equation as polynomials in coordinates; `None` if they are none (a square root, an angle's value).
pub(super) fn polynomials<'m>(
    analysis: &mut Analysis<'_, 'm>,
    rows: &[Ex<'m>],
    coordinates: &[Coordinate],
) -> Option<Polynomials<'m>> {
    let mut symbols = Vec::new();
    let mut unit_pairs = Vec::new();
    for coordinate in coordinates {
        if let CoordinateKind::Angle(_) = coordinate.kind {
            unit_pairs.push((symbols.len(), symbols.len() + 1));
        }
        symbols.extend(equations::symbols(analysis, coordinate));
    }
    let rows = rows
        .iter()
        .map(|&row| collect(row, &symbols, &unit_pairs))
        .collect::<Option<Vec<Polynomial>>>()?;
    Some(Polynomials { rows, symbols })
}

/// Removes terms in a direction whose coefficients are 0 in a spelling that constructors do not see, or by rounding.
fn drop_cancelled<'m>(analysis: &Analysis<'_, 'm>, polynomials: &mut Polynomials<'m>) {
    let zero = analysis.algebra.zero();
    for row in &mut polynomials.rows {
        let squares = row.values().map(|coefficient| coefficient.square());
        let size = squares.fold(zero, |sum, square| sum + square).sqrt();
        row.retain(|_, coefficient| {
            let with = size + *coefficient;
            !numerically_equal(*coefficient, zero)
                && !numerically_equal_within(with, size, NEGLIGIBLE)
        });
    }
}

/// The form in which one equation is solved for all its coordinates, if it has one of the known forms.
pub(super) fn classify<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equation: &Equation<'m>,
    coordinates: &[Coordinate],
) -> Option<Form<'m>> {
    use CoordinateKind::{Angle, Length};
    if let ([coordinate], 1) = (coordinates, equation.rows.len()) {
        return classify_scalar(analysis, equation, coordinate);
    }
    if equation.rows.len() == 3 {
        return space::classify_three_slides(analysis, equation, coordinates);
    }
    if equation.rows.len() != 2 || coordinates.len() != 2 {
        return None;
    }
    let polynomials = polynomials(analysis, &equation.rows, coordinates)?;
    match (coordinates[0].kind, coordinates[1].kind) {
        (Angle(first), Angle(second)) => two_rotors(analysis, polynomials, first, second),
        (Angle(angle), Length(slide)) | (Length(slide), Angle(angle)) => {
            rotor_and_slide(analysis, polynomials, angle, slide)
        }
        (Length(first), Length(second)) => two_slides(analysis, polynomials, [first, second]),
    }
}

/// The terms with an angle's unit vector (times `with`), if they are a vector turning with it.
pub(super) fn take_rotor<'m>(
    analysis: &mut Analysis<'_, 'm>,
    polynomials: &mut Polynomials<'m>,
    index: usize,
    with: &[SymbolId],
) -> Option<Rotor<'m>> {
    let angle = &analysis.algebra.names.angles[index];
    let (cos, sin) = (angle.cos, angle.sin);
    let zero = analysis.algebra.zero();
    let along = polynomials.take_pair(&[&[cos], with].concat(), zero);
    let across = polynomials.take_pair(&[&[sin], with].concat(), zero);
    let perp = along.perp();
    let back = Vector([along[1], -along[0]]);
    let equal = |v: V2<'m>| (0..2).all(|k| numerically_equal(across[k], v[k]));
    let sense = match () {
        () if equal(perp) => 1.0,
        () if equal(back) => -1.0,
        () => return None,
    };
    Some(Rotor {
        angle: index,
        sense,
        z: along,
    })
}

fn two_rotors<'m>(
    analysis: &mut Analysis<'_, 'm>,
    mut rest: Polynomials<'m>,
    first: usize,
    second: usize,
) -> Option<Form<'m>> {
    let first = take_rotor(analysis, &mut rest, first, &[])?;
    let second = take_rotor(analysis, &mut rest, second, &[])?;
    let zero = analysis.algebra.zero();
    let known = rest.take_pair(&[], zero);
    let complete = rest.is_exhausted() && !first.z.is_zero() && !second.z.is_zero();
    complete.then_some(Form::TwoRotors {
        first,
        second,
        known,
    })
}

fn rotor_and_slide<'m>(
    analysis: &mut Analysis<'_, 'm>,
    mut rest: Polynomials<'m>,
    angle: usize,
    slide: SymbolId,
) -> Option<Form<'m>> {
    let zero = analysis.algebra.zero();
    let rotor = take_rotor(analysis, &mut rest, angle, &[])?;
    let moving = take_rotor(analysis, &mut rest, angle, &[slide])?;
    let fixed = rest.take_pair(&[slide], zero);
    let known = rest.take_pair(&[], zero);
    if !rest.is_exhausted() {
        return None;
    }
    match (fixed.is_zero(), moving.z.is_zero()) {
        (false, true) if !rotor.z.is_zero() => Some(Form::RotorAndSlide {
            rotor,
            slide,
            guide: fixed,
            known,
        }),
        (true, false) if rotor.z.is_zero() || moving.sense == rotor.sense => {
            let rotor = Rotor {
                z: rotor.z,
                ..moving.clone()
            };
            Some(Form::SlideOnRotor {
                rotor,
                slide,
                guide: moving.z,
                known,
            })
        }
        _ => None,
    }
}

fn two_slides<'m>(
    analysis: &mut Analysis<'_, 'm>,
    mut rest: Polynomials<'m>,
    slides: [SymbolId; 2],
) -> Option<Form<'m>> {
    let zero = analysis.algebra.zero();
    let guides = slides.map(|slide| rest.take_pair(&[slide], zero));
    let known = rest.take_pair(&[], zero);
    rest.is_exhausted().then_some(Form::TwoSlides {
        slides,
        guides,
        known,
    })
}

/// True for a distance in the plane from a point that turns with an angle or slides along a line: a link, whether its length or the square
/// of it is given.
fn is_link<'m>(analysis: &mut Analysis<'_, 'm>, row: Ex<'m>, coordinate: &Coordinate) -> bool {
    let own = std::slice::from_ref(coordinate);
    let Some(Distance { vector, length }) = space::distance(analysis, row, own) else {
        return false;
    };
    if vector.len() != 2 || length.is_zero() {
        return false;
    }
    let Some(mut rest) = polynomials(analysis, &vector, own) else {
        return false;
    };
    let zero = analysis.algebra.zero();
    let moving = match coordinate.kind {
        CoordinateKind::Angle(angle) => {
            let rotor = take_rotor(analysis, &mut rest, angle, &[]);
            rotor.map(|rotor| rotor.z)
        }
        CoordinateKind::Length(slide) => Some(rest.take_pair(&[slide], zero)),
    };
    rest.take_pair(&[], zero);
    rest.is_exhausted() && moving.is_some_and(|vector| !vector.is_zero())
}

fn classify_scalar<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equation: &Equation<'m>,
    coordinate: &Coordinate,
) -> Option<Form<'m>> {
    if let CoordinateKind::Angle(angle) = coordinate.kind
        && let Some(value) = eliminate::solved_relation(analysis, equation, angle)
    {
        return Some(Form::Relation { angle, value });
    }
    if let Some(form) = space::classify_distance(analysis, equation.rows[0], coordinate) {
        return Some(form);
    }
    if is_link(analysis, equation.rows[0], coordinate) {
        // As squares it has another solution with another margin, less accurate where the link meets others at a needle's angle.
        return None;
    }
    let mut rest = polynomials(analysis, &equation.rows, std::slice::from_ref(coordinate))?;
    if let CoordinateKind::Angle(_) = coordinate.kind {
        drop_cancelled(analysis, &mut rest);
    }
    let zero = analysis.algebra.zero();
    let mut take = |symbols: &[SymbolId]| rest.take(symbols, zero)[0];
    let form = match coordinate.kind {
        CoordinateKind::Angle(angle) => {
            let symbols = analysis.algebra.names.angles[angle].clone();
            let (a, b) = (take(&[symbols.cos]), take(&[symbols.sin]));
            let (factor, c) = (take(&[symbols.value]), take(&[]));
            match (a.is_zero() && b.is_zero(), factor.is_zero()) {
                (true, false) => {
                    let value = (-(c / factor)).into();
                    Form::Relation { angle, value }
                }
                (false, true) => Form::Trigonometric { angle, a, b, c },
                _ => return None,
            }
        }
        CoordinateKind::Length(symbol) => {
            let (a, b) = (take(&[symbol, symbol]), take(&[symbol]));
            let c = take(&[]);
            match a.is_zero() {
                true => Form::Linear { symbol, a: b, b: c },
                false => Form::Quadratic { symbol, a, b, c },
            }
        }
    };
    rest.is_exhausted().then_some(form)
}
