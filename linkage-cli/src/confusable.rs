//! Names that look alike and are different.

use unicode_security::confusable_detection::skeleton;

/// Returns true for names that look alike and are different. Letters of ASCII that look alike, as
/// `l` and `1`, are known to everybody.
pub(crate) fn look_alike(name: &str, other: &str) -> bool {
    name != other && !(name.is_ascii() && other.is_ascii()) && skeleton(name).eq(skeleton(other))
}

/// `U+0430 instead of U+0061`: the letters that one of two names has and the other one has not.
pub(crate) fn letters(name: &str, other: &str) -> String {
    let foreign = |word: &str, other: &str| {
        let mut letters: Vec<String> = Vec::new();
        for letter in word.chars().filter(|letter| !other.contains(*letter)) {
            let letter = format!("U+{:04X}", u32::from(letter));
            if !letters.contains(&letter) {
                letters.push(letter);
            }
        }
        letters.join(" ")
    };
    format!(
        "{} instead of {}",
        foreign(name, other),
        foreign(other, name)
    )
}
