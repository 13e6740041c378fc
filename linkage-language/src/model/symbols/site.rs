//! Places of expressions, and the names that can be used there.

use super::declared_names::Symbol;
use crate::model::types::Name;
use crate::syntax::is_meant_as_unit;

/// The place of an expression, which decides about the names that it can use.
#[derive(Clone, Copy)]
pub(in crate::model) enum Site<'a> {
    Constant,
    Parameter,
    Input,
    Estimate,
    Argument,
    /// A parameter of a part.
    PartParameter,
    LetOrLoop,
    /// A clause of bodies, joints and loads.
    Mechanics,
    /// A function of these inputs; `None` if its list has a mistake.
    Function(Option<&'a [usize]>),
}

#[derive(Clone, Copy)]
pub(in crate::model) struct Context<'a> {
    pub(in crate::model) site: Site<'a>,
    /// Position of the item, to find uses before the definition.
    pub(in crate::model) item: usize,
}

impl Context<'static> {
    /// Clauses of bodies, joints and loads may use all names.
    pub(in crate::model) const MECHANICS: Self = Context {
        site: Site::Mechanics,
        item: usize::MAX,
    };

    /// Functions may use all names.
    pub(in crate::model) const FUNCTION: Self = Context {
        site: Site::Function(None),
        item: usize::MAX,
    };
}

/// Returns the rule of a place in which not all names can be used.
pub(in crate::model) fn rule(site: Site) -> Option<&'static str> {
    match site {
        Site::Constant => Some("a constant may use numbers, functions and constants only"),
        Site::Parameter => {
            Some("a value or tolerance may use numbers, functions and constants only")
        }
        Site::Input => Some(
            "the reference and range of an input may use numbers, functions and constants only",
        ),
        Site::Argument => {
            Some("the value of an argument may use numbers, functions and constants only")
        }
        Site::Estimate => {
            Some("an estimate may use numbers, functions, constants and parameters only")
        }
        Site::PartParameter => Some(
            "a parameter of a part is given by numbers, functions, constants and parameters only",
        ),
        Site::LetOrLoop | Site::Mechanics | Site::Function(_) => None,
    }
}

/// Returns fact and help for a name that cannot be used here.
pub(in crate::model) fn refusal(symbol: &Symbol, context: Context) -> Option<(String, String)> {
    let text = &symbol.text;
    let constant = matches!(symbol.name, Name::Const(_));
    let parameter = matches!(symbol.name, Name::Parameter(_));
    let rule = rule(context.site).unwrap_or_default();
    let allowed = match context.site {
        Site::Constant | Site::Parameter | Site::Input | Site::Argument => constant,
        Site::Estimate | Site::PartParameter => constant || parameter,
        Site::LetOrLoop | Site::Mechanics | Site::Function(_) => true,
    };
    if !allowed {
        return Some((
            format!("`{text}` is {}, which cannot be used here", symbol.kind()),
            if is_meant_as_unit(text) {
                format!("{rule}; the name hides the unit `{text}`")
            } else {
                rule.to_owned()
            },
        ));
    }
    let ordered = match context.site {
        Site::Constant => constant,
        // It is no definition but a coordinate.
        Site::LetOrLoop if symbol.is_unknown_frame => false,
        Site::LetOrLoop => matches!(symbol.name, Name::Let(_)),
        // The names that they can use are resolved before them.
        Site::Parameter
        | Site::Input
        | Site::Estimate
        | Site::Argument
        | Site::PartParameter
        | Site::Mechanics
        | Site::Function(_) => false,
    };
    if ordered && symbol.item == context.item {
        let fact = format!("`{text}` is used in its own definition");
        return Some((
            fact,
            "write it as an `unknown` if a `loop` is to determine it".to_owned(),
        ));
    }
    if ordered && symbol.item > context.item {
        let fact = format!("`{text}` is used before its definition");
        return Some((fact, format!("move the definition of `{text}` up")));
    }
    None
}
