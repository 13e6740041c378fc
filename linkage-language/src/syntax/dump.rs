//! The syntax tree as text, for tests.

use std::fmt::{self, Display, Formatter};

use super::ast::{InputItem, Item, MechanismDef, PartItem};
use super::expression_tree::{BinaryOp, Expr, ExprKind, Toleranced};
use super::keyword::JointKind;
use super::linked_tree::{LinkItem, LinkedItem, SlidePath, SliderItem, WheelsItem};
use super::mechanics_tree::{Between, BodyItem, ElementItem, JointItem, LoadItem, Member};
use super::vocabulary::Word;

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

struct Line<'a>(&'a Item);

impl Display for Line<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{} ", self.0.word().word())?;
        match self.0 {
            Item::Unit(item) => write!(f, "{}", item.unit),
            Item::Const(item) | Item::Let(item) | Item::Argument(item) => {
                write!(f, "{} = {}", item.name, item.value)
            }
            Item::Unknown(item) => match &item.estimate {
                Some(estimate) => write!(f, "{} = {estimate}", item.name),
                None => write!(f, "{}", item.name),
            },
            Item::Loop(item) => {
                let redundant = if item.redundant { " redundant" } else { "" };
                write!(f, "{} = {}{redundant}", item.left, item.right)
            }
            Item::Param(item) => write!(f, "{} = {}", item.name, item.value),
            Item::Input(item) => write!(f, "{item}"),
            Item::Part(item) => write!(f, "{item}"),
            Item::Gravity(item) => write!(f, "= {}", item.value),
            Item::Body(item) => write!(f, "{item}"),
            Item::Joint(item) => write!(f, "{item}"),
            Item::Force(item) | Item::Torque(item) => write!(f, "{item}"),
            Item::Spring(item) | Item::Damper(item) => write!(f, "{item}"),
            Item::Linked(item) => write!(f, "{item}"),
        }
    }
}

impl Display for InputItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{} = {}", self.name, self.value)?;
        if let Some((low, high)) = &self.range {
            write!(f, " in {low}..{high}")?;
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
        let given = self.given.iter();
        let given = given.map(|given| format!("{} = {}", given.name, given.value));
        let given: Vec<String> = given.collect();
        write!(
            f,
            "{}: {} {{ {} }}",
            self.name,
            self.mechanism,
            given.join(", ")
        )?;
        optional(f, " on ", self.on.as_ref())?;
        optional(f, " at ", self.at.as_ref())?;
        optional(f, ", turned by ", self.turned.as_ref())
    }
}

impl Display for BodyItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let joint = &self.joint;
        write!(f, "{} = {}", self.name, joint.kind.word())?;
        optional(f, " ", joint.name.as_ref())?;
        write!(f, " on {} at {}", joint.on, joint.at)?;
        direction(f, joint.kind, joint.direction.as_ref())?;
        optional(f, ", turns ", self.turns.as_ref())?;
        for part in &self.masses {
            write!(f, ", mass {} at {}", part.mass, part.at)?;
        }
        for part in &self.inertias {
            write!(f, ", inertia {}", part.inertia)?;
            optional(f, " at ", part.at.as_ref())?;
        }
        Ok(())
    }
}

impl Display for JointItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let joint = &self.joint;
        optional(f, "", joint.name.as_ref())?;
        write!(f, " = {} on {} at {}", self.body, joint.on, joint.at)?;
        direction(f, joint.kind, joint.direction.as_ref())
    }
}

fn direction(f: &mut Formatter, kind: JointKind, direction: Option<&Expr>) -> fmt::Result {
    let word = format!(" {} ", kind.direction_word().word());
    optional(f, &word, direction)
}

impl Display for LoadItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{} on {}", self.value, self.on)?;
        optional(f, " from ", self.from.as_ref())?;
        optional(f, " at ", self.at.as_ref())
    }
}

impl Display for ElementItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{} {}", self.value, self.between)?;
        optional(f, ", free ", self.free.as_ref())
    }
}

impl Display for Between {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Between::Joint(joint) => write!(f, "on {joint}"),
            Between::Points(ends) => {
                let [(from, start), (to, end)] = &**ends;
                write!(f, "from {from} at {start} to {to} at {end}")
            }
        }
    }
}

/// Prints a word and its operand, if there is one.
fn optional(f: &mut Formatter, word: &str, value: Option<&impl Display>) -> fmt::Result {
    value.map_or(Ok(()), |value| write!(f, "{word}{value}"))
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
        Some(tolerance) => write!(f, "{nominal} +- {tolerance}"),
        None => write!(f, "{nominal}"),
    }
}

impl Display for Expr {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match &self.kind {
            ExprKind::Number { text, suffix } => write!(f, "{text}{suffix}"),
            ExprKind::Name(name) => write!(f, "{name}"),
            ExprKind::Tuple(components) => list(f, "(", components, ")"),
            ExprKind::List(entries) => list(f, "[", entries, "]"),
            ExprKind::Call(name, arguments) => {
                write!(f, "{name}")?;
                list(f, "(", arguments, ")")
            }
            ExprKind::Field(value, field) => write!(f, "{value}.{field}"),
            ExprKind::Index(value, index) => write!(f, "{value}[{index}]"),
            ExprKind::Negate(value) => write!(f, "(-{value})"),
            ExprKind::Binary(operator, left, right) => write!(f, "({left} {operator} {right})"),
            ExprKind::Power(base, power) => write!(f, "{base}^{power}"),
            ExprKind::Error => f.write_str("<error>"),
        }
    }
}

fn list(f: &mut Formatter, open: &str, entries: &[Expr], close: &str) -> fmt::Result {
    let entries: Vec<String> = entries.iter().map(ToString::to_string).collect();
    write!(f, "{open}{}{close}", entries.join(", "))
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
            LinkedItem::Joints(joints) => {
                let joints = joints.iter();
                let joints = joints.map(|joint| format!("{} = {}", joint.name, joint.position));
                f.write_str(&joints.collect::<Vec<_>>().join(", "))
            }
            LinkedItem::Link(item) => write!(f, "{item}"),
            LinkedItem::Slider(item) => write!(f, "{item}"),
            LinkedItem::Gears(item) | LinkedItem::Belt(item) => write!(f, "{item}"),
            LinkedItem::Weld(item) => {
                let links: Vec<String> = item.links.iter().map(ToString::to_string).collect();
                f.write_str(&links.join(", "))
            }
        }
    }
}

impl Display for LinkItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{}:", self.name)?;
        for (index, joint) in self.joints.iter().enumerate() {
            f.write_str(if index == 0 { " " } else { ", " })?;
            write!(f, "{}", joint.name)?;
            optional(f, " = ", joint.coordinates.as_ref())?;
        }
        optional(f, " at ", self.at.as_ref())?;
        optional(f, " length ", self.length.as_ref())?;
        optional(f, " about ", self.about.as_ref())?;
        for part in &self.masses {
            write!(f, ", mass {} at {}", part.mass, part.at)?;
        }
        for part in &self.inertias {
            write!(f, ", inertia {}", part.inertia)?;
            optional(f, " at ", part.at.as_ref())?;
        }
        Ok(())
    }
}

impl Display for SliderItem {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{}: {} on {}", self.name, self.pin, self.guide)?;
        match &self.path {
            SlidePath::Line([first, second]) => write!(f, " along {first}, {second}")?,
            SlidePath::Direction { angle, through } => {
                write!(f, " along {angle}")?;
                optional(f, " through ", through.as_ref())?;
            }
            SlidePath::Arc { centre, radius } => {
                write!(f, " around {centre}")?;
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
        write!(f, "{first}, {second}")?;
        optional(f, " on ", self.carrier.as_ref())?;
        write!(f, " teeth {one}, {other}")
    }
}
