//! Where expressions stand, and which names they may use there.

use super::names::Symbol;
use crate::model::types::Name;
use crate::syntax::is_unit;

/// Where an expression stands: which names it may use.
#[derive(Clone, Copy)]
pub(in crate::model) enum Place<'a> {
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
    pub(in crate::model) place: Place<'a>,
    /// Position of the item, to find uses before the definition.
    pub(in crate::model) item: usize,
}

impl Context<'static> {
    /// Clauses of bodies, joints and loads may use all names.
    pub(in crate::model) const MECHANICS: Self = Context {
        place: Place::Mechanics,
        item: usize::MAX,
    };

    /// Functions may use all names.
    pub(in crate::model) const FUNCTION: Self = Context {
        place: Place::Function(None),
        item: usize::MAX,
    };
}

/// What may be used in a place where not all names may.
pub(in crate::model) fn rule(place: Place) -> Option<&'static str> {
    match place {
        Place::Constant => Some("a constant may use numbers, functions and constants only"),
        Place::Parameter => {
            Some("a value or tolerance may use numbers, functions and constants only")
        }
        Place::Input => Some(
            "the reference and range of an input may use numbers, functions and constants only",
        ),
        Place::Argument => {
            Some("the value of an argument may use numbers, functions and constants only")
        }
        Place::Estimate => {
            Some("an estimate may use numbers, functions, constants and parameters only")
        }
        Place::PartParameter => Some(
            "a parameter of a part is given by numbers, functions, constants and parameters only",
        ),
        Place::LetOrLoop | Place::Mechanics | Place::Function(_) => None,
    }
}

/// Why a name cannot be used here, and what to do.
pub(in crate::model) fn refusal(symbol: &Symbol, context: Context) -> Option<(String, String)> {
    let text = &symbol.text;
    let constant = matches!(symbol.name, Name::Const(_));
    let parameter = matches!(symbol.name, Name::Parameter(_));
    let rule = rule(context.place).unwrap_or_default();
    let allowed = match context.place {
        Place::Constant | Place::Parameter | Place::Input | Place::Argument => constant,
        Place::Estimate | Place::PartParameter => constant || parameter,
        Place::LetOrLoop | Place::Mechanics | Place::Function(_) => true,
    };
    if !allowed {
        return Some((
            format!("`{text}` is {}, which cannot be used here", symbol.kind()),
            match is_unit(text) {
                true => format!("{rule}; the name hides the unit `{text}`"),
                false => rule.to_owned(),
            },
        ));
    }
    let ordered = match context.place {
        Place::Constant => constant,
        // It is no definition but a coordinate.
        Place::LetOrLoop if symbol.is_unknown_frame => false,
        Place::LetOrLoop => matches!(symbol.name, Name::Let(_)),
        // What they may use is resolved before them.
        Place::Parameter
        | Place::Input
        | Place::Estimate
        | Place::Argument
        | Place::PartParameter
        | Place::Mechanics
        | Place::Function(_) => false,
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
