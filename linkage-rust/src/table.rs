//! Names and units of the columns that sweeps fill: the runtime's `Headed`, by which they are a
//! `Table`.

use proc_macro2::TokenStream;

use super::outline::{Function, Outline, plain};
use super::{attribute, code};
use linkage_compiler::ir::{Column, Meaning};

/// The trait for the columns of a function; nothing for a function without arguments.
pub(super) fn items(outline: &Outline, function: &Function, columns: &[Column]) -> TokenStream {
    if function.arguments.is_empty() {
        return TokenStream::new();
    }
    let everywhere = attribute::everywhere(function.attributes);
    let ty = code::text(&function.columns);
    let name = plain(function.name);
    let arguments: Vec<_> = function.arguments.iter().map(|name| plain(name)).collect();
    let first = columns
        .iter()
        .position(|column| column.meaning == Meaning::Picture);
    let picture = match first {
        Some(first) => {
            let mechanism = code::text(outline.name);
            format!(
                "__p::Some(__p::PictureColumns {{ first: {first}, picture: <{mechanism}<__p::f64>>::PICTURE }})"
            )
        }
        None => "__p::None".to_owned(),
    };
    let columns: String = columns.iter().map(column).collect();
    code::tokens(&format!(
        "__p::if_report! {{
            {everywhere}
            #[automatically_derived]
            #[doc(hidden)]
            impl __p::Headed for {ty}<__p::f64> {{
                const HEADING: &'static __p::Heading = &__p::Heading {{
                    function: {name:?},
                    arguments: &{arguments:?},
                    columns: &[{columns}],
                    picture: {picture},
                }};
            }}
        }}"
    ))
}

fn column(column: &Column) -> String {
    let Column {
        name,
        unit,
        meaning,
    } = column;
    let (plain, quantity) = match *meaning {
        Meaning::Value => (format!("__p::value({name:?}, {unit:?})"), None),
        Meaning::Margin => (format!("__p::margin({name:?}, {unit:?})"), None),
        Meaning::Picture => (format!("__p::drawn({name:?}, {unit:?})"), None),
        Meaning::Rate { order, of } => (format!("__p::rate({name:?}, {unit:?}, {order}u32)"), of),
        Meaning::Sensitivity { parameter, of } => (
            format!("__p::sensitivity({name:?}, {unit:?}, {parameter})"),
            of,
        ),
    };
    match quantity {
        Some(index) => format!("__p::derivative_of({index}, {plain}),"),
        None => plain + ",",
    }
}
