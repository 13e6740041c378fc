//! Euler's theorem on homogeneous functions: where every length is a parameter, an angle and its
//! derivatives do not change when all lengths grow alike, and a coordinate and its derivatives grow
//! with them: `sum r_i d(angle)/d r_i = 0`, `sum r_i d(x)/d r_i = x`.

use crate::{Components, ROUNDOFF};
use linkage::Parameter;

/// Asserts the identity for a quantity of the given degree in the lengths (0 or 1), to within
/// roundings of its terms.
pub fn homogeneous(
    parameters: &[Parameter],
    lengths: &[f64],
    value: &dyn Components,
    sensitivity: Vec<Vec<f64>>,
    degree: f64,
) {
    assert_eq!(sensitivity.len(), parameters.len());
    for (k, value) in value.components().into_iter().enumerate() {
        let terms = parameters.iter().zip(lengths).zip(&sensitivity);
        let terms = terms.filter(|((parameter, _), _)| parameter.unit == "mm");
        let terms: Vec<f64> = terms.map(|((_, length), by)| length * by[k]).collect();
        let sum: f64 = terms.iter().sum();
        let longest = lengths.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
        let least = if degree == 0.0 { 1.0 } else { longest };
        let size: f64 = least + terms.iter().map(|term| term.abs()).sum::<f64>();
        let miss = (sum - degree * value).abs();
        let allowed = 100.0 * ROUNDOFF * (size + value.abs());
        assert!(miss <= allowed, "{miss:e} > {allowed:e}: {value} {terms:?}");
    }
}

/// A test over random geometries, each dimension within 3 % of the one written, and random inputs.
///
/// Every mechanism has functions `values`, `rates` and `seconds`, where each field `q` stands
/// beside `q_by`, its sensitivities.
#[macro_export]
macro_rules! identities {
    (
        $test:ident, $mechanism:ident, $input:ident,
        angles [$($angle:ident $angle_by:ident),*], lengths [$($length:ident $length_by:ident),*],
        $random:ident => $fields:expr, $at:expr, $order:expr
    ) => {
        #[test]
        fn $test() {
            let mut generator = $crate::Random::new(81);
            for _ in 0..200 {
                let $random = &mut generator;
                let mechanism: $mechanism = $fields;
                let order: fn(&$mechanism) -> Vec<f64> = $order;
                let lengths = order(&mechanism);
                let linkage = mechanism.assemble().expect("closes");
                let $input = $at;
                let parameters = $mechanism::PARAMETERS;
                let (v, r) = (linkage.values($input), linkage.rates($input));
                let s = linkage.seconds($input);
                $(
                    $crate::homogeneous(parameters, &lengths, &v.$angle, $crate::rows(&v.$angle_by), 0.0);
                    $crate::homogeneous(parameters, &lengths, &r.$angle, $crate::rows(&r.$angle_by), 0.0);
                    $crate::homogeneous(parameters, &lengths, &s.$angle, $crate::rows(&s.$angle_by), 0.0);
                )*
                $(
                    $crate::homogeneous(parameters, &lengths, &v.$length, $crate::rows(&v.$length_by), 1.0);
                    $crate::homogeneous(parameters, &lengths, &r.$length, $crate::rows(&r.$length_by), 1.0);
                    $crate::homogeneous(parameters, &lengths, &s.$length, $crate::rows(&s.$length_by), 1.0);
                )*
            }
        }
    };
}
