//! The items of the struct block by the pass that resolves them.
//!
//! Kinds are resolved one after the other, so only `let` and `const` depend on the order. Items of
//! one pass keep the order in which they are written.

use crate::syntax::{
    ArcItem, BodyItem, ElementItem, FrictionItem, GravityItem, InputItem, Item, JointItem,
    LoadItem, LoopItem, MechanismDef, NamedItem, ParamItem, PartItem, UnitItem, UnknownItem,
};

/// Items with their positions in the struct block, in the order of the passes.
#[derive(Default)]
pub(in crate::model) struct Passes<'a> {
    pub(in crate::model) units: Vec<&'a UnitItem>,
    pub(in crate::model) constants: Vec<(usize, &'a NamedItem)>,
    pub(in crate::model) parameters: Vec<(usize, &'a ParamItem)>,
    pub(in crate::model) coordinates: Vec<(usize, Coordinate<'a>)>,
    /// Unknowns that are frames.
    pub(in crate::model) frames: Vec<(usize, &'a UnknownItem)>,
    pub(in crate::model) arguments: Vec<(usize, Taken<'a>)>,
    pub(in crate::model) definitions: Vec<(usize, Definition<'a>)>,
    pub(in crate::model) parts: Vec<&'a PartItem>,
    pub(in crate::model) bodies: Vec<&'a BodyItem>,
    pub(in crate::model) mechanics: Vec<Mechanical<'a>>,
    pub(in crate::model) arcs: Vec<&'a ArcItem>,
}

/// An input or an unknown.
pub(in crate::model) enum Coordinate<'a> {
    Input(&'a InputItem),
    Unknown(&'a UnknownItem),
}

/// An argument of functions that is no input.
pub(in crate::model) enum Taken<'a> {
    Argument(&'a NamedItem),
    /// The speed and acceleration of an input.
    Rates(&'a InputItem),
}

/// A derived quantity, a loop or a part.
pub(in crate::model) enum Definition<'a> {
    Let(&'a NamedItem),
    Loop(&'a LoopItem),
    Part(&'a PartItem),
}

/// An item about masses and forces, other than a body.
pub(in crate::model) enum Mechanical<'a> {
    Gravity(&'a GravityItem),
    Joint(&'a JointItem),
    Force(&'a LoadItem),
    Torque(&'a LoadItem),
    Spring(&'a ElementItem),
    Damper(&'a ElementItem),
    Friction(&'a FrictionItem),
}

impl<'a> Passes<'a> {
    pub(in crate::model) fn sort(definition: &'a MechanismDef) -> Self {
        let mut passes = Self::default();
        for (position, item) in definition.items.iter().enumerate() {
            match item {
                Item::Unit(item) => passes.units.push(item),
                Item::Const(item) => passes.constants.push((position, item)),
                Item::Param(item) => passes.parameters.push((position, item)),
                Item::Input(item) => {
                    passes.coordinates.push((position, Coordinate::Input(item)));
                    passes.arguments.push((position, Taken::Rates(item)));
                }
                Item::Unknown(item) if item.is_frame() => passes.frames.push((position, item)),
                Item::Unknown(item) => {
                    passes
                        .coordinates
                        .push((position, Coordinate::Unknown(item)));
                }
                Item::Argument(item) => {
                    passes.arguments.push((position, Taken::Argument(item)));
                }
                Item::Let(item) => passes.definitions.push((position, Definition::Let(item))),
                Item::Loop(item) => passes.definitions.push((position, Definition::Loop(item))),
                Item::Part(item) => {
                    passes.definitions.push((position, Definition::Part(item)));
                    passes.parts.push(item);
                }
                Item::Body(item) => passes.bodies.push(item),
                Item::Arc(item) => passes.arcs.push(item),
                Item::Gravity(item) => passes.mechanics.push(Mechanical::Gravity(item)),
                Item::Joint(item) => passes.mechanics.push(Mechanical::Joint(item)),
                Item::Force(item) => passes.mechanics.push(Mechanical::Force(item)),
                Item::Torque(item) => passes.mechanics.push(Mechanical::Torque(item)),
                Item::Spring(item) => passes.mechanics.push(Mechanical::Spring(item)),
                Item::Damper(item) => passes.mechanics.push(Mechanical::Damper(item)),
                Item::Friction(item) => passes.mechanics.push(Mechanical::Friction(item)),
                // Other items have taken their place.
                Item::Linked(_) => {}
            }
        }
        passes
    }
}
