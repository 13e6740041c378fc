//! C as a target language: names of items, and declarations of members.

use linkage_compiler::ir::Shape;
use linkage_export::{FunctionItem, Refusal, Scope, Target};

use super::constant::{CONSTANTS_OF_ALL, constant};
use super::refusal::codes;
use crate::c_names::{is_macro, is_reserved, snake_letters, spelled};
use crate::real::Real;

/// The end of the name of a type that exists where constants have all their digits: compilers print
/// it.
const CONSTANTS: &str = "is_not_for_fsingle_precision_constant";

/// The types of vectors and frames: the last of the items of a mechanism.
pub(super) const VECTORS: usize = 4;

/// The variables of printed functions.
const VARIABLES: [&str; 6] = ["m", "count", "results", "result", "k", "inputs"];

/// The items of a function; those without arguments have no sweep.
const RESULT: FunctionItem = FunctionItem {
    ending: "_result",
    kind: "the result of the function",
};
const SWEEP: FunctionItem = FunctionItem {
    ending: "_sweep",
    kind: "the sweep of the function",
};
const CALL: FunctionItem = FunctionItem {
    ending: "",
    kind: "the function",
};

/// C, with numbers of one type, for a mechanism with these refusals.
#[derive(Clone, Copy, Debug)]
pub(super) struct C<'a> {
    pub(super) real: Real,
    pub(super) refusals: &'a [Refusal],
}

impl C<'_> {
    /// The constants of a mechanism, for the beginning of its names.
    fn constants(&self, prefix: &str) -> impl Iterator<Item = String> {
        let codes = codes(prefix, prefix, self.refusals).into_iter();
        let others = CONSTANTS_OF_ALL.map(|end| constant(prefix, end));
        codes.map(|code| code.name).chain(others)
    }
}

impl Target for C<'_> {
    const LANGUAGE: &'static str = "C";

    const ITEMS: &'static [&'static str] = &[
        "dimensions",
        "assemble",
        "error",
        "ok",
        CONSTANTS,
        "xy",
        "xyz",
        "frame",
        "plane_frame",
    ];

    // A function of the user with one of these names keeps it.
    const LATER_ITEMS: &'static [&'static str] = &["check_range", "range_finding", "assembly_size"];

    const FUNCTION_ITEMS: &'static [FunctionItem] = &[RESULT, SWEEP, CALL];

    fn mechanism_name(&self, title: &str) -> String {
        snake_letters(title)
    }

    fn item_name(&self, mechanism: &str, item: &str) -> String {
        format!("{mechanism}_{item}")
    }

    fn spelled(&self, name: &str, scope: Scope) -> String {
        spelled(name, scope)
    }

    fn is_reserved(&self, name: &str, scope: Scope) -> bool {
        // The name of a mechanism is the beginning of its constants.
        let has_macro = || self.constants(name).any(|name| is_macro(&name));
        is_reserved(name, scope) || (scope == Scope::Mechanism && has_macro())
    }

    fn has_function_item(&self, item: &FunctionItem, arguments: usize) -> bool {
        arguments > 0 || *item != SWEEP
    }

    fn names_in(&self, scope: Scope, mechanism: &str, items: &[String]) -> Vec<String> {
        match scope {
            Scope::Mechanism => Vec::new(),
            Scope::File => vec![mechanism.to_owned()],
            Scope::Function => {
                let names = VARIABLES.iter().chain([&mechanism]);
                let names = names.map(|&name| name.to_owned());
                names.chain(items.iter().cloned()).collect()
            }
            // A member of C++ is not called like the type of another one.
            Scope::Members => items[items.len() - VECTORS..].to_vec(),
        }
    }

    fn declared(&self, name: &str, shape: &Shape, items: &[String]) -> String {
        let [.., xy, xyz, frame, plane_frame] = items else {
            unreachable!("a mechanism has the types of vectors and frames")
        };
        match shape {
            Shape::Scalar => format!("{} {name}", self.real.name()),
            Shape::Vector(2) => format!("{xy} {name}"),
            Shape::Vector(_) => format!("{xyz} {name}"),
            Shape::Frame => format!("{frame} {name}"),
            Shape::PlaneFrame => format!("{plane_frame} {name}"),
            Shape::Array(count, entry) => self.declared(&format!("{name}[{count}]"), entry, items),
        }
    }
}
