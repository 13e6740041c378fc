//! The source behind the header.

use std::fmt::Write;

use linkage_symbolic::program::{Program, Source};

use crate::arithmetic::{arithmetic, ok};
use crate::assemble::{assemble, close, error};
use crate::checks;
use crate::comment::comment;
use crate::coupled;
use crate::instruction::{Printed, Printer};
use crate::range;
use crate::surface::{Evaluator, Surface, places};
use crate::winding;

/// The text of the source.
pub(crate) fn source(surface: &Surface) -> String {
    let mut writer = Writer {
        surface,
        printer: Printer {
            real: surface.real,
            own: &surface.own,
            helpers: Default::default(),
        },
        text: String::new(),
    };
    writer.plumbing();
    assemble(&mut writer);
    error(&mut writer);
    ok(&mut writer);
    range::items(&mut writer);
    for own in &surface.functions {
        writer.evaluator(own);
    }
    let Writer { printer, text, .. } = writer;
    let helpers = printer.helpers.text(surface.real, &surface.own);
    let arithmetic = arithmetic(surface, &printer.helpers);
    head(surface) + &helpers + "\n" + &arithmetic + &text
}

fn head(surface: &Surface) -> String {
    let mut text = comment(
        "",
        &format!(
            "{}: see {}.h. Written by linkage; not to be changed by hand.",
            surface.title, surface.prefix
        ),
    );
    let _ = write!(
        text,
        "#include \"{}.h\"\n\n#include <float.h>\n#include <math.h>\n#include <stdint.h>\n\n{}",
        surface.prefix,
        checks::of_source(surface.real)
    );
    text
}

/// Writes the source of a mechanism.
pub(crate) struct Writer<'a> {
    pub(crate) surface: &'a Surface<'a>,
    pub(crate) printer: Printer<'a>,
    pub(crate) text: String,
}

impl Writer<'_> {
    /// The programs behind assembling.
    fn plumbing(&mut self) {
        let turns = winding::turns_type(self.surface);
        self.text += &turns;
        self.prepare();
        coupled::items(self);
        close(self);
        winding::items(self);
        coupled::served(self);
    }

    /// What depends on the dimensions alone.
    fn prepare(&mut self) {
        let Surface {
            unit, prefix, own, ..
        } = self.surface;
        let printed = self.printed(&unit.prepare);
        let mut body = printed.statements;
        for (slot, value) in printed.results.iter().enumerate() {
            let _ = writeln!(body, "    m->prepared[{slot}] = {value};");
        }
        let takes = match unit.angles.is_empty() {
            true => format!("{prefix} *m"),
            false => format!("{prefix} *m, const {own}turns *turns"),
        };
        self.text += &comment("", "What depends on the dimensions alone.");
        let body = used(&["m", "turns"][..takes.matches('*').count()], body);
        let _ = writeln!(
            self.text,
            "static void {own}prepare({takes})\n{{\n{body}}}\n"
        );
    }

    /// A program as a function of all inputs, `x`, that writes its results to `out`.
    pub(crate) fn plain(&mut self, name: &str, program: &Program, note: &str) {
        let Surface {
            prefix, own, real, ..
        } = self.surface;
        let real = real.name();
        let printed = self.printed(program);
        let body = coupled::look_up(self.surface, program, None, "x") + &written(&printed);
        self.text += &comment("", note);
        let body = used(&["m", "x"], body);
        let takes = format!("const {prefix} *m, const {real} *x, {real} *out");
        let _ = writeln!(
            self.text,
            "static void {own}{name}({takes})\n{{\n{body}}}\n"
        );
    }

    /// A Newton step of a coupled group from a state.
    pub(crate) fn correct(&mut self, number: usize, program: &Program) {
        let Surface {
            prefix, own, real, ..
        } = self.surface;
        let real = real.name();
        let printed = self.printed(program);
        let body = coupled::look_up(self.surface, program, Some(number), "x") + &written(&printed);
        let state = format!("state_{number}");
        let body = used(&["m", "x", &state], body);
        let takes =
            format!("const {prefix} *m, const {real} *x, const {real} *{state}, {real} *out");
        let _ = writeln!(
            self.text,
            "/* The state after a Newton step, the square of its change, the determinant before. */\n\
             static void {own}correct_{number}({takes})\n{{\n{body}}}\n"
        );
    }

    /// A program on what plumbing has.
    pub(crate) fn printed(&mut self, program: &Program) -> Printed {
        let surface = self.surface;
        self.printer.program(program, &|source| match source {
            Source::Input(index) => format!("x[{index}]"),
            other => place(surface, other),
        })
    }

    fn evaluator(&mut self, own: &Evaluator) {
        let surface = self.surface;
        let Surface { prefix, real, .. } = surface;
        let Evaluator {
            name,
            result,
            function,
            arguments,
            ..
        } = own;
        let program = &function.called.program;
        let printed = self.printer.program(program, &|source| match source {
            Source::Input(index) => {
                let place = function.arguments.iter().position(|own| *own == index);
                arguments[place.expect("a program uses only its inputs")].clone()
            }
            other => place(surface, other),
        });
        let mut body = states(surface, own) + &printed.statements;
        let fields = own.fields.iter();
        let targets = fields.flat_map(|field| places(&field.name, &field.shape));
        for (target, value) in targets.zip(&printed.results) {
            let _ = writeln!(body, "    result.{target} = {value};");
        }
        if own.fields.is_empty() {
            body += "    result.nothing = 0;\n";
        }
        let mut names = vec!["m"];
        names.extend(arguments.iter().map(String::as_str));
        let body = format!("    {result} result;\n") + &used(&names, body) + "    return result;\n";
        let number = real.name();
        let takes: String = arguments
            .iter()
            .map(|own| format!(", {number} {own}"))
            .collect();
        let _ = writeln!(
            self.text,
            "{result} {name}(const {prefix} *m{takes})\n{{\n{body}}}\n"
        );
        if let Some(sweep) = &own.sweep {
            let arrays: String = arguments
                .iter()
                .map(|own| format!(", const {number} *{own}"))
                .collect();
            let at: String = arguments.iter().map(|own| format!(", {own}[k]")).collect();
            let takes = format!("const {prefix} *m, size_t count{arrays}, {result} *results");
            let _ = writeln!(
                self.text,
                "void {sweep}({takes})\n{{\n    size_t k;\n    for (k = 0; k < count; k++) results[k] = {name}(m{at});\n}}\n"
            );
        }
    }
}

/// Statements that find the states of the coupled groups that a function needs.
fn states(surface: &Surface, own: &Evaluator) -> String {
    let function = own.function;
    let found = coupled::look_up(surface, &function.called.program, None, "inputs");
    if found.is_empty() {
        return found;
    }
    let inputs = surface.unit.inputs.iter().enumerate().map(|(input, of)| {
        let place = function.arguments.iter().position(|own| *own == input);
        // What a function does not take, its groups do not depend on.
        place.map_or_else(
            || surface.real.literal(of.reference),
            |place| own.arguments[place].clone(),
        )
    });
    let inputs: Vec<String> = inputs.collect();
    let (number, inputs) = (surface.real.name(), inputs.join(", "));
    format!("    const {number} inputs[] = {{ {inputs} }};\n{found}")
}

/// Results written to an array.
pub(crate) fn written(printed: &Printed) -> String {
    let mut body = printed.statements.clone();
    for (index, value) in printed.results.iter().enumerate() {
        let _ = writeln!(body, "    out[{index}] = {value};");
    }
    body
}

/// A body with a line for each parameter that it does not read: compilers warn of these. A member of a struct may have the name of a parameter.
pub(crate) fn used(parameters: &[&str], body: String) -> String {
    let of_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let words = body.split(|c| !of_name(c) && c != '.');
    let words: Vec<&str> = words.filter_map(|word| word.split('.').next()).collect();
    let unused = parameters.iter().filter(|own| !words.contains(own));
    let unused: String = unused.map(|own| format!("    (void){own};\n")).collect();
    body + &unused
}

/// Where a number stands that is no input.
pub(crate) fn place(surface: &Surface, source: Source) -> String {
    match source {
        Source::Parameter(index) => format!("m->dimensions.{}", surface.scalars[index]),
        Source::Mode(index) => {
            let plus = surface.unit.modes()[index];
            surface.real.literal(if plus { 1.0 } else { -1.0 })
        }
        Source::Centre(angle) => format!("turns->centre[{angle}]"),
        Source::Winding(angle, input) => format!("turns->winding[{angle}][{input}]"),
        Source::Prepared(slot) => format!("m->prepared[{slot}]"),
        Source::State(group, component) => format!("state_{group}[{component}]"),
        Source::Limit => coupled::limit(surface.real),
        Source::Input(_) | Source::Carried(_) => {
            unreachable!("inputs stand elsewhere, and whole programs carry nothing")
        }
    }
}
