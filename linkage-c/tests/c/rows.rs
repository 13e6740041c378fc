//! Sweeps, in which compilers compute several rows at once: packed instructions, and the bits of single calls.

use std::fmt::Write;
use std::fs;
use std::process::Command;

use linkage_c::{ColumnSweeps, Real, Sources, column_sweeps, sources};
use linkage_corpus::given::{Given, golden};

use crate::machine::{self, Compiler, WARNINGS};
use crate::page::press;

/// The instructions of a function in a listing.
fn instructions<'a>(listing: &'a str, function: &str) -> &'a str {
    let start = listing.find(&format!("\n{function}:"));
    let rest = &listing[start.expect("the function is in the listing")..];
    let end = rest.find(&format!("\t.size\t{function}"));
    &rest[..end.expect("the function ends")]
}

/// No flag is necessary for packed roots: the source itself says that a root sets no error number.
#[cfg(all(target_arch = "x86_64", target_os = "linux"))]
#[test]
fn rows_are_packed_without_a_flag() {
    let folder = machine::folder("rows_packed");
    // On x86-64 clang returns two floats as one vector, and then computes no rows together.
    let singles = (Real::Single, "vsqrtps", &["gcc"][..]);
    for (real, root, commands) in [(Real::Double, "vsqrtpd", &["gcc", "clang"][..]), singles] {
        let given = press();
        machine::write(
            &folder,
            &sources(&given.name, &given.unit, real).expect("it can be exported"),
        );
        for command in commands {
            let Some(compiler) = Compiler::named(command) else {
                continue;
            };
            // For a library, too.
            let flags = ["-std=c99", "-O3", "-march=x86-64-v3", "-fPIC", "-S"];
            compiler.run(
                &folder,
                &[&flags[..], &["press.c", "-o", "press.s"], &WARNINGS].concat(),
            );
            let listing = fs::read_to_string(folder.join("press.s")).expect("a listing");
            let sweep = instructions(&listing, "press_motion_sweep");
            let packed = sweep
                .lines()
                .any(|line| line.contains(root) && line.contains("%ymm"));
            assert!(packed, "{command}: no packed root:\n{sweep}");
            assert!(!sweep.contains("\tcall"), "{command}: a call:\n{sweep}");
            compiler.run(&folder, &["-Os", "-S", "press.c", "-o", "small.s"]);
            let listing = fs::read_to_string(folder.join("small.s")).expect("a listing");
            let sweep = instructions(&listing, "press_motion_sweep");
            assert!(
                sweep.contains("press_own_row_press_motion"),
                "{command}: two copies:\n{sweep}"
            );
        }
    }
}

/// The functions with sweeps in a header, and the number of their arguments.
fn swept(sources: &Sources) -> Vec<(String, usize)> {
    let lines = sources.header.lines();
    let sweeps = lines.filter_map(|line| {
        let (before, parameters) = line.split_once("_sweep(const ")?;
        let (_, name) = before.rsplit_once(' ')?;
        Some((
            name.to_owned(),
            parameters.matches(", const double *").count(),
        ))
    });
    sweeps.collect()
}

/// A program that returns the number of positions at which a sweep has other bits than single calls.
fn comparison(sources: &Sources) -> String {
    let prefix = &sources.name;
    let upper = prefix.to_uppercase();
    let mut text = format!(
        "#include \"{prefix}.h\"\n#include <string.h>\nint main(void)\n{{\n    const {prefix}_dimensions d = {upper}_DEFAULTS;\n    \
         static {prefix} m;\n    static double x[1003];\n    int k, other = 0;\n    if ({prefix}_assemble(&m, &d) != 0) return 100;\n    \
         for (k = 0; k < 1003; k++) x[k] = -7.0 + 0.014 * k;\n"
    );
    for (name, inputs) in swept(sources) {
        let (arrays, single) = (", x".repeat(inputs), ", x[k]".repeat(inputs));
        let _ = write!(
            text,
            "    {{\n        static {name}_result rows[1003];\n        {name}_sweep(&m, 1003{arrays}, rows);\n        \
             for (k = 0; k < 1003; k++) {{\n            const {name}_result one = {name}(&m{single});\n            \
             double a[sizeof one / sizeof(double)], b[sizeof one / sizeof(double)];\n            size_t i;\n            \
             memcpy(a, &one, sizeof a);\n            memcpy(b, &rows[k], sizeof b);\n            \
             for (i = 0; i < sizeof a / sizeof *a; i++)\n                \
             other += a[i] != a[i] ? b[i] == b[i] : memcmp(&a[i], &b[i], sizeof *a) != 0;\n        }}\n    }}\n"
        );
    }
    text + "    return other > 99 ? 99 : other;\n}\n"
}

#[test]
fn rows_have_the_bits_of_single_calls() {
    let folder = machine::folder("rows_bits");
    let mut count = 0;
    for (index, given) in golden().into_iter().enumerate() {
        let sources = sources(&given.name, &given.unit, Real::Double).expect("it can be exported");
        count += swept(&sources).len();
        machine::write(&folder, &sources);
        fs::write(folder.join("main.c"), comparison(&sources)).expect("a file");
        let source = format!("{}.c", sources.name);
        // One compiler reads all of them.
        let commands = ["gcc", "clang"];
        for command in &commands[..if index % 3 == 0 { 2 } else { 1 }] {
            let Some(compiler) = Compiler::named(command) else {
                continue;
            };
            let flags = ["-std=c99", "-O3", "-march=native", "-ffp-contract=off"];
            let files = ["main.c", &source[..], "-o", "main", "-lm"];
            compiler.run(&folder, &[&flags[..], &files].concat());
            let run = Command::new(folder.join("main")).status();
            let other = run.expect("the program runs").code();
            assert_eq!(other, Some(0), "{command}: {}", sources.name);
        }
    }
    assert!(count > 20, "{count} functions");
}

/// A program that returns the number of positions at which columns have other bits than single calls: where all arguments move, and where
/// the last one stands still.
fn comparison_of_columns(sweeps: &ColumnSweeps) -> String {
    let prefix = &sweeps.sources.name;
    let upper = prefix.to_uppercase();
    let mut text = format!(
        "#include \"{prefix}_columns.h\"\n#include <string.h>\nint main(void)\n{{\n    const {prefix}_dimensions d = {upper}_DEFAULTS;\n    \
         static {prefix} m;\n    static double x[1003];\n    int k, moves, other = 0;\n    \
         if ({prefix}_assemble(&m, &d) != 0) return 100;\n    for (k = 0; k < 1003; k++) x[k] = -7.0 + 0.014 * k;\n    \
         for (moves = 0; moves < 2; moves++) {{\n"
    );
    for (name, inputs) in swept(&sweeps.sources) {
        let columns = format!("{}_COLUMNS", name.to_uppercase());
        let first = inputs - 1;
        let (arrays, steps, single) = (
            "x, ".repeat(first),
            "1, ".repeat(first),
            ", x[k]".repeat(first),
        );
        let _ = write!(
            text,
            "    {{\n        static double numbers[{columns}][1003];\n        double *columns[{columns}];\n        \
             const double *arrays[] = {{ {arrays}x }};\n        size_t steps[] = {{ {steps}0 }}, i;\n        \
             steps[{first}] = (size_t)moves;\n        \
             for (i = 0; i < {columns}; i++) columns[i] = numbers[i];\n        \
             {name}_sweep_columns(&m, 1003, arrays, steps, columns);\n        \
             for (k = 0; k < 1003; k++) {{\n            const {name}_result one = {name}(&m{single}, x[moves ? k : 0]);\n            \
             double a[sizeof one / sizeof(double)];\n            memcpy(a, &one, sizeof a);\n            \
             if (sizeof a / sizeof *a != {columns}) return 101;\n            for (i = 0; i < {columns}; i++)\n                \
             other += a[i] != a[i] ? numbers[i][k] == numbers[i][k] : memcmp(&a[i], &numbers[i][k], sizeof *a) != 0;\n        }}\n    }}\n"
        );
    }
    text + "    }\n    return other > 99 ? 99 : other;\n}\n"
}

#[test]
fn columns_have_the_bits_of_single_calls() {
    let folder = machine::folder("columns_bits");
    let compiler = Compiler::named("gcc").expect("a compiler");
    let mut count = 0;
    // Compilers take their time for these files.
    for given in golden().into_iter().step_by(3) {
        let sweeps =
            column_sweeps(&given.name, &given.unit, Real::Double).expect("it can be exported");
        let name = &sweeps.sources.name;
        count += swept(&sweeps.sources).len();
        machine::write_columns(&folder, &sweeps);
        fs::write(folder.join("main.c"), comparison_of_columns(&sweeps)).expect("a file");
        let flags = ["-std=c99", "-O3", "-march=native", "-ffp-contract=off"];
        let source = format!("{name}_columns.c");
        let files = ["main.c", &source[..], "-o", "main", "-lm"];
        compiler.run(&folder, &[&flags[..], &WARNINGS, &files].concat());
        let run = Command::new(folder.join("main")).status();
        let other = run.expect("the program runs").code();
        assert_eq!(other, Some(0), "{name}");
    }
    assert!(count > 8, "{count} functions");
}

/// `press_error` is the function that returns the text of an error.
#[test]
fn columns_of_a_renamed_function_have_its_name_in_c() {
    let text = "pub struct Press { unit mm; input phi = 1rad; let pin = polar(30mm, phi); }
        impl Press { pub fn error(phi) -> Error { pin } }";
    let given = Given::text(text);
    let sweeps = column_sweeps(&given.name, &given.unit, Real::Double).expect("it can be exported");
    assert!(
        sweeps.header.contains("enum { PRESS_ERROR__COLUMNS = 2 };"),
        "{}",
        sweeps.header
    );
}
