//! The page about the command says what the command prints.

use std::fs;
use std::path::Path;
use std::process::Command;

const PAGE: &str = include_str!("../../docs/command.md");

/// The words of a line, quotes holding some together.
fn words(line: &str) -> Vec<String> {
    let parts = line.split('"').enumerate();
    parts
        .flat_map(|(index, part)| match index % 2 {
            0 => part.split_whitespace().map(str::to_owned).collect(),
            _ => vec![part.to_owned()],
        })
        .collect()
}

#[test]
fn the_page_shows_what_is_printed() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("docs");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    let run = |line: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
        let output = command.args(words(line)).current_dir(&folder).output();
        let output = output.expect("it runs");
        let bytes = [output.stdout, output.stderr].concat();
        String::from_utf8(bytes)
            .expect("text")
            .replace("\r\n", "\n")
    };
    run("new slider.mech");
    run("new press.mech --from toggle-press");
    let text = fs::read_to_string(folder.join("slider.mech")).expect("the mechanism");
    let wrong = text.replace("polar(rod, theta)", "polar(rot, theta)");
    fs::write(folder.join("wrong.mech"), wrong).expect("it can be written");
    let blocks = PAGE.split("```console\n").skip(1);
    let mut count = 0;
    for block in blocks {
        let (block, _) = block.split_once("```").expect("a block ends");
        // A long command goes on in the next line, as in a shell.
        let block = block.replace("\\\n    ", "");
        let (line, expected) = block
            .split_once('\n')
            .expect("a command and what it prints");
        let line = line.strip_prefix("$ linkage ").expect("a command");
        assert_eq!(run(line), expected, "linkage {line}");
        count += 1;
    }
    assert!(count >= 8, "{count} commands");
}
