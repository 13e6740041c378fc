//! The syntax tree: one type per grammar rule, names with their spans, numbers as written.

use proc_macro2::{Ident, TokenStream};
use syn::LitStr;
use syn::ext::IdentExt;

use super::expression_tree::{Expr, ExprKind};
use super::keyword::{DeclarationWord, ItemWord, LoadWord};
use super::mechanics_tree::{BodyItem, ElementItem, JointItem, LoadItem, Member};
use crate::diagnostic::SourceSpan;

/// One mechanism of the macro's input: its struct block and its `impl` blocks.
#[derive(Debug)]
pub(crate) struct MechanismDef {
    /// Outer attributes of the struct, doc comments included, as written (`#[...] #[...]`).
    pub(crate) attributes: Vec<Attribute>,
    /// `pub`, `pub(crate)` or nothing.
    pub(crate) visibility: TokenStream,
    pub(crate) name: Ident,
    pub(crate) items: Vec<Item>,
    pub(crate) functions: Vec<FunctionDef>,
}

impl MechanismDef {
    /// Its name as it is read: `loop` for `r#loop`.
    pub(crate) fn title(&self) -> String {
        self.name.unraw().to_string()
    }
}

/// The lines of a doc comment, without the blank in front.
pub(crate) fn documentation(attributes: &[Attribute]) -> String {
    let docs = attributes
        .iter()
        .filter(|attribute| attribute.name == "doc");
    let text = |attribute: &Attribute| {
        let literal = attribute.arguments.clone().into_iter().last()?;
        let text = syn::parse2::<LitStr>(literal.into()).ok()?.value();
        Some(text.strip_prefix(' ').map_or(text.clone(), str::to_owned))
    };
    docs.filter_map(text).collect::<Vec<_>>().join("\n")
}

/// One outer attribute.
#[derive(Clone, Debug)]
pub(crate) struct Attribute {
    /// The path's last segment: `doc`, `derive`, `allow`, ...
    pub(crate) name: String,
    /// The complete attribute, `#` and brackets included.
    pub(crate) tokens: TokenStream,
    /// The tokens between the brackets after the path (`derive(...)`: the group).
    pub(crate) arguments: TokenStream,
    pub(crate) span: SourceSpan,
}

#[derive(Debug)]
pub(crate) enum Item {
    Unit(UnitItem),
    Const(NamedItem),
    Param(ParamItem),
    Input(InputItem),
    Unknown(UnknownItem),
    Let(NamedItem),
    Loop(LoopItem),
    /// `argument NAME = expr;`
    Argument(NamedItem),
    Part(PartItem),
    Gravity(GravityItem),
    Body(BodyItem),
    Joint(JointItem),
    Force(LoadItem),
    Torque(LoadItem),
    Spring(ElementItem),
    Damper(ElementItem),
}

/// `unit mm;`
#[derive(Debug)]
pub(crate) struct UnitItem {
    pub(crate) unit: Ident,
    pub(crate) span: SourceSpan,
}

/// `const NAME = expr;`, `let NAME = expr;`
#[derive(Debug)]
pub(crate) struct NamedItem {
    pub(crate) name: Ident,
    pub(crate) value: Expr,
}

/// `unknown NAME = expr;`, `unknown NAME;`
#[derive(Debug)]
pub(crate) struct UnknownItem {
    pub(crate) name: Ident,
    pub(crate) estimate: Option<Expr>,
}

/// `param NAME = expr [+- tol];`
#[derive(Debug)]
pub(crate) struct ParamItem {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) value: Toleranced,
}

/// A parameter's value: one expression with a tolerance, or a vector whose components have
/// tolerances.
#[derive(Debug)]
pub(crate) enum Toleranced {
    /// `nominal [+- tolerance]`; the nominal value may be a scalar or a vector.
    Single {
        nominal: Expr,
        tolerance: Option<Expr>,
    },
    /// `(x [+- tx], y [+- ty])` where at least one component has a tolerance.
    Components {
        components: Vec<(Expr, Option<Expr>)>,
        span: SourceSpan,
    },
}

/// `input NAME = expr [in lo..hi] [at SPEED [, ACCELERATION]];`
#[derive(Debug)]
pub(crate) struct InputItem {
    pub(crate) name: Ident,
    pub(crate) value: Expr,
    /// `lo..hi` (`lo..=hi` is accepted and means the same).
    pub(crate) range: Option<(Expr, Expr)>,
    /// Names of the arguments that are its speed and acceleration.
    pub(crate) speed: Option<Ident>,
    pub(crate) acceleration: Option<Ident>,
}

/// `loop expr = expr [redundant];`
#[derive(Debug)]
pub(crate) struct LoopItem {
    /// It follows from the others, and determines nothing.
    pub(crate) redundant: bool,
    pub(crate) left: Expr,
    pub(crate) right: Expr,
    pub(crate) span: SourceSpan,
}

/// `part NAME: MECHANISM { given = expr, ... } [on BODY] [at expr] [, turned by expr];`
#[derive(Debug)]
pub(crate) struct PartItem {
    pub(crate) name: Ident,
    /// The struct of the mechanism that it is.
    pub(crate) mechanism: Ident,
    /// Its inputs, and other names of it that are given by the mechanism around it.
    pub(crate) given: Vec<GivenPart>,
    /// False if something between the braces could not be read, which has been reported.
    pub(crate) whole: bool,
    /// The body that its frame is fixed on.
    pub(crate) on: Option<Member>,
    /// Its origin, or its frame in space.
    pub(crate) at: Option<Expr>,
    /// The angle of its x axis.
    pub(crate) turned: Option<Expr>,
}

/// `phi = shaft`
#[derive(Debug)]
pub(crate) struct GivenPart {
    pub(crate) name: Ident,
    pub(crate) value: Expr,
}

/// `gravity = expr;`
#[derive(Debug)]
pub(crate) struct GravityItem {
    pub(crate) value: Expr,
    pub(crate) span: SourceSpan,
}

/// `pub fn NAME(inputs) -> TYPE { quantities }`
#[derive(Debug)]
pub(crate) struct FunctionDef {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) visibility: TokenStream,
    pub(crate) name: Ident,
    pub(crate) inputs: Vec<Ident>,
    pub(crate) result: Ident,
    pub(crate) quantities: Vec<QuantityDef>,
}

/// `tracer` or `field: expr`
#[derive(Debug)]
pub(crate) struct QuantityDef {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) field: Ident,
    pub(crate) value: Expr,
}

impl UnknownItem {
    /// The number of arguments in `unknown NAME = frame(...);`, a body of the plane (2) or of space
    /// (3).
    pub(crate) fn frame_arguments(&self) -> Option<usize> {
        match &self.estimate.as_ref()?.kind {
            ExprKind::Call(function, arguments) if function == "frame" => Some(arguments.len()),
            // Anything else is a number or a vector.
            _ => None,
        }
    }

    pub(crate) fn is_frame(&self) -> bool {
        self.frame_arguments().is_some()
    }
}

impl Item {
    /// The word that it begins with.
    pub(crate) fn word(&self) -> ItemWord {
        use DeclarationWord as Declared;
        match self {
            Item::Unit(_) => ItemWord::Declaration(Declared::Unit),
            Item::Const(_) => ItemWord::Declaration(Declared::Const),
            Item::Param(_) => ItemWord::Declaration(Declared::Param),
            Item::Input(_) => ItemWord::Declaration(Declared::Input),
            Item::Unknown(_) => ItemWord::Declaration(Declared::Unknown),
            Item::Let(_) => ItemWord::Declaration(Declared::Let),
            Item::Loop(_) => ItemWord::Declaration(Declared::Loop),
            Item::Argument(_) => ItemWord::Declaration(Declared::Argument),
            Item::Part(_) => ItemWord::Declaration(Declared::Part),
            Item::Gravity(_) => ItemWord::Declaration(Declared::Gravity),
            Item::Body(_) => ItemWord::Declaration(Declared::Body),
            Item::Joint(item) => ItemWord::Joint(item.joint.kind),
            Item::Force(_) => ItemWord::Load(LoadWord::Force),
            Item::Torque(_) => ItemWord::Load(LoadWord::Torque),
            Item::Spring(_) => ItemWord::Load(LoadWord::Spring),
            Item::Damper(_) => ItemWord::Load(LoadWord::Damper),
        }
    }
}
