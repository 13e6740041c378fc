//! Effects of tolerances: bands about quantities, and the largest errors.

use std::borrow::Cow;
use std::string::{String, ToString};
use std::vec::Vec;

use super::builder::Report;
use super::tables::Saved;
use linkage_core::Meaning;
use linkage_formats::units::numerator;
use linkage_runtime::{Column, Parameter};

/// The sum of errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BandKind {
    /// The sizes of all effects: no larger error is possible, to first order.
    WorstCase,
    /// The root of the sum of squares: three standard deviations, if tolerances are three standard
    /// deviations of independent errors.
    Statistical,
}

impl BandKind {
    /// `worst case` or `statistical`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::WorstCase => "worst case",
            Self::Statistical => "statistical",
        }
    }

    fn sum(self, effects: impl Iterator<Item = f64>) -> f64 {
        match self {
            Self::WorstCase => effects.map(f64::abs).sum(),
            Self::Statistical => effects.map(|x| x * x).sum::<f64>().sqrt(),
        }
    }
}

/// A quantity with its sensitivities.
pub(super) struct Sensitive<'a> {
    pub(super) table: &'a Saved,
    /// Its column; `None` if the function gives its sensitivities only.
    pub(super) column: Option<usize>,
    pub(super) name: Cow<'static, str>,
    pub(super) unit: Cow<'static, str>,
    effects: Vec<(Parameter, &'a [f64])>,
}

/// The position of the largest error of a quantity.
pub(super) struct Worst {
    pub(super) at: f64,
    pub(super) worst: f64,
    pub(super) statistical: f64,
    /// Sizes of the effects of parameters that have one, the largest first.
    pub(super) contributions: Vec<(&'static str, f64)>,
}

impl Sensitive<'_> {
    /// Half the width of the band at each position.
    pub(super) fn half(&self, kind: BandKind) -> Vec<f64> {
        let rows = 0..self.table.rows;
        rows.map(|row| kind.sum(self.effects_at(row).map(|(_, effect)| effect)))
            .collect()
    }

    /// The position with the largest worst case; `None` if it is finite nowhere.
    pub(super) fn worst(&self, positions: &[f64]) -> Option<Worst> {
        let half = self.half(BandKind::WorstCase);
        let finite = half.iter().enumerate().filter(|(_, x)| x.is_finite());
        let (row, &worst) = finite.max_by(|a, b| a.1.total_cmp(b.1))?;
        let sizes = self
            .effects_at(row)
            .map(|(name, effect)| (name, effect.abs()));
        let mut contributions: Vec<_> = sizes.filter(|(_, size)| *size > 0.0).collect();
        contributions.sort_by(|a, b| b.1.total_cmp(&a.1));
        Some(Worst {
            at: positions[row],
            worst,
            statistical: BandKind::Statistical.sum(self.effects_at(row).map(|(_, effect)| effect)),
            contributions,
        })
    }

    /// Sensitivity times tolerance of each parameter.
    pub(super) fn effects_at(&self, row: usize) -> impl Iterator<Item = (&'static str, f64)> {
        let effects = self.effects.iter();
        effects.map(move |(parameter, e)| (parameter.name, e[row] * parameter.tolerance))
    }
}

/// Quantities with sensitivities, in the order of their first one. None without dimensions, or if
/// no parameter that they depend on has a tolerance.
pub(super) fn sensitive(report: &Report) -> Vec<Sensitive<'_>> {
    let mut all: Vec<Sensitive<'_>> = Vec::new();
    for table in &report.tables {
        let start = all.len();
        for (column, values) in table.columns() {
            let Meaning::Sensitivity { parameter, of } = column.meaning else {
                continue;
            };
            let Some(dimension) = report.dimensions.get(parameter) else {
                continue;
            };
            let effect = (dimension.parameter, values);
            let name = quantity(table, column);
            match all[start..].iter_mut().find(|s| s.name == name) {
                Some(sensitive) => sensitive.effects.push(effect),
                None => all.push(Sensitive {
                    table,
                    column: of,
                    name,
                    unit: unit(table, column, of, dimension.parameter.unit),
                    effects: Vec::from([effect]),
                }),
            }
        }
    }
    all.retain(|s| s.effects.iter().any(|(p, _)| p.tolerance > 0.0));
    all
}

/// Returns the quantity of a sensitivity: its name, or that of the sensitivity without the
/// parameter.
fn quantity(table: &Saved, column: &'static Column) -> Cow<'static, str> {
    if let Some(name) = table.base_name(column) {
        return Cow::Borrowed(name);
    }
    match (column.name.rfind('['), column.name.rfind(']')) {
        (Some(open), Some(close)) if open < close => {
            let mut name = column.name[..open].to_string();
            name.push_str(&column.name[close + 1..]);
            Cow::Owned(name)
        }
        _ => Cow::Borrowed(column.name),
    }
}

fn unit(
    table: &Saved,
    column: &'static Column,
    of: Option<usize>,
    per: &'static str,
) -> Cow<'static, str> {
    match of {
        Some(of) => Cow::Borrowed(table.heading.columns[of].unit),
        None => Cow::Owned(String::from(numerator(column.unit, per))),
    }
}
