//! A document of bodies as joints, links and slots: pins join points, welds join bodies.

use std::collections::BTreeMap;

use crate::document::{
    Document, FRAME, Input, InputKind, LengthUnit, Load, MOST_JOINTS, MOST_LINKS, Slot, SlotPath,
};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::plain;

use super::body_conversion::Conversion;
use super::body_document::{
    Attachment, BodyDocument, BodyJoint, CoordinateKind, Driver, JointKind, WORLD,
};
use super::envelope;
use super::groups::Groups;
use super::masses;

/// The version of documents that is read.
const VERSION: u32 = 2;

/// Points of one body that are nearer than this part of its largest coordinate are one point.
const SAME: f64 = 1e-12;

/// Returns the mechanism of an address with a document of bodies.
pub(super) fn read(query: &str) -> Result<Document, ImportError> {
    let text = envelope::document(query)?;
    let source: BodyDocument = serde_json::from_str(&text).map_err(|error| {
        ImportError::new(format!(
            "the document of the address cannot be read: {error}"
        ))
    })?;
    if source.version != VERSION {
        return Err(ImportError::new(format!(
            "the address has a document of version {}, and version {VERSION} is read",
            source.version
        )));
    }
    if source.attachments.len() > MOST_JOINTS || source.bodies.len() > MOST_LINKS {
        return Err(ImportError::new(format!(
            "the address has more than {MOST_JOINTS} points or {MOST_LINKS} bodies"
        )));
    }
    document(&source)
}

fn document(source: &BodyDocument) -> Result<Document, ImportError> {
    let unit = LengthUnit::named(&source.units.length).ok_or_else(|| {
        ImportError::new(format!(
            "the unit of lengths `{}` is not known",
            shown(&source.units.length)
        ))
    })?;
    let bodies = source.bodies.iter().enumerate();
    let attachments = source.attachments.iter().enumerate();
    let mut conversion = Conversion {
        source,
        document: Document::new("an address of PMKS+ with bodies", unit),
        links: Vec::new(),
        joints: Vec::new(),
        bodies: bodies.map(|(index, body)| (&body.id[..], index)).collect(),
        attachments: attachments
            .map(|(index, point)| (&point.id[..], index))
            .collect(),
    };
    conversion.add_links()?;
    conversion.add_joints()?;
    for joint in &source.joints {
        match joint.kind {
            JointKind::Revolute | JointKind::Weld => {}
            JointKind::Prismatic | JointKind::PinInSlot => conversion.add_slot(joint)?,
        }
    }
    for driver in &source.drivers {
        conversion.add_input(driver)?;
    }
    masses::add(&mut conversion)?;
    conversion.add_forces()?;
    Ok(conversion.document)
}

impl Conversion<'_> {
    /// Adds a link for all bodies that are welded.
    fn add_links(&mut self) -> Result<(), ImportError> {
        let mut groups = Groups::new(self.source.bodies.len());
        for joint in &self.source.joints {
            if joint.kind == JointKind::Weld {
                groups.join(self.body(&joint.body_a)?, self.body(&joint.body_b)?);
            }
        }
        let world = self.bodies.get(WORLD).map(|world| groups.first(*world));
        let mut links: BTreeMap<usize, usize> = BTreeMap::new();
        for (index, body) in self.source.bodies.iter().enumerate() {
            let group = groups.first(index);
            let link = if Some(group) == world {
                FRAME
            } else if let Some(link) = links.get(&group) {
                *link
            } else {
                let name = if body.label.is_empty() {
                    &body.id
                } else {
                    &body.label
                };
                let link = self.document.add_link(name, Vec::new());
                links.insert(group, link);
                link
            };
            self.links.push(link);
        }
        Ok(())
    }

    /// Adds a joint for all points that pins join, and for points of one body at one place.
    fn add_joints(&mut self) -> Result<(), ImportError> {
        let points = &self.source.attachments;
        let mut groups = Groups::new(points.len());
        for joint in &self.source.joints {
            if joint.kind == JointKind::Revolute {
                let ends = [&joint.frame_a, &joint.frame_b];
                let [one, other] = ends.map(|frame| self.attachment(&frame.attachment_id));
                groups.join(one?, other?);
            }
        }
        for second in 0..points.len() {
            for first in 0..second {
                if is_same(&points[first], &points[second]) && points[first].body_id != WORLD {
                    groups.join(first, second);
                }
            }
        }
        let mut joints: BTreeMap<usize, usize> = BTreeMap::new();
        for (index, point) in points.iter().enumerate() {
            let position = self.drawn_point(&point.body_id, point.point)?;
            let joint = match joints.get(&groups.first(index)) {
                Some(joint) => *joint,
                None => {
                    let name = if point.label.is_empty() {
                        &point.id
                    } else {
                        &point.label
                    };
                    let joint = self.document.add_joint(name, position);
                    joints.insert(groups.first(index), joint);
                    joint
                }
            };
            self.joints.push(joint);
            let link = self.link(&point.body_id)?;
            self.document.attach(joint, link);
        }
        Ok(())
    }

    fn add_slot(&mut self, joint: &BodyJoint) -> Result<(), ImportError> {
        let body = self.body(&joint.body_a)?;
        let guide = self.links[body];
        let block = self.link(&joint.body_b)?;
        let pin = self.joints[self.attachment(&joint.frame_b.attachment_id)?];
        let through = self.joints[self.attachment(&joint.frame_a.attachment_id)?];
        let angle = self.pose(body).angle + joint.frame_a.angle;
        let text = format!("{}rad", plain(angle));
        let through = (guide != FRAME).then_some(through);
        self.document.slots.push(Slot {
            pin,
            guide,
            path: SlotPath::Direction(angle, text, through),
            block: (joint.kind == JointKind::Prismatic).then_some(block),
        });
        Ok(())
    }

    fn add_input(&mut self, driver: &Driver) -> Result<(), ImportError> {
        let id = &driver.coordinate.joint_id;
        let mut joints = self.source.joints.iter();
        let joint = joints.find(|joint| joint.id == *id);
        let joint = joint.ok_or_else(|| {
            ImportError::new(format!("the address lacks the joint `{}`", shown(id)))
        })?;
        let limits = self.source.limits.iter();
        let mut limits = limits.filter(|limit| {
            limit.coordinate.joint_id == *id
                && limit.coordinate.coordinate == driver.coordinate.coordinate
        });
        let travel = limits
            .next()
            .map(|limit| [limit.lower, limit.upper].map(|end| end - driver.profile.initial));
        let speed = driver.profile.speed;
        let input = match (driver.coordinate.coordinate, joint.kind) {
            (CoordinateKind::Angle, JointKind::Revolute) => Input {
                kind: InputKind::Crank {
                    link: self.link(&joint.body_b)?,
                    pivot: self.joints[self.attachment(&joint.frame_b.attachment_id)?],
                    base: self.link(&joint.body_a)?,
                },
                travel: travel.map(|ends| ends.map(f64::to_degrees)),
                speed: Some(format!("at {} radians per second", plain(speed))),
                rate: Some(speed.to_degrees()),
            },
            (CoordinateKind::Travel, JointKind::Prismatic | JointKind::PinInSlot) => {
                let pin = self.joints[self.attachment(&joint.frame_b.attachment_id)?];
                let guide = self.link(&joint.body_a)?;
                let mut slots = self.document.slots.iter();
                let slot = slots.position(|slot| slot.pin == pin && slot.guide == guide);
                Input {
                    kind: InputKind::Position {
                        slot: slot.expect("the joint has its slot"),
                    },
                    travel,
                    speed: None,
                    rate: None,
                }
            }
            _ => {
                let name = if joint.label.is_empty() {
                    id
                } else {
                    &joint.label
                };
                self.document.warnings.push(format!(
                    "the drive of the joint `{}` is left out: the joint does not move so",
                    shown(name)
                ));
                return Ok(());
            }
        };
        self.document.inputs.push(input);
        Ok(())
    }

    fn add_forces(&mut self) -> Result<(), ImportError> {
        let unit = match &self.source.units.force[..] {
            "lbf" => "lbf",
            _ => "N",
        };
        for (index, force) in self.source.forces.iter().enumerate() {
            let link = self.link(&force.body_id)?;
            let number = (index + 1).to_string();
            let name = if force.label.is_empty() {
                &number
            } else {
                &force.label
            };
            if force.couple != 0.0 {
                self.document.warnings.push(format!(
                    "the couple {} of the force `{}` is left out",
                    plain(force.couple),
                    shown(name)
                ));
            }
            let pose = self.pose(self.body(&force.body_id)?);
            let turns = force.frame == "body";
            let vector = if turns {
                pose.direction(force.vector)
            } else {
                [force.vector.x, force.vector.y]
            };
            let point = pose.point(force.point);
            self.document.add_load(
                name,
                link,
                point,
                Load {
                    vector,
                    unit,
                    turns,
                },
            );
        }
        Ok(())
    }
}

fn is_same(one: &Attachment, other: &Attachment) -> bool {
    let coordinates = [one.point.x, one.point.y, other.point.x, other.point.y];
    let size = coordinates
        .iter()
        .fold(0.0, |size: f64, x| size.max(x.abs()));
    let apart = (one.point.x - other.point.x).hypot(one.point.y - other.point.y);
    one.body_id == other.body_id && apart <= SAME * size
}
