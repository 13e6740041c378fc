//! Numbers in tables.

/// How numbers are written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Style {
    /// Significant digits; all that it takes to read a number back exactly without.
    pub(super) digits: Option<usize>,
    /// The decimal mark.
    pub(super) decimal: char,
}

impl Style {
    /// A number; nothing for one that is not finite.
    pub(super) fn written(self, x: f64) -> String {
        if !x.is_finite() {
            return String::new();
        }
        let digits = match self.digits {
            Some(digits) => significant(x, digits),
            None => {
                let digits = format!("{x:?}");
                digits
                    .strip_suffix(".0")
                    .map_or(digits.clone(), str::to_owned)
            }
        };
        match self.decimal {
            '.' => digits,
            other => digits.replace('.', &other.to_string()),
        }
    }
}

/// A number with so many significant digits, with an exponent where it is very small or larger than the digits say.
fn significant(x: f64, digits: usize) -> String {
    let behind = digits.max(1) - 1;
    let rounded = format!("{x:.behind$e}");
    let exponent = rounded.split_once('e').and_then(|pair| pair.1.parse().ok());
    match exponent {
        Some(exponent @ -5..=-1) => {
            format!("{x:.*}", behind + usize::from(exponent_size(exponent)))
        }
        Some(exponent) if exponent >= 0 && exponent_size(exponent) as usize <= behind => {
            format!("{x:.*}", behind - usize::from(exponent_size(exponent)))
        }
        _ if x == 0.0 => "0".to_owned(),
        _ => rounded,
    }
}

fn exponent_size(exponent: i32) -> u16 {
    exponent.unsigned_abs() as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_significant() {
        let style = |digits| Style {
            digits,
            decimal: '.',
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
            assert_eq!(style(digits).written(x), text, "{x:e}");
        }
        let comma = Style {
            digits: Some(3),
            decimal: ',',
        };
        assert_eq!(comma.written(0.5), "0,500");
    }
}
