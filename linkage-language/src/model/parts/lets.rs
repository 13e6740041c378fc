//! Derived quantities that come with a part.

use crate::model::symbols::values::Values;
use crate::model::types::{Expr, Let, Mechanism};
use crate::syntax::PartItem;

pub(in crate::model) fn add_let(
    values: &mut Values,
    mechanism: &mut Mechanism,
    item: &PartItem,
    name: &str,
    value: Expr,
) {
    values.note_let(&value);
    let name = format!("{}.{name}", item.name);
    mechanism.lets.push(Let {
        name,
        value,
        is_unknown_frame: false,
    });
}
