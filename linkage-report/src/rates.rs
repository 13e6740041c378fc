//! True velocities and accelerations.

use std::string::String;
use std::vec::Vec;

use super::builder::Report;
use super::tables::Saved;
use linkage_core::Meaning;
use linkage_formats::units::{numerator, per_second};
use linkage_runtime::{Column, true_acceleration, true_velocity};

/// A derivative by time.
pub(super) struct True {
    /// The function whose table has the derivative by the input.
    pub(super) table: &'static str,
    pub(super) column: &'static Column,
    pub(super) order: u32,
    /// The quantity, if the table has it.
    pub(super) of: Option<&'static str>,
    pub(super) unit: String,
    pub(super) values: Vec<f64>,
}

/// The true velocities and accelerations of all first and second derivatives; none without a speed.
pub(super) fn true_rates(report: &Report) -> Vec<True> {
    let tables = report.tables.iter();
    let pairs = tables.flat_map(|table| table.columns().map(move |column| (table, column)));
    pairs
        .filter_map(|(table, (column, values))| true_rate(report, table, column, values))
        .collect()
}

fn true_rate(
    report: &Report,
    table: &Saved,
    column: &'static Column,
    values: &[f64],
) -> Option<True> {
    let speed = report.speed?;
    let Meaning::Rate { order, .. } = column.meaning else {
        return None;
    };
    let values = match order {
        1 => values
            .iter()
            .map(|&v| true_velocity(v, speed.omega))
            .collect(),
        2 if speed.epsilon == 0.0 => {
            let acceleration = |&a| true_acceleration(0.0, a, speed.omega, 0.0);
            values.iter().map(acceleration).collect()
        }
        2 => {
            let velocities = first_derivative(report, table, column)?.iter();
            let both = velocities.zip(values);
            both.map(|(&v, &a)| true_acceleration(v, a, speed.omega, speed.epsilon))
                .collect()
        }
        _ => return None,
    };
    Some(True {
        table: table.heading.function,
        column,
        order,
        of: table.base_name(column),
        unit: true_unit(report, table, column, order),
        values,
    })
}

fn true_unit(report: &Report, table: &Saved, column: &Column, order: u32) -> String {
    if let Meaning::Rate { of: Some(of), .. } = column.meaning {
        return per_second(table.heading.columns[of].unit, order);
    }
    let per = match order {
        1 => String::from(report.input.unit),
        _ => std::format!("{}^{order}", report.input.unit),
    };
    per_second(&numerator(column.unit, &per), order)
}

/// The first derivative of the quantity of which a column is the second one: in the same table, or
/// in another one that has the quantity under the same name.
pub(super) fn first_derivative<'a>(
    report: &'a Report,
    table: &Saved,
    column: &Column,
) -> Option<&'a [f64]> {
    let of = table.base_name(column)?;
    let here = report
        .tables
        .iter()
        .filter(|t| core::ptr::eq(t.heading, table.heading));
    here.chain(&report.tables).find_map(|table| {
        table
            .columns()
            .find(|(other, _)| {
                matches!(other.meaning, Meaning::Rate { order: 1, .. })
                    && table.base_name(other) == Some(of)
            })
            .map(|(_, values)| values)
    })
}
