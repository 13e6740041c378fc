//! The figures in `docs/controllers.md`.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use crate::code::Function;

/// What another version of the compiler may change, in percent.
const MAY_DIFFER: usize = 15;

fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/controllers.md")
}

fn read() -> String {
    std::fs::read_to_string(path()).expect("the page is there")
}

/// Whether the page names a function.
pub(crate) fn names(function: &str) -> bool {
    read().contains(&format!("`{function}`"))
}

/// Compares with the table below the target's name, or writes it anew if the environment has `UPDATE=1`.
///
/// # Panics
///
/// If the page says something else.
pub(crate) fn compare(target: &str, functions: &[(&str, Function)]) {
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
