//! Euler's theorem on homogeneous functions: where every length is a parameter, an angle and its
//! derivatives do not change when all lengths grow alike, and a coordinate and its derivatives grow
//! with them: `sum r_i d(angle)/d r_i = 0`, `sum r_i d(x)/d r_i = x`.

use linkage_engine::{Mechanism, Parameter};

use crate::{ROUNDOFF, Random};

/// Asserts the identities of a mechanism's quantities, over random geometries and inputs.
///
/// Its functions `values`, `rates` and `seconds` have two fields for each quantity: the quantity,
/// and its sensitivities. Quantities after the first `angles` are lengths.
pub fn homogeneous(
    text: &str,
    angles: usize,
    geometry: fn(&mut Random) -> Vec<f64>,
) -> Result<(), Box<dyn std::error::Error>> {
    let mechanism = Mechanism::compile(text)?;
    let mut random = Random::new(81);
    for _ in 0..200 {
        let dimensions = geometry(&mut random);
        let assembly = mechanism.assemble(&dimensions)?;
        let at = random.angle();
        for name in ["values", "rates", "seconds"] {
            let function = mechanism.function(name)?;
            let mut row = &assembly.call(function, &[at])[..];
            let fields = &mechanism.compiled().functions[function].fields;
            for (number, field) in fields.iter().step_by(2).enumerate() {
                let (quantity, rest) = row.split_at(field.shape.width());
                let (by, rest) = rest.split_at(quantity.len() * dimensions.len());
                row = rest;
                let degree = if number < angles { 0.0 } else { 1.0 };
                check(mechanism.parameters(), &dimensions, quantity, by, degree);
            }
            assert!(row.is_empty(), "{name}");
        }
    }
    Ok(())
}

/// Asserts the identity for a quantity of the given degree in the lengths (0 or 1), to within
/// roundings of its terms. Its derivatives come parameter by parameter.
fn check(
    parameters: &[Parameter],
    dimensions: &[f64],
    quantity: &[f64],
    derivatives: &[f64],
    degree: f64,
) {
    for (k, value) in quantity.iter().enumerate() {
        let by = derivatives.chunks(quantity.len());
        let terms = parameters.iter().zip(dimensions).zip(by);
        let terms = terms.filter(|((parameter, _), _)| parameter.unit == "mm");
        let terms: Vec<f64> = terms.map(|((_, length), by)| length * by[k]).collect();
        let sum: f64 = terms.iter().sum();
        let longest = dimensions.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
        let least = if degree == 0.0 { 1.0 } else { longest };
        let size: f64 = least + terms.iter().map(|term| term.abs()).sum::<f64>();
        let miss = (sum - degree * value).abs();
        let allowed = 100.0 * ROUNDOFF * (size + value.abs());
        assert!(miss <= allowed, "{miss:e} > {allowed:e}: {value} {terms:?}");
    }
}

/// A test of the identities of a mechanism: each angle and each length with a name for its
/// sensitivities, a random geometry in the order of the parameters, and the mechanism's items.
#[macro_export]
macro_rules! identities {
    (
        $test:ident($input:ident), angles [$($angle:ident $angle_by:ident),*],
        lengths [$($length:ident $length_by:ident),*], $geometry:expr,
        { $($items:tt)* }
    ) => {
        #[test]
        fn $test() -> Result<(), Box<dyn std::error::Error>> {
            let text = stringify! {
                pub struct Mechanism { $($items)* }

                impl Mechanism {
                    pub fn values($input) -> Values {
                        $($angle, $angle_by: sensitivity($angle),)*
                        $($length, $length_by: sensitivity($length),)*
                    }
                    pub fn rates($input) -> Rates {
                        $($angle: velocity($angle), $angle_by: sensitivity(velocity($angle)),)*
                        $($length: velocity($length), $length_by: sensitivity(velocity($length)),)*
                    }
                    pub fn seconds($input) -> Seconds {
                        $(
                            $angle: acceleration($angle),
                            $angle_by: sensitivity(acceleration($angle)),
                        )*
                        $(
                            $length: acceleration($length),
                            $length_by: sensitivity(acceleration($length)),
                        )*
                    }
                }
            };
            let angles: &[&str] = &[$(stringify!($angle)),*];
            $crate::homogeneous(text, angles.len(), $geometry)
        }
    };
}
