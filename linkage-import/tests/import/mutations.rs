//! Mutated drawings of each format.

use std::fs;

use linkage_import::{Format, Options, import};
use linkage_random::Random;

use crate::files::all;
use crate::survival::survive;

/// The largest file that is mutated, in bytes.
const LARGEST: usize = 1500;

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
    let options = Options {
        format: Some(format),
        ..Options::default()
    };
    let mut mended = Random::new(48);
    let mut random = Random::new(47 + format as u64);
    survive(extension, &contents, &mut random, |_, content| {
        let mut content = content.to_vec();
        if format == Format::Pmks && mended.chance(0.7) {
            mend(&mut content);
        }
        import(&content, "a.b", &options)
    });
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
