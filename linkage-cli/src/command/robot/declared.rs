//! The bodies, joints and loads of a mechanism as they are written, and the functions that compute
//! them.

use linkage_compiler::shortened;
use linkage_engine::Source;
use linkage_language::diagnostic::Diagnostics;
use linkage_language::model::expand;
use linkage_language::syntax::{
    BodyItem, Expr, ExprKind, GravityItem, Item, JointKind, JointPart, MechanismDef, parse,
};

use super::declared_wheels::{DeclaredWheels, declared_wheels};
use super::expression_text::text;
use crate::failure::Failure;

/// A joint as it is written.
pub(super) struct DeclaredJoint {
    pub(super) kind: JointKind,
    pub(super) name: Option<String>,
    /// The index of the other body; `None` is the frame.
    pub(super) on: Option<usize>,
    at: String,
    direction: Option<String>,
}

/// A body as it is written.
pub(super) struct DeclaredBody {
    pub(super) name: String,
    pub(super) joint: DeclaredJoint,
    turns: Option<String>,
    /// Each mass and its centre.
    masses: Vec<[String; 2]>,
    inertias: Vec<DeclaredInertia>,
}

/// A moment of inertia: one number, three, or the nine of a matrix.
struct DeclaredInertia {
    numbers: Vec<String>,
    at: Option<String>,
}

/// Bodies and joints of a mechanism.
pub(super) struct Declared {
    pub(super) bodies: Vec<DeclaredBody>,
    /// Joints that close loops, each with its first body.
    pub(super) closures: Vec<(Option<usize>, DeclaredJoint)>,
    pub(super) wheels: Vec<DeclaredWheels>,
    gravity: Option<String>,
    /// Loads that a description of links and joints has no place for.
    pub(super) loads: Vec<&'static str>,
}

/// Names of fields of the two functions.
pub(super) fn field(kind: &str, index: usize) -> String {
    format!("{kind}{index}")
}

/// The field of a mass or an inertia of a body.
pub(super) fn entry(kind: &str, body: usize, index: usize) -> String {
    format!("{kind}{body}_{index}")
}

impl Declared {
    /// Reads the bodies of the mechanism of this name.
    pub(super) fn read(source: &Source, name: &str) -> Result<Self, Failure> {
        let definitions = source
            .calls()
            .iter()
            .flat_map(|call| parse(call.tokens.clone(), &mut Diagnostics::default()));
        let mut named = definitions.filter(|definition| definition.title() == name);
        let mut definition = named.next().ok_or(Failure::Silent)?;
        weigh(&mut definition);
        let mut expanded = expand(vec![definition], &mut Diagnostics::default());
        let definition = expanded.pop().ok_or(Failure::Silent)?;
        declared(&definition)
    }

    /// The quantities of a function that computes positions and directions.
    pub(super) fn positions(&self) -> String {
        let mut fields = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            add_joint(&mut fields, "", index, &body.joint);
            if let Some(turns) = &body.turns {
                fields.push(format!("{}: {turns}", field("turns", index)));
            }
            for (number, [_, at]) in body.masses.iter().enumerate() {
                fields.push(format!("{}: {at}", entry("centre", index, number)));
            }
            for (number, inertia) in body.inertias.iter().enumerate() {
                let at = inertia.at.iter();
                fields.extend(at.map(|at| format!("{}: {at}", entry("about", index, number))));
            }
        }
        for (index, (_, joint)) in self.closures.iter().enumerate() {
            add_joint(&mut fields, "closing_", index, joint);
        }
        fields.join(", ")
    }

    /// The quantities of a function that computes what is constant: masses, ratios of wheels and gravity. Empty if
    /// there are none.
    pub(super) fn constants(&self) -> String {
        let mut fields = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            for (number, [mass, _]) in body.masses.iter().enumerate() {
                fields.push(format!("{}: {mass}", entry("mass", index, number)));
            }
            for (number, inertia) in body.inertias.iter().enumerate() {
                let numbers = inertia.numbers.iter().enumerate();
                let numbers = numbers.map(|(component, text)| {
                    let name = entry("inertia", index, number);
                    format!("{name}_{component}: {text}")
                });
                fields.extend(numbers);
            }
        }
        for (index, pair) in self.wheels.iter().enumerate() {
            fields.push(format!("{}: {}", field("ratio", index), pair.ratio));
        }
        if let Some(gravity) = &self.gravity {
            fields.push(format!("gravity: {gravity}"));
        }
        fields.join(", ")
    }

    /// The bodies in an order in which those that others hang on come first.
    pub(super) fn order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = Vec::new();
        // The compiler has refused circles.
        for _ in &self.bodies {
            for (index, body) in self.bodies.iter().enumerate() {
                let hangs = body.joint.on.is_none_or(|on| order.contains(&on));
                if hangs && !order.contains(&index) {
                    order.push(index);
                }
            }
        }
        order
    }
}

impl DeclaredBody {
    pub(super) fn has_turns(&self) -> bool {
        self.turns.is_some()
    }

    pub(super) fn mass_count(&self) -> usize {
        self.masses.len()
    }

    /// The count of numbers of each inertia, and if it is about a point.
    pub(super) fn inertias(&self) -> impl Iterator<Item = (usize, bool)> {
        let inertias = self.inertias.iter();
        inertias.map(|inertia| (inertia.numbers.len(), inertia.at.is_some()))
    }
}

impl DeclaredJoint {
    pub(super) fn has_direction(&self) -> bool {
        self.direction.is_some()
    }
}

fn add_joint(fields: &mut Vec<String>, prefix: &str, index: usize, joint: &DeclaredJoint) {
    let name = |kind: &str| field(&format!("{prefix}{kind}"), index);
    fields.push(format!("{}: {}", name("at"), joint.at));
    if let Some(direction) = &joint.direction {
        fields.push(format!("{}: {direction}", name("along")));
    }
}

/// Links become bodies only if something has a weight: without gravity, add none.
fn weigh(definition: &mut MechanismDef) {
    let span = (&definition.name).into();
    let zero = || Expr {
        kind: ExprKind::Number {
            text: "0".to_owned(),
            suffix: String::new(),
        },
        span,
    };
    let mut items = definition.items.iter();
    let is_linked = items.any(|item| matches!(item, Item::Linked(_)));
    let mut items = definition.items.iter();
    let has_gravity = items.any(|item| matches!(item, Item::Gravity(_)));
    if is_linked && !has_gravity {
        let value = Expr {
            kind: ExprKind::Tuple(vec![zero(), zero()]),
            span,
        };
        let gravity = Item::Gravity(GravityItem { value, span });
        definition.items.insert(0, gravity);
    }
}

fn declared(definition: &MechanismDef) -> Result<Declared, Failure> {
    let name = definition.title();
    let bodies: Vec<&BodyItem> = definition
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Body(body) => Some(body),
            _ => None,
        })
        .collect();
    let has_parts = definition
        .items
        .iter()
        .any(|item| matches!(item, Item::Part(_)));
    if has_parts {
        return Err(Failure::Told(format!(
            "{name} has parts, whose bodies are not written\nhelp: write the mechanism of a part, by `--mechanism NAME`"
        )));
    }
    if bodies.is_empty() {
        return Err(Failure::Told(format!(
            "{name} has no `body`, and a robot consists of bodies and joints\nhelp: write `body crank = pin on frame at (0, 0), turns phi, mass 0.1kg at p / 2;` for each link and `pin a = coupler on rocker at p;` for each loop, or write the mechanism with joints and links"
        )));
    }
    let index_of = |name: &str| bodies.iter().position(|body| body.name == name);
    let joint = |part: &JointPart| DeclaredJoint {
        kind: part.kind,
        name: part.name.as_ref().map(ToString::to_string),
        on: index_of(&part.on.text),
        at: text(&part.at),
        direction: part.direction.as_ref().map(text),
    };
    let mut closures = Vec::new();
    let mut gravity = None;
    let mut loads = Vec::new();
    for item in &definition.items {
        match item {
            Item::Joint(item) => closures.push((index_of(&item.body.text), joint(&item.joint))),
            Item::Gravity(item) => gravity = Some(text(&item.value)),
            Item::Force(_) => loads.push("force"),
            Item::Torque(_) => loads.push("torque"),
            Item::Spring(_) => loads.push("spring"),
            Item::Damper(_) => loads.push("damper"),
            Item::Friction(_) => loads.push("friction"),
            _ => {}
        }
    }
    loads.sort_unstable();
    loads.dedup();
    let body = |item: &&BodyItem| DeclaredBody {
        name: item.name.to_string(),
        joint: joint(&item.joint),
        turns: item.turns.as_ref().map(text),
        masses: item
            .masses
            .iter()
            .map(|part| [&part.mass, &part.at].map(text))
            .collect(),
        inertias: item
            .inertias
            .iter()
            .map(|part| DeclaredInertia {
                numbers: components(&part.inertia),
                at: part.at.as_ref().map(text),
            })
            .collect(),
    };
    Ok(Declared {
        bodies: bodies.iter().map(body).collect(),
        closures,
        wheels: declared_wheels(definition, index_of),
        gravity,
        loads,
    })
}

/// The numbers of nested lists, in their order.
fn components(value: &Expr) -> Vec<String> {
    match &value.kind {
        ExprKind::Tuple(parts) => parts.iter().flat_map(components).collect(),
        _ => vec![text(value)],
    }
}

/// A body or the frame, as messages name it.
pub(super) fn name_of(bodies: &[DeclaredBody], body: Option<usize>) -> String {
    match body {
        Some(index) => format!("`{}`", shortened(&bodies[index].name)),
        None => "`frame`".to_owned(),
    }
}
