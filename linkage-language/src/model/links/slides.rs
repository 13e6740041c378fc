//! Slots: their lines, and positions along them.

use super::drawing::Drawing;
use super::linkage::{FRAME, Linkage, Path, Slider};
use super::locations::{angle, angle_of_line, drawn_angle, point};
use super::nodes::{call, difference, ident, name, product, quantity, sum};
use super::rigid_bodies::Bodies;
use crate::model::types::Function;
use crate::syntax::{Expr, Item, ItemName, ParamItem, Toleranced};

/// The body that has the slot.
pub(super) fn guide(bodies: &Bodies, slider: &Slider) -> usize {
    bodies.of_link[slider.guide]
}

/// Returns the joint that positions are measured from, if it is one.
pub(super) fn start_joint(slider: &Slider) -> Option<usize> {
    match slider.path {
        Path::Line([first, _]) => Some(first),
        Path::Direction(_, through) => through,
    }
}

/// Returns the point that positions are measured from.
pub(super) fn start(linkage: &Linkage, slider: &Slider) -> Expr {
    match start_joint(slider) {
        Some(joint) => point(linkage, joint),
        None => quantity(&slider.name, &ident("start", slider.name.span())),
    }
}

/// Returns the parameter that the start of a slot is, if it is no joint.
pub(super) fn start_item(slider: &Slider, drawing: &Drawing) -> Option<Item> {
    if start_joint(slider).is_some() {
        return None;
    }
    let nominal = drawing.positions[slider.pin].clone()?;
    Some(Item::Param(ParamItem {
        attributes: Vec::new(),
        name: ItemName::of_link(slider.name.clone(), ident("start", slider.name.span())),
        value: Toleranced::Single {
            nominal,
            tolerance: None,
        },
    }))
}

/// Returns the direction of a slot in the fixed link.
pub(super) fn slot_angle(
    linkage: &Linkage,
    bodies: &Bodies,
    slider: &Slider,
    drawing: &Drawing,
) -> Expr {
    let body = guide(bodies, slider);
    if body == FRAME {
        return match slider.path {
            Path::Line(line) => call(Function::Angle, vec![line_vector(linkage, line)]),
            Path::Direction(angle, _) => angle.clone(),
        };
    }
    let turning = angle(linkage, bodies.list[body].lead());
    match slot_on_body(linkage, bodies, slider, drawing) {
        Some(turned) => sum(turning, turned),
        None => turning,
    }
}

/// Returns the direction of a slot in the axes of its body; `None` for the x axis.
pub(super) fn slot_on_body(
    linkage: &Linkage,
    bodies: &Bodies,
    slider: &Slider,
    drawing: &Drawing,
) -> Option<Expr> {
    let body = &bodies.list[guide(bodies, slider)];
    match slider.path {
        Path::Line(line) => angle_of_line(linkage, body, line),
        Path::Direction(angle, _) => {
            drawn_angle(linkage, body.lead(), drawing).map(|drawn| difference(angle.clone(), drawn))
        }
    }
}

fn line_vector(linkage: &Linkage, [first, second]: [usize; 2]) -> Expr {
    difference(point(linkage, second), point(linkage, first))
}

/// Returns the point of the slot at the slider's position.
pub(super) fn point_in_slot(
    linkage: &Linkage,
    bodies: &Bodies,
    slider: &Slider,
    drawing: &Drawing,
) -> Expr {
    sum(
        start(linkage, slider),
        along(linkage, bodies, slider, drawing),
    )
}

/// Returns the vector from the start of the slot to the slider.
pub(super) fn along(
    linkage: &Linkage,
    bodies: &Bodies,
    slider: &Slider,
    drawing: &Drawing,
) -> Expr {
    let position = name(&slider.name);
    match slider.path {
        Path::Line(line) if guide(bodies, slider) == FRAME => {
            let unit = call(Function::Unit, vec![line_vector(linkage, line)]);
            product(position, unit)
        }
        _ => {
            let angle = slot_angle(linkage, bodies, slider, drawing);
            call(Function::Polar, vec![position, angle])
        }
    }
}

/// Returns the direction of a slot as drawn.
pub(super) fn drawn_direction(slider: &Slider, drawing: &Drawing) -> Option<Expr> {
    Some(match slider.path {
        Path::Line([first, second]) => call(Function::Angle, vec![drawing.vector(first, second)?]),
        Path::Direction(angle, _) => drawing.at_reference(angle),
    })
}

/// Returns the position of a slider as drawn.
pub(super) fn drawn_position(slider: &Slider, drawing: &Drawing) -> Option<Expr> {
    let unit = match slider.path {
        Path::Line([first, second]) => call(Function::Unit, vec![drawing.vector(first, second)?]),
        Path::Direction(angle, _) => call(Function::Dir, vec![drawing.at_reference(angle)]),
    };
    match start_joint(slider) {
        Some(start) => {
            let vector = drawing.vector(start, slider.pin)?;
            Some(call(Function::Dot, vec![vector, unit]))
        }
        None => Some(super::nodes::number("0", "mm", (&slider.name).into())),
    }
}

/// Returns true if two sliders are in the same slot.
pub(super) fn in_one_slot(one: &Slider, other: &Slider) -> bool {
    let same = match (one.path, other.path) {
        (Path::Line(one), Path::Line(other)) => one == other,
        (Path::Direction(one, Some(start)), Path::Direction(other, Some(end))) => {
            start == end && std::ptr::eq(one, other)
        }
        _ => false,
    };
    same && one.guide == other.guide
}

/// Returns true if the slot leads from one pin towards another, and not back.
pub(super) fn leads_on(one: &Slider, other: &Slider, drawing: &Drawing) -> bool {
    let direction = match one.path {
        Path::Line([first, second]) => drawing.vector(first, second),
        Path::Direction(angle, _) => Some(call(
            Function::Polar,
            vec![super::nodes::number("1", "", angle.span), angle.clone()],
        )),
    };
    let pins = drawing.vector(one.pin, other.pin);
    let [direction, pins] = [direction, pins].map(|vector| drawing.coordinates(&vector?));
    match (direction, pins) {
        (Some([x, y]), Some([u, v])) => x * u + y * v >= 0.0,
        _ => true,
    }
}

/// Returns the place of a pin as drawn, in metres from the start of its slot: along the slot, and
/// beside it.
pub(super) fn drawn_in_slot(slider: &Slider, drawing: &Drawing) -> Option<[f64; 2]> {
    let [u, v] = match slider.path {
        Path::Line([first, second]) => {
            let [x, y] = drawing.coordinates(&drawing.vector(first, second)?)?;
            let length = x.hypot(y);
            [x / length, y / length]
        }
        Path::Direction(angle, _) => {
            let (sin, cos) = drawing.angle(&drawing.at_reference(angle))?.sin_cos();
            [cos, sin]
        }
    };
    let [x, y] = drawing.coordinates(&drawing.vector(start_joint(slider)?, slider.pin)?)?;
    Some([x * u + y * v, (x * v - y * u).abs()])
}
