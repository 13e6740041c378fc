//! Pages of reports that are written anew while they are open.

use std::path::Path;

use linkage_browser::Page;
use linkage_browser::samples::{FourBar, four_bar};

#[test]
fn the_open_page_shows_the_new_report() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("followed");
    let write = |title: &str, version| {
        let report = four_bar(title, FourBar::SWINGING).version(version);
        report.write(&folder).expect("it can be written");
    };
    write("First", 1);
    let Some(mut page) = Page::open(&folder.join("index.html")) else {
        return;
    };
    // Asking for the version it has changes nothing.
    page.value("window.untouched = true");
    page.wait("window.linkageVersion !== undefined && document.head.querySelector('script[src]') === null");
    assert!(page.holds("window.untouched && document.title === 'First'"));
    write("Second", 2);
    page.wait("document.title === 'Second' && document.body.dataset.ready === 'true'");
    assert!(page.holds("window.untouched === undefined"));
    assert!(page.complaints().is_empty(), "{:?}", page.complaints());
}
