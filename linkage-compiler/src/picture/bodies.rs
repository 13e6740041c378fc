//! What bodies and joints say of links.

use crate::model::Joint;
use crate::picture::parts;
use crate::picture::titles;

use super::chains::Sketch;
use super::marks::{Line, Shape, Title};

/// The joints of each body are points of it.
pub(super) fn look_at_bodies(sketch: &mut Sketch<'_, '_>) {
    let mechanism = sketch.algebra.mechanism;
    let points: Vec<Option<usize>> = mechanism
        .joints
        .iter()
        .map(|joint| sketch.point_of(&joint.at))
        .collect();
    for (joint, point) in mechanism.joints.iter().zip(&points) {
        if let (Some(text), Some(point)) = (&joint.name, point) {
            let text = text.clone();
            titles::call(sketch, *point, Title { rank: 3, text });
        }
    }
    for (index, body) in mechanism.bodies.iter().enumerate() {
        let Some(own) = points[body.joint] else {
            continue;
        };
        for (joint, point) in mechanism.joints.iter().zip(&points) {
            // What slides along a guide is no point of it.
            let carries = joint.on == Some(index) && !joint.kind.slides();
            if let (true, Some(point)) = (carries || joint.body == index, point) {
                let text = body.name.clone();
                sketch.segment(
                    own,
                    *point,
                    Some(Title { rank: 0, text }),
                    Shape::Body(Some(index)),
                );
            }
        }
    }
    for (joint, point) in mechanism.joints.iter().zip(&points) {
        if let Some(point) = point {
            sketch.joints.push((*point, joint.kind));
            look_at_direction(sketch, joint, *point, &points);
        }
    }
}

fn look_at_direction<'m>(
    sketch: &mut Sketch<'_, 'm>,
    joint: &'m Joint,
    point: usize,
    points: &[Option<usize>],
) {
    let Some(direction) = &joint.direction else {
        return;
    };
    let mechanism = sketch.algebra.mechanism;
    let along = sketch.vector(direction);
    if !joint.kind.slides() {
        return parts::axis(sketch, point, along);
    }
    let along = along.unit();
    let carrier = joint
        .on
        .and_then(|body| points[mechanism.bodies[body].joint]);
    let body = &mechanism.bodies[joint.body].name;
    let name = joint.name.as_ref().unwrap_or(body).clone();
    sketch.lines.push(Line {
        slider: point,
        carrier,
        foot: None,
        along,
        name,
    });
}
