//! Thousands of mutated files of a format: a text or a message, never a panic, in the memory of a
//! few files.

use std::panic::{self, AssertUnwindSafe};

use linkage_import::{Import, ImportError};
use linkage_random::{Random, is_long};

use crate::memory::{MOST_KILOBYTES, peak};

/// How many mutations, and how many in long runs. All runs have the same ones, so that a shorter run repeats the first of them.
const MUTATIONS: usize = 2_500;
const LONG: usize = 10_000;

/// Pieces that formats and numbers have.
const PIECES: [&str; 27] = [
    "0",
    "-",
    "1e308",
    "1e-308",
    ".",
    ",",
    ";",
    ": ",
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
    "world",
    "type=\"slide\"",
    "=\"true\"",
    "\u{0}",
    "\u{feff}",
    "ö",
    "99999999999999999999",
    "\n",
];

/// Changes some bytes: removed, copied, exchanged for a piece or another number, or cut at the end.
fn mutated(content: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = content.to_vec();
    for _ in 0..=random.below(4) {
        if bytes.is_empty() {
            break;
        }
        let start = random.below(bytes.len());
        let end = (start + 1 + random.below(20)).min(bytes.len());
        match random.below(7) {
            0 => bytes[start] = random.bits() as u8,
            1 => drop(bytes.drain(start..end)),
            2 => {
                let copied = bytes[start..end].to_vec();
                let to = random.below(bytes.len());
                bytes.splice(to..to, copied);
            }
            3 => drop(bytes.splice(start..end, random.pick(&PIECES).bytes())),
            4 | 5 => {
                // Another number, or another id of the same file.
                let digits = bytes[start..].iter().position(u8::is_ascii_digit);
                if let Some(offset) = digits {
                    bytes[start + offset] = b'0' + random.below(10) as u8;
                }
            }
            _ if random.chance(0.1) => bytes.truncate(start),
            _ => {}
        }
    }
    bytes
}

/// Imports mutations of these contents in turn. `read` has the index of the content and its
/// mutation.
pub(crate) fn survive(
    name: &str,
    contents: &[Vec<u8>],
    random: &mut Random,
    mut read: impl FnMut(usize, &[u8]) -> Result<Import, ImportError>,
) {
    let before = peak();
    let count = if is_long() { LONG } else { MUTATIONS };
    let mut accepted = 0;
    for index in 0..count {
        let index = index % contents.len();
        let content = mutated(&contents[index], random);
        let result = panic::catch_unwind(AssertUnwindSafe(|| read(index, &content)));
        let text = String::from_utf8_lossy(&content);
        match result.unwrap_or_else(|_| panic!("a panic for {text}")) {
            Ok(imported) => {
                accepted += 1;
                assert!(imported.text.ends_with("}\n"), "{text}");
            }
            Err(error) => assert!(!error.to_string().is_empty(), "{text}"),
        }
    }
    // Both happen, or the mutations are too weak or too strong.
    assert!(
        (count / 50..count * 99 / 100).contains(&accepted),
        "{accepted} of {name}"
    );
    if let (Some(before), Some(after)) = (before, peak()) {
        let grown = after.saturating_sub(before);
        assert!(grown < MOST_KILOBYTES, "{name}: {grown} kB more");
    }
}
