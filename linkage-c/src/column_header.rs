//! The header of sweeps into columns.

use std::fmt::Write;

use linkage_export::FunctionDeclaration;

use crate::column_rows::signature;
use crate::comment::comment;
use crate::surface::{Evaluator, Surface};

/// Returns the text of the header: each function of the mechanism with the name of its sweep.
pub(crate) fn column_header(surface: &Surface, sweeps: &[Option<String>]) -> String {
    let name = &surface.declarations.name;
    let guard = surface.constant("columns_h");
    let mut text = comment(
        "",
        &format!(
            "Sweeps of {} into columns: each number of a result has an array of its own. Written by linkage; not to be changed by hand.\n\
             Compile {name}_columns.c in the stead of {name}.c, which it includes, as C99.",
            surface.title
        ),
    );
    let _ = write!(
        text,
        "#ifndef {guard}\n#define {guard}\n\n#include \"{name}.h\"\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n"
    );
    text += &comment(
        "",
        "All sweeps: `x` has an array for each argument of the function, with `count` numbers where its step is 1, with one number where its \
         step is 0. `columns` has an array of `count` numbers for each number of the result. Arrays that are written overlap no others.",
    );
    text.push('\n');
    let functions = surface.declarations.functions.iter();
    for ((function, evaluator), sweep) in functions.zip(&surface.functions).zip(sweeps) {
        if let Some(sweep) = sweep {
            text += &declared(surface, function, evaluator, sweep);
        }
    }
    text + "#ifdef __cplusplus\n}\n#endif\n\n#endif\n"
}

fn declared(
    surface: &Surface,
    function: &FunctionDeclaration,
    evaluator: &Evaluator,
    sweep: &str,
) -> String {
    let arguments = function.arguments.iter().map(|argument| &argument.name[..]);
    let arguments: Vec<&str> = arguments.collect();
    let columns = function
        .function
        .columns
        .iter()
        .map(|column| match &column.unit[..] {
            "" => column.name.clone(),
            unit => format!("{} ({unit})", column.name),
        });
    let columns: Vec<String> = columns.collect();
    let about = format!(
        "`{}` at `count` positions. x: {}. columns: {}.",
        function.function.name,
        arguments.join(", "),
        columns.join(", ")
    );
    let shared = format!("const {} *m", surface.declarations.name);
    // The name of the function in C, which may be another one than in the declaration.
    let arrays = format!("{}_columns", evaluator.declared.name).to_uppercase();
    comment("", &about)
        + &format!("enum {{ {arrays} = {} }};\n", columns.len())
        + &signature(surface, sweep, &shared)
        + ";\n\n"
}
