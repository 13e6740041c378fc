//! The header, which users read.

use std::fmt::Write;

use linkage_symbolic::count::Count;

use crate::comment::comment;
use crate::preprocessor;
use crate::range_check;
use crate::surface::{Code, Evaluator, Surface, listed};

/// The text of the header.
pub(crate) fn header(surface: &Surface) -> String {
    let Surface { title, real, .. } = surface;
    let guard = surface.constant("h");
    let length = length_unit(surface);
    let first = format!(
        "{title}: its loops are closed by formulas. Written by linkage; not to be changed by hand."
    );
    let last = format!(
        "All numbers are {}s; angles are radians{length}. A result that does not exist, because links do not reach each other, is NaN.\n\
         Not for -ffast-math, which takes it that there is no NaN. Numbers are rounded to nearest: assembling and functions need that mode.",
        real.name()
    );
    let about = [&first[..], surface.unit.documentation.trim(), &last];
    let about = about.iter().filter(|entry| !entry.is_empty()).copied();
    let mut text = comment("", &about.collect::<Vec<_>>().join("\n"));
    let _ = write!(
        text,
        "#ifndef {guard}\n#define {guard}\n\n#include <float.h>\n#include <stddef.h>\n\n"
    );
    text += &listed(&surface.renamed);
    text += &preprocessor::of_header(surface);
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
    text += &comment("", "What a number from assembling means, in words.");
    let _ = writeln!(text, "{};\n", surface.error.signature);
    text += &comment(
        "",
        "1 for a number that exists and is finite, else 0. It looks at the bits: compilers keep this test where NaN is taken for impossible.",
    );
    let _ = writeln!(text, "{};\n", surface.ok.signature);
    text += &range_check::declared(surface);
    for function in &surface.functions {
        text += &evaluator(surface, function);
    }
    let _ = write!(text, "#ifdef __cplusplus\n}}\n#endif\n\n#endif\n");
    text
}

/// `, lengths mm`, if there is one unit of length.
fn length_unit(surface: &Surface) -> String {
    let unknowns = surface.unit.unknowns.iter();
    let mut lengths = unknowns.filter(|unknown| !unknown.is_number && !unknown.unit.is_empty());
    lengths
        .next()
        .map_or_else(String::new, |entry| format!(", lengths {}", entry.unit))
}

fn dimensions(surface: &Surface) -> String {
    let name = &surface.dimensions_type;
    let defaults = surface.constant("defaults");
    let mut text = comment(
        "",
        &format!("The dimensions; `{name} d = {defaults};` are those of the declaration."),
    );
    let _ = writeln!(text, "typedef struct {name} {{");
    for dimension in &surface.dimensions {
        let declared = surface.declared(&dimension.name, &dimension.shape);
        text += &member(dimension.documentation, &declared, &dimension.note);
    }
    // A struct of nothing is not C.
    if surface.dimensions.is_empty() {
        text += "    char nothing;\n";
    }
    let _ = writeln!(text, "}} {name};\n");
    let values = surface.dimensions.iter().map(|dimension| {
        let numbers: Vec<String> = dimension
            .values
            .iter()
            .map(|x| surface.real.literal(*x))
            .collect();
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
        prefix,
        real,
        dimensions_type,
        unit,
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

fn evaluator(surface: &Surface, evaluator: &Evaluator) -> String {
    let Evaluator {
        declared, result, ..
    } = evaluator;
    let mut text = format!("typedef struct {result} {{\n");
    for field in &evaluator.fields {
        let declared = surface.declared(&field.name, &field.shape);
        text += &member(field.documentation, &declared, &field.note);
    }
    if evaluator.fields.is_empty() {
        text += "    char nothing;\n";
    }
    let _ = writeln!(text, "}} {result};\n");
    let notes = evaluator.arguments.iter().zip(&evaluator.argument_notes);
    let notes: Vec<String> = notes
        .map(|(name, note)| format!("{name}: {note}."))
        .collect();
    let about = [
        evaluator.function.documentation.clone(),
        cost(&evaluator.function.called.count),
    ];
    text += &comment("", &[&about, &notes[..]].concat().join("\n"));
    let _ = writeln!(text, "{};\n", declared.signature);
    if let Some(sweep) = &evaluator.sweep {
        text += &comment("", "The same at `count` positions.");
        let _ = writeln!(text, "{};\n", sweep.signature);
    }
    text
}

/// Returns a member of a struct, after the user's documentation of it.
fn member(documentation: &str, declared: &str, note: &str) -> String {
    let about = match documentation.trim().is_empty() {
        true => String::new(),
        false => comment("    ", documentation),
    };
    about + &format!("    {declared}; {}", comment("", note))
}

/// `12 additions, 20 multiplications, 1 root.`
fn cost(count: &Count) -> String {
    let kinds = [
        (count.add, "addition"),
        (count.mul, "multiplication"),
        (count.div, "division"),
        (count.sqrt, "root"),
        (count.sin_cos, "sine and cosine"),
        (count.atan2, "arc tangent"),
        (count.other, "other operation"),
    ];
    let words = kinds.iter().filter(|(count, _)| *count > 0);
    let words = words.map(|(count, word)| match (count, *word) {
        (1, word) => format!("1 {word}"),
        (count, "sine and cosine") => format!("{count} sines and cosines"),
        (count, word) => format!("{count} {word}s"),
    });
    let words: Vec<String> = words.collect();
    match words.is_empty() {
        true => "No operation at all.".to_owned(),
        false => words.join(", ") + ".",
    }
}
