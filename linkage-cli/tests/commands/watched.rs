//! Pages of a file that is edited while they are open.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::{folder, printed};

/// A command that watches a file.
struct Watched {
    folder: PathBuf,
    running: Child,
}

impl Watched {
    fn new(folder: &Path) -> Self {
        let said = File::create(folder.join("said.txt")).expect("a file");
        let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
        let command = command
            .current_dir(folder)
            .args(["page", "own.mech", "--watch"]);
        let running = command.stdout(Stdio::null()).stderr(said).spawn();
        Self {
            folder: folder.to_owned(),
            running: running.expect("it runs"),
        }
    }

    /// A file of the page; empty while there is none.
    fn page(&self, name: &str) -> String {
        fs::read_to_string(self.folder.join("own_page").join(name)).unwrap_or_default()
    }

    fn said(&self) -> String {
        fs::read_to_string(self.folder.join("said.txt")).expect("a file")
    }

    #[track_caller]
    fn wait(&self, what: impl Fn(&Self) -> bool) {
        let start = Instant::now();
        while !what(self) {
            let page = self.page("version.js");
            assert!(
                start.elapsed() < Duration::from_secs(60),
                "{page}{}",
                self.said()
            );
            sleep(Duration::from_millis(20));
        }
    }

    fn write(&self, text: &str) {
        fs::write(self.folder.join("own.mech"), text).expect("it can be written");
    }
}

impl Drop for Watched {
    fn drop(&mut self) {
        self.running.kill().expect("it runs until it is ended");
        self.running.wait().expect("it has ended");
    }
}

fn slider_crank(folder: &Path) -> String {
    printed(folder, &["new", "own.mech"]);
    fs::read_to_string(folder.join("own.mech")).expect("the mechanism")
}

/// The number of a version, without mistakes.
fn is_number(version: &str) -> bool {
    let number = version.strip_prefix("linkageVersion(");
    let number = number.and_then(|rest| rest.strip_suffix(");\n"));
    number.is_some_and(|number| number.parse::<u64>().is_ok())
}

#[test]
fn mistakes_are_on_the_page_until_the_file_is_right() {
    let folder = folder("watched_mistakes");
    let text = slider_crank(&folder);
    let watched = Watched::new(&folder);
    watched.wait(|watched| {
        watched
            .page("index.html")
            .contains("<title>SliderCrank</title>")
    });
    watched.wait(|watched| is_number(&watched.page("version.js")));
    let first = watched.page("version.js");
    watched.write(&text.replace("polar(rod, theta)", "polar(rot, theta)"));
    watched.wait(|watched| watched.page("version.js").contains("did you mean `rod`?"));
    let wrong = watched.page("version.js");
    // The version is that of the page, which stays.
    let version = first.trim_end_matches(");\n");
    assert!(
        wrong.starts_with(&format!("{version}, \"error: unknown name `rot`")),
        "{wrong}"
    );
    assert_eq!(wrong.lines().count(), 1, "{wrong}");
    assert!(watched.said().contains("unknown name `rot`"));
    // The old text is right, as a new version.
    watched.write(&text);
    watched.wait(|watched| is_number(&watched.page("version.js")));
    assert_ne!(watched.page("version.js"), first);
}

#[test]
fn a_file_that_is_being_written_is_no_mistake() {
    let folder = folder("watched_editor");
    let text = slider_crank(&folder);
    let watched = Watched::new(&folder);
    watched.wait(|watched| is_number(&watched.page("version.js")));
    let first = watched.page("version.js");
    // Emptied, half written, then complete.
    let changed = text.replace("crank  = 40mm", "crank  = 41.5mm");
    let (begin, end) = changed.split_at(changed.len() / 2);
    let mut file = File::create(folder.join("own.mech")).expect("a file");
    sleep(Duration::from_millis(350));
    file.write_all(begin.as_bytes()).expect("it can be written");
    sleep(Duration::from_millis(350));
    file.write_all(end.as_bytes()).expect("it can be written");
    watched.wait(|watched| watched.page("data.json").contains("41.5"));
    watched.wait(|watched| watched.page("version.js") != first);
    assert!(is_number(&watched.page("version.js")));
    assert_eq!(watched.said(), "");
}

#[test]
fn a_page_waits_for_a_file_that_is_right() {
    let folder = folder("watched_waiting");
    let text = slider_crank(&folder);
    fs::write(folder.join("own.mech"), &text[..text.len() / 2]).expect("it can be written");
    let watched = Watched::new(&folder);
    watched.wait(|watched| watched.page("version.js").contains("has no partner"));
    assert!(watched.page("index.html").contains("<title>own</title>"));
    // Two mechanisms: their page has no mistakes, and leads to both, which lead back.
    let other = text.replace("SliderCrank", "Other");
    watched.write(&format!("{text}{other}"));
    watched.wait(|watched| is_number(&watched.page("Other/version.js")));
    watched.wait(|watched| is_number(&watched.page("version.js")));
    assert!(
        watched
            .page("index.html")
            .contains("href=\"Other/index.html\"")
    );
    let report = watched.page("Other/index.html");
    assert!(
        report.contains("href=\"../index.html\">&larr; own</a>"),
        "no way back"
    );
    watched.write(&format!(
        "{text}{}",
        other.replace("rod, theta", "rot, theta")
    ));
    for page in ["version.js", "Other/version.js", "SliderCrank/version.js"] {
        watched.wait(|watched| watched.page(page).contains("unknown name `rot`"));
    }
}
