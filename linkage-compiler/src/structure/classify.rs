//! Recognising a group by its mathematics: its loop as a polynomial in its unknowns.

use linkage_symbolic::{Ex, Graph, SymbolId, Vector};

use crate::algebra::names::Names;
use crate::structure::distance::Distance;
use crate::structure::elements::Rotor;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::form::Form;
use crate::structure::parallel_direction::Parallel;
use crate::structure::polynomials::Polynomials;
use crate::structure::{distance, explicit, parallel_direction, polynomials, space};

/// The form in which one equation is solved for all its coordinates, if it has one of the known
/// forms.
pub(crate) fn classify<'m>(
    names: &Names<'m>,
    equation: &Equation<'m>,
    coordinates: &[Coordinate],
) -> Option<Form<'m>> {
    use CoordinateKind::{Angle, Length};
    if let ([coordinate], 1) = (coordinates, equation.rows.len()) {
        return classify_scalar(names, equation, coordinate);
    }
    if equation.rows.len() == 3 {
        return space::classify_three_slides(names.graph, equation, coordinates);
    }
    if equation.rows.len() != 2 || coordinates.len() != 2 {
        return None;
    }
    let polynomials = polynomials::polynomials(names, &equation.rows, coordinates)?;
    match (coordinates[0].kind, coordinates[1].kind) {
        (Angle(first), Angle(second)) => two_rotors(names, polynomials, first, second),
        (Angle(angle), Length(slide)) | (Length(slide), Angle(angle)) => {
            rotor_and_slide(names, polynomials, angle, slide)
        }
        (Length(first), Length(second)) => two_slides(names.graph, polynomials, [first, second]),
    }
}

fn two_rotors<'m>(
    names: &Names<'m>,
    mut rest: Polynomials<'m>,
    first: usize,
    second: usize,
) -> Option<Form<'m>> {
    let first = polynomials::take_rotor(names, &mut rest, first, &[])?;
    let second = polynomials::take_rotor(names, &mut rest, second, &[])?;
    let zero = names.zero();
    let known = rest.take_pair(&[], zero);
    let complete = rest.is_exhausted() && !first.z.is_zero() && !second.z.is_zero();
    complete.then_some(Form::TwoRotors {
        first,
        second,
        known,
    })
}

fn rotor_and_slide<'m>(
    names: &Names<'m>,
    mut rest: Polynomials<'m>,
    angle: usize,
    slide: SymbolId,
) -> Option<Form<'m>> {
    let zero = names.zero();
    let rotor = polynomials::take_rotor(names, &mut rest, angle, &[])?;
    let moving = polynomials::take_rotor(names, &mut rest, angle, &[slide])?;
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
    graph: &'m Graph,
    mut rest: Polynomials<'m>,
    slides: [SymbolId; 2],
) -> Option<Form<'m>> {
    let zero = graph.number(0.0);
    let guides = slides.map(|slide| rest.take_pair(&[slide], zero));
    let known = rest.take_pair(&[], zero);
    rest.is_exhausted().then_some(Form::TwoSlides {
        slides,
        guides,
        known,
    })
}

/// True for a distance in the plane from a point that turns with an angle or slides along a line: a
/// link, whether its length or the square of it is given.
fn is_link<'m>(names: &Names<'m>, row: Ex<'m>, coordinate: &Coordinate) -> bool {
    let coordinates = std::slice::from_ref(coordinate);
    let Some(Distance { vector, length }) = distance::distance(names, row, coordinates) else {
        return false;
    };
    if vector.len() != 2 || length.is_zero() {
        return false;
    }
    let Some(mut rest) = polynomials::polynomials(names, &vector, coordinates) else {
        return false;
    };
    let zero = names.zero();
    let moving = match coordinate.kind {
        CoordinateKind::Angle(angle) => {
            let rotor = polynomials::take_rotor(names, &mut rest, angle, &[]);
            rotor.map(|rotor| rotor.z)
        }
        CoordinateKind::Length(slide) => Some(rest.take_pair(&[slide], zero)),
    };
    rest.take_pair(&[], zero);
    rest.is_exhausted() && moving.is_some_and(|vector| !vector.is_zero())
}

/// `a cos + b sin + c = 0` with `c = 0`, if the angle is then that of a direction that turns with
/// known angles.
fn along_direction<'m>(names: &Names<'m>, [a, b, c]: [Ex<'m>; 3]) -> Option<Parallel<'m>> {
    c.is_zero()
        .then(|| parallel_direction::parallel_direction(names, Vector([b, -a])))?
}

fn classify_scalar<'m>(
    names: &Names<'m>,
    equation: &Equation<'m>,
    coordinate: &Coordinate,
) -> Option<Form<'m>> {
    if let CoordinateKind::Angle(angle) = coordinate.kind
        && let Some(value) = explicit::solved_relation(names, equation, angle)
    {
        return Some(Form::Relation { angle, value });
    }
    if let Some(form) = space::classify_distance(names, equation.rows[0], coordinate) {
        return Some(form);
    }
    if is_link(names, equation.rows[0], coordinate) {
        // Squares have another solution with another margin, less accurate where the link meets
        // others at a needle's angle.
        return None;
    }
    let mut rest =
        polynomials::polynomials(names, &equation.rows, std::slice::from_ref(coordinate))?;
    if let CoordinateKind::Angle(_) = coordinate.kind {
        polynomials::drop_cancelled(names.graph, &mut rest);
    }
    let zero = names.zero();
    let mut take = |symbols: &[SymbolId]| rest.take(symbols, zero)[0];
    let form = match coordinate.kind {
        CoordinateKind::Angle(angle) => {
            let symbols = names.angles[angle].clone();
            let (a, b) = (take(&[symbols.cos]), take(&[symbols.sin]));
            let (factor, c) = (take(&[symbols.value]), take(&[]));
            match (a.is_zero() && b.is_zero(), factor.is_zero()) {
                (true, false) => {
                    let value = (-(c / factor)).into();
                    Form::Relation { angle, value }
                }
                (false, true) => match along_direction(names, [a, b, c]) {
                    Some(Parallel { value, arm }) => Form::Parallel { angle, value, arm },
                    None => Form::Trigonometric { angle, a, b, c },
                },
                _ => return None,
            }
        }
        CoordinateKind::Length(symbol) => {
            let (a, b) = (take(&[symbol, symbol]), take(&[symbol]));
            let c = take(&[]);
            if a.is_zero() {
                Form::Linear { symbol, a: b, b: c }
            } else {
                Form::Quadratic { symbol, a, b, c }
            }
        }
    };
    rest.is_exhausted().then_some(form)
}
