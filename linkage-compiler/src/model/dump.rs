//! The model as text, for golden files.

use std::fmt::{self, Display, Formatter, Write};

use super::functions::MotionWord;
use super::mechanics::write_mechanics;
use super::types::{
    BinaryOp, Course, CourseKind, Expr, ExprKind, Knot, Mechanism, Pieces, Repeats, Type, Variable,
};
use crate::syntax::Word;

/// One line for each item and quantity; every operation in parentheses, numbers in the mechanism's unit and radians.
pub(crate) fn dump(mechanism: &Mechanism) -> String {
    let mut text = String::new();
    write_items(&mut text, mechanism)
        .and_then(|()| write_functions(&mut text, mechanism))
        .expect("a String takes everything");
    text
}

fn write_items(out: &mut String, mechanism: &Mechanism) -> fmt::Result {
    let show = |expr| Show { expr, mechanism };
    writeln!(
        out,
        "mechanism {}, lengths in {}",
        mechanism.name,
        mechanism.unit.name()
    )?;
    for item in &mechanism.constants {
        writeln!(
            out,
            "const {} = {}: {}",
            item.name,
            show(&item.value),
            item.value.ty
        )?;
    }
    for item in &mechanism.parameters {
        write!(out, "param {} = {}", item.name, show(&item.nominal))?;
        for tolerance in &item.tolerances {
            match tolerance {
                Some(tolerance) => write!(out, " +- {}", show(tolerance))?,
                None => write!(out, " +- none")?,
            }
        }
        writeln!(out, ": {}", item.ty)?;
    }
    for item in &mechanism.inputs {
        write!(out, "input {} = {}", item.name, show(&item.reference))?;
        if let Some((low, high)) = &item.range {
            write!(out, " in {}..{}", show(low), show(high))?;
        }
        for rate in [item.speed, item.acceleration].into_iter().flatten() {
            write!(out, " at {}", mechanism.arguments[rate].name)?;
        }
        writeln!(out, ": {}", item.dimension)?;
    }
    for item in &mechanism.arguments {
        write!(out, "argument {}", item.name)?;
        if let Some(reference) = &item.reference {
            write!(out, " = {}", show(reference))?;
        }
        writeln!(out, ": {}", item.dimension)?;
    }
    for item in &mechanism.unknowns {
        write!(out, "unknown {}", item.name)?;
        if let Some(estimate) = &item.estimate {
            write!(out, " = {}", show(estimate))?;
        }
        writeln!(out, ": {}", item.ty)?;
    }
    for item in &mechanism.lets {
        writeln!(
            out,
            "let {} = {}: {}",
            item.name,
            show(&item.value),
            item.value.ty
        )?;
    }
    for item in &mechanism.loops {
        writeln!(
            out,
            "loop {} = {}: {}",
            show(&item.left),
            show(&item.right),
            item.left.ty
        )?;
    }
    for item in &mechanism.redundant {
        let (left, right) = (show(&item.left), show(&item.right));
        writeln!(out, "redundant loop {left} = {right}: {}", item.left.ty)?;
    }
    write_mechanics(out, mechanism)
}

fn write_functions(out: &mut String, mechanism: &Mechanism) -> fmt::Result {
    for function in &mechanism.evaluators {
        let inputs = function
            .inputs
            .iter()
            .map(|input| mechanism.input_name(*input));
        let inputs: Vec<&str> = inputs.collect();
        writeln!(
            out,
            "fn {}({}) -> {}",
            function.name,
            inputs.join(", "),
            function.result
        )?;
        for quantity in &function.quantities {
            let value = Show {
                expr: &quantity.value,
                mechanism,
            };
            writeln!(
                out,
                "  {}: {value}: {}",
                quantity.field,
                Full(&quantity.value.ty)
            )?;
        }
    }
    Ok(())
}

/// A type with the types of an array's entries.
struct Full<'a>(&'a Type);

impl Display for Full<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Type::Array(entries) = self.0 else {
            return write!(f, "{}", self.0);
        };
        separated(f, "[", entries.iter().map(Full), "]")
    }
}

pub(super) struct Show<'a> {
    pub(super) expr: &'a Expr,
    pub(super) mechanism: &'a Mechanism,
}

impl<'a> Show<'a> {
    pub(super) fn inner(&self, expr: &'a Expr) -> Show<'a> {
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
                write!(
                    f,
                    "{}.{}",
                    self.inner(value),
                    super::components::COMPONENTS[*index]
                )
            }
            ExprKind::Index(value, index) if value.ty.is_frame() => {
                let parts = match value.ty {
                    Type::PlaneFrame => super::frame_parts::PLANE_PARTS,
                    _ => super::frame_parts::PARTS,
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
            ExprKind::Course(course) => self.course(f, course),
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

pub(super) fn separated<T: Display>(
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

impl<'a> Show<'a> {
    fn course(&self, f: &mut Formatter, course: &'a Course) -> fmt::Result {
        let knot = |own: &'a Knot| {
            let (place, value) = (self.inner(&own.place), self.inner(&own.value));
            let slope = own.slope.as_ref();
            let slope = slope.map_or(String::new(), |own| format!(", {}", self.inner(own)));
            let law = own
                .law
                .map_or(String::new(), |law| format!(", {}", law.word()));
            let jump = if own.may_jump { ", jump" } else { "" };
            format!("({place}, {value}{slope}{law}{jump})")
        };
        let name = match course.kind {
            CourseKind::Rise | CourseKind::Laws => "piecewise",
            CourseKind::Spline(ends, _) => ends.word(),
        };
        let quintic = match course.kind {
            CourseKind::Spline(_, Pieces::Quintic) => " quintic",
            CourseKind::Rise
            | CourseKind::Laws
            | CourseKind::Spline(_, Pieces::Cubic | Pieces::QuinticBySlopes) => "",
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
}
