//! Messages of an earlier text at their places in a later one.

use std::ops::Range;

use crate::diagnostics::{Diagnostic, Edit, Fix, Related};

/// The bytes in which two texts differ.
#[derive(Debug)]
pub(crate) struct Change {
    /// The bytes of the earlier text.
    old: Range<usize>,
    /// The end of those of the later text, which begin at the same byte.
    new_end: usize,
}

impl Change {
    /// Compares two texts from both ends.
    pub(crate) fn between(old: &str, new: &str) -> Self {
        let alike = |mut pairs: std::iter::Zip<std::str::Bytes<'_>, std::str::Bytes<'_>>| {
            let different = pairs.position(|(a, b)| a != b);
            different.unwrap_or(old.len().min(new.len()))
        };
        let mut start = alike(old.bytes().zip(new.bytes()));
        while !old.is_char_boundary(start) || !new.is_char_boundary(start) {
            start -= 1;
        }
        let reversed = old.bytes().rev().zip(new.bytes().rev());
        let different = reversed.clone().position(|(a, b)| a != b);
        let mut rest = different.unwrap_or(reversed.len());
        rest = rest.min(old.len() - start).min(new.len() - start);
        while !old.is_char_boundary(old.len() - rest) || !new.is_char_boundary(new.len() - rest) {
            rest -= 1;
        }
        Self {
            old: start..old.len() - rest,
            new_end: new.len() - rest,
        }
    }

    /// Returns the message at its new place, without the changes that would meet this one; `None`
    /// if its words are gone.
    pub(crate) fn message(&self, message: &Diagnostic) -> Option<Diagnostic> {
        let related = message.related.iter();
        let fixes = message.fixes.iter();
        Some(Diagnostic {
            range: self.range(&message.range)?,
            related: related
                .filter_map(|related| self.related(related))
                .collect(),
            fixes: fixes.filter_map(|fix| self.fix(fix)).collect(),
            ..message.clone()
        })
    }

    fn related(&self, related: &Related) -> Option<Related> {
        Some(Related {
            range: self.range(&related.range)?,
            message: related.message.clone(),
        })
    }

    fn fix(&self, fix: &Fix) -> Option<Fix> {
        let moved = |edit: &Edit| {
            let is_apart = edit.range.end <= self.old.start || self.old.end <= edit.range.start;
            Some(Edit {
                range: self.range(&edit.range).filter(|_| is_apart)?,
                text: edit.text.clone(),
            })
        };
        Some(Fix {
            title: fix.title.clone(),
            edits: fix.edits.iter().map(moved).collect::<Option<_>>()?,
        })
    }

    /// Returns bytes of the earlier text in the later one, as editors move marks: with a word that
    /// is changed in its middle they grow or shrink. `None` if nothing of them is left.
    fn range(&self, range: &Range<usize>) -> Option<Range<usize>> {
        let shifted = |byte: usize| byte - self.old.end + self.new_end;
        let start = match range.start {
            start if start >= self.old.end => shifted(start),
            start => start.min(self.old.start),
        };
        let end = match range.end {
            end if end <= self.old.start => end,
            end if end >= self.old.end => shifted(end),
            _ => self.new_end,
        };
        (start < end || range.is_empty()).then_some(start..end.max(start))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The place of `psi` in a later text.
    fn moved(new: &str) -> Option<Range<usize>> {
        let old = "let a = psi + 1;";
        Change::between(old, new).range(&(8..11))
    }

    #[test]
    fn places_follow_their_words() {
        assert_eq!(moved("let a = psi + 1;"), Some(8..11));
        assert_eq!(moved("let abc = psi + 1;"), Some(10..13));
        assert_eq!(moved("let a = psi + 1234;"), Some(8..11));
        assert_eq!(moved("let a = ppssi + 1;"), Some(8..13));
        assert_eq!(moved("let a = pi + 1;"), Some(8..10));
        assert_eq!(moved("let a = xpsi + 1;"), Some(9..12));
        assert_eq!(moved("let a = psix + 1;"), Some(8..11));
        assert_eq!(moved("let a =  + 1;"), None);
        assert_eq!(moved(""), None);
    }

    #[test]
    fn characters_are_not_cut() {
        // Both letters begin with the same byte, and end with the same byte.
        for (old, new) in [("aφb", "aχb"), ("a\u{3c6}b", "a\u{2c6}b")] {
            let change = Change::between(old, new);
            assert_eq!((change.old, change.new_end), (1..3, 3), "{new}");
        }
        let change = Change::between("aaa", "aa");
        assert_eq!((change.old, change.new_end), (2..3, 2));
    }

    #[test]
    fn changes_that_meet_are_left_out() {
        let fix = |range: Range<usize>| Fix {
            title: String::new(),
            edits: vec![Edit {
                range,
                text: "40mm".to_owned(),
            }],
        };
        let message = Diagnostic {
            fixes: vec![fix(4..7), fix(9..12)],
            ..Diagnostic::error(4..12, "")
        };
        let moved = Change::between("r = 5mm, 6mm;", "r = 5mm, 66mm;").message(&message);
        let moved = moved.expect("it is there");
        assert_eq!((moved.range, moved.fixes), (4..13, vec![fix(4..7)]));
    }
}
