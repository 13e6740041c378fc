//! What is printed: everything, and nothing over it.

use linkage_browser::samples::{FourBar, four_bar, sliders, spatial, written};
use linkage_browser::{Page, some};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Rows and items that are not wholly to be seen when they stand at the foot of the window, where what is fixed would lie over them: both
/// ends of each are looked at. Items within a folder that is closed have no size.
const HIDDEN: &str = "[...document.querySelectorAll('#sheets tr, #sheets li, #sheets p, #gaps, header p')]\
  .filter((row) => row.innerText.trim() !== '' && !row.closest('#chooser, details:has(> .buttons), footer'))\
  .filter((row) => {\
    row.scrollIntoView({ block: 'end', behavior: 'instant' });\
    const box = row.getBoundingClientRect();\
    if (!(box.width > 0 && box.height > 0) || box.left < 0 || box.right > innerWidth) return true;\
    const edge = 2;\
    return [box.left + edge, box.right - edge].some((x) => [box.top + edge, box.bottom - edge].some((y) => {\
      const seen = document.elementFromPoint(x, y);\
      return seen === null || !(row.contains(seen) || seen === row.closest('table') || seen === row.closest('.scroll'));\
    }));\
  }).map((row) => row.innerText.replace(/\\s+/g, ' ')).join('; ')";

/// Everything of a page that must stand on its sheets.
fn prints(file: &Path, name: &str) -> bool {
    let Some(mut page) = Page::open(file) else {
        return false;
    };
    let open =
        "[...document.querySelectorAll('#tables details')].filter((fold) => fold.open).length";
    let before = page.number(open);
    // Told after the page itself, so that it sees what the page has done.
    page.value("addEventListener('beforeprint', () => { window.closedFolds = document.querySelectorAll('#tables details:not([open])').length; })");
    let pdf = page.print(&format!("print-{name}"));
    let bytes = fs::read(&pdf).unwrap_or_else(|error| panic!("{}: {error}", pdf.display()));
    assert!(bytes.starts_with(b"%PDF"), "{}", pdf.display());
    assert_eq!(
        page.number("window.closedFolds"),
        0.0,
        "closed folds of {name} in print"
    );
    assert_eq!(
        page.number(open),
        before,
        "the reader's folds are as they were"
    );

    let report = crate::checks::report(&mut page);
    page.on_paper();
    assert_eq!(page.words(HIDDEN), "", "hidden in the print of {name}");
    let rows = |page: &mut Page, table: &str| {
        page.number(&format!(
            "document.querySelectorAll('[data-table={table:?}] tbody tr').length"
        )) as usize
    };
    let count = |list: &Value| list.as_array().map_or(0, Vec::len);
    let columns = report["tables"].as_array().into_iter().flatten();
    let columns: usize = columns.map(|table| count(&table["columns"])).sum();
    assert_eq!(rows(&mut page, "values"), columns + count(&report["true"]));
    assert_eq!(rows(&mut page, "dimensions"), count(&report["dimensions"]));
    assert_eq!(rows(&mut page, "summary"), count(&report["summary"]));
    let over = page.words("[...document.querySelectorAll('body *')].filter((item) => ['fixed', 'sticky'].includes(getComputedStyle(item).position) && item.getClientRects().length > 0).map((item) => item.id).join(' ')");
    assert_eq!(over, "", "over the sheets of {name}");
    // A plot and its legend go together to the next sheet.
    assert!(page.holds("[...document.querySelectorAll('.panel, #figure')].every((item) => getComputedStyle(item).breakInside === 'avoid' && item.getBoundingClientRect().height < innerHeight)"));
    page.assert_quiet();
    true
}

#[test]
fn everything_is_printed() {
    let reports = [
        ("four-bar", four_bar("On sheets", FourBar::TURNING)),
        ("swinging", four_bar("With gaps", FourBar::SWINGING)),
        ("sliders", sliders()),
        ("space", spatial()),
    ];
    for (name, report) in reports {
        if !prints(&written(&report, &format!("print-{name}")), name) {
            return;
        }
    }
}

#[test]
fn every_report_of_the_gallery_is_printed() {
    for entry in some() {
        if !prints(&entry.page, &entry.name) {
            return;
        }
    }
}
