//! Hard points of wheel suspensions: tables of named points. Axes, unit and side are named by the
//! user, because the tables do not have them.

mod axes;
mod moving_parts;
mod point_table;
mod rocker;
mod roles;
mod suspension;
mod wheel_travel;

use std::fmt::Write;

use crate::Import;
use crate::error::ImportError;
use crate::names::{in_comment, shown, type_name};
use crate::options::Options;
use axes::Meaning;
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
    let mut suspension = Suspension::new(&points, &meaning)?;
    let input = suspension.input(&points)?;
    let mut warnings = suspension.warnings.clone();
    if !points.others.is_empty() {
        warnings.push(format!("not taken: {}", points.others.join(", ")));
    }
    let unused: Vec<&str> = points
        .by_role
        .keys()
        .copied()
        .filter(|role| !is_used(&suspension, role))
        .collect();
    if !unused.is_empty() {
        warnings.push(format!("points without use: {}", unused.join(", ")));
    }
    let stem = file.rsplit(['/', '\\']).next().unwrap_or_default();
    let stem = stem.split_once('.').map_or(stem, |parts| parts.0);
    let name = type_name(options.mechanism.as_deref().unwrap_or(stem));
    let side = if meaning.is_left { "left" } else { "right" };
    let kind = points.kind;
    let mut out = format!(
        "// From {}: a {kind}, {side} side. x is forward, y left, z up.\n",
        in_comment(&shown(file))
    );
    for warning in &warnings {
        let _ = writeln!(out, "// {}", in_comment(warning));
    }
    let unit = meaning.unit;
    let _ = writeln!(
        out,
        "\n/// A suspension: {kind}.\npub struct {name} {{\n    unit {unit};\n\n    {input}\n"
    );
    for lines in [
        &suspension.parameters,
        &suspension.unknowns,
        &suspension.lets,
        &suspension.loops,
    ] {
        for line in lines {
            let _ = writeln!(out, "    {line}");
        }
        out.push('\n');
    }
    let quantities = suspension.quantities.join(", ");
    let out = out.trim_end();
    let text = format!(
        "{out}\n}}\n\nimpl {name} {{\n    /// Points, and what depends on the travel of the wheel.\n    pub fn motion(travel) -> Motion {{ {quantities} }}\n\n    /// The links, for the drawing.\n    pub fn shape(travel) -> Shape {{ shape: picture() }}\n}}\n"
    );
    Ok(Import {
        text,
        warnings,
        drawn: suspension.drawn(),
    })
}

/// True if a point is in the text.
fn is_used(suspension: &Suspension, role: &str) -> bool {
    if ["wheel_centre", "spindle"].contains(&role) {
        return true;
    }
    let mut lines = suspension.parameters.iter().chain(&suspension.lets);
    lines.any(|line| line.contains(&format!("{role} =")))
}
