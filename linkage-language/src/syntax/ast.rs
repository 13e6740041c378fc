//! The syntax tree: one type per grammar rule, names with their spans, numbers as written.

use proc_macro2::{Ident, TokenStream};
use syn::LitStr;
use syn::ext::IdentExt;

use super::expression_tree::{Expr, ExprKind, Toleranced};
use super::item_name::ItemName;
use super::keyword::{DeclarationWord, ItemWord, LoadWord};
use super::link_elements::LinkElements;
use super::link_inventory::{LinkInventory, LinkLoop};
use super::linked_tree::LinkedItem;
use super::mechanics_tree::{BodyItem, ElementItem, FrictionItem, JointItem, LoadItem, Member};
use crate::diagnostic::{Diagnostics, SourceSpan};

/// One mechanism of the macro's input: its struct block and its `impl` blocks.
#[derive(Debug)]
pub struct MechanismDef {
    /// Outer attributes of the struct, doc comments included, as written (`#[...] #[...]`).
    pub attributes: Vec<Attribute>,
    /// `pub`, `pub` or nothing.
    pub visibility: TokenStream,
    pub name: Ident,
    pub items: Vec<Item>,
    pub functions: Vec<FunctionDef>,
    /// The joints and links that items stand for, once these have taken their place.
    pub links: Option<LinkInventory>,
    /// The links and wheels among these.
    pub link_elements: LinkElements,
    /// Warnings about joints and links.
    pub warnings: Diagnostics,
    /// True after a mistake in joints and links: their bodies and quantities are unknown.
    pub links_are_lost: bool,
    /// True after a mistake in the name of a joint, link or slider: any unknown name may be meant.
    pub link_names_are_lost: bool,
}

impl MechanismDef {
    /// Its name as it is read: `loop` for `r#loop`.
    pub fn title(&self) -> String {
        self.name.unraw().to_string()
    }
}

/// The lines of a doc comment, without the blank in front.
pub fn documentation(attributes: &[Attribute]) -> String {
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
pub struct Attribute {
    /// The path's last segment: `doc`, `derive`, `allow`, ...
    pub name: String,
    /// The complete attribute, `#` and brackets included.
    pub tokens: TokenStream,
    /// The tokens between the brackets after the path (`derive(...)`: the group).
    pub arguments: TokenStream,
    pub span: SourceSpan,
}

#[derive(Debug)]
pub enum Item {
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
    Friction(FrictionItem),
    Arc(ArcItem),
    /// A joint, a link or the like. `model::links` replaces all of them by other items.
    Linked(LinkedItem),
}

/// `unit mm;`
#[derive(Debug)]
pub struct UnitItem {
    pub unit: Ident,
    pub span: SourceSpan,
}

/// `const NAME = expr;`, `let NAME = expr;`
#[derive(Debug)]
pub struct NamedItem {
    pub name: ItemName,
    pub value: Expr,
}

/// `unknown NAME = expr;`, `unknown NAME;`
#[derive(Debug)]
pub struct UnknownItem {
    pub name: ItemName,
    pub estimate: Option<Expr>,
}

/// `param NAME = expr [+- tol];`
#[derive(Debug)]
pub struct ParamItem {
    pub attributes: Vec<Attribute>,
    pub name: ItemName,
    pub value: Toleranced,
}

/// `input NAME = expr [in lo..hi] [at SPEED [, ACCELERATION]];`
#[derive(Debug)]
pub struct InputItem {
    pub name: Ident,
    pub value: Expr,
    /// `lo..hi` (`lo..=hi` is accepted and means the same).
    pub range: Option<(Expr, Expr)>,
    /// Names of the arguments that are its speed and acceleration.
    pub speed: Option<Ident>,
    pub acceleration: Option<Ident>,
}

/// `loop expr = expr [redundant];`
#[derive(Debug)]
pub struct LoopItem {
    /// It follows from the others, and determines nothing.
    pub redundant: bool,
    pub left: Expr,
    pub right: Expr,
    pub span: SourceSpan,
    /// The joint or link that it stands for.
    pub of: Option<LinkLoop>,
}

/// `part NAME: MECHANISM { given = expr, ... } [on BODY] [at expr] [, turned by expr];`
#[derive(Debug)]
pub struct PartItem {
    pub name: Ident,
    /// The struct of the mechanism that it is.
    pub mechanism: Ident,
    /// Its inputs, and other names of it that are given by the mechanism around it.
    pub given: Vec<GivenPart>,
    /// False if something between the braces could not be read, which has been reported.
    pub whole: bool,
    /// The body that its frame is fixed on.
    pub on: Option<Member>,
    /// Its origin, or its frame in space.
    pub at: Option<Expr>,
    /// The angle of its x axis.
    pub turned: Option<Expr>,
}

/// `phi = shaft`
#[derive(Debug)]
pub struct GivenPart {
    pub name: Ident,
    pub value: Expr,
}

/// `arc NAME: point around point [turned by angle];`
#[derive(Debug)]
pub struct ArcItem {
    pub name: Ident,
    /// The point in the slot.
    pub slider: Expr,
    pub centre: Expr,
    /// The angle of the link that has the slot; without it, the frame has it.
    pub turned: Option<Expr>,
}

/// `gravity = expr;`
#[derive(Debug)]
pub struct GravityItem {
    pub value: Expr,
    pub span: SourceSpan,
}

/// `pub fn NAME(inputs) -> TYPE { quantities }`
#[derive(Debug)]
pub struct FunctionDef {
    pub attributes: Vec<Attribute>,
    pub visibility: TokenStream,
    pub name: Ident,
    pub inputs: Vec<Ident>,
    pub result: Ident,
    pub quantities: Vec<QuantityDef>,
}

/// `tracer` or `field: expr`
#[derive(Debug)]
pub struct QuantityDef {
    pub attributes: Vec<Attribute>,
    pub field: Ident,
    pub value: Expr,
}

impl UnknownItem {
    /// The number of arguments in `unknown NAME = frame(...);`, a body of the plane (2) or of space
    /// (3).
    pub fn frame_arguments(&self) -> Option<usize> {
        match &self.estimate.as_ref()?.kind {
            ExprKind::Call(function, arguments) if function == "frame" => Some(arguments.len()),
            // Anything else is a number or a vector.
            _ => None,
        }
    }

    pub fn is_frame(&self) -> bool {
        self.frame_arguments().is_some()
    }
}

impl Item {
    /// The word that it begins with.
    pub fn word(&self) -> ItemWord {
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
            Item::Arc(_) => ItemWord::Declaration(Declared::Arc),
            Item::Joint(item) => ItemWord::Joint(item.joint.kind),
            Item::Force(_) => ItemWord::Load(LoadWord::Force),
            Item::Torque(_) => ItemWord::Load(LoadWord::Torque),
            Item::Spring(_) => ItemWord::Load(LoadWord::Spring),
            Item::Damper(_) => ItemWord::Load(LoadWord::Damper),
            Item::Friction(_) => ItemWord::Load(LoadWord::Friction),
            Item::Linked(item) => ItemWord::Linked(item.word()),
        }
    }
}
