//! Compares programs with the reference.

use crate::errors::{compare_derivatives, compare_margin, compare_positions, must_be_nan};
use crate::gap::{Standing, standing};
use crate::report::Program;
use crate::{Answers, Big, Reference, Report, System, solve};

/// A program at one geometry: input in, answers out.
pub type Evaluate = Box<dyn Fn(f64) -> Answers>;

/// How to compute a form.
#[derive(Clone, Copy, Debug)]
pub struct Variant {
    /// With fused multiply-adds; else as this build does.
    pub fused: bool,
    /// In the other assembly mode.
    pub flipped: bool,
}

/// One written form of the mechanism.
#[derive(Clone, Copy)]
pub struct Form {
    /// Its name in the report.
    pub name: &'static str,
    /// Assembles it for a geometry (all data but the input); the error as text.
    pub assemble: fn(&[f64], Variant) -> Result<Evaluate, String>,
    /// Whether the form can be used for a geometry: `distance(a, b) = l` wants `l` to be positive.
    pub fits: fn(&[f64]) -> bool,
}

/// A geometry and the inputs to look at.
#[derive(Clone, Debug)]
pub struct Case {
    /// All data but the input.
    pub geometry: Vec<f64>,
    /// The inputs.
    pub inputs: Vec<f64>,
    /// Whether to look at the other assembly mode.
    pub flipped: bool,
}

impl Case {
    /// A case in the assembly mode that the estimates choose.
    pub fn new(geometry: Vec<f64>, inputs: Vec<f64>) -> Self {
        Self {
            geometry,
            inputs,
            flipped: false,
        }
    }

    /// The case in the other assembly mode.
    #[must_use]
    pub fn flipped(self) -> Self {
        Self {
            flipped: true,
            ..self
        }
    }
}

/// What to compare, which the reference's time depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// Values and first derivatives; of every third position second derivatives and sensitivities.
    Usual,
    /// Everything that a program is asked for.
    Full,
}

/// Compares all forms with the reference in all cases.
pub fn compare(system: &System, forms: &[Form], cases: &[Case], depth: Depth) -> Report {
    let mut report = Report::of(system.name);
    let mode = default_mode(system);
    for case in cases {
        let mode = if case.flipped { -mode } else { mode };
        let programs = assemble(system, forms, case, &mut report);
        for &input in &case.inputs {
            if !programs.is_empty() {
                let data: Vec<f64> = case.geometry.iter().copied().chain([input]).collect();
                compare_position(system, &programs, &data, (mode, depth), &mut report);
            }
        }
    }
    report
}

/// Tests of one mechanism in its written forms, a row for each: name, title in the report, cases, depth, accepted errors, and how many
/// positions must be compared at least.
///
/// `SYSTEM, FORMS; NAME "TITLE": CASES(FROM, GEOMETRIES, SEED), DEPTH, LIMITS, at least COUNT;`
#[macro_export]
macro_rules! sets {
    ($system:ident, $forms:ident; $(
        $(#[$doc:meta])*
        $name:ident $title:literal:
            $cases:ident($from:expr, $geometries:literal, $seed:literal), $depth:ident, $limits:expr
            $(, at least $least:literal)?;
    )*) => {$(
        $(#[$doc])*
        #[test]
        fn $name() {
            let cases = $crate::$cases(&$system, $from, $geometries, $seed);
            $crate::compare(&$system, $forms, &cases, $crate::Depth::$depth)
                $(.at_least($least))?
                .check($title, &$limits);
        }
    )*};
}

fn assemble(
    system: &System,
    forms: &[Form],
    case: &Case,
    report: &mut Report,
) -> Vec<(Program, Evaluate)> {
    let geometry = &case.geometry;
    let data: Vec<f64> = geometry
        .iter()
        .copied()
        .chain([system.reference_input()])
        .collect();
    let standing = standing(system, &data);
    let mut programs = Vec::new();
    for form in forms.iter().filter(|form| (form.fits)(geometry)) {
        for fused in [false, true] {
            let program = Program {
                form: form.name,
                fused,
            };
            let variant = Variant {
                fused,
                flipped: case.flipped,
            };
            match ((form.assemble)(geometry, variant), &standing) {
                (Ok(_), Standing::Apart) => report
                    .fail(|| format!("{program}: assembled although it cannot be: {geometry:?}")),
                (Ok(evaluate), _) => programs.push((program, evaluate)),
                (Err(why), Standing::Closed) => {
                    report.fail(|| format!("{program}: not assembled: {why}: {geometry:?}"));
                }
                (Err(_), _) => {}
            }
        }
    }
    programs
}

/// The sign of the determinant in the assembly mode that the estimates choose.
pub(crate) fn default_mode(system: &System) -> f64 {
    let input = system.reference_input();
    let data: Vec<f64> = system
        .default_geometry()
        .into_iter()
        .chain([input])
        .collect();
    let data: Vec<Big> = data.into_iter().map(Big::from).collect();
    let estimates: Vec<f64> = system
        .unknowns
        .iter()
        .map(|unknown| unknown.estimate)
        .collect();
    let solution = solve(system, &data, &estimates).expect("the mechanism as written assembles");
    solution.determinant.to_f64().signum()
}

fn compare_position(
    system: &System,
    programs: &[(Program, Evaluate)],
    data: &[f64],
    (mode, depth): (f64, Depth),
    report: &mut Report,
) {
    let input = data[system.input()];
    let answers: Vec<(Program, Answers)> = programs
        .iter()
        .map(|(program, evaluate)| (*program, evaluate(input)))
        .collect();
    match standing(system, data) {
        Standing::DeadPoint => {
            report.undecided += 1;
            return;
        }
        Standing::Apart => {
            report.apart += 1;
            return must_be_nan(&answers, data, report);
        }
        Standing::Closed => report.positions += 1,
    }
    let finite = answers
        .iter()
        .find(|(_, a)| a.values.iter().all(|x| x.is_finite()));
    let Some((_, start)) = finite else {
        return report.fail(|| format!("{}: NaN although assembled: {data:?}", system.name));
    };
    let Some(mut reference) = Reference::new(system, data, &start.values) else {
        return report.fail(|| format!("no solution near {:?}: {data:?}", start.values));
    };
    if !system.linear && reference.determinant() * mode <= 0.0 {
        return report.fail(|| format!("wrong assembly mode: {:?}: {data:?}", start.values));
    }
    compare_positions(system, &mut reference, &answers, data, report);
    compare_margin(&reference, &answers, data, report);
    compare_derivatives(system, &mut reference, &answers, depth, report);
}
