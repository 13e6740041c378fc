//! Computes the surface of a mechanism from its declarations.

use linkage_compiler::ir::CompiledMechanism;
use linkage_export::{Declarations, refusals};

use super::data::Surface;
use super::declared::Declared;
use super::evaluator::Evaluator;
use super::range_names::RangeNames;
use super::refusal::codes;
use super::target::{C, VECTORS};
use crate::c_names::plain;
use crate::real::Real;

/// The surface of a mechanism that is called `title` in its declaration.
pub(crate) fn surface<'a>(title: &'a str, unit: &'a CompiledMechanism, real: Real) -> Surface<'a> {
    let refusals = refusals(unit);
    let c = C {
        real,
        refusals: &refusals,
    };
    let declarations = Declarations::new(title, unit, &c);
    let prefix = &declarations.name;
    let [
        dimensions_type,
        assemble,
        error,
        ok,
        constants,
        vectors @ ..,
    ] = &declarations.items[..]
    else {
        unreachable!("C has these items")
    };
    let functions = declarations.functions.iter();
    let functions = functions.map(|function| Evaluator::new(prefix, function, real));
    Surface {
        codes: codes(prefix, title, &refusals),
        title: plain(title),
        real,
        functions: functions.collect(),
        assemble: Declared {
            signature: format!("int {assemble}({prefix} *m, const {dimensions_type} *dimensions)"),
            name: assemble.clone(),
        },
        error: Declared {
            signature: format!("const char *{error}(int code)"),
            name: error.clone(),
        },
        range: RangeNames::new(prefix, fixed(&declarations.later_items)),
        ok: Declared {
            signature: format!("int {ok}({} number)", real.name()),
            name: ok.clone(),
        },
        constants: constants.clone(),
        dimensions_type: dimensions_type.clone(),
        vectors: fixed::<VECTORS>(vectors),
        declarations,
    }
}

/// Returns the names of items whose number is known.
fn fixed<const COUNT: usize>(names: &[String]) -> [String; COUNT] {
    std::array::from_fn(|index| names[index].clone())
}
