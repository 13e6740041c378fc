//! Bodies, joints and loads as text.

use std::fmt::{self, Write};

use super::expressions::{Show, joint_name};
use crate::model::types::{Between, Body, Contact, Expr, Inertia, Joint, Load, Mechanism};
use crate::syntax::Word;

/// One line for each body, joint and load.
pub(in crate::model) fn write_mechanics(out: &mut String, mechanism: &Mechanism) -> fmt::Result {
    let show = |expr| Show { expr, mechanism };
    if let Some(gravity) = &mechanism.gravity {
        writeln!(out, "gravity = {}: {}", show(gravity), gravity.ty)?;
    }
    for body in &mechanism.bodies {
        write_body(out, body, mechanism)?;
    }
    for joint in &mechanism.joints[mechanism.bodies.len()..] {
        write!(out, "joint {} = ", mechanism.bodies[joint.body].name)?;
        write_joint(out, joint, mechanism)?;
        writeln!(out)?;
    }
    for load in &mechanism.loads {
        write_load(out, load, mechanism)?;
    }
    for element in &mechanism.elements {
        let word = element.kind.word();
        write!(out, "{word} {}", show(&element.value))?;
        match &element.between {
            Between::Points(ends) => {
                for (side, (body, point)) in ["from", "to"].iter().zip(ends) {
                    let body = body_name(mechanism, *body);
                    write!(out, " {side} {body} at {}", show(point))?;
                }
            }
            Between::Joint(joint) => write!(out, " on {}", joint_name(mechanism, *joint))?,
        }
        if let Some(free) = &element.free {
            write!(out, ", free {}", show(free))?;
        }
        writeln!(out, ": {}", element.value.ty)?;
    }
    for friction in &mechanism.frictions {
        let joint = joint_name(mechanism, friction.joint);
        write!(out, "friction {} on {joint}", show(&friction.coefficient))?;
        match &friction.contact {
            Contact::Pin(radius) => write!(out, ", radius {}", show(radius))?,
            Contact::Guide(Some(length)) => write!(out, ", length {}", show(length))?,
            Contact::Guide(None) => {}
        }
        writeln!(out)?;
    }
    Ok(())
}

pub(in crate::model) fn write_body(
    out: &mut String,
    body: &Body,
    mechanism: &Mechanism,
) -> fmt::Result {
    let show = |expr| Show { expr, mechanism };
    write!(out, "body {} = ", body.name)?;
    write_joint(out, &mechanism.joints[body.joint], mechanism)?;
    if let Some(turns) = &body.turns {
        write!(out, ", turns {}", show(turns))?;
    }
    for (mass, at) in &body.masses {
        write!(out, ", mass {} at {}", show(mass), show(at))?;
    }
    for (inertia, at) in &body.inertias {
        write!(out, ", inertia ")?;
        match inertia {
            Inertia::Scalar(value) => write!(out, "{}", show(value))?,
            Inertia::Tensor(rows) => {
                for (index, row) in rows.iter().enumerate() {
                    let open = if index == 0 { "((" } else { ", (" };
                    let row = row.each_ref().map(|entry| show(entry).to_string());
                    write!(out, "{open}{})", row.join(", "))?;
                }
                write!(out, ")")?;
            }
        }
        if let Some(at) = at {
            write!(out, " at {}", show(at))?;
        }
    }
    writeln!(out)
}

pub(in crate::model) fn write_joint(
    out: &mut String,
    joint: &Joint,
    mechanism: &Mechanism,
) -> fmt::Result {
    let show = |expr| Show { expr, mechanism };
    write!(out, "{}", joint.kind.word())?;
    if let Some(name) = &joint.name {
        write!(out, " {name}")?;
    }
    let on = body_name(mechanism, joint.on);
    write!(out, " on {on} at {}", show(&joint.at))?;
    let word = joint.kind.direction_word().word();
    match &joint.direction {
        Some(direction) => write!(out, " {word} {}", show(direction)),
        None => Ok(()),
    }
}

pub(in crate::model) fn write_load(
    out: &mut String,
    load: &Load,
    mechanism: &Mechanism,
) -> fmt::Result {
    let show = |expr: &'_ Expr| Show { expr, mechanism }.to_string();
    let word = if load.at.is_some() { "force" } else { "torque" };
    let [on, from] = [load.on, load.from].map(|body| body_name(mechanism, body));
    write!(out, "{word} {} on {on} from {from}", show(&load.value))?;
    if let Some(at) = &load.at {
        write!(out, " at {}", show(at))?;
    }
    writeln!(out, ": {}", load.value.ty)
}

pub(in crate::model) fn body_name(mechanism: &Mechanism, body: Option<usize>) -> &str {
    body.map_or("frame", |body| mechanism.bodies[body].name.as_str())
}
