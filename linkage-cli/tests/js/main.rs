//! Mechanisms in JavaScript, in the browser, against the command's own numbers.

mod assembled;
mod ranges;

use std::fs;
use std::path::Path;

use linkage_browser::Page;
use linkage_compiler::Checked;
use linkage_corpus::given::Given;
use linkage_engine::Mechanism;

/// Loads the module of a mechanism, which is `mechanism` in the page. Tests of another kind have files of their own.
fn load(kind: &str, given: Given, page: &mut Page) -> Mechanism {
    let Given { name, unit } = given;
    let script = linkage_js::module(&name, &unit).script;
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}_{kind}.html"));
    let html = format!(
        "<!doctype html><meta charset=\"utf-8\"><script type=\"module\">\n{script}\nwindow.mechanism = mechanism;\n</script>"
    );
    fs::write(&file, html).expect("a file");
    page.load(&file);
    page.wait(&format!("mechanism.name === '{name}'"));
    let checked = Checked {
        name: Some(name),
        unit: Some(unit),
        out_of_range: None,
        messages: Vec::new(),
        warnings: Vec::new(),
        model: None,
    };
    Mechanism::new(&checked).expect("it has no mistake")
}

/// Dimensions as an object of JavaScript.
fn object(mechanism: &Mechanism, dimensions: &[f64]) -> String {
    let names = mechanism.parameters().iter().map(|own| own.name);
    let pairs = names.zip(dimensions);
    let pairs: Vec<String> = pairs.map(|(name, x)| format!("{name:?}: {x:?}")).collect();
    format!("{{ {} }}", pairs.join(", "))
}
