//! Units as others write them: `Nmm`, `kgm2`.

use super::units::{is_unit, unit_names};

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
