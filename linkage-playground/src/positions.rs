//! Places in a text: bytes here, units of UTF-16 in a browser.

/// A text whose bytes are counted.
pub(crate) struct Positions<'t> {
    text: &'t str,
}

impl<'t> Positions<'t> {
    pub(crate) fn new(text: &'t str) -> Self {
        Self { text }
    }

    /// The place of a byte, counted in units of UTF-16; the end for bytes after it.
    pub(crate) fn utf16(&self, byte: usize) -> usize {
        let before = self
            .text
            .char_indices()
            .take_while(|(index, _)| *index < byte);
        before.map(|(_, letter)| letter.len_utf16()).sum()
    }

    /// The byte at a place that is counted in units of UTF-16.
    pub(crate) fn byte(&self, utf16: usize) -> usize {
        let mut passed = 0;
        let mut letters = self.text.char_indices();
        let found = letters.find(|(_, letter)| {
            let there = passed >= utf16;
            passed += letter.len_utf16();
            there
        });
        found.map_or(self.text.len(), |(index, _)| index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_of_several_units_are_counted() {
        let positions = Positions::new("aµ𝛼b");
        let counted = [0, 1, 3, 7, 8].map(|byte| positions.utf16(byte));
        assert_eq!(counted, [0, 1, 2, 4, 5]);
        assert_eq!(counted.map(|utf16| positions.byte(utf16)), [0, 1, 3, 7, 8]);
    }
}
