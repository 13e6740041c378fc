//! Every example is a test: it compares itself with known answers and fails if one is missed.

// Each example is a program of its own and brings its copy of the checking helper.
#![allow(clippy::duplicate_mod)]

use std::error::Error;

type Outcome = Result<(), Box<dyn Error>>;

/// Includes an example as a module and runs it.
macro_rules! example {
    ($name:ident, $path:literal) => {
        #[path = $path]
        #[allow(
            unreachable_pub,
            dead_code,
            reason = "a program of its own, here a module"
        )]
        mod $name;

        #[test]
        fn $name() -> Outcome {
            $name::main()
        }
    };
}

example!(crank_rocker, "../examples/crank_rocker.rs");
example!(delta_robot, "../examples/delta_robot.rs");
example!(double_double, "../examples/double_double.rs");
example!(drag_link, "../examples/drag_link.rs");
example!(eye_needle_accuracy, "../examples/eye_needle_accuracy.rs");
example!(eye_needle, "../examples/eye_needle.rs");
example!(favorit, "../examples/favorit.rs");
example!(favorit_forces, "../examples/favorit_forces.rs");
example!(geared_five_bar, "../examples/geared_five_bar.rs");
example!(gears, "../examples/gears.rs");
example!(hydraulic_cylinder, "../examples/hydraulic_cylinder.rs");
example!(machine, "../examples/machine.rs");
example!(needle_drive, "../examples/needle_drive.rs");
example!(quick_return, "../examples/quick_return.rs");
example!(spatial_crank_rocker, "../examples/spatial_crank_rocker.rs");
example!(spatial_slider_crank, "../examples/spatial_slider_crank.rs");
example!(stability, "../examples/stability.rs");
example!(trammel, "../examples/trammel.rs");
example!(two_crank_triad, "../examples/two_crank_triad.rs");
example!(universal_joint, "../examples/universal_joint.rs");
