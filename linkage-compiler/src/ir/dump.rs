//! A unit as text.

use std::fmt::Write;

use super::CompiledMechanism;

/// All programs, as golden files show them.
pub fn dump(unit: &CompiledMechanism) -> String {
    let mut text = format!("prepare\n{}\ngaps\n{}", unit.prepare, unit.gaps);
    let _ = write!(text, "\nsurvey\n{}", unit.survey);
    if !unit.angles.is_empty() {
        let _ = write!(text, "\nangles\n{}", unit.directions);
    }
    if !unit.bearings.outputs.is_empty() {
        let _ = write!(text, "\nbearings\n{}", unit.bearings);
        for angle in &unit.angles {
            let turns = angle.phases.iter().map(|phase| &phase.turns);
            let turns: Vec<_> = turns.collect();
            let _ = writeln!(text, "{}: {turns:?}", unit.unknowns[angle.unknown].name);
        }
    }
    for (number, group) in unit.coupled.iter().enumerate() {
        if !group.followed {
            let _ = write!(text, "\nterms of coupled group {number}\n");
        }
        for (equation, exponents) in &group.terms {
            let _ = writeln!(text, "equation {equation}: {exponents:?}");
        }
        let start = match group.followed {
            true => ("estimate", &group.estimate),
            false => ("coefficients", &group.system),
        };
        let of_followed = [("residuals", &group.residuals), ("missed", &group.missed)];
        let of_followed = of_followed.into_iter().filter(|_| group.followed);
        let programs = [
            start,
            ("correction", &group.correct),
            ("unknowns", &group.placed),
        ];
        for (what, program) in programs.into_iter().chain(of_followed) {
            let _ = write!(text, "\n{what} of coupled group {number}\n{program}");
        }
    }
    for function in &unit.functions {
        let name = &function.name;
        let fields = function.fields.iter();
        let fields: Vec<String> = fields
            .map(|f| format!("{}: {:?} {}", f.name, f.shape, f.unit))
            .collect();
        let program = &function.called.program;
        let _ = write!(text, "\n{name} ({})\n{program}", fields.join(", "));
        if let Some(beside) = &function.beside {
            let program = &beside.program;
            let _ = write!(
                text,
                "\n{name}, for what the table does not know\n{program}"
            );
        }
        if let Some(settled) = &function.settled {
            let program = &settled.program;
            let _ = write!(text, "\n{name}, where a follower stands\n{program}");
        }
    }
    if let Some(picture) = &unit.picture {
        let _ = write!(text, "\npicture\n{picture}");
    }
    text
}
