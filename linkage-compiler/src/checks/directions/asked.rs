//! The directions that a mechanism needs: axes of `turn` and of `frame`, arguments of `unit`,
//! guides and axes of joints.

use crate::model::{Expr, ExprKind, Function, Joint, Mechanism};

/// A vector that must not be zero.
pub(super) struct Asked<'m> {
    /// The name in messages.
    pub(super) subject: &'static str,
    pub(super) vector: &'m Expr,
    /// Another one that must not be parallel to it.
    pub(super) beside: Option<&'m Expr>,
    /// True for a direction in a loop, or in a derived quantity that a loop is written with.
    pub(super) in_loop: bool,
}

/// All of them, in the order of the source for each kind of item.
pub(super) fn asked_for(mechanism: &Mechanism) -> Vec<Asked<'_>> {
    let mut asked = Vec::new();
    let mut collect = |expr, in_loop| collect(expr, in_loop, &mut asked);
    let loops: Vec<usize> = (0..mechanism.loops.len()).collect();
    let in_loops = mechanism.usage(&loops).lets;
    mechanism
        .constants
        .iter()
        .for_each(|c| collect(&c.value, false));
    for parameter in &mechanism.parameters {
        collect(&parameter.nominal, false);
        let tolerances = parameter.tolerances.iter().flatten();
        tolerances.for_each(|tolerance| collect(tolerance, false));
    }
    for input in &mechanism.inputs {
        collect(&input.reference, false);
        if let Some((low, high)) = &input.range {
            collect(low, false);
            collect(high, false);
        }
    }
    mechanism
        .unknowns
        .iter()
        .filter_map(|unknown| unknown.estimate.as_ref())
        .for_each(|estimate| collect(estimate, false));
    for (item, in_loop) in mechanism.lets.iter().zip(in_loops) {
        collect(&item.value, in_loop);
    }
    for item in mechanism.loops.iter().chain(&mechanism.redundant) {
        collect(&item.left, true);
        collect(&item.right, true);
    }
    mechanism
        .expressions_of_mechanics()
        .into_iter()
        .for_each(|expr| collect(expr, false));
    let quantities = mechanism.evaluators.iter().flat_map(|e| &e.quantities);
    quantities.for_each(|quantity| collect(&quantity.value, false));
    asked.extend(mechanism.joints.iter().filter_map(of_joint));
    asked
}

/// The guide or axis of a joint.
fn of_joint(joint: &Joint) -> Option<Asked<'_>> {
    Some(Asked {
        subject: joint.kind.direction_name(),
        vector: joint.direction.as_ref()?,
        beside: None,
        in_loop: false,
    })
}

fn collect<'m>(expr: &'m Expr, in_loop: bool, asked: &mut Vec<Asked<'m>>) {
    if let ExprKind::Call(function, arguments) = &expr.kind {
        let argument = |subject, index: usize, beside: Option<usize>| Asked {
            subject,
            vector: &arguments[index],
            beside: beside.map(|index| &arguments[index]),
            in_loop,
        };
        let all = match function {
            Function::Turn => vec![argument("the axis of `turn`", 1, None)],
            Function::Unit => vec![argument("the vector of `unit`", 0, None)],
            Function::Frame => match arguments.len() {
                // An unknown one of the plane has an angle.
                2 if arguments[1].ty.components() == Some(1) => Vec::new(),
                2 => vec![argument("the x axis of `frame`", 1, None)],
                _ => vec![
                    argument("the x axis of `frame`", 1, None),
                    argument("the z axis of `frame`", 2, Some(1)),
                ],
            },
            _ => Vec::new(),
        };
        asked.extend(all.into_iter().filter(|item| {
            let vectors = std::iter::once(item.vector).chain(item.beside);
            !vectors.into_iter().any(is_of_functions)
        }));
    }
    expr.operands()
        .into_iter()
        .for_each(|operand| collect(operand, in_loop, asked));
}

/// Quantities of functions are known at run time only.
fn is_of_functions(expr: &Expr) -> bool {
    expr.is_quantity() || expr.operands().into_iter().any(is_of_functions)
}
