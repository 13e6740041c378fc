//! Pages of reports that are written anew while they are open.

use std::path::Path;

use linkage_browser::Page;
use linkage_browser::samples::{FourBar, four_bar};
use linkage_report::{Index, show_mistakes};

/// The text of the banner, empty while it is hidden.
const BANNER: &str = "(() => { const own = document.getElementById('mistakes'); return own.hidden ? '' : own.innerText; })()";

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

#[test]
fn the_open_page_shows_mistakes_until_they_are_gone() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mistaken");
    let report = four_bar("Four-bar", FourBar::SWINGING)
        .index("Machine")
        .version(3);
    report.write(folder.join("bar")).expect("it can be written");
    let index = Index::new("Machine").version(3).report("bar", &report);
    index.write(&folder).expect("it can be written");
    let Some(mut page) = Page::open(&folder.join("bar/index.html")) else {
        return;
    };
    page.value("window.untouched = true");
    let mistakes = "error: unknown name `rot`\n  --> bar.mech:3:5 <b>\u{2028}</script>";
    for place in [folder.join("bar"), folder.clone()] {
        assert_eq!(show_mistakes(&place, mistakes).ok(), Some(true));
    }
    page.wait(&format!("{BANNER}.includes('bar.mech:3:5 <b>')"));
    assert!(page.holds(
        "window.untouched && document.getElementById('mistakes').getBoundingClientRect().top >= 0"
    ));
    show_mistakes(folder.join("bar"), "").expect("it can be written");
    page.wait(&format!("{BANNER} === ''"));
    assert!(page.holds("window.untouched"));
    // The page that leads to the report has them, too.
    page.value("document.getElementById('index').click()");
    page.wait("document.title === 'Machine' && document.getElementById('mistakes') !== null");
    page.wait(&format!("{BANNER}.includes('unknown name')"));
    assert!(page.complaints().is_empty(), "{:?}", page.complaints());
    let nothing = folder.join("plots");
    assert_eq!(show_mistakes(nothing, mistakes).ok(), Some(false));
}
