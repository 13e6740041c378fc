//! Writes a test program around the items of a mechanism.

/// One written form of a mechanism, as a module with a function `assemble` for
/// [`Form`](crate::Form).
///
/// The outputs are names of scalars or vectors; every form of one system has the same, in the same
/// order. The fields are an expression for the mechanism's value from a slice `g` of all data but
/// the input.
#[macro_export]
macro_rules! form {
    (
        $(#[$doc:meta])*
        $name:ident($input:ident) -> [$($out:ident),+ $(,)?];
        pairs $a:ident $b:ident, $c:ident $d:ident;
        fields |$g:ident| { $($fields:tt)* }
        { $($items:tt)* }
    ) => {
        $(#[$doc])*
        mod $name {
            linkage::mechanism! {
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

            pub(super) fn assemble($g: &[f64]) -> Result<linkage_accuracy::Evaluate, String> {
                let mechanism = Mechanism { $($fields)* };
                let linkage = mechanism.assemble().map_err(|why| why.to_string())?;
                Ok(Box::new(move |input| {
                    let values = linkage.values(input);
                    let first = linkage.first(input);
                    let second = linkage.second(input);
                    let third = linkage.third(input);
                    let sensitivity = linkage.sensitivities(input);
                    let mixed = linkage.mixed(input);
                    let mixed_second = linkage.mixed_second(input);
                    let (one, two) = (linkage.pair_one(input), linkage.pair_two(input));
                    linkage_accuracy::Answers {
                        values: $crate::concatenate(&[$(&values.$out),+]),
                        margin: values.margin,
                        first: $crate::concatenate(&[$(&first.$out),+]),
                        second: $crate::concatenate(&[$(&second.$out),+]),
                        third: $crate::concatenate(&[$(&third.$out),+]),
                        sensitivity: $crate::by_column(&[$($crate::rows(&sensitivity.$out)),+]),
                        mixed: $crate::by_column(&[$($crate::rows(&mixed.$out)),+]),
                        mixed_second: $crate::by_column(&[$($crate::rows(&mixed_second.$out)),+]),
                        pairs: vec![
                            $crate::concatenate(&[$(&one.$out),+]),
                            $crate::concatenate(&[$(&two.$out),+]),
                        ],
                    }
                }))
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
