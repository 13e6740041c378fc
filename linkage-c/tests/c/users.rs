//! Programs of users that have exported files and standard headers.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use linkage_c::{Real, Sources, all_sources};
use linkage_corpus::given::Given;
use linkage_random::is_long;

use crate::machine::compilers;

/// A mechanism with these parameters, results, inputs and functions.
pub(crate) fn mechanism(
    name: &str,
    parameters: &[&str],
    results: &[&str],
    inputs: &[&str],
    functions: &[&str],
) -> String {
    let mut text = format!("pub struct {name} {{ unit mm; input angle__ = 30deg;\n");
    for own in parameters {
        let _ = writeln!(text, "param {own} = 3mm;");
    }
    for own in inputs {
        let _ = writeln!(text, "input {own} = 3mm;");
    }
    let terms = [parameters, inputs].concat();
    let sum = terms
        .iter()
        .fold("30mm".to_owned(), |sum, own| format!("{sum} + {own}"));
    let _ = writeln!(
        text,
        "let height__ = ({sum}) * sin(angle__); }}\nimpl {name} {{"
    );
    let takes: String = inputs.iter().map(|own| format!(", {own}")).collect();
    let gives: String = results
        .iter()
        .map(|own| format!("{own}: height__, "))
        .collect();
    let _ = writeln!(
        text,
        "pub fn all__(angle__{takes}) -> All {{ {gives} height__ }}"
    );
    for (number, own) in functions.iter().enumerate() {
        let _ = writeln!(
            text,
            "pub fn {own}(angle__{takes}) -> R{number} {{ height__ }}"
        );
    }
    text + "}\n"
}

/// A file of a user that has standard headers before the exported ones, or behind them.
fn user(headers: &[&str], all: &[Sources], before: bool) -> String {
    let standard: String = headers
        .iter()
        .map(|own| format!("#include <{own}>\n"))
        .collect();
    let ours: String = all
        .iter()
        .map(|own| format!("#include \"{}.h\"\n", own.name))
        .collect();
    let parts = if before {
        [standard, ours]
    } else {
        [ours, standard]
    };
    format!(
        "#ifndef _GNU_SOURCE\n#define _GNU_SOURCE\n#endif\n{}int main(void) {{ return 0; }}\n",
        parts.concat()
    )
}

/// Headers that C and C++ both have, and those of C alone.
pub(crate) const BOTH: [&str; 27] = [
    "assert.h",
    "ctype.h",
    "errno.h",
    "fcntl.h",
    "fenv.h",
    "float.h",
    "inttypes.h",
    "limits.h",
    "locale.h",
    "math.h",
    "setjmp.h",
    "signal.h",
    "stdarg.h",
    "stddef.h",
    "stdint.h",
    "stdio.h",
    "stdlib.h",
    "string.h",
    "strings.h",
    "sys/stat.h",
    "sys/time.h",
    "sys/types.h",
    "time.h",
    "unistd.h",
    "wchar.h",
    "wctype.h",
    "pthread.h",
];
pub(crate) const OF_C: [&str; 8] = [
    "complex.h",
    "iso646.h",
    "stdalign.h",
    "stdatomic.h",
    "stdbool.h",
    "stdnoreturn.h",
    "tgmath.h",
    "threads.h",
];

/// Compiles sources and users of all headers, in the versions of C and of C++.
pub(crate) fn compile(folder: &Path, all: &[Sources]) {
    let of_c = [&BOTH[..], &OF_C].concat();
    for (file, headers, before) in [
        ("before.c", &of_c[..], true),
        ("behind.c", &of_c, false),
        ("before.cc", &BOTH, true),
        ("behind.cc", &BOTH, false),
    ] {
        fs::write(folder.join(file), user(headers, all, before)).expect("C can be written");
    }
    let sources: Vec<String> = all.iter().map(|own| format!("{}.c", own.name)).collect();
    // What takes long is left to one compiler of each language.
    let is_asked = |command: &str| is_long() || matches!(command, "gcc" | "g++");
    for (command, compiler) in compilers() {
        if !is_asked(command) {
            continue;
        }
        let (language, with_sources, with_users, users) = match command.contains("++") {
            true => ("c++", "c++11", "c++20", ["before.cc", "behind.cc"]),
            // C23 has words that C17 does not have; C99 has no headers of threads.
            false => ("c", "c99", "gnu2x", ["before.c", "behind.c"]),
        };
        let check = |version: &str, files: &[&str]| {
            let standard = format!("-std={version}");
            let flags = [
                "-fsyntax-only",
                "-Wall",
                "-Wextra",
                "-Werror",
                "-x",
                language,
                &standard,
            ];
            compiler.run(folder, &[&flags, files].concat());
        };
        let files: Vec<&str> = sources.iter().map(String::as_str).collect();
        check(with_sources, &files);
        check(with_users, &users);
        println!("{command}: {} mechanisms", all.len());
    }
}

/// Mechanisms of one program.
pub(crate) fn exported(texts: &[String]) -> Vec<Sources> {
    let given: Vec<Given> = texts.iter().map(|text| Given::text(text)).collect();
    let named: Vec<_> = given.iter().map(|own| (&own.name[..], &own.unit)).collect();
    all_sources(&named, Real::Double).expect("no two names are one")
}
