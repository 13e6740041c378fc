//! The check of the declared range.

use std::fmt::Write;

use linkage_compiler::ir::Group;
use linkage_core::range_check::{AT_END, DEAD, END, ROUNDING, Slack, samples};
use linkage_export::Declarations;

use crate::comment::comment;
use crate::real::Real;
use crate::surface::{API, KINDS, OFF, RangeNames, Surface};
use crate::template::fill;
use crate::writer::Writer;

/// The criteria of the search: the slack of a dead point, the size of rounding, the share of a
/// range at its ends where a dead point is allowed, and the share of it within which a place is at
/// its end.
struct Criteria {
    dead: f64,
    rounding: f64,
    end: f64,
    at_end: f64,
}

impl Criteria {
    fn for_real(real: Real) -> Self {
        match real {
            Real::Double | Real::Fused => Self {
                dead: DEAD,
                rounding: ROUNDING,
                end: END,
                at_end: AT_END,
            },
            // 16 roundoffs: what discriminants are rounded by is 8 of them. A slack that is zero as
            // a square does not say more than half of the digits of its place.
            Real::Single => Self {
                dead: 2e-6,
                rounding: 1e-6,
                end: 1e-6,
                at_end: 5e-4,
            },
        }
    }
}

/// Type, constants and function in the header.
pub(crate) fn declared(surface: &Surface) -> String {
    let Surface {
        declarations: Declarations { unit, .. },
        real,
        range: RangeNames {
            check_range,
            finding,
        },
        ..
    } = surface;
    let Some((input, _)) = unit.checked() else {
        return match unit
            .inputs
            .iter()
            .filter(|entry| entry.range.is_some())
            .count()
        {
            0 | 1 => String::new(),
            _ => {
                comment(
                    "",
                    "The ranges are not checked for change points and dead points: several inputs have one.",
                ) + "\n"
            }
        };
    };
    let number = real.name();
    let input = &unit.inputs[input];
    let what = match input.range {
        Some(_) => format!("the range of `{}`", input.name),
        None => format!("a turn of `{}`, which has no range,", input.name),
    };
    let mut text = comment(
        "",
        "What is found in a range: a change point, where the mechanism may go on in another assembly; a dead point, beyond which it does not \
         close; a gap, which ends at `to`; a place without a finite number.",
    );
    text += "enum {\n";
    let kinds = KINDS.iter().enumerate();
    let kinds = kinds.map(|(k, kind)| format!("    {} = {}", surface.kind(kind), k + 1));
    let _ = writeln!(text, "{}\n}};\n", kinds.collect::<Vec<_>>().join(",\n"));
    let _ = writeln!(
        text,
        "typedef struct {finding} {{\n    int kind; /* one of these constants */\n    int group; /* the group that it is about, from 0 */\n    \
         {number} from, to; /* where it begins and ends */\n    {number} miss; /* by how much the group misses closing at worst */\n}} \
         {finding};\n"
    );
    text += &comment(
        "",
        &format!(
            "Searches {what} for places where the assembly ends, or may go on in another one. Returns how many there are, 0 if there is none, \
             and writes the first `room` of them. Some thousand evaluations: for the start, not for the loop."
        ),
    );
    let _ = writeln!(text, "{};\n", check_range.signature);
    text
}

/// The function.
pub(crate) fn items(writer: &mut Writer) {
    let surface = writer.surface;
    let (unit, prefix, private) = surface.unit_and_prefixes();
    let Surface {
        real,
        range: RangeNames {
            check_range,
            finding,
        },
        ..
    } = surface;
    let Some((input, (low, high))) = unit.checked() else {
        return;
    };
    let off = surface.constant(OFF);
    let _ = writeln!(writer.text, "#ifndef {off}");
    writer.plain(
        "range_slacks",
        &unit.slacks(),
        "How far each group is from its dead point.",
    );
    let own_input = &unit.inputs[input];
    let reference = own_input.reference;
    let count = samples(high - low, own_input.angle);
    let steps = |from: f64, to: f64| match to > from {
        true => ((count as f64 * ((to - from) / (high - low))) as usize).max(1),
        false => 0,
    };
    let criteria = Criteria::for_real(*real);
    let flags = |is: fn(&Group) -> bool| {
        let flags = unit
            .groups
            .iter()
            .map(|entry| u8::from(is(entry)).to_string());
        format!("{{ {} }}", flags.collect::<Vec<_>>().join(", "))
    };
    let references = unit.inputs.iter().map(|item| real.literal(item.reference));
    let references: Vec<String> = references.collect();
    let text = fill(include_str!("templates/range.c"), *real, private, |word| {
        Some(match word {
            "MECHANISM" => prefix.to_owned(),
            "API" => surface.constant(API),
            "CHECK" => check_range.name.clone(),
            "FINDING" => finding.clone(),
            "GROUPS" => unit.groups.len().to_string(),
            "INPUTS" => unit.inputs.len().to_string(),
            "INPUT" => input.to_string(),
            "AT" => format!("{{ {} }}", references.join(", ")),
            "LOW" => real.literal(low),
            "HIGH" => real.literal(high),
            "REFERENCE" => real.literal(reference),
            "BELOW" => steps(low, reference).to_string(),
            "ABOVE" => steps(reference, high).to_string(),
            "DECLARED" => u8::from(own_input.range.is_some()).to_string(),
            "TABLES" => flags(|other| other.slack == Slack::Prepared),
            "SINGLE" => flags(|entry| entry.slack == Slack::Signed),
            "RELATIVE" => flags(|entry| matches!(entry.slack, Slack::Signed | Slack::Relative)),
            "DEAD" => real.literal(criteria.dead),
            "ROUNDING" => real.literal(criteria.rounding),
            "END" => real.literal(criteria.end),
            "AT_END" => real.literal(criteria.at_end),
            "LARGEST" => match real {
                Real::Double | Real::Fused => "DBL_MAX".to_owned(),
                Real::Single => "FLT_MAX".to_owned(),
            },
            kind if KINDS.contains(&kind) => surface.kind(kind),
            _ => return None,
        })
    });
    writer.text += &text;
    writer.text += "#endif\n\n";
}
