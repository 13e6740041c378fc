//! Exact decimal arithmetic on literals, so that a value converted to another unit is rounded once.

/// `digits` (most significant first, as numbers) times ten to the `exponent`.
#[derive(Clone, Debug)]
pub(in crate::model) struct Decimal {
    digits: Vec<u8>,
    exponent: i64,
}

/// Digits after those of the dividend if a quotient does not end.
const GUARD_DIGITS: usize = 40;
/// Beyond this every value overflows or vanishes; the sum of two cannot overflow.
const EXPONENT_LIMIT: i64 = 1_000_000_000;

impl Decimal {
    /// Reads `12`, `1.5`, `1e-3`: digits with at most one point and an exponent.
    pub(in crate::model) fn parse(text: &str) -> Option<Decimal> {
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, parse_exponent(exponent)?),
            None => (text, 0),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        if whole.is_empty() {
            return None;
        }
        let mut digits = Vec::with_capacity(whole.len() + fraction.len());
        for part in [whole, fraction] {
            for &byte in part.as_bytes() {
                digits.push(digit(byte)?);
            }
        }
        Some(Decimal {
            digits,
            exponent: exponent - fraction.len() as i64,
        })
    }

    pub(in crate::model) fn is_zero(&self) -> bool {
        self.digits.iter().all(|digit| *digit == 0)
    }

    pub(in crate::model) fn shifted(self, powers_of_ten: i64) -> Decimal {
        Decimal {
            exponent: self.exponent + powers_of_ten,
            ..self
        }
    }

    pub(in crate::model) fn times(&self, other: &Decimal) -> Decimal {
        // Indices of slices: iterators are calls where nothing is optimised, and pi is long.
        let (left, right) = (&self.digits[..], &other.digits[..]);
        let product = &mut vec![0u64; left.len() + right.len()][..];
        let mut i = 0;
        while i < left.len() {
            let mut j = 0;
            while j < right.len() {
                product[i + j + 1] += left[i] as u64 * right[j] as u64;
                j += 1;
            }
            i += 1;
        }
        let mut carry = 0;
        for digit in product.iter_mut().rev() {
            let sum = *digit + carry;
            *digit = sum % 10;
            carry = sum / 10;
        }
        let digits = product.iter().map(|digit| *digit as u8).collect();
        Decimal {
            digits,
            exponent: self.exponent + other.exponent,
        }
    }

    /// Exact, or longer than any tie between two neighbouring numbers of practical length.
    pub(in crate::model) fn over(&self, divisor: u64) -> Decimal {
        let guard = std::iter::repeat_n(&0, GUARD_DIGITS);
        let mut remainder = 0;
        let mut digits = Vec::with_capacity(self.digits.len() + GUARD_DIGITS + 1);
        for digit in self.digits.iter().chain(guard) {
            let dividend = remainder * 10 + u64::from(*digit);
            digits.push((dividend / divisor) as u8);
            remainder = dividend % divisor;
        }
        digits.push(u8::from(remainder != 0));
        Decimal {
            digits,
            exponent: self.exponent - GUARD_DIGITS as i64 - 1,
        }
    }

    /// The nearest double; infinite or zero beyond its range.
    pub(in crate::model) fn to_f64(&self) -> f64 {
        let digits: String = self
            .digits
            .iter()
            .map(|digit| char::from(b'0' + digit))
            .collect();
        let text = format!("{digits}e{}", self.exponent);
        text.parse().expect("digits and an exponent are a number")
    }
}

fn digit(byte: u8) -> Option<u8> {
    byte.is_ascii_digit().then(|| byte - b'0')
}

fn parse_exponent(text: &str) -> Option<i64> {
    let (sign, digits) = match text.strip_prefix('-') {
        Some(digits) => (-1, digits),
        None => (1, text.strip_prefix('+').unwrap_or(text)),
    };
    if digits.is_empty() {
        return None;
    }
    let mut value = 0;
    for byte in digits.bytes() {
        value = (value * 10 + i64::from(digit(byte)?)).min(EXPONENT_LIMIT);
    }
    Some(sign * value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_and_rounds() {
        for text in [
            "0", "12", "1.5", "1.", "1e-3", "1E+3", "2.5e400", "1e-400", "0.1",
        ] {
            let value = Decimal::parse(text).expect("a number").to_f64();
            assert_eq!(value, text.parse::<f64>().expect("a number"), "{text}");
        }
        for text in ["", ".5", "1.2.3", "1e", "1e+", "x", "1x"] {
            assert!(Decimal::parse(text).is_none(), "{text}");
        }
        let huge = Decimal::parse("1e99999999999999999999").expect("a number");
        assert_eq!(huge.to_f64(), f64::INFINITY);
    }

    #[test]
    fn arithmetic() {
        let decimal = |text| Decimal::parse(text).expect("a number");
        assert_eq!(decimal("12.5").times(&decimal("0.08")).to_f64(), 1.0);
        assert_eq!(decimal("999").times(&decimal("999")).to_f64(), 998001.0);
        assert_eq!(decimal("1").over(3).to_f64(), 1.0 / 3.0);
        assert_eq!(decimal("254").over(254).to_f64(), 1.0);
        assert_eq!(decimal("12").shifted(-3).to_f64(), 0.012);
    }
}
