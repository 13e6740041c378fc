//! The items of a function of inputs that are the same for all functions, except for their names.

/// Lets the columns of a function be those of the runtime; nothing without feature `alloc`.
#[cfg(feature = "alloc")]
#[doc(hidden)]
#[macro_export]
macro_rules! columns {
    ($columns:ident of [$result:ident; $width:literal]) => {
        #[automatically_derived]
        impl<T> ::core::default::Default for $columns<T> {
            fn default() -> Self {
                Self(::core::default::Default::default())
            }
        }
        #[automatically_derived]
        impl<T> ::core::ops::Deref for $columns<T> {
            type Target = $crate::__private::ResultColumns<T, $result<T>, $width>;

            fn deref(&self) -> &Self::Target {
                &self.0
            }
        }
    };
}

/// Lets the columns of a function be those of the runtime; nothing without feature `alloc`.
#[cfg(not(feature = "alloc"))]
#[doc(hidden)]
#[macro_export]
macro_rules! columns {
    ($($token:tt)*) => {};
}

/// The methods that sweep a function over its inputs; nothing without feature `alloc`. The module
/// behind `by` has the functions that they call. Lists are those of their names, and of the
/// arguments that no input has.
#[cfg(feature = "alloc")]
#[doc(hidden)]
#[macro_export]
macro_rules! sweeps {
    (
        ($visibility:vis fn) $function:literal ($($argument:ident),*)
        -> $columns:ident of [$result:ident; $width:literal] by $($by:ident)::+,
        [$sweep:ident, $into:ident, $slices:ident, $parallel_into:ident],
        [$columns_argument:ident, $slices_argument:ident]
    ) => {
        #[doc = concat!(" `", $function, "` at many positions: see [sweeps](Self#sweeps).")]
        #[must_use]
        $visibility fn $sweep(&self, $($argument: &[T]),*) -> $columns<T> {
            $columns($($by)::+::sweep(&self.__sealed, [$($argument),*]))
        }

        #[doc = concat!(
            " `", $function, "` at many positions, into columns that are there: see [sweeps](Self#sweeps)."
        )]
        $visibility fn $into(&self, $($argument: &[T],)* $columns_argument: &mut $columns<T>) {
            $($by)::+::sweep_into(
                &self.__sealed,
                [$($argument),*],
                &mut $columns_argument.0,
            );
        }

        #[doc = concat!(
            " `", $function, "` at many positions, into slices: see [sweeps](Self#sweeps)."
        )]
        $visibility fn $slices(&self, $($argument: &[T],)* $slices_argument: [&mut [T]; $width]) {
            $($by)::+::Slices::<$result<T>>::sweep(
                &self.__sealed,
                [$($argument),*],
                $slices_argument,
            );
        }

        $crate::if_rayon! {
            #[doc = concat!(
                " `", $function, "` at many positions, on all threads: see [sweeps](Self#sweeps)."
            )]
            $visibility fn $parallel_into(
                &self,
                $($argument: &[T],)*
                $columns_argument: &mut $columns<T>,
            )
            where
                T: ::core::marker::Send + ::core::marker::Sync,
            {
                $($by)::+::sweep_parallel_into(
                    &self.__sealed,
                    [$($argument),*],
                    &mut $columns_argument.0,
                );
            }
        }
    };
}

/// The methods that sweep a function over its inputs; nothing without feature `alloc`.
#[cfg(not(feature = "alloc"))]
#[doc(hidden)]
#[macro_export]
macro_rules! sweeps {
    ($($token:tt)*) => {};
}

/// The methods that sweep a function over mechanisms; nothing without feature `alloc`. The lists
/// are those of `sweeps!`.
#[cfg(feature = "alloc")]
#[doc(hidden)]
#[macro_export]
macro_rules! set_sweeps {
    (
        ($visibility:vis fn) $function:literal ($($argument:ident),*)
        -> $columns:ident of $mechanism:ident by $($by:ident)::+,
        [$sweep:ident, $into:ident, $parallel_into:ident],
        [$sets_argument:ident, $columns_argument:ident]
    ) => {
        #[doc = concat!(" `", $function, "` for many mechanisms: see [sweeps](Self#sweeps).")]
        #[must_use]
        $visibility fn $sweep(
            &self,
            $sets_argument: &[$mechanism<T>],
            $($argument: &[T]),*
        ) -> $columns<T> {
            $columns($($by)::+::sweep_sets(
                &self.__sealed,
                $sets_argument,
                [$($argument),*],
            ))
        }

        #[doc = concat!(
            " `", $function, "` for many mechanisms, into columns that are there: see [sweeps](Self#sweeps)."
        )]
        $visibility fn $into(
            &self,
            $sets_argument: &[$mechanism<T>],
            $($argument: &[T],)*
            $columns_argument: &mut $columns<T>,
        ) {
            $($by)::+::sweep_sets_into(
                &self.__sealed,
                $sets_argument,
                [$($argument),*],
                &mut $columns_argument.0,
            );
        }

        $crate::if_rayon! {
            #[doc = concat!(
                " `", $function, "` for many mechanisms, on all threads: see [sweeps](Self#sweeps)."
            )]
            $visibility fn $parallel_into(
                &self,
                $sets_argument: &[$mechanism<T>],
                $($argument: &[T],)*
                $columns_argument: &mut $columns<T>,
            )
            where
                T: ::core::marker::Send + ::core::marker::Sync,
            {
                $($by)::+::sweep_sets_parallel_into(
                    &self.__sealed,
                    $sets_argument,
                    [$($argument),*],
                    &mut $columns_argument.0,
                );
            }
        }
    };
}

/// The methods that sweep a function over mechanisms; nothing without feature `alloc`.
#[cfg(not(feature = "alloc"))]
#[doc(hidden)]
#[macro_export]
macro_rules! set_sweeps {
    ($($token:tt)*) => {};
}

/// The sweeps of a function.
#[cfg(feature = "alloc")]
pub mod sweeps {
    pub use linkage_runtime::support::{Slices, sweep, sweep_into, sweep_sets, sweep_sets_into};
    #[cfg(feature = "rayon")]
    pub use linkage_runtime::support::{sweep_parallel_into, sweep_sets_parallel_into};
}

/// The sweeps over mechanisms of a function whose coupled groups are followed.
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod followed_sweeps {
    #[cfg(feature = "rayon")]
    pub use linkage_runtime::support::followed_sweep_sets_parallel_into as sweep_sets_parallel_into;
    pub use linkage_runtime::support::{
        followed_sweep_sets as sweep_sets, followed_sweep_sets_into as sweep_sets_into,
    };
}

/// The sweeps of a mechanism with errors, which never run.
#[cfg(feature = "alloc")]
pub mod missing_sweeps {
    use core::marker::PhantomData;

    /// A sweep that returns columns.
    pub fn sweep<D, A, C>(_: &D, _: A) -> C {
        unimplemented!("the mechanism has errors")
    }

    /// A sweep into columns.
    pub fn sweep_into<D, A, C>(_: &D, _: A, _: &mut C) {}

    /// Sweeps into slices.
    #[derive(Debug)]
    pub struct Slices<R>(PhantomData<fn() -> R>);

    impl<R> Slices<R> {
        /// A sweep into slices.
        pub fn sweep<D, A, S>(_: &D, _: A, _: S) {}
    }

    /// A sweep over mechanisms that returns columns.
    pub fn sweep_sets<D, M, A, C>(_: &D, _: &[M], _: A) -> C {
        unimplemented!("the mechanism has errors")
    }

    /// A sweep over mechanisms into columns.
    pub fn sweep_sets_into<D, M, A, C>(_: &D, _: &[M], _: A, _: &mut C) {}

    #[cfg(feature = "rayon")]
    pub use {sweep_into as sweep_parallel_into, sweep_sets_into as sweep_sets_parallel_into};
}
