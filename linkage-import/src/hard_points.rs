//! Hard points of wheel suspensions: tables of named points. Axes, unit and side are named by the
//! user, because the tables do not have them.

mod axes;
mod holding_links;
mod moving_parts;
mod point_table;
mod rocker;
mod roles;
mod suspension;
mod text;
mod travel_input;
mod wheel_travel;

use std::fmt::Write;

use crate::error::ImportError;
use crate::imported::Import;
use crate::names::{file as file_name, in_comment, shown, stem, type_name};
use crate::number::short;
use crate::options::Options;
use crate::wrapped::{comment, warnings_as_comments};
use axes::Meaning;
use roles::Points;
use suspension::Suspension;

/// Reads a table and writes it as a mechanism.
pub(crate) fn import(content: &[u8], file: &str, options: &Options) -> Result<Import, ImportError> {
    let text = std::str::from_utf8(content)
        .map_err(|_| ImportError::new("the file is no text in UTF-8"))?;
    let text = text.trim_start_matches('\u{feff}');
    let ending = file.rsplit_once('.').map_or("", |parts| parts.1);
    let ending = ending.to_ascii_lowercase();
    let mut lines = text
        .lines()
        .filter(|line| !line.trim_start().starts_with('#'));
    let first = lines.next().unwrap_or_default();
    let is_yaml = match ending.as_str() {
        "yaml" | "yml" | "json" => true,
        "csv" | "tsv" => false,
        _ => first.contains(':') || first.starts_with("---") || first.starts_with('{'),
    };
    let table = match is_yaml {
        true => point_table::yaml(text)?,
        false => point_table::csv(text)?,
    };
    let meaning = Meaning::of_options(options)?;
    let points = roles::points(table, &meaning, options)?;
    let suspension = Suspension::new(&points, &meaning)?;
    let input = travel_input::input(&suspension, &points)?;
    let mut warnings = suspension.warnings.clone();
    if !points.others.is_empty() {
        warnings.push(format!("not taken: {}", points.others.join(", ")));
    }
    let unused: Vec<&str> = points
        .by_role
        .keys()
        .copied()
        .filter(|role| suspension.position(role).is_none())
        .collect();
    if !unused.is_empty() {
        warnings.push(format!("points without use: {}", unused.join(", ")));
    }
    let drawn = suspension.drawn();
    warnings.extend(drawn.confirmation());
    let name = type_name(options.mechanism.as_deref().unwrap_or(stem(file)));
    let text = written(
        &suspension,
        &points,
        &meaning,
        [&input, &name, file],
        &warnings,
    );
    Ok(Import {
        text,
        warnings,
        drawn,
    })
}

fn written(
    suspension: &Suspension,
    points: &Points,
    meaning: &Meaning,
    [input, name, file]: [&str; 3],
    warnings: &[String],
) -> String {
    let side = if meaning.is_left { "left" } else { "right" };
    let kind = points.kind;
    let file = in_comment(&shown(file_name(file)));
    let mut text = String::new();
    let words = format!("From {file}: a {kind}, {side} side. x is forward, y left, z up.");
    comment(&mut text, "// ", &words);
    let band = short(points.band);
    let words = format!(
        "Each coordinate may be wrong by {band}{}: no length is exact.",
        meaning.unit
    );
    comment(&mut text, "// ", &words);
    warnings_as_comments(&mut text, warnings);
    let _ = writeln!(text, "\n/// A suspension: {kind}.\npub struct {name} {{");
    text::items(suspension, input, points.band, &mut text);
    text.push_str("}\n");
    text::functions(suspension, name, &mut text);
    text
}
