//! Angles with turns: by the closed form if one of the vectors that they are found from decides,
//! else followed through the ranges.

use std::fmt::Write;

use linkage_export::{Declarations, RefusalCause};

use crate::surface::Surface;
use crate::template::fill;
use crate::writer::{Writer, used, written};

/// The type of the turns of all angles; nothing if no angle counts them.
pub(crate) fn turns_type(surface: &Surface) -> String {
    let Surface {
        declarations: Declarations { unit, private, .. },
        real,
        ..
    } = surface;
    let (angles, inputs) = (unit.angles.len(), unit.inputs.len().max(1));
    match angles {
        0 => String::new(),
        _ => format!(
            "/* An angle is the one of its direction nearest to centre + the sum of winding * input. */\n\
             typedef struct {private}turns {{ {real} centre[{angles}], winding[{angles}][{inputs}]; }} {private}turns;\n\n",
            real = real.name()
        ),
    }
}

/// Writes the functions that find the turns; nothing if no angle counts them.
pub(crate) fn items(writer: &mut Writer) {
    let surface = writer.surface;
    let unit = surface.declarations.unit;
    if unit.angles.is_empty() {
        return;
    }
    writer.plain(
        "directions",
        &unit.directions,
        "Cosine and sine, of some length, of each angle whose turns are counted.",
    );
    bearings(writer);
    for helper in ["nan", "infinite", "whole", "hypot", "atan2", "angle_near"] {
        writer.printer.helpers.need(helper);
    }
    let text = tables(surface);
    writer.text += &text;
    let rates = unit.inputs.iter().map(|input| input.rates.len()).max();
    let number = |word: &str| {
        Some(match word {
            "MECHANISM" => surface.declarations.name.clone(),
            "DIRECTIONS" => (2 * unit.angles.len()).to_string(),
            "BEARINGS" => unit.bearings.outputs.len().max(1).to_string(),
            "ANGLES" => unit.angles.len().to_string(),
            "INPUTS" => unit.inputs.len().max(1).to_string(),
            "NO_TURNS" => surface.code(RefusalCause::NoTurns(0)).to_string(),
            "RATES" => rates.unwrap_or(0).max(1).to_string(),
            _ => return None,
        })
    };
    for template in [
        include_str!("templates/follow.c"),
        include_str!("templates/wind.c"),
    ] {
        writer.text += &fill(
            template,
            surface.real,
            &surface.declarations.private,
            number,
        );
        writer.text.push('\n');
    }
}

/// The vectors of all angles, where all inputs are 0.
fn bearings(writer: &mut Writer) {
    let surface = writer.surface;
    let printed = writer.printed(&surface.declarations.unit.bearings);
    let body = used(&["m", "out"], written(&printed));
    let (private, prefix, real) = (
        &surface.declarations.private,
        &surface.declarations.name,
        surface.real.name(),
    );
    writer.text += "/* The vectors that angles are found from, where all inputs are 0. */\n";
    let _ = writeln!(
        writer.text,
        "static void {private}bearings(const {prefix} *m, {real} *out)\n{{\n{body}}}\n"
    );
}

/// Returns the tables of facts about each angle.
fn tables(surface: &Surface) -> String {
    let Surface {
        declarations:
            Declarations {
                unit,
                private,
                angles,
                ..
            },
        real,
        ..
    } = surface;
    let name = real.name();
    let numbers = |all: &[f64]| list(all.iter().map(|x| real.literal(*x)), "0");
    let indices = |all: &[usize]| list(all.iter().map(usize::to_string), "0");
    let estimates = numbers(&angles.estimates);
    let phases = angles.phase_turns.iter();
    let turning = phases
        .clone()
        .map(|turns| u8::from(turns.is_some()).to_string());
    let turning = list(turning, "0");
    let inputs = unit.inputs.len().max(1);
    let none = vec![0.0; inputs];
    let turns = phases.map(|turns| numbers(turns.as_ref().unwrap_or(&none)));
    let turns = list(turns, "{ 0 }");
    let first_phase = indices(&angles.first_phase);
    let first_along = indices(&angles.first_along);
    let along = angles.along.iter().map(|along| {
        let (low, high) = (real.literal(along.low), real.literal(along.high));
        format!(
            "{{ {}, {low}, {high}, {}, {} }}",
            along.input, along.first_rate, along.rates
        )
    });
    let along = list(along, "{ 0, 0, 0, 0, 0 }");
    let rates = numbers(&angles.rates);
    format!(
        "/* For each angle: its value at the reference, about; its vectors, whether they turn with the inputs alone, and how often; the inputs that it is\n   \
         followed along, over which range, and which rates are tried. */\n\
         static const {name} {private}estimates[] = {estimates};\n\
         static const int {private}first_phase[] = {first_phase};\n\
         static const int {private}turning[] = {turning};\n\
         static const {name} {private}phase_turns[][{inputs}] = {turns};\n\
         typedef struct {private}along {{ int input; {name} low, high; int first_rate, rates; }} {private}along;\n\
         static const int {private}first_along[] = {first_along};\n\
         static const {private}along {private}all_along[] = {along};\n\
         static const {name} {private}rates[] = {rates};\n\n"
    )
}

/// An initializer; an array of nothing is not C.
fn list(entries: impl Iterator<Item = String>, nothing: &str) -> String {
    let entries: Vec<String> = entries.collect();
    match entries.is_empty() {
        true => format!("{{ {nothing} }}"),
        false => format!("{{ {} }}", entries.join(", ")),
    }
}
