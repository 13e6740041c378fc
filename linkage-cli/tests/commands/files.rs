//! Files are written whole or not at all.

use std::fs;
use std::process::Command;

use crate::{printed, slider};

#[test]
fn a_file_is_replaced_as_a_whole() {
    let folder = slider("whole");
    let into = |steps| {
        printed(
            &folder,
            &[
                "table", "own.mech", "stroke", "--steps", steps, "-o", "t.csv",
            ],
        )
    };
    assert_eq!(into("3") + &into("2"), "");
    let text = fs::read_to_string(folder.join("t.csv")).expect("a file");
    assert_eq!(text.lines().count(), 3);
    assert_eq!(
        fs::read_dir(&folder).expect("the folder is there").count(),
        2
    );
}

/// What cannot be written whole, here because files must not be longer than a few lines, leaves the old file.
#[test]
#[cfg(unix)]
fn a_file_that_cannot_be_written_stays_as_it_was() {
    let folder = slider("limit");
    let old = ["table", "own.mech", "stroke", "--steps", "3", "-o", "t.csv"];
    printed(&folder, &old);
    let before = fs::read_to_string(folder.join("t.csv")).expect("a file");
    let mut shell = Command::new("sh");
    shell
        .current_dir(&folder)
        .args(["-c", "trap '' XFSZ; ulimit -f 4; exec \"$0\" \"$@\""]);
    shell.arg(env!("CARGO_BIN_EXE_linkage"));
    let output = shell
        .args(["table", "own.mech", "stroke", "-o", "t.csv"])
        .output();
    let output = output.expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.starts_with("error: cannot write `t.csv`: "), "{said}");
    assert_eq!(
        fs::read_to_string(folder.join("t.csv")).expect("a file"),
        before
    );
    assert_eq!(
        fs::read_dir(&folder).expect("the folder is there").count(),
        2
    );
}

#[test]
#[cfg(unix)]
fn a_device_stays_a_device() {
    use std::os::unix::fs::FileTypeExt;
    let folder = slider("device");
    printed(&folder, &["table", "own.mech", "stroke", "-o", "/dev/null"]);
    let kind = fs::metadata("/dev/null").expect("it is there").file_type();
    assert!(kind.is_char_device());
}
