//! Signatures of a function of the user.

use linkage_export::FunctionDeclaration;

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
        let sweep = sweep.map(|name| Declared {
            signature: format!(
                "void {name}(const {prefix} *m, size_t count{arrays}, {result} *results)"
            ),
            name: name.clone(),
        });
        Self {
            declared: Declared {
                signature: format!("{result} {name}(const {prefix} *m{numbers})"),
                name: name.clone(),
            },
            result: result.clone(),
            sweep,
        }
    }
}
