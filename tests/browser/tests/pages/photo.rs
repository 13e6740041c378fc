//! A photograph behind the drawing: to scale after two clicks, with the drawing when that is moved, and in no saved file.

use linkage_browser::Page;
use linkage_browser::samples::{FourBar, four_bar, spatial, written};

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
