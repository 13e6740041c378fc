//! A suspension as joints and links: its points, links and loops.

use super::axes::Meaning;
use super::rocker::Rocker;
use super::roles::Points;
use super::wheel_travel::Hold;
use crate::drawn::{Drawn, DrawnPoint, Drive, Measure};
use crate::error::ImportError;
use crate::number::plain;
use crate::placement::{Vector, cross, difference, length};

/// Points of the carrier on one line, as a part of the square of its size, give no axes.
const FLAT: f64 = 1e-6;

/// A joint where it is drawn.
pub(super) struct JointLine {
    pub(super) name: String,
    pub(super) at: Vector,
    pub(super) note: String,
    pub(super) is_of_file: bool,
}

/// A link with its joints and its clauses.
pub(super) struct LinkLine {
    pub(super) name: String,
    pub(super) joints: Vec<String>,
    pub(super) clause: String,
    /// Distances of points that the link keeps.
    pub(super) lengths: Vec<[String; 2]>,
}

/// The parts of a suspension.
#[derive(Default)]
pub(super) struct Suspension {
    pub(super) joints: Vec<JointLine>,
    /// Joints of the chassis.
    pub(super) frame: Vec<String>,
    pub(super) links: Vec<LinkLine>,
    /// Lines in front of the links.
    pub(super) parameters: Vec<String>,
    pub(super) loops: Vec<String>,
    pub(super) lets: Vec<String>,
    pub(super) quantities: Vec<String>,
    pub(super) warnings: Vec<String>,
    /// The joints of the carrier.
    carrier: Vec<(String, Vector)>,
    /// The quantities that are points, where they are drawn.
    points: Vec<(String, Vector)>,
    pub(super) holds: Vec<Hold>,
    pub(super) rocker: Option<Rocker>,
    pub(super) unit: &'static str,
    pub(super) centre: Vector,
    band: f64,
    /// The inner end of the tie rod, which is no joint but a point on the rack.
    pub(super) rack_end: Option<Vector>,
}

/// Returns the side on which a coordinate to the left is.
fn side_of(left: f64) -> &'static str {
    if left > 0.0 {
        "left of the middle"
    } else if left < 0.0 {
        "right of the middle"
    } else {
        "on the middle"
    }
}

impl Suspension {
    /// Writes all parts of the suspension.
    pub(super) fn new(points: &Points, meaning: &Meaning) -> Result<Self, ImportError> {
        let centre = points.point("wheel_centre").unwrap_or_default();
        let mut suspension = Self {
            unit: meaning.unit,
            centre,
            band: points.band,
            ..Self::default()
        };
        if centre[1] * meaning.outside() <= 0.0 {
            return Err(ImportError::new(format!(
                "with these axes the wheel centre is {}, which is not the {} side\nhelp: another `--side`, or other `--axes`; a middle that is not at 0 must be moved there",
                side_of(centre[1]),
                if meaning.is_left { "left" } else { "right" }
            )));
        }
        suspension.on_carrier(points, "wheel_centre");
        let height = suspension.length(centre[2]);
        let of_travel = format!("loop wheel_centre.z = {height} + travel;");
        suspension.loops.push(of_travel);
        suspension.suspended(points)?;
        suspension.wheel(points, meaning);
        suspension.rocker(points)?;
        suspension.damper(points);
        let carrier = suspension.carrier_link()?;
        suspension.links.insert(0, carrier);
        Ok(suspension)
    }

    /// Adds a joint, once.
    fn joint(&mut self, name: &str, at: Vector, note: String, is_of_file: bool) {
        if !self.joints.iter().any(|joint| joint.name == name) {
            self.joints.push(JointLine {
                name: name.to_owned(),
                at,
                note,
                is_of_file,
            });
        }
    }

    fn joint_of_role(&mut self, points: &Points, role: &str) -> Option<Vector> {
        let at = points.point(role)?;
        let name = points.names.get(role);
        let note = name.map_or_else(String::new, |name| format!("{name} in the file"));
        self.joint(role, at, note, true);
        Some(at)
    }

    /// A point of the chassis.
    pub(super) fn chassis(&mut self, points: &Points, role: &str) -> Option<Vector> {
        let at = self.joint_of_role(points, role)?;
        if !self.frame.iter().any(|name| name == role) {
            self.frame.push(role.to_owned());
        }
        Some(at)
    }

    /// A point of the carrier.
    pub(super) fn on_carrier(&mut self, points: &Points, role: &str) -> Option<Vector> {
        let at = self.joint_of_role(points, role)?;
        if !self.carrier.iter().any(|(name, _)| name == role) {
            self.carrier.push((role.to_owned(), at));
            self.quantity(role, at);
        }
        Some(at)
    }

    /// A point of the carrier that the file does not have.
    pub(super) fn beside_carrier(&mut self, name: &str, at: Vector) {
        self.joint(name, at, "not in the file".to_owned(), false);
        self.carrier.push((name.to_owned(), at));
    }

    /// A point of a link that turns about an axis of the chassis.
    pub(super) fn on_link(&mut self, points: &Points, role: &str, link: &str) -> Option<Vector> {
        let at = self.joint_of_role(points, role)?;
        let link = self.links.iter_mut().find(|line| line.name == link)?;
        if !link.joints.iter().any(|name| name == role) {
            let pivot = link.joints[0].clone();
            link.lengths.push([pivot, role.to_owned()]);
            link.joints.push(role.to_owned());
            self.quantity(role, at);
        }
        Some(at)
    }

    /// A rod between two ball joints.
    pub(super) fn rod_link(&mut self, name: &str, ends: [&str; 2]) {
        let ends = ends.map(ToOwned::to_owned);
        self.links.push(LinkLine {
            name: name.to_owned(),
            joints: ends.to_vec(),
            clause: String::new(),
            lengths: vec![ends],
        });
    }

    /// The carrier: its axes are given by the wheel centre and the two points that are least on one
    /// line with it, which come first.
    fn carrier_link(&self) -> Result<LinkLine, ImportError> {
        let area = |a: Vector, b: Vector| {
            length(cross(
                difference(a, self.centre),
                difference(b, self.centre),
            ))
        };
        let others = &self.carrier[1..];
        let pairs = others
            .iter()
            .enumerate()
            .flat_map(|(index, a)| others[index + 1..].iter().map(move |b| (a, b)));
        let areas = pairs.map(|(a, b)| (area(a.1, b.1), [&a.0, &b.0]));
        let (most, first) = areas
            .max_by(|a, b| a.0.total_cmp(&b.0))
            .unwrap_or((0.0, [&self.carrier[0].0; 2]));
        let size = others
            .iter()
            .map(|(_, at)| length(difference(*at, self.centre)));
        if most <= FLAT * size.fold(0.0, f64::max).powi(2) {
            return Err(ImportError::new(
                "all points of the carrier are on one line: the points do not make a suspension",
            ));
        }
        let mut joints = vec![
            self.carrier[0].0.clone(),
            first[0].clone(),
            first[1].clone(),
        ];
        for (name, _) in others {
            if !joints.contains(name) {
                joints.push(name.clone());
            }
        }
        Ok(LinkLine {
            name: "carrier".to_owned(),
            joints,
            clause: String::new(),
            lengths: Vec::new(),
        })
    }

    /// Adds a point that moves to the quantities.
    fn quantity(&mut self, role: &str, at: Vector) {
        self.quantities.push(role.to_owned());
        self.points.push((role.to_owned(), at));
    }

    /// The drawn pose; the travel shifts the wheel centre.
    pub(super) fn drawn(&self) -> Drawn {
        let moving = self.points.iter().map(|(name, at)| (name, *at, false));
        let fixed = self.joints.iter();
        let fixed = fixed.filter(|joint| self.frame.contains(&joint.name));
        let fixed = fixed.map(|joint| (&joint.name, joint.at, true));
        let points = moving
            .chain(fixed)
            .map(|(name, position, is_fixed)| DrawnPoint {
                name: name.clone(),
                position,
                is_fixed,
            });
        let travel = Drive {
            input: "travel".to_owned(),
            rate: 1.0,
            measure: Measure::Shift {
                point: 0,
                origin: None,
                along: [0.0, 0.0, 1.0],
                base: None,
            },
        };
        Drawn {
            function: "motion",
            unit: self.unit,
            band: self.band,
            points: points.collect(),
            drives: vec![travel],
        }
    }

    /// The position of a point where it is drawn.
    pub(super) fn position(&self, name: &str) -> Option<Vector> {
        let mut joints = self.joints.iter();
        let joint = joints.find(|joint| joint.name == name);
        match joint {
            Some(joint) => Some(joint.at),
            None => self.rack_end.filter(|_| name == "tie_inner"),
        }
    }

    pub(super) fn length(&self, value: f64) -> String {
        format!("{}{}", plain(value), self.unit)
    }

    pub(super) fn point(&self, point: Vector) -> String {
        let all = point.map(|value| self.length(value));
        format!("({})", all.join(", "))
    }
}
