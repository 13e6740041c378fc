//! The syntax tree: one type per grammar rule, names with their spans, numbers as written.

use proc_macro2::{Ident, TokenStream};
use syn::LitStr;
use syn::ext::IdentExt;

use super::keyword::{DeclarationWord, ItemWord, JointKind, LoadWord};
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
    let docs = attributes.iter().filter(|own| own.name == "doc");
    let text = |own: &Attribute| {
        let literal = own.arguments.clone().into_iter().last()?;
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

/// A parameter's value: a single toleranced expression, or a vector whose components have tolerances of their own.
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
    /// Where its origin is, or its frame in space.
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

/// `body NAME = JOINT, turns expr, mass expr at expr, inertia expr [at expr];`, the clauses after the joint in any order.
#[derive(Debug)]
pub(crate) struct BodyItem {
    pub(crate) name: Ident,
    /// What the body hangs on; its point is the body's origin.
    pub(crate) joint: JointPart,
    pub(crate) turns: Option<Expr>,
    pub(crate) masses: Vec<MassPart>,
    pub(crate) inertias: Vec<InertiaPart>,
}

/// `KIND [NAME] on BODY at expr [along expr | about expr]`, the clauses after the name in any order.
#[derive(Debug)]
pub(crate) struct JointPart {
    pub(crate) kind: JointKind,
    pub(crate) name: Option<Ident>,
    pub(crate) on: Member,
    pub(crate) at: Expr,
    /// The guide of a slide, the axis of a pin or a cylinder in space.
    pub(crate) direction: Option<Expr>,
    pub(crate) span: SourceSpan,
}

/// `mass expr at expr`
#[derive(Debug)]
pub(crate) struct MassPart {
    pub(crate) mass: Expr,
    pub(crate) at: Expr,
}

/// `inertia expr [at expr]`: about the body's centre of mass, or about a point.
#[derive(Debug)]
pub(crate) struct InertiaPart {
    pub(crate) inertia: Expr,
    pub(crate) at: Option<Expr>,
}

/// A joint between two bodies that hang on others: `pin NAME = BODY on BODY at expr;`
#[derive(Debug)]
pub(crate) struct JointItem {
    /// The body on which the reaction acts.
    pub(crate) body: Member,
    /// Its name is never missing.
    pub(crate) joint: JointPart,
}

/// The name of a body or a joint, with those of the parts that it belongs to in front: `rod`, `hook.rod`.
#[derive(Clone, Debug)]
pub(crate) struct Member {
    pub(crate) text: String,
    pub(crate) span: SourceSpan,
}

/// `force expr on BODY [from BODY] at expr;`, `torque expr on BODY [from BODY];`
#[derive(Debug)]
pub(crate) struct LoadItem {
    pub(crate) value: Expr,
    pub(crate) on: Member,
    /// The body that takes the opposite; the frame if it is not named.
    pub(crate) from: Option<Member>,
    pub(crate) at: Option<Expr>,
    pub(crate) span: SourceSpan,
}

/// `spring expr BETWEEN [, free expr];`, `damper expr BETWEEN;`
#[derive(Debug)]
pub(crate) struct ElementItem {
    /// Stiffness or damping.
    pub(crate) value: Expr,
    pub(crate) between: Between,
    /// Length or angle without force; zero if it is not given.
    pub(crate) free: Option<Expr>,
    pub(crate) span: SourceSpan,
}

#[derive(Debug)]
pub(crate) enum Between {
    /// `from BODY at expr to BODY at expr`
    Points(Box<[(Member, Expr); 2]>),
    /// `on JOINT`
    Joint(Member),
}

#[derive(Clone, Debug)]
pub(crate) struct Expr {
    pub(crate) kind: ExprKind,
    pub(crate) span: SourceSpan,
}

#[derive(Clone, Debug)]
pub(crate) enum ExprKind {
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
pub(crate) enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
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
    /// The number of arguments in `unknown NAME = frame(...);`, a body of the plane (2) or of space (3).
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

impl From<&Ident> for Member {
    fn from(ident: &Ident) -> Self {
        Self {
            text: ident.to_string(),
            span: ident.into(),
        }
    }
}

impl Expr {
    /// What a mistake leaves behind.
    pub(crate) fn error(span: SourceSpan) -> Self {
        Expr {
            kind: ExprKind::Error,
            span,
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
