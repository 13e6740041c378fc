//! Answers of the module in node.

use std::io::Write;
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::built::built;

/// An answer of the module, and the time that it took in milliseconds.
pub(crate) struct Answered {
    pub(crate) answer: String,
    pub(crate) milliseconds: f64,
}

/// Returns the answers to requests, one after the other in one module.
pub(crate) fn answers(requests: &[Value]) -> Option<Vec<Answered>> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/web/answers.mjs");
    let mut node = Command::new("node")
        .arg(script)
        .arg(&built()?.module)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("node has built it");
    let lines: String = requests
        .iter()
        .map(|request| format!("{request}\n"))
        .collect();
    let mut input = node.stdin.take().expect("a pipe");
    let writing = std::thread::spawn(move || input.write_all(lines.as_bytes()));
    let output = node.wait_with_output().expect("node ends");
    writing
        .join()
        .expect("no panic")
        .expect("node reads all requests");
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).expect("text");
    let all = text.lines().map(|line| {
        let value: Value = serde_json::from_str(line).expect("JSON");
        Answered {
            answer: value["answer"].as_str().expect("a text").to_owned(),
            milliseconds: value["milliseconds"].as_f64().expect("a number"),
        }
    });
    Some(all.collect())
}
