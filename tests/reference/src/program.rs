//! The text of a mechanism, compiled by the engine, as a written form.

use crate::{Answers, Evaluate, Variant};
use linkage_engine::{Assembly, Mechanism};
use std::sync::OnceLock;

/// The number of a scalar parameter, or those of a vector.
pub trait Values {
    /// The numbers in order.
    fn values(&self) -> Vec<f64>;
}

impl Values for f64 {
    fn values(&self) -> Vec<f64> {
        vec![*self]
    }
}

impl<const N: usize> Values for [f64; N] {
    fn values(&self) -> Vec<f64> {
        self.to_vec()
    }
}

/// The parameters of a mechanism with their values, by name.
pub type Parameters = Vec<(&'static str, Vec<f64>)>;

/// A mechanism that is compiled when it is first needed, for each rounding of multiply-adds.
pub struct Program {
    text: &'static str,
    parameters: fn(&[f64]) -> Parameters,
    generated: OnceLock<Mechanism>,
    fused: OnceLock<Mechanism>,
}

impl Program {
    /// A mechanism from its text, and its parameters for a geometry.
    pub const fn new(text: &'static str, parameters: fn(&[f64]) -> Parameters) -> Self {
        Self {
            text,
            parameters,
            generated: OnceLock::new(),
            fused: OnceLock::new(),
        }
    }

    /// Assembles the mechanism for a geometry.
    ///
    /// # Errors
    ///
    /// The text of the error, if it does not assemble.
    pub fn assemble(&'static self, geometry: &[f64], variant: Variant) -> Result<Evaluate, String> {
        let mechanism = self.mechanism(variant.fused);
        let dimensions = dimensions(mechanism, &(self.parameters)(geometry));
        let assembly = assemble(mechanism, &dimensions, variant.flipped)?;
        let functions = Functions::new(mechanism);
        Ok(Box::new(move |input| functions.answers(&assembly, input)))
    }

    fn mechanism(&self, fused: bool) -> &Mechanism {
        let generated = || {
            let compiled = || Mechanism::compile(self.text);
            self.generated
                .get_or_init(|| compiled().unwrap_or_else(|error| panic!("{error}")))
        };
        match fused {
            false => generated(),
            true => self
                .fused
                .get_or_init(|| generated().clone().with_fused_multiply_adds()),
        }
    }
}

/// The dimensions of a mechanism, in its order.
///
/// # Panics
///
/// If a parameter has no value, or a value no parameter.
fn dimensions(mechanism: &Mechanism, parameters: &Parameters) -> Vec<f64> {
    let names = parameters.iter().flat_map(|(name, values)| {
        let components = ["x", "y", "z"].map(|component| format!("{name}.{component}"));
        match values.len() {
            1 => vec![(*name).to_owned()],
            count => components[..count].to_vec(),
        }
    });
    let names: Vec<String> = names.collect();
    let values: Vec<f64> = parameters.iter().flat_map(|(_, v)| v.clone()).collect();
    assert_eq!(names.len(), mechanism.parameters().len(), "{names:?}");
    let value = |name: &str| {
        let place = names.iter().position(|own| own == name);
        values[place.unwrap_or_else(|| panic!("`{name}` has no value"))]
    };
    mechanism
        .parameters()
        .iter()
        .map(|own| value(own.name))
        .collect()
}

fn assemble<'m>(
    mechanism: &'m Mechanism,
    dimensions: &[f64],
    flipped: bool,
) -> Result<Assembly<'m>, String> {
    if !flipped {
        return mechanism
            .assemble(dimensions)
            .map_err(|why| why.to_string());
    }
    // The default mechanism closes: its modes are those of the estimates.
    let usual = mechanism.assemble(&mechanism.dimensions());
    let usual = usual.map_err(|why| why.to_string())?;
    let all = mechanism.assemblies(dimensions, &mechanism.reference());
    let all = all.map_err(|why| why.to_string())?;
    let other = all.into_iter().find(|other| other.modes() != usual.modes());
    other.ok_or_else(|| "no assembly in the other mode".to_owned())
}

/// The functions of a form, by their numbers.
struct Functions {
    /// The numbers of each output: one, or the components of a vector.
    widths: Vec<usize>,
    values: usize,
    first: usize,
    second: usize,
    sensitivities: usize,
    further: Option<Further>,
}

/// The functions beyond those of [`Depth::Usual`](crate::Depth::Usual).
struct Further {
    third: usize,
    mixed: usize,
    mixed_second: usize,
    pairs: [usize; 2],
}

impl Functions {
    fn new(mechanism: &Mechanism) -> Self {
        let number = |name| mechanism.function(name).map_err(|error| error.to_string());
        let found = |name| number(name).unwrap_or_else(|error| panic!("{error}"));
        let values = found("values");
        let fields = &mechanism.compiled().functions[values].fields;
        let (margin, outputs) = fields.split_last().expect("a margin");
        assert_eq!(margin.name, "margin");
        Self {
            widths: outputs.iter().map(|own| own.shape.width()).collect(),
            values,
            first: found("first"),
            second: found("second"),
            sensitivities: found("sensitivities"),
            further: number("third").ok().map(|third| Further {
                third,
                mixed: found("mixed"),
                mixed_second: found("mixed_second"),
                pairs: [found("pair_one"), found("pair_two")],
            }),
        }
    }

    fn answers(&self, assembly: &Assembly<'_>, input: f64) -> Answers {
        let call = |function| assembly.call(function, &[input]);
        let by_parameter = |function| self.by_parameter(&call(function));
        let mut values = call(self.values);
        let margin = values.pop().expect("a margin");
        let answers = Answers {
            values,
            margin,
            first: call(self.first),
            second: call(self.second),
            sensitivity: by_parameter(self.sensitivities),
            ..Answers::default()
        };
        match &self.further {
            None => answers,
            Some(further) => Answers {
                third: call(further.third),
                mixed: by_parameter(further.mixed),
                mixed_second: by_parameter(further.mixed_second),
                pairs: further.pairs.map(call).to_vec(),
                ..answers
            },
        }
    }

    /// For each parameter the derivatives of all outputs, from one array for each output.
    fn by_parameter(&self, row: &[f64]) -> Vec<Vec<f64>> {
        let parameters = row.len() / self.widths.iter().sum::<usize>();
        let mut derivatives = vec![Vec::new(); parameters];
        let mut rest = row;
        for &width in &self.widths {
            let (array, others) = rest.split_at(width * parameters);
            rest = others;
            for (all, entry) in derivatives.iter_mut().zip(array.chunks(width)) {
                all.extend_from_slice(entry);
            }
        }
        derivatives
    }
}

// Writes the text of a test mechanism around its items.

/// One written form of a mechanism, as a module with a function `assemble` for
/// [`Form`](crate::Form). The engine compiles it when it is first assembled.
///
/// The outputs are names of scalars or vectors; every form of one system has the same, in the same
/// order. The fields are the values of the mechanism's parameters from a slice `g` of all data but
/// the input. Without `pairs` the program has no derivatives beyond those of
/// [`Depth::Usual`](crate::Depth::Usual).
#[macro_export]
macro_rules! form {
    (
        @module $name:ident
        |$g:ident| { $($field:ident: $value:expr),* $(,)? }
        { $($mechanism:tt)* }
    ) => {
        mod $name {
            static PROGRAM: $crate::Program = $crate::Program::new(
                stringify!($($mechanism)*),
                |$g| vec![$((stringify!($field), $crate::Values::values(&$value))),*],
            );

            pub(super) fn assemble(
                geometry: &[f64],
                variant: $crate::Variant,
            ) -> Result<$crate::Evaluate, String> {
                PROGRAM.assemble(geometry, variant)
            }
        }
    };
    (
        $name:ident($input:ident) -> [$($out:ident),+ $(,)?];
        pairs $a:ident $b:ident, $c:ident $d:ident;
        fields |$g:ident| { $($fields:tt)* }
        { $($items:tt)* }
    ) => {
        $crate::form! {
            @module $name
            |$g| { $($fields)* }
            {
                pub struct Mechanism { $($items)* }

                impl Mechanism {
                    pub fn values($input) -> Values { $($out,)+ margin: margin() }
                    pub fn first($input) -> First { $($out: velocity($out)),+ }
                    pub fn second($input) -> Second { $($out: acceleration($out)),+ }
                    pub fn third($input) -> Third { $($out: jerk($out)),+ }
                    pub fn sensitivities($input) -> Sensitivities { $($out: sensitivity($out)),+ }
                    pub fn mixed($input) -> Mixed { $($out: sensitivity(velocity($out))),+ }
                    pub fn mixed_second($input) -> MixedSecond {
                        $($out: sensitivity(acceleration($out))),+
                    }
                    pub fn pair_one($input) -> PairOne { $($out: d($out, $a, $b)),+ }
                    pub fn pair_two($input) -> PairTwo { $($out: d($out, $c, $d)),+ }
                }
            }
        }
    };
    (
        $name:ident($input:ident) -> [$($out:ident),+ $(,)?];
        fields |$g:ident| { $($fields:tt)* }
        { $($items:tt)* }
    ) => {
        $crate::form! {
            @module $name
            |$g| { $($fields)* }
            {
                pub struct Mechanism { $($items)* }

                impl Mechanism {
                    pub fn values($input) -> Values { $($out,)+ margin: margin() }
                    pub fn first($input) -> First { $($out: velocity($out)),+ }
                    pub fn second($input) -> Second { $($out: acceleration($out)),+ }
                    pub fn sensitivities($input) -> Sensitivities { $($out: sensitivity($out)),+ }
                }
            }
        }
    };
}

/// The forms with the given module names, those after `where` only for geometries that satisfy a
/// condition.
#[macro_export]
macro_rules! forms {
    ($($name:ident),* $(,)? $(; where $fits:expr => $($other:ident),+ $(,)?)?) => {
        &[
            $($crate::Form { name: stringify!($name), assemble: $name::assemble, fits: |_| true },)*
            $($($crate::Form {
                name: stringify!($other),
                assemble: $other::assemble,
                fits: $fits,
            },)+)?
        ]
    };
}
