//! Computes the surface of a mechanism from its declarations.

use linkage_compiler::ir::CompiledMechanism;
use linkage_export::{Declarations, refusals};

use super::constant::{API, constant};
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
    let [check_range, finding, assembly_size] = &declarations.later_items[..] else {
        unreachable!("C has these items")
    };
    let functions = declarations.functions.iter();
    let functions = functions.map(|function| Evaluator::new(prefix, function, real));
    let api = constant(prefix, API);
    let declared = |result, name, parameters: &str| Declared::new(&api, result, name, parameters);
    let takes = format!("{prefix} *m, const {dimensions_type} *dimensions");
    Surface {
        codes: codes(prefix, title, &refusals),
        title: plain(title),
        real,
        functions: functions.collect(),
        assemble: declared("int", assemble, &takes),
        assembly_size: declared("size_t", assembly_size, "void"),
        error: declared("const char *", error, "int code"),
        range: RangeNames::new(prefix, check_range, finding),
        ok: declared("int", ok, &format!("{} number", real.name())),
        constants: constants.clone(),
        dimensions_type: dimensions_type.clone(),
        vectors: std::array::from_fn::<_, VECTORS, _>(|number| vectors[number].clone()),
        declarations,
    }
}
