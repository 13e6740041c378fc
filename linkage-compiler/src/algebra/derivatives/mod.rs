//! Derivatives.

pub(crate) mod acting;
pub(crate) mod adjoint;
pub(crate) mod by_rule;
pub(crate) mod dependence;
pub(crate) mod direction;
pub(crate) mod elimination;
pub(crate) mod gradient;
pub(crate) mod implicit;
pub(crate) mod links;
pub(crate) mod mentioned;
pub(crate) mod partial;
pub(crate) mod preaccumulation;
pub(crate) mod reverse;
pub(crate) mod rotation_variation;
pub(crate) mod rows;
