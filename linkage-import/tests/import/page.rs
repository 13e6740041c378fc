//! The pages about files show what is written.

use std::fs;
use std::path::Path;

use linkage_import::{Format, Options, import};

/// Returns the name of a file that the line before a block gives: `` `NAME`: ``.
fn named(before: &str) -> Option<&str> {
    let line = before.trim_end().lines().next_back()?;
    line.strip_prefix('`')?.strip_suffix("`:")
}

/// Returns the options that a page names in front of a file: a table of closures, or the meaning of
/// points.
fn options(before: &str, closures: Option<String>) -> Options {
    let value = |option: &str| {
        let start = before.rfind(option)? + option.len();
        let rest = before[start..].trim_start();
        let end = rest.find(|letter: char| letter.is_whitespace() || letter == '`')?;
        Some(rest[..end].to_owned())
    };
    let is_suspension = before.contains("--axes");
    Options {
        format: is_suspension.then_some(Format::HardPoints),
        closures,
        axes: value("--axes "),
        length: value("--length "),
        side: value("--side "),
        ..Options::default()
    }
}

/// Returns the text of a block: after a line with the name of a file and a colon, or after a command
/// with an address.
fn written(before: &str, block: &str, closures: Option<String>) -> Option<String> {
    let mut options = options(before, closures);
    let (content, name) = if let Some(command) = block.strip_prefix("$ linkage import ") {
        let (address, rest) = command.trim_start_matches('"').split_once('"')?;
        let called = rest.split_once("--name ").map(|parts| parts.1.trim());
        options.mechanism = called.map(str::to_owned);
        ("", address)
    } else {
        (block, named(before)?)
    };
    let imported = import(content.as_bytes(), name, &options);
    Some(
        imported
            .unwrap_or_else(|error| panic!("{name}: {error}"))
            .text,
    )
}

/// Compares the texts of a page. Set `UPDATE` to write them into it.
fn shows(page: &str, examples: usize) {
    let page = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../docs")
        .join(page);
    let text = fs::read_to_string(&page).expect("the page");
    let mut pieces: Vec<String> = text.split("```").map(str::to_owned).collect();
    let mut closures = None;
    let mut count = 0;
    for index in (1..pieces.len()).step_by(2) {
        let (_, block) = pieces[index].split_once('\n').expect("a block");
        if named(&pieces[index - 1]) == Some("closures.csv") {
            closures = Some(block.to_owned());
            continue;
        }
        let Some(wanted) = written(&pieces[index - 1], block, closures.take()) else {
            continue;
        };
        assert_eq!(pieces[index + 1].trim(), "The text:");
        let wanted = format!("text\n{wanted}");
        if std::env::var_os("UPDATE").is_none() {
            assert_eq!(pieces[index + 2], wanted);
        }
        pieces[index + 2] = wanted;
        count += 1;
    }
    assert_eq!(count, examples, "examples");
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&page, pieces.join("```")).expect("the page can be written");
    }
}

#[test]
fn the_page_of_drawings_shows_what_is_written() {
    shows("from-your-files.md", 5);
}

#[test]
fn the_page_of_robots_shows_what_is_written() {
    shows("from-your-files/robots.md", 3);
}

#[test]
fn the_page_of_suspensions_shows_what_is_written() {
    shows("from-your-files/hard-points.md", 1);
}
