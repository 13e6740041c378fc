#![allow(
    dead_code,
    deprecated,
    non_camel_case_types,
    non_snake_case,
    non_upper_case_globals,
    unreachable_pub,
    unused_imports,
    unused_parens,
    unused_qualifications,
    unused_variables,
    clippy::all,
    clippy::nursery,
    clippy::pedantic,
    clippy::restriction
)]
/// A crank drives a slider through a connecting rod.
#[cfg_attr(
    doc,
    doc = "\n <div><svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"SliderCrank at its reference inputs\" viewBox=\"0 0 400 111.2\" width=\"400\" style=\"max-width:100%\" fill=\"none\" stroke=\"currentColor\" stroke-linecap=\"round\" stroke-linejoin=\"round\"><g stroke-width=\"1.5\"><title>slide</title><path d=\"M334 72.4L398 72.4\"/><path d=\"M334 60.4L398 60.4\"/><path d=\"M356 61.4L376 61.4L376 71.4L356 71.4Z\" fill=\"var(--main-background-color,#fff)\"/></g><path d=\"M34 77.2L108.8 34\" stroke-width=\"4\"><title>crank</title></path><path d=\"M108.8 34L366 66.4\" stroke-width=\"4\"><title>rod</title></path><path d=\"M34 77.2l-8 14h16zm-13 14h26\" stroke-width=\"1.5\"/><circle cx=\"34\" cy=\"77.2\" r=\"4\" stroke-width=\"1.5\" fill=\"var(--main-background-color,#fff)\"/><circle cx=\"108.8\" cy=\"34\" r=\"4\" stroke-width=\"1.5\" fill=\"var(--main-background-color,#fff)\"/><circle cx=\"366\" cy=\"66.4\" r=\"4\" stroke-width=\"1.5\" fill=\"var(--main-background-color,#fff)\"/><g font-family=\"sans-serif\" font-size=\"11\" fill=\"currentColor\" stroke=\"var(--main-background-color,#fff)\" stroke-width=\"3\" paint-order=\"stroke\"><text x=\"115.8\" y=\"27\">pin</text><text x=\"361\" y=\"59.4\">slider</text></g></svg></div>"
)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SliderCrank<T = ::core::primitive::f64> {
    /// `crank`, in mm; default 40, tolerance 0.01.
    pub crank: T,
    /// `rod`, in mm; default 120, tolerance 0.02.
    pub rod: T,
    /// `offset`, in mm; default 5, tolerance 0.05.
    pub offset: T,
}
/// An assembled `SliderCrank`: closed loops in one assembly, everything prepared that does not depend on the inputs.
///
/// # Sweeps
///
/// Each function of inputs has methods that compute it many times, side by side, with feature `alloc`, which is part of `std`; those of the first one are:
///
/// | method | does |
/// |---|---|
/// | `stroke_sweep(phi)` | many positions, one for each element of the slices |
/// | `stroke_sweep_into(phi, columns)` | the same into columns that are there: allocates only if they are too small |
/// | `stroke_sweep_slices(phi, slices)` | the same into slices: one for each number of the result, in the order of its fields; allocates nothing |
/// | `stroke_sweep_parallel_into(phi, columns)` | the same on all threads of rayon's current pool; with feature `rayon` |
/// | `stroke_sweep_sets(sets, phi)` | many mechanisms, each at inputs of its own |
/// | `stroke_sweep_sets_into(sets, phi, columns)` | the same into columns that are there |
/// | `stroke_sweep_sets_parallel_into(sets, phi, columns)` | the same on all threads of rayon's current pool; with feature `rayon` |
///
/// Many mechanisms are assembled in the modes of this one, and their angles count turns from those of this one. Where one cannot be assembled at its position, the results are NaN.
///
/// Sweeps panic if slices differ in length, those with a single element aside: they have that value everywhere. Of many mechanisms, each such slice has one element or as many as there are mechanisms.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SliderCrankAssembly<T = ::core::primitive::f64> {
    __sealed: ::linkage::__private::Sealed<
        ::linkage::__private::Core<
            SliderCrank<T>,
            [::linkage::__private::AssemblyMode; 1],
            ::linkage::__private::Turns<T, 0, 1>,
            [T; 9],
        >,
    >,
}
mod __SliderCrank_stroke {
    use super::*;
    /// What `SliderCrankAssembly::stroke` returns.
    #[derive(
        ::core::clone::Clone,
        ::core::marker::Copy,
        ::core::fmt::Debug,
        ::core::cmp::PartialEq
    )]
    pub struct Stroke<T = ::core::primitive::f64> {
        /// `slide`, in mm.
        pub slide: T,
        /// `v`: derivative of `slide` by `phi`, in mm/rad.
        pub v: T,
        /// `a`: second derivative of `slide` by `phi`, in mm/rad^2.
        pub a: T,
    }
    /// Many `Stroke` values, one column for each number.
    #[derive(::core::clone::Clone, ::core::cmp::PartialEq, ::core::fmt::Debug)]
    pub struct StrokeColumns<T = ::core::primitive::f64>(
        pub(super) ::linkage::__private::ResultColumns<T, Stroke<T>, 3>,
    );
}
pub use __SliderCrank_stroke::Stroke;
pub use __SliderCrank_stroke::StrokeColumns;
mod __SliderCrank_accuracy {
    use super::*;
    /// What `SliderCrankAssembly::accuracy` returns.
    #[derive(
        ::core::clone::Clone,
        ::core::marker::Copy,
        ::core::fmt::Debug,
        ::core::cmp::PartialEq
    )]
    pub struct Accuracy<T = ::core::primitive::f64> {
        /// `slide`, in mm.
        pub slide: T,
        /// `e`: derivatives of `slide` by each of `PARAMETERS`, in mm/mm.
        pub e: [T; 3],
        /// `margin`: how far the nearest group is from a dead point, at most 1.
        pub margin: T,
    }
    /// Many `Accuracy` values, one column for each number.
    #[derive(::core::clone::Clone, ::core::cmp::PartialEq, ::core::fmt::Debug)]
    pub struct AccuracyColumns<T = ::core::primitive::f64>(
        pub(super) ::linkage::__private::ResultColumns<T, Accuracy<T>, 5>,
    );
}
pub use __SliderCrank_accuracy::Accuracy;
pub use __SliderCrank_accuracy::AccuracyColumns;
mod __SliderCrank_shape {
    use super::*;
    /// What `SliderCrankAssembly::shape` returns.
    #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::cmp::PartialEq)]
    pub struct Shape<T = ::core::primitive::f64> {
        /// `shape`: points of `PICTURE` in mm, then its unit vectors.
        pub shape: [::linkage::__private::Vector2<T>; 5],
    }
    /// Many `Shape` values, one column for each number.
    #[derive(::core::clone::Clone, ::core::cmp::PartialEq, ::core::fmt::Debug)]
    pub struct ShapeColumns<T = ::core::primitive::f64>(
        pub(super) ::linkage::__private::ResultColumns<T, Shape<T>, 10>,
    );
}
pub use __SliderCrank_shape::Shape;
pub use __SliderCrank_shape::ShapeColumns;
const _: () = {
    use ::linkage::__private as __p;
    #[automatically_derived]
    impl ::core::default::Default for SliderCrank<__p::f64> {
        #[inline]
        fn default() -> Self {
            __of(|__k| Self::PARAMETERS[__k].nominal)
        }
    }
    impl SliderCrank<__p::f64> {
        /// The same dimensions in another scalar type: single precision, lanes, dual numbers.
        #[must_use]
        pub fn cast<U: __p::Scalar>(&self) -> SliderCrank<U> {
            let __values = __values(self);
            __of(|__k| <U as __p::Scalar>::from_f64(__values[__k]))
        }
    }
    /// The dimensions, each by its index in `PARAMETERS`.
    #[inline(always)]
    fn __of<T: __p::Scalar>(__number: impl __p::Fn(__p::usize) -> T) -> SliderCrank<T> {
        SliderCrank {
            crank: __number(0),
            rod: __number(1),
            offset: __number(2),
        }
    }
    impl SliderCrank<__p::f64> {
        /// The inputs in declaration order, with their reference positions and ranges.
        pub const INPUTS: &'static [__p::Input] = &[
            __p::Input {
                name: "phi",
                unit: "rad",
                reference: 0.5235987755982989f64,
                range: __p::Some((0.0f64, 6.283185307179586f64)),
            },
        ];
        /// The scalar parameters in declaration order, with the defaults and tolerances of the declaration, in
        /// the units of the fields.
        pub const PARAMETERS: &'static [__p::Parameter] = &[
            __p::parameter("crank", "mm", 40.0f64, 0.01f64),
            __p::parameter("rod", "mm", 120.0f64, 0.02f64),
            __p::parameter("offset", "mm", 5.0f64, 0.05f64),
        ];
        /// The groups in the order in which they are solved, their methods, and operation counts.
        pub const STRUCTURE: &'static __p::Structure = &__p::Structure {
            mobility: 1,
            groups: &[
                __p::Group {
                    class: 2u8,
                    order: 2u8,
                    kind: "RRP",
                    loops: &[1],
                    joints: "",
                    unknowns: &["theta", "slide"],
                    mode: __p::Some(0),
                    method: "intersection of a circle and a line, by the distance from the line",
                },
            ],
            functions: &[
                __p::function("stroke", [9u32, 11u32, 1u32, 1u32, 1u32, 0u32, 3u32]),
                __p::function("accuracy", [7u32, 12u32, 1u32, 1u32, 1u32, 0u32, 4u32]),
                __p::function("shape", [5u32, 4u32, 0u32, 1u32, 1u32, 0u32, 1u32]),
            ],
            prepare: __p::operations([1u32, 3u32, 4u32, 0u32, 0u32, 0u32, 4u32]),
        };
        /// Index of `crank` in `PARAMETERS` and in the arrays of `sensitivity`.
        pub const INDEX_CRANK: __p::usize = 0;
        /// Index of `rod` in `PARAMETERS` and in the arrays of `sensitivity`.
        pub const INDEX_ROD: __p::usize = 1;
        /// Index of `offset` in `PARAMETERS` and in the arrays of `sensitivity`.
        pub const INDEX_OFFSET: __p::usize = 2;
    }
    impl SliderCrank<__p::f64> {
        /// What the vectors of the quantity `picture()` are: points, links, guides.
        pub const PICTURE: &'static __p::Picture = &__p::Picture {
            dimension: 2,
            points: &[
                __p::PicturePoint {
                    name: "crank/frame",
                    kind: __p::PointKind::Ground,
                },
                __p::PicturePoint {
                    name: "pin",
                    kind: __p::PointKind::Joint,
                },
                __p::PicturePoint {
                    name: "guide of slide",
                    kind: __p::PointKind::Construction,
                },
                __p::PicturePoint {
                    name: "slider",
                    kind: __p::PointKind::Joint,
                },
            ],
            directions: &["along slide"],
            links: &[
                __p::PictureLink {
                    name: "crank",
                    points: &[0, 1],
                },
                __p::PictureLink {
                    name: "rod",
                    points: &[1, 3],
                },
            ],
            guides: &[
                __p::Guide {
                    name: "slide",
                    origin: 2,
                    direction: 0,
                    slider: 3,
                    on: __p::GuideOn::Frame,
                    shape: __p::GuideShape::Slot,
                },
            ],
            axes: &[],
            joints: &[
                __p::PictureJoint {
                    point: 0,
                    shape: __p::JointShape::Pin,
                },
                __p::PictureJoint {
                    point: 1,
                    shape: __p::JointShape::Pin,
                },
                __p::PictureJoint {
                    point: 3,
                    shape: __p::JointShape::Pin,
                },
                __p::PictureJoint {
                    point: 3,
                    shape: __p::JointShape::Slide,
                },
            ],
            gears: &[],
            drives: &[
                __p::Drive {
                    input: 0,
                    on: __p::DriveOn::Turn([0, 1]),
                },
            ],
            undrawn: &[],
            parts: &[],
        };
    }
    #[automatically_derived]
    impl __p::Dimensions<3> for SliderCrank<__p::f64> {
        const PARAMETERS: &'static [__p::Parameter] = Self::PARAMETERS;
        #[inline]
        fn from_values(__values: &[__p::f64; 3]) -> Self {
            __of(|__k| __values[__k])
        }
        #[inline]
        fn values(&self) -> [__p::f64; 3] {
            __values(self)
        }
    }
    /// The scalar dimensions in the order of `PARAMETERS`.
    #[inline(always)]
    fn __values<T: __p::Scalar>(__mechanism: &SliderCrank<T>) -> [T; 3] {
        [__mechanism.crank, __mechanism.rod, __mechanism.offset]
    }
    type __Core<T> = __p::Core<
        SliderCrank<T>,
        [__p::AssemblyMode; 1],
        __p::Turns<T, 0, 1>,
        [T; 9],
    >;
    impl<T> SliderCrankAssembly<T> {
        /// The dimensions that it was assembled with.
        #[must_use]
        pub const fn mechanism(&self) -> &SliderCrank<T> {
            &__p::Sealed::core(&self.__sealed).dimensions
        }
        /// The assembly mode of each group that has two; `STRUCTURE` says which group is which.
        #[must_use]
        pub const fn modes(&self) -> &[__p::AssemblyMode; 1] {
            &__p::Sealed::core(&self.__sealed).modes
        }
    }
    impl<T: __p::Scalar> SliderCrank<T> {
        /// Closes the loops at the reference inputs in the assembly mode that the start estimates choose, and
        /// computes what depends on the dimensions alone.
        ///
        /// # Errors
        ///
        /// Says which loop cannot close and by how much it misses, or has no finite solution, or which angle cannot be
        /// followed through the range.
        #[doc(
            alias(
                "stroke",
                "stroke_sweep",
                "accuracy",
                "accuracy_sweep",
                "shape",
                "shape_sweep"
            )
        )]
        pub fn assemble(
            &self,
        ) -> __p::Result<SliderCrankAssembly<T>, __p::AssemblyError> {
            __p::assemble(self)
        }
    }
    impl<T: __p::Scalar> SliderCrank<T> {
        /// Every real assembly at the reference inputs, each ready to evaluate; the one that the start
        /// estimates choose comes first if it is real. The list is empty if no assembly is.
        ///
        /// # Errors
        ///
        /// Fails if a dimension is not a finite number, if there are more than 16 groups with two modes, or if the assemblies of a
        /// group without a closed form cannot be listed or followed.
        pub fn assemblies(
            &self,
        ) -> __p::Result<__p::Vec<SliderCrankAssembly<T>>, __p::AssemblyError> {
            __p::assemblies(self)
        }
        /// Every real assembly at the given inputs, each ready to evaluate; the one that the start estimates
        /// choose comes first if it is real there.
        ///
        /// # Errors
        ///
        /// As `assemblies()`.
        pub fn assemblies_at(
            &self,
            phi: T,
        ) -> __p::Result<__p::Vec<SliderCrankAssembly<T>>, __p::AssemblyError> {
            __p::assemblies_at(self, &[phi])
        }
        /// These dimensions in the assembly of a mechanism with others: it is followed along the straight way from those to these, at
        /// the reference inputs, in steps too small to leave it. Each lane of `T` has a way of its own; it is followed in `f64`, on
        /// real parts, and the assembly has the digits and derivatives of `T` as one from `assemble()` has.
        ///
        /// # Errors
        ///
        /// `Blocked` where the assembly ends on the way, in one lane at least; what `assemble()` says of these dimensions.
        pub fn assemble_from(
            &self,
            __assembly: &SliderCrankAssembly<T>,
        ) -> __p::Result<SliderCrankAssembly<T>, __p::AssemblyError> {
            __p::assemble_from(self, __assembly)
        }
    }
    impl<T: __p::Scalar> __p::Compiled for SliderCrank<T> {
        type Scalar = T;
        type Plain = SliderCrank<__p::f64>;
        type Assembly = SliderCrankAssembly<T>;
        type Modes = [__p::AssemblyMode; 1];
        type Inputs = [T; 1];
        type Centres = [T; 0];
        type Windings = [[T; 1]; 0];
        type Prepared = [T; 9];
        type States = ();
        type Arguments = [T; 1];
        fn description(&self) -> &'static __p::Description {
            const {
                &__p::Description {
                    name: "SliderCrank",
                    inputs: SliderCrank::<__p::f64>::INPUTS,
                    parameters: SliderCrank::<__p::f64>::PARAMETERS,
                    groups: SliderCrank::<__p::f64>::STRUCTURE.groups,
                    needed: &[0, 1, 2],
                    gap_units: &["mm"],
                    prepared: 9,
                    modes: &[__p::AssemblyMode::Minus],
                    angles: &[],
                }
            }
        }
        fn assembly(__sealed: __p::DataOf<Self>) -> SliderCrankAssembly<T> {
            SliderCrankAssembly { __sealed }
        }
        #[inline(always)]
        fn data(__assembly: &SliderCrankAssembly<T>) -> &__p::DataOf<Self> {
            &__assembly.__sealed
        }
        #[inline(always)]
        fn dimensions(&self) -> impl __p::AsRef<[T]> {
            __values(self)
        }
        #[inline(always)]
        fn with_dimensions(&self, __dimension: impl __p::Fn(__p::usize) -> T) -> Self {
            __of(__dimension)
        }
        fn plain(
            &self,
            __dimension: impl __p::Fn(__p::usize) -> __p::f64,
        ) -> Self::Plain {
            __of(__dimension)
        }
        #[inline(always)]
        fn arguments(&self, __states: &(), __inputs: &[T; 1]) -> [T; 1] {
            *__inputs
        }
        #[inline(always)]
        fn prepare<const __FUSED: __p::bool>(
            &self,
            __modes: &[__p::AssemblyMode; 1],
            __turns: &__p::RevolutionsOf<Self>,
            __slots: &mut impl __p::RowNumbersMut<T>,
        ) {
            let __m = self;
            let __v0 = T::from_f64(__p::AssemblyMode::sign(__modes[0]));
            let __v2 = __m.rod;
            let __v3 = T::abs(__v2);
            let __v6 = T::unless_negative(
                T::mul_add::<
                    __FUSED,
                >(-__v3, __v3, T::from_f64(1.7976931348623157e308f64)),
                __v3,
            );
            let __v7 = T::slack(__v6);
            let __v9 = T::from_f64((-1.0f64)) / __v0;
            let __v10 = T::from_f64(1.0f64);
            let __v11 = __v10 / __v2;
            let __v12 = __v0 * __v11;
            let __v13 = __v10 / __v6;
            let __v15 = __v10 / (__v6 * __v6);
            let __v16 = -__v12;
            __slots.put(0, __v0);
            __slots.put(1, __v6);
            __slots.put(2, __v7);
            __slots.put(3, __v9);
            __slots.put(4, __v11);
            __slots.put(5, __v12);
            __slots.put(6, __v13);
            __slots.put(7, __v15);
            __slots.put(8, __v16);
        }
        fn gaps(
            &self,
            __modes: &[__p::AssemblyMode; 1],
            __prepared: &[T; 9],
            __x: [T; 1],
        ) -> impl __p::AsRef<[T]> {
            const __FUSED: __p::bool = __p::FUSED;
            let __m = self;
            let __v0 = __prepared[1];
            let __v2 = __m.crank;
            let (__v4, __v5) = T::sin_cos_with::<__FUSED>(__x[0]);
            let __v6 = T::mul_add::<__FUSED>(-__v2, __v4, __m.offset);
            let __v14 = T::mul_add::<
                __FUSED,
            >(__v0 - __v6, __v0 + __v6, __prepared[2] * (T::abs(__v2 * __v5) + __v0));
            let __v20 = T::select(
                __v14,
                T::from_f64(0.0f64),
                T::max(T::abs(__v6) - __v0, T::from_f64(2.2250738585072014e-308f64)),
            );
            [__v20]
        }
        fn directions(
            &self,
            __modes: &[__p::AssemblyMode; 1],
            __prepared: &[T; 9],
            __x: [T; 1],
        ) -> impl __p::AsRef<[[T; 2]]> {
            const __FUSED: __p::bool = __p::FUSED;
            let __m = self;
            []
        }
        fn bearings(
            &self,
            __modes: &[__p::AssemblyMode; 1],
        ) -> impl __p::AsRef<[[T; 2]]> {
            const __FUSED: __p::bool = __p::FUSED;
            let __m = self;
            []
        }
    }
    impl<T: __p::Scalar> __p::Grouped for SliderCrank<T> {
        const COUPLED: __p::bool = false;
        type Lane = [__p::Start; 0];
        type Survey = [T; 5];
        fn group_data(&self) -> &'static __p::GroupData {
            const {
                &__p::GroupData {
                    levels: &[__p::Level::Modes(0)],
                    slacks: &[__p::Slack::Number],
                    coupled: &[],
                    surveying: 0,
                    unknowns: &[
                        __p::surveyed("theta", "", true, 2),
                        __p::surveyed("slide", "mm", false, 1),
                    ],
                    repeats: true,
                    cycle: __p::Some(__p::Cycle {
                        low: 0.0f64,
                        high: 6.283185307179586f64,
                        angle: true,
                        samples: 73,
                    }),
                }
            }
        }
        fn states(&self, __lanes: &[[__p::Start; 0]]) -> () {
            ()
        }
        fn survey<const __SLACKS: __p::bool>(
            __core: &__p::CoreOf<Self>,
            __x: [T; 1],
        ) -> [T; 5] {
            const __FUSED: __p::bool = __p::FUSED;
            let (__m, __modes, __prepared) = __core.loaded();
            let __v0 = __prepared[1];
            let __v2 = __m.crank;
            let (__v4, __v5) = T::sin_cos_with::<__FUSED>(__x[0]);
            let __v6 = T::mul_add::<__FUSED>(-__v2, __v4, __m.offset);
            let __v9 = (__v0 - __v6) * (__v0 + __v6);
            let __v11 = __prepared[7] * __v9;
            if __SLACKS {
                return __p::slacks([__v11]);
            }
            let __v15 = __v2 * __v5;
            let __v18 = T::root_with::<
                __FUSED,
            >(__v9, __prepared[2], T::abs(__v15) + __v0);
            let __v20 = T::min(T::from_f64(1.0f64), __prepared[6] * __v18);
            let __v22 = __prepared[8] * __v18;
            let __v25 = __prepared[4] * T::select(__v18, __v6, __v18);
            let __v27 = T::mul_add::<__FUSED>(-__prepared[0], __v18, __v15);
            [__v20, __v11, __v22, __v25, __v27]
        }
    }
    impl __p::PlainGroups for SliderCrank<__p::f64> {
        #[inline]
        fn bounds(
            __data: &__p::DataOf<Self>,
            __group: __p::usize,
        ) -> __p::Option<__p::Bounds<'static>> {
            let __m = &__p::Sealed::core(__data).dimensions;
            __p::Some(__p::bounds(__m.cast::<__p::Enclosure>(), __data, __group))
        }
    }
    impl SliderCrank<__p::f64> {
        /// Every assembly over the range of the input (a turn about the reference where an angle has none): how far each
        /// reaches, its turning points, and where its margin is smallest.
        ///
        /// # Errors
        ///
        /// As `assemblies()`, if it fails at every position.
        #[inline]
        pub fn circuits(
            &self,
        ) -> __p::Result<
            __p::Circuits<SliderCrankAssembly<__p::f64>>,
            __p::AssemblyError,
        > {
            __p::circuits_of(self)
        }
    }
    impl SliderCrankAssembly<__p::f64> {
        /// Searches the declared range for change points, dead points and gaps, as the compiler does for the default
        /// dimensions. An angle without a range is searched for change points over a turn about its reference.
        #[must_use]
        #[inline]
        pub fn check_range(&self) -> __p::RangeReport {
            __p::check_range_of::<SliderCrank<__p::f64>>(self)
        }
    }
    use __SliderCrank_stroke::*;
    impl<T: __p::Scalar> __p::ResultRow<T, 3> for Stroke<T> {
        #[inline(always)]
        fn from_row([__row0, __row1, __row2]: [T; 3]) -> Self {
            Self {
                slide: __row0,
                v: __row1,
                a: __row2,
            }
        }
        #[inline(always)]
        fn to_row(&self) -> [T; 3] {
            [self.slide, self.v, self.a]
        }
    }
    __p::columns! {
        StrokeColumns of[Stroke; 3]
    }
    impl<T: __p::Scalar> StrokeColumns<T> {
        /// Empty columns; nothing is allocated before the first sweep.
        #[must_use]
        pub fn new() -> Self {
            ::core::default::Default::default()
        }
        /// `slide` at all positions, in mm.
        #[must_use]
        pub fn slide(&self) -> &[T] {
            self.0.column(0)
        }
        /// `v` at all positions: derivative of `slide` by `phi`, in mm/rad.
        #[must_use]
        pub fn v(&self) -> &[T] {
            self.0.column(1)
        }
        /// `a` at all positions: second derivative of `slide` by `phi`, in mm/rad^2.
        #[must_use]
        pub fn a(&self) -> &[T] {
            self.0.column(2)
        }
    }
    impl<T: __p::Scalar> SliderCrankAssembly<T> {
        /// Place of the slider; its velocity and acceleration per radian of the crank.
        ///
        /// Takes `phi`, in rad.
        ///
        /// A quantity that depends on something which cannot be assembled is NaN.
        ///
        /// Operations: 9 additions, 11 multiplications, 1 division, 1 square root, 1 sine-cosine pair, 3 others.
        #[must_use]
        #[inline]
        pub fn stroke(&self, phi: T) -> Stroke<T> {
            __p::call(&self.__sealed, [phi])
        }
        __p::sweeps! {
            (pub fn) "stroke"(phi) -> StrokeColumns of[Stroke; 3] by __p::sweeps,
            [stroke_sweep, stroke_sweep_into, stroke_sweep_slices,
            stroke_sweep_parallel_into], [columns, slices]
        }
        __p::set_sweeps! {
            (pub fn) "stroke"(phi) -> StrokeColumns of SliderCrank by __p::sweeps,
            [stroke_sweep_sets, stroke_sweep_sets_into, stroke_sweep_sets_parallel_into],
            [sets, columns]
        }
    }
    #[doc(hidden)]
    impl<T: __p::Scalar> __p::Function<T, __Core<T>, (), 1, 1, 3> for Stroke<T> {
        type Called = __stroke_stages;
        type Refining = __stroke_stages;
        type States = __p::NoStates;
        const NAMES: &'static __p::FunctionNames<1> = &__p::function_names(
            "stroke",
            ["phi"],
        );
    }
    #[doc(hidden)]
    pub struct __stroke_stages;
    impl<T: __p::Scalar> __p::Staged<T, __Core<T>, 1, 3> for __stroke_stages {
        const WIDE: __p::bool = !::core::cfg!(debug_assertions);
        type Memory<const __BLOCK: __p::usize> = __p::Block<T, __BLOCK, 2>;
        #[inline(always)]
        fn run(__stages: &mut impl __p::RunStages<T, __Core<T>, Self>) {
            __stages.stage::<0>();
            __stages.stage::<1>();
        }
    }
    impl<T: __p::Scalar> __p::Stage<T, __Core<T>, 0> for __stroke_stages {
        #[inline(always)]
        fn row<const __FUSED: __p::bool, const __ROWS: __p::bool>(
            __core: &__Core<T>,
            __row: &mut impl __p::StageRow<T>,
        ) {
            let (__v1, __v2) = T::sin_cos_shortest::<__FUSED, __ROWS>(__row.number(0));
            let __v4 = __core.dimensions.crank * __v2;
            __row.keep(0, __v1);
            __row.keep(1, __v4);
        }
    }
    impl<T: __p::Scalar> __p::Stage<T, __Core<T>, 1> for __stroke_stages {
        #[inline(always)]
        fn row<const __FUSED: __p::bool, const __ROWS: __p::bool>(
            __core: &__Core<T>,
            __row: &mut impl __p::StageRow<T>,
        ) {
            let __v0 = __core.dimensions.crank;
            let __v1 = __row.kept(0);
            let __v2 = __v0 * __v1;
            let __v4 = T::mul_add::<__FUSED>(-__v0, __v1, __core.dimensions.offset);
            let __v5 = __row.prepared(1);
            let __v9 = __row.kept(1);
            let __v13 = T::root_with::<
                __FUSED,
            >((__v5 - __v4) * (__v5 + __v4), __row.prepared(2), T::abs(__v9) + __v5);
            let __v14 = __row.prepared(0);
            let __v16 = T::mul_add::<__FUSED>(-__v14, __v13, __v9);
            let __v17 = T::select(__v13, __v4, __v13);
            let __v19 = T::quotient_with::<__FUSED>(__row.prepared(3), __v13);
            let __v20 = __v9 * __v19;
            let __v22 = T::mul_add::<__FUSED>(__v17, __v20, -__v2);
            let __v28 = -T::mul_add::<
                __FUSED,
            >(
                __v17,
                __v19 * T::mul_add::<__FUSED>(__v20, __v17 * __v20, __v2),
                T::mul_add::<__FUSED>(-__v20, (__v14 * __v13) * __v20, __v9),
            );
            __row.finish(0, __v16);
            __row.finish(1, __v22);
            __row.finish(2, __v28);
        }
        #[inline(always)]
        fn write(__rows: &mut impl __p::FinishedRows) {
            __rows.write(0);
            __rows.write(1);
            __rows.write(2);
        }
    }
    impl<T: __p::Scalar> __p::SetStages<SliderCrank<T>, 3, 4, 4> for __stroke_stages {
        type Prepared<const __BLOCK: __p::usize> = __p::Block<T, __BLOCK, 4>;
        const COLUMNS: &'static [__p::usize] = &__p::columns_of::<9>(&[0, 1, 2, 3]);
    }
    use __SliderCrank_accuracy::*;
    impl<T: __p::Scalar> __p::ResultRow<T, 5> for Accuracy<T> {
        #[inline(always)]
        fn from_row([__row0, __row1, __row2, __row3, __row4]: [T; 5]) -> Self {
            Self {
                slide: __row0,
                e: [__row1, __row2, __row3],
                margin: __row4,
            }
        }
        #[inline(always)]
        fn to_row(&self) -> [T; 5] {
            [self.slide, self.e[0], self.e[1], self.e[2], self.margin]
        }
    }
    __p::columns! {
        AccuracyColumns of[Accuracy; 5]
    }
    impl<T: __p::Scalar> AccuracyColumns<T> {
        /// Empty columns; nothing is allocated before the first sweep.
        #[must_use]
        pub fn new() -> Self {
            ::core::default::Default::default()
        }
        /// `slide` at all positions, in mm.
        #[must_use]
        pub fn slide(&self) -> &[T] {
            self.0.column(0)
        }
        /// `e` at all positions: derivatives of `slide` by each of `PARAMETERS`, in mm/mm.
        #[must_use]
        pub fn e(&self) -> [&[T]; 3] {
            [self.0.column(1), self.0.column(2), self.0.column(3)]
        }
        /// `margin` at all positions: how far the nearest group is from a dead point, at most 1.
        #[must_use]
        pub fn margin(&self) -> &[T] {
            self.0.column(4)
        }
    }
    impl<T: __p::Scalar> SliderCrankAssembly<T> {
        /// What each dimension does to the slider's place, and how far the mechanism is from a dead point (0 to 1).
        ///
        /// Takes `phi`, in rad.
        ///
        /// A quantity that depends on something which cannot be assembled is NaN.
        ///
        /// Operations: 7 additions, 12 multiplications, 1 division, 1 square root, 1 sine-cosine pair, 4 others. Derivatives by parameters are computed forward.
        #[must_use]
        #[inline]
        pub fn accuracy(&self, phi: T) -> Accuracy<T> {
            __p::call(&self.__sealed, [phi])
        }
        __p::sweeps! {
            (pub fn) "accuracy"(phi) -> AccuracyColumns of[Accuracy; 5] by __p::sweeps,
            [accuracy_sweep, accuracy_sweep_into, accuracy_sweep_slices,
            accuracy_sweep_parallel_into], [columns, slices]
        }
        __p::set_sweeps! {
            (pub fn) "accuracy"(phi) -> AccuracyColumns of SliderCrank by __p::sweeps,
            [accuracy_sweep_sets, accuracy_sweep_sets_into,
            accuracy_sweep_sets_parallel_into], [sets, columns]
        }
    }
    #[doc(hidden)]
    impl<T: __p::Scalar> __p::Function<T, __Core<T>, (), 1, 1, 5> for Accuracy<T> {
        type Called = __accuracy_stages;
        type Refining = __accuracy_stages;
        type States = __p::NoStates;
        const NAMES: &'static __p::FunctionNames<1> = &__p::function_names(
            "accuracy",
            ["phi"],
        );
    }
    #[doc(hidden)]
    pub struct __accuracy_stages;
    impl<T: __p::Scalar> __p::Staged<T, __Core<T>, 1, 5> for __accuracy_stages {
        const WIDE: __p::bool = !::core::cfg!(debug_assertions);
        type Memory<const __BLOCK: __p::usize> = __p::Block<T, __BLOCK, 2>;
        #[inline(always)]
        fn run(__stages: &mut impl __p::RunStages<T, __Core<T>, Self>) {
            __stages.stage::<0>();
            __stages.stage::<1>();
        }
    }
    impl<T: __p::Scalar> __p::Stage<T, __Core<T>, 0> for __accuracy_stages {
        #[inline(always)]
        fn row<const __FUSED: __p::bool, const __ROWS: __p::bool>(
            __core: &__Core<T>,
            __row: &mut impl __p::StageRow<T>,
        ) {
            let (__v1, __v2) = T::sin_cos_shortest::<__FUSED, __ROWS>(__row.number(0));
            __row.keep(0, __v1);
            __row.keep(1, __v2);
        }
    }
    impl<T: __p::Scalar> __p::Stage<T, __Core<T>, 1> for __accuracy_stages {
        #[inline(always)]
        fn row<const __FUSED: __p::bool, const __ROWS: __p::bool>(
            __core: &__Core<T>,
            __row: &mut impl __p::StageRow<T>,
        ) {
            let __v0 = __core.dimensions.crank;
            let __v1 = __row.kept(1);
            let __v2 = __v0 * __v1;
            let __v3 = __row.kept(0);
            let __v5 = T::mul_add::<__FUSED>(-__v0, __v3, __core.dimensions.offset);
            let __v6 = __row.prepared(1);
            let __v13 = T::root_with::<
                __FUSED,
            >((__v6 - __v5) * (__v6 + __v5), __row.prepared(2), T::abs(__v2) + __v6);
            let __v15 = T::mul_add::<__FUSED>(-__row.prepared(0), __v13, __v2);
            let __v16 = T::select(__v13, __v5, __v13);
            let __v18 = T::quotient_with::<__FUSED>(__row.prepared(3), __v13);
            let __v20 = T::mul_add::<__FUSED>(__v16, __v3 * __v18, __v1);
            let __v26 = T::mul_add::<
                __FUSED,
            >(__v16, (__row.prepared(4) * __v16) * __v18, -(__row.prepared(5) * __v13));
            let __v28 = -(__v16 * __v18);
            let __v32 = T::min(T::from_f64(1.0f64), __row.prepared(6) * __v13);
            __row.finish(0, __v15);
            __row.finish(1, __v20);
            __row.finish(2, __v26);
            __row.finish(3, __v28);
            __row.finish(4, __v32);
        }
        #[inline(always)]
        fn write(__rows: &mut impl __p::FinishedRows) {
            __rows.write(0);
            __rows.write(1);
            __rows.write(2);
            __rows.write(3);
            __rows.write(4);
        }
    }
    impl<T: __p::Scalar> __p::SetStages<SliderCrank<T>, 3, 4, 4> for __accuracy_stages {
        type Prepared<const __BLOCK: __p::usize> = __p::Block<T, __BLOCK, 7>;
        const COLUMNS: &'static [__p::usize] = &__p::columns_of::<
            9,
        >(&[0, 1, 2, 3, 4, 5, 6]);
    }
    use __SliderCrank_shape::*;
    #[automatically_derived]
    impl<T: ::core::fmt::Debug> ::core::fmt::Debug for Shape<T> {
        fn fmt(&self, __f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
            __f.debug_struct("Shape").field("shape", &__p::named(&self.shape)).finish()
        }
    }
    impl<T: __p::Scalar> __p::ResultRow<T, 10> for Shape<T> {
        #[inline(always)]
        fn from_row(
            [__row0,
            __row1,
            __row2,
            __row3,
            __row4,
            __row5,
            __row6,
            __row7,
            __row8,
            __row9,
            ]: [T; 10],
        ) -> Self {
            Self {
                shape: [
                    __p::Vector2::new(__row0, __row1),
                    __p::Vector2::new(__row2, __row3),
                    __p::Vector2::new(__row4, __row5),
                    __p::Vector2::new(__row6, __row7),
                    __p::Vector2::new(__row8, __row9),
                ],
            }
        }
        #[inline(always)]
        fn to_row(&self) -> [T; 10] {
            [
                self.shape[0].x,
                self.shape[0].y,
                self.shape[1].x,
                self.shape[1].y,
                self.shape[2].x,
                self.shape[2].y,
                self.shape[3].x,
                self.shape[3].y,
                self.shape[4].x,
                self.shape[4].y,
            ]
        }
    }
    __p::columns! {
        ShapeColumns of[Shape; 10]
    }
    impl<T: __p::Scalar> ShapeColumns<T> {
        /// Empty columns; nothing is allocated before the first sweep.
        #[must_use]
        pub fn new() -> Self {
            ::core::default::Default::default()
        }
        /// `shape` at all positions: points of `PICTURE` in mm, then its unit vectors.
        #[must_use]
        pub fn shape(&self) -> [[&[T]; 2]; 5] {
            [
                [self.0.column(0), self.0.column(1)],
                [self.0.column(2), self.0.column(3)],
                [self.0.column(4), self.0.column(5)],
                [self.0.column(6), self.0.column(7)],
                [self.0.column(8), self.0.column(9)],
            ]
        }
    }
    impl<T: __p::Scalar> SliderCrankAssembly<T> {
        /// The links, for the drawing.
        ///
        /// Takes `phi`, in rad.
        ///
        /// A quantity that depends on something which cannot be assembled is NaN.
        ///
        /// Operations: 5 additions, 4 multiplications, 1 square root, 1 sine-cosine pair, 1 other.
        #[must_use]
        #[inline]
        pub fn shape(&self, phi: T) -> Shape<T> {
            __p::call(&self.__sealed, [phi])
        }
        __p::sweeps! {
            (pub fn) "shape"(phi) -> ShapeColumns of[Shape; 10] by __p::sweeps,
            [shape_sweep, shape_sweep_into, shape_sweep_slices,
            shape_sweep_parallel_into], [columns, slices]
        }
        __p::set_sweeps! {
            (pub fn) "shape"(phi) -> ShapeColumns of SliderCrank by __p::sweeps,
            [shape_sweep_sets, shape_sweep_sets_into, shape_sweep_sets_parallel_into],
            [sets, columns]
        }
    }
    #[doc(hidden)]
    impl<T: __p::Scalar> __p::Function<T, __Core<T>, (), 1, 1, 10> for Shape<T> {
        type Called = __shape_stages;
        type Refining = __shape_stages;
        type States = __p::NoStates;
        const NAMES: &'static __p::FunctionNames<1> = &__p::function_names(
            "shape",
            ["phi"],
        );
    }
    #[doc(hidden)]
    pub struct __shape_stages;
    impl<T: __p::Scalar> __p::Staged<T, __Core<T>, 1, 10> for __shape_stages {
        const WIDE: __p::bool = !::core::cfg!(debug_assertions);
        type Memory<const __BLOCK: __p::usize> = __p::Block<T, __BLOCK, 2>;
        #[inline(always)]
        fn run(__stages: &mut impl __p::RunStages<T, __Core<T>, Self>) {
            __stages.stage::<0>();
            __stages.stage::<1>();
        }
    }
    impl<T: __p::Scalar> __p::Stage<T, __Core<T>, 0> for __shape_stages {
        #[inline(always)]
        fn row<const __FUSED: __p::bool, const __ROWS: __p::bool>(
            __core: &__Core<T>,
            __row: &mut impl __p::StageRow<T>,
        ) {
            let (__v1, __v2) = T::sin_cos_shortest::<__FUSED, __ROWS>(__row.number(0));
            let __v3 = __core.dimensions.crank;
            let __v4 = __v3 * __v2;
            let __v5 = __v3 * __v1;
            let __v7 = T::mul_add::<__FUSED>(-__v3, __v1, __core.dimensions.offset);
            __row.keep(0, __v4);
            __row.keep(1, __v7);
            __row.finish(2, __v4);
            __row.finish(3, __v5);
        }
        #[inline(always)]
        fn write(__rows: &mut impl __p::FinishedRows) {
            __rows.write(2);
            __rows.write(3);
        }
    }
    impl<T: __p::Scalar> __p::Stage<T, __Core<T>, 1> for __shape_stages {
        #[inline(always)]
        fn row<const __FUSED: __p::bool, const __ROWS: __p::bool>(
            __core: &__Core<T>,
            __row: &mut impl __p::StageRow<T>,
        ) {
            let __v0 = __row.prepared(1);
            let __v1 = __row.kept(1);
            let __v5 = __row.kept(0);
            let __v11 = T::mul_add::<
                __FUSED,
            >(
                -__row.prepared(0),
                T::root_with::<
                    __FUSED,
                >((__v0 - __v1) * (__v0 + __v1), __row.prepared(2), T::abs(__v5) + __v0),
                __v5,
            );
            let __v12 = T::from_f64(0.0f64);
            let __v13 = __core.dimensions.offset;
            let __v14 = T::from_f64(1.0f64);
            __row.finish(0, __v12);
            __row.finish(1, __v12);
            __row.finish(4, __v12);
            __row.finish(5, __v13);
            __row.finish(6, __v11);
            __row.finish(7, __v13);
            __row.finish(8, __v14);
            __row.finish(9, __v12);
        }
        #[inline(always)]
        fn write(__rows: &mut impl __p::FinishedRows) {
            __rows.write(0);
            __rows.write(1);
            __rows.write(4);
            __rows.write(5);
            __rows.write(6);
            __rows.write(7);
            __rows.write(8);
            __rows.write(9);
        }
    }
    impl<T: __p::Scalar> __p::SetStages<SliderCrank<T>, 3, 4, 4> for __shape_stages {
        type Prepared<const __BLOCK: __p::usize> = __p::Block<T, __BLOCK, 3>;
        const COLUMNS: &'static [__p::usize] = &__p::columns_of::<9>(&[0, 1, 2]);
    }
};
