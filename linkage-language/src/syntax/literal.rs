//! Numbers with their units.

use super::expression_tree::{Expr, ExprKind};
use super::parser::{Parsed, Parser, Reported};
use super::spelling::{near_unit, units_within};
use super::units::{is_unit, unit_names};
use crate::diagnostic::SourceSpan;

/// The type suffixes of Rust's own numbers.
const RUST_SUFFIXES: [&str; 16] = [
    "f16", "f32", "f64", "f128", "i8", "i16", "i32", "i64", "i128", "isize", "u8", "u16", "u32",
    "u64", "u128", "usize",
];

impl Parser<'_> {
    /// A number; its unit is glued to it or the next word.
    pub(super) fn number(&mut self) -> Parsed<Expr> {
        let span = self.stream.span();
        let Some(literal) = self.literal() else {
            return self.expected("a number", "");
        };
        let written = literal.to_string();
        if let Some(positive) = written.strip_prefix('-') {
            let number = self.number_from(positive, span)?;
            return Ok(Expr {
                kind: ExprKind::Negate(Box::new(number)),
                span,
            });
        }
        self.number_from(&written, span)
    }

    fn number_from(&mut self, written: &str, span: SourceSpan) -> Parsed<Expr> {
        if !written.starts_with(|first: char| first.is_ascii_digit()) {
            return self.fail_at(span, format!("expected a number, found `{written}`"), "");
        }
        if written.starts_with('0') && written[1..].starts_with(['x', 'X', 'o', 'b']) {
            let fact = format!("`{written}` is not a decimal number");
            return self.fail_at(span, fact, "write the number in decimal digits");
        }
        let (text, suffix) = split_suffix(written);
        if !suffix.is_empty() {
            self.check_suffix(&text, suffix, span)?;
            return Ok(number(text, suffix, span));
        }
        match self.stream.ident(0).map(ToString::to_string) {
            Some(unit) if is_unit(&unit) => {
                let span = span.to(self.stream.span());
                self.stream.skip(1);
                Ok(number(text, &unit, span))
            }
            _ => Ok(number(text, "", span)),
        }
    }

    fn check_suffix(&mut self, text: &str, suffix: &str, span: SourceSpan) -> Parsed<()> {
        if is_unit(suffix) {
            return Ok(());
        }
        if RUST_SUFFIXES.contains(&suffix) {
            let fact = format!("the type suffix `{suffix}` has no meaning here");
            return self.fail_at(span, fact, &format!("write `{text}`"));
        }
        if let Some(help) = other_spelling(text, suffix) {
            let fact = format!("unknown unit `{suffix}`");
            return self.fail_at(span, fact, &format!("write {help}"));
        }
        let fact = format!("unknown unit `{suffix}`");
        if let Some(unit) = near_unit(suffix) {
            let number = format!("{text}{unit}");
            let help = format!("did you mean `{number}`?");
            let message = self.diagnostics.error_with_help(span, fact, help);
            message.suggest(format!("write `{number}`"), span, number);
            return Err(Reported);
        }
        let names: Vec<&str> = unit_names().collect();
        let help = format!(
            "units are {}; a product is written `{text} * {suffix}`",
            names.join(" ")
        );
        self.fail_at(span, fact, &help)
    }
}

fn number(text: String, suffix: &str, span: SourceSpan) -> Expr {
    Expr {
        kind: ExprKind::Number {
            text,
            suffix: suffix.to_owned(),
        },
        span,
    }
}

/// `1_000.5e-3mm` is `1000.5e-3` and `mm`.
fn split_suffix(written: &str) -> (String, &str) {
    let bytes = written.as_bytes();
    let digits_from = |start: usize| {
        let is_digit = |byte: &u8| byte.is_ascii_digit() || *byte == b'_';
        start
            + bytes[start..]
                .iter()
                .take_while(|byte| is_digit(byte))
                .count()
    };
    let mut end = digits_from(0);
    if bytes.get(end) == Some(&b'.') {
        end = digits_from(end + 1);
    }
    if let Some(b'e' | b'E') = bytes.get(end) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let digits = end + 1 + sign;
        let exponent_end = digits_from(digits);
        if bytes[digits..exponent_end].iter().any(u8::is_ascii_digit) {
            end = exponent_end;
        }
    }
    (written[..end].replace('_', ""), &written[end..])
}

/// Returns the spelling of a unit for a suffix that a user may expect to work.
fn other_spelling(text: &str, suffix: &str) -> Option<String> {
    let instead = match suffix {
        "in" | "inches" => "inch",
        "metre" | "meter" => "m",
        "micron" | "microns" => "um",
        "degree" | "degrees" => "deg",
        "radian" | "radians" => "rad",
        "arcminute" => "arcmin",
        "arcsecond" => "arcsec",
        "Kg" | "KG" | "kgs" => "kg",
        "KN" | "kn" => "kN",
        "Mpa" | "mpa" => "MPa",
        "foot" | "feet" => "ft",
        "RPM" => "rpm",
        "Hz" => "/s",
        "rps" => "turn/s",
        "mrad" => " * 0.001rad",
        "MM" | "Mm" => "mm",
        "CM" | "Cm" => "cm",
        "km" => " * 1000m",
        "mil" | "thou" => " * 0.001inch",
        "MN" => " * 1000kN",
        "GPa" => " * 1000MPa",
        "ksi" => " * 1000psi",
        "bar" => " * 0.1MPa",
        "kgf" => " * 9.80665N",
        "lbs" => return Some(format!("`{text}lb` for a mass, `{text}lbf` for a force")),
        "sec" => return Some(format!("`{text}s` for time, `{text}arcsec` for an angle")),
        "rev" | "turns" => "turn",
        _ => {
            let factors = units_within(suffix).map(|units| match units.split_once('^') {
                // A power cannot follow a number.
                Some((before, _)) if !before.contains('*') => format!("`{text} * {units}`"),
                _ => format!("`{text}{units}`"),
            });
            return factors.or_else(|| compound(text, suffix));
        }
    };
    Some(format!("`{text}{instead}`"))
}

/// `45deg30arcmin` is `45deg + 30arcmin`.
fn compound(text: &str, suffix: &str) -> Option<String> {
    let mut terms = Vec::new();
    let mut number = text;
    let mut rest = suffix;
    loop {
        let unit_end = rest
            .find(|letter: char| letter.is_ascii_digit())
            .unwrap_or(rest.len());
        let (unit, tail) = rest.split_at(unit_end);
        if !is_unit(unit) {
            return None;
        }
        terms.push(format!("{number}{unit}"));
        if tail.is_empty() {
            return (terms.len() > 1).then(|| format!("`{}`", terms.join(" + ")));
        }
        let number_end = tail
            .find(|letter: char| !letter.is_ascii_digit())
            .unwrap_or(tail.len());
        (number, rest) = tail.split_at(number_end);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn suffixes_are_split_off() {
        for (written, text, suffix) in [
            ("272.5mm", "272.5", "mm"),
            ("1_000_mm", "1000", "mm"),
            ("1E+3mm", "1E+3", "mm"),
            ("1.5e-3", "1.5e-3", ""),
            ("5.", "5.", ""),
            ("2.5E", "2.5", "E"),
            ("3e_mm", "3", "e_mm"),
            ("5µm", "5", "µm"),
        ] {
            assert_eq!(split_suffix(written), (text.to_owned(), suffix));
        }
    }

    #[test]
    fn compound_angles() {
        assert_eq!(
            compound("45", "deg30arcmin").as_deref(),
            Some("`45deg + 30arcmin`")
        );
        assert_eq!(compound("45", "deg30"), None);
        assert_eq!(compound("45", "deg"), None);
    }
}
