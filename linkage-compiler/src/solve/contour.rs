//! Loops of the plane that earlier groups close: they lead to one point in several ways.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, Polynomial, SymbolId, V2, Vector, collect, substitute};

use crate::algebra::{Algebra, derivatives::dependence};
use crate::solve::unknowns;
use crate::structure::{Form, Rotor};

/// The most loops that are followed. Each loop doubles the ways to a point; with more loops it is
/// not known how far the point can move.
const MOST_LOOPS: usize = 6;

/// The loop of an earlier group, through which points of the group can be reached.
#[derive(Debug)]
pub(super) struct Contour<'m> {
    /// A sum of vectors that is 0.
    loop_vector: V2<'m>,
    /// The terms with the group's unknowns, each of which any vector can do without; none for a
    /// coupled group.
    terms: Vec<UnknownTerm>,
    /// The symbols of the unknowns.
    symbols: Vec<SymbolId>,
}

/// The unknowns that are solved already.
#[derive(Default)]
pub(super) struct EarlierGroups<'m> {
    /// Unknowns that are expressions of others.
    pub(super) explicit: Map<SymbolId, Ex<'m>>,
    /// The contours of the groups, in order.
    pub(super) contours: Vec<Contour<'m>>,
}

/// A term with an unknown of the group.
#[derive(Debug)]
enum UnknownTerm {
    /// A vector that turns with an angle: cosine and sine.
    Turning([SymbolId; 2]),
    Slide(SymbolId),
    /// A slide along a guide that turns with an angle.
    SlideOn(SymbolId, [SymbolId; 2]),
}

impl<'m> Contour<'m> {
    /// Returns `None` for a group that is neither coupled nor of the plane with two unknowns.
    pub(super) fn new(algebra: &Algebra<'m>, form: &Form<'m>) -> Option<Self> {
        let symbols = |angle: usize| {
            let angle = &algebra.names.angles[angle];
            [angle.cos, angle.sin]
        };
        let turned = |rotor: &Rotor<'m>| rotor.z.turned(unknowns::unit_of(algebra, rotor));
        let along = |slide: SymbolId, guide: V2<'m>| unknowns::unknown(algebra, slide) * guide;
        let (loop_vector, terms) = match form {
            Form::TwoRotors {
                first,
                second,
                known,
            } => {
                let terms = [first, second].map(|rotor| UnknownTerm::Turning(symbols(rotor.angle)));
                (turned(first) + turned(second) + *known, terms.into())
            }
            Form::RotorAndSlide {
                rotor,
                slide,
                guide,
                known,
            } => {
                let terms = vec![
                    UnknownTerm::Turning(symbols(rotor.angle)),
                    UnknownTerm::Slide(*slide),
                ];
                (turned(rotor) + along(*slide, *guide) + *known, terms)
            }
            Form::SlideOnRotor {
                rotor,
                slide,
                guide,
                known,
            } => {
                let guide = guide.turned(unknowns::unit_of(algebra, rotor));
                let terms = vec![UnknownTerm::SlideOn(*slide, symbols(rotor.angle))];
                (turned(rotor) + along(*slide, guide) + *known, terms)
            }
            Form::TwoSlides {
                slides,
                guides,
                known,
            } => {
                let [first, second] = [0, 1].map(|k| along(slides[k], guides[k]));
                (
                    first + second + *known,
                    slides.map(UnknownTerm::Slide).into(),
                )
            }
            Form::Coupled(coupled) => {
                let symbols =
                    unknowns::symbols_of_coupled(coupled, |angle| symbols(angle).to_vec());
                return Some(Self {
                    loop_vector: Vector([algebra.zero(); 2]),
                    terms: Vec::new(),
                    symbols,
                });
            }
            _ => return None,
        };
        let symbols = terms.iter().flat_map(UnknownTerm::symbols).collect();
        Some(Self {
            loop_vector,
            terms,
            symbols,
        })
    }

    fn is_in(&self, symbols: impl IntoIterator<Item = SymbolId>) -> bool {
        let mut symbols = symbols.into_iter();
        symbols.any(|symbol| self.symbols.contains(&symbol))
    }
}

/// A vector without unknowns that are expressions of others, and of others again.
pub(super) fn without_explicit<'m>(
    algebra: &Algebra<'m>,
    earlier: &EarlierGroups<'m>,
    vector: V2<'m>,
) -> V2<'m> {
    let [x, y] = substitute(&vector.0, &earlier.explicit)[..] else {
        unreachable!("as many as before");
    };
    let next = Vector([x, y]);
    if next == vector {
        vector
    } else {
        without_explicit(algebra, earlier, multiplied_out(algebra, next))
    }
}

/// Simplifies vectors that turn forth and back with an angle, such as a link with an angle from
/// another link on the way to its own angle.
fn multiplied_out<'m>(algebra: &Algebra<'m>, vector: V2<'m>) -> V2<'m> {
    let present = algebra.graph.symbols_of(&vector.ids());
    let angles = algebra.names.angles.iter();
    let angles =
        angles.filter(|angle| present.contains(&angle.cos) || present.contains(&angle.sin));
    let symbols: Vec<SymbolId> = angles.flat_map(|angle| [angle.cos, angle.sin]).collect();
    let pairs: Vec<(usize, usize)> = (0..symbols.len() / 2).map(|k| (2 * k, 2 * k + 1)).collect();
    vector.map(|x| match collect(x, &symbols, &pairs) {
        Some(polynomial) => sum(algebra, &polynomial, &symbols),
        None => x,
    })
}

fn sum<'m>(algebra: &Algebra<'m>, polynomial: &Polynomial<'m>, symbols: &[SymbolId]) -> Ex<'m> {
    let terms = polynomial.iter().map(|(monomial, &coefficient)| {
        let powers = symbols.iter().zip(monomial);
        powers.fold(coefficient, |product, (&symbol, &power)| {
            (0..power).fold(product, |product, _| {
                product * unknowns::unknown(algebra, symbol)
            })
        })
    });
    terms.fold(algebra.zero(), |sum, term| sum + term)
}

/// A vector, in all ways that lead around the loops of earlier groups: the way in which it is
/// written is none of them by itself. Of each loop one of its group's unknowns is got rid of, first
/// of the last one. No way, where it hangs on a coupled group or on too many.
pub(super) fn ways_to<'m>(
    algebra: &Algebra<'m>,
    earlier: &EarlierGroups<'m>,
    vector: V2<'m>,
) -> Vec<V2<'m>> {
    let below = dependence::symbols_below(algebra.graph, &vector.0);
    let contours: Vec<&Contour> = earlier.contours.iter().collect();
    let behind = contours
        .iter()
        .filter(|contour| contour.is_in(below.iter().copied()));
    if behind.count() > MOST_LOOPS {
        Vec::new()
    } else {
        ways(algebra, vector, &contours)
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
    let without = last.terms.iter().filter_map(|term| {
        let [columns, loop_columns] = [vector, last.loop_vector].map(|vector| term.columns(vector));
        let ([c, d], [l, m]) = (columns?, loop_columns?);
        let [rest, loop_rest] = [vector, last.loop_vector].map(|vector| term.dropped(vector));
        // The columns of the loop are perpendicular and of one length.
        let square = l.square();
        let [x, y] = [l, m].map(|column| column.dot(loop_rest) / square);
        Some(rest - x * c - y * d)
    });
    without
        .flat_map(|vector| ways(algebra, vector, before))
        .collect()
}

impl UnknownTerm {
    fn symbols(&self) -> Vec<SymbolId> {
        match *self {
            Self::Turning(angle) => angle.to_vec(),
            Self::Slide(slide) => vec![slide],
            Self::SlideOn(slide, [cos, sin]) => vec![slide, cos, sin],
        }
    }

    /// The factors of cosine and sine in a vector, or of a slide along a vector and across it.
    /// Returns `None` if the vector is no sum of such a term and of others, or if the factors are
    /// not fixed.
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
            let mut with_unknown = row.iter().filter(|(monomial, _)| is_own(monomial));
            with_unknown.all(|(monomial, x)| monomials.contains(&&monomial[..]) && x.is_fixed())
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
