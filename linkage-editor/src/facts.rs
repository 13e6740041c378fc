//! Types and units of names, taken from a resolved mechanism.

use std::collections::BTreeMap;

use linkage_language::model::{Mechanism, Type};

/// Names and types of a mechanism.
#[derive(Clone, Debug)]
pub(crate) struct Facts {
    pub(crate) mechanism: String,
    /// By name as it is written: `crank`, `coupler.length`, `left.tip`.
    pub(crate) names: BTreeMap<String, Fact>,
    /// The inputs, in order.
    pub(crate) inputs: Vec<String>,
    /// The joints of each link, in order.
    pub(crate) joints_of: BTreeMap<String, Vec<String>>,
}

/// The type of a name.
#[derive(Clone, Debug)]
pub(crate) struct Fact {
    /// `an angle`, `a plane vector of lengths`
    pub(crate) ty: String,
    /// The words that can follow after a dot.
    pub(crate) members: &'static [&'static str],
    /// True if a function can return its value for given inputs alone.
    pub(crate) is_computed: bool,
}

impl Facts {
    /// Reads a resolved mechanism.
    pub(crate) fn new(mechanism: &Mechanism) -> Self {
        let scalar = |dimension, is_computed| fact(&Type::Scalar(dimension), is_computed);
        let mut names = BTreeMap::new();
        for item in &mechanism.constants {
            names.insert(item.name.clone(), fact(&item.value.ty, true));
        }
        for item in &mechanism.parameters {
            names.insert(item.name.clone(), fact(&item.ty, true));
        }
        for item in &mechanism.inputs {
            names.insert(item.name.clone(), scalar(item.dimension, true));
        }
        for item in &mechanism.unknowns {
            names.insert(item.name.clone(), fact(&item.ty, true));
        }
        for item in &mechanism.lets {
            names.insert(item.name.clone(), fact(&item.value.ty, true));
        }
        for item in &mechanism.arguments {
            names.insert(item.name.clone(), scalar(item.dimension, false));
        }
        let inputs = mechanism.inputs.iter().map(|input| input.name.clone());
        Self {
            mechanism: mechanism.name.clone(),
            names,
            inputs: inputs.collect(),
            joints_of: mechanism
                .links
                .as_ref()
                .map_or_else(BTreeMap::new, |links| links.members.clone()),
        }
    }
}

fn fact(ty: &Type, is_computed: bool) -> Fact {
    Fact {
        ty: ty.to_string(),
        members: members(ty),
        is_computed: is_computed && ty.components().is_some(),
    }
}

/// Returns the words that can follow after a value of this type and a dot.
fn members(ty: &Type) -> &'static [&'static str] {
    match ty {
        Type::Vector(2, _) | Type::Zero(2) => &["x", "y"],
        Type::Vector(..) | Type::Zero(3) => &["x", "y", "z"],
        Type::Frame => &["origin", "x", "y", "z"],
        Type::PlaneFrame => &["origin", "x", "y", "angle"],
        Type::Scalar(_) | Type::Zero(_) | Type::Array(_) | Type::Error => &[],
    }
}
