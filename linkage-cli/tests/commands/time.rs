//! How long it takes.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::{favorit, folder};

/// The processor time that a command takes, in seconds: others use the machine, too. The shell tells it behind what is printed.
fn seconds(folder: &Path, arguments: &[&str]) -> f64 {
    let mut shell = Command::new("sh");
    let program = env!("CARGO_BIN_EXE_linkage");
    shell
        .current_dir(folder)
        .args(["-c", "\"$0\" \"$@\" && times", program]);
    let output = shell.args(arguments).output().expect("it runs");
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).expect("text");
    // `0m0.031s 0m0.004s`, of the children in the last line.
    let last = text.lines().last().expect("times");
    let times = last.split_whitespace().map(|time| {
        let (minutes, seconds) = time.trim_end_matches('s').split_once('m').expect("a time");
        let [minutes, seconds] = [minutes, seconds].map(|x| x.parse::<f64>().expect("a number"));
        60.0 * minutes + seconds
    });
    times.sum()
}

#[test]
fn nobody_waits_for_a_table_or_a_page() {
    let folder = folder("time");
    let table = seconds(&folder, &["table", favorit(), "motion", "-o", "motion.csv"]);
    let page = seconds(&folder, &["page", favorit(), "-o", "page"]);
    println!("table {table} s, page {page} s");
    let text = fs::read_to_string(folder.join("motion.csv")).expect("a table");
    assert_eq!(text.lines().count(), 362);
    // Without optimisation, too.
    assert!(table > 0.0 && table < 0.3, "table {table} s");
    assert!(page > 0.0 && page < 1.0, "page {page} s");
}
