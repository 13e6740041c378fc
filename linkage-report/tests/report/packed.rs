//! The data of a page, whose numbers are packed.

use crate::fixture::FourBar;
use crate::four_bar;
use serde_json::{Value, json};

#[test]
fn pages_have_fewer_letters_than_decimals() {
    let report = four_bar(FourBar::GAPPED);
    let page = report.html().unwrap();
    let (_, rest) = page.split_once("id=\"report\">").unwrap();
    let packed = rest.split_once("</script>").unwrap().0.len();
    let decimals = report.json().unwrap().len();
    assert!(
        10 * packed < 7 * decimals,
        "{packed} and {decimals} letters"
    );
}

/// The data of a page with lists of numbers, as in the JSON of the report.
pub(crate) fn page_data(page: &str) -> Value {
    let (_, rest) = page.split_once("id=\"report\">").unwrap();
    let mut data = serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap();
    unpack(&mut data);
    data
}

fn unpack(value: &mut Value) {
    match value {
        Value::Object(members) => match members.get("f64") {
            Some(Value::String(letters)) => *value = json!(numbers(letters)),
            Some(Value::Array(pair)) => {
                let rows = pair[1].as_u64().unwrap();
                *value = json!(vec![pair[0].clone(); rows as usize]);
            }
            _ => members.values_mut().for_each(unpack),
        },
        Value::Array(items) => items.iter_mut().for_each(unpack),
        _ => {}
    }
}

/// The numbers whose bytes are in base 64.
fn numbers(letters: &str) -> Vec<f64> {
    let mut bytes = Vec::new();
    for four in letters.as_bytes().chunks(4) {
        let bits = four
            .iter()
            .fold(0, |bits: u32, letter| bits << 6 | six_bits(*letter));
        let there = four.iter().filter(|letter| **letter != b'=').count() - 1;
        bytes.extend(bits.to_be_bytes().into_iter().skip(1).take(there));
    }
    let eight = bytes.chunks_exact(8);
    eight
        .map(|eight| f64::from_le_bytes(eight.try_into().unwrap()))
        .collect()
}

fn six_bits(letter: u8) -> u32 {
    let value = match letter {
        b'A'..=b'Z' => letter - b'A',
        b'a'..=b'z' => letter - b'a' + 26,
        b'0'..=b'9' => letter - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        _ => 0,
    };
    value.into()
}
