//! The machine code of functions in single precision for small processors: neither branch nor call, hence the same instructions
//! for every input. Skipped where a target is not installed, unless `LINKAGE_TARGETS` names it.

mod code;
mod instruction;

use crate::code::Function;
use code::Library;
use instruction::{Decode, aarch64, thumb};
use std::fmt::Write;
use std::path::{Path, PathBuf};

const THUMB: &str = "thumbv7em-none-eabihf";

/// Functions of the package.
const FUNCTIONS: [&str; 8] = [
    "slider_crank_motion",
    "crank_rocker_position",
    "crank_rocker_motion",
    "crank_rocker_accuracy",
    "crank_rocker_angle",
    "quick_return_motion",
    "toggle_press_motion",
    "spatial_crank_rocker_motion",
];

/// What assembles the mechanisms.
const ASSEMBLIES: [&str; 5] = [
    "slider_crank_assemble",
    "crank_rocker_assemble",
    "quick_return_assemble",
    "toggle_press_assemble",
    "spatial_crank_rocker_assemble",
];

fn library(target: &str, decode: Decode) -> Option<Library> {
    Some(Library::read(&code::library(target)?, decode))
}

fn functions_are_straight(target: &str, decode: Decode) {
    let Some(library) = library(target, decode) else {
        return;
    };
    let functions = FUNCTIONS.map(|name| (name, library.function(name)));
    for (name, function) in &functions {
        assert!(function.instructions > 50, "{name}: {function:?}");
        assert_eq!(function.returns, 1, "{name}: {function:?}");
        assert!(function.branches.is_empty(), "{name}: {function:?}");
        assert!(function.doubles.is_empty(), "{name}: {function:?}");
        assert!(function.calls.is_empty(), "{name}: {function:?}");
    }
    compare_with_page(target, &functions);
}

#[test]
fn functions_for_a_cortex_m4_are_straight() {
    functions_are_straight(THUMB, thumb);
}

#[test]
fn functions_for_aarch64_are_straight() {
    functions_are_straight("aarch64-unknown-linux-gnu", aarch64);
}

/// As the table of the page says.
#[test]
fn what_is_called_on_a_cortex_m4_is_known() {
    let Some(library) = library(THUMB, thumb) else {
        return;
    };
    let names = |function: &str| library.function(function).calls;
    let called = names("functions_at");
    assert_eq!(called.len(), 3, "{called:?}");
    for name in ["5asinf", "5acosf", "5atanf"] {
        assert!(
            called.iter().any(|called| called.contains(name)),
            "{called:?}"
        );
    }

    for name in ASSEMBLIES {
        for called in names(name) {
            let known = page_names(&called) || called.contains("linkage") || called == code::INSIDE;
            assert!(known, "{name} calls {called}, which the page does not say");
        }
    }
}

// The figures in `docs/controllers.md`.

/// What another version of the compiler may change, in percent.
const MAY_DIFFER: usize = 15;

fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/controllers.md")
}

fn read() -> String {
    std::fs::read_to_string(path()).expect("the page is there")
}

/// Whether the page names a function.
fn page_names(function: &str) -> bool {
    read().contains(&format!("`{function}`"))
}

/// Compares with the table below the target's name, or writes it anew if the environment has `UPDATE=1`.
///
/// # Panics
///
/// If the page says something else.
fn compare_with_page(target: &str, functions: &[(&str, Function)]) {
    let page = read();
    let (start, end) = table(&page, target);
    if std::env::var_os("UPDATE").is_some_and(|value| value == "1") {
        let page = [&page[..start], &printed(functions), &page[end..]].concat();
        return std::fs::write(path(), page).expect("the page can be written");
    }
    let rows = page[start..end].lines().skip(2).collect::<Vec<_>>();
    assert_eq!(rows.len(), functions.len(), "rows for {target}");
    for (row, (name, function)) in rows.into_iter().zip(functions) {
        let cells = row.split('|').map(str::trim).collect::<Vec<_>>();
        assert_eq!(cells[1], format!("`{name}`"));
        let numbers: Vec<usize> = cells[2..6]
            .iter()
            .map(|cell| cell.parse().expect("a number"))
            .collect();
        let near = |was: usize, is: usize| was.abs_diff(is) * 100 <= was * MAY_DIFFER;
        let same = near(numbers[0], function.instructions)
            && near(numbers[1], function.bytes)
            && numbers[2..] == [function.roots, function.divisions];
        assert!(
            same,
            "{target}: the page has {row}, but it is {function:?}; UPDATE=1 writes it anew"
        );
    }
}

/// Where the table of a target begins and ends.
fn table(page: &str, target: &str) -> (usize, usize) {
    let name = page
        .find(&format!("`{target}`:\n\n"))
        .expect("the page has the target");
    let start = name + page[name..].find('|').expect("a table");
    let end = page[start..]
        .find("\n\n")
        .map_or(page.len(), |at| start + at + 1);
    (start, end)
}

fn printed(functions: &[(&str, Function)]) -> String {
    let mut table = String::from(
        "| function | instructions | bytes | roots | divisions |\n|---|---|---|---|---|\n",
    );
    for (name, function) in functions {
        let Function {
            instructions,
            bytes,
            roots,
            divisions,
            ..
        } = function;
        writeln!(
            table,
            "| `{name}` | {instructions} | {bytes} | {roots} | {divisions} |"
        )
        .expect("a string takes everything");
    }
    table
}
