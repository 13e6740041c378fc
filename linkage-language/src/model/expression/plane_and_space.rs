//! Messages about vectors of the plane where vectors of space are meant, and vice versa.

use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{COMPONENTS, Expr, ExprKind, Function, Name, Type};
use crate::syntax::Word;

/// Returns the vector of the plane among two, if the other one is a vector of space.
pub(in crate::model) fn plane_beside_space<'e>(
    left: &'e Expr,
    right: &'e Expr,
) -> Option<&'e Expr> {
    match (vector_components(left)?, vector_components(right)?) {
        (2, 3) => Some(left),
        (3, 2) => Some(right),
        _ => None,
    }
}

/// Number of components of a vector, zeros included.
pub(in crate::model) fn vector_components(value: &Expr) -> Option<usize> {
    value.ty.components().filter(|&count| count > 1)
}

/// The type of a value, with its name if it has one: `` `pivot` (a plane vector of lengths) ``.
fn type_with_name(names: &Names, value: &Expr) -> String {
    match name_as_written(names, value) {
        Some(text) => format!("`{text}` ({})", value.ty),
        None => value.ty.to_string(),
    }
}

/// Returns both types as text, with names if a plane vector meets a space vector.
pub(in crate::model) fn both_types(names: &Names, left: &Expr, right: &Expr) -> (String, String) {
    match plane_beside_space(left, right) {
        Some(_) => (type_with_name(names, left), type_with_name(names, right)),
        None => (left.ty.to_string(), right.ty.to_string()),
    }
}

/// Returns a help with the text of a plane vector in space.
pub(in crate::model) fn lifting_help(names: &Names, plane: &Expr) -> String {
    let text = |value: &Expr, otherwise: &str| {
        name_as_written(names, value).unwrap_or_else(|| otherwise.to_owned())
    };
    match &plane.kind {
        ExprKind::Name(name) => {
            let written = text(plane, "p");
            let declared = match name {
                Name::Let(_) => String::new(),
                _ => format!(", or declare `{written}` as `(x, y, z)`"),
            };
            format!("write `({written}.x, {written}.y, 0)`{declared}")
        }
        ExprKind::Vector(components) => {
            let [x, y] = [(0, "x"), (1, "y")].map(|(k, axis)| text(&components[k], axis));
            format!("give it a third component: `({x}, {y}, 0)`")
        }
        ExprKind::Negate(value) => lifting_help(names, value),
        ExprKind::Call(Function::Polar, arguments) => format!(
            "`polar` makes plane vectors; in space write `turn(({}, 0, 0), (0, 0, 1), {})`",
            text(&arguments[0], "length"),
            text(&arguments[1], "angle"),
        ),
        ExprKind::Call(Function::Dir, arguments) => format!(
            "`dir` makes plane vectors; in space write `turn((1, 0, 0), (0, 0, 1), {})`",
            text(&arguments[0], "angle"),
        ),
        ExprKind::Call(Function::Rotate, arguments) => {
            let (v, angle) = (text(&arguments[0], "v"), text(&arguments[1], "angle"));
            format!(
                "`rotate` turns plane vectors; in space write `turn(({v}.x, {v}.y, 0), (0, 0, 1), {angle})`"
            )
        }
        _ => "name the plane vector, `let p = ...;`, and write `(p.x, p.y, 0)`".to_owned(),
    }
}

/// A value as its user wrote it, if that is a name or a component of one.
fn name_as_written(names: &Names, value: &Expr) -> Option<String> {
    match &value.kind {
        ExprKind::Name(Name::Pi) => Some("PI".to_owned()),
        ExprKind::Name(name) => {
            let symbol = names.symbol(*name)?;
            Some(symbol.text.clone())
        }
        ExprKind::Component(vector, index) => {
            let vector = name_as_written(names, vector)?;
            Some(format!("{vector}.{}", COMPONENTS[*index]))
        }
        ExprKind::Number(0.0) => Some("0".to_owned()),
        _ => None,
    }
}

/// Reports arguments of which one is a vector of the plane, the other one of space.
pub(in crate::model) fn check_one_space(
    names: &Names,
    sink: &mut Sink,
    function: Function,
    left: &Expr,
    right: &Expr,
) -> Option<()> {
    let Some(plane) = plane_beside_space(left, right) else {
        return Some(());
    };
    let (first, second) = both_types(names, left, right);
    let fact = format!(
        "the arguments of `{}` differ: {first} and {second}",
        function.word()
    );
    let help = lifting_help(names, plane);
    let span = sink.span(plane.origin);
    sink.error_with_help(span, fact, help);
    None
}

/// Returns a help for a function that takes another kind of vector.
pub(in crate::model) fn vector_help(
    names: &Names,
    function: Function,
    found: &Expr,
    wanted: Option<usize>,
) -> String {
    let count = vector_components(found);
    let help = match (function, wanted, count) {
        (Function::Rotate, _, Some(3)) => "`turn(v, axis, angle)` turns space vectors",
        (Function::Angle, _, Some(3)) => {
            "the angle between two directions in space is `atan2(norm(cross(a, b)), dot(a, b))`"
        }
        (Function::Turn, _, Some(2)) if !matches!(found.kind, ExprKind::Vector(_)) => {
            return format!(
                "{}; `rotate(v, angle)` turns plane vectors",
                lifting_help(names, found)
            );
        }
        (_, Some(3), Some(2)) => return lifting_help(names, found),
        (_, Some(2), _) => "write it as `(x, y)`",
        (_, Some(_), _) => "write it as `(x, y, z)`",
        (_, None, _) => "write it as `(x, y)` or `(x, y, z)`",
    };
    help.to_owned()
}

/// Returns a help for a vector within the parentheses of a vector.
pub(in crate::model) fn nested_help(names: &Names, components: &[Expr]) -> String {
    if let [vector, third] = components
        && vector_components(vector) == Some(2)
        && matches!(third.ty, Type::Scalar(_) | Type::Zero(1))
        && let (Some(v), Some(z)) = (
            name_as_written(names, vector),
            name_as_written(names, third),
        )
    {
        return format!("write `({v}.x, {v}.y, {z})`");
    }
    "take a component of it: `.x`".to_owned()
}
