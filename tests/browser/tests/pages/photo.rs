//! Photographs and paper: a picture behind the drawing, and pages as they are printed.

use linkage_browser::samples::{FourBar, four_bar, sliders, spatial, written};
use linkage_browser::{Page, some};
use serde_json::Value;
use std::fs;
use std::path::Path;

// A photograph behind the drawing: to scale after two clicks, with the drawing when that is moved, and in no saved file.

/// Chooses a picture of 200 times 100 pixels.
const CHOOSE: &str = "(async () => { \
    const canvas = new OffscreenCanvas(200, 100); canvas.getContext('2d').fillRect(0, 0, 200, 100); \
    const all = new DataTransfer(); \
    all.items.add(new File([await canvas.convertToBlob()], 'machine.png', { type: 'image/png' })); \
    const file = document.querySelector('#hint input[type=file]'); \
    file.files = all.files; file.dispatchEvent(new Event('change')); return 0; })()";

/// Left, top, width and height of the photograph in pixels.
fn shown(page: &mut Page) -> [f64; 4] {
    let found = page.value(
        "['x', 'y', 'width', 'height'].map((name) => Number(document.querySelector('#drawing image').getAttribute(name)))",
    );
    [0, 1, 2, 3].map(|k| found[k].as_f64().expect("a number"))
}

/// A press on the drawing at these pixels of it.
fn press(page: &mut Page, [x, y]: [f64; 2], kinds: &str) {
    page.value(&format!(
        "(() => {{ const view = document.getElementById('drawing'); const {{ left, top }} = view.getBoundingClientRect(); \
           view.setPointerCapture = () => {{}}; \
           for (const kind of {kinds:?}.split(' ')) view.dispatchEvent(new PointerEvent(kind, \
             {{ bubbles: true, pointerId: 1, clientX: left + {x}, clientY: top + {y} }})); return 0; }})()"
    ));
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 0.5, "{a} {b}");
}

#[test]
fn a_photograph_is_behind_the_drawing_to_scale() {
    let file = written(&four_bar("Photograph", FourBar::TURNING), "photo");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    page.value(CHOOSE);
    page.wait("document.querySelector('#drawing image') !== null");
    assert!(page.holds("document.querySelector('#drawing').firstElementChild.contains(document.querySelector('#drawing image'))"));
    let [x, y, width, height] = shown(&mut page);
    near(width, 2.0 * height);
    // A quarter of its width is said to be 60 mm.
    press(
        &mut page,
        [x + width / 2.0, y + height / 2.0],
        "pointerdown pointerup",
    );
    assert!(page.holds("document.getElementById('photo-length').disabled"));
    press(
        &mut page,
        [x + 0.75 * width, y + height / 2.0],
        "pointerdown pointerup",
    );
    page.value("(() => { const length = document.getElementById('photo-length'); length.value = '60'; length.dispatchEvent(new Event('change')); return 0; })()");
    let scale = page.number("Number(document.getElementById('drawing').dataset.scale)");
    let scaled = shown(&mut page);
    near(scaled[2], 240.0 * scale);
    near(scaled[3], 120.0 * scale);
    // The first point stays.
    near(scaled[0] + scaled[2] / 2.0, x + width / 2.0);
    near(scaled[1] + scaled[3] / 2.0, y + height / 2.0);
    // It grows and moves with the drawing.
    page.click("#nearer");
    let larger = shown(&mut page);
    near(larger[2], 1.25 * scaled[2]);
    page.click("#fit");
    page.click("#photo-move");
    press(&mut page, [100.0, 100.0], "pointerdown");
    press(&mut page, [130.0, 80.0], "pointermove pointerup");
    let moved = shown(&mut page);
    near(moved[0], scaled[0] + 30.0);
    near(moved[1], scaled[1] - 20.0);
    page.value("(() => { const opacity = document.querySelector('#photo-line input'); opacity.value = 0.25; opacity.dispatchEvent(new Event('input')); return 0; })()");
    assert!(
        page.holds("document.querySelector('#drawing image').getAttribute('opacity') === '0.25'")
    );
    // Files are without it.
    page.value("window.caught = null; HTMLAnchorElement.prototype.click = function () { fetch(this.href).then((answer) => answer.text()).then((text) => { window.caught = text; }); }; 1");
    page.click("[data-file='mechanism.svg']");
    page.wait("window.caught !== null");
    assert!(page.holds("window.caught.includes('data-link') && !window.caught.includes('<image')"));
    page.click("#photo-remove");
    assert!(page.holds("document.querySelector('#drawing image') === null"));
    page.assert_quiet();
}

#[test]
fn space_has_no_photograph() {
    let Some(mut page) = Page::open(&written(&spatial(), "photo-space")) else {
        return;
    };
    assert!(page.holds("document.getElementById('photo') === null"));
    page.assert_quiet();
}

// What is printed: everything, and nothing over it.

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
