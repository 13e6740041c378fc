//! The `STRUCTURE` constant.

use linkage_symbolic::count::Count;

use super::count;
use super::outline::{Outline, plain};
use linkage_compiler::ir::{CompiledMechanism, Group};

/// The literal of the runtime's `Structure`.
pub(super) fn literal(outline: &Outline, unit: &CompiledMechanism) -> String {
    let mobility = unit.mobility;
    let groups: String = unit.groups.iter().map(group).collect();
    let functions = outline.functions.iter().zip(&unit.functions);
    let functions = functions.map(|(function, compiled)| {
        let name = plain(function.name);
        let operations = count::literal(&compiled.called.count);
        format!("__p::function({name:?}, {operations}),")
    });
    let functions: String = functions.collect();
    let prepare = count::literal(&Count::of_program(&unit.prepare));
    format!(
        "__p::Structure {{
            mobility: {mobility},
            groups: &[{groups}],
            functions: &[{functions}],
            prepare: __p::operations({prepare}),
        }}"
    )
}

/// A structure with nothing in it, for the skeleton.
pub(super) fn empty(outline: &Outline) -> String {
    literal(outline, &CompiledMechanism::default())
}

fn group(group: &Group) -> String {
    let Group {
        class,
        order,
        kind,
        loops,
        joints,
        unknowns,
        method,
        ..
    } = group;
    let mode = match group.mode {
        Some(mode) => format!("__p::Some({mode})"),
        None => "__p::None".to_owned(),
    };
    format!(
        "__p::Group {{
            class: {class}u8,
            order: {order}u8,
            kind: {kind:?},
            loops: &{loops:?},
            joints: {joints:?},
            unknowns: &{unknowns:?},
            mode: {mode},
            method: {method:?},
        }},"
    )
}
