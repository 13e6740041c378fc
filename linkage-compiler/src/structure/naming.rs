//! Names of coordinates and unknowns in messages.

use crate::algebra::names::Names;
use crate::model::Mechanism;
use crate::structure::equations::{Coordinate, CoordinateKind};

/// The unknowns behind coordinates; of a vector that is not there as a whole, the components.
pub(crate) fn unknown_names<'c>(
    names: &Names<'_>,
    coordinates: impl Iterator<Item = &'c Coordinate>,
) -> String {
    let coordinates: Vec<&Coordinate> = coordinates.filter(|c| c.unknown.is_some()).collect();
    let mut named: Vec<(usize, String)> = Vec::new();
    for coordinate in &coordinates {
        let Some(unknown) = coordinate.unknown else {
            continue;
        };
        let of_it = coordinates.iter().filter(|c| c.unknown == Some(unknown));
        let name = if of_it.count() == names.components_of(unknown) {
            names.mechanism.unknowns[unknown].name.clone()
        } else {
            coordinate_name(names, coordinate)
        };
        named.push((unknown, format!("`{name}`")));
    }
    named.sort_by_key(|(unknown, _)| *unknown);
    named.dedup();
    let texts: Vec<String> = named.into_iter().map(|(_, name)| name).collect();
    texts.join(", ")
}

/// True if these are not all components of the first one's unknown.
pub(crate) fn is_component(indices: &[usize], coordinates: &[Coordinate]) -> bool {
    let Some(unknown) = indices.first().and_then(|&k| coordinates[k].unknown) else {
        return false;
    };
    let of_it = indices
        .iter()
        .filter(|&&k| coordinates[k].unknown == Some(unknown));
    let missing = coordinates.iter().filter(|c| c.unknown == Some(unknown));
    of_it.count() < missing.count()
}

/// `theta`, or a component: `p.x`.
pub(crate) fn coordinate_name(names: &Names<'_>, coordinate: &Coordinate) -> String {
    match coordinate.kind {
        CoordinateKind::Length(symbol) => names.graph.symbol(symbol).name,
        CoordinateKind::Angle(angle) => {
            let value = names.angles[angle].value;
            names.graph.symbol(value).name
        }
    }
}

pub(crate) fn unknown_list(mechanism: &Mechanism, mut unknowns: Vec<usize>) -> String {
    unknowns.sort_unstable();
    unknowns.dedup();
    let name = |&k: &usize| format!("`{}`", mechanism.unknowns[k].name);
    unknowns.iter().map(name).collect::<Vec<_>>().join(", ")
}

/// `1 unknown`, `3 unknowns`
pub(crate) fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}
