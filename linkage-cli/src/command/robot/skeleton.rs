//! Bodies and joints of a mechanism with numbers: lengths in metres, masses in kilograms.
//!
//! At the reference all frames of bodies are parallel to the fixed one, and a body's origin is the
//! point of its joint.

use linkage_engine::{Assembly, Mechanism};
use linkage_language::syntax::JointKind;

use super::declared::{Declared, DeclaredJoint, field, name_of};
use super::jointed_links::{Closure, FIXED, Freedom, Link, Pose, pose_of};
use super::mass::{InertiaAxes, Mass, in_metres, mass_of};
use super::metres::Metres;
use super::results::Values;
use super::space_vectors::{
    AXES, IDENTITY, Rotation, Vector, ZERO, about, between, difference, from_axes, length, product,
    sum, transposed, turned, unit,
};
use crate::failure::Failure;

/// The name of the function that computes positions.
pub(super) const POSITIONS: &str = "robot_positions";

/// The name of the function that computes masses.
pub(super) const CONSTANTS: &str = "robot_constants";

/// A mechanism of bodies.
pub(super) struct Skeleton<'m> {
    pub(super) links: Vec<Link>,
    pub(super) closures: Vec<Closure>,
    pub(super) gravity: Vector,
    /// Parents come before those that hang on them.
    pub(super) order: Vec<usize>,
    pub(super) is_plane: bool,
    declared: &'m Declared,
    mechanism: &'m Mechanism,
    assembly: &'m Assembly<'m>,
    function: usize,
    arguments: Vec<f64>,
    /// The place of the running input among the arguments.
    running: usize,
    metres: Metres,
    reference: Vec<Orientation>,
}

/// The orientation of a body as it is declared.
#[derive(Clone, Copy, Debug)]
enum Orientation {
    Along,
    Angle(f64),
    Axes(Rotation),
    Rod(Vector),
}

/// The input that moves, and the values of the others.
pub(super) struct ChosenInput {
    pub(super) arguments: Vec<f64>,
    pub(super) running: usize,
}

impl<'m> Skeleton<'m> {
    /// Returns the bodies at these arguments of the function of positions.
    pub(super) fn new(
        declared: &'m Declared,
        mechanism: &'m Mechanism,
        assembly: &'m Assembly<'m>,
        course: ChosenInput,
    ) -> Result<Self, Failure> {
        let function = mechanism.function(POSITIONS);
        let function = function.map_err(|error| Failure::Told(error.to_string()))?;
        let metres = Metres::of_unit(mechanism.compiled().length)?;
        let mut skeleton = Self {
            links: Vec::new(),
            closures: Vec::new(),
            gravity: ZERO,
            order: declared.order(),
            is_plane: true,
            declared,
            mechanism,
            assembly,
            function,
            arguments: course.arguments,
            running: course.running,
            metres,
            reference: Vec::new(),
        };
        let values = Values::of_call(mechanism, assembly, function, &skeleton.arguments);
        let constants = mechanism.function(CONSTANTS).ok();
        let constants =
            constants.map(|function| Values::of_call(mechanism, assembly, function, &[]));
        let width = |index| values.numbers(&field("at", index)).len();
        skeleton.is_plane = (0..declared.bodies.len()).all(|index| width(index) == 2);
        skeleton.reference = skeleton.orientations(&values);
        skeleton.links = skeleton.all_links(constants.as_ref(), &values)?;
        let closures = declared.closures.iter().enumerate();
        skeleton.closures = closures
            .map(|(index, (body, joint))| Closure {
                name: joint.name.clone().unwrap_or_else(|| {
                    let [body, on] = [*body, joint.on].map(|body| name_of(&declared.bodies, body));
                    format!("{body}_{on}").replace('`', "")
                }),
                kind: joint.kind,
                bodies: [*body, joint.on],
                at: metres.vector(values.vector(&field("closing_at", index))),
                along: skeleton.direction(&values, "closing_along", index, joint),
            })
            .collect();
        if let Some(constants) = &constants
            && !constants.numbers("gravity").is_empty()
        {
            skeleton.gravity = metres.vector(constants.vector("gravity"));
        }
        Ok(skeleton)
    }

    fn all_links(&self, constants: Option<&Values>, values: &Values) -> Result<Vec<Link>, Failure> {
        let bodies = self.declared.bodies.iter().enumerate();
        bodies
            .map(|(index, body)| {
                let origin = self.metres.vector(values.vector(&field("at", index)));
                let direction = self.direction(values, "along", index, &body.joint);
                let mass = match constants {
                    Some(constants) => mass_of(body, index, constants, values, self.axes(index))?,
                    None => Mass::default(),
                };
                let name = || format!("{}_joint", body.name);
                Ok(Link {
                    name: body.name.clone(),
                    joint: body.joint.name.clone().unwrap_or_else(name),
                    parent: body.joint.on,
                    freedoms: self.freedoms(body.joint.kind, direction),
                    origin,
                    mass: in_metres(mass, origin, self.metres),
                })
            })
            .collect()
    }

    /// The axes of a body's inertia.
    fn axes(&self, index: usize) -> InertiaAxes {
        let (frame, rod) = match self.reference[index] {
            Orientation::Axes(axes) => (axes, None),
            Orientation::Rod(along) => (IDENTITY, Some(along)),
            Orientation::Along | Orientation::Angle(_) => (IDENTITY, None),
        };
        InertiaAxes { frame, rod }
    }

    fn direction(
        &self,
        values: &Values,
        kind: &str,
        index: usize,
        joint: &DeclaredJoint,
    ) -> Option<Vector> {
        joint
            .has_direction()
            .then(|| unit(values.vector(&field(kind, index))))
    }

    fn freedoms(&self, kind: JointKind, direction: Option<Vector>) -> Vec<Freedom> {
        let up = AXES[2];
        let along = direction.unwrap_or(up);
        match kind {
            JointKind::Pin => vec![Freedom::Hinge(if self.is_plane { up } else { along })],
            JointKind::Slide => vec![Freedom::Slide(along)],
            JointKind::Roller => vec![Freedom::Slide(along), Freedom::Hinge(up)],
            JointKind::Cylinder => vec![Freedom::Slide(along), Freedom::Hinge(along)],
            JointKind::Ball => vec![Freedom::Ball],
            JointKind::Fixed => Vec::new(),
        }
    }

    /// The metres of the mechanism's length unit.
    pub(super) fn metres(&self) -> Metres {
        self.metres
    }

    /// The reference value of the running input.
    pub(super) fn reference(&self) -> f64 {
        self.arguments[self.running]
    }

    /// The function of positions at a value of the running input.
    pub(super) fn values_at(&self, x: f64) -> Values {
        let arguments = self.arguments_at(x);
        Values::of_call(self.mechanism, self.assembly, self.function, &arguments)
    }

    fn arguments_at(&self, x: f64) -> Vec<f64> {
        let mut arguments = self.arguments.clone();
        arguments[self.running] = x;
        arguments
    }

    /// The poses of all bodies at a value of the running input; not finite where the mechanism has
    /// no position.
    pub(super) fn poses(&self, x: f64) -> Vec<Pose> {
        self.poses_at(&self.arguments_at(x))
    }

    /// The arguments of the function of positions at the reference.
    pub(super) fn arguments(&self) -> &[f64] {
        &self.arguments
    }

    /// The inputs among the arguments by their numbers, with their ranges.
    pub(super) fn inputs(&self) -> Vec<(usize, [f64; 2])> {
        let arguments = &self.mechanism.compiled().functions[self.function].arguments;
        let inputs = arguments.iter().enumerate().filter_map(|(number, index)| {
            let (low, high) = self.mechanism.inputs().get(*index)?.ends();
            Some((number, [low, high]))
        });
        inputs.collect()
    }

    /// The poses of all bodies at other arguments.
    pub(super) fn poses_at(&self, arguments: &[f64]) -> Vec<Pose> {
        let values = Values::of_call(self.mechanism, self.assembly, self.function, arguments);
        let orientations = self.orientations(&values);
        let mut poses = vec![FIXED; self.links.len()];
        for &index in &self.order {
            let parent = pose_of(&poses, self.links[index].parent);
            let (rotation, angle) = self.rotation(index, orientations[index], &parent);
            poses[index] = Pose {
                origin: self.metres.vector(values.vector(&field("at", index))),
                rotation,
                angle,
            };
        }
        poses
    }

    fn rotation(&self, index: usize, now: Orientation, on: &Pose) -> (Rotation, Option<f64>) {
        match (self.reference[index], now) {
            (Orientation::Angle(from), Orientation::Angle(to)) if self.is_plane => {
                (about(AXES[2], to - from), Some(to - from))
            }
            (Orientation::Angle(from), Orientation::Angle(to)) => {
                let freedoms = self.links[index].freedoms.iter();
                let mut axes = freedoms.filter_map(|freedom| match freedom {
                    Freedom::Hinge(axis) => Some(*axis),
                    Freedom::Slide(_) | Freedom::Ball => None,
                });
                let axis = axes.next().unwrap_or(AXES[2]);
                (product(&on.rotation, &about(axis, to - from)), None)
            }
            (Orientation::Axes(from), Orientation::Axes(to)) => {
                (product(&to, &transposed(&from)), None)
            }
            (Orientation::Rod(from), Orientation::Rod(to)) => (between(from, to), None),
            // It turns with the body that it is attached to.
            _ => (on.rotation, on.angle),
        }
    }

    fn orientations(&self, values: &Values) -> Vec<Orientation> {
        let bodies = self.declared.bodies.iter().enumerate();
        bodies
            .map(|(index, body)| {
                if !body.has_turns() {
                    return Orientation::Along;
                }
                match *values.numbers(&field("turns", index)) {
                    [angle] => Orientation::Angle(angle),
                    [x, y, z] => Orientation::Rod(unit([x, y, z])),
                    [_, _, _, ref axes @ ..] => {
                        let axis = |k: usize| [axes[k], axes[k + 1], axes[k + 2]];
                        Orientation::Axes(from_axes(&[axis(0), axis(3), axis(6)]))
                    }
                    _ => Orientation::Along,
                }
            })
            .collect()
    }

    /// The largest distance of a joint from the first one.
    pub(super) fn size(&self) -> f64 {
        let points = self.links.iter().map(|link| link.origin);
        let points = points.chain(self.closures.iter().map(|closure| closure.at));
        let first = self.links.first().map_or(ZERO, |link| link.origin);
        let distances = points.map(|point| length(difference(point, first)));
        distances.fold(0.0, f64::max)
    }

    /// The position of a point that is fixed on a body, from its position at the reference.
    pub(super) fn carried(&self, poses: &[Pose], body: Option<usize>, at: Vector) -> Vector {
        let origin = body.map_or(ZERO, |index| self.links[index].origin);
        let pose = pose_of(poses, body);
        sum(pose.origin, turned(&pose.rotation, difference(at, origin)))
    }

    /// True if a rod between balls turns freely about itself.
    pub(super) fn spins(&self, index: usize) -> bool {
        let is_rod = matches!(self.reference[index], Orientation::Rod(_));
        is_rod && self.links[index].freedoms == [Freedom::Ball]
    }
}
