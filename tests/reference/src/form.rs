//! Writes the text of a test mechanism around its items.

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
