//! The document of newer addresses: bodies with their poses, points on them, and joints between two
//! bodies. Numbers have all digits.

use serde::Deserialize;

/// The identifier of the fixed body.
pub(super) const WORLD: &str = "WORLD";

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BodyDocument {
    pub(super) version: u32,
    pub(super) units: Units,
    pub(super) bodies: Vec<Body>,
    pub(super) attachments: Vec<Attachment>,
    pub(super) joints: Vec<BodyJoint>,
    #[serde(default)]
    pub(super) drivers: Vec<Driver>,
    #[serde(default)]
    pub(super) limits: Vec<Limit>,
    #[serde(default)]
    pub(super) forces: Vec<Force>,
    #[serde(default)]
    pub(super) groups: Vec<Group>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Units {
    /// `m`, `cm` or `in`
    pub(super) length: String,
    /// `kg`, `g` or `lb`
    pub(super) mass: String,
    /// `kg*m2`, `kg*cm2` or `lb*in2`
    pub(super) inertia: String,
    /// `N` or `lbf`
    pub(super) force: String,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
pub(super) struct Point {
    pub(super) x: f64,
    pub(super) y: f64,
}

/// The place and the angle of a body in radians.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
pub(super) struct Pose {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) angle: f64,
}

#[derive(Debug, Deserialize)]
pub(super) struct Body {
    pub(super) id: String,
    #[serde(default)]
    pub(super) label: String,
    pub(super) pose: Pose,
    /// The fixed body has none.
    pub(super) mass: Option<MassSpecification>,
}

#[derive(Debug, Deserialize)]
pub(super) struct MassSpecification {
    pub(super) mass: Choice,
    pub(super) inertia: Choice,
    pub(super) center: Choice,
}

/// A value that is given, or that follows from the shape.
#[derive(Debug, Deserialize)]
pub(super) struct Choice {
    pub(super) mode: String,
    pub(super) value: Option<f64>,
    pub(super) point: Option<Point>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Attachment {
    pub(super) id: String,
    pub(super) body_id: String,
    /// In the axes of the body.
    pub(super) point: Point,
    #[serde(default)]
    pub(super) label: String,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BodyJoint {
    pub(super) id: String,
    #[serde(default)]
    pub(super) label: String,
    pub(super) kind: JointKind,
    pub(super) body_a: String,
    pub(super) body_b: String,
    pub(super) frame_a: JointFrame,
    pub(super) frame_b: JointFrame,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub(super) enum JointKind {
    Revolute,
    Weld,
    /// The second body slides on the first one, and does not turn there.
    Prismatic,
    /// A pin of the second body slides on the first one.
    PinInSlot,
}

/// A point on a body, and the direction of a slot there in the axes of the body.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct JointFrame {
    pub(super) attachment_id: String,
    pub(super) angle: f64,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Coordinate {
    pub(super) joint_id: String,
    pub(super) coordinate: CoordinateKind,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(super) enum CoordinateKind {
    Angle,
    Travel,
}

#[derive(Debug, Deserialize)]
pub(super) struct Driver {
    pub(super) coordinate: Coordinate,
    pub(super) profile: Profile,
}

#[derive(Debug, Deserialize)]
pub(super) struct Profile {
    pub(super) initial: f64,
    pub(super) speed: f64,
}

#[derive(Debug, Deserialize)]
pub(super) struct Limit {
    pub(super) coordinate: Coordinate,
    pub(super) lower: f64,
    pub(super) upper: f64,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Force {
    pub(super) body_id: String,
    pub(super) point: Point,
    #[serde(default)]
    pub(super) label: String,
    /// `world` or `body`
    pub(super) frame: String,
    pub(super) vector: Point,
    #[serde(default)]
    pub(super) couple: f64,
}

/// Welded bodies with properties of their own.
#[derive(Debug, Deserialize)]
pub(super) struct Group {
    pub(super) mass: Option<serde_json::Value>,
}

impl Pose {
    /// Returns the place of a point of the body in the drawing.
    pub(super) fn point(self, point: Point) -> [f64; 2] {
        let [x, y] = self.direction(point);
        [self.x + x, self.y + y]
    }

    /// Returns a vector of the body in the axes of the drawing.
    pub(super) fn direction(self, vector: Point) -> [f64; 2] {
        // A body that is not turned keeps its numbers.
        if self.angle == 0.0 {
            return [vector.x, vector.y];
        }
        let (sin, cos) = self.angle.sin_cos();
        [
            cos * vector.x - sin * vector.y,
            sin * vector.x + cos * vector.y,
        ]
    }
}
