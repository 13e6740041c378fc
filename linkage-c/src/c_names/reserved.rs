//! Names that C, C++ and their libraries have. The lists are those of the standards up to C23 and
//! C++23, of POSIX, and of the headers of glibc, newlib and avr-libc; a test compares them with the
//! headers of the system.

use std::collections::BTreeSet;
use std::sync::OnceLock;

/// The names of a list.
type Set = BTreeSet<&'static str>;

/// Words of C and C++ in any version.
pub(crate) fn is_keyword(name: &str) -> bool {
    static ALL: OnceLock<Set> = OnceLock::new();
    is_in(&ALL, include_str!("keywords.txt"), name)
}

/// Macros of the library that stand for something without arguments: no name of the user may be
/// one, wherever it is.
pub(crate) fn is_macro(name: &str) -> bool {
    static ALL: OnceLock<Set> = OnceLock::new();
    is_in(&ALL, include_str!("macros.txt"), name)
        || is_of_integers(name)
        || ends()
            .filter_map(|end| name.strip_suffix(end))
            .any(|base| base.starts_with("M_") && is_macro(base))
}

/// Functions, types and variables of the library, and macros with arguments: no name of a file may
/// be one.
pub(crate) fn is_declared(name: &str) -> bool {
    static ALL: OnceLock<Set> = OnceLock::new();
    let all = include_str!("declared.txt");
    let mut bases = ends().filter_map(|end| name.strip_suffix(end));
    is_in(&ALL, all, name) || bases.any(|base| is_in(&ALL, all, base))
}

/// Functions and types of `math.h` and `stddef.h`: no argument is called so.
pub(crate) fn is_mathematics(name: &str) -> bool {
    static ALL: OnceLock<Set> = OnceLock::new();
    is_in(&ALL, include_str!("mathematics.txt"), name)
}

/// Headers, without `.h`: no file of a mechanism may be one.
pub(crate) fn is_header(name: &str) -> bool {
    static ALL: OnceLock<Set> = OnceLock::new();
    is_in(&ALL, include_str!("headers.txt"), name)
}

/// Names that the standards leave to compilers, among those of a whole file or of something in it.
pub(crate) fn is_for_compilers(name: &str, of_file: bool) -> bool {
    let Some(rest) = name.strip_prefix('_') else {
        return false;
    };
    of_file || rest.starts_with(|c: char| c == '_' || c.is_ascii_uppercase())
}

fn is_in(all: &OnceLock<Set>, text: &'static str, name: &str) -> bool {
    all.get_or_init(|| text.split_whitespace().collect())
        .contains(name)
}

/// Ends of the names of functions and constants for each type of numbers.
fn ends() -> impl Iterator<Item = &'static str> {
    [
        "f", "l", "f16", "f32", "f32x", "f64", "f64x", "f128", "f128x",
    ]
    .into_iter()
}

/// `INT_FAST16_MAX`, `UINTPTR_WIDTH`, `INT8_C`, `PRIuLEAST32`, `SCNdMAX`.
fn is_of_integers(name: &str) -> bool {
    let sizes = |text: &str| matches!(text, "8" | "16" | "32" | "64" | "MAX" | "PTR");
    let fast = |text: &str, mark: &str| {
        let rest = ["FAST", "LEAST"]
            .iter()
            .find_map(|kind| text.strip_prefix(mark)?.strip_prefix(kind));
        rest.is_some_and(sizes)
    };
    if let Some(rest) = ["PRI", "SCN"]
        .iter()
        .find_map(|entry| name.strip_prefix(entry))
    {
        let kind = rest.strip_prefix(|c: char| "diouxXbB".contains(c));
        return kind.is_some_and(|rest| sizes(rest) || fast(rest, ""));
    }
    let rest = name.strip_prefix('U').unwrap_or(name).strip_prefix("INT");
    let rest = rest.and_then(|rest| {
        ["_MAX", "_MIN", "_WIDTH", "_C"]
            .iter()
            .find_map(|end| rest.strip_suffix(end))
    });
    rest.is_some_and(|rest| sizes(rest) || fast(rest, "_"))
}
