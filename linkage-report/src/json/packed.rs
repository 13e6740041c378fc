//! Numbers of a page in fewer letters than decimals take: one number for all rows, or the bytes of
//! all.

use serde_json::{Value, json};
use std::string::String;
use std::vec::Vec;

/// Letters of six bits each.
const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Returns the shortest of these: a list, `{"f64": [NUMBER, ROWS]}` for equal numbers, and
/// `{"f64": TEXT}` with the bytes of all numbers in base 64. Numbers that are not finite are NaN in
/// the bytes, and `null` otherwise.
pub(super) fn packed(values: &[f64]) -> Value {
    let equal = match values {
        [first, others @ ..] if others.iter().all(|x| x.to_bits() == first.to_bits()) => {
            Some(json!({ "f64": [first, values.len()] }))
        }
        _ => None,
    };
    let bytes_length = AROUND_LETTERS + (8 * values.len()).div_ceil(3) * 4;
    let most = match &equal {
        Some(equal) => bytes_length.min(equal.to_string().len()),
        None => bytes_length,
    };
    if is_list_within(values, most) {
        return json!(values);
    }
    match equal {
        Some(equal) if equal.to_string().len() < bytes_length => equal,
        _ => json!({ "f64": letters(values) }),
    }
}

/// The characters of `{"f64":""}`.
const AROUND_LETTERS: usize = 10;

/// Returns true if the list of numbers has at most so many characters. Most lists are longer, and
/// printing all of their numbers takes longer than everything else in a page.
fn is_list_within(values: &[f64], most: usize) -> bool {
    // A bracket and a comma or a bracket.
    let mut length = if values.is_empty() { 2 } else { 1 };
    let mut number = Vec::new();
    values.iter().all(|value| {
        number.clear();
        let written = serde_json::to_writer(&mut number, value);
        length += number.len() + 1;
        written.is_ok() && length <= most
    }) && length <= most
}

/// The bytes of numbers in base 64, with `=` for bytes that are missing at the end.
fn letters(values: &[f64]) -> String {
    let finite = |x: &f64| if x.is_finite() { *x } else { f64::NAN };
    let bytes: Vec<u8> = values
        .iter()
        .flat_map(|x| finite(x).to_le_bytes())
        .collect();
    base_64(&bytes)
}

fn base_64(bytes: &[u8]) -> String {
    let mut text = Vec::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let number = |k: usize| u32::from(three.get(k).copied().unwrap_or(0));
        let bits = number(0) << 16 | number(1) << 8 | number(2);
        let all = [18, 12, 6, 0].map(|shift| LETTERS[(bits >> shift & 63) as usize]);
        text.extend_from_slice(&all);
        let missing = 3 - three.len();
        let end = text.len();
        text[end - missing..].fill(b'=');
    }
    text.into_iter().map(char::from).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shortest_form_is_taken() {
        assert_eq!(packed(&[1.5, 2.0]), json!([1.5, 2.0]));
        assert_eq!(packed(&[0.25; 20]), json!({ "f64": [0.25, 20] }));
        assert_eq!(packed(&[f64::NAN; 20]), json!({ "f64": [null, 20] }));
        assert_eq!(packed(&[]), json!([]));
        let third = packed(&[1.0 / 3.0, -1.0 / 3.0, f64::INFINITY]);
        assert_eq!(third, json!({ "f64": "VVVVVVVV1T9VVVVVVVXVvwAAAAAAAPh/" }));
        // Lists of equal length come first.
        for count in 0..40 {
            for value in [0.5, 0.123_456_78, 1.0 / 3.0, f64::NAN] {
                let equal = vec![value; count];
                let other: Vec<f64> = (0..count).map(|k| value + k as f64).collect();
                for values in [equal, other] {
                    let mut forms = Vec::from([json!(values), json!({ "f64": letters(&values) })]);
                    if values
                        .windows(2)
                        .all(|pair| pair[0].to_bits() == pair[1].to_bits())
                        && count > 0
                    {
                        forms.push(json!({ "f64": [values[0], count] }));
                    }
                    let shortest = forms.into_iter().min_by_key(|form| form.to_string().len());
                    assert_eq!(Some(packed(&values)), shortest, "{values:?}");
                }
            }
        }
    }

    #[test]
    fn bytes_are_in_base_64() {
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base_64(bytes.as_bytes()), text);
        }
    }
}
