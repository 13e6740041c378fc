//! The report as JSON, the input of the page.

mod live;
mod motion_data;
mod packed;
mod series;
mod signs;

use serde_json::{Value, json};
use std::string::{String, ToString};
use std::vec::Vec;

use super::accuracy::BandKind;
use super::builder::Report;
use super::palette::{Palette, Style};
use super::positioned_picture::{PositionedPicture, point_named};
use super::rates::True;
use super::tables::Saved;
use super::traced_points::traced_points;
use super::{
    accuracy, check, downsample, machine, missing, palette, positioned_picture, rates, summary,
};
use linkage_core::{GuideOn, GuideShape, Meaning, PointKind};
use linkage_formats::ReportError;
use linkage_runtime::{Column, Operations, Structure};
use series::Series;

/// Returns the whole report as JSON.
pub(super) fn report_json(report: &Report) -> Result<String, ReportError> {
    check::check(report)?;
    Ok(report_value(report, Series::new(report, None, false)).to_string())
}

/// Returns the JSON of the page, with packed numbers and without the rows that it does not show.
pub(super) fn page_json(report: &Report) -> Result<String, ReportError> {
    check::check(report)?;
    let rows = downsample::page_rows(report);
    Ok(report_value(report, Series::new(report, rows.as_deref(), true)).to_string())
}

fn report_value(report: &Report, series: Series<'_>) -> Value {
    let hues = palette::palette(report);
    let (bands, accuracy) = tolerance_values(report, &series);
    let tables = report.tables.iter().enumerate();
    let mut value = json!({
        "title": report.title,
        "about": report.about,
        "notes": positioned_picture::all_notes(report),
        "input": {
            "name": report.input.name,
            "unit": report.input.unit,
            "values": series.picked(&report.positions),
            "periodic": missing::is_periodic(report),
        },
        "thinned": series.rows.map(|rows| json!({ "rows": rows.len(), "of": report.positions.len() })),
        "tables": list(tables, |(index, table)| table_value(report, &series, &hues, index, table)),
        "bands": bands,
        "accuracy": accuracy,
        "speed": report.speed.map(|s| json!({ "omega": s.omega, "epsilon": s.epsilon })),
        "true": list(rates::true_rates(report), |rate| coloured(true_value(&series, &rate), &hues, rate.column.name)),
        "picture": positioned_picture::find_picture(report).map(|shown| picture_value(report, &series, &hues, &shown)),
        "structure": report.structure.map(|structure| structure_value(report, &structure)),
        "dimensions": list(&report.dimensions, |d| json!({
            "name": d.parameter.name,
            "unit": d.parameter.unit,
            "nominal": d.parameter.nominal,
            "tolerance": d.parameter.tolerance,
            "value": d.value,
        })),
        "summary": list(&summary::summary_rows(report), |row| json!({
            "quantity": row.quantity,
            "what": row.what,
            "value": row.value,
            "unit": row.unit,
            "at": row.at,
        })),
        "facts": list(&report.facts, |f| json!({ "name": f.name, "text": f.text })),
        "gaps": list(missing::gaps(report), |gap| json!({ "from": gap.from, "to": gap.to })),
        "live": (!report.programs.is_empty()).then(|| live::live_value(report)),
    });
    if let Some(cyclogram) = &report.cyclogram {
        value["cyclogram"] = machine::cyclogram_value(report, cyclogram);
    }
    value
}

fn table_value(
    report: &Report,
    series: &Series<'_>,
    hues: &Palette,
    index: usize,
    table: &Saved,
) -> Value {
    let columns = table.heading.columns.iter().enumerate();
    json!({
        "function": table.heading.function,
        "columns": list(columns, |(at, column)| {
            coloured(column_value(report, table, column, series.column(index, at)), hues, column.name)
        }),
    })
}

fn column_value(report: &Report, table: &Saved, column: &Column, values: Value) -> Value {
    let mut value = json!({
        "name": column.name,
        "unit": column.unit,
        "meaning": meaning(column.meaning),
        "values": values,
    });
    if let Some(of) = table.base_name(column) {
        value["of"] = json!(of);
    }
    match column.meaning {
        Meaning::Rate { order, .. } => value["order"] = json!(order),
        Meaning::Sensitivity { parameter, .. } => {
            if let Some(dimension) = report.dimensions.get(parameter) {
                value["parameter"] = json!(dimension.parameter.name);
            }
        }
        Meaning::Value | Meaning::Margin | Meaning::Picture => {}
    }
    value
}

/// Bands, and the table of accuracy.
fn tolerance_values(report: &Report, series: &Series<'_>) -> (Vec<Value>, Vec<Value>) {
    let mut bands = Vec::new();
    let mut accuracy = Vec::new();
    for sensitive in accuracy::sensitive(report) {
        if sensitive.column.is_some() {
            bands.extend([BandKind::WorstCase, BandKind::Statistical].map(|kind| {
                json!({
                    "table": sensitive.table.heading.function,
                    "column": sensitive.name,
                    "kind": kind.name(),
                    "half": series.other(&sensitive.half(kind)),
                })
            }));
        }
        if let Some(worst) = sensitive.worst(&report.positions) {
            accuracy.push(json!({
                "quantity": sensitive.name,
                "unit": sensitive.unit,
                "at": worst.at,
                "worst": worst.worst,
                "statistical": worst.statistical,
                "contributions": list(worst.contributions, |(parameter, amount)| {
                    json!({ "parameter": parameter, "amount": amount })
                }),
            }));
        }
    }
    (bands, accuracy)
}

fn picture_value(
    report: &Report,
    series: &Series<'_>,
    hues: &Palette,
    shown: &PositionedPicture<'_>,
) -> Value {
    let picture = shown.picture;
    let points = picture.points.iter().enumerate();
    let directions = picture.directions.iter().enumerate();
    let mut value = json!({
        "dimension": picture.dimension,
        "unit": shown.unit,
        "points": list(points, |(index, point)| json!({
            "name": point.name,
            "kind": match point.kind {
                PointKind::Ground => "ground",
                PointKind::Joint => "joint",
                PointKind::Tip => "tip",
                PointKind::Loose => "loose",
                PointKind::Construction => "construction",
            },
            "at": list(shown.point(index), |values| series.other(values)),
            "colour": hues.named(point.name),
        })),
        "directions": list(directions, |(index, name)| json!({
            "name": name,
            "at": list(shown.direction(index), |values| series.other(values)),
        })),
        "links": list(picture.links, |link| json!({ "name": link.name, "points": link.points })),
        "guides": list(picture.guides, |guide| json!({
            "name": guide.name,
            "origin": guide.origin,
            "direction": guide.direction,
            "slider": guide.slider,
            "on": match guide.on {
                GuideOn::Frame => json!("frame"),
                GuideOn::Link(link) => json!(link),
                GuideOn::Itself => json!("itself"),
            },
            "shape": match guide.shape {
                GuideShape::Slot => "slot",
                GuideShape::Cylinder => "cylinder",
                GuideShape::Arc => "arc",
            },
        })),
        "axes": list(picture.axes, |axis| {
            json!({ "point": axis.point, "direction": axis.direction })
        }),
        "traces": traced_points(report, shown),
    });
    signs::add(&mut value, shown);
    if !report.forces.is_empty() {
        let forces = report.forces.iter();
        value["forces"] = json!(list(forces, |(point, quantity)| json!({
            "point": point_named(picture, point),
            "quantity": quantity,
        })));
    }
    if let Some(view) = report.view {
        value["view"] = json!(view);
    }
    if !picture.parts.is_empty() {
        value["parts"] = json!(list(picture.parts, |part| json!({
            "name": part.name,
            "points": part.points,
            "links": part.links,
            "guides": part.guides,
        })));
    }
    value
}

fn structure_value(report: &Report, structure: &Structure) -> Value {
    let sign = |mode| report.modes.get(mode).map(|mode| std::format!("{mode}"));
    json!({
        "mobility": structure.mobility,
        "groups": list(structure.groups, |group| json!({
            "kind": group.kind,
            "class": group.class,
            "order": group.order,
            "mode": group.mode.and_then(sign),
            "loops": group.loops,
            "joints": group.joints,
            "unknowns": group.unknowns,
            "method": group.method,
        })),
        "functions": list(structure.functions, |function| json!({
            "name": function.name,
            "operations": operations(&function.operations),
            "total": function.operations.total(),
        })),
        "prepare": operations(&structure.prepare),
    })
}

fn true_value(series: &Series<'_>, rate: &True) -> Value {
    let mut value = json!({
        "table": rate.table,
        "name": rate.column.name,
        "unit": rate.unit,
        "meaning": "rate",
        "order": rate.order,
        "values": series.other(&rate.values),
    });
    if let Some(of) = rate.of {
        value["of"] = json!(of);
    }
    value
}

/// With the number of its colour and of its dashes among those of curves.
fn coloured(mut column: Value, hues: &Palette, name: &str) -> Value {
    if let Some(Style { hue, dash }) = hues.style(name) {
        column["colour"] = json!(hue);
        column["dash"] = json!(dash);
    }
    column
}

fn list<T>(items: impl IntoIterator<Item = T>, value: impl FnMut(T) -> Value) -> Vec<Value> {
    items.into_iter().map(value).collect()
}

const fn meaning(meaning: Meaning) -> &'static str {
    match meaning {
        Meaning::Value => "value",
        Meaning::Rate { .. } => "rate",
        Meaning::Sensitivity { .. } => "sensitivity",
        Meaning::Margin => "margin",
        Meaning::Picture => "picture",
    }
}

fn operations(operations: &Operations) -> Value {
    json!({
        "add": operations.add,
        "mul": operations.mul,
        "div": operations.div,
        "sqrt": operations.sqrt,
        "sin_cos": operations.sin_cos,
        "atan2": operations.atan2,
        "other": operations.other,
    })
}
