//! The page about files shows what is written.

use std::fs;
use std::path::Path;

use linkage_import::{Options, import};

/// Returns the text of a block of the page: after a line with the name of a file and a colon, or
/// after a command with an address.
fn written(before: &str, block: &str) -> Option<String> {
    let mut options = Options::default();
    let (content, name) = if let Some(command) = block.strip_prefix("$ linkage import ") {
        let (address, rest) = command.trim_start_matches('"').split_once('"')?;
        let called = rest.split_once("--name ").map(|parts| parts.1.trim());
        options.mechanism = called.map(str::to_owned);
        ("", address)
    } else {
        let line = before.trim_end().lines().next_back()?;
        let name = line.strip_prefix('`')?.strip_suffix("`:")?;
        (block, name)
    };
    let imported = import(content.as_bytes(), name, &options);
    Some(
        imported
            .unwrap_or_else(|error| panic!("{name}: {error}"))
            .text,
    )
}

/// Set `UPDATE` to write the texts into the page.
#[test]
fn the_page_shows_what_is_written() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/from-your-files.md");
    let text = fs::read_to_string(&page).expect("the page");
    let mut pieces: Vec<String> = text.split("```").map(str::to_owned).collect();
    let mut count = 0;
    for index in (1..pieces.len()).step_by(2) {
        let (_, block) = pieces[index].split_once('\n').expect("a block");
        let Some(wanted) = written(&pieces[index - 1], block) else {
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
    assert_eq!(count, 5, "examples");
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&page, pieces.join("```")).expect("the page can be written");
    }
}
