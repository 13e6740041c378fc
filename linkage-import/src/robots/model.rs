//! A robot as its file describes it: rigid bodies in a tree of joints, closures of loops, couplings.
//!
//! All points and directions are in fixed coordinates of the drawn position, where every joint is
//! zero.

use std::collections::BTreeMap;

use crate::error::ImportError;
use crate::names::shown;
use crate::placement::{Placement, Vector, difference, dot, scaled, sum};

/// More bodies than any mechanism that is worth a closed form.
const MOST_BODIES: usize = 400;

/// More loops than such a mechanism has.
const MOST_CLOSURES: usize = 400;

/// The relative motion that a joint allows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Motion {
    Hinge(Vector),
    Slide(Vector),
    Ball,
    /// All six motions: the body is held by closures alone.
    Free,
    /// None.
    Fixed,
}

/// The joint that a body hangs on.
#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) motion: Motion,
    pub(crate) parent: usize,
    /// The point that it turns about, where it is drawn.
    pub(crate) at: Vector,
    /// The limits, from the drawn position.
    pub(crate) range: Option<[f64; 2]>,
    /// The value of the joint in the file where it is drawn.
    pub(crate) zero: f64,
    pub(crate) is_driven: bool,
    /// A joint that it follows, and the coefficients of a polynomial.
    pub(crate) follows: Option<(usize, Vec<f64>)>,
}

impl Joint {
    /// Returns the bodies that have the point of the joint of a body: on a slide it leaves the
    /// parent.
    pub(crate) fn bodies(&self, body: usize) -> Vec<usize> {
        match self.motion {
            Motion::Slide(_) => vec![body],
            Motion::Hinge(_) | Motion::Ball | Motion::Free | Motion::Fixed => {
                vec![body, self.parent]
            }
        }
    }
}

/// A mass with its tensor about the centre, in fixed axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mass {
    pub(crate) mass: f64,
    pub(crate) centre: Vector,
    pub(crate) inertia: [Vector; 3],
}

/// A rigid body; the first one is fixed.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) joint: Option<Joint>,
    pub(crate) masses: Vec<Mass>,
}

/// The kind of a joint that closes a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ClosingJoint {
    Point,
    Hinge(Vector),
    Slide(Vector),
    Weld,
}

/// A joint that closes a loop.
#[derive(Clone, Debug)]
pub(crate) struct Closure {
    pub(crate) name: String,
    pub(crate) closing: ClosingJoint,
    pub(crate) bodies: [usize; 2],
    /// The point on each body.
    pub(crate) at: [Vector; 2],
}

/// A robot.
#[derive(Clone, Debug)]
pub(crate) struct Robot {
    pub(crate) name: String,
    pub(crate) bodies: Vec<Body>,
    pub(crate) closures: Vec<Closure>,
    /// The acceleration of free fall, if the file has masses and says it.
    pub(crate) gravity: Option<Vector>,
    /// Elements and attributes that are not used, with their counts.
    pub(crate) left_out: BTreeMap<String, usize>,
    pub(crate) warnings: Vec<String>,
}

impl Robot {
    pub(crate) fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            bodies: vec![Body {
                name: "frame".to_owned(),
                joint: None,
                masses: Vec::new(),
            }],
            closures: Vec::new(),
            gravity: None,
            left_out: BTreeMap::new(),
            warnings: Vec::new(),
        }
    }

    /// Adds a body, whose joint is named. Returns its index.
    pub(crate) fn add(&mut self, name: &str, joint: Joint) -> Result<usize, ImportError> {
        if self.bodies.len() > MOST_BODIES {
            return Err(ImportError::new(format!(
                "the file has more than {MOST_BODIES} moving bodies"
            )));
        }
        self.bodies.push(Body {
            name: name.to_owned(),
            joint: Some(joint),
            masses: Vec::new(),
        });
        Ok(self.bodies.len() - 1)
    }

    /// Adds a joint that closes a loop.
    pub(crate) fn close(&mut self, closure: Closure) -> Result<(), ImportError> {
        if self.closures.len() >= MOST_CLOSURES {
            return Err(ImportError::new(format!(
                "the file has more than {MOST_CLOSURES} loops"
            )));
        }
        self.closures.push(closure);
        Ok(())
    }

    /// The body of the joint of this name.
    pub(crate) fn joint_named(&self, name: &str) -> Option<usize> {
        let of_name = |body: &Body| body.joint.as_ref().is_some_and(|joint| joint.name == name);
        self.bodies.iter().position(of_name)
    }

    /// Counts something that is not used.
    pub(crate) fn leave_out(&mut self, what: &str) {
        *self.left_out.entry(shown(what)).or_default() += 1;
    }

    /// Adds a mass to a body. Its centre is the origin of the placement, and its tensor has the axes
    /// of the placement.
    pub(crate) fn add_mass(
        &mut self,
        body: usize,
        located: &Placement,
        mass: f64,
        tensor: &[Vector; 3],
    ) {
        self.bodies[body].masses.push(Mass {
            mass,
            centre: located.origin,
            inertia: located.tensor(tensor),
        });
    }

    /// Returns true if a body is the other one or hangs on it.
    pub(crate) fn hangs_on(&self, body: usize, other: usize) -> bool {
        let mut current = body;
        loop {
            if current == other {
                return true;
            }
            match &self.bodies[current].joint {
                Some(joint) => current = joint.parent,
                None => return false,
            }
        }
    }

    /// The largest distance of a joint from the first one.
    pub(crate) fn size(&self) -> f64 {
        let joints = self.bodies.iter().filter_map(|body| body.joint.as_ref());
        let points = joints.map(|joint| joint.at);
        let points = points.chain(self.closures.iter().flat_map(|closure| closure.at));
        let mut points = points.peekable();
        let first = points.peek().copied().unwrap_or_default();
        points.fold(0.0, |most, point| {
            let apart = difference(point, first);
            f64::max(most, dot(apart, apart).sqrt())
        })
    }
}

impl Body {
    /// The sum of its masses.
    pub(crate) fn mass(&self) -> Option<Mass> {
        let mass: f64 = self.masses.iter().map(|mass| mass.mass).sum();
        if mass <= 0.0 {
            return None;
        }
        let centres = self.masses.iter().map(|one| scaled(one.centre, one.mass));
        let centre = scaled(centres.fold([0.0; 3], sum), 1.0 / mass);
        let mut inertia = [[0.0; 3]; 3];
        for one in &self.masses {
            let arm = difference(one.centre, centre);
            for (i, row) in inertia.iter_mut().enumerate() {
                for (j, number) in row.iter_mut().enumerate() {
                    let square = if i == j { dot(arm, arm) } else { 0.0 };
                    *number += one.inertia[i][j] + one.mass * (square - arm[i] * arm[j]);
                }
            }
        }
        Some(Mass {
            mass,
            centre,
            inertia,
        })
    }
}

/// A joint that nothing drives and that follows nothing.
pub(crate) fn joint(name: &str, motion: Motion, parent: usize, at: Vector) -> Joint {
    Joint {
        name: name.to_owned(),
        motion,
        parent,
        at,
        range: None,
        zero: 0.0,
        is_driven: false,
        follows: None,
    }
}

/// Returns a moment of inertia from the numbers of its six names, in the order of its rows.
pub(crate) fn tensor(
    number: impl Fn(&'static str) -> Result<f64, ImportError>,
) -> Result<[[f64; 3]; 3], ImportError> {
    let names = [
        ["ixx", "ixy", "ixz"],
        ["ixy", "iyy", "iyz"],
        ["ixz", "iyz", "izz"],
    ];
    let mut tensor = [[0.0; 3]; 3];
    for (row, names) in tensor.iter_mut().zip(names) {
        for (entry, name) in row.iter_mut().zip(names) {
            *entry = number(name)?;
        }
    }
    Ok(tensor)
}
