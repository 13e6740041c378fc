//! Positions, quantities and loops in the words of a message.

use linkage_core::range_check::{self, significant};

use crate::model::{Dimension, Mechanism, Type};

/// Prints quantities of one mechanism.
pub(crate) struct MessageFormat<'m> {
    mechanism: &'m Mechanism,
}

impl<'m> MessageFormat<'m> {
    pub(crate) fn new(mechanism: &'m Mechanism) -> Self {
        Self { mechanism }
    }

    pub(crate) fn mechanism(&self) -> &'m Mechanism {
        self.mechanism
    }

    /// `theta`, `psi` in back-ticks.
    pub(crate) fn unknowns(&self, unknowns: &[usize]) -> String {
        let name = |&k: &usize| format!("`{}`", self.mechanism.unknowns[k].name);
        unknowns.iter().map(name).collect::<Vec<_>>().join(", ")
    }

    /// Returns the joints and links that loops stand for, or the numbers of loops.
    pub(crate) fn loops(&self, loops: &[usize]) -> String {
        loop_names(self.mechanism, loops)
    }

    /// `phi = 30deg, s = 12mm` for the inputs `among` all.
    pub(crate) fn inputs(&self, values: &[f64], among: &[usize]) -> String {
        let word = |&k: &usize| {
            let input = &self.mechanism.inputs[k];
            format!(
                "`{} = {}`",
                input.name,
                self.scalar(input.dimension, values[k])
            )
        };
        among.iter().map(word).collect::<Vec<_>>().join(", ")
    }

    /// ` at the reference input phi = 30deg`; nothing for a structure.
    pub(crate) fn at_reference(&self, values: &[f64]) -> String {
        match values {
            [] => String::new(),
            _ => {
                let inputs: Vec<usize> = (0..values.len()).collect();
                format!(" at the reference input {}", self.inputs(values, &inputs))
            }
        }
    }

    pub(crate) fn unknown_value(&self, unknown: usize, value: &[f64]) -> String {
        let item = &self.mechanism.unknowns[unknown];
        format!("{} = {}", item.name, self.coordinate(&item.ty, value))
    }

    /// `60deg`, `(10mm, 0mm)`: of an unknown, which is an angle where it is no length.
    pub(crate) fn coordinate(&self, ty: &Type, value: &[f64]) -> String {
        match (ty, value) {
            (Type::Scalar(dimension), [x]) => self.scalar(*dimension, *x),
            (ty, components) => self.vector(ty, components),
        }
    }

    /// Prints `60deg`, `(10mm, 0mm)`: a value in the unit of its type. A value that is not known to
    /// be an angle is a number.
    pub(crate) fn value(&self, ty: &Type, value: &[f64]) -> String {
        let dimension = ty.dimension().unwrap_or(Dimension::NUMBER);
        let of_length = dimension.fits(Dimension::LENGTH);
        match value {
            [x] if dimension.angle || of_length => self.scalar(dimension, *x),
            [x] => format!("{}{}", significant(*x), dimension.unit(self.mechanism.unit)),
            components => self.vector(ty, components),
        }
    }

    /// `(10mm, 0mm, 0mm)`, `(0, 0, 1)`
    pub(crate) fn vector(&self, ty: &Type, components: &[f64]) -> String {
        let dimension = ty.dimension().unwrap_or(Dimension::NUMBER);
        let parts: Vec<String> = match dimension {
            Dimension::NUMBER => numbers(components),
            _ => without_noise(components)
                .map(|x| self.scalar(dimension, x))
                .collect(),
        };
        format!("({})", parts.join(", "))
    }

    /// Prints the digits that matter for the distance between two things.
    pub(crate) fn rounded(&self, dimension: Dimension, x: f64) -> String {
        let shown = match dimension.half_lengths {
            0 => x.to_degrees(),
            _ => x,
        };
        let digits = (2 - shown.abs().log10().floor() as i32).clamp(0, 17) as usize;
        let text = format!("{shown:.digits$}");
        let rounded = text.parse().unwrap_or(shown);
        match dimension.half_lengths {
            0 => format!("{}deg", significant(rounded)),
            _ => self.scalar(dimension, rounded),
        }
    }

    /// Prints a multiple of `step`, without further digits.
    pub(crate) fn rounded_to(&self, dimension: Dimension, x: f64, step: f64) -> String {
        range_check::rounded_to(x, step, dimension.half_lengths == 0, self.suffix(dimension))
    }

    /// Prints as [`scalar`](Self::scalar) does, with more digits if the text would be equal to that
    /// of the other number.
    pub(crate) fn distinguished(&self, dimension: Dimension, x: f64, other: f64) -> String {
        let short = self.scalar(dimension, x);
        if x == other || short != self.scalar(dimension, other) {
            return short;
        }
        let (unit, [shown, beside]) = match dimension.half_lengths {
            0 => ("deg".to_owned(), [x, other].map(f64::to_degrees)),
            _ => (dimension.unit(self.mechanism.unit), [x, other]),
        };
        let rounded = |x: f64, decimals: usize| format!("{x:.decimals$e}").parse().unwrap_or(x);
        // More than 17 digits add nothing.
        let mut lengths = 7..17;
        let differs = |decimals: &usize| rounded(shown, *decimals) != rounded(beside, *decimals);
        let enough = lengths
            .find(differs)
            .map_or(shown, |decimals| rounded(shown, decimals));
        format!("{enough}{unit}")
    }

    pub(crate) fn scalar(&self, dimension: Dimension, x: f64) -> String {
        range_check::position_as_written(x, dimension.half_lengths == 0, self.suffix(dimension))
    }

    /// The unit of a length; nothing for other scalars.
    fn suffix(&self, dimension: Dimension) -> &'static str {
        match dimension.half_lengths {
            2 => self.mechanism.unit.name(),
            _ => "",
        }
    }
}

/// Components below this share of the largest one are roundoff.
const NOISE: f64 = 1e-12;

/// Components of a vector.
pub(crate) fn numbers(components: &[f64]) -> Vec<String> {
    without_noise(components).map(significant).collect()
}

/// Components that are nothing but roundoff of the largest one become 0.
fn without_noise(components: &[f64]) -> impl Iterator<Item = f64> {
    let largest = components.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
    components
        .iter()
        .map(move |&x| if x.abs() <= NOISE * largest { 0.0 } else { x })
}

/// Returns the joints and links that loops stand for, ``joint `c` of `rocker` ``, and the numbers of
/// those that are written as loops, `loops 2 and 3`.
pub(crate) fn loop_names<'a>(
    mechanism: &Mechanism,
    loops: impl IntoIterator<Item = &'a usize>,
) -> String {
    let numbers = loop_numbers(loops);
    let of = |number: usize| mechanism.loops[number - 1].of.as_ref();
    let linked = numbers.iter().filter_map(|number| of(*number));
    let mut names: Vec<String> = linked.map(ToString::to_string).collect();
    names.dedup();
    let written: Vec<usize> = numbers
        .into_iter()
        .filter(|number| of(*number).is_none())
        .collect();
    if names.is_empty() || !written.is_empty() {
        names.push(range_check::loop_list(&written));
    }
    range_check::listed(&names)
}

/// Returns the joints and links that loops stand for, with the numbers of those among them that are
/// written as loops. Returns nothing if all of them are.
pub(crate) fn joint_names(mechanism: &Mechanism, loops: &[usize]) -> String {
    let mut linked = loops.iter().map(|&index| &mechanism.loops[index].of);
    match linked.any(Option::is_some) {
        true => loop_names(mechanism, loops),
        false => String::new(),
    }
}

/// The numbers of loops as they are printed: the first loop of the mechanism is 1.
pub(crate) fn loop_numbers<'a>(loops: impl IntoIterator<Item = &'a usize>) -> Vec<usize> {
    let mut numbers: Vec<usize> = loops.into_iter().map(|k| k + 1).collect();
    numbers.sort_unstable();
    numbers.dedup();
    numbers
}
