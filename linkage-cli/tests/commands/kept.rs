//! Mechanisms and open files are never replaced, and nothing is left of runs that ended early.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use crate::{folder, linkage, printed, refused, slider};

/// Names of all files.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let names = entries.map(|entry| entry.expect("an entry").file_name());
    let mut names: Vec<String> = names
        .map(|name| name.to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// A folder with the slider-crank, and other files that hold mechanisms.
fn mechanisms(name: &str) -> std::path::PathBuf {
    let folder = folder(name);
    printed(&folder, &["new", "own.mech"]);
    let text = fs::read_to_string(folder.join("own.mech")).expect("the mechanism");
    let other = |name: &str, text: &str| fs::write(folder.join(name), text).expect("written");
    other("input.txt", &text);
    other("other.txt", &text);
    // With a mistake, as while it is being written.
    other("broken.txt", &text.replace("loop pin", "loop pni"));
    other("own.rs", &format!("linkage::mechanism! {{ {text} }}"));
    fs::create_dir(folder.join("inner")).expect("a folder");
    fs::hard_link(folder.join("input.txt"), folder.join("hard")).expect("a link");
    folder
}

#[test]
fn mechanisms_are_not_replaced() {
    let folder = mechanisms("kept");
    #[cfg(unix)]
    std::os::unix::fs::symlink("other.txt", folder.join("link")).expect("a link");
    let before = names(&folder);
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect("a file");
    let texts: Vec<_> = before
        .iter()
        .filter(|name| *name != "inner")
        .map(|name| read(name))
        .collect();
    let mut outputs = vec![
        (
            "input.txt",
            "it is the file with the mechanism that is read",
        ),
        (
            "inner/../input.txt",
            "it is the file with the mechanism that is read",
        ),
        ("hard", "it is the file with the mechanism that is read"),
        ("own.mech", "its ending is that of files with mechanisms"),
        ("new.mech", "its ending is that of files with mechanisms"),
        ("other.txt", "there is a mechanism in it"),
        ("broken.txt", "there is a mechanism in it"),
        ("own.rs", "there is a mechanism in it"),
    ];
    if cfg!(unix) {
        outputs.push(("link", "there is a mechanism in it"));
    }
    for (output, why) in outputs {
        for more in [&[][..], &["--json"]] {
            let table = ["table", "input.txt", "stroke", "--steps", "2", "-o", output];
            let said = refused(&folder, &[&table[..], more].concat(), 1);
            let expected = format!(
                "error: cannot write `{output}`: {why}\nhelp: give another name after `-o`\n"
            );
            assert_eq!(said, expected);
        }
    }
    for command in ["page", "c", "js"] {
        let said = refused(&folder, &[command, "input.txt", "-o", "new.mech"], 1);
        assert!(
            said.contains("its ending is that of files with mechanisms"),
            "{said}"
        );
    }
    assert_eq!(names(&folder), before);
    let after: Vec<_> = before
        .iter()
        .filter(|name| *name != "inner")
        .map(|name| read(name))
        .collect();
    assert_eq!(after, texts);
}

#[test]
fn exported_code_does_not_replace_a_mechanism() {
    let folder = mechanisms("kept_by_exports");
    let text = fs::read_to_string(folder.join("own.mech")).expect("the mechanism");
    for (command, name) in [
        ("c", "slider_crank.c"),
        ("js", "SliderCrank.js"),
        ("page", "data.json"),
    ] {
        fs::write(folder.join(name), &text).expect("written");
        let output = linkage(&folder, &[command, name]);
        let said = String::from_utf8_lossy(&output.stderr);
        if command == "page" {
            let output = linkage(&folder, &["page", name, "-o", "."]);
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(
                said.starts_with("error: cannot write `data.json`: it is the file"),
                "{said}"
            );
        } else {
            assert!(said.contains(&format!("{name}`: it is the file")), "{said}");
        }
        assert_eq!(fs::read_to_string(folder.join(name)).expect("a file"), text);
    }
    // Output of an earlier run is no mechanism.
    for command in ["c", "js", "page"] {
        let again = [command, "own.mech", "-o", "out"];
        assert_eq!(printed(&folder, &again), printed(&folder, &again));
    }
}

/// Runs a script in which `$0` is the program.
#[cfg(unix)]
fn shell(folder: &Path, script: &str) {
    let mut shell = Command::new("sh");
    shell
        .current_dir(folder)
        .args(["-ec", script, env!("CARGO_BIN_EXE_linkage")]);
    let output = shell.output().expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{script}: {said}");
}

#[test]
#[cfg(unix)]
fn open_files_are_written_to() {
    let folder = slider("open");
    let table = ["table", "own.mech", "stroke", "--steps", "2"];
    let expected = printed(&folder, &table);
    let command = "\"$0\" table own.mech stroke --steps 2 -o";
    for (script, before) in [
        (format!("{command} /dev/stdout >> out"), "before\n"),
        (format!("{command} /dev/stdout > out"), ""),
        (format!("{command} /dev/fd/1 >> out"), "before\n"),
        (format!("{command} /dev/fd/3 3>> out"), "before\n"),
        (
            format!("ln -s /dev/stdout link; {command} link >> out"),
            "before\n",
        ),
        (format!("{command} /dev/stdout | cat >> out"), "before\n"),
    ] {
        let out = folder.join("out");
        fs::write(&out, "before\n").expect("written");
        // A second name says whether it is still the same file.
        fs::hard_link(&out, folder.join("same")).expect("a link");
        shell(&folder, &script);
        let text = fs::read_to_string(folder.join("same")).expect("the file");
        assert_eq!(text, format!("{before}{expected}"), "{script}");
        fs::remove_file(folder.join("same")).expect("removed");
    }
    // A pipe with a name.
    shell(
        &folder,
        &format!("mkfifo pipe; cat pipe > out & {command} pipe; wait; test -p pipe"),
    );
    assert_eq!(
        fs::read_to_string(folder.join("out")).expect("the file"),
        expected
    );
}

#[test]
#[cfg(unix)]
fn the_mode_of_a_replaced_file_stays() {
    use std::os::unix::fs::PermissionsExt;
    let folder = slider("mode");
    for mode in [0o600, 0o666, 0o755] {
        let path = folder.join("t.csv");
        fs::write(&path, "").expect("written");
        fs::set_permissions(&path, fs::Permissions::from_mode(mode)).expect("it is ours");
        printed(
            &folder,
            &["table", "own.mech", "stroke", "--steps", "2", "-o", "t.csv"],
        );
        let data = fs::metadata(&path).expect("the file");
        assert_eq!(data.permissions().mode() & 0o777, mode);
        assert!(data.len() > 0);
    }
}

/// A run that is killed at the end of the test, whatever its result.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        self.0.kill().expect("it runs still");
        self.0.wait().expect("it ends");
    }
}

#[test]
fn what_a_killed_run_left_is_removed() {
    let folder = slider("killed");
    let run = |output: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
        command
            .current_dir(&folder)
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        let steps = ["--steps", "4000000000", "-o", output];
        command.args(["table", "own.mech", "stroke"]).args(steps);
        Running(command.spawn().expect("it runs"))
    };
    // The name of the file that a process writes, when it is there.
    let written_by = |running: &Running| {
        let start = format!(".linkage-{}-", running.0.id());
        for _ in 0..1000 {
            let names = names(&folder);
            if let Some(name) = names.iter().find(|name| name.starts_with(&start)) {
                return name.clone();
            }
            sleep(Duration::from_millis(10));
        }
        panic!("{:?}", names(&folder));
    };
    // Names of files that are not ours, however like ours they look.
    let foreign = [".own.csv.1.part", ".linkage-1-0123.part"];
    for name in foreign {
        fs::write(folder.join(name), "").expect("written");
    }
    let short = ["table", "own.mech", "stroke", "--steps", "2", "-o", "t.csv"];
    let with = |more: &[&str]| {
        let all = [&foreign[..], &["own.mech"], more].concat();
        let mut all: Vec<String> = all.into_iter().map(str::to_owned).collect();
        all.sort();
        all
    };
    let killed = run("killed.csv");
    let left = written_by(&killed);
    drop(killed);
    assert_eq!(names(&folder), with(&[&left]));
    // The next run takes it away, and leaves what another one is writing.
    let writing = run("writing.csv");
    let open = written_by(&writing);
    assert_eq!(names(&folder), with(&[&open]));
    printed(&folder, &short);
    assert_eq!(names(&folder), with(&[&open, "t.csv"]));
    drop(writing);
    printed(&folder, &short);
    assert_eq!(names(&folder), with(&["t.csv"]));
}

#[test]
#[cfg(unix)]
fn a_planted_link_is_not_followed() {
    let folder = slider("planted");
    fs::write(folder.join("victim"), "mine").expect("written");
    // The name that a process of this number took for its file.
    let script =
        "ln -s victim .t.csv.$$.part; exec \"$0\" table own.mech stroke --steps 2 -o t.csv";
    shell(&folder, script);
    assert_eq!(
        fs::read_to_string(folder.join("victim")).expect("the file"),
        "mine"
    );
}
