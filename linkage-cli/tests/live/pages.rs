//! Pages of the command, and what is in them.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use linkage_browser::Page;
use linkage_engine::{Assembly, Mechanism, Source};

/// Files that the page saves are kept in the page instead.
pub(crate) const CATCH: &str = "window.saved = []; URL.createObjectURL = (blob) => { window.saved.push(blob); return 'data:,'; }; 0";

/// Saves a file, and gives its text.
const SAVED: &str = "document.querySelector('button[data-file=\"NAME\"]').click(); \
     while (window.saved.length === 0) await new Promise((done) => setTimeout(done, 5)); \
     return window.saved.pop().text();";

/// The page of a mechanism.
pub(crate) struct Live {
    pub(crate) page: Page,
    // As long as its assemblies.
    pub(crate) mechanism: &'static Mechanism,
}

impl Live {
    /// Of an example; `None` without a browser.
    pub(crate) fn example(name: &str) -> Option<Self> {
        Self::example_as(name, "live")
    }

    /// In a folder of its own: tests run beside each other.
    pub(crate) fn example_as(name: &str, kind: &str) -> Option<Self> {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../mechanisms");
        Self::new(&file.join(name), kind)
    }

    /// Of a golden file of the compiler.
    pub(crate) fn golden(name: &str) -> Option<Self> {
        Self::golden_as(name, "live")
    }

    /// In a folder of its own.
    pub(crate) fn golden_as(name: &str, kind: &str) -> Option<Self> {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../linkage-compiler/tests/golden");
        Self::new(&file.join(name), kind)
    }

    /// Of a text.
    pub(crate) fn text(name: &str, text: &str) -> Option<Self> {
        let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.mech"));
        fs::write(&file, text).expect("a file");
        Self::new(&file, "live")
    }

    fn new(file: &Path, kind: &str) -> Option<Self> {
        let folder = written(file, kind);
        let mechanism = mechanism(file);
        let mut page = Page::open(&folder.join("index.html"))?;
        page.value(CATCH);
        Some(Self { page, mechanism })
    }

    /// Changes all dimensions.
    pub(crate) fn set(&mut self, dimensions: &[f64]) {
        let pairs = self.mechanism.parameters().iter().zip(dimensions);
        let parts: Vec<String> = pairs
            .map(|(own, x)| format!("{}={x:?}", own.name))
            .collect();
        let address = parts.join("&");
        self.page.value(&format!(
            "new Promise((done) => {{ addEventListener('hashchange', () => setTimeout(done), {{ once: true }}); location.hash = '{address}'; }})"
        ));
    }

    pub(crate) fn says(&mut self) -> String {
        self.page
            .words("document.getElementById('says').textContent")
    }

    /// A table as the page saves it, without the line of changes before its head.
    pub(crate) fn csv(&mut self, function: &str) -> String {
        let text = self.file(&format!("{function}.csv"));
        match text.split_once("\r\n") {
            Some((line, table)) if line.trim_start_matches('"').starts_with("# changed:") => {
                table.to_owned()
            }
            _ => text,
        }
    }

    /// A file as the page saves it.
    pub(crate) fn file(&mut self, name: &str) -> String {
        saved_file(&mut self.page, name)
    }
}

/// A file as a page saves it.
pub(crate) fn saved_file(page: &mut Page, name: &str) -> String {
    let saved = SAVED.replace("NAME", name);
    page.words(&format!("(async () => {{ {saved} }})()"))
}

/// The first mechanism of a file.
pub(crate) fn mechanism(file: &Path) -> &'static Mechanism {
    let text = fs::read_to_string(file).expect("the file");
    let source = Source::new("file", &text).expect("brackets have partners");
    let checked = linkage_compiler::check(source.calls()[0].tokens.clone());
    let mechanism = Mechanism::new(&checked).expect("a mechanism without a mistake");
    Box::leak(Box::new(mechanism))
}

fn written(file: &Path, kind: &str) -> PathBuf {
    let name = file.file_stem().expect("a name").to_string_lossy();
    let folder = folder(&name, kind);
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    let output = command
        .arg("page")
        .arg(file)
        .arg("-o")
        .arg(&folder)
        .output();
    let output = output.expect("it runs");
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    folder
}

/// Roundoffs of what is computed, as in `js/assembled.rs`.
const ROUNDOFFS: f64 = 200.0;

/// Of so many rows one is compared: the command's interpreter takes its time.
const EVERY: usize = 9;

/// True for the drawing of a mechanism that has no function with a picture.
pub(crate) fn is_derived(mechanism: &Mechanism, function: &str) -> bool {
    let headings = mechanism.headings();
    let is_drawn = headings.iter().any(|heading| heading.picture.is_some());
    !is_drawn && function == "picture" && mechanism.function(function).is_err()
}

/// Compares all tables, where arguments beside the input are as they were or, by name, others; how many positions have no values.
pub(crate) fn compare(live: &mut Live, assembly: &Assembly, given: &[(&str, f64)]) -> usize {
    let functions = live.page.words("Array.from(document.querySelectorAll('button[data-file$=\".csv\"]'), (own) => own.dataset.file.slice(0, -4)).join()");
    let mut gaps = 0;
    for name in functions.split(',') {
        let unit = &live.mechanism.compiled();
        if is_derived(live.mechanism, name) {
            continue;
        }
        let function = unit
            .functions
            .iter()
            .position(|own| own.name == name)
            .expect("it is one of them");
        let places = unit.functions[function].arguments.clone();
        let value = |place: usize| {
            let input = &unit.inputs[place];
            let other = given.iter().find(|(name, _)| *name == input.name);
            other.map_or(input.reference, |(_, x)| *x)
        };
        let references: Vec<f64> = places.iter().map(|&place| value(place)).collect();
        let text = live.csv(name);
        let rows = text
            .lines()
            .skip(1)
            .map(|line| line.split(',').map(|word| word.parse::<f64>().ok()));
        let rows: Vec<Vec<Option<f64>>> = rows.step_by(EVERY).map(Iterator::collect).collect();
        let at = |x: f64| {
            let pairs = places.iter().zip(&references);
            let arguments: Vec<f64> = pairs
                .map(|(&place, &reference)| if place == 0 { x } else { reference })
                .collect();
            assembly.call(function, &arguments)
        };
        let expected: Vec<Vec<f64>> = rows
            .iter()
            .map(|row| at(row[0].expect("a position")))
            .collect();
        for column in 0..expected[0].len() {
            let sizes = expected
                .iter()
                .map(|row| row[column].abs())
                .filter(|x| x.is_finite());
            let size = sizes.fold(live.mechanism.compiled().longest * 1e-3, f64::max);
            for (row, rust) in rows.iter().zip(&expected) {
                let what = format!(
                    "{}, {name}, column {column} at {:?}",
                    live.mechanism.name(),
                    row[0]
                );
                match row[column + 1] {
                    None => {
                        assert!(
                            !rust[column].is_finite(),
                            "{what}: there is {}",
                            rust[column]
                        );
                        gaps += 1;
                    }
                    Some(js) => {
                        let step = 1e-9 * row[0].unwrap_or(1.0).abs();
                        let growth =
                            (at(row[0].unwrap_or(0.0) + step)[column] - rust[column]).abs() / 1e-9;
                        let near =
                            (js - rust[column]).abs() <= ROUNDOFFS * f64::EPSILON * (size + growth);
                        assert!(
                            near,
                            "{what}: {js:e} on the page, {:e} in Rust",
                            rust[column]
                        );
                    }
                }
            }
        }
    }
    gaps
}

/// The page of a mechanism as a text.
pub(crate) fn html(name: &str) -> String {
    fs::read_to_string(folder(name, "live").join("index.html")).expect("it was written")
}

/// Another file beside a page.
pub(crate) fn beside(name: &str, kind: &str, file: &str, text: &str) -> PathBuf {
    let path = folder(name, kind).join(file);
    fs::write(&path, text).expect("a file");
    path
}

fn folder(name: &str, kind: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{kind}_{name}"))
}
