//! Signatures of a function of the user.

use linkage_export::FunctionDeclaration;

use super::constant::{API, constant};
use super::declared::Declared;
use crate::real::Real;

/// A function of the user in C.
#[derive(Debug)]
pub(crate) struct Evaluator {
    pub(crate) declared: Declared,
    /// The type of its results.
    pub(crate) result: String,
    pub(crate) sweep: Option<Declared>,
}

impl Evaluator {
    /// A function of the mechanism whose struct is called `prefix`.
    pub(super) fn new(prefix: &str, function: &FunctionDeclaration, real: Real) -> Self {
        let (result, sweep, name) = match &function.items[..] {
            [result, sweep, name] => (result, Some(sweep), name),
            [result, name] => (result, None, name),
            _ => unreachable!("a function has a result and a name"),
        };
        let arguments = function.arguments.iter();
        let numbers: String = arguments
            .clone()
            .map(|argument| format!(", {}", argument.declaration))
            .collect();
        let number = real.name();
        let arrays: String = arguments
            .map(|argument| format!(", const {number} *{}", argument.name))
            .collect();
        let api = constant(prefix, API);
        let parameters = format!("const {prefix} *m, size_t count{arrays}, {result} *results");
        let sweep = sweep.map(|name| Declared::new(&api, "void", name, &parameters));
        let parameters = format!("const {prefix} *m{numbers}");
        Self {
            declared: Declared::new(&api, result, name, &parameters),
            result: result.clone(),
            sweep,
        }
    }
}
