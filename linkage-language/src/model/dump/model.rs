//! The model as text, for golden files.

use std::fmt::{self, Display, Formatter, Write};

use super::expressions::{Show, separated};
use super::mechanics::write_mechanics;
use crate::model::types::{Mechanism, Type};

/// Prints one line for each item and quantity: every operation in parentheses, numbers in the
/// mechanism's unit and radians.
pub fn dump(mechanism: &Mechanism) -> String {
    let mut text = String::new();
    write_items(&mut text, mechanism)
        .and_then(|()| write_functions(&mut text, mechanism))
        .expect("a String takes everything");
    text
}

fn write_items(out: &mut String, mechanism: &Mechanism) -> fmt::Result {
    let show = |expr| Show { expr, mechanism };
    writeln!(
        out,
        "mechanism {}, lengths in {}",
        mechanism.name,
        mechanism.unit.name()
    )?;
    for item in &mechanism.constants {
        writeln!(
            out,
            "const {} = {}: {}",
            item.name,
            show(&item.value),
            item.value.ty
        )?;
    }
    for item in &mechanism.parameters {
        write!(out, "param {} = {}", item.name, show(&item.nominal))?;
        for tolerance in &item.tolerances {
            match tolerance {
                Some(tolerance) => write!(out, " +- {}", show(tolerance))?,
                None => write!(out, " +- none")?,
            }
        }
        writeln!(out, ": {}", item.ty)?;
    }
    for item in &mechanism.inputs {
        write!(out, "input {} = {}", item.name, show(&item.reference))?;
        if let Some((low, high)) = &item.range {
            write!(out, " in {}..{}", show(low), show(high))?;
        }
        for rate in [item.speed, item.acceleration].into_iter().flatten() {
            write!(out, " at {}", mechanism.arguments[rate].name)?;
        }
        writeln!(out, ": {}", item.dimension)?;
    }
    for item in &mechanism.arguments {
        write!(out, "argument {}", item.name)?;
        if let Some(reference) = &item.reference {
            write!(out, " = {}", show(reference))?;
        }
        writeln!(out, ": {}", item.dimension)?;
    }
    for item in &mechanism.unknowns {
        write!(out, "unknown {}", item.name)?;
        if let Some(estimate) = &item.estimate {
            write!(out, " = {}", show(estimate))?;
        }
        writeln!(out, ": {}", item.ty)?;
    }
    for item in &mechanism.lets {
        writeln!(
            out,
            "let {} = {}: {}",
            item.name,
            show(&item.value),
            item.value.ty
        )?;
    }
    for item in &mechanism.loops {
        writeln!(
            out,
            "loop {} = {}: {}",
            show(&item.left),
            show(&item.right),
            item.left.ty
        )?;
    }
    for item in &mechanism.redundant {
        let (left, right) = (show(&item.left), show(&item.right));
        writeln!(out, "redundant loop {left} = {right}: {}", item.left.ty)?;
    }
    write_mechanics(out, mechanism)?;
    for arc in &mechanism.arcs {
        let [slider, centre] = [&arc.slider, &arc.centre].map(show);
        let (name, direction) = (&arc.name, show(&arc.direction));
        writeln!(
            out,
            "arc {name}: {slider} around {centre}, direction {direction}"
        )?;
    }
    Ok(())
}

fn write_functions(out: &mut String, mechanism: &Mechanism) -> fmt::Result {
    for function in &mechanism.evaluators {
        let inputs = function
            .inputs
            .iter()
            .map(|input| mechanism.input_name(*input));
        let inputs: Vec<&str> = inputs.collect();
        writeln!(
            out,
            "fn {}({}) -> {}",
            function.name,
            inputs.join(", "),
            function.result
        )?;
        for quantity in &function.quantities {
            let value = Show {
                expr: &quantity.value,
                mechanism,
            };
            writeln!(
                out,
                "  {}: {value}: {}",
                quantity.field,
                Full(&quantity.value.ty)
            )?;
        }
    }
    Ok(())
}

/// A type with the types of an array's entries.
struct Full<'a>(&'a Type);

impl Display for Full<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Type::Array(entries) = self.0 else {
            return write!(f, "{}", self.0);
        };
        separated(f, "[", entries.iter().map(Full), "]")
    }
}
