//! A mechanism as files describe it: joints, links, slots, gears and inputs.

use crate::error::ImportError;

mod input;
mod parts;
mod unit;

pub(crate) use input::{Input, InputKind};
pub(crate) use parts::{GearPair, Joint, Link, Load, Mass, PlacedLoad, Slot, SlotPath};
pub(crate) use unit::LengthUnit;

/// The index of the fixed link.
pub(crate) const FRAME: usize = 0;

/// The greatest numbers of joints and of links: files of people have some dozens.
pub(crate) const MOST_JOINTS: usize = 2000;
pub(crate) const MOST_LINKS: usize = 2000;

/// The greatest magnitude of a coordinate, in the unit of the file.
pub(crate) const LARGEST_COORDINATE: f64 = 1e9;

/// A mechanism of a file. Lengths are in `unit`.
#[derive(Clone, Debug)]
pub(crate) struct Document {
    /// The format in a few words, for the heading.
    pub(crate) origin: String,
    /// The name of the mechanism in the file, or empty.
    pub(crate) name: String,
    pub(crate) unit: LengthUnit,
    /// The largest rounding error of a coordinate. Zero if all digits are stored.
    pub(crate) band: f64,
    pub(crate) joints: Vec<Joint>,
    /// The first one is the fixed link.
    pub(crate) links: Vec<Link>,
    pub(crate) slots: Vec<Slot>,
    pub(crate) gears: Vec<GearPair>,
    pub(crate) inputs: Vec<Input>,
    pub(crate) loads: Vec<PlacedLoad>,
    /// Doubts about the inputs of the file: warnings, unless the user names others.
    pub(crate) doubts: Vec<String>,
    /// Facts for the comments of the text.
    pub(crate) remarks: Vec<String>,
    /// Everything that was not taken, or that the user should confirm.
    pub(crate) warnings: Vec<String>,
}

impl Document {
    pub(crate) fn new(origin: &str, unit: LengthUnit) -> Self {
        Self {
            origin: origin.to_owned(),
            name: String::new(),
            unit,
            band: 0.0,
            joints: Vec::new(),
            links: vec![Link {
                name: "frame".to_owned(),
                ..Link::default()
            }],
            slots: Vec::new(),
            gears: Vec::new(),
            inputs: Vec::new(),
            loads: Vec::new(),
            doubts: Vec::new(),
            remarks: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// Adds a joint and returns its index.
    pub(crate) fn add_joint(&mut self, name: impl Into<String>, position: [f64; 2]) -> usize {
        self.joints.push(Joint {
            name: name.into(),
            position,
            is_derived: false,
        });
        self.joints.len() - 1
    }

    /// Adds a joint that the file does not have.
    pub(crate) fn add_derived(&mut self, name: impl Into<String>, position: [f64; 2]) -> usize {
        let index = self.add_joint(name, position);
        self.joints[index].is_derived = true;
        index
    }

    /// Adds a link and returns its index.
    pub(crate) fn add_link(&mut self, name: impl Into<String>, joints: Vec<usize>) -> usize {
        self.links.push(Link {
            name: name.into(),
            joints,
            ..Link::default()
        });
        self.links.len() - 1
    }

    /// Adds a force on a link at a point of the drawing. A force on the fixed link has no effect.
    pub(crate) fn add_load(&mut self, name: &str, link: usize, point: [f64; 2], load: Load) {
        if link == FRAME {
            let name = crate::names::shown(name);
            self.warnings
                .push(format!("the force `{name}` on the fixed link is left out"));
            return;
        }
        let joints = &self.links[link].joints;
        let here = joints
            .iter()
            .copied()
            .find(|joint| self.joints[*joint].position == point);
        let joint = here.unwrap_or_else(|| self.add_derived(format!("place_of_{name}"), point));
        self.attach(joint, link);
        self.loads.push(PlacedLoad { link, joint, load });
    }

    /// Adds a joint to a link unless it is there.
    pub(crate) fn attach(&mut self, joint: usize, link: usize) {
        let joints = &mut self.links[link].joints;
        if !joints.contains(&joint) {
            joints.push(joint);
        }
    }

    /// Returns true if a joint is fixed.
    pub(crate) fn is_fixed(&self, joint: usize) -> bool {
        self.links[FRAME].joints.contains(&joint)
    }

    /// Returns the links of a joint, the fixed one first.
    pub(crate) fn links_of(&self, joint: usize) -> Vec<usize> {
        let links = self.links.iter().enumerate();
        let with_joint = links.filter(|(_, link)| link.joints.contains(&joint));
        with_joint.map(|(index, _)| index).collect()
    }

    pub(crate) fn distance(&self, first: usize, second: usize) -> f64 {
        let [a, b] = [first, second].map(|joint| self.joints[joint].position);
        (b[0] - a[0]).hypot(b[1] - a[1])
    }

    /// Returns the direction from a joint to another in radians.
    pub(crate) fn direction(&self, from: usize, to: usize) -> f64 {
        let [a, b] = [from, to].map(|joint| self.joints[joint].position);
        (b[1] - a[1]).atan2(b[0] - a[0])
    }

    /// Returns the pair of joints with the largest distance, and the distance.
    pub(crate) fn largest_distance(&self) -> Option<(usize, usize, f64)> {
        let mut largest: Option<(usize, usize, f64)> = None;
        for second in 0..self.joints.len() {
            for first in 0..second {
                let distance = self.distance(first, second);
                if largest.is_none_or(|largest| distance > largest.2) {
                    largest = Some((first, second, distance));
                }
            }
        }
        largest
    }

    /// Checks the limits of numbers and sizes.
    pub(crate) fn check(&self) -> Result<(), ImportError> {
        if self.joints.len() > MOST_JOINTS || self.links.len() > MOST_LINKS {
            return Err(ImportError::new(format!(
                "the file has more than {MOST_JOINTS} joints or {MOST_LINKS} links"
            )));
        }
        for joint in &self.joints {
            let is_wrong = |value: &f64| !value.is_finite() || value.abs() > LARGEST_COORDINATE;
            if joint.position.iter().any(is_wrong) {
                let [x, y] = joint.position;
                return Err(ImportError::new(format!(
                    "joint `{}` is at ({x:e}, {y:e}), which is too far away",
                    crate::names::shown(&joint.name)
                )));
            }
        }
        Ok(())
    }
}
