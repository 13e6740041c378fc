#![doc = include_str!("links.md")]
#![doc = include_str!("../docs/introduction.md")]
#![doc = include_str!("../docs/features.md")]
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "num-dual")]
pub use linkage_core::Dual;
#[cfg(all(feature = "simba", any(feature = "std", feature = "libm")))]
pub use linkage_core::Lanes;
/// The library whose vectors and poses results are, for everything else that it offers for them,
/// in the version that fits.
#[cfg(feature = "nalgebra")]
pub use linkage_runtime::nalgebra;
pub use linkage_runtime::{
    AssemblyError, AssemblyMode, Axis, Column, Dimensions, Drive, DriveOn, Frame, FunctionInfo,
    Gear, Group, GroupRef, Guide, GuideOn, GuideShape, Halt, Heading, Input, JointShape, Meaning,
    NotFollowed, Operations, Parameter, Picture, PictureColumns, PictureJoint, PictureLink,
    PicturePart, PicturePoint, PlaneFrame, PointKind, Programs, ResultRow, Scalar, Screw,
    Structure, Table, Vector2, Vector3, WheelContact, WheelTurn, true_acceleration, true_jerk,
    true_velocity,
};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use linkage_runtime::{
    Branch, BranchEnd, Circuits, Cycle, Estimate, Meeting, RangeFinding, RangeFindingKind,
    RangeMessage, RangeReport, Unchecked, Undetermined,
};
#[cfg(feature = "alloc")]
pub use linkage_runtime::{
    ClosestApproach, Columns, CoupledCause, CoupledError, Missed, Placed, ResultColumns, Unlisted,
    Value,
};
#[cfg(any(feature = "std", feature = "libm"))]
pub use linkage_runtime::{Enclosure, Float};
#[cfg(all(feature = "alloc", target_has_atomic = "ptr"))]
pub use linkage_runtime::{Handle, Handles, Scene};

/// Compiles a mechanism of the plane or of space: a struct block with dimensions, inputs, unknowns
/// and loops, then an `impl` block with functions, listed by the quantities that they give.
///
/// It generates the struct of dimensions, its assembly, the functions on the assembly, and a result
/// type for each of them, all next to each other in the module of the call. Mistakes are errors of
/// the compiler at the words at fault; the items are then generated without content, so that
/// the rest of the program is still checked. The page [`language`] is the complete reference.
///
/// ```
/// use linkage::mechanism;
///
/// mechanism! {
///     /// A ladder sliding down a wall.
///     struct Ladder {
///         param length = 3m +- 2mm;
///         input foot = 1m in 0.1m..2.9m;
///         unknown top  = 2.8m;
///         unknown lean = 110deg;
///         loop (foot, 0) + polar(length, lean) = (0, top);
///     }
///     impl Ladder {
///         fn top(foot) -> Top { top, slope: d(top, foot), e: d(top, length) }
///     }
/// }
///
/// let top = Ladder::default().assemble()?.top(1.8);
/// assert!((top.top - 2.4).abs() < 1e-15);
/// assert!((top.slope + 0.75).abs() < 1e-15 && (top.e - 1.25).abs() < 1e-15);
/// # Ok::<(), linkage::AssemblyError>(())
/// ```
#[macro_export]
macro_rules! mechanism {
    ($($tokens:tt)*) => {
        // Before the mechanism: rust-analyzer completes in the first expansion of a word. In the block of an item
        // that allows the name, which rustc does not know.
        #[allow(unexpected_cfgs)]
        const _: () = {
            #[cfg(rust_analyzer)]
            $crate::__private::names! { [$crate] $($tokens)* }
        };
        $crate::__private::mechanism! { [$crate] $($tokens)* }
    };
}

mod columns_and_sweeps;

/// Its content if feature `alloc` is on, else nothing: generated code cannot see the features.
#[cfg(feature = "alloc")]
#[doc(hidden)]
#[macro_export]
macro_rules! if_alloc {
    ($($item:tt)*) => { $($item)* };
}

/// Its content if feature `alloc` is on, else nothing: generated code cannot see the features.
#[cfg(not(feature = "alloc"))]
#[doc(hidden)]
#[macro_export]
macro_rules! if_alloc {
    ($($item:tt)*) => {};
}

/// Its content if feature `rayon` is on, else nothing.
#[cfg(feature = "rayon")]
#[doc(hidden)]
#[macro_export]
macro_rules! if_rayon {
    ($($item:tt)*) => { $($item)* };
}

/// Its content if feature `rayon` is on, else nothing.
#[cfg(not(feature = "rayon"))]
#[doc(hidden)]
#[macro_export]
macro_rules! if_rayon {
    ($($item:tt)*) => {};
}

/// Its content if feature `report` or `design` is on, which read columns by their names, else
/// nothing: unused items need not be compiled.
#[cfg(any(feature = "report", feature = "design"))]
#[doc(hidden)]
#[macro_export]
macro_rules! if_report {
    ($($item:tt)*) => { $($item)* };
}

/// Its content if feature `report` or `design` is on, which read columns by their names, else
/// nothing: unused items need not be compiled.
#[cfg(not(any(feature = "report", feature = "design")))]
#[doc(hidden)]
#[macro_export]
macro_rules! if_report {
    ($($item:tt)*) => {};
}

// Links between pages lead to files if the repository is read: each page ends with them. Here
// `links.md` comes before a page, and of two definitions the first one counts. It begins with blank
// lines, which end the paragraph before it.

/// A tutorial from a sketch to loops that ends with the take-up lever of a sewing machine.
///
/// Its pictures are seen where the repository's `docs/tutorial.md` is read.
pub mod tutorial {
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/tutorial.md")]
}

/// Tasks with a short program for each, from inverse motion to a counterweight.
///
/// Its pictures are in the repository's `docs/cookbook.md`.
// Its samples are tested if there are the features that they need.
#[cfg_attr(
    all(doctest, not(all(feature = "monte-carlo", feature = "report"))),
    cfg(false)
)]
pub mod cookbook {
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/cookbook.md")]
}

/// The language of [`mechanism!`], and the items that it generates: the complete reference.
pub mod language {
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/language.md")]

    /// Items of the struct block: units, parameters with tolerances, inputs, unknowns, derived
    /// names, loops.
    pub mod items {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/items.md")]
    }

    /// Joints and links: the second way to write a mechanism.
    pub mod links {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/links.md")]
    }

    /// Expressions: literals with units, functions, vectors; frames that follow bodies in space.
    pub mod expressions {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/expressions.md")]
    }

    /// Loops: groups that are recognised and solved in closed form, in the plane and in space.
    ///
    /// Its pictures are in the repository's `docs/language/loops.md`.
    pub mod loops {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/loops.md")]
    }

    /// Coupled groups: loops that can only be solved together, class III and more; their
    /// preparation and their ranges.
    pub mod coupled {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/coupled.md")]
    }

    /// Functions of the impl block: quantities: positions, derivatives, sensitivities, several
    /// inputs.
    pub mod functions {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/functions.md")]
    }

    /// Forces: bodies, joints, loads, speeds; reactions, torques, energies; units of force, mass
    /// and time.
    ///
    /// Its pictures are in the repository's `docs/language/forces.md`.
    pub mod forces {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/forces.md")]
    }

    /// Pictures: the elements that `picture()` finds in the loops, and its limits.
    ///
    /// Its pictures are in the repository's `docs/language/pictures.md`.
    pub mod pictures {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/pictures.md")]
    }

    /// Generated items; sweeps over positions and over mechanisms.
    pub mod generated {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/generated.md")]
    }

    /// Machines: mechanisms as parts of others; the inverse of a mechanism; a `Scene` of functions
    /// of several linkages.
    pub mod machines {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/machines.md")]
    }

    /// Assemblies: assembly modes, circuits, angles that count their turns, errors at run time,
    /// margins.
    pub mod assemblies {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/assemblies.md")]
    }

    /// Checks of the compiler: ranges, directions, estimates; unsupported mechanisms.
    pub mod checks {
        #![doc = include_str!("links.md")]
        #![doc = include_str!("../docs/language/checks.md")]
    }
}

/// Mechanisms on small processors, in single precision: called functions, bytes and instructions.
pub mod controllers {
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/controllers.md")]
}

/// Mechanisms as C99, for controllers: the printed code, a control loop, a block of a PLC.
pub mod c {
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/c.md")]
}

/// Promises of versions: names, digits of results, operation counts, the oldest Rust.
pub mod stability {
    #![doc = include_str!("../docs/stability.md")]
}

/// Accuracy: the effect of tolerances, and the tolerances for an allowed error.
#[cfg(feature = "tolerance")]
// Its samples draw random mechanisms.
#[cfg_attr(all(doctest, not(feature = "monte-carlo")), cfg(false))]
pub mod tolerance {
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/tolerance.md")]

    pub use linkage_analysis::tolerance::*;
}

/// Design: from requirements to dimensions, by least squares from many starts.
#[cfg(feature = "design")]
pub mod design {
    // Only here: without this feature there is nothing to link to. A blank line ends the paragraph
    // before it.
    #![doc = "\n[exact]: crate::design::exact"]
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/design.md")]

    pub use linkage_design::*;

    /// Exact synthesis: all mechanisms that meet as many conditions as they have dimensions.
    pub mod exact {
        #![doc = include_str!("../docs/exact.md")]

        pub use linkage_synthesis::*;
    }
}

/// Dynamics: the motion that forces make, its events, steady states, motors, flywheels, frequencies.
///
/// Its picture is in the repository's `docs/dynamics.md`.
#[cfg(feature = "dynamics")]
pub mod dynamics {
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/dynamics.md")]

    pub use linkage_dynamics::*;
}

/// Reports: plots, drawings to scale, data and interactive pages of a mechanism over its range.
#[cfg(feature = "report")]
pub mod report {
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/report.md")]

    pub use linkage_report::*;
}

/// Pins of joints: their diameter under the largest reaction, and their stresses.
#[cfg(any(feature = "std", feature = "libm"))]
pub mod pins {
    #![doc = include_str!("../docs/pins.md")]

    pub use linkage_analysis::pins::*;
}

/// Jacobians both ways: motions, forces, condition, singular positions.
pub mod jacobian {
    #![doc = include_str!("../docs/jacobian.md")]

    pub use linkage_runtime::jacobian::*;
}

/// Plate cams: profile, pressure angle, curvature, undercut.
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod cam {
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/cam.md")]

    pub use linkage_analysis::cam::*;
}

/// Counterweights: the least shaking force over a cycle.
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod balancing {
    #![doc = include_str!("../docs/balancing.md")]

    pub use linkage_analysis::balancing::*;
}

/// Figures of a cycle: limits, extreme velocities, dwells, time ratio, transmission angle, margin.
#[cfg(feature = "alloc")]
pub mod summary {
    #![doc = include_str!("../docs/summary.md")]

    pub use linkage_analysis::summary::*;
}

/// Clearances: the least distance of two working members over a cycle, and the phase that makes it
/// largest.
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod clearance {
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/clearance.md")]

    pub use linkage_analysis::clearance::*;
}

/// Cyclograms: the motions of the working members of a machine over the shaft angle.
#[cfg(feature = "alloc")]
pub mod cyclogram {
    #![doc = include_str!("links.md")]
    #![doc = include_str!("../docs/cyclogram.md")]

    pub use linkage_analysis::cyclogram::*;
}

/// Tests of the programs in the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// Tests of the programs in the overview, a page of the book only.
#[cfg(all(doctest, feature = "report"))]
#[doc = include_str!("../docs/overview.md")]
struct Overview;

/// The items that generated code names. Some have other names in the runtime, which users never
/// see.
#[doc(hidden)]
pub mod __private {
    #[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
    pub use crate::columns_and_sweeps::followed_sweeps;
    #[cfg(feature = "alloc")]
    pub use crate::columns_and_sweeps::{missing_sweeps, sweeps};
    pub use crate::{columns, if_alloc, if_report, set_sweeps, sweeps};
    pub use core::convert::AsRef;
    pub use core::ops::{Fn, FnOnce};
    pub use core::option::Option;
    pub use core::option::Option::{None, Some};
    pub use core::primitive::{bool, f64, usize};
    pub use core::result::Result;
    pub use core::result::Result::{Err, Ok};
    pub use linkage_macros::{mechanism, names};
    #[cfg(any(feature = "std", feature = "libm"))]
    pub use linkage_runtime::support::assemble;
    pub use linkage_runtime::support::{
        Along, Angle, ArrayRevolutions as Turns, Compiled, CoreOf, DataOf, Description,
        RevolutionsOf,
    };
    #[cfg(feature = "alloc")]
    pub use linkage_runtime::support::{Arguments, OverInputs, SetStages, Vec, columns_of, fill};
    pub use linkage_runtime::support::{
        AssemblyData as Sealed, Block, Core, Dispatch as Single, FinishedRows, Function,
        FunctionNames, NoStates, RowNumbersMut, RunStages, Stage, StageData, StageRow, Staged,
        States, call, call_inlined, derivative_of, dispatch as single, drawn, evaluate, function,
        function_names, margin, named, operations, parameter, rate, sensitivity, value,
    };
    #[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
    pub use linkage_runtime::support::{
        Bounds, Enclosure, GroupData, GroupProgram, Grouped, Level, PlainGroups, Slack,
        assemble_coupled, assemble_from, assemblies, assemblies_at, bounds, check_range_of,
        circuits_of, slacks, surveyed,
    };
    #[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
    pub use linkage_runtime::support::{
        Coupled, CoupledGrid, CoupledGroup, CoupledInput, CoupledLoop, CoupledUnknown,
        FollowedStages, InitialState as Start, Moving, Range, Standing, Stop, Term, Terms,
        Variable, follow, list_roots, put_corrected,
    };
    pub use linkage_runtime::{
        AssemblyError, AssemblyMode, Axis, Dimensions, Drive, DriveOn, FUSED, Frame, Gear, Group,
        Guide, GuideOn, GuideShape, Heading, Input, JointShape, NotFollowed, Parameter, Picture,
        PictureColumns, PictureJoint, PictureLink, PicturePart, PicturePoint, PlaneFrame,
        PointKind, Programs, ResultRow, Scalar, Structure, Vector2, Vector3, WheelContact,
        WheelTurn,
    };
    #[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
    pub use linkage_runtime::{Circuits, Cycle, RangeReport};
    #[cfg(feature = "alloc")]
    pub use linkage_runtime::{Columns, Headed, ResultColumns};
}
