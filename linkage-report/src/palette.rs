//! One colour for one quantity: in plots and legends, along the path of its point, on paper and on
//! the page.

use std::collections::BTreeMap;
use std::vec::Vec;

use super::builder::Report;
use super::positioned_picture;
use linkage_core::{Meaning, PointKind};
use linkage_formats::colour::{CURVES, Colour};
use linkage_runtime::Column;

/// Colours of quantities by their names; components of a vector have that of the vector.
#[derive(Clone, Debug, Default)]
pub(super) struct Palette {
    of: BTreeMap<&'static str, Assigned>,
}

/// The colour that a quantity has been assigned.
#[derive(Clone, Copy, Debug)]
struct Assigned {
    hue: usize,
    /// The number of earlier quantities of the same unit.
    rank: usize,
}

/// The look of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Style {
    /// The number of the colour among those of curves.
    pub(super) hue: usize,
    /// The number of the dash pattern.
    pub(super) dash: usize,
}

/// Ways of being dashed.
pub(super) const DASHES: usize = 4;

impl Style {
    /// Returns the style of a curve that is known by its order only. With the colours, 28 curves
    /// can be distinguished, and four without any colour.
    pub(super) const fn numbered(index: usize) -> Self {
        Self {
            hue: index,
            dash: index % DASHES,
        }
    }

    pub(super) const fn colour(self) -> Colour {
        Colour::Curve(self.hue)
    }
}

impl Palette {
    /// Returns the style of the curve of a column.
    pub(super) fn style(&self, column: &str) -> Option<Style> {
        let (quantity, component) = components(column);
        let Assigned { hue, rank } = *self.of.get(quantity)?;
        let dash = (rank + component) % DASHES;
        Some(Style { hue, dash })
    }

    /// The colour of a point or a quantity.
    pub(super) fn named(&self, name: &str) -> Option<usize> {
        self.of.get(name).map(|given| given.hue)
    }
}

/// The quantity that a column is a component of, and which: `p.y` is the second one of `p`.
fn components(column: &str) -> (&str, usize) {
    let parts = column.rsplit_once('.');
    let index = |name: &str| ["x", "y", "z"].iter().position(|axis| *axis == name);
    match parts.map(|(quantity, axis)| (quantity, index(axis))) {
        Some((quantity, Some(component))) => (quantity, component),
        _ => (column, 0),
    }
}

/// The colours of all quantities: those of the functions first, then points of the picture.
pub(super) fn palette(report: &Report) -> Palette {
    let mut hues = Assignment::default();
    let columns = report.tables.iter().flat_map(|table| table.heading.columns);
    let (coloured, others): (Vec<&Column>, Vec<&Column>) =
        columns.partition(|column| match column.meaning {
            Meaning::Value | Meaning::Rate { .. } | Meaning::Margin => true,
            Meaning::Sensitivity { .. } | Meaning::Picture => false,
        });
    for column in coloured {
        hues.give(components(column.name).0, column.unit);
    }
    if let Some(shown) = positioned_picture::find_picture(report) {
        for (index, point) in shown.picture.points.iter().enumerate() {
            if point.kind != PointKind::Construction {
                let given = hues.give(point.name, shown.unit);
                // `shape[p].x` is where `p` is.
                let column = components(shown.column_name(index)).0;
                hues.of.entry(column).or_insert(given);
            }
        }
    }
    for column in others {
        hues.give(components(column.name).0, column.unit);
    }
    Palette { of: hues.of }
}

/// Colours while they are given.
#[derive(Default)]
struct Assignment {
    of: BTreeMap<&'static str, Assigned>,
    /// The number of uses of each colour in a unit.
    units: BTreeMap<&'static str, [usize; CURVES]>,
}

impl Assignment {
    /// A colour that is rare in its unit, whose quantities meet in a panel, then one that is rare
    /// at all.
    fn give(&mut self, name: &'static str, unit: &'static str) -> Assigned {
        if let Some(given) = self.of.get(name) {
            return *given;
        }
        let there = |hue: usize| self.units.values().map(|unit| unit[hue]).sum::<usize>();
        let everywhere: [usize; CURVES] = core::array::from_fn(there);
        let counts = self.units.entry(unit).or_default();
        let rarest = (0..CURVES).min_by_key(|hue| (counts[*hue], everywhere[*hue]));
        let given = Assigned {
            hue: rarest.unwrap_or(0),
            rank: counts.iter().sum(),
        };
        counts[given.hue] += 1;
        self.of.insert(name, given);
        given
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_belong_to_their_vector() {
        assert_eq!(components("p10.y"), ("p10", 1));
        assert_eq!(components("e[crank].z"), ("e[crank]", 2));
        assert_eq!(components("psi"), ("psi", 0));
        assert_eq!(components("frame.angle"), ("frame.angle", 0));
    }
}
