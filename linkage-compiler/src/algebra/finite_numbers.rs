//! Are the numbers of the mechanism numbers? Defaults such as `1 / zero`, tolerances such as `1um -
//! 2um`.

use crate::algebra::nominal::Nominal;
use crate::diagnostic::Reporter;
use crate::model::{Expr, Mechanism};

const NOT_FINITE: &str =
    "look for a division by zero, or a root or an arc function out of its range";

impl Nominal {
    /// Reports values that are not finite and tolerances below zero.
    pub(crate) fn check(&self, mechanism: &Mechanism, reporter: &mut Reporter) {
        let mut finite = |expr: &Expr, what: &str, name: &str, values: &[f64]| {
            if values.iter().any(|x| !x.is_finite()) {
                reporter.error_with_help(
                    expr.origin,
                    format!("the {what} of `{name}` is not a finite number"),
                    NOT_FINITE,
                );
            }
        };
        let mut negative = Vec::new();
        for parameter in &mechanism.parameters {
            let first = parameter.first_scalar.0;
            let name = &parameter.name;
            let defaults = &self.parameters[first..first + parameter.tolerances.len()];
            finite(&parameter.nominal, "value", name, defaults);
            for (tolerance, value) in parameter.tolerances.iter().zip(&self.tolerances[first..]) {
                let Some(tolerance) = tolerance else { continue };
                finite(tolerance, "tolerance", name, &[*value]);
                if *value < 0.0 {
                    negative.push((tolerance.origin, name));
                }
            }
        }
        for (k, input) in mechanism.inputs.iter().enumerate() {
            finite(
                &input.reference,
                "reference value",
                &input.name,
                &self.inputs[k..=k],
            );
            if let (Some((low, high)), Some((a, b))) = (&input.range, self.ranges[k]) {
                finite(low, "lower end of the range", &input.name, &[a]);
                finite(high, "upper end of the range", &input.name, &[b]);
            }
        }
        for (unknown, estimate) in mechanism.unknowns.iter().zip(&self.estimates) {
            if let Some(written) = &unknown.estimate {
                finite(written, "estimate", &unknown.name, estimate);
            }
        }
        for (argument, value) in mechanism.arguments.iter().zip(&self.arguments) {
            if let (Some(declared), Some(value)) = (&argument.reference, value)
                && !value.is_finite()
            {
                // No error: calls of the macro give the value, and only the command needs it.
                reporter.warning_with_help(
                    declared.origin,
                    format!("the value of `{}` is not a finite number", argument.name),
                    NOT_FINITE,
                );
            }
        }
        for (origin, name) in negative {
            reporter.error_with_help(
                origin,
                format!("the tolerance of `{name}` is negative"),
                "write how far the value may lie above or below its nominal value",
            );
        }
    }
}
