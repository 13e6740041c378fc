//! Values on the command line: numbers with units, as in a mechanism.

use clap::Args;
use linkage_compiler::ir::COMPONENTS;
use linkage_compiler::{check_value, shortened};
use linkage_engine::Mechanism;
use proc_macro2::TokenStream;

use super::value_names::name_within;
use crate::failure::{Failure, known_names};
use crate::normal::normal;

/// Dimensions other than those of the file.
#[derive(Debug, Args)]
pub(super) struct Dimensions {
    /// A dimension, as `crank=51mm`, `crank='51mm +- 0.1mm'` or `pivot=(140mm, 0mm)`; may be given
    /// several times
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = normal)]
    set: Vec<String>,
}

impl Dimensions {
    /// Returns true if there are other dimensions than those of the file.
    pub(super) fn are_given(&self) -> bool {
        !self.set.is_empty()
    }

    /// The options as they are written.
    pub(super) fn options(&self) -> String {
        let options: Vec<String> = self.set.iter().map(|set| format!("--set {set}")).collect();
        options.join(" ")
    }

    /// Those of the options whose dimension a mechanism has.
    pub(super) fn known_to(&self, mechanism: &Mechanism) -> Self {
        let known = |given: &&String| {
            let setting = parts("--set", given);
            setting.is_ok_and(|(name, _)| places(mechanism, name).is_ok())
        };
        Self {
            set: self.set.iter().filter(known).cloned().collect(),
        }
    }

    /// Fails at the first option that none of the mechanisms knows.
    pub(super) fn known_to_any(&self, all: &[Mechanism]) -> Result<(), Failure> {
        for given in &self.set {
            let (name, _) = parts("--set", given)?;
            let mut found = all.iter().map(|mechanism| places(mechanism, name));
            if let Some(Err(unknown)) = found.next()
                && found.all(|found| found.is_err())
            {
                return Err(unknown);
            }
        }
        Ok(())
    }

    /// All dimensions of the mechanism, in the order of its parameters.
    pub(super) fn resolve(&self, mechanism: &Mechanism) -> Result<Vec<f64>, Failure> {
        let mut values = mechanism.dimensions();
        for (parameter_index, number) in self.numbers(mechanism)? {
            values[parameter_index] = number.value;
        }
        Ok(values)
    }

    /// Gives the mechanism the tolerances that stand with the dimensions, as `crank=40mm +- 0.1mm`.
    pub(super) fn tolerate(&self, mechanism: &mut Mechanism) -> Result<(), Failure> {
        for (parameter_index, number) in self.numbers(mechanism)? {
            if let Some(tolerance) = number.tolerance {
                mechanism.set_tolerance(parameter_index, tolerance);
            }
        }
        Ok(())
    }

    /// The numbers of all options in their order, with the places of their scalars.
    fn numbers(&self, mechanism: &Mechanism) -> Result<Vec<(usize, Number)>, Failure> {
        let mut all = Vec::new();
        for given in &self.set {
            let (name, text) = parts("--set", given)?;
            let places = places(mechanism, name)?;
            let units = places
                .iter()
                .map(|&parameter_index| mechanism.parameters()[parameter_index].unit);
            let units: Vec<&str> = units.collect();
            let numbers = quantity(mechanism, name, text, &units)?;
            all.extend(places.into_iter().zip(numbers));
        }
        Ok(all)
    }
}

/// The scalars of a parameter, or one of them: `pivot`, `pivot.x`.
fn places(mechanism: &Mechanism, name: &str) -> Result<Vec<usize>, Failure> {
    let component = |axis: &str| COMPONENTS.contains(&axis);
    let whole = |full: &str| {
        let last = full.rsplit_once('.');
        full == name || last.is_some_and(|(of, last)| of == name && component(last))
    };
    let all = mechanism.parameters().iter().enumerate();
    let found: Vec<usize> = all
        .filter(|(_, parameter)| whole(parameter.name))
        .map(|(parameter_index, _)| parameter_index)
        .collect();
    if !found.is_empty() {
        return Ok(found);
    }
    // The dimensions of a machine are those of the part in question.
    let part = name.rsplit_once('.').map_or(name, |(part, _)| part);
    let names = mechanism
        .parameters()
        .iter()
        .map(|parameter| parameter.name);
    let of_part = |full: &&str| {
        full.strip_prefix(part)
            .is_some_and(|rest| rest.starts_with('.'))
    };
    let of_part: Vec<&str> = names.clone().filter(of_part).collect();
    Err(Failure::Told(format!(
        "there is no dimension `{}` in {}; there is {}",
        shortened(name),
        mechanism.name(),
        match of_part.is_empty() {
            true => known_names(name, names),
            false => known_names(name, of_part),
        }
    )))
}

/// `NAME=VALUE`
pub(super) fn parts<'a>(option: &str, given: &'a str) -> Result<(&'a str, &'a str), Failure> {
    let pair = given.split_once('=').map(|(a, b)| (a.trim(), b.trim()));
    let given = shortened(given);
    pair.ok_or_else(|| Failure::Told(format!("`{option} {given}`: write `{option} NAME=VALUE`")))
}

/// The value of one number, in its unit.
pub(super) fn number(
    mechanism: &Mechanism,
    name: &str,
    text: &str,
    unit: &str,
) -> Result<f64, Failure> {
    let Number { value, tolerance } = quantity(mechanism, name, text, &[unit])?[0];
    match tolerance {
        None => Ok(value),
        Some(_) => Err(wrong(name, text)(
            "only dimensions have tolerances, by `--set`",
        )),
    }
}

/// A number of the command line.
#[derive(Clone, Copy)]
struct Number {
    value: f64,
    /// The unit, if one is written.
    tolerance: Option<f64>,
}

/// The numbers that a text stands for, in these units. It is read as the value of a parameter.
fn quantity(
    mechanism: &Mechanism,
    name: &str,
    text: &str,
    units: &[&str],
) -> Result<Vec<Number>, Failure> {
    let wrong = wrong(name, text);
    if let Some(help) = decimal_comma(text) {
        return Err(wrong(&format!(
            "a comma stands between the components of a vector only\nhelp: {help}"
        )));
    }
    let length = mechanism.compiled().length;
    let tokens: Result<TokenStream, _> = text.parse();
    let tokens = tokens.map_err(|_| {
        wrong(
            "a bracket has no partner, or a character no meaning\nhelp: write a tolerance as `+-`",
        )
    })?;
    if let Some(word) = name_within(mechanism, tokens.clone()) {
        return Err(wrong(&format!(
            "`{}` of {} cannot be used here\nhelp: a value may use numbers with units, functions and constants only",
            shortened(&word),
            mechanism.name()
        )));
    }
    let last = name.rsplit_once('.').map_or(name, |(_, last)| last);
    let checked = check_value(last, tokens, length);
    if let Some(message) = checked.messages.first() {
        return Err(wrong(&message.text));
    }
    let unit = checked.unit.unwrap_or_default();
    let found: Vec<_> = unit.scalars().collect();
    // The sign of a tolerance is no operator elsewhere.
    let dense: String = text.split_whitespace().collect();
    let is_tolerated = ["+-", "+/-"].iter().any(|sign| dense.contains(sign));
    if found.len() != units.len() {
        let [found, wanted] = [found.len(), units.len()].map(|count| match count {
            1 => "one number".to_owned(),
            count => format!("a vector of {count} numbers"),
        });
        return Err(wrong(&format!(
            "this is {found}, `{}` is {wanted}",
            shortened(name)
        )));
    }
    let pairs = found.iter().zip(units);
    pairs
        .map(|(scalar, &unit)| {
            // A bare zero has every unit.
            let is_zero = scalar.nominal == 0.0 && scalar.tolerance == 0.0;
            match scalar.unit == unit || scalar.unit.is_empty() && is_zero {
                true => Ok(Number {
                    value: scalar.nominal,
                    tolerance: is_tolerated.then_some(scalar.tolerance),
                }),
                false => Err(wrong(&format!(
                    "this is {}, `{}` is {}{}",
                    in_words(&scalar.unit),
                    shortened(name),
                    in_words(unit),
                    help_with_unit(text, &scalar.unit, unit)
                ))),
            }
        })
        .collect()
}

/// Returns the help for a number with a decimal comma: one outside of brackets.
fn decimal_comma(text: &str) -> Option<String> {
    let outside = text.find('(').map_or(text, |bracket| &text[..bracket]);
    let (before, after) = outside.split_once(',')?;
    let is_digit = |letter: char| letter.is_ascii_digit();
    if !(before.ends_with(is_digit) && after.starts_with(is_digit)) {
        return None;
    }
    Some(match before.contains('.') || after.contains(',') {
        true => "write a point before the decimals, and nothing between thousands".to_owned(),
        false => format!("write `{}`", text.replacen(',', ".", 1)),
    })
}

/// Returns the message for an impossible value.
fn wrong(name: &str, text: &str) -> impl Fn(&str) -> Failure {
    let given = format!("{name}={text}");
    let given = shortened(&given).into_owned();
    move |why| Failure::Told(format!("`{given}`: {why}"))
}

/// Returns the help for a number whose unit is missing.
fn help_with_unit(text: &str, found: &str, wanted: &str) -> String {
    match (found, wanted, text.parse::<f64>()) {
        ("", "rad", Ok(_)) => {
            format!("\nhelp: write `{text}deg` for degrees, `{text}rad` for radians")
        }
        // A unit like `N/mm` is written in another way.
        ("", wanted, Ok(_)) if wanted.chars().all(char::is_alphabetic) => {
            format!("\nhelp: write `{text}{wanted}`")
        }
        _ => String::new(),
    }
}

fn in_words(unit: &str) -> String {
    match unit {
        "" => "a number".to_owned(),
        "rad" => "an angle, `30deg`".to_owned(),
        unit => format!("in {unit}"),
    }
}
