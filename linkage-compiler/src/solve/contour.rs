//! Loops of the plane that earlier groups close: they lead to one point in several ways.

use crate::algebra::dependence;
use linkage_symbolic::lookup::Map;

use linkage_symbolic::{Ex, Polynomial, SymbolId, V2, Vector, collect, substitute};

use crate::algebra::Algebra;
use crate::structure::{Core, Form, Private, Rotor};

use super::Solver;

/// So many loops behind a point double the ways to it each; behind more it is not known how far it can move.
const MOST_LOOPS: usize = 6;

/// What an earlier group says about points that hang on it.
#[derive(Debug)]
pub(super) struct Contour<'m> {
    /// A sum of vectors that is 0.
    loop_vector: V2<'m>,
    /// The terms with the group's unknowns, each of which any vector can do without; none for a coupled group.
    own: Vec<Own>,
    /// The symbols of the unknowns.
    symbols: Vec<SymbolId>,
}

/// A term with an unknown of the group.
#[derive(Debug)]
enum Own {
    /// What turns with an angle: cosine and sine.
    Turning([SymbolId; 2]),
    Slide(SymbolId),
    /// A slide along a guide that turns with an angle.
    SlideOn(SymbolId, [SymbolId; 2]),
}

impl<'m> Contour<'m> {
    /// `None` for what is no group of the plane with two unknowns, nor coupled.
    pub(super) fn of(form: &Form<'m>, solver: &Solver<'_, 'm>) -> Option<Self> {
        let symbols = |angle: usize| {
            let angle = &solver.algebra.names.angles[angle];
            [angle.cos, angle.sin]
        };
        let turned = |rotor: &Rotor<'m>| rotor.z.turned(solver.unit_of(rotor));
        let along = |slide: SymbolId, guide: V2<'m>| solver.unknown(slide) * guide;
        let (loop_vector, own) = match form {
            Form::TwoRotors {
                first,
                second,
                known,
            } => {
                let own = [first, second].map(|rotor| Own::Turning(symbols(rotor.angle)));
                (turned(first) + turned(second) + *known, own.into())
            }
            Form::RotorAndSlide {
                rotor,
                slide,
                guide,
                known,
            } => {
                let own = vec![Own::Turning(symbols(rotor.angle)), Own::Slide(*slide)];
                (turned(rotor) + along(*slide, *guide) + *known, own)
            }
            Form::SlideOnRotor {
                rotor,
                slide,
                guide,
                known,
            } => {
                let guide = guide.turned(solver.unit_of(rotor));
                let own = vec![Own::SlideOn(*slide, symbols(rotor.angle))];
                (turned(rotor) + along(*slide, guide) + *known, own)
            }
            Form::TwoSlides {
                slides,
                guides,
                known,
            } => {
                let [first, second] = [0, 1].map(|k| along(slides[k], guides[k]));
                (first + second + *known, slides.map(Own::Slide).into())
            }
            Form::Coupled(coupled) => {
                let private = coupled.blocks.iter().filter_map(|b| b.private.as_ref());
                let private = private.flat_map(|private| match private {
                    Private::Rotor(rotor) => symbols(rotor.angle).to_vec(),
                    Private::Slide { slide, .. } => vec![*slide],
                });
                let core = coupled.core.iter().flat_map(|core| match *core {
                    Core::Angle(angle) => symbols(angle).to_vec(),
                    Core::Length { symbol, .. } => vec![symbol],
                });
                return Some(Self {
                    loop_vector: Vector([solver.algebra.zero(); 2]),
                    own: Vec::new(),
                    symbols: private.chain(core).collect(),
                });
            }
            _ => return None,
        };
        let symbols = own.iter().flat_map(Own::symbols).collect();
        Some(Self {
            loop_vector,
            own,
            symbols,
        })
    }

    fn is_in(&self, all: impl IntoIterator<Item = SymbolId>) -> bool {
        let mut all = all.into_iter();
        all.any(|symbol| self.symbols.contains(&symbol))
    }
}

/// A vector without unknowns that are expressions of others, and of others again.
pub(super) fn without_explicit<'m>(solver: &Solver<'_, 'm>, vector: V2<'m>) -> V2<'m> {
    let [x, y] = substitute(&vector.0, solver.explicit)[..] else {
        unreachable!("as many as before");
    };
    let next = Vector([x, y]);
    match next == vector {
        true => vector,
        false => without_explicit(solver, multiplied_out(solver, next)),
    }
}

/// What turns forth and back with an angle does not turn: a link by an angle from another one, that one's way to its own angle.
fn multiplied_out<'m>(solver: &Solver<'_, 'm>, vector: V2<'m>) -> V2<'m> {
    let present = solver.algebra.graph.symbols_of(&vector.ids());
    let angles = solver.algebra.names.angles.iter();
    let angles =
        angles.filter(|angle| present.contains(&angle.cos) || present.contains(&angle.sin));
    let symbols: Vec<SymbolId> = angles.flat_map(|angle| [angle.cos, angle.sin]).collect();
    let pairs: Vec<(usize, usize)> = (0..symbols.len() / 2).map(|k| (2 * k, 2 * k + 1)).collect();
    vector.map(|x| match collect(x, &symbols, &pairs) {
        Some(polynomial) => sum(solver, &polynomial, &symbols),
        None => x,
    })
}

fn sum<'m>(solver: &Solver<'_, 'm>, polynomial: &Polynomial<'m>, symbols: &[SymbolId]) -> Ex<'m> {
    let terms = polynomial.iter().map(|(monomial, &coefficient)| {
        let powers = symbols.iter().zip(monomial);
        powers.fold(coefficient, |product, (&symbol, &power)| {
            (0..power).fold(product, |product, _| product * solver.unknown(symbol))
        })
    });
    terms.fold(solver.algebra.zero(), |sum, term| sum + term)
}

/// A vector, in all ways that lead around the loops of earlier groups: the way in which it is written is none of them by itself. Of each loop
/// one of its group's unknowns is got rid of, first of the last one. No way, where it hangs on a coupled group or on too many.
pub(super) fn ways_to<'m>(solver: &Solver<'_, 'm>, vector: V2<'m>) -> Vec<V2<'m>> {
    let below = dependence::symbols_below(solver.algebra, &vector.0);
    let contours: Vec<&Contour> = solver.contours.iter().collect();
    let behind = contours
        .iter()
        .filter(|contour| contour.is_in(below.iter().copied()));
    match behind.count() > MOST_LOOPS {
        true => Vec::new(),
        false => ways(solver.algebra, vector, &contours),
    }
}

fn ways<'m>(algebra: &Algebra<'m>, vector: V2<'m>, contours: &[&Contour<'m>]) -> Vec<V2<'m>> {
    let Some((last, before)) = contours.split_last() else {
        return vec![vector];
    };
    let nodes = vector.ids();
    if !last.is_in(algebra.graph.symbols_of(&nodes)) {
        return ways(algebra, vector, before);
    }
    let without = last.own.iter().filter_map(|own| {
        let [columns, loop_columns] = [vector, last.loop_vector].map(|vector| own.columns(vector));
        let ([c, d], [l, m]) = (columns?, loop_columns?);
        let [rest, loop_rest] = [vector, last.loop_vector].map(|vector| own.dropped(vector));
        // The columns of the loop are perpendicular and of one length.
        let square = l.square();
        let [x, y] = [l, m].map(|column| column.dot(loop_rest) / square);
        Some(rest - x * c - y * d)
    });
    without
        .flat_map(|vector| ways(algebra, vector, before))
        .collect()
}

impl Own {
    fn symbols(&self) -> Vec<SymbolId> {
        match *self {
            Self::Turning(angle) => angle.to_vec(),
            Self::Slide(slide) => vec![slide],
            Self::SlideOn(slide, [cos, sin]) => vec![slide, cos, sin],
        }
    }

    /// What cosine and sine, or a slide along a vector and across it, have for factors in a vector. `None` if it is no sum of such a term and
    /// of others, or if they are not fixed.
    fn columns<'m>(&self, vector: V2<'m>) -> Option<[V2<'m>; 2]> {
        let symbols = self.symbols();
        let rows = vector.0.map(|x| collect(x, &symbols, &[]));
        let [Some(x), Some(y)] = rows else {
            return None;
        };
        let rows = [x, y];
        let monomials: &[&[u8]] = match self {
            Self::Turning(_) => &[&[1, 0], &[0, 1]],
            Self::Slide(_) => &[&[1]],
            Self::SlideOn(..) => &[&[1, 1, 0], &[1, 0, 1]],
        };
        let is_own = |monomial: &[u8]| match self {
            Self::SlideOn(..) => monomial[0] > 0,
            Self::Turning(_) | Self::Slide(_) => monomial.iter().any(|&power| power > 0),
        };
        let known = |row: &Polynomial| {
            let mut own = row.iter().filter(|(monomial, _)| is_own(monomial));
            own.all(|(monomial, x)| monomials.contains(&&monomial[..]) && x.is_fixed())
        };
        let zero = vector[0].number(0.0);
        let factor =
            |row: &Polynomial<'m>, monomial: &[u8]| row.get(monomial).copied().unwrap_or(zero);
        let column = |monomial: &[u8]| Vector([0, 1].map(|k| factor(&rows[k], monomial)));
        rows.iter().all(known).then(|| match monomials {
            [only] => [column(only), column(only).perp()],
            both => [column(both[0]), column(both[1])],
        })
    }

    /// A vector without the term.
    fn dropped<'m>(&self, vector: V2<'m>) -> V2<'m> {
        let gone: &[SymbolId] = match self {
            Self::Turning(angle) => angle,
            Self::Slide(slide) | Self::SlideOn(slide, _) => core::slice::from_ref(slide),
        };
        let zero: Ex = vector[0].number(0.0);
        let zeros: Map<SymbolId, Ex> = gone.iter().map(|&symbol| (symbol, zero)).collect();
        let rest = substitute(&vector.0, &zeros);
        Vector([rest[0], rest[1]])
    }
}
