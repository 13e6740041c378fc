//! Neovim and Emacs with the server, where they are installed: a text with a mistake is opened, a
//! name is described, and the mistake is mended.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::template;

/// The repository's settings of editors.
fn settings() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../editors")
}

/// Runs an editor with a script. Returns both outputs; `None` if it is not installed.
fn run(program: &str, name: &str, arguments: &[&str]) -> Option<String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder");
    let broken = template("slider").replace("polar(rod,", "polar(rodx,");
    std::fs::write(folder.join("broken.mech"), broken).expect("a file");
    let output = Command::new(program)
        .args(arguments)
        .env("FOLDER", &folder)
        .env("HOME", &folder)
        .env("LINKAGE", env!("CARGO_BIN_EXE_linkage"))
        .env("EDITORS", settings())
        .output();
    let Ok(output) = output else {
        println!("{program} is not installed");
        return None;
    };
    let [printed, errors] =
        [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text));
    Some(format!("{printed}\n{errors}"))
}

fn script(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/lsp/real_editors");
    folder.join(name).display().to_string()
}

fn contains_all(printed: &str, wanted: &[&str]) {
    for text in wanted {
        assert!(printed.contains(text), "`{text}` is not in:\n{printed}");
    }
}

#[test]
fn neovim_shows_messages_and_hover() {
    let command = format!("luafile {}", script("neovim.lua"));
    let arguments = [
        "--headless",
        "-u",
        "NONE",
        "-i",
        "NONE",
        "-n",
        "-c",
        &command,
    ];
    let Some(printed) = run("nvim", "neovim", &arguments) else {
        return;
    };
    let wanted = [
        "type: linkage",
        "message: 26:22 unknown name `rodx`",
        "help: did you mean `rod`?",
        "hover: derived quantity `pin`",
        "left: 0",
    ];
    contains_all(&printed, &wanted);
}

#[test]
fn emacs_shows_messages_and_hover() {
    let script = script("eglot.el");
    let Some(printed) = run("emacs", "emacs", &["--batch", "--load", &script]) else {
        return;
    };
    if printed.contains("no eglot") {
        println!("this Emacs has no Eglot");
        return;
    }
    let wanted = [
        "type: linkage-mode",
        "unknown name `rodx`",
        "help: did you mean `rod`?",
        "hover: derived quantity `pin`",
        "left: 0",
    ];
    contains_all(&printed, &wanted);
}
