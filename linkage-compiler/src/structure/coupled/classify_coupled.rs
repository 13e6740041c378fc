//! Loops that must be solved together: class III and higher.
//!
//! A loop that alone contains some angle or slide gives that *private* unknown once the others are
//! known, and one equation without it: a link keeps its length, or a point stays on its guide. The
//! rest are the *core* unknowns, two for a triad, whatever its joints.

use linkage_symbolic::{SymbolId, Vector, substitute};

use crate::algebra::names::Names;
use crate::structure::coupled::group::{Block, Coupled, Private, Product};
use crate::structure::coupled::{class, core_unknowns, scalar_product};
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::form::Form;
use crate::structure::polynomials::Polynomials;
use crate::structure::{equations, polynomials};

/// More core unknowns than this, those of four bodies, are refused: the operations of a step grow
/// with the cube, two bodies on rods take a thousand.
pub(crate) const MOST_CORE: usize = 36;

/// A coordinate with its terms in one loop.
struct CoordinateInLoop<'p, 'm> {
    polynomials: &'p Polynomials<'m>,
    /// The first symbol of the coordinate among those of the polynomials.
    first: usize,
    coordinate: &'p Coordinate,
}

/// The form of loops that remain coupled, if they are polynomials in their unknowns.
pub(crate) fn classify_coupled<'m>(
    names: &Names<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<Form<'m>> {
    let polynomials = equations
        .iter()
        .map(|equation| polynomials::polynomials(names, &equation.rows, coordinates))
        .collect::<Option<Vec<_>>>()?;
    let values_free = coordinates.iter().enumerate().all(|(k, coordinate)| {
        let first = polynomials::first_symbol(names, coordinates, k);
        !matches!(coordinate.kind, CoordinateKind::Angle(_))
            || polynomials.iter().all(|p| !p.mention(first + 2))
    });
    if !values_free {
        return None;
    }
    let (private, core) = private_and_core(names, &polynomials, coordinates);
    if core.len() > MOST_CORE {
        return None;
    }
    let (class, order, contour) = class::class_and_order(names, &polynomials, coordinates);
    let mut kind = class::kind_of_group(
        names,
        &private,
        &polynomials,
        coordinates,
        &core,
        class,
        contour,
    );
    let in_space = equations
        .iter()
        .any(|e| e.rows.len() == 3 || e.distance.is_some());
    // Class and order are notions of the plane.
    let (class, order) = if in_space { (0, 0) } else { (class, order) };
    if in_space {
        kind = match equations.len() {
            1 => "loop in space".to_owned(),
            count => format!("{count} loops in space"),
        };
    }
    let blocks = equations.iter().zip(&polynomials).zip(private);
    let blocks = blocks.map(|((equation, polynomials), private)| {
        let private = private.map(|(private, _)| private);
        block(names, equation, polynomials, private, coordinates)
    });
    let blocks = blocks.collect();
    let core = core
        .into_iter()
        .map(|k| core_unknowns::core_unknown(names.mechanism, &coordinates[k]))
        .collect();
    Some(Form::Coupled(Box::new(Coupled {
        kind,
        class,
        order,
        blocks,
        core: core_unknowns::with_paired_components(core),
    })))
}

/// The unknowns that one loop alone contains, by loop with their coordinate, and the coordinates
/// that remain.
pub(crate) fn private_and_core<'m>(
    names: &Names<'m>,
    polynomials: &[Polynomials<'m>],
    coordinates: &[Coordinate],
) -> (Vec<Option<(Private<'m>, usize)>>, Vec<usize>) {
    let mut privates = vec![None; polynomials.len()];
    let mut core = Vec::new();
    for (k, coordinate) in coordinates.iter().enumerate() {
        let first = polynomials::first_symbol(names, coordinates, k);
        let width = equations::symbols(names, coordinate).len();
        let with: Vec<usize> = (0..polynomials.len())
            .filter(|&e| (first..first + width).any(|s| polynomials[e].mention(s)))
            .collect();
        if let [only] = with[..]
            && privates[only].is_none()
            && let Some(found) = private_unknown(
                names,
                CoordinateInLoop {
                    polynomials: &polynomials[only],
                    first,
                    coordinate,
                },
            )
        {
            privates[only] = Some((found, k));
            continue;
        }
        core.push(k);
    }
    (privates, core)
}

/// A coordinate as the private unknown of a loop, if the loop can be solved for it.
fn private_unknown<'m>(
    names: &Names<'m>,
    coordinate: CoordinateInLoop<'_, 'm>,
) -> Option<Private<'m>> {
    let CoordinateInLoop {
        polynomials,
        first,
        coordinate,
    } = coordinate;
    if polynomials.rows.len() != 2 {
        return None;
    }
    match coordinate.kind {
        CoordinateKind::Angle(angle) => {
            let mut rest = polynomials.clone();
            let rotor = polynomials::take_rotor(names, &mut rest, angle, &[])?;
            let gone = !rest.mention(first) && !rest.mention(first + 1);
            (gone && !rotor.z.is_zero()).then_some(Private::Rotor(rotor))
        }
        CoordinateKind::Length(slide) => {
            let guide = Vector(polynomials.slope(names.graph, first)?.try_into().ok()?);
            (!guide.is_zero()).then_some(Private::Slide { slide, guide })
        }
    }
}

fn block<'m>(
    names: &Names<'m>,
    equation: &Equation<'m>,
    polynomials: &Polynomials<'m>,
    private: Option<Private<'m>>,
    coordinates: &[Coordinate],
) -> Block<'m> {
    let zero = names.zero();
    let mut monomials: Vec<_> = polynomials.rows.iter().flat_map(|row| row.keys()).collect();
    monomials.sort();
    monomials.dedup();
    let terms = monomials.into_iter().map(|monomial| Product {
        coefficient: polynomials
            .rows
            .iter()
            .map(|row| row.get(monomial).copied().unwrap_or(zero))
            .collect(),
        powers: polynomials.powers(monomial),
    });
    let symbols: Vec<SymbolId> = match &private {
        Some(Private::Rotor(rotor)) => {
            let angle = &names.angles[rotor.angle];
            vec![angle.cos, angle.sin]
        }
        Some(Private::Slide { slide, .. }) => vec![*slide],
        None => Vec::new(),
    };
    let product = match equation.rows[..] {
        [row] => scalar_product::scalar_product(names, row, coordinates),
        _ => None,
    };
    let removed = symbols.into_iter().map(|symbol| (symbol, zero)).collect();
    Block {
        terms: terms.collect(),
        rest: substitute(&equation.rows, &removed),
        rows: equation.rows.clone(),
        private,
        distance: equation.distance.clone(),
        product,
        number: core_unknowns::is_number_loop(names.mechanism, equation.written),
        between_lengths: core_unknowns::is_length_loop(names.mechanism, equation.written),
    }
}
