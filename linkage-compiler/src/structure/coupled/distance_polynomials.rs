//! Distances in space as polynomials of low degree, for the general machinery.

use linkage_symbolic::{Ex, V3};

use crate::algebra::names::Names;
use crate::structure::elements::SpaceLink;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::{distance, polynomials};

/// `|v| = l` becomes `(v . v / l - l)/2`, a length. Where an earlier distance is about the same
/// point, their difference is taken: it is of the first degree in that point, which leaves fewer
/// solutions at infinity.
pub(crate) fn with_squared_distances<'m>(
    names: &Names<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Vec<Equation<'m>> {
    let mut squared = equations.to_vec();
    let mut links: Vec<SpaceLink<'m>> = Vec::new();
    for equation in &mut squared {
        let &[row] = &equation.rows[..] else { continue };
        let Some((vector, length)) = distance::space_distance(names, row, coordinates) else {
            continue;
        };
        let mut link = SpaceLink {
            vector,
            length,
            less: None,
        };
        let partner = links
            .iter()
            .find_map(|other| Some((apart(names, &link, other, coordinates)?, other)));
        let row = match partner {
            Some(([apart, sum], other)) => {
                link.less = Some(Box::new(other.clone()));
                difference_of_links(&link, other, apart, sum)
            }
            None => square_of_link(&link),
        };
        equation.rows = vec![row];
        equation.distance = Some(link.clone());
        links.push(link);
    }
    squared
}

/// Difference and sum of two links' vectors (one of them reversed if need be), if the difference is
/// free of a length that the first vector contains.
fn apart<'m>(
    names: &Names<'m>,
    link: &SpaceLink<'m>,
    other: &SpaceLink<'m>,
    coordinates: &[Coordinate],
) -> Option<[V3<'m>; 2]> {
    let contained = lengths_in(names, link.vector, coordinates)?;
    let sum = link.vector + other.vector;
    let difference = link.vector - other.vector;
    [[difference, sum], [sum, difference]]
        .into_iter()
        .find(|[apart, _]| {
            let left = lengths_in(names, *apart, coordinates);
            left.is_some_and(|left| {
                left.len() < contained.len() && left.iter().all(|k| contained.contains(k))
            })
        })
}

/// The unknown lengths that a vector contains.
fn lengths_in<'m>(
    names: &Names<'m>,
    vector: V3<'m>,
    coordinates: &[Coordinate],
) -> Option<Vec<usize>> {
    let polynomials = polynomials::polynomials(names, &vector.0, coordinates)?;
    let is_length = |k: &usize| matches!(coordinates[*k].kind, CoordinateKind::Length(_));
    let contained = (0..coordinates.len())
        .filter(is_length)
        .filter(|&k| polynomials.mention(polynomials::first_symbol(names, coordinates, k)));
    Some(contained.collect())
}

fn square_of_link<'m>(link: &SpaceLink<'m>) -> Ex<'m> {
    let share = link.vector.square() / link.length;
    0.5 * (share - link.length)
}

/// `((v - w).(v + w) - (l - m)(l + m))/2 l`
fn difference_of_links<'m>(
    link: &SpaceLink<'m>,
    other: &SpaceLink<'m>,
    apart: V3<'m>,
    sum: V3<'m>,
) -> Ex<'m> {
    let product = apart.dot(sum);
    let wanted = link.length.difference_of_squares(other.length);
    0.5 * ((product - wanted) / link.length)
}
