//! Units of derivatives.

use std::borrow::Cow;
use std::format;
use std::string::String;

/// The unit of a quantity whose derivative by something in `per` has the unit `unit`.
pub fn numerator<'a>(unit: &'a str, per: &'a str) -> Cow<'a, str> {
    match unit.strip_suffix(per).and_then(|u| u.strip_suffix('/')) {
        Some("1") => Cow::Borrowed(""),
        Some(rest) => Cow::Borrowed(rest),
        None if per.is_empty() => Cow::Borrowed(unit),
        None if unit.is_empty() => Cow::Borrowed(per),
        None => Cow::Owned(format!("{unit}*{per}")),
    }
}

/// The unit of a quantity's derivative by time.
pub fn per_second(unit: &str, order: u32) -> String {
    let unit = if unit.is_empty() { "1" } else { unit };
    match order {
        1 => format!("{unit}/s"),
        _ => format!("{unit}/s^{order}"),
    }
}

/// `name [unit]`, or the name alone for a number.
pub fn titled(name: &str, unit: &str) -> String {
    match unit {
        "" => String::from(name),
        _ => format!("{name} [{unit}]"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_quantities_follow_from_those_of_derivatives() {
        assert_eq!(numerator("mm/rad", "rad"), "mm");
        assert_eq!(numerator("mm/rad^2", "rad^2"), "mm");
        assert_eq!(numerator("mm/mm", "mm"), "mm");
        assert_eq!(numerator("1/rad", "rad"), "");
        assert_eq!(numerator("", "rad"), "rad");
        assert_eq!(numerator("mm", ""), "mm");
        assert_eq!(numerator("1/mm", "mm^2"), "1/mm*mm^2");
    }

    #[test]
    fn numbers_per_second_have_a_unit() {
        assert_eq!(per_second("mm", 1), "mm/s");
        assert_eq!(per_second("", 2), "1/s^2");
    }
}
