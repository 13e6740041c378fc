//! The drawing and the plots, saved as pictures.

use linkage_browser::Page;
use linkage_browser::samples::{FourBar, four_bar, spatial, written};
use serde_json::Value;

fn page(name: &str) -> Option<Page> {
    Page::open(&written(&four_bar("A & <B>", FourBar::TURNING), name))
}

/// Catches what a button gives to save.
fn save(page: &mut Page, name: &str) {
    page.value(
        "window.caught = null; HTMLAnchorElement.prototype.click = function () { \
           fetch(this.href).then((answer) => answer.blob()).then((blob) => { window.caught = blob; }); }; 1",
    );
    page.click(&format!("[data-file={name:?}]"));
    page.wait("window.caught !== null");
}

/// A saved picture, as a document that knows nothing of the page; what it has of the page's styles.
fn read(page: &mut Page, name: &str) -> Value {
    save(page, name);
    page.value(
        "(async () => { const text = await window.caught.text(); \
           window.saved = new DOMParser().parseFromString(text, 'image/svg+xml'); \
           const all = [...window.saved.querySelectorAll('*')]; \
           const colours = all.flatMap((node) => ['fill', 'stroke'].map((name) => node.getAttribute(name))); \
           return { type: window.caught.type, root: window.saved.documentElement.localName, \
             title: window.saved.querySelector('title').textContent, \
             classes: all.filter((node) => node.hasAttribute('class') || node.hasAttribute('style')).length, \
             variables: text.includes('var(') || text.includes('color('), \
             colours: colours.filter((c) => c !== null && c !== 'none' && !/^#[0-9a-f]{6}$/.test(c)) }; })()",
    )
}

fn assert_stands_alone(found: &Value, title: &str) {
    assert_eq!(found["type"], "image/svg+xml");
    assert_eq!(found["root"], "svg");
    assert_eq!(found["title"], title);
    assert_eq!(found["classes"], 0);
    assert_eq!(found["variables"], false);
    assert_eq!(found["colours"], serde_json::json!([]));
}

/// Width and height of a PNG, and how many of its pixels have nearly a colour.
fn pixels(page: &mut Page, name: &str, colour: &str) -> [f64; 3] {
    save(page, name);
    assert_eq!(page.words("window.caught.type"), "image/png");
    let found = page.value(&format!(
        "(async () => {{ const image = await createImageBitmap(window.caught); \
           const paint = new OffscreenCanvas(image.width, image.height).getContext('2d'); \
           paint.drawImage(image, 0, 0); \
           const data = paint.getImageData(0, 0, image.width, image.height).data; \
           const [r, g, b] = [1, 3, 5].map((at) => parseInt({colour:?}.slice(at, at + 2), 16)); \
           let count = 0; \
           for (let i = 0; i < data.length; i += 4) \
             if (Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 9 && data[i + 3] === 255) count += 1; \
           return [image.width, image.height, count]; }})()"
    ));
    [0, 1, 2].map(|i| found[i].as_f64().expect("a number"))
}

#[test]
fn the_mechanism_is_saved_as_it_is_seen() {
    let Some(mut page) = page("export-mechanism") else {
        return;
    };
    let found = read(&mut page, "mechanism.svg");
    assert_stands_alone(&found, "A & <B>");
    for part in ["[data-link]", "[data-point]", "[data-trace]"] {
        let count = |root: &str| format!("{root}.querySelectorAll('{part}').length");
        let seen = page.number(&count("document.querySelector('#drawing')"));
        assert!(
            seen > 0.0 && page.number(&count("window.saved")) == seen,
            "{part}"
        );
    }
    let path =
        |root: &str| format!("{root}.querySelector('[data-trace=tracer]').getAttribute('d')");
    let [seen, saved] = ["document", "window.saved"].map(|root| page.words(&path(root)));
    assert_eq!(seen, saved);
    // Outlines are darker than bodies, by no filter.
    let shares = page.value(
        "[...window.saved.querySelectorAll('[data-link]')].map((link) => { \
           const [a, b] = [...link.querySelectorAll('path')].map((path) => parseInt(path.getAttribute('stroke').slice(3, 5), 16)); \
           return a / b; })",
    );
    for share in shares.as_array().expect("links") {
        let share = share.as_f64().expect("a share");
        assert!((share - 0.62).abs() < 0.01, "{share}");
    }
    // Names that are not shown, and targets of fingers, are not there.
    assert!(page.holds(
        "![...window.saved.querySelectorAll('text')].some((t) => t.textContent === 'tracer')"
    ));
    let colour =
        page.words("window.saved.querySelector('[data-trace=tracer]').getAttribute('stroke')");
    let [left, top, width, height] = page.place("#drawing");
    assert!(left >= 0.0 && top < 900.0);
    let [w, h, count] = pixels(&mut page, "mechanism.png", &colour);
    assert_eq!([w, h], [2.0 * width.round(), 2.0 * height.round()]);
    assert!(count > 500.0, "{count} pixels of {colour}");
    page.assert_quiet();
}

#[test]
fn plots_are_saved_with_their_legends() {
    let Some(mut page) = page("export-plots") else {
        return;
    };
    page.dark(true);
    let found = read(&mut page, "plots.svg");
    assert_stands_alone(&found, "A & <B>");
    let curves = "[...ROOT.querySelectorAll('[data-column][d]')].map((c) => c.dataset.column + c.getAttribute('d')).join('\\n')";
    let [seen, saved] =
        ["document", "window.saved"].map(|root| page.words(&curves.replace("ROOT", root)));
    assert_eq!(seen, saved);
    assert!(seen.lines().count() >= 6);
    let words = page
        .words("[...window.saved.querySelectorAll('text')].map((t) => t.textContent).join('|')");
    for legend in [
        "|tracer.x [mm]|",
        "|tracer.y [mm]|",
        "|psi [deg]|",
        "|v.x [mm/s]|",
    ] {
        assert!(words.contains(legend), "{legend} in {words}");
    }
    assert!(page.holds("window.saved.querySelector('[data-cursor]') === null"));
    let size = page.value("['width', 'height'].map((side) => Number(window.saved.documentElement.getAttribute(side)))");
    let colour = page.words("window.saved.querySelector(\"[data-column='motion||tracer.x|mm']\").getAttribute('stroke')");
    let [w, h, count] = pixels(&mut page, "plots.png", &colour);
    assert_eq!(Some(w), size[0].as_f64().map(|x| 2.0 * x));
    assert_eq!(Some(h), size[1].as_f64().map(|x| 2.0 * x));
    assert!(count > 500.0, "{count} pixels of {colour}");
    page.assert_quiet();
}

#[test]
fn space_is_saved_too() {
    let Some(mut page) = Page::open(&written(&spatial(), "export-space")) else {
        return;
    };
    let found = read(&mut page, "mechanism.svg");
    assert_stands_alone(&found, "Crank and rocker in space");
    page.assert_quiet();
}

/// The picture that moves has at each of its times what the page shows at that row.
#[test]
fn the_mechanism_is_saved_moving() {
    let Some(mut page) = page("export-moving") else {
        return;
    };
    page.click("[data-vectors=velocity]");
    crate::checks::go_to(&mut page, 123);
    let before = page.words("document.querySelector('[data-link] path').getAttribute('d')");
    let found = read(&mut page, "moving.svg");
    assert_stands_alone(&found, "A & <B>");
    assert_eq!(
        page.words("document.querySelector('[data-link] path').getAttribute('d')"),
        before,
        "the page stays where it is"
    );
    let seconds = page.words("[...new Set([...window.saved.querySelectorAll('animate')].map((own) => own.getAttribute('dur')))].join(' ')");
    assert_eq!(seconds, "8s");
    let moving = page.number("window.saved.querySelectorAll('animate').length");
    assert!(moving > 10.0, "{moving} courses");
    // Every sixth degree, and the beginning again.
    let saved = page.value(
        "[...window.saved.querySelectorAll('[data-link] path, [data-arrow] path')].map((own) => own.querySelector('animate')?.getAttribute('values').split(';') ?? own.getAttribute('d'))",
    );
    for key in [0_usize, 10, 41, 59, 60] {
        crate::checks::go_to(&mut page, (6 * key) % 360);
        let shown = page.value("[...document.querySelectorAll('#drawing [data-link] path, #drawing [data-arrow] path')].map((own) => own.getAttribute('d'))");
        let pairs = shown
            .as_array()
            .expect("paths")
            .iter()
            .zip(saved.as_array().expect("courses"));
        assert_eq!(
            shown.as_array().map(Vec::len),
            saved.as_array().map(Vec::len)
        );
        for (shown, course) in pairs {
            match course.as_array() {
                Some(course) => {
                    assert_eq!(course.len(), 61);
                    assert_eq!(&course[key], shown, "at {key}");
                }
                None => assert_eq!(course, shown),
            }
        }
    }
    page.assert_quiet();
}

/// The bytes of what was saved, in letters.
fn letters(page: &mut Page) -> String {
    page.words(
        "(async () => { const reader = new FileReader(); reader.readAsDataURL(window.caught); \
           await new Promise((done) => { reader.onload = done; }); return reader.result; })()",
    )
}

/// The shortest time for a range.
fn run_fast(page: &mut Page) {
    page.value(
        "(() => { const speed = document.getElementById('speed'); speed.value = '1'; \
           speed.dispatchEvent(new Event('change')); return 0; })()",
    );
}

#[test]
fn a_film_is_recorded() {
    let Some(mut page) = page("export-film") else {
        return;
    };
    run_fast(&mut page);
    crate::checks::go_to(&mut page, 123);
    let [_, _, width, height] = page.place("#drawing");
    save(&mut page, "moving.webm");
    assert_eq!(page.words("window.caught.type"), "video/webm");
    assert_eq!(page.row(), 123);
    let film = letters(&mut page);
    page.assert_quiet();
    let text = format!("<!doctype html><video muted src=\"{film}\"></video>");
    page.load(&linkage_browser::samples::page_written(
        &text,
        "export-film-shown",
    ));
    page.wait("document.querySelector('video').readyState >= 2");
    let size = page.value(
        "['videoWidth', 'videoHeight'].map((side) => document.querySelector('video')[side])",
    );
    assert_eq!(size[0].as_f64(), Some(width.round()));
    assert_eq!(size[1].as_f64(), Some(height.round()));
    // It runs for a second, longer where a busy machine records slowly, and its pictures differ.
    page.value(
        "(() => { const film = document.querySelector('video'); window.pictures = new Set(); \
           const look = () => { const canvas = new OffscreenCanvas(80, 60); const paint = canvas.getContext('2d'); \
             paint.drawImage(film, 0, 0, 80, 60); window.pictures.add(paint.getImageData(0, 0, 80, 60).data.join()); \
             film.requestVideoFrameCallback(look); }; \
           film.requestVideoFrameCallback(look); film.play(); return 0; })()",
    );
    page.wait("document.querySelector('video').ended");
    let seconds = page.number("document.querySelector('video').currentTime");
    assert!(seconds > 0.8 && seconds < 5.0, "{seconds} s");
    let pictures = page.number("window.pictures.size");
    assert!(pictures > 4.0, "{pictures} pictures");
}

#[test]
fn a_film_is_saved_as_gif() {
    let Some(mut page) = page("export-gif") else {
        return;
    };
    run_fast(&mut page);
    save(&mut page, "moving.gif");
    page.value("window.film = window.caught; 0");
    let found = page.value(
        "(async () => { const film = new ImageDecoder({ data: await window.film.arrayBuffer(), type: 'image/gif' }); \
           await film.completed; await film.tracks.ready; window.pictures = []; \
           const { frameCount, repetitionCount } = film.tracks.selectedTrack; \
           let time = 0; \
           for (let k = 0; k < frameCount; k += 1) { \
             const { image } = await film.decode({ frameIndex: k }); time += image.duration / 1e6; \
             const paint = new OffscreenCanvas(image.displayWidth, image.displayHeight).getContext('2d'); \
             paint.drawImage(image, 0, 0); \
             window.pictures.push(paint.getImageData(0, 0, image.displayWidth, image.displayHeight).data); } \
           return { count: frameCount, again: repetitionCount === Infinity, time, bytes: window.film.size }; })()",
    );
    assert_eq!(found["count"], 13);
    assert_eq!(found["again"], true);
    let time = found["time"].as_f64().expect("seconds");
    assert!((time - 1.0).abs() < 0.1, "{time} s");
    let bytes = found["bytes"].as_f64().expect("a size");
    assert!(bytes < 300_000.0, "{bytes} bytes");
    // Each picture is the drawing at its row, and no other.
    for (picture, other) in [(0, 6), (6, 0), (12, 5)] {
        let row = (360.0 * f64::from(picture) / 13.0).round() as usize;
        crate::checks::go_to(&mut page, row);
        save(&mut page, "mechanism.svg");
        let apart = page.value(&format!(
            "(async () => {{ const image = new Image(); image.src = URL.createObjectURL(window.caught); await image.decode(); \
               const paint = new OffscreenCanvas(image.width, image.height).getContext('2d'); paint.drawImage(image, 0, 0); \
               const { } = paint.getImageData(0, 0, image.width, image.height); \
               const apart = (own) => data.reduce((sum, x, k) => sum + (Math.abs(x - own[k]) > 40), 0) / data.length; \
               return [{picture}, {other}].map((k) => apart(window.pictures[k])); }})()",
            "{ data }"
        ));
        let [here, there] = [0, 1].map(|k| apart[k].as_f64().expect("a share"));
        assert!(
            here < 1e-3 && there > 5.0 * here && there > 3e-3,
            "{here} {there}"
        );
    }
    page.assert_quiet();
}
