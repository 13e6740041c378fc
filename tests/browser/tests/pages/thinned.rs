//! Pages of more positions than they show.

use crate::checks;
use linkage_browser::samples::{many, written};
use linkage_browser::{Key, Page};

#[test]
fn a_page_says_how_many_positions_it_has() {
    let Some(mut page) = Page::open(&written(&many(30_001), "thinned")) else {
        return;
    };
    let report = checks::report(&mut page);
    let rows = report["input"]["values"].as_array().map_or(0, Vec::len);
    assert!((19_000..=20_000).contains(&rows), "{rows}");
    let said = page.words("document.querySelector('#thinned').innerText");
    assert!(
        said.starts_with(&format!("This page has {rows} of 30001 positions")),
        "{said}"
    );
    page.key(Key::End);
    assert_eq!(page.row(), rows - 1);
    page.shoot("thinned");
    page.assert_quiet();
}
