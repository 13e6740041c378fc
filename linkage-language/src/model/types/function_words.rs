//! Words that can be called in expressions: functions everywhere, quantities in the functions of
//! the `impl` block.

use super::value_type::Type;
use crate::syntax::{Word, vocabulary};

vocabulary! {
    /// A function of expressions.
    pub enum Function {
        Polar = "polar",
        Dir = "dir",
        Rotate = "rotate",
        Turn = "turn",
        Dot = "dot",
        Cross = "cross",
        Norm = "norm",
        Distance = "distance",
        Unit = "unit",
        Angle = "angle",
        TriangleAngle = "triangle_angle",
        Sin = "sin",
        Cos = "cos",
        Tan = "tan",
        Asin = "asin",
        Acos = "acos",
        Atan = "atan",
        Atan2 = "atan2",
        Sqrt = "sqrt",
        Hypot = "hypot",
        Abs = "abs",
        Min = "min",
        Max = "max",
        Frame = "frame",
        PointIn = "point_in",
        CoordinatesIn = "coordinates_in",
    }
}

vocabulary! {
    /// Functions that depend on a list of knots or on a word.
    pub enum MotionLawWord {
        Rise = "rise",
        Piecewise = "piecewise",
        Spline = "spline",
        Slope = "slope",
    }
}

vocabulary! {
    /// Quantities of the functions of the `impl` block, besides expressions.
    pub enum QuantityWord {
        Motion(MotionWord),
        Mechanics(MechanicsWord),
    }
}

vocabulary! {
    /// Quantities of the motion.
    pub enum MotionWord {
        Derivative = "d",
        Velocity = "velocity",
        Acceleration = "acceleration",
        Jerk = "jerk",
        Omega = "omega",
        Alpha = "alpha",
        ScrewPoint = "screw_point",
        ScrewDirection = "screw_direction",
        ScrewPitch = "screw_pitch",
        Sensitivity = "sensitivity",
        Margin = "margin",
        Picture = "picture",
    }
}

vocabulary! {
    /// Quantities of forces and masses.
    pub enum MechanicsWord {
        Reaction = "reaction",
        Moment = "moment",
        Torque = "torque",
        Force = "force",
        Power = "power",
        KineticEnergy = "kinetic_energy",
        PotentialEnergy = "potential_energy",
        ShakingForce = "shaking_force",
        ShakingMoment = "shaking_moment",
    }
}

impl Function {
    /// Its arguments as messages show them.
    pub(in crate::model) fn parameters(self) -> &'static [&'static str] {
        match self {
            Function::Polar => &["length", "angle"],
            Function::Dir | Function::Sin | Function::Cos | Function::Tan => &["angle"],
            Function::Rotate => &["vector", "angle"],
            Function::Turn => &["vector", "axis", "angle"],
            Function::Dot
            | Function::Cross
            | Function::Distance
            | Function::Hypot
            | Function::Min
            | Function::Max => &["a", "b"],
            Function::Norm | Function::Unit | Function::Angle => &["vector"],
            Function::TriangleAngle => &["a", "b", "c"],
            Function::Asin | Function::Acos | Function::Atan => &["number"],
            Function::Atan2 => &["y", "x"],
            Function::Sqrt | Function::Abs => &["a"],
            Function::Frame => &["origin", "x", "z"],
            Function::PointIn => &["frame", "vector"],
            Function::CoordinatesIn => &["frame", "point"],
        }
    }

    /// Returns the index of the argument that is an angle.
    pub(in crate::model) fn angle_argument(self) -> Option<usize> {
        match self {
            Function::Dir | Function::Sin | Function::Cos | Function::Tan => Some(0),
            Function::Polar | Function::Rotate => Some(1),
            Function::Turn => Some(2),
            Function::Dot
            | Function::Cross
            | Function::Norm
            | Function::Distance
            | Function::Unit
            | Function::Angle
            | Function::TriangleAngle
            | Function::Asin
            | Function::Acos
            | Function::Atan
            | Function::Atan2
            | Function::Sqrt
            | Function::Hypot
            | Function::Abs
            | Function::Min
            | Function::Max
            | Function::Frame
            | Function::PointIn
            | Function::CoordinatesIn => None,
        }
    }

    /// Returns the arguments that the result has the dimension of, or a power of it.
    pub(in crate::model) fn measured_arguments(self) -> &'static [usize] {
        match self {
            Function::Polar
            | Function::Rotate
            | Function::Turn
            | Function::Norm
            | Function::Sqrt
            | Function::Abs => &[0],
            Function::Dot
            | Function::Cross
            | Function::Distance
            | Function::Hypot
            | Function::Min
            | Function::Max => &[0, 1],
            Function::Dir
            | Function::Unit
            | Function::Angle
            | Function::TriangleAngle
            | Function::Sin
            | Function::Cos
            | Function::Tan
            | Function::Asin
            | Function::Acos
            | Function::Atan
            | Function::Atan2
            | Function::Frame
            | Function::PointIn
            | Function::CoordinatesIn => &[],
        }
    }

    /// Returns true if some argument can be of this type although it has no arithmetic. Other
    /// functions refuse it.
    pub(in crate::model) fn takes(self, ty: &Type) -> bool {
        matches!(self, Function::PointIn | Function::CoordinatesIn) && ty.is_frame()
    }

    /// Returns true if it can be called with this number of arguments.
    pub(in crate::model) fn takes_count(self, count: usize) -> bool {
        // Without the z axis it is a frame of the plane.
        count == self.parameters().len() || (self == Function::Frame && count == 2)
    }
}

impl MotionWord {
    /// Returns the order of the derivative with respect to the inputs of the function.
    pub(in crate::model) fn order(self) -> Option<u8> {
        match self {
            MotionWord::Velocity | MotionWord::Omega => Some(1),
            MotionWord::Acceleration | MotionWord::Alpha => Some(2),
            MotionWord::Jerk => Some(3),
            MotionWord::Derivative
            | MotionWord::ScrewPoint
            | MotionWord::ScrewDirection
            | MotionWord::ScrewPitch
            | MotionWord::Sensitivity
            | MotionWord::Margin
            | MotionWord::Picture => None,
        }
    }

    /// Returns true for a derivative of the first argument.
    pub(in crate::model) fn differentiates(self) -> bool {
        match self {
            MotionWord::Derivative
            | MotionWord::Velocity
            | MotionWord::Acceleration
            | MotionWord::Jerk
            | MotionWord::Omega
            | MotionWord::Alpha
            | MotionWord::ScrewPoint
            | MotionWord::ScrewDirection
            | MotionWord::ScrewPitch
            | MotionWord::Sensitivity => true,
            MotionWord::Margin | MotionWord::Picture => false,
        }
    }

    /// Returns true for a quantity of the rotation of a frame.
    pub(in crate::model) fn turns(self) -> bool {
        matches!(self, MotionWord::Omega | MotionWord::Alpha)
    }

    /// The word for so many derivatives by the inputs, of a frame or of something else.
    pub(in crate::model) fn of_order(order: u8, frame: bool) -> Option<Self> {
        Self::all().find(|word| word.order() == Some(order) && word.turns() == frame)
    }
}

impl MotionLawWord {
    /// Returns the form of a call, for messages.
    pub(in crate::model) fn form(self) -> &'static str {
        match self {
            MotionLawWord::Rise => "rise(x, law)",
            MotionLawWord::Piecewise => {
                "piecewise(x, [(place, value), (place, value, law)])` or `piecewise(x, [...], periodic)"
            }
            MotionLawWord::Spline => "spline(x, [(place, value), (place, value)], ends)",
            MotionLawWord::Slope => "slope(course)",
        }
    }
}

/// Returns true for a word that can be called.
pub(in crate::model) fn is_function(name: &str) -> bool {
    Function::from_word(name).is_some()
        || MotionLawWord::from_word(name).is_some()
        || QuantityWord::from_word(name).is_some()
}
