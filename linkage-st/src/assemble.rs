//! The function block that prepares the numbers of the functions and closes the loops.

use std::fmt::Write;

use linkage_export::{Declarations, RefusalCause};

use crate::blocks::{Writer, block, comment, path};
use crate::program::literal;

/// Squares of larger numbers overflow.
const LARGEST: f64 = 1e154;

/// Returns the block that closes the loops at the reference inputs.
pub(crate) fn assemble(writer: &mut Writer) -> String {
    let Declarations {
        unit,
        items,
        name,
        reference,
        ..
    } = writer.declarations;
    let mut statements = format!("    code := 0;\n    m.miss := {};\n", literal(0.0));
    let prepare = writer.program(&unit.prepare, &|_| String::new());
    statements += &prepare.statements;
    for (slot, value) in prepare.results.iter().enumerate() {
        let _ = writeln!(statements, "    m.prepared[{slot}] := {value};");
    }
    // The variables of the program above are used again.
    let gaps = writer.program(&unit.gaps, &|input| literal(unit.inputs[input].reference));
    statements += &gaps.statements;
    let (codes, branches) = refusals(writer, &gaps.results);
    if !branches.is_empty() {
        let _ = writeln!(
            statements,
            "    IF {}    END_IF;",
            branches.join("    ELSIF ")
        );
    }
    let about = format!(
        "Closes the loops at the reference inputs ({reference}), and computes the numbers that depend on the dimensions alone. \
         code is 0, or:{codes}"
    );
    let variables = [prepare.variables, gaps.variables].concat();
    comment(&about) + &block([&items[0], name], "", "code : INT", variables, &statements)
}

/// Returns the meanings of all codes, and the conditions for them with their statements; `gaps` are
/// the expressions of closing errors.
fn refusals(writer: &Writer, gaps: &[String]) -> (String, Vec<String>) {
    let Declarations {
        unit,
        scalars,
        refusals,
        ..
    } = writer.declarations;
    let any = |condition: &dyn Fn(usize, String) -> String| {
        let paths = scalars
            .iter()
            .map(|scalar| format!("m.{}", path(scalar)))
            .enumerate();
        let all: Vec<String> = paths.map(|(index, path)| condition(index, path)).collect();
        if all.is_empty() {
            "FALSE".to_owned()
        } else {
            all.join(" OR ")
        }
    };
    let too_large = any(&|_, path| format!("ABS({path}) > {}", literal(LARGEST)));
    let of_size = refusals
        .iter()
        .position(|refusal| refusal.cause == RefusalCause::TooLarge);
    let (mut codes, mut branches, mut others) = (String::new(), Vec::new(), Vec::new());
    for (number, refusal) in (1..).zip(refusals) {
        let mut about = &refusal.text;
        let of_angle;
        match refusal.cause {
            RefusalCause::NotFinite(index) => {
                let (path, most) = (path(&scalars[index]), literal(f64::MAX));
                branches.push(format!(
                    "NOT (ABS(m.{path}) <= {most}) THEN\n        code := {number};\n"
                ));
            }
            RefusalCause::CannotClose(group) => {
                let (gap, zero) = (&gaps[group], literal(0.0));
                branches.push(format!(
                    "{gap} > {zero} THEN\n        code := {number};\n        m.miss := {gap};\n"
                ));
            }
            RefusalCause::Undefined(group) => {
                let (gap, size) = (&gaps[group], of_size.map_or(number, |index| index + 1));
                branches.push(format!(
                    "{gap} <> {gap} THEN\n        code := SEL({too_large}, {number}, {size});\n"
                ));
            }
            RefusalCause::NoTurns(angle) => {
                let angle = &unit.unknowns[unit.angles[angle].unknown].name;
                of_angle = format!(
                    "the turns of {angle} are counted for the declared dimensions, and these are others"
                );
                about = &of_angle;
                others.push(number);
            }
            RefusalCause::TooLarge | RefusalCause::TooFar(_) => {}
        }
        let _ = write!(codes, "\n{number}: {about}.");
    }
    if let Some(number) = others.first() {
        let nominal = &writer.assembly.dimensions;
        let are_others = any(&|index, path| format!("{path} <> {}", literal(nominal[index])));
        branches.push(format!("{are_others} THEN\n        code := {number};\n"));
    }
    (codes, branches)
}
