//! The operations of functions and the quantities of their fields, from a text that was compiled.

use std::collections::BTreeMap;

use linkage_compiler::Checked;
use linkage_compiler::ir::plain;
use linkage_runtime::support::operations;

/// A compiled function.
#[derive(Clone, Debug)]
pub(crate) struct FunctionFacts {
    pub(crate) mechanism: String,
    pub(crate) name: String,
    /// `12 add, 9 mul, 1 sqrt`
    pub(crate) operations: String,
    /// The quantity and the unit of each field, by its name: `` derivative of `p` by `phi`, in
    /// mm/rad ``; empty for a number that its name describes.
    pub(crate) fields: BTreeMap<String, String>,
}

/// Returns the functions of a mechanism, perhaps compiled in other ranges than the declared ones.
pub(crate) fn functions(checked: &Checked) -> Vec<FunctionFacts> {
    let unit = checked.unit.as_ref().or(checked.out_of_range.as_ref());
    let (Some(mechanism), Some(unit)) = (&checked.name, unit) else {
        return Vec::new();
    };
    let facts = unit.functions.iter().map(|function| FunctionFacts {
        mechanism: mechanism.clone(),
        name: plain(&function.name).to_owned(),
        operations: operations(function.called.count.by_class()).to_string(),
        fields: function
            .fields
            .iter()
            .map(|field| (plain(&field.name).to_owned(), field.description()))
            .collect(),
    });
    facts.collect()
}
