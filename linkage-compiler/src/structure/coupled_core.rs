//! Loops that must be solved together: class III and higher.
//!
//! A loop that alone contains some angle or slide gives that *private* unknown once the others are known, and one
//! equation without it: a link keeps its length, or a point stays on its guide. What remains are the *core* unknowns, two for a
//! triad, whatever its joints.

use crate::structure::class;
use crate::structure::classify;
use crate::structure::core_unknowns;
use crate::structure::equations;
use crate::structure::product;
use linkage_symbolic::{Ex, SymbolId, V2, V3, Vector, substitute};

use super::classify::Polynomials;
use super::core_unknowns::paired;
use super::distance_polynomials::Link;
use super::equations::{Coordinate, CoordinateKind, Equation};
use super::{Analysis, Form, Rotor};

/// Of more core unknowns than this the assemblies are not listed, a work that grows without bound: one is followed from its estimates.
const MOST_LISTED: usize = 6;

/// More core unknowns than this, those of four bodies, are refused: the operations of a step grow with the cube, two bodies on rods take a thousand.
pub(super) const MOST_CORE: usize = 36;

/// A coupled group.
#[derive(Clone, Debug)]
pub(crate) struct Coupled<'m> {
    /// `RR-RR-PR`, or a general word.
    pub(crate) kind: String,
    pub(crate) class: u8,
    pub(crate) order: u8,
    pub(crate) blocks: Vec<Block<'m>>,
    pub(crate) core: Vec<Core>,
}

impl Coupled<'_> {
    /// Whether its assemblies can be too many to be listed, and its matrix too large for cofactors.
    pub(crate) fn is_large(&self) -> bool {
        self.core.len() > MOST_LISTED
    }
}

/// One loop of a coupled group.
#[derive(Clone, Debug)]
pub(crate) struct Block<'m> {
    /// Each row is 0.
    pub(crate) rows: Vec<Ex<'m>>,
    /// The rows without the private unknown.
    pub(crate) rest: Vec<Ex<'m>>,
    pub(crate) private: Option<Private<'m>>,
    /// The rows as polynomials.
    pub(crate) terms: Vec<Product<'m>>,
    /// A link in space, if the row is about the square of its vector.
    pub(crate) distance: Option<Link<'m>>,
    /// The factors of a row in space that is their scalar product, or its negative, but for what is known.
    pub(crate) product: Option<[V3<'m>; 2]>,
    /// Whether it is about numbers, as those of directions are.
    pub(crate) number: bool,
}

impl Block<'_> {
    /// True if its rows are lengths: what a scalar loop is, nobody knows.
    pub(crate) fn is_length(&self) -> bool {
        !self.number && (self.rows.len() > 1 || self.distance.is_some())
    }
}

/// A product of unknowns with one coefficient for each row.
#[derive(Clone, Debug)]
pub(crate) struct Product<'m> {
    pub(crate) coefficient: Vec<Ex<'m>>,
    /// Symbols and their exponents, which are not 0.
    pub(crate) powers: Vec<(SymbolId, u8)>,
}

/// The unknown that a loop of two rows contains alone.
#[derive(Clone, Debug)]
pub(crate) enum Private<'m> {
    /// A link of fixed length.
    Rotor(Rotor<'m>),
    /// A slide; the guide may turn with unknowns of the core.
    Slide { slide: SymbolId, guide: V2<'m> },
}

/// An unknown of the core.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Core {
    Angle(usize),
    /// A slide or a component of a point.
    Length {
        symbol: SymbolId,
        /// Whether it is a number and no length: a component of a direction.
        number: bool,
        /// 0 or 1 if both components of a point are in the core.
        component: Option<usize>,
    },
}

/// What is known of one coordinate in one loop.
struct Place<'p, 'm> {
    polynomials: &'p Polynomials<'m>,
    /// The first symbol of the coordinate among those of the polynomials.
    first: usize,
    coordinate: &'p Coordinate,
}

/// The form of loops that remain coupled, if they are polynomials in their unknowns.
pub(super) fn coupled<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<Form<'m>> {
    let polynomials = equations
        .iter()
        .map(|equation| classify::polynomials(analysis, &equation.rows, coordinates))
        .collect::<Option<Vec<_>>>()?;
    let values_free = coordinates.iter().enumerate().all(|(k, coordinate)| {
        let first = first_symbol(analysis, coordinates, k);
        !matches!(coordinate.kind, CoordinateKind::Angle(_))
            || polynomials.iter().all(|p| !p.mention(first + 2))
    });
    if !values_free {
        return None;
    }
    let (private, core) = private_and_core(analysis, &polynomials, coordinates);
    if core.len() > MOST_CORE {
        return None;
    }
    let (class, order, contour) = class::class_and_order(analysis, &polynomials, coordinates);
    let mut kind = class::kind(
        analysis,
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
        block(analysis, equation, polynomials, private, coordinates)
    });
    let blocks = blocks.collect();
    let core = core
        .into_iter()
        .map(|k| core_unknowns::of_core(analysis, &coordinates[k]))
        .collect();
    Some(Form::Coupled(Box::new(Coupled {
        kind,
        class,
        order,
        blocks,
        core: paired(core),
    })))
}

/// The unknowns that one loop alone contains, by loop with their coordinate, and the coordinates that remain.
pub(super) fn private_and_core<'m>(
    analysis: &mut Analysis<'_, 'm>,
    polynomials: &[Polynomials<'m>],
    coordinates: &[Coordinate],
) -> (Vec<Option<(Private<'m>, usize)>>, Vec<usize>) {
    let mut privates = vec![None; polynomials.len()];
    let mut core = Vec::new();
    for (k, coordinate) in coordinates.iter().enumerate() {
        let first = first_symbol(analysis, coordinates, k);
        let width = equations::symbols(analysis, coordinate).len();
        let with: Vec<usize> = (0..polynomials.len())
            .filter(|&e| (first..first + width).any(|s| polynomials[e].mention(s)))
            .collect();
        if let [only] = with[..]
            && privates[only].is_none()
            && let Some(found) = private(
                analysis,
                Place {
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

/// The place of a coordinate's first symbol among the symbols of polynomials.
pub(super) fn first_symbol(
    analysis: &Analysis<'_, '_>,
    coordinates: &[Coordinate],
    index: usize,
) -> usize {
    let before = coordinates[..index].iter();
    before.map(|c| equations::symbols(analysis, c).len()).sum()
}

/// A coordinate as the private unknown of a loop, if the loop can be solved for it.
fn private<'m>(analysis: &mut Analysis<'_, 'm>, place: Place<'_, 'm>) -> Option<Private<'m>> {
    let Place {
        polynomials,
        first,
        coordinate,
    } = place;
    if polynomials.rows.len() != 2 {
        return None;
    }
    match coordinate.kind {
        CoordinateKind::Angle(angle) => {
            let mut rest = polynomials.clone();
            let rotor = classify::take_rotor(analysis, &mut rest, angle, &[])?;
            let gone = !rest.mention(first) && !rest.mention(first + 1);
            (gone && !rotor.z.is_zero()).then_some(Private::Rotor(rotor))
        }
        CoordinateKind::Length(slide) => {
            let mut guide = Vector([analysis.algebra.zero(); 2]);
            for (row, sum) in polynomials.rows.iter().zip(&mut guide.0) {
                for (monomial, &coefficient) in row {
                    match monomial[first] {
                        0 => continue,
                        1 => {}
                        _ => return None,
                    }
                    let mut others = monomial.clone();
                    others[first] = 0;
                    let factor = product_of_powers(analysis, polynomials.powers(&others));
                    *sum += coefficient * factor;
                }
            }
            (!guide.is_zero()).then_some(Private::Slide { slide, guide })
        }
    }
}

fn product_of_powers<'m>(analysis: &Analysis<'_, 'm>, powers: Vec<(SymbolId, u8)>) -> Ex<'m> {
    let graph = analysis.algebra.graph;
    let mut product = analysis.algebra.one();
    for (symbol, power) in powers {
        for _ in 0..power {
            let factor = graph.ex(graph.symbol_node(symbol));
            product = product * factor;
        }
    }
    product
}

fn block<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equation: &Equation<'m>,
    polynomials: &Polynomials<'m>,
    private: Option<Private<'m>>,
    coordinates: &[Coordinate],
) -> Block<'m> {
    let zero = analysis.algebra.zero();
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
    let own: Vec<SymbolId> = match &private {
        Some(Private::Rotor(rotor)) => {
            let angle = &analysis.algebra.names.angles[rotor.angle];
            vec![angle.cos, angle.sin]
        }
        Some(Private::Slide { slide, .. }) => vec![*slide],
        None => Vec::new(),
    };
    let product = match equation.rows[..] {
        [row] => product::product(analysis, row, coordinates),
        _ => None,
    };
    let removed = own.into_iter().map(|symbol| (symbol, zero)).collect();
    Block {
        terms: terms.collect(),
        rest: substitute(&equation.rows, &removed),
        rows: equation.rows.clone(),
        private,
        distance: equation.distance.clone(),
        product,
        number: core_unknowns::is_number_loop(analysis, equation.written),
    }
}
