//! Checks that the parts of a report fit together.

use std::string::{String, ToString};
use std::vec::Vec;

use super::builder::Report;
use super::positioned_picture::{drawn_names, point_named};
use super::tables::Saved;
use super::{glyphs, machine, positioned_picture, rates, tables};
use linkage_core::{Meaning, Picture};
use linkage_formats::{Mistake, ReportError};

/// Returns all mistakes of a report as an error.
pub(super) fn check(report: &Report) -> Result<(), ReportError> {
    let mut mistakes = Vec::new();
    glyphs::check_words(report, &mut mistakes);
    check_tables(report, &mut mistakes);
    check_picture(report, &mut mistakes);
    check_parameters(report, &mut mistakes);
    check_speed(report, &mut mistakes);
    check_given(report, &mut mistakes);
    mistakes.extend(report.csv_style.mistake());
    machine::check_cyclogram(report, &mut mistakes);
    if mistakes.is_empty() {
        Ok(())
    } else {
        Err(ReportError::Mistakes(mistakes))
    }
}

fn check_tables(report: &Report, mistakes: &mut Vec<Mistake>) {
    let positions = report.positions.len();
    if positions < 2 {
        mistakes.push(Mistake::Positions { count: positions });
    }
    check_positions(report, mistakes);
    for (index, table) in report.tables.iter().enumerate() {
        let function = table.heading.function;
        if table.rows != positions {
            mistakes.push(Mistake::Rows {
                function: function.to_string(),
                rows: table.rows,
                positions,
            });
        }
        let same = |other: &&Saved| other.heading.function == function;
        if report.tables[..index].iter().filter(same).count() == 1 {
            mistakes.push(Mistake::Twice {
                function: function.to_string(),
            });
        }
    }
}

fn check_positions(report: &Report, mistakes: &mut Vec<Mistake>) {
    let mut rows = report.positions.iter().enumerate();
    if let Some((row, &value)) = rows.find(|(_, x)| !x.is_finite()) {
        let what = std::format!("position {row} of `{}`", report.input.name);
        mistakes.push(Mistake::NotFinite { what, value });
    }
    let input = report.input.name.to_string();
    match report.positions[..] {
        [first, _, ..] if report.positions.iter().all(|x| *x == first) => {
            mistakes.push(Mistake::Still { input, at: first });
        }
        _ => mistakes.extend(turning_position(report)),
    }
}

/// The first position that does not go on as those before it do: neither an axis nor a player could
/// tell it from an earlier one.
fn turning_position(report: &Report) -> Option<Mistake> {
    let mut steps = report.positions.windows(2);
    let rises = steps
        .find(|pair| pair[0] != pair[1])
        .is_some_and(|pair| pair[1] > pair[0]);
    let goes_on = |pair: &[f64]| match rises {
        true => pair[1] > pair[0],
        false => pair[1] < pair[0],
    };
    let mut pairs = report.positions.windows(2).enumerate();
    // A number that is not finite is reported by itself.
    let (row, pair) =
        pairs.find(|(_, pair)| pair.iter().all(|x| x.is_finite()) && !goes_on(pair))?;
    Some(Mistake::Turning {
        input: report.input.name.to_string(),
        index: row + 1,
        values: [pair[0], pair[1]],
        rises,
    })
}

fn check_picture(report: &Report, mistakes: &mut Vec<Mistake>) {
    let pictures = report.tables.iter().filter(|t| t.heading.picture.is_some());
    let functions: Vec<String> = pictures.map(|t| t.heading.function.to_string()).collect();
    if functions.len() > 1 {
        mistakes.push(Mistake::Pictures { functions });
    }
    let Some(shown) = positioned_picture::find_picture(report) else {
        if let Some(name) = report.traces.first() {
            mistakes.push(Mistake::NoPicture {
                wanted: std::format!("the path of `{name}`"),
                functions: tables::function_names(&report.tables),
            });
        }
        return;
    };
    check_forces(report, shown.picture, mistakes);
    for name in &report.traces {
        if point_named(shown.picture, name).is_none() {
            mistakes.push(Mistake::Unknown {
                kind: "point",
                name: name.to_string(),
                known: drawn_names(shown.picture),
            });
        }
    }
}

fn check_forces(report: &Report, picture: &Picture, mistakes: &mut Vec<Mistake>) {
    let names = || report.tables.iter().flat_map(Saved::columns);
    let vectors = || names().filter_map(|(column, _)| column.name.strip_suffix(".x"));
    for (point, quantity) in &report.forces {
        if point_named(picture, point).is_none() {
            mistakes.push(Mistake::Unknown {
                kind: "point",
                name: point.clone(),
                known: drawn_names(picture),
            });
        }
        if !vectors().any(|name| name == quantity) {
            mistakes.push(Mistake::Unknown {
                kind: "vector",
                name: quantity.clone(),
                known: vectors().map(String::from).collect(),
            });
        }
    }
}

fn check_parameters(report: &Report, mistakes: &mut Vec<Mistake>) {
    let dimensions = report.dimensions.len();
    if dimensions == 0 {
        return;
    }
    for column in report.tables.iter().flat_map(|table| table.heading.columns) {
        if let Meaning::Sensitivity { parameter, .. } = column.meaning
            && parameter >= dimensions
        {
            mistakes.push(Mistake::Parameter {
                column: column.name.to_string(),
                parameter,
                dimensions,
            });
        }
    }
}

fn check_given(report: &Report, mistakes: &mut Vec<Mistake>) {
    let arguments = report
        .tables
        .iter()
        .flat_map(|table| table.heading.arguments);
    let beside: Vec<&str> = arguments
        .copied()
        .filter(|name| *name != report.input.name)
        .collect();
    for (name, value) in &report.given {
        if !beside.contains(&name.as_str()) {
            let mut known: Vec<String> = beside.iter().map(ToString::to_string).collect();
            known.sort();
            known.dedup();
            mistakes.push(Mistake::Unknown {
                kind: "argument",
                name: name.to_string(),
                known,
            });
        }
        if !value.is_finite() {
            let what = std::format!("the argument `{name}`");
            mistakes.push(Mistake::NotFinite {
                what,
                value: *value,
            });
        }
    }
}

fn check_speed(report: &Report, mistakes: &mut Vec<Mistake>) {
    if let Some(speed) = report.speed {
        for (what, value) in [
            ("the speed", speed.omega),
            ("the acceleration", speed.epsilon),
        ] {
            if !value.is_finite() {
                let what = std::format!("{what} of `{}`", report.input.name);
                mistakes.push(Mistake::NotFinite { what, value });
            }
        }
    }
    let accelerates = report.speed.is_some_and(|speed| speed.epsilon != 0.0);
    if !accelerates {
        return;
    }
    for table in &report.tables {
        for column in table.heading.columns {
            if let Meaning::Rate { order: 2, .. } = column.meaning
                && rates::first_derivative(report, table, column).is_none()
            {
                mistakes.push(Mistake::Velocity {
                    column: column.name.to_string(),
                    of: table.base_name(column).map(|name| std::format!("`{name}`")),
                });
            }
        }
    }
}
