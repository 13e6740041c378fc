//! Assembling: are dimensions numbers, how do angles turn, do the groups close?

use std::fmt::Write;

use linkage_export::{Declarations, RefusalCause};

use crate::comment::comment;
use crate::coupled::deciding;
use crate::real::Real;
use crate::surface::{Surface, Why};
use crate::template::fill;
use crate::writer::{Writer, used};

/// Writes the function that computes the values that depend on the dimensions alone.
pub(crate) fn prepare(writer: &mut Writer) {
    let (unit, prefix, private) = writer.surface.unit_and_prefixes();
    let printed = writer.printed(&unit.prepare);
    let mut body = printed.statements;
    for (slot, value) in printed.results.iter().enumerate() {
        let _ = writeln!(body, "    m->prepared[{slot}] = {value};");
    }
    let takes = match unit.angles.is_empty() {
        true => format!("{prefix} *m"),
        false => format!("{prefix} *m, const {private}turns *turns"),
    };
    writer.text += &comment("", "What depends on the dimensions alone.");
    let body = used(&["m", "turns"][..takes.matches('*').count()], body);
    let _ = writeln!(
        writer.text,
        "static void {private}prepare({takes})\n{{\n{body}}}\n"
    );
}

/// The function that says whether the groups close; nothing if nobody asks for it.
pub(crate) fn close(writer: &mut Writer) {
    let surface = writer.surface;
    let (unit, prefix, private) = surface.unit_and_prefixes();
    let real = surface.real;
    if unit.groups.is_empty() {
        if !unit.angles.is_empty() {
            let number = real.name();
            let _ = writeln!(
                writer.text,
                "/* There is nothing to close. */\nstatic int {private}close(const {prefix} *m, const {number} *at)\n{{\n    \
                 (void)m;\n    (void)at;\n    return 0;\n}}\n"
            );
        }
        return;
    }
    writer.plain("gaps", &unit.gaps, "By how much each group misses closing.");
    let text = overflows(surface);
    writer.text += &text;
    let numbers = |cause: fn(usize) -> RefusalCause| {
        let numbers = (0..unit.groups.len()).map(|group| surface.code(cause(group)).to_string());
        format!("{{ {} }}", numbers.collect::<Vec<_>>().join(", "))
    };
    let close = fill(include_str!("templates/close.c"), real, private, |word| {
        Some(match word {
            "MECHANISM" => prefix.to_owned(),
            "GROUPS" => unit.groups.len().to_string(),
            "OPEN" => numbers(RefusalCause::CannotClose),
            "UNDEFINED" => numbers(RefusalCause::Undefined),
            "TOO_LARGE" => surface.code(RefusalCause::TooLarge).to_string(),
            _ => return None,
        })
    });
    writer.text += &close;
    writer.text.push('\n');
}

/// Returns the function that checks for overflow in numbers computed from a dimension.
fn overflows(surface: &Surface) -> String {
    let Surface {
        declarations: Declarations { private, .. },
        real,
        dimensions_type,
        ..
    } = surface;
    // Squares of larger numbers overflow.
    let (abs, largest) = match real {
        Real::Double | Real::Fused => ("fabs", 1e154),
        Real::Single => ("fabsf", 1e19),
    };
    let largest = real.literal(largest);
    let one = |scalar: &String| format!("{abs}(dimensions->{scalar}) > {largest}");
    let all: Vec<String> = surface.declarations.scalars.iter().map(one).collect();
    let body = match all.is_empty() {
        true => "    (void)dimensions;\n    return 0;\n".to_owned(),
        false => format!("    return {};\n", all.join("\n        || ")),
    };
    format!(
        "/* Whether a dimension is so large that its square is beyond the largest number. */\n\
         static int {private}overflows(const {dimensions_type} *dimensions)\n{{\n{body}}}\n\n"
    )
}

/// The function that assembles.
pub(crate) fn assemble(writer: &mut Writer) {
    let surface = writer.surface;
    let Surface {
        declarations: Declarations { unit, private, .. },
        real,
        assemble,
        ..
    } = surface;
    let mut declared = String::new();
    if !(unit.groups.is_empty() && unit.angles.is_empty()) {
        let references = unit
            .inputs
            .iter()
            .map(|input| real.literal(input.reference));
        let mut references: Vec<String> = references.collect();
        if references.is_empty() {
            references.push("0".to_owned());
        }
        let _ = writeln!(
            declared,
            "    static const {} at[] = {{ {} }}; /* {} */",
            real.name(),
            references.join(", "),
            surface.declarations.reference
        );
    }
    let coupled = !unit.coupled.is_empty();
    declared += "    int code;\n";
    let (turn, prepared) = match unit.angles.is_empty() {
        true => (String::new(), format!("    {private}prepare(m);\n")),
        false => {
            let _ = writeln!(declared, "    {private}turns turns;");
            let fails = match coupled {
                true => format!(
                    "return m->moved && {private}too_far(m, at) != 0 ? {private}too_far(m, at) : code;"
                ),
                false => "return code;".to_owned(),
            };
            (
                format!("    code = {private}turn(m, at, &turns);\n    if (code != 0) {fails}\n"),
                format!("    {private}prepare(m, &turns);\n"),
            )
        }
    };
    let closed = match unit.groups.is_empty() {
        true => "0".to_owned(),
        false => format!("{private}close(m, at)"),
    };
    let (moved, reached) = match coupled {
        true => (
            format!("    m->moved = {};\n", moved(surface)),
            format!(
                "    code = m->moved ? {private}too_far(m, at) : 0;\n    if (code != 0) return code;\n"
            ),
        ),
        false => (String::new(), String::new()),
    };
    // What the test of the arithmetic reads.
    writer.printer.helpers.need("bits");
    let finite = finite(writer);
    let zero = real.literal(0.0);
    let _ = writeln!(
        writer.text,
        "{}\n{{\n{declared}    m->dimensions = *dimensions;\n    \
         m->miss = {zero};\n    code = {private}arithmetic();\n    if (code != 0) return code;\n{moved}{finite}{turn}{prepared}{reached}    return {closed};\n}}\n",
        assemble.signature
    );
}

/// Returns a condition: dimensions are not those of the tables.
fn moved(surface: &Surface) -> String {
    let nominal: Vec<f64> = surface
        .declarations
        .unit
        .scalars()
        .map(|scalar| scalar.nominal)
        .collect();
    let different = deciding(surface.declarations.unit)
        .into_iter()
        .map(|index| {
            let (scalar, nominal) = (
                &surface.declarations.scalars[index],
                surface.real.literal(nominal[index]),
            );
            format!("m->dimensions.{scalar} != {nominal}")
        });
    let different: Vec<String> = different.collect();
    match different.is_empty() {
        true => "0".to_owned(),
        false => different.join(" || "),
    }
}

/// Statements that return the number of a dimension that is none.
fn finite(writer: &mut Writer) -> String {
    let Surface {
        declarations: Declarations {
            private, scalars, ..
        },
        codes,
        ..
    } = writer.surface;
    let mut checks = String::new();
    for (index, code) in codes.iter().enumerate() {
        if let Why::Mechanism(RefusalCause::NotFinite(dimension)) = code.why {
            writer.printer.helpers.need("infinite");
            let scalar = &scalars[dimension];
            let _ = writeln!(
                checks,
                "    if ({private}infinite(m->dimensions.{scalar})) return {};",
                index + 1
            );
        }
    }
    checks
}

/// Writes the function that returns the size of the struct of the mechanism.
pub(crate) fn assembly_size(writer: &mut Writer) {
    let Surface {
        declarations: Declarations { name, .. },
        assembly_size,
        ..
    } = writer.surface;
    let signature = &assembly_size.signature;
    let _ = writeln!(
        writer.text,
        "{signature}\n{{\n    return sizeof({name});\n}}\n"
    );
}

/// The function that gives texts.
pub(crate) fn error(writer: &mut Writer) {
    let Surface {
        title,
        error,
        codes,
        ..
    } = writer.surface;
    let mut texts = vec![format!("{title}: assembled")];
    texts.extend(codes.iter().map(|code| code.text.clone()));
    let quoted = texts.iter().map(|entry| {
        format!(
            "        \"{}\"",
            entry.replace('\\', "\\\\").replace('"', "\\\"")
        )
    });
    let quoted = quoted.collect::<Vec<_>>().join(",\n");
    writer.text += &comment("", "One text for each number that assembling returns.");
    let _ = writeln!(
        writer.text,
        "{}\n{{\n    static const char *const texts[] = {{\n{quoted}\n    }};\n    \
         return code < 0 || code > {} ? \"{title}: assembling returns no such number\" : texts[code];\n}}\n",
        error.signature,
        codes.len()
    );
}
