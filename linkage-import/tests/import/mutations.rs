//! Ten thousand mutated files of each format: a text or a message, never a panic, in the memory of
//! a few files.

use std::fs;
use std::panic::{self, AssertUnwindSafe};

use linkage_import::{Format, Options, import};
use linkage_random::Random;

use crate::files::all;
use crate::memory::{MOST_KILOBYTES, peak};

const MUTATIONS: usize = 10_000;
/// The largest file that is mutated, in bytes.
const LARGEST: usize = 1500;

/// Pieces that other formats and numbers have.
const PIECES: [&str; 24] = [
    "0",
    "-",
    "1e308",
    "1e-308",
    ".",
    ",",
    ";",
    "\"",
    "'",
    "<",
    "/>",
    "&#0;",
    "&lt;",
    "[",
    "]",
    "{",
    "}",
    "null",
    "\u{0}",
    "\u{feff}",
    "ö",
    "=\"true\"",
    "99999999999999999999",
    "\n",
];

/// Changes some bytes: removed, copied, exchanged for a piece, or cut at the end.
fn mutated(content: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = content.to_vec();
    for _ in 0..=random.below(4) {
        if bytes.is_empty() {
            break;
        }
        let at = random.below(bytes.len());
        let end = (at + 1 + random.below(20)).min(bytes.len());
        match random.below(6) {
            0 => bytes[at] = random.bits() as u8,
            1 => {
                bytes.drain(at..end);
            }
            2 => {
                let copied = bytes[at..end].to_vec();
                let to = random.below(bytes.len());
                bytes.splice(to..to, copied);
            }
            3 => {
                let piece = random.pick(&PIECES).bytes();
                bytes.splice(at..end, piece);
            }
            4 => {
                // Another number, or another id of the same file.
                let digit = b'0' + random.below(10) as u8;
                bytes[at] = if bytes[at].is_ascii_digit() {
                    digit
                } else {
                    bytes[at]
                };
            }
            _ => bytes.truncate(at),
        }
    }
    bytes
}

fn survives(format: Format, extension: &str) {
    let files = all().into_iter();
    let files = files.filter(|file| file.extension().is_some_and(|other| other == extension));
    let mut contents: Vec<Vec<u8>> = files.map(|file| fs::read(file).expect("a file")).collect();
    if format == Format::Pylinkage {
        contents.push(
            br#"{"name": "a", "joints": [{"id": "O", "type": "ground", "position": [0.0, 0.0]},
            {"id": "A", "type": "revolute", "position": [1.0, 0.25]},
            {"id": "B", "type": "prismatic", "position": [4, 0.5], "axis": [1, 0]}],
            "links": [{"id": "c", "type": "driver", "joints": ["O", "A"], "motor_joint": "O"},
            {"id": "r", "joints": ["A", "B"]}]}"#
                .to_vec(),
        );
    }
    // Large drawings take longer, and have the same items.
    contents.retain(|content| content.len() < LARGEST);
    assert!(!contents.is_empty(), "{extension}");
    let mut random = Random::new(47 + format as u64);
    let options = Options {
        format: Some(format),
        ..Options::default()
    };
    let before = peak();
    let mut read = 0;
    for index in 0..MUTATIONS {
        let mut content = mutated(&contents[index % contents.len()], &mut random);
        if format == Format::Pmks && random.chance(0.7) {
            mend(&mut content);
        }
        let result = panic::catch_unwind(AssertUnwindSafe(|| import(&content, "a.b", &options)));
        let text = String::from_utf8_lossy(&content);
        match result.unwrap_or_else(|_| panic!("a panic for {text}")) {
            Ok(imported) => {
                read += 1;
                assert!(imported.text.ends_with("}\n"), "{text}");
            }
            Err(error) => assert!(!error.to_string().is_empty(), "{text}"),
        }
    }
    // Both happen, or the mutations are too weak or too strong.
    assert!(
        (MUTATIONS / 50..MUTATIONS * 99 / 100).contains(&read),
        "{read} of {extension}"
    );
    if let (Some(before), Some(after)) = (before, peak()) {
        let grown = after.saturating_sub(before);
        assert!(grown < MOST_KILOBYTES, "{extension}: {grown} kB more");
    }
}

/// Writes the check of an address again, so that its records are read.
fn mend(content: &mut Vec<u8>) {
    const DIGITS: &[u8] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    let text = String::from_utf8_lossy(content).into_owned();
    if let Some((page, query)) = text.trim_end().split_once('?')
        && let Some((last, _)) = query.char_indices().next_back()
    {
        let length = query[..last].encode_utf16().count();
        let check = char::from(DIGITS[length % DIGITS.len()]);
        *content = format!("{page}?{}{check}", &query[..last]).into_bytes();
    }
}

#[test]
fn mutated_files_of_linkage() {
    survives(Format::Linkage, "linkage2");
}

#[test]
fn mutated_addresses() {
    survives(Format::Pmks, "pmks");
}

#[test]
fn mutated_expressions() {
    survives(Format::Pyslvs, "pyslvs");
}

#[test]
fn mutated_files_of_pylinkage() {
    survives(Format::Pylinkage, "json");
}

#[test]
fn mutated_tables() {
    survives(Format::JointTable, "csv");
}
