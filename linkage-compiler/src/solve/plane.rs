//! What the closed forms of the plane share: gaps, guards, terms of their equations.

use linkage_symbolic::{Ex, V2};

use crate::algebra::{Link, Solution, Term};

use super::Solver;

/// A value that is NaN where the root `h` is, also where `h` drops out of its formula: a guide along an axis leaves
/// the other component of a link free of the root, but not of the assembly. Whether `h` stays is known only
/// when definitions are gone (a direction may turn out to be constant): the inliner removes a guard without use.
pub(super) fn guarded<'m>(value: Ex<'m>, h: Ex<'m>) -> Ex<'m> {
    h.select(value, h)
}

/// A length that is NaN where its square is too large for a number, so that what is computed from a root is NaN altogether, and not infinite in one
/// component. Only of what `assemble()` knows: in a call it would cost something.
pub(super) fn squarable<'m>(length: Ex<'m>) -> Ex<'m> {
    if !length.is_fixed() {
        return length;
    }
    let room = length.number(f64::MAX) - length.square();
    room.select(length, length.number(f64::NAN))
}

/// 0 where the root of `q` is a number (see [`Ex::root`]), else `miss`, which is then made positive.
pub(super) fn gap<'m>(q: Ex<'m>, scale: Ex<'m>, miss: Ex<'m>) -> Ex<'m> {
    let closes = q.reserve(scale);
    let miss = miss.max(q.number(f64::MIN_POSITIVE));
    closes.select(q.number(0.0), miss)
}

/// 0 where `determinant` is not 0, else NaN: a linear group has nothing to measure a gap by.
pub(super) fn linear_gap(determinant: Ex) -> Ex {
    defined_gap(determinant.number(0.0), determinant)
}

/// NaN where something known is no finite number, by a division, a root or an arc function: what follows from it is none either, and
/// nothing else of an equation that is solved without a root would show it.
pub(super) fn where_finite<'m>(value: Ex<'m>, known: &[Ex<'m>]) -> Ex<'m> {
    let open = known.iter().filter(|x| x.is_partial());
    let Some(size) = open.map(|x| x.abs()).reduce(|sum, x| sum + x) else {
        return value;
    };
    let finite = size.number(f64::MAX) - size;
    finite.select(value, value.number(f64::NAN))
}

/// A gap that is NaN where `size` is 0: parallel guides, or pivots that coincide, which any angle would suit.
pub(super) fn defined_gap<'m>(gap: Ex<'m>, size: Ex<'m>) -> Ex<'m> {
    let regular = size.abs() - f64::MIN_POSITIVE;
    regular.select(gap, gap.number(f64::NAN))
}

/// The terms `z (c, s')` of a rotating vector.
pub(super) fn rotor_terms<'m>(z: V2<'m>, factors: V2<'m>) -> Vec<Term<'m>> {
    let coefficients = [z, z.perp()].into_iter().zip(factors.components());
    coefficients
        .map(|(coefficient, factor)| Term {
            coefficient: coefficient.0.to_vec(),
            factor,
        })
        .collect()
}

/// What a group's equations contain of what was known before.
pub(super) fn known_term<'m>(known: &[Ex<'m>]) -> Term<'m> {
    Term {
        coefficient: known.to_vec(),
        factor: known[0].number(1.0),
    }
}

/// Records a group of two equations. The determinant's closed value is `determinant`.
pub(super) fn push_pair<'m>(
    solver: &mut Solver<'_, 'm>,
    terms: Vec<Term<'m>>,
    columns: [V2<'m>; 2],
    determinant: Ex<'m>,
) {
    let product = columns[0].cross(columns[1]);
    let determinant = solver.alias("det", determinant, product);
    solver.push_solution(Solution {
        terms,
        jacobian: columns.map(|column| column.0.to_vec()).to_vec(),
        determinant,
        elimination: None,
        links: [None; 2],
        rod: None,
        rows: Vec::new(),
    });
}

/// Records that the link `vector`, which is `z unit`, turns with an unknown of the group of two equations that was recorded last.
pub(super) fn links_turn<'m>(
    solver: &mut Solver<'_, 'm>,
    position: usize,
    z: V2<'m>,
    unit: V2<'m>,
    vector: V2<'m>,
    across: Ex<'m>,
) {
    let group = solver.algebra.solutions.groups.last_mut();
    let group = group.expect("the group that is solved");
    group.links[position] = Some(Link {
        vector,
        z,
        unit,
        square: z.square(),
        across,
    });
}

/// Records a group of one equation with one unknown.
pub(super) fn push_single<'m>(
    solver: &mut Solver<'_, 'm>,
    terms: Vec<Term<'m>>,
    determinant: Ex<'m>,
) {
    solver.push_solution(Solution {
        terms,
        jacobian: vec![vec![determinant]],
        determinant,
        elimination: None,
        links: [None; 2],
        rod: None,
        rows: Vec::new(),
    });
}
