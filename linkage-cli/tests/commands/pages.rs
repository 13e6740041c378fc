//! Pages.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use linkage_engine::Source;

use crate::{favorit, folder, linkage, printed, refused, slider};

#[test]
fn a_page_has_all_functions() {
    let folder = folder("page");
    // The hook-needle drive as a text file.
    let source = Source::read(Path::new(favorit())).expect("the example");
    let tokens: Vec<_> = source.calls()[0].tokens.clone().into_iter().collect();
    let [first, last] = [&tokens[0], &tokens[tokens.len() - 1]].map(|own| own.span().byte_range());
    let text = &source.text()[first.start..last.end];
    fs::write(folder.join("favorit.mech"), text).expect("it can be written");
    printed(&folder, &["page", "favorit.mech"]);
    let page = folder.join("favorit_page");
    let data = fs::read_to_string(page.join("data.json")).expect("data");
    let data: serde_json::Value = serde_json::from_str(&data).expect("JSON");
    assert_eq!(data["title"], "Favorit");
    for name in ["needle", "height", "transmission", "picture", "motion"] {
        let lines = fs::read_to_string(page.join(name).with_extension("csv")).expect("a table");
        assert_eq!(lines.lines().count(), 362, "{name}");
    }
    let html = fs::read_to_string(page.join("index.html")).expect("a page");
    assert!(html.contains("<title>Favorit</title>") && !html.contains("follow("));
    assert!(page.join("drawing.svg").is_file() && !page.join("version.js").exists());
}

#[test]
fn several_mechanisms_have_a_page_that_leads_to_them() {
    let folder = folder("several");
    let machine = concat!(env!("CARGO_MANIFEST_DIR"), "/../mechanisms/machine.rs");
    let output = linkage(&folder, &["page", machine, "-o", "all"]);
    assert!(output.status.success(), "{output:?}");
    let html = fs::read_to_string(folder.join("all/index.html")).expect("a page");
    let links: Vec<&str> = html.split("<a href=\"").skip(1).collect();
    assert_eq!(links.len(), 3);
    for link in links {
        let (target, _) = link.split_once('"').expect("an address");
        assert!(folder.join("all").join(target).is_file(), "{target}");
    }
}

#[test]
fn what_does_not_move_is_left_out_of_pages_and_circuits() {
    let folder = folder("still");
    let gears = concat!(env!("CARGO_MANIFEST_DIR"), "/../mechanisms/gears.rs");
    let output = linkage(&folder, &["page", gears, "-o", "gears"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert_eq!(said, "note: Bracket has no input: nothing of it moves\n");
    assert!(folder.join("gears/index.html").is_file());
    let bracket = ["--mechanism", "Bracket"];
    for (command, expected) in [
        ("page", "error: Bracket has no input: nothing of it moves\n"),
        (
            "circuits",
            "error: Bracket has no circuits: they are for mechanisms with loops and one input\n",
        ),
    ] {
        let said = refused(&folder, &[&[command, gears], &bracket[..]].concat(), 1);
        assert_eq!(said, expected);
    }
}

#[test]
fn a_watched_page_follows_its_file() {
    let folder = slider("watch");
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command
        .current_dir(&folder)
        .args(["page", "own.mech", "--watch"]);
    let mut running = command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("it runs");
    let read = |name: &str| fs::read_to_string(folder.join("own_page").join(name));
    let until = |what: &dyn Fn() -> bool| {
        let start = Instant::now();
        while !what() && start.elapsed() < Duration::from_secs(60) {
            sleep(Duration::from_millis(20));
        }
        what()
    };
    let first = until(&|| read("version.js").is_ok());
    let version = read("version.js").unwrap_or_default();
    // The page knows which version it is, and asks for others.
    let number = version
        .trim()
        .trim_start_matches("linkageVersion")
        .to_owned();
    let own = read("index.html").is_ok_and(|html| html.contains(&format!("follow{number}")));
    let file = folder.join("own.mech");
    let text = fs::read_to_string(&file).expect("the mechanism");
    fs::write(&file, text.replace("crank  = 40mm", "crank  = 41.5mm")).expect("it can be changed");
    let again = until(&|| read("version.js").is_ok_and(|now| now != version));
    let data = read("data.json").unwrap_or_default();
    running.kill().expect("it runs until it is ended");
    running.wait().expect("it has ended");
    assert!(first && own && again, "{first} {own} {again}");
    assert!(data.contains("41.5"), "the new dimension");
}
