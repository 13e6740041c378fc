//! Links, straight slots and pairs of wheels, which pictures show and descriptions of robots need.

use proc_macro2::Ident;

use super::drawing::Drawing;
use super::linkage::{FRAME, Linkage, Wheels, is_spatial};
use super::locations::{angle, is_cylinder, point};
use super::rigid_bodies::Bodies;
use super::slides::{slot_angle, start};
use super::wheels;
use crate::syntax::{LinkElements, PairOfWheels, PairedWheel, RigidLink, StraightSlot};

/// Returns the rigid links, the straight slots and the pairs of wheels.
pub(super) fn elements(linkage: &Linkage, bodies: &Bodies, drawing: &Drawing) -> LinkElements {
    if is_spatial(linkage) {
        let links = FRAME + 1..linkage.links.len();
        let rigid = links
            .filter_map(|link| rigid_link(linkage, drawing, link, &linkage.links[link].joints));
        return LinkElements {
            links: rigid.collect(),
            slots: Vec::new(),
            pairs: Vec::new(),
        };
    }
    let moving = bodies.list[FRAME + 1..].iter();
    let links = moving.filter_map(|body| rigid_link(linkage, drawing, body.lead(), &body.joints));
    let slots = linkage.sliders.iter().map(|slider| StraightSlot {
        name: slider.name.clone(),
        slider: point(linkage, slider.pin),
        start: start(linkage, slider),
        angle: slot_angle(linkage, bodies, slider, drawing),
    });
    let pairs = linkage.wheels.iter();
    LinkElements {
        links: links.collect(),
        slots: slots.collect(),
        pairs: pairs
            .map(|pair| pair_of_wheels(linkage, bodies, pair))
            .collect(),
    }
}

/// Returns a link with at least two joints that keep their distances. The second joint of a cylinder
/// is on its rod, and the arc of a curved slot is no link.
fn rigid_link(
    linkage: &Linkage,
    drawing: &Drawing,
    lead: usize,
    joints: &[usize],
) -> Option<RigidLink> {
    let link = &linkage.links[lead];
    let sliding = link.joints.get(1);
    let sliding = sliding.filter(|_| is_cylinder(link, drawing));
    let rigid = joints.iter().filter(|joint| sliding != Some(*joint));
    let joints: Vec<_> = rigid.map(|joint| point(linkage, *joint)).collect();
    (joints.len() > 1 && !link.is_arc()).then(|| RigidLink {
        name: link.name.clone(),
        joints,
    })
}

fn pair_of_wheels(linkage: &Linkage, bodies: &Bodies, pair: &Wheels) -> PairOfWheels {
    let wheels = pair.wheels.map(|wheel| {
        let body = body_name(linkage, bodies, wheel);
        let pivot = bodies.shared_joint(wheel, pair.carrier);
        PairedWheel {
            angle: body.is_some().then(|| angle(linkage, wheel)),
            pivot: pivot.map(|joint| point(linkage, joint)),
            body,
        }
    });
    PairOfWheels {
        wheels,
        carrier: body_name(linkage, bodies, pair.carrier),
        ratio: wheels::ratio(pair),
        touch: pair.reverses,
    }
}

/// Returns the name of the body that a link is part of; `None` for the frame.
fn body_name(linkage: &Linkage, bodies: &Bodies, link: usize) -> Option<Ident> {
    let body = bodies.of_link[link];
    (body != FRAME).then(|| linkage.links[bodies.list[body].lead()].name.clone())
}
