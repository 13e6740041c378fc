//! Words of messages that several phases share.

use std::borrow::Cow;
use std::fmt::Write;

/// The greatest number of characters that a message repeats of one piece of the user's text.
const MOST_REPEATED: usize = 80;

/// A text as a message repeats it: of more than 80 characters the first 79 and an ellipsis.
#[must_use]
pub fn shortened(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(MOST_REPEATED) {
        None => Cow::Borrowed(text),
        Some(_) => {
            let mut short: String = text.chars().take(MOST_REPEATED - 1).collect();
            short.push('…');
            Cow::Owned(short)
        }
    }
}

/// A message in which every word, name or number is [`shortened`].
#[must_use]
pub fn short_words(message: &str) -> String {
    let ends_word = |c: char| c.is_whitespace() || c == '`';
    let pieces = message.split_inclusive(ends_word);
    let short = |piece: &str| {
        let word = piece.trim_end_matches(ends_word);
        format!("{}{}", shortened(word), &piece[word.len()..])
    };
    pieces.map(short).collect()
}

/// The candidate nearest to a misspelt word, if any is near: at most a third of the letters differ.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = (word.chars().count() / 3).max(1);
    candidates
        .into_iter()
        .map(|candidate| (edit_distance(word, candidate), candidate))
        .filter(|(distance, candidate)| *distance <= limit && *distance < candidate.chars().count())
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// Insertions, deletions, substitutions and swaps of neighbours; letter case costs nothing.
pub(crate) fn edit_distance(left: &str, right: &str) -> usize {
    let left: Vec<char> = left.chars().flat_map(char::to_lowercase).collect();
    let right: Vec<char> = right.chars().flat_map(char::to_lowercase).collect();
    let mut before = vec![0; right.len() + 1];
    let mut row: Vec<usize> = (0..=right.len()).collect();
    for i in 0..left.len() {
        let mut next = vec![i + 1];
        for j in 0..right.len() {
            let substituted = row[j] + usize::from(left[i] != right[j]);
            let mut best = substituted.min(row[j + 1] + 1).min(next[j] + 1);
            if i > 0 && j > 0 && left[i] == right[j - 1] && left[i - 1] == right[j] {
                best = best.min(before[j - 1] + 1);
            }
            next.push(best);
        }
        before = std::mem::replace(&mut row, next);
    }
    row[right.len()]
}

/// `` `a`, `b` and `c` ``
pub fn list(words: &[&str]) -> String {
    let mut text = String::new();
    for (index, word) in words.iter().enumerate() {
        let separator = match index {
            0 => "",
            _ if index + 1 == words.len() => " and ",
            _ => ", ",
        };
        write!(text, "{separator}`{word}`").expect("a String takes everything");
    }
    text
}

/// `1 argument`, `2 arguments`
pub fn count(number: usize, noun: &str) -> String {
    match number {
        0 => format!("no {noun}"),
        1 => format!("1 {noun}"),
        _ => format!("{number} {noun}s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances() {
        for (left, right, distance) in [
            ("", "", 0),
            ("crank", "crank", 0),
            ("crank", "carnk", 1),
            ("crank", "rank", 1),
            ("Crank", "crank", 0),
            ("theta", "psi", 5),
        ] {
            assert_eq!(edit_distance(left, right), distance, "{left} {right}");
        }
    }

    #[test]
    fn long_words_are_cut() {
        let [fits, long] = [80, 81].map(|count| "ä".repeat(count));
        let cut = format!("{}…", "ä".repeat(79));
        assert_eq!(shortened(&fits), fits);
        assert_eq!(shortened(&long), cut);
        let message = format!("`{long}` is  no `{fits}`\nhelp: {long}");
        let expected = format!("`{cut}` is  no `{fits}`\nhelp: {cut}");
        assert_eq!(short_words(&message), expected);
    }

    #[test]
    fn near_words_only() {
        assert_eq!(nearest("cuopler", ["crank", "coupler"]), Some("coupler"));
        assert_eq!(nearest("zzz", ["crank", "coupler"]), None);
        assert_eq!(nearest("b", ["a"]), None);
    }

    #[test]
    fn lists() {
        assert_eq!(list(&["a"]), "`a`");
        assert_eq!(list(&["a", "b", "c"]), "`a`, `b` and `c`");
        assert_eq!(count(1, "argument"), "1 argument");
        assert_eq!(count(2, "argument"), "2 arguments");
    }
}
