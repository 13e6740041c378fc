//! The source as it grows: its text, and functions that print programs into it.

use std::fmt::Write;

use linkage_symbolic::program::{Program, Source};

use crate::comment::comment;
use crate::operations::{Printed, Printer};
use crate::states::{limit, look_up};
use crate::surface::Surface;

/// Writes the source of a mechanism.
pub(crate) struct Writer<'a> {
    pub(crate) surface: &'a Surface<'a>,
    pub(crate) printer: Printer<'a>,
    pub(crate) text: String,
}

impl Writer<'_> {
    /// A program as a function of all inputs, `x`, that writes its results to `out`.
    pub(crate) fn plain(&mut self, name: &str, program: &Program, note: &str) {
        let (_, prefix, private) = self.surface.unit_and_prefixes();
        let real = self.surface.real.name();
        let printed = self.printed(program);
        let body = look_up(self.surface, program, None, "x") + &written(&printed);
        self.text += &comment("", note);
        let body = used(&["m", "x"], body);
        let takes = format!("const {prefix} *m, const {real} *x, {real} *out");
        let _ = writeln!(
            self.text,
            "static void {private}{name}({takes})\n{{\n{body}}}\n"
        );
    }

    /// Prints a program whose inputs are the array `x`.
    pub(crate) fn printed(&mut self, program: &Program) -> Printed {
        let surface = self.surface;
        self.printer.program(program, &|source| match source {
            Source::Input(index) => format!("x[{index}]"),
            other => source_expression(surface, other),
        })
    }
}

/// Results written to an array.
pub(crate) fn written(printed: &Printed) -> String {
    let mut body = printed.statements.clone();
    for (index, value) in printed.results.iter().enumerate() {
        let _ = writeln!(body, "    out[{index}] = {value};");
    }
    body
}

/// A body with a line for each parameter that it does not read: compilers warn of these. A member
/// of a struct may have the name of a parameter.
pub(crate) fn used(parameters: &[&str], body: String) -> String {
    let of_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let words = body.split(|c| !of_name(c) && c != '.');
    let words: Vec<&str> = words.filter_map(|word| word.split('.').next()).collect();
    let unused = parameters
        .iter()
        .filter(|parameter| !words.contains(parameter));
    let unused: String = unused
        .map(|entry| format!("    (void){entry};\n"))
        .collect();
    body + &unused
}

/// Returns the expression of a number that is no input.
pub(crate) fn source_expression(surface: &Surface, source: Source) -> String {
    match source {
        Source::Parameter(index) => {
            format!("m->dimensions.{}", surface.declarations.scalars[index])
        }
        Source::Mode(index) => {
            let plus = surface.declarations.unit.modes()[index];
            surface.real.literal(if plus { 1.0 } else { -1.0 })
        }
        Source::Centre(angle) => format!("turns->centre[{angle}]"),
        Source::Winding(angle, input) => format!("turns->winding[{angle}][{input}]"),
        Source::Prepared(slot) => format!("m->prepared[{slot}]"),
        Source::State(group, component) => format!("state_{group}[{component}]"),
        Source::Limit => limit(surface.real),
        Source::Input(_) | Source::Carried(_) => {
            unreachable!("inputs stand elsewhere, and whole programs carry nothing")
        }
    }
}
