//! Format of numbers and cells of CSV.

use std::borrow::Cow;
use std::format;
use std::string::{String, ToString};

use crate::mistake::Mistake;

/// The format of tables as CSV: separator, decimal mark, number of digits, angles in radians or
/// degrees.
///
/// Without a change: commas, points, the digits that it takes to read numbers back exactly,
/// radians.
///
/// ```
/// use linkage_formats::CsvStyle;
///
/// // For a spreadsheet that writes commas.
/// let style = CsvStyle::default().separator(";").decimal(',').digits(6).degrees(true);
/// assert_eq!(style.number(-0.5), "-0,500000");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CsvStyle {
    separator: String,
    decimal: char,
    digits: Option<usize>,
    degrees: bool,
}

impl Default for CsvStyle {
    fn default() -> Self {
        Self {
            separator: String::from(","),
            decimal: '.',
            digits: None,
            degrees: false,
        }
    }
}

impl CsvStyle {
    /// Sets the separator of columns: `;`, a tabulator. It may contain nothing that numbers have.
    #[must_use]
    pub fn separator(mut self, separator: &str) -> Self {
        self.separator = separator.to_string();
        self
    }

    /// The decimal mark.
    #[must_use]
    pub fn decimal(mut self, decimal: char) -> Self {
        self.decimal = decimal;
        self
    }

    /// Sets the number of significant digits, one at least.
    #[must_use]
    pub fn digits(mut self, digits: usize) -> Self {
        self.digits = Some(digits);
        self
    }

    /// Turns angles in degrees on or off. Their rates stay in radians.
    #[must_use]
    pub fn degrees(mut self, degrees: bool) -> Self {
        self.degrees = degrees;
        self
    }

    /// Returns the mistake of a style whose cells are ambiguous.
    #[must_use]
    pub fn mistake(&self) -> Option<Mistake> {
        let (separator, decimal) = (&self.separator, self.decimal);
        let in_numbers =
            |letter: char| letter.is_ascii_alphanumeric() || "+-\"\r\n".contains(letter);
        let wrong = separator.is_empty()
            || separator.contains(decimal)
            || separator.contains(in_numbers)
            || in_numbers(decimal);
        wrong.then(|| Mistake::Separator {
            separator: separator.clone(),
            decimal,
        })
    }

    /// A number; nothing for one that is not finite.
    #[must_use]
    pub fn number(&self, x: f64) -> String {
        if !x.is_finite() {
            return String::new();
        }
        let digits = match self.digits {
            // Zero has no sign for a reader; all digits of a number are its sign, too.
            Some(digits) => significant(x + 0.0, digits),
            None => shortest(x),
        };
        match self.decimal {
            '.' => digits,
            other => digits.replace('.', &other.to_string()),
        }
    }

    /// A line of cells.
    #[must_use]
    pub fn line<'a>(&self, cells: impl IntoIterator<Item = Cow<'a, str>>) -> String {
        let mut line = String::new();
        for (index, cell) in cells.into_iter().enumerate() {
            if index > 0 {
                line.push_str(&self.separator);
            }
            line.push_str(&cell);
        }
        line.push_str("\r\n");
        line
    }

    /// A word as a cell, in quotes where it would be misread.
    #[must_use]
    pub fn word<'a>(&self, word: &'a str) -> Cow<'a, str> {
        let misread = word.contains(&self.separator) || word.contains(['"', '\r', '\n']);
        match misread {
            true => Cow::Owned(format!("\"{}\"", word.replace('"', "\"\""))),
            false => Cow::Borrowed(word),
        }
    }

    /// Returns the unit in which numbers of a unit are shown, and the conversion.
    #[doc(hidden)]
    #[must_use]
    pub fn shown<'a>(&self, unit: &'a str) -> (&'a str, fn(f64) -> f64) {
        match unit {
            "rad" if self.degrees => ("deg", f64::to_degrees),
            unit => (unit, |x| x),
        }
    }
}

/// Shortest digits that are read back to the same number.
fn shortest(x: f64) -> String {
    let digits = format!("{x:?}");
    match digits.strip_suffix(".0") {
        Some(whole) => whole.to_string(),
        None => digits,
    }
}

/// A number with so many significant digits, with an exponent where it is very small or larger than
/// the digits say.
fn significant(x: f64, digits: usize) -> String {
    let behind = digits.max(1) - 1;
    let rounded = format!("{x:.behind$e}");
    let exponent: Option<i32> = rounded.split_once('e').and_then(|pair| pair.1.parse().ok());
    let size = |exponent: i32| exponent.unsigned_abs() as usize;
    match exponent {
        Some(exponent @ -5..=-1) => format!("{x:.*}", behind + size(exponent)),
        Some(exponent) if exponent >= 0 && size(exponent) <= behind => {
            format!("{x:.*}", behind - size(exponent))
        }
        _ => rounded,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_significant() {
        let style = |digits: Option<usize>| {
            let style = CsvStyle::default();
            digits.map_or(style.clone(), |digits| style.digits(digits))
        };
        for (x, digits, text) in [
            (3.125, None, "3.125"),
            (3.0, None, "3"),
            (0.1 + 0.2, None, "0.30000000000000004"),
            (1e300, None, "1e300"),
            (f64::NAN, None, ""),
            (f64::INFINITY, Some(3), ""),
            (0.0, Some(6), "0.00000"),
            (-12.345_678, Some(4), "-12.35"),
            (9.9996, Some(4), "10.00"),
            (123_456.7, Some(6), "123457"),
            (1_234_567.0, Some(6), "1.23457e6"),
            (0.001_234_56, Some(3), "0.00123"),
            (1.234e-9, Some(3), "1.23e-9"),
        ] {
            assert_eq!(style(digits).number(x), text, "{x:e}");
        }
        assert_eq!(style(Some(3)).decimal(',').number(0.5), "0,500");
    }

    #[test]
    fn cells_can_be_told_apart() {
        let style = |separator, decimal| CsvStyle::default().separator(separator).decimal(decimal);
        for (separator, decimal) in [
            (",", '.'),
            (";", ','),
            ("\t", ','),
            (" | ", '.'),
            (",", '·'),
        ] {
            assert_eq!(style(separator, decimal).mistake(), None, "{separator:?}");
        }
        for (separator, decimal) in [
            (",", ','),
            (".", '.'),
            ("; ,", ','),
            ("", '.'),
            ("e", '.'),
            ("1", '.'),
            ("-", '.'),
            (";", '5'),
            (";", 'e'),
            ("\n", '.'),
            ("\"", '.'),
        ] {
            let mistake = style(separator, decimal).mistake();
            assert!(mistake.is_some(), "{separator:?} {decimal:?}");
        }
        let message = style(",", ',').mistake().unwrap().to_string();
        assert_eq!(
            message,
            "columns with \",\" between them and numbers with ',' for the decimal point cannot be told apart when they are read; \
             take \";\" and ',', or \",\" and '.'"
        );
    }
}
