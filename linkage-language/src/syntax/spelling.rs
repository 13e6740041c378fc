//! Units as others write them, `Nmm`, `kgm2`, and misspelt ones.

use std::collections::BTreeSet;

use super::units::{is_unit, unit_names};
use crate::diagnostic::text::edit_distance;

/// Letters of the shortest unit that is a word: a slip in it cannot be another unit.
const WORD: usize = 4;
/// Letters of the shortest slip: two letters can be another unit, as `mn` is near `nm` and `mN`.
const SHORTEST_SLIP: usize = 3;

/// Returns the unit that a slip of the keyboard has spoilt: `mmm`, `dge`, `inhc`. Another letter in
/// a short unit is no slip, because it can be another unit: `ksi`, `mrad`.
pub fn near_unit(text: &str) -> Option<&'static str> {
    let letters = |word: &str| word.chars().collect::<BTreeSet<char>>();
    let is_near = |unit: &&'static str| {
        let is_slip = unit.len() >= WORD || unit.len() > 1 && letters(unit) == letters(text);
        is_slip && edit_distance(unit, text) == 1
    };
    let can_be_slip = text.len() >= SHORTEST_SLIP && !is_unit(text);
    unit_names().filter(|_| can_be_slip).find(is_near)
}

/// Returns units and exponents without signs between them in the notation of the language: `N*mm`,
/// `kg*m^2`. `None` for a unit of the table, and for a text that can be any name.
pub fn units_within(text: &str) -> Option<String> {
    let factors = split(text).filter(|_| !is_unit(text))?;
    let telling = |factor: &String| factor.contains(['N', '^']) || factor == "kg";
    factors.iter().any(telling).then(|| factors.join("*"))
}

fn split(text: &str) -> Option<Vec<String>> {
    if text.is_empty() {
        return Some(Vec::new());
    }
    let mut units: Vec<&str> = unit_names().collect();
    units.sort_by_key(|unit| std::cmp::Reverse(unit.len()));
    units.into_iter().find_map(|unit| {
        let rest = text.strip_prefix(unit)?;
        let exponent = rest
            .chars()
            .next()
            .filter(|digit| ('2'..='4').contains(digit));
        let factor = match exponent {
            Some(digit) => format!("{unit}^{digit}"),
            None => unit.to_owned(),
        };
        let rest = split(&rest[exponent.map_or(0, char::len_utf8)..])?;
        Some(std::iter::once(factor).chain(rest).collect())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_units() {
        for (text, unit) in [
            ("mmm", "mm"),
            ("dge", "deg"),
            ("ccm", "cm"),
            ("kgg", "kg"),
            ("inhc", "inch"),
            ("inc", "inch"),
            ("trun", "turn"),
        ] {
            assert_eq!(near_unit(text), Some(unit), "{text}");
        }
        for text in ["mm", "ksi", "mrad", "MN", "x", "mmmm", "mil", "kph", "mn"] {
            assert_eq!(near_unit(text), None, "{text}");
        }
    }

    #[test]
    fn units_are_found() {
        for (text, expected) in [
            ("Nm", "N*m"),
            ("Nmm", "N*mm"),
            ("kNm", "kN*m"),
            ("Ns", "N*s"),
            ("kgmm2", "kg*mm^2"),
            ("s2", "s^2"),
        ] {
            assert_eq!(units_within(text).as_deref(), Some(expected));
        }
        for text in ["mm", "mN", "min", "x", "m1", "mt", "Nx", "N9"] {
            assert_eq!(units_within(text), None, "{text}");
        }
    }
}
