//! Programs as JavaScript.

use linkage_symbolic::program::{Language, Program, Source, print};

/// A program as a function of an assembly, inputs and states of groups without a closed form, which
/// writes its results to `out`.
pub(crate) fn function(program: &Program, inputs: usize) -> String {
    let mut script = Script {
        inputs,
        values: Vec::new(),
    };
    let results = print(program, &mut script);
    let values = script.values;
    let constants = match values.is_empty() {
        true => String::new(),
        false => format!("const {};", values.join(", ")),
    };
    let results = results.iter().enumerate();
    let results: String = results
        .map(|(index, value)| format!(" out[{index}] = {value};"))
        .collect();
    format!(
        "(own, x, states, out) => {{ const d = own.dimensions, p = own.prepared; {constants}{results} }}"
    )
}

/// A program while it is printed.
struct Script {
    /// The number of inputs of the mechanism.
    inputs: usize,
    /// Definitions of values, in order.
    values: Vec<String>,
}

impl Language for Script {
    fn number(&self, x: f64) -> String {
        literal(x)
    }

    fn load(&mut self, index: usize, source: Source) -> String {
        let value = source_expression(source, self.inputs);
        self.define(index, &value)
    }

    fn define(&mut self, index: usize, value: &str) -> String {
        self.values.push(format!("v{index} = {value}"));
        format!("v{index}")
    }

    fn define_sine_pair(&mut self, index: usize, angle: &str) -> [String; 2] {
        // The engine keeps the cosine until the next sine is computed.
        let sine = self.define(index, &format!("sine({angle}), w{index} = beside"));
        [sine, format!("w{index}")]
    }

    fn call(&mut self, name: &'static str, operands: &[&str]) -> String {
        format!("{}({})", function_of(name), operands.join(", "))
    }

    fn sine_or_cosine(&mut self, number: usize, angle: &str) -> String {
        format!("{}({angle})", ["sine", "cosine"][number])
    }
}

/// Returns the expression of a number that a program loads.
fn source_expression(source: Source, inputs: usize) -> String {
    match source {
        Source::Parameter(index) => format!("d[{index}]"),
        Source::Input(index) => format!("x[{index}]"),
        Source::Mode(index) => format!("own.modes[{index}]"),
        Source::Centre(angle) => format!("own.centres[{angle}]"),
        Source::Winding(angle, input) => format!("own.windings[{}]", angle * inputs + input),
        Source::Prepared(slot) => format!("p[{slot}]"),
        Source::State(group, component) => format!("states[{group}][{component}]"),
        Source::Limit => "CORRECTION_LIMIT".to_owned(),
        Source::Carried(_) => unreachable!("whole programs carry nothing"),
    }
}

/// Operations whose function does not have their own name in JavaScript, by the names of their
/// rows.
const FUNCTIONS: [(&str, &str); 10] = [
    ("abs", "Math.abs"),
    ("sqrt", "Math.sqrt"),
    ("tan", "tangent"),
    ("asin", "Math.asin"),
    ("acos", "Math.acos"),
    ("atan", "Math.atan"),
    ("sign", "signOf"),
    ("atan2", "angleOf"),
    ("min", "Math.min"),
    ("max", "Math.max"),
];

/// The function of JavaScript for an operation: by default that of its name, `inverseScale` for
/// `inverse_scale`.
pub(crate) fn function_of(name: &str) -> String {
    if let Some((_, function)) = FUNCTIONS.iter().find(|(operation, _)| *operation == name) {
        return (*function).to_owned();
    }
    let mut parts = name.split('_');
    let mut function = String::from(parts.next().unwrap_or_default());
    for part in parts {
        let (first, rest) = part.split_at(1);
        function += &first.to_uppercase();
        function += rest;
    }
    function
}

/// The number with the fewest digits that JavaScript reads back to the last bit; `-` in front of it
/// is never behind another one.
pub(crate) fn literal(x: f64) -> String {
    match x {
        x if x.is_nan() => "NaN".to_owned(),
        x if x.is_infinite() => format!("({}Infinity)", if x < 0.0 { "-" } else { "" }),
        x if x.is_sign_negative() => format!("({x:?})"),
        x => format!("{x:?}"),
    }
}

#[cfg(all(test, feature = "module"))]
mod tests {
    use super::*;
    use crate::engine::engine;
    use linkage_symbolic::program::{Binary, RustCall, Ternary, Unary};

    /// JavaScript has the function of each operation, or the engine defines it.
    #[test]
    fn operations_have_functions() {
        let engine = engine();
        let unary = Unary::ALL.iter().map(|op| (op.row().name, op.row().call));
        let binary = Binary::ALL.iter().map(|op| (op.row().name, op.row().call));
        let ternary = Ternary::ALL.iter().map(|op| (op.row().name, op.row().call));
        for (name, call) in unary.chain(binary).chain(ternary) {
            if let RustCall::Method(_) | RustCall::FusedMethod(_) = call {
                let function = function_of(name);
                let is_defined = engine.contains(&format!("function {function}("));
                assert!(
                    function.starts_with("Math.") || is_defined,
                    "the engine does not define {function} for {name}"
                );
            }
        }
    }
}
