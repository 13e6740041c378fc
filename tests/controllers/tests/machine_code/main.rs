//! The machine code of functions in single precision for small processors: neither branch nor call, hence the same instructions
//! for every input. Skipped where a target is not installed, unless `LINKAGE_TARGETS` names it.

mod code;
mod compile;
mod instruction;
mod page;

use code::Library;
use instruction::{Decode, aarch64, thumb};

const THUMB: &str = "thumbv7em-none-eabihf";

/// Functions of the package.
const FUNCTIONS: [&str; 8] = [
    "slider_crank_motion",
    "crank_rocker_position",
    "crank_rocker_motion",
    "crank_rocker_accuracy",
    "crank_rocker_angle",
    "quick_return_motion",
    "toggle_press_motion",
    "spatial_crank_rocker_motion",
];

/// What assembles the mechanisms.
const ASSEMBLIES: [&str; 5] = [
    "slider_crank_assemble",
    "crank_rocker_assemble",
    "quick_return_assemble",
    "toggle_press_assemble",
    "spatial_crank_rocker_assemble",
];

fn library(target: &str, decode: Decode) -> Option<Library> {
    Some(Library::read(&compile::library(target)?, decode))
}

fn functions_are_straight(target: &str, decode: Decode) {
    let Some(library) = library(target, decode) else {
        return;
    };
    let functions = FUNCTIONS.map(|name| (name, library.function(name)));
    for (name, function) in &functions {
        assert!(function.instructions > 50, "{name}: {function:?}");
        assert_eq!(function.returns, 1, "{name}: {function:?}");
        assert!(function.branches.is_empty(), "{name}: {function:?}");
        assert!(function.doubles.is_empty(), "{name}: {function:?}");
        assert!(function.calls.is_empty(), "{name}: {function:?}");
    }
    page::compare(target, &functions);
}

#[test]
fn functions_for_a_cortex_m4_are_straight() {
    functions_are_straight(THUMB, thumb);
}

#[test]
fn functions_for_aarch64_are_straight() {
    functions_are_straight("aarch64-unknown-linux-gnu", aarch64);
}

/// As the table of the page says.
#[test]
fn what_is_called_on_a_cortex_m4_is_known() {
    let Some(library) = library(THUMB, thumb) else {
        return;
    };
    let names = |function: &str| library.function(function).calls;
    let called = names("functions_at");
    assert_eq!(called.len(), 3, "{called:?}");
    for name in ["5asinf", "5acosf", "5atanf"] {
        assert!(
            called.iter().any(|called| called.contains(name)),
            "{called:?}"
        );
    }

    for name in ASSEMBLIES {
        for called in names(name) {
            let known =
                page::names(&called) || called.contains("linkage") || called == code::INSIDE;
            assert!(known, "{name} calls {called}, which the page does not say");
        }
    }
}
