//! Functions whose names a follower uses for items of its own.

use crate::diagnostic::Reporter;
use crate::message_format::loop_names;
use crate::model::{METHODS_OF_FOLLOWER, Mechanism};
use crate::solve::Formulation;

/// Reports functions whose names are taken in the follower of an assembly. A follower is generated
/// if a coupled group depends on several inputs.
pub(crate) fn check_names_of_follower(
    mechanism: &Mechanism,
    formulation: &Formulation,
    reporter: &mut Reporter,
) {
    let over_several = formulation.groups.iter().find(|solved| {
        let prepared = solved.prepared.as_ref();
        prepared.is_some_and(|prepared| prepared.inputs.len() > 1)
    });
    let Some(solved) = over_several else { return };
    for function in &mechanism.evaluators {
        let name = function.name.as_str();
        if !METHODS_OF_FOLLOWER.contains(&name) {
            continue;
        }
        let loops = &solved.group.loops;
        let fact = format!(
            "the method `{name}` is also generated: {} {} on several inputs, so the assembly has a follower",
            loop_names(mechanism, loops),
            if loops.len() == 1 {
                "depends"
            } else {
                "depend"
            },
        );
        reporter.error_with_help(function.origin, fact, "choose another name");
    }
}
