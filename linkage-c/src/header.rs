//! The header, which users read.

use std::fmt::Write;

use linkage_export::{Declarations, FunctionDeclaration, MemberDeclaration, Renamed};

use crate::comment::comment;
use crate::preprocessor;
use crate::range_check;
use crate::surface::{API, Code, Evaluator, LOCAL, Surface};

/// The text of the header.
pub(crate) fn header(surface: &Surface) -> String {
    let Surface { title, real, .. } = surface;
    let guard = surface.constant("h");
    let length = surface.declarations.length;
    let length = length.map_or_else(String::new, |unit| format!(", lengths {unit}"));
    let first = format!(
        "{title}: its loops are closed by formulas. Written by linkage; not to be changed by hand."
    );
    let last = format!(
        "All numbers are {}s; angles are radians{length}. A result that does not exist, because links do not reach each other, is NaN.\n\
         Not for -ffast-math, which takes it that there is no NaN. Numbers are rounded to nearest: assembling and functions need that mode.",
        real.name()
    );
    let about = [&first[..], surface.declarations.documentation, &last];
    let about = about.iter().filter(|entry| !entry.is_empty()).copied();
    let mut text = comment("", &about.collect::<Vec<_>>().join("\n"));
    let _ = write!(
        text,
        "#ifndef {guard}\n#define {guard}\n\n#include <float.h>\n#include <stddef.h>\n\n"
    );
    text += &listed(&surface.declarations.renamed);
    text += &preprocessor::of_header(surface);
    text += &macros(surface);
    text += "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n";
    for entry in surface.vector_types() {
        text += &entry;
        text.push('\n');
    }
    text += &dimensions(surface);
    text += &assembled(surface);
    text += &codes(surface);
    text += &comment(
        "",
        "Closes the loops at the reference inputs in the assembly that the start estimates of the declaration choose, and computes what \
         depends on the dimensions alone. 0, or why not: then `m` is of no use.",
    );
    let _ = writeln!(text, "{};\n", surface.assemble.signature);
    text += &comment(
        "",
        &format!(
            "The size of `{}` in bytes, for programs in other languages, which need not know its members.",
            surface.declarations.name
        ),
    );
    let _ = writeln!(text, "{};\n", surface.assembly_size.signature);
    text += &comment("", "What a number from assembling means, in words.");
    let _ = writeln!(text, "{};\n", surface.error.signature);
    text += &comment(
        "",
        "1 for a number that exists and is finite, else 0. It looks at the bits: compilers keep this test where NaN is taken for impossible.",
    );
    let _ = writeln!(text, "{};\n", surface.ok.signature);
    text += &range_check::declared(surface);
    let functions = surface.declarations.functions.iter();
    for (function, signatures) in functions.zip(&surface.functions) {
        text += &evaluator(function, signatures);
    }
    let _ = write!(text, "#ifdef __cplusplus\n}}\n#endif\n\n#endif\n");
    text
}

/// Returns the macros that users may define before they include the header.
fn macros(surface: &Surface) -> String {
    let all = [
        (
            API,
            "Before each function of this header: nothing, static inline, __device__, a visibility.",
        ),
        (
            LOCAL,
            "Before each function and table of the source alone, after static: nothing, __device__.",
        ),
    ];
    let all = all.map(|(end, about)| {
        let name = surface.constant(end);
        comment("", about) + &format!("#ifndef {name}\n#define {name}\n#endif\n")
    });
    all.concat() + "\n"
}

fn dimensions(surface: &Surface) -> String {
    let name = &surface.dimensions_type;
    let defaults = surface.constant("defaults");
    let mut text = comment(
        "",
        &format!("The dimensions; `{name} d = {defaults};` are those of the declaration."),
    );
    let _ = writeln!(text, "typedef struct {name} {{");
    for dimension in &surface.declarations.dimensions {
        text += &member(&dimension.member);
    }
    // A struct of nothing is not C.
    if surface.declarations.dimensions.is_empty() {
        text += "    char nothing;\n";
    }
    let _ = writeln!(text, "}} {name};\n");
    let values = surface.declarations.dimensions.iter().map(|dimension| {
        let numbers = dimension.scalars.iter();
        let numbers = numbers.map(|scalar| surface.real.literal(scalar.nominal));
        let numbers: Vec<String> = numbers.collect();
        match &numbers[..] {
            [one] => one.clone(),
            several => format!("{{ {} }}", several.join(", ")),
        }
    });
    let values: Vec<String> = values.collect();
    let values = if values.is_empty() {
        "0".to_owned()
    } else {
        values.join(", \\\n    ")
    };
    let _ = writeln!(text, "#define {defaults} {{ \\\n    {values} }}\n");
    text
}

fn assembled(surface: &Surface) -> String {
    let Surface {
        declarations: Declarations {
            name: prefix, unit, ..
        },
        real,
        dimensions_type,
        ..
    } = surface;
    let number = real.name();
    let mut text = comment(
        "",
        "The assembled mechanism. Functions only read it, so that several tasks may share one.",
    );
    let _ = writeln!(text, "typedef struct {prefix} {{");
    let _ = writeln!(text, "    {dimensions_type} dimensions;");
    let _ = writeln!(
        text,
        "    {number} miss; /* by how much a loop misses closing, if one does */"
    );
    if !unit.coupled.is_empty() {
        text += "    int moved; /* whether dimensions are not those for which tables are made */\n";
    }
    if unit.slots() > 0 {
        let _ = writeln!(
            text,
            "    {number} prepared[{}]; /* what depends on the dimensions alone */",
            unit.slots()
        );
    }
    let _ = writeln!(text, "}} {prefix};\n");
    text
}

fn codes(surface: &Surface) -> String {
    let mut text = comment("", "What assembling may return.");
    text += "enum {\n";
    let _ = write!(text, "    {} = 0", surface.constant("ok"));
    // Those that all mechanisms have stand first, whatever their numbers.
    let mut codes: Vec<(usize, &Code)> = (1..).zip(&surface.codes).collect();
    codes.sort_by_key(|(_, code)| !code.why.is_of_arithmetic());
    for (number, code) in codes {
        let _ = write!(text, ",\n    {} = {number}", code.name);
    }
    text + "\n};\n\n"
}

fn evaluator(function: &FunctionDeclaration, evaluator: &Evaluator) -> String {
    let Evaluator {
        declared,
        result,
        sweep,
    } = evaluator;
    let mut text = format!("typedef struct {result} {{\n");
    for field in &function.fields {
        text += &member(field);
    }
    if function.fields.is_empty() {
        text += "    char nothing;\n";
    }
    let _ = writeln!(text, "}} {result};\n");
    let arguments = function.arguments.iter();
    let notes = arguments.map(|argument| format!("{}: {}.", argument.name, argument.note));
    let about = [
        function.function.documentation.clone(),
        function.cost.clone(),
    ];
    let about: Vec<String> = about.into_iter().chain(notes).collect();
    text += &comment("", &about.join("\n"));
    let _ = writeln!(text, "{};\n", declared.signature);
    if let Some(sweep) = sweep {
        text += &comment("", "The same at `count` positions.");
        let _ = writeln!(text, "{};\n", sweep.signature);
    }
    text
}

/// Returns a member of a struct, after the user's documentation of it.
fn member(member: &MemberDeclaration) -> String {
    let about = match member.documentation.trim().is_empty() {
        true => String::new(),
        false => comment("    ", member.documentation),
    };
    about + &format!("    {}; {}", member.declaration, comment("", &member.note))
}

/// Returns a comment with the names that have another form; nothing if there is none.
fn listed(all: &[Renamed]) -> String {
    if all.is_empty() {
        return String::new();
    }
    let lines = all.iter().map(|item| item.to_string().replace('`', ""));
    let lines: Vec<String> = lines.collect();
    comment(
        "",
        &format!(
            "Names of the declaration that C, C++, their libraries or this file have themselves, or whose letters C does not know:\n{}.",
            lines.join(",\n")
        ),
    ) + "\n"
}
