//! Distances in space as polynomials of low degree, for the general machinery.

use crate::structure::classify;
use crate::structure::coupled_core;
use crate::structure::space;
use linkage_symbolic::{Ex, V3};

use super::Analysis;
use super::equations::{Coordinate, CoordinateKind, Equation};

/// A link in space, whose distance was squared.
#[derive(Clone, Debug)]
pub(crate) struct Link<'m> {
    pub(crate) vector: V3<'m>,
    pub(crate) length: Ex<'m>,
    /// The link whose square was subtracted.
    pub(crate) less: Option<Box<Link<'m>>>,
}

/// `|v| = l` becomes `(v . v / l - l)/2`, a length. Where an earlier distance is about the same point, their difference is taken: it
/// is of the first degree in that point, which leaves fewer solutions at infinity.
pub(super) fn squared<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Vec<Equation<'m>> {
    let mut squared = equations.to_vec();
    let mut links: Vec<Link<'m>> = Vec::new();
    for equation in &mut squared {
        let &[row] = &equation.rows[..] else { continue };
        let Some((vector, length)) = space::space_distance(analysis, row, coordinates) else {
            continue;
        };
        let mut link = Link {
            vector,
            length,
            less: None,
        };
        let partner = links
            .iter()
            .find_map(|other| Some((apart(analysis, &link, other, coordinates)?, other)));
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

/// Difference and sum of two links' vectors (one of them reversed if need be), if the difference is free of a length that the
/// first vector contains.
fn apart<'m>(
    analysis: &mut Analysis<'_, 'm>,
    link: &Link<'m>,
    other: &Link<'m>,
    coordinates: &[Coordinate],
) -> Option<[V3<'m>; 2]> {
    let contained = lengths_in(analysis, link.vector, coordinates)?;
    let sum = link.vector + other.vector;
    let difference = link.vector - other.vector;
    [[difference, sum], [sum, difference]]
        .into_iter()
        .find(|[apart, _]| {
            let left = lengths_in(analysis, *apart, coordinates);
            left.is_some_and(|left| {
                left.len() < contained.len() && left.iter().all(|k| contained.contains(k))
            })
        })
}

/// The unknown lengths that a vector contains.
fn lengths_in<'m>(
    analysis: &mut Analysis<'_, 'm>,
    vector: V3<'m>,
    coordinates: &[Coordinate],
) -> Option<Vec<usize>> {
    let polynomials = classify::polynomials(analysis, &vector.0, coordinates)?;
    let is_length = |k: &usize| matches!(coordinates[*k].kind, CoordinateKind::Length(_));
    let contained = (0..coordinates.len())
        .filter(is_length)
        .filter(|&k| polynomials.mention(coupled_core::first_symbol(analysis, coordinates, k)));
    Some(contained.collect())
}

fn square_of_link<'m>(link: &Link<'m>) -> Ex<'m> {
    let share = link.vector.square() / link.length;
    0.5 * (share - link.length)
}

/// `((v - w).(v + w) - (l - m)(l + m))/2 l`
fn difference_of_links<'m>(
    link: &Link<'m>,
    other: &Link<'m>,
    apart: V3<'m>,
    sum: V3<'m>,
) -> Ex<'m> {
    let product = apart.dot(sum);
    let wanted = link.length.difference_of_squares(other.length);
    0.5 * ((product - wanted) / link.length)
}
