//! Programs as statements of structured text.

use linkage_export::Helpers;
use linkage_symbolic::program::{Instruction, Language, Program, Source, print};

/// A program as statements, with the names of its variables and the expressions of its results.
pub(crate) struct Printed {
    pub(crate) variables: Vec<String>,
    pub(crate) statements: String,
    pub(crate) results: Vec<String>,
}

/// Prints a program; `load` returns the expressions of numbers that it loads.
pub(crate) fn printed(
    program: &Program,
    helpers: &mut Helpers,
    private: &str,
    load: &dyn Fn(Source) -> String,
) -> Printed {
    let mut instructions = program.instructions.iter();
    if instructions.any(|item| matches!(item, Instruction::Constant(x) if !x.is_finite())) {
        helpers.need("nan");
    }
    let mut printer = Printer {
        helpers,
        private,
        load,
        variables: Vec::new(),
        statements: String::new(),
    };
    let results = print(program, &mut printer);
    Printed {
        variables: printer.variables,
        statements: printer.statements,
        results,
    }
}

/// Returns a finite number with the fewest digits that are read back to the last bit.
pub(crate) fn literal(x: f64) -> String {
    let digits = format!("{:?}", x.abs()).replace('e', "E");
    let digits = match digits.split_once('E') {
        // An exponent follows a point.
        Some((whole, exponent)) if !whole.contains('.') => format!("{whole}.0E{exponent}"),
        _ => digits,
    };
    match x.is_sign_negative() {
        true => format!("(-LREAL#{digits})"),
        false => format!("LREAL#{digits}"),
    }
}

/// A program while it is printed.
struct Printer<'p, 'l> {
    helpers: &'p mut Helpers<'l>,
    /// The beginning of names that nothing else has.
    private: &'p str,
    load: &'p dyn Fn(Source) -> String,
    variables: Vec<String>,
    statements: String,
}

impl Language for Printer<'_, '_> {
    fn number(&self, x: f64) -> String {
        // A number that is not finite has no literal.
        let call = |name| format!("{}{name}({})", self.private, literal(1e300));
        match x {
            x if x.is_nan() => call("nan"),
            x if x == f64::INFINITY => call("infinity"),
            x if x == f64::NEG_INFINITY => format!("(-{})", call("infinity")),
            x => literal(x),
        }
    }

    fn load(&mut self, _index: usize, source: Source) -> String {
        (self.load)(source)
    }

    fn define(&mut self, index: usize, value: &str) -> String {
        self.assign(format!("v{index}"), value)
    }

    fn define_sine_pair(&mut self, index: usize, angle: &str) -> [String; 2] {
        [('v', 0), ('c', 1)].map(|(letter, number)| {
            let value = self.sine_or_cosine(number, angle);
            self.assign(format!("{letter}{index}"), &value)
        })
    }

    fn call(&mut self, name: &'static str, operands: &[&str]) -> String {
        let operands = operands.join(", ");
        match name {
            "abs" | "sqrt" | "tan" | "asin" | "acos" | "atan" => {
                format!("{}({operands})", name.to_uppercase())
            }
            _ => {
                self.helpers.need(name);
                format!("{}{name}({operands})", self.private)
            }
        }
    }

    fn sine_or_cosine(&mut self, number: usize, angle: &str) -> String {
        self.call("turned", &[angle, &literal(number as f64)])
    }
}

impl Printer<'_, '_> {
    /// Adds a variable and the statement that gives it its value. Returns its name.
    fn assign(&mut self, name: String, value: &str) -> String {
        self.statements += &format!("    {name} := {value};\n");
        self.variables.push(name.clone());
        name
    }
}
