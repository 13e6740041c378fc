//! Emission: from the resolved model and its straight-line programs to Rust items.
//!
//! An `Outline` says which items there are, with which names, types and docs; it is the same for a mechanism without
//! mistakes ([`emit`]) and for what can be said after errors ([`skeleton`]). The other files each print one kind of
//! item. Generated code names only `$crate::__private` and `::core`, and all its own names begin with `__`.

mod assembly;
mod attribute;
mod body;
mod columns;
mod count;
mod docs;
mod evaluator;
pub mod facts;
mod guess;
mod kernels;
mod literal;
mod load;
mod mechanism;
mod outline;
mod shape;
mod skeleton;
mod structure;
mod sweeps;
#[cfg(test)]
mod tests;
mod winding;

use proc_macro2::TokenStream;

pub use self::skeleton::skeleton;

use linkage_symbolic::stages::split;

use self::facts::Facts;
use self::outline::Outline;
use crate::lower::Lowered;
use crate::model::Mechanism;
use crate::syntax::MechanismDef;

/// All items for a mechanism without mistakes. `krate` is the path of the facade.
pub fn emit(
    krate: &TokenStream,
    def: &MechanismDef,
    mechanism: &Mechanism,
    facts: &Facts,
    lowered: &Lowered,
) -> TokenStream {
    let outline = Outline::complete(krate, def, mechanism, facts, lowered);
    let mut items = mechanism::items(&outline);
    items.extend(mechanism::constants(
        &outline,
        &structure::literal(&outline, facts, lowered),
    ));
    items.extend(assembly::items(&outline));
    items.extend(assembly::plumbing(&outline, facts, lowered));
    items.extend(winding::items(&outline, mechanism, facts, lowered));
    for (function, evaluator) in outline.functions.iter().zip(&lowered.evaluators) {
        items.extend(evaluator::items(&outline, function));
        let inputs = &mechanism.evaluators[evaluator.index].inputs;
        let stages = split(&evaluator.program);
        items.extend(evaluator::kernel(&outline, function, &stages, inputs));
        items.extend(columns::items(&outline, function));
        items.extend(kernels::items(&outline, function, &stages));
    }
    items
}
