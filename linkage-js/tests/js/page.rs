//! Modules in the browser.

use std::env;
use std::fs;
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};

use linkage_browser::Page;
use linkage_corpus::given::Given;

/// A page with the modules of these mechanisms, which are the list `mechanisms` there, and a script before them. `None` without a browser.
pub(crate) fn page(given: &[Given], before: &str) -> Option<Page> {
    let mut text = format!(
        "<!doctype html><meta charset=\"utf-8\"><title>Modules</title><script>const mechanisms = [];\n{before}</script>\n"
    );
    for own in given {
        let script = linkage_js::module(&own.name, &own.unit).script;
        text += &format!(
            "<script type=\"module\">\n{script}\nmechanisms.push(mechanism);\n</script>\n"
        );
    }
    let mut page = load(&text)?;
    page.wait(&format!("mechanisms.length === {}", given.len()));
    Some(page)
}

/// A page of this text. `None` without a browser.
pub(crate) fn load(text: &str) -> Option<Page> {
    static COUNT: AtomicU32 = AtomicU32::new(0);
    let mut page = Page::empty()?;
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    let file = env::temp_dir().join(format!("linkage-js-{}-{number}.html", process::id()));
    fs::write(&file, text).expect("a temporary file");
    page.load(&file);
    page.wait("document.readyState === 'complete'");
    fs::remove_file(&file).expect("it was written");
    Some(page)
}

/// Numbers as JavaScript.
pub(crate) fn list(numbers: &[f64]) -> String {
    let texts = numbers.iter().map(|x| match x {
        x if x.is_infinite() => if *x > 0.0 { "Infinity" } else { "-Infinity" }.to_owned(),
        x => format!("{x:?}"),
    });
    format!("[{}]", texts.collect::<Vec<_>>().join(","))
}

/// What `written` in the page made of numbers.
pub(crate) fn read(text: &str) -> Vec<f64> {
    let words = text.split_whitespace();
    words.map(|word| word.parse().expect("a number")).collect()
}

/// Numbers as a text of the page, every bit of them.
pub(crate) const WRITTEN: &str = "const written = (numbers) => Array.from(numbers, (x) => (Object.is(x, -0) ? \"-0\" : String(x))).join(\" \");\n";
