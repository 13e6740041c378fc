//! The errors of one position.

use crate::report::{Errors, Program};
use crate::{Answers, Big, Depth, Kind, Measure, ROUNDOFF, Reference, Report, System};

type Found = [(Program, Answers)];

pub(crate) fn must_be_nan(answers: &Found, data: &[f64], report: &mut Report) {
    for (program, a) in answers {
        let flat = [&a.values, &a.first, &a.second, &a.third]
            .into_iter()
            .flatten();
        // A derivative by a dimension that the quantity does not contain is zero everywhere.
        let lists = [&a.sensitivity, &a.mixed, &a.mixed_second, &a.pairs];
        let nested = lists.into_iter().flatten().flatten().filter(|x| **x != 0.0);
        let mut all = flat.chain(nested).chain([&a.margin]);
        if let Some(number) = all.find(|x| !x.is_nan()) {
            report.fail(|| format!("{program}: {number} where it cannot be assembled: {data:?}"));
        }
    }
}

/// Errors of lengths and coordinates by the size of the mechanism, which is that of its longest
/// length (of numbers by 1), and by the condition number.
pub(crate) fn compare_positions(
    system: &System,
    reference: &mut Reference,
    answers: &Found,
    data: &[f64],
    report: &mut Report,
) {
    let lengths = (0..reference.outputs()).filter(|&k| reference.is_length(k));
    let size = lengths.fold(system.size(data), |size, k| {
        size.max(reference.value(k).abs())
    });
    let turned = system.turned_at(&reference.data);
    let roundoff = Big::from(ROUNDOFF) * turned;
    let of_lengths = &roundoff * size;
    let conditions = reference.conditions();
    for (program, a) in answers {
        if a.values.len() != reference.outputs() {
            report.fail(|| format!("{program}: {} outputs", a.values.len()));
            continue;
        }
        for (k, &x) in a.values.iter().enumerate() {
            if reference.is_angle(k) {
                continue;
            }
            let unit = if reference.is_length(k) {
                &of_lengths
            } else {
                &roundoff
            };
            let raw = ratio(x, &reference.error(k, x), unit);
            let conditioned = raw / conditions[k];
            let errors = Errors {
                raw: raw * turned,
                conditioned,
                alone: conditioned,
            };
            report.add(*program, Measure::Position, errors, || {
                format!("output {k} = {x:e} at {data:?}")
            });
        }
    }
}

pub(crate) fn compare_margin(
    reference: &Reference,
    answers: &Found,
    data: &[f64],
    report: &mut Report,
) {
    let Some((expected, uncertainty)) = reference.margin() else {
        return;
    };
    for (program, a) in answers {
        let error = (&expected - &Big::from(a.margin)).abs();
        let conditioned = ratio(a.margin, &error, &uncertainty);
        let errors = Errors {
            raw: ratio(a.margin, &error, &Big::from(ROUNDOFF)),
            conditioned,
            alone: conditioned,
        };
        report.add(*program, Measure::Margin, errors, || {
            format!(
                "margin {:e}, expected {:e} at {data:?}",
                a.margin,
                expected.to_f64()
            )
        });
    }
}

type Computed<'a> = &'a dyn Fn(&Answers) -> Option<Vec<f64>>;

pub(crate) fn compare_derivatives(
    system: &System,
    reference: &mut Reference,
    answers: &Found,
    depth: Depth,
    report: &mut Report,
) {
    let x = system.input();
    let full = depth == Depth::Full;
    let position = report.positions;
    let mut one = |measure, by: &[usize], computed: Computed| {
        compare_one(reference, answers, report, measure, by, computed);
    };
    one(Measure::Value, &[], &|a| Some(a.values.clone()));
    one(Measure::First, &[x], &|a| Some(a.first.clone()));
    if !full && position % 3 != 1 {
        return;
    }
    one(Measure::Second, &[x, x], &|a| Some(a.second.clone()));
    for p in 0..system.parameters {
        one(Measure::Sensitivity, &[p], &|a| {
            a.sensitivity.get(p).cloned()
        });
    }
    if !full {
        return;
    }
    one(Measure::Third, &[x, x, x], &|a| Some(a.third.clone()));
    for p in 0..system.parameters {
        one(Measure::Mixed, &[x, p], &|a| a.mixed.get(p).cloned());
        // These take half of the time.
        if position % 4 == 1 {
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
    answers: &Found,
    report: &mut Report,
    measure: Measure,
    by: &[usize],
    computed: Computed,
) {
    let alone = reference.uncertainty(by);
    let joint = reference.joint_uncertainty(by);
    let sizes = sizes(reference, by);
    let exact = if by.is_empty() {
        Vec::new()
    } else {
        reference.derivative(by)
    };
    for (program, a) in answers {
        for (k, &number) in computed(a).unwrap_or_default().iter().enumerate() {
            let error = match exact.get(k) {
                Some(exact) => (exact - &Big::from(number)).abs(),
                None => reference.error(k, number),
            };
            let in_unit = |unit: &Big| ratio(number, &error, unit);
            // An angle that counts many turns is rounded as a whole, however little it changes with what it is computed from.
            let own = match by {
                [] if number.is_finite() => Big::from(number.abs()) * ROUNDOFF,
                _ => Big::zero(),
            };
            let errors = Errors {
                raw: in_unit(&(&sizes[k] * ROUNDOFF)),
                conditioned: in_unit(&joint[k].clone().max(&own)),
                alone: in_unit(&alone[k].clone().max(&own)),
            };
            report.add(*program, measure, errors, || {
                format!(
                    "output {k} by {by:?} = {number:e} at {:?}",
                    reference.given()
                )
            });
        }
    }
}

/// How large quantities are: the largest one of the same kind (of a length, of an angle or
/// number), at least that of a mechanism that grows as a whole or turns with the input.
fn sizes(reference: &mut Reference, by: &[usize]) -> Vec<Big> {
    let system = reference.system;
    let size = Big::from(system.size(&reference.given()));
    let divisor = by.iter().fold(Big::one(), |product, &index| {
        if system.data[index].kind == Kind::Length {
            product * &size
        } else {
            product
        }
    });
    let derivative = reference.derivative(by);
    let magnitude = |k: usize| match by {
        [] => Big::from(reference.value(k)).abs(),
        _ => derivative[k].abs(),
    };
    let of_kind = |length: bool| {
        let least = if length { size.clone() } else { Big::one() } / &divisor;
        (0..reference.outputs())
            .filter(|&k| reference.is_length(k) == length)
            .fold(least, |largest, k| largest.max(&magnitude(k)))
    };
    let [lengths, numbers] = [of_kind(true), of_kind(false)];
    (0..reference.outputs())
        .map(|k| {
            if reference.is_length(k) {
                lengths.clone()
            } else {
                numbers.clone()
            }
        })
        .collect()
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
