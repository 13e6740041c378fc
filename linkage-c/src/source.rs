//! The source behind the header.

use std::fmt::Write;

use crate::arithmetic::{arithmetic, ok};
use crate::assemble;
use crate::comment::comment;
use crate::coupled;
use crate::evaluator::evaluator;
use crate::operations::{Printer, helper_text, helpers};
use crate::preprocessor;
use crate::range_check;
use crate::surface::{LOCAL, Surface};
use crate::winding;
use crate::writer::Writer;

/// The text of the source.
pub(crate) fn source(surface: &Surface) -> String {
    let mut writer = writer(surface);
    plumbing(&mut writer);
    assemble::assemble(&mut writer);
    assemble::assembly_size(&mut writer);
    assemble::error(&mut writer);
    ok(&mut writer);
    range_check::items(&mut writer);
    let functions = surface.declarations.functions.iter();
    for (function, signatures) in functions.zip(&surface.functions) {
        evaluator(&mut writer, function, signatures);
    }
    let Writer { printer, text, .. } = writer;
    let private = &surface.declarations.private;
    let helpers = helper_text(&printer.helpers, surface.real, private);
    let arithmetic = arithmetic(surface, &printer.helpers);
    let text = head(surface) + &helpers + "\n" + &arithmetic + &text;
    text.replace(
        "\nstatic ",
        &format!("\nstatic {} ", surface.constant(LOCAL)),
    )
}

/// A writer without a text.
pub(crate) fn writer<'a>(surface: &'a Surface<'a>) -> Writer<'a> {
    Writer {
        surface,
        printer: Printer {
            real: surface.real,
            private: &surface.declarations.private,
            helpers: helpers(surface.real),
        },
        text: String::new(),
    }
}

/// The programs behind assembling.
fn plumbing(writer: &mut Writer) {
    let turns = winding::turns_type(writer.surface);
    writer.text += &turns;
    assemble::prepare(writer);
    coupled::items(writer);
    assemble::close(writer);
    winding::items(writer);
    coupled::served(writer);
}

fn head(surface: &Surface) -> String {
    let mut text = comment(
        "",
        &format!(
            "{}: see {}.h. Written by linkage; not to be changed by hand.",
            surface.title, surface.declarations.name
        ),
    );
    let _ = write!(
        text,
        "#include \"{}.h\"\n\n#include <float.h>\n#include <math.h>\n#include <stdint.h>\n\n{}{}",
        surface.declarations.name,
        preprocessor::of_source(surface.real),
        preprocessor::of_rows(surface)
    );
    text
}
