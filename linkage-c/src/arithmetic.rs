//! A test of the arithmetic that results depend on, which `assemble` makes; and the test of a
//! number.

use std::fmt::Write;

use linkage_export::{Declarations, Helpers};

use crate::comment::comment;
use crate::real::Real;
use crate::surface::{Surface, Why};
use crate::template::fill;
use crate::writer::Writer;

/// Returns the function that tests rounding, digits and the order of sums; the sine, if the
/// mechanism has one, is tested with them.
pub(crate) fn arithmetic(surface: &Surface, helpers: &Helpers) -> String {
    let Surface {
        declarations: Declarations { private, .. },
        real,
        ..
    } = surface;
    let word = |word: &str| {
        Some(match word {
            "ROUNDING" => surface.code(Why::Rounding).to_string(),
            "DIGITS" => surface.code(Why::Digits).to_string(),
            "REORDERED" => surface.code(Why::Reordered).to_string(),
            "ROUNDOFF" => real.literal(real.roundoff()),
            "HALF_ROUNDOFF" => real.literal(0.5 * real.roundoff()),
            "THIRD" => match real {
                Real::Double | Real::Fused => format!("0x{:016x}u", (1.0_f64 / 3.0).to_bits()),
                Real::Single => format!("0x{:08x}u", (1.0_f32 / 3.0).to_bits()),
            },
            _ => return None,
        })
    };
    let filled = |template: &str| fill(template, *real, private, word);
    let sine = match helpers.has("sin_cos") {
        true => filled(include_str!("templates/arithmetic_sine.c")),
        false => String::new(),
    };
    filled(include_str!("templates/arithmetic.c")).replace("/* SINE */\n", &sine) + "\n"
}

/// The function that tests a number.
pub(crate) fn ok(writer: &mut Writer) {
    let Surface {
        declarations: Declarations { private, .. },
        ok,
        ..
    } = writer.surface;
    writer.printer.helpers.need("infinite");
    writer.text += &comment("", "Whether a number exists and is finite.");
    let _ = writeln!(
        writer.text,
        "{}\n{{\n    return !{private}infinite(number);\n}}\n",
        ok.signature
    );
}
