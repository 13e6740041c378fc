//! The tutorial says what the command prints, and its mechanisms are those of the example that draws its pictures.

use std::fs;
use std::path::Path;
use std::process::Command;

const PAGE: &str = include_str!("../../docs/tutorial.md");
const EXAMPLE: &str = include_str!("../../mechanisms/tutorial.rs");

/// A text without its breaks and spaces: the page breaks long lines.
fn unbroken(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What a declaration is called: `psi` of `unknown psi = 80deg;`.
fn declared(line: &str) -> Option<&str> {
    let mut words = line.split([' ', ';']).filter(|word| !word.is_empty());
    let item = words.next()?;
    let items = ["param", "input", "unknown", "let"];
    if items.contains(&item) {
        words.next()
    } else {
        None
    }
}

/// A mechanism with some declarations replaced by others of the same name.
fn changed(base: &str, changes: &str) -> String {
    let mut lines: Vec<&str> = base.lines().collect();
    for change in changes.lines() {
        let place = lines
            .iter()
            .position(|line| declared(line) == declared(change));
        let place = place.unwrap_or_else(|| panic!("nothing to replace by `{change}`"));
        lines[place] = change;
    }
    // Indented as what it replaces.
    let indented = lines.iter().map(|line| match declared(line) {
        Some(_) => format!("    {}\n", line.trim_start()),
        None => format!("{line}\n"),
    });
    indented.collect()
}

/// Writes a block that begins with its file's name, as `// sign.mech`, or `// sign.mech is four_bar.mech with`.
fn write(folder: &Path, block: &str) {
    let (head, rest) = block.split_once('\n').expect("a head");
    let words: Vec<&str> = head.split(' ').collect();
    match words[..] {
        ["//", name] => {
            let (declaration, _) = rest.rsplit_once("impl").expect("functions");
            assert!(
                unbroken(EXAMPLE).contains(&unbroken(declaration)),
                "the example has another {name}"
            );
            fs::write(folder.join(name), block)
        }
        ["//", name, "is", base, "with"] => {
            let base = fs::read_to_string(folder.join(base)).expect("an earlier file");
            fs::write(folder.join(name), changed(&base, rest))
        }
        _ => panic!("`{head}` names no file"),
    }
    .expect("it can be written");
}

/// What a command prints.
fn printed(folder: &Path, line: &str) -> String {
    let words = line
        .strip_prefix("$ linkage ")
        .expect("a command")
        .split(' ');
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    let output = command
        .args(words)
        .current_dir(folder)
        .output()
        .expect("it runs");
    String::from_utf8([output.stdout, output.stderr].concat()).expect("text")
}

#[test]
fn the_tutorial_shows_what_is_printed() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("tutorial");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    let mut count = 0;
    // Every other part is a block, the first line its language.
    for block in PAGE.split("```").skip(1).step_by(2) {
        let (language, block) = block.split_once('\n').expect("a language");
        match language {
            "text" => write(&folder, block),
            "console" => {
                let (line, expected) = block
                    .split_once('\n')
                    .expect("a command and what it prints");
                assert_eq!(
                    unbroken(&printed(&folder, line)),
                    unbroken(expected),
                    "{line}"
                );
                count += 1;
            }
            "rust" => {}
            _ => panic!("blocks in `{language}` are not tested"),
        }
    }
    assert_eq!(count, 14);
}
