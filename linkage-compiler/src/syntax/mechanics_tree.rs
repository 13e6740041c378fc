//! The syntax tree of bodies, joints and loads.

use proc_macro2::Ident;

use super::expression_tree::Expr;
use super::keyword::JointKind;
use crate::diagnostic::SourceSpan;

/// `body NAME = JOINT, turns expr, mass expr at expr, inertia expr [at expr];`, the clauses after
/// the joint in any order.
#[derive(Debug)]
pub(crate) struct BodyItem {
    pub(crate) name: Ident,
    /// The joint that the body is attached by; its point is the body's origin.
    pub(crate) joint: JointPart,
    pub(crate) turns: Option<Expr>,
    pub(crate) masses: Vec<MassPart>,
    pub(crate) inertias: Vec<InertiaPart>,
}

/// `KIND [NAME] on BODY at expr [along expr | about expr]`, the clauses after the name in any
/// order.
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

/// The name of a body or a joint, after the names of its parts: `rod`, `hook.rod`.
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

impl From<&Ident> for Member {
    fn from(ident: &Ident) -> Self {
        Self {
            text: ident.to_string(),
            span: ident.into(),
        }
    }
}
