//! The engine in JavaScript: it closes loops and evaluates functions in a browser, as
//! `linkage-runtime` does for generated Rust. It contains centres and windings of angles, groups
//! without a closed form, and closure errors. The descriptions of mechanisms are written for it.

use linkage_core::{certificate, range_check};

/// The parts of the engine as they are stored: a later one uses those before it, and `CORE.` is
/// followed by the name of a constant of `linkage-core`.
pub const ENGINE: [&str; 6] = [
    include_str!("engine/elementary.js"),
    include_str!("engine/numbers.js"),
    include_str!("engine/follow.js"),
    include_str!("engine/revolutions.js"),
    include_str!("engine/coupled.js"),
    include_str!("engine/assemble.js"),
];

/// Parts that modules have after the engine, and pages do not. The function `mechanismOf` of the
/// last part makes the public interface of a module from a description.
pub const MODULE: [&str; 2] = [
    include_str!("engine/range.js"),
    include_str!("engine/mechanism.js"),
];

/// The part of pages of reports alone, after those: other assemblies of groups without a closed
/// form.
pub const OTHERS: &str = include_str!("engine/others.js");

/// The integrator of motions under forces, for pages of motions alone. It needs nothing else.
pub const INTEGRATOR: &str = include_str!("engine/integrator.js");

/// Returns the engine as text, with the constants of `linkage-core`.
pub fn engine() -> String {
    with_constants(&ENGINE.join("\n"))
}

/// Returns the engine of a module as text, with the constants of `linkage-core`.
pub fn module_engine() -> String {
    with_constants(&[&ENGINE[..], &MODULE].concat().join("\n"))
}

/// Writes the values of constants of `linkage-core` where the sources of the engine have `CORE.`
/// and a name.
pub fn with_constants(source: &str) -> String {
    let mut parts = source.split("CORE.");
    let mut text = String::from(parts.next().unwrap_or_default());
    for part in parts {
        let end = part.find(|c: char| !(c.is_ascii_uppercase() || c == '_'));
        let (name, rest) = part.split_at(end.unwrap_or(part.len()));
        match constant(name) {
            Some(value) => text += &value,
            None => unreachable!("linkage-core has no constant {name} for the engine"),
        }
        text += rest;
    }
    text
}

/// Returns a constant of `linkage-core` as JavaScript.
fn constant(name: &str) -> Option<String> {
    let number = match name {
        "FIRST_CORRECTION" => certificate::FIRST_CORRECTION,
        "ALLOWED_CONTRACTION" => certificate::ALLOWED_CONTRACTION,
        "CORRECTIONS" => certificate::CORRECTIONS as f64,
        "SETTLED" => certificate::SETTLED,
        "SCALES" => {
            let scales = certificate::SCALES.map(literal);
            return Some(format!("[{}]", scales.join(", ")));
        }
        "CORRECTION_LIMIT" => certificate::CORRECTION_LIMIT,
        "ROUNDINGS" => certificate::ROUNDINGS,
        "COMFORTABLE_STRAY" => certificate::COMFORTABLE_STRAY,
        "MOST_STRAY" => certificate::MOST_STRAY,
        "MOST_MIDDLE" => certificate::MOST_MIDDLE,
        "DEAD" => range_check::DEAD,
        "END" => range_check::END,
        "AT_END" => range_check::AT_END,
        "ROUNDING" => range_check::ROUNDING,
        "SAMPLES" => range_check::SAMPLES,
        "LEAST_SAMPLES" => range_check::LEAST_SAMPLES,
        "MOST_SAMPLES" => range_check::MOST_SAMPLES,
        _ => return None,
    };
    Some(literal(number))
}

/// Returns a number with the fewest digits, without a point for whole numbers.
fn literal(number: f64) -> String {
    let text = format!("{number:?}");
    match text.strip_suffix(".0") {
        Some(whole) => whole.to_owned(),
        None => text,
    }
}
