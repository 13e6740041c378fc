//! Plots of a report's columns.

use std::borrow::Cow;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::accuracy::Sensitive;
use super::builder::Report;
use super::panels::{TOGETHER, panels};
use super::plot::Plot;
use super::rates::True;
use super::tables::Saved;
use super::{BandKind, Mistake};
use super::{accuracy, check, palette, rates};
use linkage_core::Meaning;
use linkage_core::format::rounded;
use linkage_formats::ReportError;
use linkage_formats::units::{per_second, titled};
use linkage_runtime::Column;

/// A column as it is asked for.
struct FoundColumn<'a> {
    name: &'static str,
    unit: Cow<'a, str>,
    values: Cow<'a, [f64]>,
    /// The table and index, unless it is a true velocity or acceleration.
    column: Option<(&'a Saved, usize)>,
}

/// Plots the named columns against the input.
pub(super) fn plot_columns<'n>(
    report: &Report,
    columns: impl IntoIterator<Item = &'n str>,
) -> Result<Plot, ReportError> {
    check::check(report)?;
    let rates = rates::true_rates(report);
    let mut mistakes = Vec::new();
    let mut plot = empty_plot(report);
    for name in columns {
        match find_column(report, &rates, name) {
            Some(found) => plot = with_column(report, plot, &found),
            None => mistakes.push(Mistake::Unknown {
                kind: "column",
                name: name.to_string(),
                known: known_columns(report),
            }),
        }
    }
    if mistakes.is_empty() {
        Ok(plot)
    } else {
        Err(ReportError::Mistakes(mistakes))
    }
}

/// Plots the errors by tolerances; `None` if there are none.
pub(super) fn plot_errors(report: &Report) -> Result<Option<Plot>, ReportError> {
    check::check(report)?;
    let sensitive = accuracy::sensitive(report);
    if sensitive.is_empty() {
        return Ok(None);
    }
    let hues = palette::palette(report);
    let mut plot = empty_plot(report).title(format!("{}: errors by tolerances", report.title));
    for quantities in sensitive.chunks(TOGETHER / 2) {
        for quantity in quantities {
            for kind in [BandKind::WorstCase, BandKind::Statistical] {
                let name = format!("{}, {}", quantity.name, kind.name());
                plot = plot.curve(&name, &quantity.unit, &quantity.half(kind));
                plot = plot.styled(hues.style(&quantity.name));
                if kind == BandKind::Statistical {
                    plot = plot.thin();
                }
            }
        }
        plot = plot.panel();
    }
    Ok(Some(plot))
}

/// The plots that belong to a report, with their names: values and derivatives of each function,
/// true velocities and accelerations, errors by tolerances.
pub(super) fn all_plots(report: &Report) -> Result<Vec<(String, Plot)>, ReportError> {
    let rates = rates::true_rates(report);
    let sensitive = accuracy::sensitive(report);
    let hues = palette::palette(report);
    let mut plots = Vec::new();
    for table in &report.tables {
        let function = table.heading.function;
        let columns = table.columns().filter(|(column, _)| is_plotted(column));
        let given = columns.map(|(column, values)| (column.name, column.unit, values));
        let plot = empty_plot(report).title(format!("{}: {function}", report.title));
        let plot = panels(plot, &hues, given).map(|plot| banded(plot, table, &sensitive));
        plots.extend(plot.map(|plot| (function.to_string(), plot)));

        let rates = rates.iter().filter(|rate| rate.table == function);
        let rates = rates.map(|r| (r.column.name, r.unit.as_str(), r.values.as_slice()));
        let title = format!(
            "{}: {function}, true velocities and accelerations{}",
            report.title,
            speed_note(report)
        );
        let plot = empty_plot(report).title(title);
        plots.extend(panels(plot, &hues, rates).map(|plot| (format!("{function}-true"), plot)));
    }
    let errors = plot_errors(report)?;
    plots.extend(errors.map(|plot| (String::from("errors-by-tolerances"), plot)));
    Ok(plots)
}

/// ` at 10 rad/s`
fn speed_note(report: &Report) -> String {
    report.speed.map_or_else(String::new, |speed| {
        let unit = per_second(report.input.unit, 1);
        format!(" at {} {unit}", rounded(speed.omega))
    })
}

fn empty_plot(report: &Report) -> Plot {
    Plot::new(report.input.name, report.input.unit, &report.positions).title(report.title.as_str())
}

fn with_column(report: &Report, plot: Plot, found: &FoundColumn<'_>) -> Plot {
    let name = match found.column {
        Some((table, _)) if plot.has_curve(found.name, &found.unit) => {
            Cow::Owned(format!("{}.{}", table.heading.function, found.name))
        }
        _ => Cow::Borrowed(found.name),
    };
    let plot = plot.curve(&name, &found.unit, &found.values);
    let mut plot = plot.styled(palette::palette(report).style(found.name));
    let sensitive = accuracy::sensitive(report);
    let about = sensitive.iter().filter(|sensitive| {
        let of = sensitive.column.map(|index| (sensitive.table, index));
        match (of, found.column) {
            (Some((a, i)), Some((b, j))) => core::ptr::eq(a, b) && i == j,
            _ => false,
        }
    });
    for sensitive in about {
        for kind in [BandKind::WorstCase, BandKind::Statistical] {
            plot = plot.band(&name, kind, &sensitive.half(kind));
        }
    }
    plot
}

fn find_column<'a>(report: &'a Report, rates: &'a [True], name: &str) -> Option<FoundColumn<'a>> {
    let named = |function: &str, column: &Column, unit: &str| {
        let titled = titled(column.name, unit);
        let rest = name
            .strip_prefix(function)
            .and_then(|rest| rest.strip_prefix('.'));
        [Some(name), rest]
            .into_iter()
            .flatten()
            .any(|name| name == column.name || name == titled)
    };
    let columns = report.tables.iter().flat_map(|table| {
        let columns = table.columns().enumerate();
        columns.map(move |(index, (column, values))| (table, index, column, values))
    });
    let columns =
        columns.filter(|(table, _, column, _)| named(table.heading.function, column, column.unit));
    // One with sensitivities is preferred among the functions that have the column.
    let sensitive = accuracy::sensitive(report);
    let is_banded = |table: &Saved, index: usize| {
        let is_it = |s: &Sensitive<'_>| s.column == Some(index) && core::ptr::eq(s.table, table);
        sensitive.iter().any(is_it)
    };
    let given = columns.min_by_key(|(table, index, ..)| !is_banded(table, *index));
    let given = given.map(|(table, index, column, values)| FoundColumn {
        name: column.name,
        unit: Cow::Borrowed(column.unit),
        values: Cow::Borrowed(values),
        column: Some((table, index)),
    });
    let mut rates = rates
        .iter()
        .filter(|rate| named(rate.table, rate.column, &rate.unit));
    given.or_else(|| {
        rates.next().map(|rate| FoundColumn {
            name: rate.column.name,
            unit: Cow::Borrowed(&rate.unit),
            values: Cow::Borrowed(&rate.values),
            column: None,
        })
    })
}

/// Name, unit and values of a column, as [`plot`](Self::plot) finds it.
pub(super) fn find_series(report: &Report, name: &str) -> Option<(&'static str, String, Vec<f64>)> {
    let rates = rates::true_rates(report);
    let found = find_column(report, &rates, name)?;
    Some((
        found.name,
        found.unit.into_owned(),
        found.values.into_owned(),
    ))
}

pub(super) fn known_columns(report: &Report) -> Vec<String> {
    let columns = report.tables.iter().flat_map(|table| table.heading.columns);
    let columns = columns.filter(|column| column.meaning != Meaning::Picture);
    let columns = columns.map(|column| column.name.to_string());
    let rates = rates::true_rates(report);
    let rates = rates
        .iter()
        .map(|rate| titled(rate.column.name, &rate.unit));
    columns.chain(rates).collect()
}

/// The plot with bands about the quantities that the function has sensitivities of, too.
fn banded(plot: Plot, table: &Saved, sensitive: &[Sensitive<'_>]) -> Plot {
    let is_of_table =
        |about: &&Sensitive<'_>| about.column.is_some() && core::ptr::eq(about.table, table);
    sensitive
        .iter()
        .filter(is_of_table)
        .fold(plot, |plot, about| {
            [BandKind::WorstCase, BandKind::Statistical]
                .into_iter()
                .fold(plot, |plot, kind| {
                    plot.band(&about.name, kind, &about.half(kind))
                })
        })
}

/// Returns true for a column in the plots that a report makes by itself. Sensitivities are too
/// many, and points of the picture are in the drawing.
fn is_plotted(column: &Column) -> bool {
    match column.meaning {
        Meaning::Value | Meaning::Rate { .. } | Meaning::Margin => true,
        Meaning::Sensitivity { .. } | Meaning::Picture => false,
    }
}
