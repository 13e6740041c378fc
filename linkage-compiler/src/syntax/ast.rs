//! The syntax tree: one type per grammar rule, names with their spans, numbers as written.

use proc_macro2::{Ident, TokenStream};

use super::vocabulary::vocabulary;
use super::words::{ClauseWord, DeclarationWord, ItemWord, LoadWord};
use crate::diagnostic::SourceSpan;

/// The whole macro input: the struct block and the `impl` block.
#[derive(Debug)]
pub struct MechanismDef {
    /// Outer attributes of the struct, doc comments included, as written (`#[...] #[...]`).
    pub attributes: Vec<Attribute>,
    /// `pub`, `pub(crate)` or nothing.
    pub visibility: TokenStream,
    pub name: Ident,
    pub items: Vec<Item>,
    pub functions: Vec<FunctionDef>,
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
    Unknown(NamedItem),
    Let(NamedItem),
    Loop(LoopItem),
    /// `argument NAME = expr;`
    Argument(NamedItem),
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
pub struct UnitItem {
    pub unit: Ident,
    pub span: SourceSpan,
}

/// `const NAME = expr;`, `let NAME = expr;`, `unknown NAME = expr;`
#[derive(Debug)]
pub struct NamedItem {
    pub attributes: Vec<Attribute>,
    pub name: Ident,
    pub value: Expr,
}

/// `param NAME = expr [+- tol];`
#[derive(Debug)]
pub struct ParamItem {
    pub attributes: Vec<Attribute>,
    pub name: Ident,
    pub value: Toleranced,
}

/// A parameter's value: a single toleranced expression, or a vector whose components have tolerances of their own.
#[derive(Debug)]
pub enum Toleranced {
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
pub struct InputItem {
    pub attributes: Vec<Attribute>,
    pub name: Ident,
    pub value: Expr,
    /// `lo..hi` (`lo..=hi` is accepted and means the same).
    pub range: Option<(Expr, Expr)>,
    /// Names of the arguments that are its speed and acceleration.
    pub speed: Option<Ident>,
    pub acceleration: Option<Ident>,
}

/// `loop expr = expr;`
#[derive(Debug)]
pub struct LoopItem {
    pub left: Expr,
    pub right: Expr,
    pub span: SourceSpan,
}

/// `gravity = expr;`
#[derive(Debug)]
pub struct GravityItem {
    pub value: Expr,
    pub span: SourceSpan,
}

/// `body NAME = JOINT, turns expr, mass expr at expr, inertia expr [at expr];`, the clauses after the joint in any order.
#[derive(Debug)]
pub struct BodyItem {
    pub attributes: Vec<Attribute>,
    pub name: Ident,
    /// What the body hangs on; its point is the body's origin.
    pub joint: JointPart,
    pub turns: Option<Expr>,
    pub masses: Vec<MassPart>,
    pub inertias: Vec<InertiaPart>,
}

/// `KIND [NAME] on BODY at expr [along expr | about expr]`, the clauses after the name in any order.
#[derive(Debug)]
pub struct JointPart {
    pub kind: JointKind,
    pub name: Option<Ident>,
    pub on: Ident,
    pub at: Expr,
    /// The guide of a slide, the axis of a pin or a cylinder in space.
    pub direction: Option<Expr>,
    pub span: SourceSpan,
}

vocabulary! {
    /// What a joint lets free.
    pub enum JointKind {
        Pin = "pin",
        Slide = "slide",
        Ball = "ball",
        Cylinder = "cylinder",
        Fixed = "fixed",
    }
}

/// `mass expr at expr`
#[derive(Debug)]
pub struct MassPart {
    pub mass: Expr,
    pub at: Expr,
}

/// `inertia expr [at expr]`: about the body's centre of mass, or about a point.
#[derive(Debug)]
pub struct InertiaPart {
    pub inertia: Expr,
    pub at: Option<Expr>,
}

/// A joint between two bodies that hang on others: `pin NAME = BODY on BODY at expr;`
#[derive(Debug)]
pub struct JointItem {
    pub attributes: Vec<Attribute>,
    /// The body on which the reaction acts.
    pub body: Ident,
    /// Its name is never missing.
    pub joint: JointPart,
}

/// `force expr on BODY [from BODY] at expr;`, `torque expr on BODY [from BODY];`
#[derive(Debug)]
pub struct LoadItem {
    pub value: Expr,
    pub on: Ident,
    /// The body that takes the opposite; the frame if it is not named.
    pub from: Option<Ident>,
    pub at: Option<Expr>,
    pub span: SourceSpan,
}

/// `spring expr BETWEEN [, free expr];`, `damper expr BETWEEN;`
#[derive(Debug)]
pub struct ElementItem {
    /// Stiffness or damping.
    pub value: Expr,
    pub between: Between,
    /// Length or angle without force; zero if it is not given.
    pub free: Option<Expr>,
    pub span: SourceSpan,
}

#[derive(Debug)]
pub enum Between {
    /// `from BODY at expr to BODY at expr`
    Points([(Ident, Expr); 2]),
    /// `on JOINT`
    Joint(Ident),
}

#[derive(Clone, Debug)]
pub struct Expr {
    pub kind: ExprKind,
    pub span: SourceSpan,
}

#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A number and its unit suffix (empty: none), both as written; `text` has no underscores.
    Number {
        text: String,
        suffix: String,
    },
    Name(Ident),
    /// `(a, b)` or `(a, b, c)`; any other count is kept too, for `resolve` to refuse.
    Tuple(Vec<Expr>),
    /// `v.x`
    Field(Box<Expr>, Ident),
    /// `v[0]`
    Index(Box<Expr>, Box<Expr>),
    Negate(Box<Expr>),
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `mm^2`: a power, of units only.
    Power(Box<Expr>, i32),
    /// `name(args)`, also `d(...)`, `sensitivity(q, [..])`, `margin()`.
    Call(Ident, Vec<Expr>),
    /// `[a, b]`, only meaningful as second argument of `sensitivity`.
    List(Vec<Expr>),
    /// What a syntax error left behind; it has been reported, later phases stay silent about it.
    Error,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
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

impl Expr {
    /// What a mistake leaves behind.
    pub fn error(span: SourceSpan) -> Self {
        Expr {
            kind: ExprKind::Error,
            span,
        }
    }
}

impl JointKind {
    /// The clause that names its direction.
    pub(crate) fn direction_word(self) -> ClauseWord {
        match self {
            JointKind::Slide => ClauseWord::Along,
            // Those without a direction are asked for none.
            JointKind::Pin | JointKind::Ball | JointKind::Cylinder | JointKind::Fixed => {
                ClauseWord::About
            }
        }
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
