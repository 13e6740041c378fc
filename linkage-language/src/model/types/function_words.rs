//! Words that can be called in expressions: functions everywhere, quantities in the functions of
//! the `impl` block.

use super::value_type::Type;
use crate::syntax::{Word, vocabulary};

vocabulary! {
    /// A function of expressions.
    pub enum Function {
        /// The plane vector of a length at an angle from the x axis.
        Polar = "polar",
        /// The unit vector at an angle from the x axis.
        Dir = "dir",
        /// A plane vector turned by an angle.
        Rotate = "rotate",
        /// A space vector turned about an axis through the origin, right-handed.
        Turn = "turn",
        /// The scalar product of two vectors.
        Dot = "dot",
        /// The cross product of two vectors: a scalar in the plane, a vector in space.
        Cross = "cross",
        /// The length of a vector.
        Norm = "norm",
        /// The distance of two points.
        Distance = "distance",
        /// The vector divided by its length.
        Unit = "unit",
        /// The angle of a plane vector from the x axis, from -180 to 180 degrees.
        Angle = "angle",
        /// The angle between the sides `a` and `b` of a triangle, opposite to `c`.
        TriangleAngle = "triangle_angle",
        /// The sine of an angle.
        Sin = "sin",
        /// The cosine of an angle.
        Cos = "cos",
        /// The tangent of an angle.
        Tan = "tan",
        /// The angle of this sine, from -90 to 90 degrees.
        Asin = "asin",
        /// The angle of this cosine, from 0 to 180 degrees.
        Acos = "acos",
        /// The angle of this tangent, from -90 to 90 degrees.
        Atan = "atan",
        /// The angle of the vector `(x, y)` from the x axis, from -180 to 180 degrees.
        Atan2 = "atan2",
        /// The square root; it halves the power of length.
        Sqrt = "sqrt",
        /// The square root of `a * a + b * b`.
        Hypot = "hypot",
        /// The absolute value.
        Abs = "abs",
        /// The smaller value.
        Min = "min",
        /// The larger value.
        Max = "max",
        /// A frame that moves with a body: origin and x axis in the plane, in space the plane of x and z, too.
        Frame = "frame",
        /// The fixed coordinates of a point that is given in a frame.
        PointIn = "point_in",
        /// The coordinates of a fixed point in a frame.
        CoordinatesIn = "coordinates_in",
    }
}

vocabulary! {
    /// Functions that depend on a list of knots or on a word.
    pub enum MotionLawWord {
        /// Goes from 0 to 1 while `x` does, by a law of motion.
        Rise = "rise",
        /// A course from knot to knot, each piece by a law of motion.
        Piecewise = "piecewise",
        /// A smooth course through points.
        Spline = "spline",
        /// The derivative of a course with respect to its `x`.
        Slope = "slope",
    }
}

vocabulary! {
    /// All words in front of parentheses.
    pub enum CalledWord {
        Function(Function),
        Law(MotionLawWord),
        Quantity(QuantityWord),
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
        /// The partial derivative with respect to inputs or parameters.
        Derivative = "d",
        /// The derivative with respect to the input of the function; with several inputs an array.
        Velocity = "velocity",
        /// The second derivative with respect to the input of the function.
        Acceleration = "acceleration",
        /// The third derivative with respect to the input of the function.
        Jerk = "jerk",
        /// The angular velocity of a frame with respect to the input.
        Omega = "omega",
        /// The angular acceleration of a frame with respect to the input.
        Alpha = "alpha",
        /// A point of the screw axis about which a frame turns.
        ScrewPoint = "screw_point",
        /// The direction of the screw axis about which a frame turns.
        ScrewDirection = "screw_direction",
        /// The shift of a frame along its screw axis for each radian.
        ScrewPitch = "screw_pitch",
        /// The derivatives with respect to the scalar parameters, all or those of a list.
        Sensitivity = "sensitivity",
        /// The distance of the nearest group from a dead point, from 0 to 1.
        Margin = "margin",
        /// The points of all links, for drawings.
        Picture = "picture",
    }
}

vocabulary! {
    /// Quantities of forces and masses.
    pub enum MechanicsWord {
        /// The force on the body of a joint from the body that it is attached to.
        Reaction = "reaction",
        /// The moment on the body of a joint about the joint's point.
        Moment = "moment",
        /// The torque of the drive at an input that is an angle.
        Torque = "torque",
        /// The force of the drive at an input that is a length.
        Force = "force",
        /// The power of all drives.
        Power = "power",
        /// The kinetic energy of all bodies.
        KineticEnergy = "kinetic_energy",
        /// The energy of gravity and springs.
        PotentialEnergy = "potential_energy",
        /// The sum of the inertia forces on the frame.
        ShakingForce = "shaking_force",
        /// The moment of the inertia forces about a fixed point, by default the origin.
        ShakingMoment = "shaking_moment",
        /// The reduced inertia of an input; of two inputs an entry of the mass matrix; of none the whole.
        Inertia = "inertia",
        /// The drive of an input for velocities and weights, at zero acceleration and without loads.
        Bias = "bias",
        /// The power that friction turns into heat.
        FrictionPower = "friction_power",
        /// The ratio of useful power to spent power; not positive where friction locks.
        Efficiency = "efficiency",
        /// The work of forces, torques, springs, dampers and friction per motion of an input.
        GeneralisedForce = "generalised_force",
        /// The acceleration of an input if no drive acts, only the declared loads.
        DrivenAcceleration = "driven_acceleration",
    }
}

impl Function {
    /// Its arguments as messages show them.
    pub fn parameters(self) -> &'static [&'static str] {
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
    pub fn form(self) -> &'static str {
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
