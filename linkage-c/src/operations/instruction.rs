//! Programs as C.

use linkage_export::Helpers;
use linkage_symbolic::program::{Language, Program, Source, print};

use crate::real::Real;

/// Operations that are functions of C's library, by the names of their rows.
const LIBRARY: [(&str, &str); 2] = [("abs", "fabs"), ("sqrt", "sqrt")];

/// State of printing the programs of a mechanism.
#[derive(Debug)]
pub(crate) struct Printer<'a> {
    pub(crate) real: Real,
    /// The beginning of names that nothing else has.
    pub(crate) private: &'a str,
    pub(crate) helpers: Helpers<'static>,
}

/// A program in C: statements, and expressions of its results.
#[derive(Debug)]
pub(crate) struct Printed {
    pub(crate) statements: String,
    pub(crate) results: Vec<String>,
}

impl Printer<'_> {
    /// Prints a program; `load` returns the expressions of numbers that it loads.
    pub(crate) fn program(
        &mut self,
        program: &Program,
        load: &dyn Fn(Source) -> String,
    ) -> Printed {
        let mut c = C {
            printer: self,
            load,
            statements: String::new(),
        };
        let results = print(program, &mut c);
        Printed {
            statements: c.statements,
            results,
        }
    }

    /// A call of a helper.
    fn call_helper(&mut self, helper: &str, operands: &[&str]) -> String {
        self.helpers.need(helper);
        format!("{}{helper}({})", self.private, operands.join(", "))
    }
}

/// A program while it is printed.
struct C<'p, 'a> {
    printer: &'p mut Printer<'a>,
    load: &'p dyn Fn(Source) -> String,
    statements: String,
}

impl Language for C<'_, '_> {
    fn number(&self, x: f64) -> String {
        self.printer.real.literal(x)
    }

    fn load(&mut self, _index: usize, source: Source) -> String {
        (self.load)(source)
    }

    fn define(&mut self, index: usize, value: &str) -> String {
        let real = self.printer.real.name();
        self.statements += &format!("    const {real} v{index} = {value};\n");
        format!("v{index}")
    }

    fn define_sine_pair(&mut self, index: usize, angle: &str) -> [String; 2] {
        let pair = self.printer.call_helper("sin_cos", &[angle]);
        let private = self.printer.private;
        self.statements += &format!("    const {private}pair v{index} = {pair};\n");
        [format!("v{index}.sine"), format!("v{index}.cosine")]
    }

    fn call(&mut self, name: &'static str, operands: &[&str]) -> String {
        match LIBRARY.iter().find(|(operation, _)| *operation == name) {
            Some((_, function)) => {
                // Most processors have an instruction for it.
                let suffix = match self.printer.real {
                    Real::Double | Real::Fused => "",
                    Real::Single => "f",
                };
                format!("{function}{suffix}({})", operands.join(", "))
            }
            None => self.printer.call_helper(name, operands),
        }
    }

    fn sine_or_cosine(&mut self, number: usize, angle: &str) -> String {
        let member = [".sine", ".cosine"][number];
        self.printer.call_helper("sin_cos", &[angle]) + member
    }
}

#[cfg(test)]
mod tests {
    use super::super::helpers;
    use super::*;
    use linkage_symbolic::program::{Binary, RustCall, Ternary, Unary};

    /// C has a function of its library or a helper for each operation.
    #[test]
    fn operations_have_functions() {
        for real in [Real::Double, Real::Fused, Real::Single] {
            let mut printer = Printer {
                real,
                private: "own_",
                helpers: helpers(real),
            };
            let mut c = C {
                printer: &mut printer,
                load: &|_| String::new(),
                statements: String::new(),
            };
            let unary = Unary::ALL.iter().map(|op| (op.row().name, op.row().call));
            let binary = Binary::ALL.iter().map(|op| (op.row().name, op.row().call));
            let ternary = Ternary::ALL.iter().map(|op| (op.row().name, op.row().call));
            for (name, call) in unary.chain(binary).chain(ternary) {
                if let RustCall::Method(_) | RustCall::FusedMethod(_) = call {
                    assert!(c.call(name, &["a"]).ends_with("(a)"));
                }
            }
        }
    }
}
