//! Names of files as identifiers of the language, each once.

use std::collections::BTreeSet;

/// The longest identifier that is made of a name.
const LONGEST: usize = 40;

/// Words of the language and of Rust, and functions of expressions.
const TAKEN: &str = "about abs abstract accel acceleration acos alpha and angle as asin async at atan \
    atan2 await become belt block body bool box break cam const continue coordinates_in cos crate \
    cross cylinder deg derivative dir distance do dot dyn else enum extern f32 f64 false final \
    fn for force frame friction gears gravity guide hinge hypot if impl in inertia input jerk \
    joint length let link load loop macro margin mass match max min mod moment motor move mut norm \
    of omega on override part param pi picture piecewise planar point point_in polar priv pub \
    radii radius range reaction ref return rise rotate screw_direction screw_pitch screw_point \
    self sensitivity sin slider slope spline spring sqrt static str struct super tan tau teeth \
    time tolerance torque trait triangle_angle true try turn type typeof u8 unit union unknown \
    unsafe unsized use velocity virtual weld where while with yield";

/// A name of a file in a message: short, and without line breaks.
pub(crate) fn shown(name: &str) -> String {
    let mut text: String = name
        .chars()
        .map(|letter| if letter.is_control() { ' ' } else { letter })
        .take(LONGEST)
        .collect();
    if name.chars().nth(LONGEST).is_some() {
        text.push('…');
    }
    text
}

/// A text of a file inside of a line comment.
pub(crate) fn in_comment(text: &str) -> String {
    let is_harmless = |letter: char| !letter.is_control() && letter != '\u{2028}';
    text.chars()
        .map(|letter| if is_harmless(letter) { letter } else { ' ' })
        .take(400)
        .collect()
}

/// Returns the name of a file without its folder.
pub(crate) fn file(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or_default()
}

/// Returns the name of a file without its folder and its endings.
pub(crate) fn stem(path: &str) -> &str {
    let file = file(path);
    file.split_once('.').map_or(file, |parts| parts.0)
}

/// Identifiers that are in use.
#[derive(Debug)]
pub(crate) struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    pub(crate) fn new() -> Self {
        Self {
            taken: TAKEN.split_whitespace().map(str::to_owned).collect(),
        }
    }

    /// Returns an identifier for a name: lower case letters, digits and underscores. A name that
    /// begins with a digit, or has no letter, gets the prefix in front.
    pub(crate) fn unique(&mut self, name: &str, prefix: &str) -> String {
        let mut word = snake_case(name);
        let begins_well = word.starts_with(|letter: char| letter.is_ascii_lowercase());
        if !begins_well {
            word = format!("{prefix}{word}");
        }
        if word.len() == 1 && self.taken.contains(&word) {
            word = format!("{prefix}_{word}");
        }
        let mut candidate = word.clone();
        let mut number = 2;
        while self.taken.contains(&candidate) {
            candidate = format!("{word}_{number}");
            number += 1;
        }
        self.taken.insert(candidate.clone());
        candidate
    }
}

/// Returns the ASCII letters and digits of a name in lower case, other runs as one underscore.
fn snake_case(name: &str) -> String {
    let mut word = String::new();
    for letter in name.chars().take(LONGEST) {
        if letter.is_ascii_alphanumeric() {
            word.push(letter.to_ascii_lowercase());
        } else if !word.ends_with('_') && !word.is_empty() {
            word.push('_');
        }
    }
    word.trim_end_matches('_').to_owned()
}

/// Returns the name of a type for a mechanism: `quick press 2.linkage2` becomes `QuickPress2`.
pub(crate) fn type_name(name: &str) -> String {
    let words = name.split(|letter: char| !letter.is_ascii_alphanumeric());
    let mut text = String::new();
    for word in words.filter(|word| !word.is_empty()) {
        let mut letters = word.chars();
        if let Some(first) = letters.next() {
            text.push(first.to_ascii_uppercase());
            text.push_str(letters.as_str());
        }
        if text.len() > LONGEST {
            break;
        }
    }
    let begins_well = text.starts_with(|letter: char| letter.is_ascii_uppercase());
    if begins_well && text.len() > 1 && text != "Self" {
        text
    } else {
        format!("Mechanism{text}")
    }
}
