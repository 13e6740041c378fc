//! Expressions as text, for golden files.

use std::fmt::{self, Display, Formatter};

use crate::model::types::{
    BinaryOp, COMPONENTS, Expr, ExprKind, FRAME_PARTS, Knot, MechanicalQuantity, Mechanism,
    MotionLaw, MotionLawKind, MotionWord, PLANE_PARTS, Pieces, Repeats, Type, Variable,
};
use crate::syntax::Word;

pub(in crate::model) struct Show<'a> {
    pub(in crate::model) expr: &'a Expr,
    pub(in crate::model) mechanism: &'a Mechanism,
}

impl<'a> Show<'a> {
    pub(in crate::model) fn inner(&self, expr: &'a Expr) -> Show<'a> {
        Show {
            expr,
            mechanism: self.mechanism,
        }
    }

    fn variable(&self, variable: Variable) -> &str {
        match variable {
            Variable::Input(index) => &self.mechanism.inputs[index].name,
            Variable::Parameter(scalar) => &self.mechanism.scalar_parameters[scalar.0].name,
        }
    }

    fn course(&self, f: &mut Formatter, course: &'a MotionLaw) -> fmt::Result {
        let knot = |knot: &'a Knot| {
            let (abscissa, value) = (self.inner(&knot.abscissa), self.inner(&knot.value));
            let slope = knot.slope.as_ref();
            let slope = slope.map_or(String::new(), |slope| format!(", {}", self.inner(slope)));
            let law = knot
                .law
                .map_or(String::new(), |law| format!(", {}", law.word()));
            let jump = if knot.may_jump { ", jump" } else { "" };
            format!("({abscissa}, {value}{slope}{law}{jump})")
        };
        let name = match course.kind {
            MotionLawKind::Rise | MotionLawKind::Laws => "piecewise",
            MotionLawKind::Spline(ends, _) => ends.word(),
        };
        let quintic = match course.kind {
            MotionLawKind::Spline(_, Pieces::Quintic) => " quintic",
            MotionLawKind::Rise
            | MotionLawKind::Laws
            | MotionLawKind::Spline(_, Pieces::Cubic | Pieces::QuinticBySlopes) => "",
        };
        let slope = "slope of ".repeat(usize::from(course.order));
        let repeats = match course.repeats {
            Repeats::Never => "",
            Repeats::EachTurn => " each turn",
            Repeats::FromLastToFirst => " again and again",
        };
        write!(f, "{slope}{name}({}, ", self.inner(&course.argument))?;
        separated(f, "[", course.knots.iter().map(knot), "]")?;
        write!(f, "{repeats}{quintic})")
    }

    fn quantity(&self, f: &mut Formatter, quantity: &MechanicalQuantity) -> fmt::Result {
        let mechanism = self.mechanism;
        let input = |input: usize| mechanism.inputs[input].name.as_str();
        match quantity {
            MechanicalQuantity::Reaction(joint) => {
                write!(f, "reaction({})", joint_name(mechanism, *joint))
            }
            MechanicalQuantity::Moment(joint) => {
                write!(f, "moment({})", joint_name(mechanism, *joint))
            }
            MechanicalQuantity::Drive(of) => {
                write!(f, "drive({})", input(*of))
            }
            MechanicalQuantity::Power => f.write_str("power()"),
            MechanicalQuantity::FrictionPower => f.write_str("friction_power()"),
            MechanicalQuantity::Efficiency => f.write_str("efficiency()"),
            MechanicalQuantity::KineticEnergy => f.write_str("kinetic_energy()"),
            MechanicalQuantity::PotentialEnergy => f.write_str("potential_energy()"),
            MechanicalQuantity::ShakingForce => f.write_str("shaking_force()"),
            MechanicalQuantity::ShakingMoment(point) => {
                f.write_str("shaking_moment")?;
                let point = point.iter().map(|point| self.inner(point));
                separated(f, "(", point, ")")
            }
            MechanicalQuantity::Inertia([a, b]) => {
                write!(f, "inertia({}, {})", input(*a), input(*b))
            }
            MechanicalQuantity::MassMatrix(inputs) => {
                let inputs = inputs.iter().map(|of| input(*of));
                separated(f, "mass_matrix(", inputs, ")")
            }
            MechanicalQuantity::Bias(of) => write!(f, "bias({})", input(*of)),
            MechanicalQuantity::GeneralisedForce(of) => {
                write!(f, "generalised_force({})", input(*of))
            }
            MechanicalQuantity::DrivenAcceleration(of) => {
                write!(f, "driven_acceleration({})", input(*of))
            }
        }
    }
}

impl Display for Show<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match &self.expr.kind {
            ExprKind::Number(value) => write!(f, "{value:?}"),
            ExprKind::Name(name) => f.write_str(self.mechanism.name(*name)),
            ExprKind::Vector(components) => separated(
                f,
                "(",
                components.iter().map(|value| self.inner(value)),
                ")",
            ),
            ExprKind::Component(value, index) => {
                write!(f, "{}.{}", self.inner(value), COMPONENTS[*index])
            }
            ExprKind::Index(value, index) if value.ty.is_frame() => {
                let parts = match value.ty {
                    Type::PlaneFrame => PLANE_PARTS,
                    _ => FRAME_PARTS,
                };
                write!(f, "{}.{}", self.inner(value), parts[*index])
            }
            ExprKind::Index(value, index) => write!(f, "{}[{index}]", self.inner(value)),
            ExprKind::Negate(value) => write!(f, "(-{})", self.inner(value)),
            ExprKind::Binary(operator, left, right) => {
                let sign = match operator {
                    BinaryOp::Add => '+',
                    BinaryOp::Sub => '-',
                    BinaryOp::Mul => '*',
                    BinaryOp::Div => '/',
                };
                write!(f, "({} {sign} {})", self.inner(left), self.inner(right))
            }
            ExprKind::Call(function, arguments) => {
                f.write_str(function.word())?;
                separated(f, "(", arguments.iter().map(|value| self.inner(value)), ")")
            }
            ExprKind::MotionLaw(course) => self.course(f, course),
            ExprKind::Derivative(value, variables) => {
                write!(f, "d({}, ", self.inner(value))?;
                separated(
                    f,
                    "",
                    variables.iter().map(|variable| self.variable(*variable)),
                    ")",
                )
            }
            ExprKind::InputDerivative(value, order) => {
                let word = MotionWord::of_order(*order, value.ty == Type::Frame);
                let word = word.map_or("", MotionWord::word);
                write!(f, "{word}({})", self.inner(value))
            }
            ExprKind::Sensitivity(value, parameters) => {
                write!(f, "sensitivity({}, ", self.inner(value))?;
                let names = parameters.iter().map(|scalar| Variable::Parameter(*scalar));
                separated(f, "[", names.map(|variable| self.variable(variable)), "])")
            }
            ExprKind::Mechanics(quantity) => self.quantity(f, quantity),
            ExprKind::Margin => f.write_str("margin()"),
            ExprKind::Picture(links) => {
                let link = |link: &Vec<Expr>| {
                    let points: Vec<String> =
                        link.iter().map(|p| self.inner(p).to_string()).collect();
                    format!("[{}]", points.join(", "))
                };
                separated(f, "picture(", links.iter().map(link), ")")
            }
            ExprKind::Error => f.write_str("<error>"),
        }
    }
}

pub(in crate::model) fn separated<T: Display>(
    f: &mut Formatter,
    open: &str,
    entries: impl Iterator<Item = T>,
    close: &str,
) -> fmt::Result {
    f.write_str(open)?;
    for (index, entry) in entries.enumerate() {
        let separator = if index == 0 { "" } else { ", " };
        write!(f, "{separator}{entry}")?;
    }
    f.write_str(close)
}

pub(in crate::model) fn joint_name(mechanism: &Mechanism, joint: usize) -> &str {
    let name = mechanism.joints[joint].name.as_deref();
    name.unwrap_or_default()
}
