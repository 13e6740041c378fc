//! Values on the command line: numbers with units, as in a mechanism.

use clap::Args;
use linkage_compiler::check;
use linkage_compiler::unit::COMPONENTS;

use crate::failure::{Failure, listed};
use crate::mechanism::Mechanism;

/// Dimensions other than those of the file.
#[derive(Debug, Args)]
pub(super) struct Dimensions {
    /// A dimension, as `crank=51mm` or `pivot=(140mm, 0mm)`; may be given several times
    #[arg(long = "set", value_name = "NAME=VALUE")]
    set: Vec<String>,
}

impl Dimensions {
    /// Whether there are other dimensions than those of the file.
    pub(super) fn are_given(&self) -> bool {
        !self.set.is_empty()
    }

    /// The options as they are written.
    pub(super) fn options(&self) -> String {
        let options: Vec<String> = self.set.iter().map(|own| format!("--set {own}")).collect();
        options.join(" ")
    }

    /// Those of the options whose dimension a mechanism has.
    pub(super) fn known_to(&self, mechanism: &Mechanism) -> Self {
        let known = |given: &&String| {
            let own = parts("--set", given);
            own.is_ok_and(|(name, _)| places(mechanism, name).is_ok())
        };
        Self {
            set: self.set.iter().filter(known).cloned().collect(),
        }
    }

    /// Fails at the first option that none of the mechanisms knows.
    pub(super) fn known_to_any(&self, all: &[Mechanism]) -> Result<(), Failure> {
        for given in &self.set {
            let (name, _) = parts("--set", given)?;
            let mut found = all.iter().map(|own| places(own, name));
            if let Some(Err(unknown)) = found.next()
                && found.all(|own| own.is_err())
            {
                return Err(unknown);
            }
        }
        Ok(())
    }

    /// All dimensions of the mechanism, in the order of its parameters.
    pub(super) fn of(&self, mechanism: &Mechanism) -> Result<Vec<f64>, Failure> {
        let mut values = mechanism.dimensions();
        for given in &self.set {
            let (name, text) = parts("--set", given)?;
            let places = places(mechanism, name)?;
            let units = places.iter().map(|&place| mechanism.parameters[place].unit);
            let units: Vec<&str> = units.collect();
            let numbers = quantity(mechanism, name, text, &units)?;
            for (place, number) in places.into_iter().zip(numbers) {
                values[place] = number;
            }
        }
        Ok(values)
    }
}

/// The scalars of a parameter, or one of them: `pivot`, `pivot.x`.
fn places(mechanism: &Mechanism, name: &str) -> Result<Vec<usize>, Failure> {
    let component = |own: &str| COMPONENTS.contains(&own);
    let whole = |own: &str| {
        let last = own.rsplit_once('.');
        own == name || last.is_some_and(|(of, last)| of == name && component(last))
    };
    let all = mechanism.parameters.iter().enumerate();
    let found: Vec<usize> = all
        .filter(|(_, own)| whole(own.name))
        .map(|(place, _)| place)
        .collect();
    if !found.is_empty() {
        return Ok(found);
    }
    // Of a machine, the dimensions of the part that is meant.
    let part = name.rsplit_once('.').map_or(name, |(part, _)| part);
    let names = mechanism.parameters.iter().map(|own| own.name);
    let of_part = |own: &&str| {
        own.strip_prefix(part)
            .is_some_and(|rest| rest.starts_with('.'))
    };
    let of_part: Vec<&str> = names.clone().filter(of_part).collect();
    Err(Failure::Told(format!(
        "there is no dimension `{name}` in {}; there is {}",
        mechanism.name,
        match of_part.is_empty() {
            true => listed(names),
            false => listed(of_part),
        }
    )))
}

/// `NAME=VALUE`
pub(super) fn parts<'a>(option: &str, given: &'a str) -> Result<(&'a str, &'a str), Failure> {
    let pair = given.split_once('=').map(|(a, b)| (a.trim(), b.trim()));
    pair.ok_or_else(|| Failure::Told(format!("`{option} {given}`: write `{option} NAME=VALUE`")))
}

/// The value of one number, in its unit.
pub(super) fn number(
    mechanism: &Mechanism,
    name: &str,
    text: &str,
    unit: &str,
) -> Result<f64, Failure> {
    Ok(quantity(mechanism, name, text, &[unit])?[0])
}

/// The numbers that a text stands for, in these units. It is read as the value of a parameter.
fn quantity(
    mechanism: &Mechanism,
    name: &str,
    text: &str,
    units: &[&str],
) -> Result<Vec<f64>, Failure> {
    let wrong = |why: &str| Failure::Told(format!("`{name}={text}`: {why}"));
    let length = mechanism.unit.length;
    let declaration = format!("struct Value {{ unit {length}; param value = ({text}); }}");
    let tokens = declaration.parse();
    let tokens =
        tokens.map_err(|_| wrong("a bracket has no partner, or a character no meaning"))?;
    let checked = check(tokens);
    if let Some(message) = checked.messages.first() {
        return Err(wrong(&message.text));
    }
    let unit = checked.unit.unwrap_or_default();
    let found: Vec<_> = unit.scalars().collect();
    if found.len() != units.len() {
        let [found, wanted] = [found.len(), units.len()].map(|count| match count {
            1 => "one number".to_owned(),
            count => format!("a vector of {count} numbers"),
        });
        return Err(wrong(&format!("this is {found}, `{name}` is {wanted}")));
    }
    let pairs = found.iter().zip(units);
    pairs
        .map(
            |(own, &unit)| match own.unit == unit || own.nominal == 0.0 {
                true => Ok(own.nominal),
                false => Err(wrong(&format!(
                    "this is {}, `{name}` is {}",
                    in_words(&own.unit),
                    in_words(unit)
                ))),
            },
        )
        .collect()
}

fn in_words(unit: &str) -> String {
    match unit {
        "" => "a number".to_owned(),
        "rad" => "an angle, `30deg`".to_owned(),
        unit => format!("in {unit}"),
    }
}
