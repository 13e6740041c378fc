//! Speeds and accelerations of the values that inputs of a part are given.

use super::slopes::{of_both, slopes};
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::part_scopes::Unfollowed;
use crate::model::symbols::values::Values;
use crate::model::types::{BinaryOp, Dimension, Expr, ExprKind, Let, MotionLaw, Name, Type};

/// The derivative with respect to time; `None` for a value at rest.
type Rate = Result<Option<Expr>, Unfollowed>;

/// Returns the speed and the acceleration of a value. `lets` has all derived quantities before it.
pub(in crate::model) fn speed_and_acceleration(
    values: &Values,
    value: &Expr,
    lets: &[Let],
) -> [Result<Expr, Unfollowed>; 2] {
    let still = |value: &Expr, order: i32| Expr {
        kind: ExprKind::Number(0.0),
        ty: changing(&value.ty, order),
        origin: value.origin,
    };
    let speed = time_derivative(values, value, lets);
    let acceleration = speed.clone().and_then(|speed| match speed {
        Some(speed) => time_derivative(values, &speed, lets),
        None => Ok(None),
    });
    let or_still = |rate: Rate, order| rate.map(|rate| rate.unwrap_or(still(value, order)));
    [or_still(speed, 1), or_still(acceleration, 2)]
}

/// Returns the second half of a help for a speed or an acceleration of a part that does not follow.
pub(in crate::model) fn unfollowed_help(names: &Names, why: Unfollowed) -> String {
    match why {
        Unfollowed::OfInput(input) => {
            let symbol = names.symbol(Name::Input(input));
            let input = symbol.map_or("", |symbol| symbol.text.as_str());
            format!("; or give `{input}` one: `input {input} = ... at speed, acceleration`")
        }
        Unfollowed::Other => "; it follows from the input given where that is made of inputs and parameters by sums, products, \
             quotients, laws, splines and functions of numbers like `sin`, which is a limit of linkage"
            .to_owned(),
    }
}

fn time_derivative(values: &Values, value: &Expr, lets: &[Let]) -> Rate {
    let made = |kind| Expr {
        kind,
        ty: changing(&value.ty, 1),
        origin: value.origin,
    };
    let joined = |op, a, b| made(ExprKind::Binary(op, Box::new(a), Box::new(b)));
    let kind = match &value.kind {
        ExprKind::Number(_) | ExprKind::Name(Name::Const(_) | Name::Parameter(_) | Name::Pi) => {
            return Ok(None);
        }
        ExprKind::Name(Name::Input(input)) => {
            let [speed, _] = values.rates[*input];
            ExprKind::Name(Name::Argument(speed.ok_or(Unfollowed::OfInput(*input))?))
        }
        // Nothing that moves depends on arguments but these.
        ExprKind::Name(Name::Argument(speed)) => {
            let mut inputs = values.rates.iter();
            let input = inputs.position(|rates| rates[0] == Some(*speed));
            let input = input.ok_or(Unfollowed::Other)?;
            let [_, acceleration] = values.rates[input];
            ExprKind::Name(Name::Argument(
                acceleration.ok_or(Unfollowed::OfInput(input))?,
            ))
        }
        ExprKind::Name(Name::Let(index)) => {
            return time_derivative(values, &lets[*index].value, lets);
        }
        ExprKind::Negate(a) => match time_derivative(values, a, lets)? {
            Some(a) => ExprKind::Negate(Box::new(a)),
            None => return Ok(None),
        },
        ExprKind::Binary(op, a, b) => {
            let rates = [
                time_derivative(values, a, lets)?,
                time_derivative(values, b, lets)?,
            ];
            let [a, b] = [a, b].map(|operand| operand.as_ref().clone());
            return Ok(match (op, rates) {
                (_, [None, None]) => None,
                (BinaryOp::Add, [None, Some(rate)]) => Some(rate),
                (BinaryOp::Add | BinaryOp::Sub, [Some(rate), None]) => Some(rate),
                (BinaryOp::Sub, [None, Some(rate)]) => Some(made(ExprKind::Negate(Box::new(rate)))),
                (BinaryOp::Add | BinaryOp::Sub, [Some(first), Some(second)]) => {
                    Some(joined(*op, first, second))
                }
                (BinaryOp::Mul, [first, second]) => {
                    let first = first.map(|rate| joined(BinaryOp::Mul, rate, b));
                    let second = second.map(|rate| joined(BinaryOp::Mul, a, rate));
                    summed(first, second, &|a, b| joined(BinaryOp::Add, a, b))
                }
                // (a' - (a / b) b') / b
                (BinaryOp::Div, [first, second]) => {
                    let second = second.map(|rate| {
                        let taken = joined(BinaryOp::Mul, value.clone(), rate);
                        Expr {
                            ty: changing(&a.ty, 1),
                            ..made(ExprKind::Negate(Box::new(taken)))
                        }
                    });
                    let above = summed(first, second, &|first, second| Expr {
                        ty: changing(&a.ty, 1),
                        ..joined(BinaryOp::Add, first, second)
                    });
                    above.map(|above| joined(BinaryOp::Div, above, b))
                }
            });
        }
        // A value made of parameters alone, like `sqrt(2)`, is at rest.
        _ if is_still(value, lets) => return Ok(None),
        ExprKind::MotionLaw(course) => {
            let slope = slope_of_motion_law(course, value, lets).ok_or(Unfollowed::Other)?;
            return by_chain_rule(values, slope, &course.argument, lets);
        }
        ExprKind::Call(function, arguments) => {
            let slopes = slopes(*function, arguments, value).ok_or(Unfollowed::Other)?;
            let mut rate = None;
            for (slope, argument) in slopes.into_iter().zip(arguments) {
                let share = by_chain_rule(values, slope, argument, lets)?;
                rate = summed(rate, share, &|a, b| joined(BinaryOp::Add, a, b));
            }
            return Ok(rate);
        }
        _ => return Err(Unfollowed::Other),
    };
    Ok(Some(made(kind)))
}

/// Returns the rate of a function from its slope and the rate of its argument.
fn by_chain_rule(values: &Values, slope: Expr, argument: &Expr, lets: &[Let]) -> Rate {
    let rate = time_derivative(values, argument, lets)?;
    Ok(rate.map(|rate| of_both(BinaryOp::Mul, slope, rate)))
}

/// Returns the slope of a course whose knots are at rest.
fn slope_of_motion_law(course: &MotionLaw, value: &Expr, lets: &[Let]) -> Option<Expr> {
    let mut knots = course.operands().into_iter().skip(1);
    let slope = course
        .slope()
        .filter(|_| knots.all(|value| is_still(value, lets)))?;
    let by = course.argument_type().dimension()?;
    let dimension = value.ty.dimension()?.over(by)?;
    Some(Expr {
        kind: ExprKind::MotionLaw(slope),
        ty: Type::Scalar(dimension),
        origin: value.origin,
    })
}

fn is_still(value: &Expr, lets: &[Let]) -> bool {
    let mut names = value.parts().filter_map(Expr::as_name);
    names.all(|name| match name {
        Name::Const(_) | Name::Parameter(_) | Name::Pi => true,
        Name::Let(index) => is_still(&lets[index].value, lets),
        Name::Input(_) | Name::Unknown(_) | Name::Argument(_) => false,
    })
}

fn summed(
    first: Option<Expr>,
    second: Option<Expr>,
    joined: &dyn Fn(Expr, Expr) -> Expr,
) -> Option<Expr> {
    match (first, second) {
        (Some(first), Some(second)) => Some(joined(first, second)),
        (first, second) => first.or(second),
    }
}

/// Returns the type of a derivative of this order with respect to time.
fn changing(ty: &Type, order: i32) -> Type {
    let rate = |dimension: Dimension| Type::Scalar(dimension.rate(order));
    ty.dimension().map_or_else(|| ty.clone(), rate)
}
