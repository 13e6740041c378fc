//! The syntax tree as text: for tests with all parentheses, for users with as few as possible.

use std::fmt::{self, Display, Formatter};

use super::ast::{ArcItem, GivenPart, InputItem, Item, MechanismDef, PartItem};
use super::expression_tree::{BinaryOp, Expr, ExprKind, Toleranced};
use super::keyword::JointKind;
use super::linked_tree::{DrawnJoint, LinkItem, LinkedItem, SlidePath, SliderItem, WheelsItem};
use super::mechanics_tree::{
    Between, BodyItem, ElementItem, FrictionItem, JointItem, LoadItem, Member,
};
use super::vocabulary::Word;

/// Prints values one after the other, all in the form of the formatter.
macro_rules! show {
    ($f:expr, $first:expr $(, $value:expr)*) => {
        Display::fmt(&$first, $f)$(.and_then(|()| Display::fmt(&$value, $f)))*
    };
}

/// One line for each item and quantity, every operation in parentheses.
pub fn dump(definition: &MechanismDef) -> String {
    let mut lines = vec![format!("struct {}", definition.name)];
    lines.extend(
        definition
            .items
            .iter()
            .map(|item| format!("  {}", Line(item))),
    );
    for function in &definition.functions {
        let inputs: Vec<String> = function.inputs.iter().map(ToString::to_string).collect();
        lines.push(format!(
            "fn {}({}) -> {}",
            function.name,
            inputs.join(", "),
            function.result
        ));
        for quantity in &function.quantities {
            lines.push(format!("  {}: {}", quantity.field, quantity.value));
        }
    }
    lines.join("\n") + "\n"
}

/// An item without its `;`.
pub(super) struct Line<'a>(pub(super) &'a Item);

impl Display for Line<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        show!(f, self.0.word().word(), " ")?;
        match self.0 {
            Item::Unit(item) => show!(f, item.unit),
            Item::Const(item) | Item::Let(item) | Item::Argument(item) => {
                show!(f, item.name, " = ", item.value)
            }
            Item::Unknown(item) => match &item.estimate {
                Some(estimate) => show!(f, item.name, " = ", estimate),
                None => show!(f, item.name),
            },
            Item::Loop(item) => {
                let redundant = if item.redundant { " redundant" } else { "" };
                show!(f, item.left, " = ", item.right, redundant)
            }
            Item::Param(item) => show!(f, item.name, " = ", item.value),
            Item::Input(item) => show!(f, item),
            Item::Part(item) => show!(f, item),
            Item::Gravity(item) => show!(f, "= ", item.value),
            Item::Body(item) => show!(f, item),
            Item::Arc(item) => show!(f, item),
            Item::Joint(item) => show!(f, item),
            Item::Force(item) | Item::Torque(item) => show!(f, item),
            Item::Spring(item) | Item::Damper(item) => show!(f, item),
            Item::Friction(item) => show!(f, item),
            Item::Linked(item) => show!(f, item),
        }
    }
}

impl Display for InputItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        show!(f, self.name, " = ", self.value)?;
        if let Some((low, high)) = &self.range {
            show!(f, " in ", low, "..", high)?;
        }
        optional(f, " at ", self.speed.as_ref())?;
        optional(f, ", ", self.acceleration.as_ref())
    }
}

impl Display for Member {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl Display for PartItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        show!(f, self.name, ": ", self.mechanism)?;
        list(f, " { ", &self.given, " }")?;
        optional(f, " on ", self.on.as_ref())?;
        optional(f, " at ", self.at.as_ref())?;
        optional(f, ", turned by ", self.turned.as_ref())
    }
}

impl Display for ArcItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        show!(f, self.name, ": ", self.slider, " around ", self.centre)?;
        optional(f, ", turned by ", self.turned.as_ref())
    }
}

impl Display for BodyItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let joint = &self.joint;
        show!(f, self.name, " = ", joint.kind.word())?;
        optional(f, " ", joint.name.as_ref())?;
        show!(f, " on ", joint.on, " at ", joint.at)?;
        direction(f, joint.kind, joint.direction.as_ref())?;
        optional(f, ", turns ", self.turns.as_ref())?;
        for part in &self.masses {
            show!(f, ", mass ", part.mass, " at ", part.at)?;
        }
        for part in &self.inertias {
            show!(f, ", inertia ", part.inertia)?;
            optional(f, " at ", part.at.as_ref())?;
        }
        Ok(())
    }
}

impl Display for JointItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let joint = &self.joint;
        optional(f, "", joint.name.as_ref())?;
        show!(f, " = ", self.body, " on ", joint.on, " at ", joint.at)?;
        direction(f, joint.kind, joint.direction.as_ref())
    }
}

fn direction(f: &mut Formatter, kind: JointKind, direction: Option<&Expr>) -> fmt::Result {
    let word = format!(" {} ", kind.direction_word().word());
    optional(f, &word, direction)
}

impl Display for LoadItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        show!(f, self.value, " on ", self.on)?;
        optional(f, " from ", self.from.as_ref())?;
        optional(f, " at ", self.at.as_ref())
    }
}

impl Display for ElementItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        show!(f, self.value, " ", self.between)?;
        optional(f, ", free ", self.free.as_ref())
    }
}

impl Display for FrictionItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        show!(f, self.coefficient, " on ", self.joint)?;
        optional(f, ", radius ", self.radius.as_ref())?;
        optional(f, ", length ", self.length.as_ref())
    }
}

impl Display for Between {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Between::Joint(joint) => show!(f, "on ", joint),
            Between::Points(ends) => {
                let [(from, start), (to, end)] = &**ends;
                show!(f, "from ", from, " at ", start, " to ", to, " at ", end)
            }
        }
    }
}

/// Prints a word and its operand, if there is one.
fn optional(f: &mut Formatter, word: &str, value: Option<&impl Display>) -> fmt::Result {
    value.map_or(Ok(()), |value| show!(f, word, value))
}

impl Display for Toleranced {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Toleranced::Single { nominal, tolerance } => pair(f, nominal, tolerance.as_ref()),
            Toleranced::Components { components, .. } => {
                let mut separator = "(";
                for (nominal, tolerance) in components {
                    f.write_str(separator)?;
                    pair(f, nominal, tolerance.as_ref())?;
                    separator = ", ";
                }
                f.write_str(")")
            }
        }
    }
}

fn pair(f: &mut Formatter, nominal: &Expr, tolerance: Option<&Expr>) -> fmt::Result {
    match tolerance {
        Some(tolerance) => show!(f, nominal, " +- ", tolerance),
        None => show!(f, nominal),
    }
}

impl Display for Expr {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        fmt_expression(f, self, Operand::Term)
    }
}

/// The operands that need no parentheses in some place, each with those before it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Operand {
    Term,
    Factor,
    Signed,
    Primary,
}

/// Prints an expression: every operation in parentheses, or as few as possible in the alternate
/// form.
fn fmt_expression(f: &mut Formatter, expr: &Expr, operand: Operand) -> fmt::Result {
    let (operation, left, right) = match &expr.kind {
        ExprKind::Negate(_) => (Operand::Signed, Operand::Signed, Operand::Signed),
        ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, ..) => {
            (Operand::Term, Operand::Term, Operand::Factor)
        }
        ExprKind::Binary(BinaryOp::Mul | BinaryOp::Div, ..) => {
            (Operand::Factor, Operand::Factor, Operand::Signed)
        }
        _ => (Operand::Primary, Operand::Primary, Operand::Primary),
    };
    let is_operation = operation != Operand::Primary;
    let enclosed = is_operation && (!f.alternate() || operation < operand);
    f.write_str(if enclosed { "(" } else { "" })?;
    match &expr.kind {
        ExprKind::Number { text, suffix } => show!(f, text, suffix)?,
        ExprKind::Name(name) => show!(f, name)?,
        ExprKind::Tuple(components) => list(f, "(", components, ")")?,
        ExprKind::List(entries) => list(f, "[", entries, "]")?,
        ExprKind::Call(name, arguments) => {
            show!(f, name)?;
            list(f, "(", arguments, ")")?;
        }
        ExprKind::Field(value, field) => {
            fmt_expression(f, value, Operand::Primary)?;
            show!(f, ".", field)?;
        }
        ExprKind::Index(value, index) => {
            fmt_expression(f, value, Operand::Primary)?;
            show!(f, "[", index, "]")?;
        }
        ExprKind::Negate(value) => {
            f.write_str("-")?;
            fmt_expression(f, value, right)?;
        }
        ExprKind::Binary(operator, first, second) => {
            fmt_expression(f, first, left)?;
            show!(f, " ", operator, " ")?;
            fmt_expression(f, second, right)?;
        }
        ExprKind::Power(base, power) => {
            fmt_expression(f, base, Operand::Primary)?;
            show!(f, "^", power)?;
        }
        ExprKind::Error => f.write_str("<error>")?,
    }
    f.write_str(if enclosed { ")" } else { "" })
}

/// Prints entries with commas between them.
fn list(f: &mut Formatter, open: &str, entries: &[impl Display], close: &str) -> fmt::Result {
    f.write_str(open)?;
    for (index, entry) in entries.iter().enumerate() {
        f.write_str(if index == 0 { "" } else { ", " })?;
        entry.fmt(f)?;
    }
    f.write_str(close)
}

impl Display for BinaryOp {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(match self {
            BinaryOp::Add => "+",
            BinaryOp::Sub => "-",
            BinaryOp::Mul => "*",
            BinaryOp::Div => "/",
        })
    }
}

impl Display for LinkedItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            LinkedItem::Joints(joints) => list(f, "", joints, ""),
            LinkedItem::Link(item) => show!(f, item),
            LinkedItem::Slider(item) => show!(f, item),
            LinkedItem::Gears(item) | LinkedItem::Belt(item) => show!(f, item),
            LinkedItem::Weld(item) => list(f, "", &item.links, ""),
            LinkedItem::Lost(item) => list(f, "", &item.names, ""),
        }
    }
}

impl Display for DrawnJoint {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        show!(f, self.name, " = ", self.position)
    }
}

impl Display for GivenPart {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        show!(f, self.name, " = ", self.value)
    }
}

impl Display for LinkItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        show!(f, self.name, ":")?;
        for (index, joint) in self.joints.iter().enumerate() {
            f.write_str(if index == 0 { " " } else { ", " })?;
            show!(f, joint.name)?;
            optional(f, " = ", joint.coordinates.as_ref())?;
        }
        optional(f, " at ", self.at.as_ref())?;
        optional(f, " length ", self.length.as_ref())?;
        optional(f, " about ", self.about.as_ref())?;
        for part in &self.masses {
            show!(f, ", mass ", part.mass, " at ", part.at)?;
        }
        for part in &self.inertias {
            show!(f, ", inertia ", part.inertia)?;
            optional(f, " at ", part.at.as_ref())?;
        }
        Ok(())
    }
}

impl Display for SliderItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        show!(f, self.name, ": ", self.pin, " on ", self.guide)?;
        match &self.path {
            SlidePath::Line([first, second]) => show!(f, " along ", first, ", ", second)?,
            SlidePath::Direction { angle, through } => {
                show!(f, " along ", angle)?;
                optional(f, " through ", through.as_ref())?;
            }
            SlidePath::Arc { centre, radius } => {
                show!(f, " around ", centre)?;
                optional(f, " radius ", radius.as_ref())?;
            }
        }
        optional(f, ", block ", self.block.as_ref())?;
        optional(f, ", at ", self.at.as_ref())
    }
}

impl Display for WheelsItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let ([first, second], [one, other]) = (&self.wheels, &self.sizes);
        show!(f, first, ", ", second)?;
        optional(f, " on ", self.carrier.as_ref())?;
        show!(f, " teeth ", one, ", ", other)
    }
}
