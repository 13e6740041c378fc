//! Lines and columns of a text, as editors count them, and its bytes.

/// The unit of columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Columns count bytes.
    Utf8,
    /// Columns count the 16-bit units of UTF-16.
    Utf16,
}

/// A position in a text, line and column counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// The line.
    pub line: u32,
    /// The column, in units of the [`Encoding`].
    pub column: u32,
}

/// The beginnings of all lines of a text.
#[derive(Clone, Debug)]
pub struct Lines {
    starts: Vec<usize>,
}

impl Lines {
    /// Finds the lines of a text. `\n`, `\r\n` and `\r` end a line.
    #[must_use]
    pub fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let ends = |index: &usize| match bytes[*index] {
            b'\n' => true,
            b'\r' => bytes.get(index + 1) != Some(&b'\n'),
            _ => false,
        };
        let starts = (0..bytes.len()).filter(ends).map(|index| index + 1);
        Self {
            starts: [0].into_iter().chain(starts).collect(),
        }
    }

    /// Returns the number of the line of a byte.
    #[must_use]
    pub fn line(&self, offset: usize) -> usize {
        self.starts.partition_point(|start| *start <= offset) - 1
    }

    /// Returns the byte at which a line begins, the end of the text after the last line.
    #[must_use]
    pub fn start(&self, text: &str, line: usize) -> usize {
        self.starts.get(line).copied().unwrap_or(text.len())
    }

    /// Returns the position of a byte. A byte within a character counts as its beginning.
    #[must_use]
    pub fn position(&self, text: &str, offset: usize, encoding: Encoding) -> Position {
        let offset = boundary(text, offset);
        let line = self.line(offset);
        let before = &text[self.starts[line]..offset];
        let column = match encoding {
            Encoding::Utf8 => before.len(),
            Encoding::Utf16 => before.encode_utf16().count(),
        };
        Position {
            line: line as u32,
            column: column as u32,
        }
    }

    /// Returns the byte of a position. A column after the end of the line counts as the end.
    #[must_use]
    pub fn offset(&self, text: &str, position: Position, encoding: Encoding) -> usize {
        let line = position.line as usize;
        let start = self.start(text, line);
        let end = self.start(text, line + 1);
        let content = text[start..end].trim_end_matches(['\n', '\r']);
        let column = position.column as usize;
        let within = match encoding {
            Encoding::Utf8 => boundary(content, column),
            Encoding::Utf16 => {
                let mut units = 0;
                let mut characters = content.char_indices();
                let found = characters.find(|(_, character)| {
                    units += character.len_utf16();
                    units > column
                });
                found.map_or(content.len(), |(index, _)| index)
            }
        };
        start + within
    }
}

/// Returns the nearest boundary of characters at or before a byte.
fn boundary(text: &str, offset: usize) -> usize {
    let mut offset = offset.min(text.len());
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    offset
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_units_of_the_encoding() {
        let text = "a\r\nä𝛗b\rc";
        let lines = Lines::new(text);
        let b = text.find('b').expect("there is one");
        for (encoding, column) in [(Encoding::Utf8, 6), (Encoding::Utf16, 3)] {
            let position = Position { line: 1, column };
            assert_eq!(lines.position(text, b, encoding), position);
            assert_eq!(lines.offset(text, position, encoding), b);
        }
        let last = Position { line: 2, column: 1 };
        assert_eq!(lines.position(text, text.len(), Encoding::Utf16), last);
    }

    #[test]
    fn positions_outside_are_the_nearest_inside() {
        let text = "ab\ncd";
        let lines = Lines::new(text);
        let at = |line, column| lines.offset(text, Position { line, column }, Encoding::Utf16);
        assert_eq!([at(0, 9), at(1, 9), at(7, 0)], [2, 5, 5]);
        // The middle of a character of two units, and of two bytes.
        let wide = "𝛗ä";
        let lines = Lines::new(wide);
        let at = |column, encoding| lines.offset(wide, Position { line: 0, column }, encoding);
        assert_eq!([at(1, Encoding::Utf16), at(5, Encoding::Utf8)], [0, 4]);
    }
}
