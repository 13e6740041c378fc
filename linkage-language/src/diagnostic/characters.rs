//! Characters of formulas and word processors that no mechanism has, and the text for them.

/// A character that is no token, as a message reports it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnreadableCharacter {
    /// The fact.
    pub fact: String,
    /// The advice, if the meaning of the character is known.
    pub help: Option<String>,
    /// The text for it.
    pub replacement: Option<&'static str>,
}

/// Describes the character at a byte of a text if it is no token of any text: one outside of ASCII.
#[must_use]
pub fn unreadable_character(text: &str, byte: usize) -> Option<UnreadableCharacter> {
    let letter = text.get(byte..)?.chars().next()?;
    if letter.is_ascii() {
        return None;
    }
    let replacement = replacement(letter);
    let help = replacement.map(|instead| match number_before(text, byte) {
        Some(number) if instead.starts_with(|first: char| first.is_ascii_alphabetic()) => {
            format!("write `{number}{instead}`")
        }
        _ => format!("write `{instead}`"),
    });
    Some(UnreadableCharacter {
        fact: format!("the character `{letter}` means nothing here"),
        help,
        replacement,
    })
}

fn replacement(letter: char) -> Option<&'static str> {
    Some(match letter {
        '\u{b0}' | '\u{ba}' => "deg",
        // Prime and double prime of angles.
        '\u{2032}' => "arcmin",
        '\u{2033}' => "arcsec",
        '\u{b1}' => "+-",
        // The minus sign, and the dashes that word processors make of it.
        '\u{2212}' | '\u{2010}'..='\u{2014}' => "-",
        // Cross, middle dot, dot operator and bullet.
        '\u{d7}' | '\u{b7}' | '\u{22c5}' | '\u{2022}' => "*",
        '\u{f7}' | '\u{2215}' => "/",
        '\u{b2}' => "^2",
        '\u{b3}' => "^3",
        // Dots of a range.
        '\u{2026}' => "..",
        _ => return None,
    })
}

/// Returns the number that ends before a byte.
fn number_before(text: &str, byte: usize) -> Option<&str> {
    let before = text.get(..byte)?.trim_end();
    let is_digit = |letter: char| letter.is_ascii_digit() || letter == '.' || letter == '_';
    let number = &before[before.trim_end_matches(is_digit).len()..];
    number
        .starts_with(|first: char| first.is_ascii_digit())
        .then_some(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_of_formulas_have_words() {
        for (text, help) in [
            ("input phi = 60\u{b0};", "write `60deg`"),
            ("input phi = 2.5 \u{b0};", "write `2.5deg`"),
            ("param a = 5mm \u{b1} 1mm;", "write `+-`"),
            ("joint a = (\u{2212}5mm, 0);", "write `-`"),
            ("let a = 2\u{d7}b;", "write `*`"),
        ] {
            let byte = text.find(|letter: char| !letter.is_ascii()).expect("one");
            let found = unreadable_character(text, byte).expect("a character");
            assert_eq!(found.help.as_deref(), Some(help), "{text}");
        }
        assert_eq!(
            unreadable_character("a \u{20ac}", 2).and_then(|found| found.help),
            None
        );
        assert_eq!(unreadable_character("a $", 2), None);
    }
}
