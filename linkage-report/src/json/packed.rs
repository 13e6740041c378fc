//! Numbers of a page in fewer letters than decimals take: one number for all rows, or the bytes of
//! all.

use core::iter::repeat_n;
use serde_json::{Value, json};
use std::string::String;
use std::vec::Vec;

/// Letters of six bits each.
const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Returns the shortest of these: a list, `{"f64": [NUMBER, ROWS]}` for equal numbers, and
/// `{"f64": TEXT}` with the bytes of all numbers in base 64. Numbers that are not finite are NaN in
/// the bytes, and `null` otherwise.
pub(super) fn packed(values: &[f64]) -> Value {
    let bytes: Vec<u8> = values
        .iter()
        .flat_map(|x| if x.is_finite() { *x } else { f64::NAN }.to_le_bytes())
        .collect();
    let mut forms = Vec::from([json!(values), json!({ "f64": letters(&bytes) })]);
    if let [first, others @ ..] = values
        && others.iter().all(|x| x.to_bits() == first.to_bits())
    {
        forms.push(json!({ "f64": [first, values.len()] }));
    }
    let forms = forms.into_iter();
    forms
        .min_by_key(|form| form.to_string().len())
        .unwrap_or_default()
}

/// Base 64, with `=` for bytes that are missing at the end.
fn letters(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let number = |k: usize| u32::from(three.get(k).copied().unwrap_or(0));
        let bits = number(0) << 16 | number(1) << 8 | number(2);
        let there = three.len() + 1;
        let all = [18, 12, 6, 0].map(|shift| char::from(LETTERS[(bits >> shift & 63) as usize]));
        text.extend(all.into_iter().take(there).chain(repeat_n('=', 4 - there)));
    }
    text
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
            assert_eq!(letters(bytes.as_bytes()), text);
        }
    }
}
