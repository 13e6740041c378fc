//! Derived quantities that come with a part.

use super::types::{Expr, Let, Mechanism};
use super::values::Values;
use crate::syntax::PartItem;

pub(super) fn add_let(
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
