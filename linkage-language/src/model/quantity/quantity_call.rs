//! Quantities of functions: one of the motion, or one of forces and masses.

use proc_macro2::Ident;

use super::derivative::{
    resolve_derivative, resolve_input_derivative, resolve_margin, resolve_sensitivity,
};
use super::forces::resolve_mechanics_quantity;
use super::picture_links::refuse_inner_picture;
use super::screw::resolve_screw;
use crate::diagnostic::SourceSpan;
use crate::model::expression::nodes::error_expr;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Site;
use crate::model::types::{Expr, MotionWord, QuantityWord};
use crate::syntax::{self, Word};

pub(in crate::model) fn resolve_quantity(
    operands: Operands,
    sink: &mut Sink,
    word: QuantityWord,
    ident: &Ident,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    let Site::Function(inputs) = operands.context.site else {
        let name = word.word();
        let fact = format!("`{name}` is only known in the functions of the `impl` block");
        let help = "move it there, as a quantity of a function";
        sink.error_with_help(ident.into(), fact, help);
        return error_expr(sink, span);
    };
    let word = match word {
        QuantityWord::Motion(word) => word,
        QuantityWord::Mechanics(word) => {
            return resolve_mechanics_quantity(operands, sink, word, arguments, span);
        }
    };
    match word {
        MotionWord::Margin => resolve_margin(sink, arguments, span),
        MotionWord::Picture => refuse_inner_picture(sink, span),
        MotionWord::Derivative => resolve_derivative(operands, sink, arguments, span),
        MotionWord::Sensitivity => resolve_sensitivity(operands, sink, arguments, span),
        MotionWord::Velocity
        | MotionWord::Acceleration
        | MotionWord::Jerk
        | MotionWord::Omega
        | MotionWord::Alpha => {
            resolve_input_derivative(operands, sink, word, inputs, arguments, span)
        }
        MotionWord::ScrewPoint | MotionWord::ScrewDirection | MotionWord::ScrewPitch => {
            resolve_screw(operands, sink, word, inputs, arguments, span)
        }
    }
}
