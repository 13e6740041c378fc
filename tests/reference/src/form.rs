//! Writes a test program around the items of a mechanism.

/// One written form of a mechanism, as a module with a function `assemble` for
/// [`Form`](crate::Form).
///
/// The outputs are names of scalars or vectors; every form of one system has the same, in the same
/// order. The fields are an expression for the mechanism's value from a slice `g` of all data but
/// the input. Without `pairs` the program has no derivatives beyond those of
/// [`Depth::Usual`](crate::Depth::Usual).
#[macro_export]
macro_rules! form {
    (
        @module $name:ident [$($out:ident),+]
        |$g:ident| { $($fields:tt)* }
        { $($mechanism:tt)* }
        |$linkage:ident, $input:ident, $answers:ident| $further:block
    ) => {
        mod $name {
            linkage::mechanism! { $($mechanism)* }

            pub(super) fn assemble(
                $g: &[f64],
                variant: linkage_reference::Variant,
            ) -> Result<linkage_reference::Evaluate, String> {
                let mechanism = Mechanism { $($fields)* };
                if variant.fused {
                    evaluate(&mechanism.cast::<linkage_reference::Fused>(), variant.flipped)
                } else {
                    evaluate(&mechanism, variant.flipped)
                }
            }

            fn evaluate<T: linkage::Scalar + linkage_reference::Components>(
                mechanism: &Mechanism<T>,
                flipped: bool,
            ) -> Result<linkage_reference::Evaluate, String> {
                let $linkage = if flipped {
                    // The default mechanism closes: its modes are those of the estimates.
                    let usual = Mechanism::default().assemble().map_err(|why| why.to_string())?;
                    let found = mechanism.assemblies().map_err(|why| why.to_string())?;
                    let other = found.into_iter().find(|other| other.modes() != usual.modes());
                    other.ok_or("no assembly in the other mode")?
                } else {
                    mechanism.assemble().map_err(|why| why.to_string())?
                };
                Ok(Box::new(move |input| {
                    let $input = T::from_f64(input);
                    let values = $linkage.values($input);
                    let first = $linkage.first($input);
                    let second = $linkage.second($input);
                    let sensitivity = $linkage.sensitivities($input);
                    let mut $answers = linkage_reference::Answers {
                        values: $crate::concatenate(&[$(&values.$out),+]),
                        margin: values.margin.lane(0),
                        first: $crate::concatenate(&[$(&first.$out),+]),
                        second: $crate::concatenate(&[$(&second.$out),+]),
                        sensitivity: $crate::by_column(&[$($crate::rows(&sensitivity.$out)),+]),
                        ..linkage_reference::Answers::default()
                    };
                    $further
                    $answers
                }))
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
            @module $name [$($out),+]
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
            |linkage, input, answers| {
                let third = linkage.third(input);
                let (mixed, mixed_second) = (linkage.mixed(input), linkage.mixed_second(input));
                let (one, two) = (linkage.pair_one(input), linkage.pair_two(input));
                answers.third = $crate::concatenate(&[$(&third.$out),+]);
                answers.mixed = $crate::by_column(&[$($crate::rows(&mixed.$out)),+]);
                answers.mixed_second =
                    $crate::by_column(&[$($crate::rows(&mixed_second.$out)),+]);
                answers.pairs = vec![
                    $crate::concatenate(&[$(&one.$out),+]),
                    $crate::concatenate(&[$(&two.$out),+]),
                ];
            }
        }
    };
    (
        $name:ident($input:ident) -> [$($out:ident),+ $(,)?];
        fields |$g:ident| { $($fields:tt)* }
        { $($items:tt)* }
    ) => {
        $crate::form! {
            @module $name [$($out),+]
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
            |linkage, input, answers| {}
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
