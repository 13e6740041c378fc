//! Coordinates of joints: from positions of bodies to coordinates, and back.

use super::jointed_links::{Freedom, Link, Pose, pose_of};
use super::skeleton::Skeleton;
use super::space_vectors::{
    AXES, IDENTITY, Rotation, about, angle_about, angles_of, difference, dot, length, product,
    scaled, sum, transposed, turned, turned_back,
};

/// One number of a joint.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Coordinate {
    pub(super) name: String,
    pub(super) link: usize,
    /// A slide or a hinge.
    pub(super) freedom: Freedom,
}

impl Coordinate {
    pub(super) fn is_length(&self) -> bool {
        matches!(self.freedom, Freedom::Slide(_))
    }
}

/// The coordinates of all joints, link by link. Every rotation is that of three hinges.
pub(super) fn coordinates(links: &[Link]) -> Vec<Coordinate> {
    let mut all = Vec::new();
    for (link, body) in links.iter().enumerate() {
        for freedom in &body.freedoms {
            let mut add = |suffix: &str, freedom: Freedom| {
                let name = format!("{}{suffix}", body.joint);
                all.push(Coordinate {
                    name,
                    link,
                    freedom,
                });
            };
            match freedom {
                Freedom::Ball => {
                    for (suffix, axis) in ["_x", "_y", "_z"].iter().zip(AXES) {
                        add(suffix, Freedom::Hinge(axis));
                    }
                }
                Freedom::Slide(_) if body.freedoms.len() > 1 => add("_slide", *freedom),
                Freedom::Slide(_) | Freedom::Hinge(_) => add("", *freedom),
            }
        }
    }
    all
}

/// The values of all coordinates at positions of the bodies. Angles that do not count turns are
/// those next to the earlier ones.
pub(super) fn values_at(skeleton: &Skeleton, poses: &[Pose], before: Option<&[f64]>) -> Vec<f64> {
    let mut values = Vec::new();
    for (index, link) in skeleton.links.iter().enumerate() {
        let parent = pose_of(poses, link.parent);
        let pose = poses[index];
        let relative = product(&transposed(&parent.rotation), &pose.rotation);
        let start = origin_on_parent(skeleton, link);
        let now = turned_back(&parent.rotation, difference(pose.origin, parent.origin));
        for freedom in &link.freedoms {
            match freedom {
                Freedom::Slide(axis) => values.push(dot(difference(now, start), *axis)),
                Freedom::Hinge(axis) => values.push(match (parent.angle, pose.angle) {
                    (Some(on), Some(angle)) if skeleton.is_plane => angle - on,
                    _ => continued(angle_about(&relative, *axis), before, values.len()),
                }),
                Freedom::Ball => {
                    for angle in angles_of(&relative) {
                        let angle = continued(angle, before, values.len());
                        values.push(angle);
                    }
                }
            }
        }
    }
    values
}

/// The angle without a jump from the earlier one.
fn continued(angle: f64, before: Option<&[f64]>, index: usize) -> f64 {
    let turn = core::f64::consts::TAU;
    match before {
        Some(before) => angle + turn * ((before[index] - angle) / turn).round(),
        None => angle,
    }
}

/// The origin of a link at the reference, from that of the body that it hangs on.
pub(super) fn origin_on_parent(skeleton: &Skeleton, link: &Link) -> [f64; 3] {
    match link.parent {
        Some(parent) => difference(link.origin, skeleton.links[parent].origin),
        None => link.origin,
    }
}

/// The positions of all bodies at values of the coordinates.
pub(super) fn built(skeleton: &Skeleton, values: &[f64]) -> Vec<Pose> {
    let links = &skeleton.links;
    let mut firsts = Vec::with_capacity(links.len());
    let mut first = 0;
    for link in links {
        firsts.push(first);
        first += link.freedoms.iter().map(numbers).sum::<usize>();
    }
    let still = Pose {
        origin: [0.0; 3],
        rotation: IDENTITY,
        angle: None,
    };
    let mut poses = vec![still; links.len()];
    for &index in &skeleton.order {
        let link = &links[index];
        let parent = pose_of(&poses, link.parent);
        let mut offset = origin_on_parent(skeleton, link);
        let mut rotation: Rotation = IDENTITY;
        let mut next = values[firsts[index]..].iter().copied();
        for freedom in &link.freedoms {
            let mut number = || next.next().unwrap_or(f64::NAN);
            match freedom {
                Freedom::Slide(axis) => offset = sum(offset, scaled(*axis, number())),
                Freedom::Hinge(axis) => rotation = product(&rotation, &about(*axis, number())),
                Freedom::Ball => {
                    for axis in AXES {
                        rotation = product(&rotation, &about(axis, number()));
                    }
                }
            }
        }
        poses[index] = Pose {
            origin: sum(parent.origin, turned(&parent.rotation, offset)),
            rotation: product(&parent.rotation, &rotation),
            angle: None,
        };
    }
    poses
}

fn numbers(freedom: &Freedom) -> usize {
    match freedom {
        Freedom::Ball => 3,
        Freedom::Slide(_) | Freedom::Hinge(_) => 1,
    }
}

/// The largest difference of two positions of a body: of its origin in metres and of points at a
/// distance of `size`.
pub(super) fn distance(a: &Pose, b: &Pose, size: f64) -> f64 {
    let columns = transposed(&a.rotation).into_iter();
    let turns = columns.zip(transposed(&b.rotation));
    let turns = turns.map(|(a, b)| size * length(difference(a, b)));
    let shift = length(difference(a.origin, b.origin));
    // Not finite numbers stay.
    turns.fold(shift, |most, next| {
        if next > most || next.is_nan() {
            next
        } else {
            most
        }
    })
}
