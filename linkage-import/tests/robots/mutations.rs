//! Ten thousand mutated files of each format: a text or a message, never a panic, in
//! bounded memory.

use std::panic::{self, AssertUnwindSafe};

use linkage_import::{Options, import};
use linkage_random::Random;

use crate::memory::{MOST_KILOBYTES, peak};
use crate::{file, hard_points};

const MUTATIONS: usize = 10_000;

/// Pieces that formats and numbers have.
const PIECES: [&str; 20] = [
    "0",
    "-",
    "1e308",
    "1e-308",
    ".",
    ",",
    ";",
    "\"",
    "<",
    "/>",
    "&#0;",
    "[",
    "]",
    "{",
    ": ",
    "world",
    "type=\"slide\"",
    "99999999999999999999",
    "ö",
    "\n",
];

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
                // Another number.
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

fn survives(names: &[&str], options: &Options) {
    let contents: Vec<Vec<u8>> = names.iter().map(|name| file(name)).collect();
    let mut random = Random::new(names[0].len() as u64);
    let mut read = 0;
    let before = peak();
    for index in 0..MUTATIONS {
        let number = index % contents.len();
        let content = mutated(&contents[number], &mut random);
        let run = || import(&content, names[number], options);
        let result = panic::catch_unwind(AssertUnwindSafe(run));
        let text = String::from_utf8_lossy(&content);
        match result.unwrap_or_else(|_| panic!("a panic for {text}")) {
            Ok(imported) => {
                read += 1;
                assert!(imported.text.ends_with("}\n"), "{text}");
                assert!(
                    !imported.text.contains("NaN") && !imported.text.contains("inf"),
                    "{text}"
                );
            }
            Err(error) => assert!(!error.to_string().is_empty(), "{text}"),
        }
    }
    // Both happen, or the mutations are too weak or too strong.
    assert!(
        (MUTATIONS / 50..MUTATIONS * 99 / 100).contains(&read),
        "{read} of {}",
        names[0]
    );
    if let (Some(before), Some(after)) = (before, peak()) {
        let grown = after.saturating_sub(before);
        assert!(grown < MOST_KILOBYTES, "{}: {grown} kB more", names[0]);
    }
}

#[test]
fn mutated_mjcf() {
    survives(
        &["four_bar.xml", "press.xml", "crossed.xml"],
        &Options::default(),
    );
}

#[test]
fn mutated_urdf() {
    survives(&["four_bar.urdf", "gripper.urdf"], &Options::default());
}

#[test]
fn mutated_sdf() {
    survives(&["four_bar.sdf"], &Options::default());
}

#[test]
fn mutated_tables_of_points() {
    survives(
        &["double_wishbone.csv"],
        &hard_points("forward,left,up", "left"),
    );
}

#[test]
fn mutated_yaml_of_points() {
    survives(&["strut.yaml"], &hard_points("rear,right,up", "right"));
}
