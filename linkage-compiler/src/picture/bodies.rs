//! Points and segments of bodies and joints.

use crate::algebra::Algebra;
use crate::model::Joint;
use crate::picture::layout::Layout;
use crate::picture::marks::{Line, Shape, Title};
use crate::picture::sketch::Sketch;
use crate::picture::statement::Statement;
use crate::picture::{chains, layout, parts, titles};

/// The joints of each body are points of it.
pub(super) fn look_at_bodies<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
) {
    let mechanism = algebra.mechanism;
    let points: Vec<Option<usize>> = mechanism
        .joints
        .iter()
        .map(|joint| chains::point_of(algebra, layout, sketch, Statement::default(), &joint.at))
        .collect();
    for (joint, point) in mechanism.joints.iter().zip(&points) {
        if let (Some(text), Some(point)) = (&joint.name, point) {
            let text = text.clone();
            titles::call(&mut sketch.points[*point], Title { rank: 3, text });
        }
    }
    for (index, body) in mechanism.bodies.iter().enumerate() {
        let Some(origin) = points[body.joint] else {
            continue;
        };
        for (joint, point) in mechanism.joints.iter().zip(&points) {
            // What slides along a guide is no point of it.
            let carries = joint.on == Some(index) && !joint.kind.slides();
            if let (true, Some(point)) = (carries || joint.body == index, point) {
                let text = body.name.clone();
                sketch.segment(
                    &[],
                    [origin, *point],
                    Some(Title { rank: 0, text }),
                    Shape::Body(Some(index)),
                );
            }
        }
    }
    for (joint, point) in mechanism.joints.iter().zip(&points) {
        if let Some(point) = point {
            sketch.joints.push((*point, joint.kind));
            let name = joint.name.iter().cloned();
            sketch.joint_names.extend(name.map(|name| (name, *point)));
            look_at_direction(algebra, layout.dimension, sketch, joint, *point, &points);
        }
    }
}

fn look_at_direction<'m>(
    algebra: &mut Algebra<'m>,
    dimension: usize,
    sketch: &mut Sketch<'m>,
    joint: &'m Joint,
    point: usize,
    points: &[Option<usize>],
) {
    let Some(direction) = &joint.direction else {
        return;
    };
    let mechanism = algebra.mechanism;
    let along = layout::vector(algebra, dimension, direction);
    if !joint.kind.slides() {
        return parts::axis(&mut sketch.axes, point, along);
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
