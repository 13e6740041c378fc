//! Texts that are broken at every byte, as while they are being written.

use std::path::Path;
use std::time::{Duration, Instant};

use serde_json::json;

use crate::client::{Client, URI};
use crate::template;

/// Templates of all kinds: loops, links, courses, forces, several inputs.
const TEXTS: [&str; 10] = [
    "slider",
    "joints",
    "cam",
    "boom",
    "scissors",
    "geneva",
    "leg",
    "suspension",
    "steering",
    "toggle-press",
];

/// Removes a character, asks everything that an editor asks after a key, and writes it again. Returns
/// the times of the answers.
fn broken_at(client: &mut Client, text: &str, byte: usize) -> Vec<Duration> {
    let line = text[..byte].matches('\n').count();
    let start = text[..byte].rfind('\n').map_or(0, |start| start + 1);
    let [from, removed] = [
        byte - start,
        text[byte..].chars().next().map_or(0, char::len_utf8),
    ];
    let end = match &text[byte..byte + removed] {
        "\n" => [line + 1, 0],
        _ => [line, from + removed],
    };
    let mut times = Vec::new();
    let mut timed = |client: &mut Client, work: &mut dyn FnMut(&mut Client)| {
        let begin = Instant::now();
        work(client);
        times.push(begin.elapsed());
    };
    timed(client, &mut |client| {
        client.change([[line, from], end], "");
        client.first_messages();
    });
    for method in ["hover", "completion", "signatureHelp", "definition"] {
        timed(client, &mut |client| {
            client.ask_at(&format!("textDocument/{method}"), line, from);
        });
    }
    timed(client, &mut |client| {
        client.ask_of_text("textDocument/semanticTokens/full");
    });
    let place = json!({ "line": line, "character": from });
    timed(client, &mut |client| {
        let range = json!({ "start": place, "end": place });
        client.ask(
            "textDocument/codeAction",
            json!({ "textDocument": { "uri": URI }, "range": range, "context": { "diagnostics": [] } }),
        );
    });
    timed(client, &mut |client| {
        let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 999, "character": 0 } });
        client.ask(
            "textDocument/inlayHint",
            json!({ "textDocument": { "uri": URI }, "range": range }),
        );
    });
    client.change([[line, from], [line, from]], &text[byte..byte + removed]);
    client.first_messages();
    times
}

/// Breaks texts at every `step`th character. Returns all times.
fn broken(texts: &[&str], step: usize) -> Vec<Duration> {
    let mut times = Vec::new();
    for (number, name) in texts.iter().enumerate() {
        let text = template(name);
        let (mut client, _) = Client::start(&["utf-8"]);
        assert_eq!(client.open("linkage", &text), json!([]), "{name}");
        let characters = text.char_indices().skip(number % step).step_by(step);
        for (byte, _) in characters {
            times.extend(broken_at(&mut client, &text, byte));
        }
        // The text is whole again. A word that changes and changes back is solved once more.
        client.change([[0, 0], [0, 0]], "x");
        client.change([[0, 0], [0, 1]], "");
        assert_eq!(client.messages(), json!([]), "{name}");
        client.stop();
    }
    times.sort_unstable();
    times
}

#[test]
fn the_server_answers_while_texts_are_broken() {
    let times = broken(&TEXTS, 797);
    assert!(times.len() > 150, "{} answers", times.len());
}

/// The text between the braces of `mechanism! { }` in a file of the largest examples.
fn example(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../mechanisms");
    let text = std::fs::read_to_string(folder.join(format!("{name}.rs"))).expect("an example");
    let (_, text) = text.split_once("mechanism! {").expect("a call");
    let (text, _) = text.rsplit_once('}').expect("its end");
    text.to_owned()
}

/// Changes a digit of every number but those of comments, one after the other, which leaves most
/// texts to be solved. Returns the times until the first messages, in order.
fn changed_numbers(text: &str) -> Vec<Duration> {
    let (mut client, _) = Client::start(&["utf-8"]);
    assert_eq!(client.open("linkage", text), json!([]));
    let mut times = Vec::new();
    for (line, written) in text.lines().enumerate() {
        let code = written.split("//").next().unwrap_or_default();
        let Some(column) = code.find(|c: char| c.is_ascii_digit()) else {
            continue;
        };
        let digit = &code[column..=column];
        for digit in [if digit == "2" { "3" } else { "2" }, digit] {
            let begin = Instant::now();
            client.change([[line, column], [line, column + 1]], digit);
            client.first_messages();
            times.push(begin.elapsed());
        }
    }
    client.stop();
    times.sort_unstable();
    times
}

/// Messages do not wait for the solver, which takes hundreds of milliseconds for these.
#[test]
#[ignore = "the largest examples, with optimisation"]
fn messages_of_the_largest_examples_come_within_50_milliseconds() {
    for name in ["five_link_axle", "knitting_machine"] {
        let times = changed_numbers(&example(name));
        let [median, last] = [times[times.len() / 2], times[times.len() - 1]];
        println!(
            "{name}: {} keys, median {median:?}, last {last:?}",
            times.len()
        );
        // Other programs of the machine may hold a few answers up.
        let late = times.iter().filter(|time| time.as_millis() > 50).count();
        assert!(
            late * 50 <= times.len(),
            "{name}: {late} of {}",
            times.len()
        );
    }
}

/// `cargo test --release -p linkage-cli --test lsp -- --ignored --nocapture` takes minutes.
#[test]
#[ignore = "every byte of ten mechanisms, with optimisation"]
fn answers_come_within_50_milliseconds() {
    let times = broken(&TEXTS, 1);
    let [median, last] = [times[times.len() / 2], times[times.len() - 1]];
    let late = times.iter().filter(|time| time.as_millis() > 50).count();
    println!(
        "{} answers, median {median:?}, {late} over 50 ms, last {last:?}",
        times.len()
    );
    // Other programs of the machine may hold a few answers up.
    assert!(late * 1000 <= times.len(), "{late} of {}", times.len());
}
