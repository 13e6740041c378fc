//! Compares programs with the reference.

use crate::standing::{Standing, standing};
use crate::{Answers, Big, Measure, ROUNDOFF, Reference, Report, System, solve};

/// A program at one geometry: input in, answers out.
pub type Evaluate = Box<dyn Fn(f64) -> Answers>;

/// One written form of the mechanism.
#[derive(Clone, Copy)]
pub struct Form {
    /// Its name in the report.
    pub name: &'static str,
    /// Assembles it for a geometry (all data but the input); the error as text.
    pub assemble: fn(&[f64]) -> Result<Evaluate, String>,
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
}

/// Compares all forms with the reference in all cases.
pub fn compare(system: &System, forms: &[Form], cases: &[Case]) -> Report {
    let mut report = Report::default();
    let mode = default_mode(system);
    for case in cases {
        let programs = assemble(system, forms, &case.geometry, &mut report);
        for &input in &case.inputs {
            if !programs.is_empty() {
                let data: Vec<f64> = case.geometry.iter().copied().chain([input]).collect();
                compare_position(system, &programs, &data, mode, &mut report);
            }
        }
    }
    report
}

type Program = (&'static str, Evaluate);

fn assemble(
    system: &System,
    forms: &[Form],
    geometry: &[f64],
    report: &mut Report,
) -> Vec<Program> {
    let data: Vec<f64> = geometry
        .iter()
        .copied()
        .chain([system.reference_input()])
        .collect();
    let standing = standing(system, &data);
    let mut programs = Vec::new();
    for form in forms.iter().filter(|form| (form.fits)(geometry)) {
        match ((form.assemble)(geometry), &standing) {
            (Ok(_), Standing::Apart) => report.fail(|| {
                format!(
                    "{}: assembled although it cannot be: {geometry:?}",
                    form.name
                )
            }),
            (Ok(evaluate), _) => programs.push((form.name, evaluate)),
            (Err(why), Standing::Closed) => {
                report.fail(|| format!("{}: not assembled: {why}: {geometry:?}", form.name));
            }
            (Err(_), _) => {}
        }
    }
    programs
}

/// The sign of the determinant in the assembly mode that the estimates choose.
fn default_mode(system: &System) -> f64 {
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
    programs: &[Program],
    data: &[f64],
    mode: f64,
    report: &mut Report,
) {
    let input = data[system.input()];
    let answers = programs
        .iter()
        .map(|(name, evaluate)| (*name, evaluate(input)));
    let answers: Vec<(&'static str, Answers)> = answers.collect();
    match standing(system, data) {
        Standing::DeadPoint => return,
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
    compare_values(system, &reference, &answers, data, report);
    compare_margin(system, &reference, &answers, data, report);
    compare_derivatives(system, &mut reference, &answers, data, report);
}

fn must_be_nan(answers: &[(&'static str, Answers)], data: &[f64], report: &mut Report) {
    for (form, a) in answers {
        let flat = [&a.values, &a.first, &a.second, &a.third]
            .into_iter()
            .flatten();
        // A derivative by a dimension that the quantity does not contain is zero everywhere.
        let lists = [&a.sensitivity, &a.mixed, &a.mixed_second, &a.pairs];
        let nested = lists.into_iter().flatten().flatten().filter(|x| **x != 0.0);
        let mut all = flat.chain(nested).chain([&a.margin]);
        if let Some(number) = all.find(|x| !x.is_nan()) {
            report.fail(|| format!("{form}: {number} where it cannot be assembled: {data:?}"));
        }
    }
}

fn compare_values(
    system: &System,
    reference: &Reference,
    answers: &[(&'static str, Answers)],
    data: &[f64],
    report: &mut Report,
) {
    let lengths = (0..reference.outputs()).filter(|&k| !reference.is_angle(k));
    let size = lengths.fold(system.size(data), |size, k| {
        size.max(reference.value(k).abs())
    });
    let size = size * ROUNDOFF;
    let condition = 1.0 / reference.determinant().abs();
    for (form, a) in answers {
        if a.values.len() != reference.outputs() {
            report.fail(|| format!("{form}: {} outputs", a.values.len()));
            continue;
        }
        for (k, &x) in a.values.iter().enumerate() {
            if reference.is_angle(k) {
                continue;
            }
            let error = ratio(x, &reference.error(k, x), &Big::from(size));
            let place = || format!("output {k} = {x:e} at {data:?}");
            report.add(form, Measure::Size, [error; 2], place);
            report.add(form, Measure::Condition, [error / condition; 2], place);
        }
    }
}

fn compare_margin(
    system: &System,
    reference: &Reference,
    answers: &[(&'static str, Answers)],
    data: &[f64],
    report: &mut Report,
) {
    if !system.margin {
        return;
    }
    let (expected, uncertainty) = reference.margin();
    for (form, a) in answers {
        let error = ratio(
            a.margin,
            &(&expected - &Big::from(a.margin)).abs(),
            &uncertainty,
        );
        report.add(form, Measure::Margin, [error; 2], || {
            format!(
                "margin {:e}, expected {:e} at {data:?}",
                a.margin,
                expected.to_f64()
            )
        });
    }
}

fn compare_derivatives(
    system: &System,
    reference: &mut Reference,
    answers: &[(&'static str, Answers)],
    data: &[f64],
    report: &mut Report,
) {
    let x = system.input();
    // These take half of the time.
    let thorough = report.positions % 4 == 1;
    let mut one = |measure, by: &[usize], computed: &dyn Fn(&Answers) -> Option<Vec<f64>>| {
        compare_one(reference, answers, data, report, measure, by, computed);
    };
    one(Measure::Value, &[], &|a| Some(a.values.clone()));
    one(Measure::First, &[x], &|a| Some(a.first.clone()));
    one(Measure::Second, &[x, x], &|a| Some(a.second.clone()));
    one(Measure::Third, &[x, x, x], &|a| Some(a.third.clone()));
    for p in 0..system.parameters {
        one(Measure::Sensitivity, &[p], &|a| {
            a.sensitivity.get(p).cloned()
        });
        one(Measure::Mixed, &[x, p], &|a| a.mixed.get(p).cloned());
        if thorough {
            one(Measure::MixedSecond, &[x, x, p], &|a| {
                a.mixed_second.get(p).cloned()
            });
        }
    }
    for (index, &(p, q)) in system.pairs.iter().enumerate() {
        one(Measure::Pair, &[p, q], &|a| a.pairs.get(index).cloned());
    }
}

fn compare_one(
    reference: &mut Reference,
    answers: &[(&'static str, Answers)],
    data: &[f64],
    report: &mut Report,
    measure: Measure,
    by: &[usize],
    computed: &dyn Fn(&Answers) -> Option<Vec<f64>>,
) {
    let alone = reference.uncertainty(by);
    let joint = reference.joint_uncertainty(by);
    let exact = if by.is_empty() {
        Vec::new()
    } else {
        reference.derivative(by)
    };
    for (form, a) in answers {
        for (k, &number) in computed(a).unwrap_or_default().iter().enumerate() {
            let error = match exact.get(k) {
                Some(exact) => (exact - &Big::from(number)).abs(),
                None => reference.error(k, number),
            };
            let errors = [&joint, &alone].map(|unit| ratio(number, &error, &unit[k]));
            report.add(form, measure, errors, || {
                format!("output {k} by {by:?} = {number:e} at {data:?}")
            });
        }
    }
}

/// `error / unit`; infinite for a computed number that is not one, zero for no error of no
/// uncertainty.
fn ratio(computed: f64, error: &Big, unit: &Big) -> f64 {
    if !computed.is_finite() {
        f64::INFINITY
    } else if error.is_zero() {
        0.0
    } else if unit.is_zero() {
        f64::INFINITY
    } else {
        (error / unit).to_f64()
    }
}
