//! Sums, products, and the dimension that zero takes from its surroundings.

use super::names::Resolver;
use super::plane_and_space::{plane_beside_space, vector_components};
use super::types::{BinaryOp, Dimension, Expr, ExprKind, Name, Type};
use crate::diagnostic::SourceSpan;

impl Type {
    /// The type of a sum of the two; `None` if they cannot be added.
    pub(super) fn common(left: &Type, right: &Type) -> Option<Type> {
        match (left, right) {
            (Type::Array(_) | Type::Frame | Type::PlaneFrame | Type::Error, _)
            | (_, Type::Array(_) | Type::Frame | Type::PlaneFrame | Type::Error) => None,
            (Type::Zero(1), other) | (other, Type::Zero(1)) => Some(other.clone()),
            _ if left.components() != right.components() => None,
            (Type::Zero(_), other) | (other, Type::Zero(_)) => Some(other.clone()),
            _ => {
                let (left_dimension, right_dimension) = (left.dimension()?, right.dimension()?);
                let fits = left_dimension.fits(right_dimension);
                fits.then(|| left.with(left_dimension.or(right_dimension)))
            }
        }
    }
}

impl Expr {
    /// Gives zero the type that its surroundings ask for; a bare `0` beside a vector becomes a vector.
    pub(super) fn settle(&mut self, wanted: &Type) {
        let Type::Zero(count) = self.ty else { return };
        let Some(wanted_count) = wanted.components() else {
            return;
        };
        let component_type = match wanted {
            Type::Vector(_, dimension) => Type::Scalar(*dimension),
            Type::Zero(_) => Type::Zero(1),
            other => other.clone(),
        };
        if count == 1 && wanted_count > 1 {
            let mut component = self.clone();
            component.settle(&component_type);
            self.kind = ExprKind::Vector(vec![component; wanted_count]);
        } else if count != wanted_count {
            return;
        }
        match &mut self.kind {
            ExprKind::Vector(components) => {
                components
                    .iter_mut()
                    .for_each(|component| component.settle(&component_type));
            }
            ExprKind::Negate(value) => value.settle(wanted),
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, left, right) => {
                left.settle(wanted);
                right.settle(wanted);
            }
            // Only what is put together of zeros hands its type on to them.
            _ => {}
        }
        self.ty = wanted.clone();
    }
}

impl Resolver<'_> {
    pub(super) fn negate(&mut self, value: Expr, span: SourceSpan) -> Expr {
        if self.refuse_compound(&value) {
            return self.failed(span);
        }
        let ty = value.ty.clone();
        self.make(ExprKind::Negate(Box::new(value)), ty, span)
    }

    pub(super) fn binary(
        &mut self,
        operator: BinaryOp,
        mut left: Expr,
        mut right: Expr,
        span: SourceSpan,
    ) -> Expr {
        let refused = [self.refuse_compound(&left), self.refuse_compound(&right)].contains(&true);
        if refused || left.ty.is_error() || right.ty.is_error() {
            return self.failed(span);
        }
        let ty = match operator {
            BinaryOp::Add | BinaryOp::Sub => self.sum(operator, &mut left, &mut right, span),
            BinaryOp::Mul => self.product(&mut left, &mut right, span),
            BinaryOp::Div => self.quotient(&mut left, &mut right, span),
        };
        match ty {
            Some(ty) => {
                let kind = ExprKind::Binary(operator, Box::new(left), Box::new(right));
                self.make(kind, ty, span)
            }
            None => self.failed(span),
        }
    }

    fn sum(
        &mut self,
        operator: BinaryOp,
        left: &mut Expr,
        right: &mut Expr,
        span: SourceSpan,
    ) -> Option<Type> {
        if let Some(ty) = Type::common(&left.ty, &right.ty) {
            left.settle(&ty);
            right.settle(&ty);
            return Some(ty);
        }
        self.suspect_both(left, right);
        let (first, second) = self.both_types(left, right);
        let fact = match operator {
            BinaryOp::Sub => format!("cannot subtract {second} from {first}"),
            _ => format!("cannot add {first} and {second}"),
        };
        let help = self.mismatch_help(left, right);
        self.diagnostics.error_with_help(span, fact, help);
        None
    }

    fn product(&mut self, left: &mut Expr, right: &mut Expr, span: SourceSpan) -> Option<Type> {
        settle_alone(left);
        settle_alone(right);
        if let (Type::Vector(left_count, _), Type::Vector(right_count, _)) = (&left.ty, &right.ty) {
            let fact =
                format!("a product of two vectors ({left_count} and {right_count} components)");
            self.diagnostics
                .error_with_help(span, fact, "write `dot(a, b)` or `cross(a, b)`");
            return None;
        }
        let shape = if matches!(left.ty, Type::Vector(..)) {
            &left.ty
        } else {
            &right.ty
        };
        let dimension = left.ty.dimension()?.times(right.ty.dimension()?);
        let dimension = dimension.map(Dimension::of_arithmetic);
        self.in_range(dimension.map(|dimension| shape.with(dimension)), span)
    }

    fn quotient(&mut self, left: &mut Expr, right: &mut Expr, span: SourceSpan) -> Option<Type> {
        settle_alone(left);
        settle_alone(right);
        if matches!(right.ty, Type::Vector(..)) {
            let help = "divide by `norm(v)` or by a component";
            self.diagnostics
                .error_with_help(span, "cannot divide by a vector", help);
            return None;
        }
        let dimension = left.ty.dimension()?.over(right.ty.dimension()?);
        let dimension = dimension.map(Dimension::of_arithmetic);
        self.in_range(dimension.map(|dimension| left.ty.with(dimension)), span)
    }

    pub(super) fn in_range(&mut self, ty: Option<Type>, span: SourceSpan) -> Option<Type> {
        if ty.is_none() {
            let fact = "the power of length is beyond 32 or not a multiple of one half";
            self.diagnostics
                .error_with_help(span, fact, "divide by a length first");
        }
        ty
    }

    /// The type of all together; reports the first that differs from those before it.
    pub(super) fn common_type(&mut self, values: &mut [&mut Expr], what: &str) -> Type {
        let mut ty = Type::Zero(1);
        for index in 0..values.len() {
            if values[index].ty.is_error() || self.refuse_compound(values[index]) {
                return Type::Error;
            }
            match Type::common(&ty, &values[index].ty) {
                Some(common) => ty = common,
                None => {
                    self.suspect(values[index], &ty);
                    for before in &values[..index] {
                        self.suspect(before, &values[index].ty);
                    }
                    let fact = format!("{what} differ in dimension: {ty} and {}", values[index].ty);
                    let help = self.mismatch_help(values[index - 1], values[index]);
                    let span = self.origins.span(values[index].origin);
                    self.diagnostics.error_with_help(span, fact, help);
                    return Type::Error;
                }
            }
        }
        ty
    }

    /// What to do about two values that do not fit.
    pub(super) fn mismatch_help(&self, left: &Expr, right: &Expr) -> String {
        for value in [left, right] {
            let ExprKind::Name(name @ (Name::Parameter(_) | Name::Input(_) | Name::Unknown(_))) =
                &value.kind
            else {
                continue;
            };
            let symbol = self.symbols.iter().find(|symbol| symbol.name == *name);
            if let Some(symbol) = symbol.filter(|symbol| symbol.bare_zero) {
                let unit = self.unit.name();
                return format!("declare `{}` with a unit: `0{unit}` or `0deg`", symbol.text);
            }
        }
        let hidden = [left, right].map(|value| self.hidden_unit(value));
        if let Some(help) = hidden.into_iter().flatten().next() {
            return help;
        }
        if let Some(plane) = plane_beside_space(left, right) {
            return self.lifted(plane);
        }
        let components = [left, right].map(vector_components);
        if components[0] != components[1] {
            let vector = match components.contains(&Some(3)) {
                true => "(x, y, z)",
                false => "(x, y)",
            };
            return format!("write a vector `{vector}` on both sides, or take a component `.x`");
        }
        for value in [left, right] {
            if let ExprKind::Number(number) = value.kind
                && value.ty == Type::NUMBER
            {
                return format!("give the number its unit: `{number}{}`", self.unit.name());
            }
        }
        "both must have the same dimension".to_owned()
    }

    /// Arrays and frames consist of values of different dimensions, so there is no arithmetic with them.
    pub(super) fn refuse_compound(&mut self, value: &Expr) -> bool {
        let help = match &value.ty {
            Type::Array(_) => "take one entry: `[0]`".to_owned(),
            Type::Frame | Type::PlaneFrame => self.parts_help("take", value),
            Type::Scalar(_) | Type::Vector(..) | Type::Zero(_) | Type::Error => return false,
        };
        if !value.ty.is_error() {
            let fact = format!("{} cannot be used in an expression", value.ty);
            let span = self.origins.span(value.origin);
            self.diagnostics.error_with_help(span, fact, help);
        }
        true
    }
}

/// Zero with nothing beside it that would give it a dimension.
pub(super) fn settle_alone(value: &mut Expr) {
    let ty = value.ty.settled();
    value.settle(&ty);
}
