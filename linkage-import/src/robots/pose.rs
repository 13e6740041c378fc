//! The drawn pose of a robot, with the names of its text.

use super::model::Motion;
use super::wording::{NamedPoint, Sections, Wording};
use crate::drawn::{Drawn, DrawnPoint, Drive, Measure};
use crate::placement::{Vector, cross, difference, dot, length};

/// A point this near to an axis, as a part of the size, shows no turn.
const ON_AXIS: f64 = 1e-6;

/// Returns the points of the function `motion` where they are drawn, and the driven coordinates that
/// they show.
pub(super) fn drawn(wording: &Wording, sections: &Sections) -> Drawn {
    let chain = wording.chain;
    let pose = chain.drawn();
    let position = |body: usize, at: Vector| {
        let at = pose.bodies[body].point(at);
        match chain.plane {
            Some(plane) => {
                let [x, y] = plane.coordinates(at);
                [x, y, 0.0]
            }
            None => at,
        }
    };
    let points = sections.points.iter().map(|point| DrawnPoint {
        name: point.name.clone(),
        position: position(point.bodies[0], point.at),
        is_fixed: false,
    });
    let drives = wording.analysis.inputs.iter().filter_map(|index| {
        let body = chain.coordinates[*index].body;
        Some(Drive {
            input: wording.joints[body].clone(),
            rate: 1.0,
            measure: measure(wording, &sections.points, body)?,
        })
    });
    Drawn {
        function: "motion",
        unit: "m",
        band: 0.0,
        points: points.collect(),
        drives: drives.collect(),
    }
}

/// The coordinate that the joint of a body drives, if points show it: in space only against fixed
/// bodies.
fn measure(wording: &Wording, points: &[NamedPoint], body: usize) -> Option<Measure> {
    let chain = wording.chain;
    let joint = wording.body(body).joint.as_ref()?;
    let on = |body: usize| {
        let points = points.iter().enumerate();
        points.filter(move |(_, point)| point.bodies.contains(&body))
    };
    let (pivot, _) = on(body).find(|(_, point)| point.bodies[0] == body)?;
    let nearest = ON_AXIS * chain.size;
    // The base turns only in the plane.
    let base = match (joint.parent, chain.plane) {
        (0, _) => None,
        (_, None) => return None,
        (parent, Some(_)) => {
            let mut ends = on(parent);
            let (first, start) = ends.next()?;
            let apart = |point: &NamedPoint| length(difference(point.at, start.at)) > nearest;
            let (second, _) = ends.find(|(_, point)| apart(point))?;
            Some([first, second])
        }
    };
    match joint.motion {
        Motion::Hinge(axis) => {
            let arm = |point: &NamedPoint| length(cross(axis, difference(point.at, joint.at)));
            let (point, _) = on(body).find(|(_, point)| arm(point) > nearest)?;
            let axis = match chain.plane {
                Some(plane) => [0.0, 0.0, dot(plane.normal, axis).signum()],
                None => axis,
            };
            Some(Measure::Turn {
                pivot,
                point,
                axis,
                base,
            })
        }
        Motion::Slide(axis) => {
            let along = match chain.plane {
                Some(plane) => {
                    let [x, y] = plane.coordinates(axis);
                    [x, y, 0.0]
                }
                None => axis,
            };
            Some(Measure::Shift {
                point: pivot,
                origin: base.map(|[first, _]| first),
                along,
                base,
            })
        }
        Motion::Ball | Motion::Free | Motion::Fixed => None,
    }
}
