//! Class, order and kind of coupled groups, read from their loops.

use linkage_symbolic::numerically_equal;

use crate::algebra::names::Names;
use crate::structure::coupled::group::Private;
use crate::structure::equations::{Coordinate, CoordinateKind};
use crate::structure::polynomials::Polynomials;
use crate::structure::{equations, polynomials};

/// Class, order, and the number of links in the closed contour that changes its shape (0 without
/// one). Loops whose known parts are the same, and a loop without any, close a contour that leaves
/// the frame out; every other loop adds a place where the group is attached.
pub(crate) fn class_and_order<'m>(
    names: &Names<'m>,
    polynomials: &[Polynomials<'m>],
    coordinates: &[Coordinate],
) -> (u8, u8, usize) {
    if let [only] = polynomials {
        let dyad = if only.rows.len() == 2 { 2 } else { 0 };
        return (dyad, dyad, 0);
    }
    let mut contours = 0;
    let mut longest = 0;
    for (index, a) in polynomials.iter().enumerate() {
        let alone = std::iter::once(None);
        let with_others = polynomials[..index].iter().map(Some);
        let contour = alone
            .chain(with_others)
            .find_map(|b| contour(names, a, b, coordinates));
        if let Some(length) = contour {
            contours += 1;
            longest = longest.max(length);
        }
    }
    let order = polynomials.len() + 1 - contours;
    let class = if contours == 0 { 3 } else { longest.max(4) };
    (class as u8, order as u8, longest)
}

/// The number of unknowns in a vector loop, or in the sum or difference of two, if the known parts
/// cancel.
fn contour<'m>(
    names: &Names<'m>,
    a: &Polynomials<'m>,
    b: Option<&Polynomials<'m>>,
    coordinates: &[Coordinate],
) -> Option<usize> {
    let both: Vec<&Polynomials> = std::iter::once(a).chain(b).collect();
    if both.iter().any(|p| p.rows.len() != 2) {
        return None;
    }
    [1.0, -1.0].into_iter().find_map(|sign| {
        let cancels = |monomial: &[u8]| {
            (0..2).all(|row| {
                let zero = names.zero();
                let of = |p: &Polynomials<'m>| p.rows[row].get(monomial).copied().unwrap_or(zero);
                let (x, y) = (of(a), b.map_or(zero, of));
                let y = if sign < 0.0 { -y } else { y };
                numerically_equal(x, y)
            })
        };
        let mut monomials = both.iter().flat_map(|p| &p.rows).flat_map(|row| row.keys());
        let known = vec![0; monomials.next().map_or(0, Vec::len)];
        if known.is_empty() || !cancels(&known) {
            return None;
        }
        let mut left: Vec<Vec<u8>> = Vec::new();
        for monomial in both.iter().flat_map(|p| &p.rows).flat_map(|row| row.keys()) {
            if !left.contains(monomial) && !cancels(monomial) {
                left.push(monomial.clone());
            }
        }
        let in_contour = |k: &usize| {
            let first = polynomials::first_symbol(names, coordinates, *k);
            let width = equations::symbols(names, &coordinates[*k]).len();
            left.iter()
                .any(|m| m[first..first + width].iter().any(|&e| e > 0))
        };
        Some((0..coordinates.len()).filter(in_contour).count())
    })
}

/// The legs of a triad by their joints, the outer one first.
pub(crate) fn kind_of_group<'m>(
    names: &Names<'m>,
    private: &[Option<(Private<'m>, usize)>],
    polynomials: &[Polynomials<'m>],
    coordinates: &[Coordinate],
    core: &[usize],
    class: u8,
    contour: usize,
) -> String {
    let angle = |k: &usize| matches!(coordinates[*k].kind, CoordinateKind::Angle(_));
    let general = || match contour {
        0 if private.len() == 1 => "polynomial".to_owned(),
        0 => format!("{} loops", private.len()),
        links => format!("contour of {links}"),
    };
    let (true, [Some(first), Some(second)], [a, b]) = (class == 3, private, core) else {
        return general();
    };
    let mut legs: Vec<&str> = [first, second]
        .map(|(p, _)| leg(names, p, coordinates))
        .into();
    let together = |monomial: &Vec<u8>| {
        [a, b].into_iter().all(|k| {
            let first = polynomials::first_symbol(names, coordinates, *k);
            let width = equations::symbols(names, &coordinates[*k]).len();
            monomial[first..first + width].iter().any(|&e| e > 0)
        })
    };
    let guide_turns = || {
        polynomials
            .iter()
            .flat_map(|p| &p.rows)
            .any(|row| row.keys().any(together))
    };
    match [a, b].map(angle) {
        [true, true] => legs.push("RR"),
        // The components of a point.
        [false, false] if coordinates[*a].unknown == coordinates[*b].unknown => {
            return general();
        }
        [false, false] => legs.push("PP"),
        _ if guide_turns() => legs.push("RP"),
        _ => legs.push("PR"),
    }
    legs.sort_unstable_by_key(|leg| ["PP", "RR", "PR", "RP"].iter().position(|l| l == leg));
    legs.join("-")
}

fn leg<'m>(names: &Names<'m>, private: &Private<'m>, coordinates: &[Coordinate]) -> &'static str {
    match private {
        Private::Rotor(_) => "RR",
        Private::Slide { guide, .. } => {
            let turns =
                |c: &Coordinate| guide.components().any(|g| equations::contains(names, g, c));
            if coordinates.iter().any(turns) {
                "RP"
            } else {
                "PR"
            }
        }
    }
}
