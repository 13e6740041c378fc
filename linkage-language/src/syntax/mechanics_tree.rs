//! The syntax tree of bodies, joints and loads.

use proc_macro2::Ident;

use super::expression_tree::Expr;
use super::keyword::JointKind;
use crate::diagnostic::SourceSpan;

/// `body NAME = JOINT, turns expr, mass expr at expr, inertia expr [at expr];`, the clauses after
/// the joint in any order.
#[derive(Debug)]
pub struct BodyItem {
    pub name: Ident,
    /// The joint that the body is attached by; its point is the body's origin.
    pub joint: JointPart,
    pub turns: Option<Expr>,
    pub masses: Vec<MassPart>,
    pub inertias: Vec<InertiaPart>,
}

/// `KIND [NAME] on BODY at expr [along expr | about expr]`, the clauses after the name in any
/// order.
#[derive(Debug)]
pub struct JointPart {
    pub kind: JointKind,
    pub name: Option<Ident>,
    pub on: Member,
    pub at: Expr,
    /// The guide of a slide, the axis of a pin or a cylinder in space.
    pub direction: Option<Expr>,
    pub span: SourceSpan,
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
    /// The body on which the reaction acts.
    pub body: Member,
    /// Its name is never missing.
    pub joint: JointPart,
}

/// The name of a body or a joint, after the names of its parts: `rod`, `hook.rod`.
#[derive(Clone, Debug)]
pub struct Member {
    pub text: String,
    pub span: SourceSpan,
}

/// `force expr on BODY [from BODY] at expr;`, `torque expr on BODY [from BODY];`
#[derive(Debug)]
pub struct LoadItem {
    pub value: Expr,
    pub on: Member,
    /// The body that takes the opposite; the frame if it is not named.
    pub from: Option<Member>,
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

/// `friction expr on JOINT [, radius expr] [, length expr];`
#[derive(Debug)]
pub struct FrictionItem {
    pub coefficient: Expr,
    pub joint: Member,
    /// Of a pin.
    pub radius: Option<Expr>,
    /// Of the block of a slide: the distance of its ends, between which a moment acts.
    pub length: Option<Expr>,
    pub span: SourceSpan,
}

#[derive(Debug)]
pub enum Between {
    /// `from BODY at expr to BODY at expr`
    Points(Box<[(Member, Expr); 2]>),
    /// `on JOINT`
    Joint(Member),
}

impl From<&Ident> for Member {
    fn from(ident: &Ident) -> Self {
        Self {
            text: ident.to_string(),
            span: ident.into(),
        }
    }
}
