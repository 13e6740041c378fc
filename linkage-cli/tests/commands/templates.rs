//! Mechanisms to start from.

use std::fs;

use crate::{folder, linkage, printed, refused};

/// The names of all templates with their descriptions, as they are listed.
fn templates(list: &str) -> Vec<(&str, &str)> {
    let lines = list.lines().map(|line| line.split_once("  "));
    let templates = lines.map(|parts| parts.expect("a name and a description"));
    templates
        .map(|(name, about)| (name, about.trim()))
        .collect()
}

#[test]
fn each_template_is_a_mechanism_with_a_page() {
    let folder = folder("templates");
    let list = printed(&folder, &["new", "--list"]);
    let templates = templates(&list);
    assert_eq!(templates.len(), 16, "{list}");
    for (name, about) in templates {
        let file = format!("{name}.mech");
        let said = printed(&folder, &["new", &file, "--from", name]);
        assert!(
            said.starts_with(&format!("{about} is in `{file}`")),
            "{said}"
        );

        // Comments say what each item is, and every function has its docs.
        let text = fs::read_to_string(folder.join(&file)).expect("the mechanism");
        assert!(text.starts_with("// "), "{name}");
        let functions = text.matches("    pub fn ").count();
        assert!(functions >= 3, "{name}: {functions} functions");
        assert!(text.matches("    /// ").count() >= functions, "{name}");
        assert!(text.lines().all(|line| line.len() <= 120), "{name}");

        // No warning, and no assembly but at the reference.
        let known = printed(&folder, &["check", &file]);
        assert!(known.contains("assemblies at the reference: "), "{known}");

        let output = linkage(&folder, &["page", &file]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{name}: {said}");
        // Only functions of a speed wait for it.
        for note in said.lines() {
            assert!(note.contains("it takes `omega`, too"), "{name}: {note}");
        }
        let page = folder.join(format!("{name}_page"));
        let drawing = fs::read_to_string(page.join("drawing.svg")).expect("a drawing");
        assert!(drawing.contains("class=\"link\""), "{name}");
        assert!(
            !drawing.contains("No link of the picture carries"),
            "{name}"
        );
        let data = fs::read_to_string(page.join("data.json")).expect("data");
        let data: serde_json::Value = serde_json::from_str(&data).expect("JSON");
        assert_eq!(
            data["gaps"],
            serde_json::json!([]),
            "{name}: it runs through its range"
        );
    }
}

/// The templates on one page, to be looked at.
#[test]
fn templates_have_a_gallery() {
    let folder = folder("templates_together");
    let list = printed(&folder, &["new", "--list"]);
    let text = |(name, _): &(&str, &str)| {
        let file = format!("{name}.mech");
        printed(&folder, &["new", &file, "--from", name]);
        fs::read_to_string(folder.join(file)).expect("the mechanism")
    };
    let templates = templates(&list);
    let all: String = templates.iter().map(text).collect();
    fs::write(folder.join("templates.mech"), all).expect("it can be written");
    let gallery = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/templates");
    let output = linkage(&folder, &["page", "templates.mech", "-o", gallery]);
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let index = fs::read_to_string(format!("{gallery}/index.html")).expect("a page");
    assert_eq!(index.matches("drawing.svg").count(), templates.len());
}

#[test]
fn a_file_is_never_replaced_and_templates_are_listed() {
    let folder = folder("templates_refused");
    fs::write(folder.join("own.mech"), "mine").expect("it can be written");
    for arguments in [
        &["new", "own.mech"][..],
        &["new", "own.mech", "--from", "wiper"],
    ] {
        let said = refused(&folder, arguments, 1);
        assert_eq!(
            said,
            "error: cannot write `own.mech`: it exists, and no file is replaced\nhelp: give another name, or remove the file\n"
        );
    }
    assert_eq!(
        fs::read_to_string(folder.join("own.mech")).ok().as_deref(),
        Some("mine")
    );
    let said = refused(&folder, &["new", "other.mech", "--from", "wipr"], 1);
    let list = printed(&folder, &["new", "--list"]);
    assert_eq!(
        said,
        format!("error: there is no template `wipr`; there is\n{list}")
    );
    assert!(!folder.join("other.mech").exists());
    refused(&folder, &["new"], 2);
    // A list is not a file.
    let said = refused(&folder, &["new", "other.mech", "--list"], 2);
    assert!(said.contains("cannot be used with '--list'"), "{said}");
    assert!(!folder.join("other.mech").exists());
}

#[test]
fn names_of_new_files_get_their_ending() {
    let folder = folder("templates_named");
    let said = printed(&folder, &["new", "q", "--from", "clamp"]);
    assert!(said.contains(" is in `q.mech`: change it"), "{said}");
    assert!(folder.join("q.mech").exists() && !folder.join("q").exists());
    printed(&folder, &["new", "notes.txt"]);
    assert!(folder.join("notes.txt").exists());
    for (name, expected) in [
        (
            "q",
            "`q.mech`: it exists, and no file is replaced\nhelp: give another name, or remove the file\n",
        ),
        (
            "no/q",
            "`no/q.mech`: there is no folder `no`\nhelp: make the folder first, or give another name\n",
        ),
        (
            "q.rs",
            "`q.rs`: a mechanism without Rust code does not belong in a Rust file\nhelp: write `linkage new q.mech`\n",
        ),
    ] {
        let said = refused(&folder, &["new", name], 1);
        assert_eq!(said, format!("error: cannot write {expected}"));
    }
}

#[test]
fn forces_of_templates_do_the_work_of_their_motion() {
    let folder = folder("templates_forces");
    printed(&folder, &["new", "press.mech", "--from", "toggle-press"]);
    let column = |function: &str, column: usize| -> Vec<f64> {
        let options = ["--steps", "9"];
        let table = printed(
            &folder,
            &[&["table", "press.mech", function], &options[..]].concat(),
        );
        let cell = |line: &str| {
            line.split(',')
                .nth(column)
                .and_then(|cell| cell.parse().ok())
        };
        table.lines().skip(1).filter_map(cell).collect()
    };
    // The torque of the crank is the force of the work times the velocity of the ram, against it.
    let pairs = column("forces", 1).into_iter().zip(column("stroke", 2));
    for (torque, velocity) in pairs {
        assert!(
            (torque + 20_000.0 * velocity).abs() < 1e-6 * torque.abs().max(1.0),
            "{torque} {velocity}"
        );
    }
}
