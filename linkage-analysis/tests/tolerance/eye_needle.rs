//! Published figures of a real mechanism from recorded sensitivities.

use linkage_analysis::tolerance::{Extreme, Tolerances, largest_at};
use linkage_runtime::Parameter;

use super::near;

/// Lengths with their tolerances in um.
const LENGTHS: [(&str, f64, f64); 12] = [
    ("l12", 50.0, 12.0),
    ("l23", 272.5, 26.0),
    ("l34", 81.0, 17.0),
    ("l45", 104.5, 17.0),
    ("l35", 174.0, 20.0),
    ("l46", 104.5, 17.0),
    ("l57", 261.0, 26.0),
    ("l78", 136.8, 20.0),
    ("X6", 195.0, 23.0),
    ("Y6", 226.0, 23.0),
    ("X7", 46.0, 12.0),
    ("Y7", 533.0, 35.0),
];

/// The parameters in the order of the record: the angle is between the lengths.
pub(crate) fn parameters() -> [Parameter; 13] {
    let mut parameters = LENGTHS.map(|(name, nominal, tolerance)| Parameter {
        name,
        unit: "mm",
        nominal,
        tolerance: 1e-3 * tolerance,
    });
    let arm = Parameter {
        name: "U578",
        unit: "rad",
        nominal: (-25.0_f64).to_radians(),
        tolerance: (30.0_f64 / 3600.0).to_radians(),
    };
    std::array::from_fn(|i| match i {
        0..8 => parameters[i],
        8 => arm,
        _ => std::mem::replace(&mut parameters[i - 1], arm),
    })
}

/// Angles in degrees with the sensitivities there.
pub(crate) fn record() -> Vec<(f64, [[f64; 2]; 13])> {
    let text = include_str!("data/eye_needle.txt");
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines
        .map(|line| {
            let numbers: Vec<f64> = line
                .split(' ')
                .map(|x| x.parse().expect("a number"))
                .collect();
            let row = std::array::from_fn(|i| [numbers[1 + 2 * i], numbers[2 + 2 * i]]);
            (numbers[0], row)
        })
        .collect()
}

type Effects = linkage_analysis::tolerance::Effects<13, 2>;

fn over_cycle(relative: bool, figure: fn(&Effects) -> f64) -> Extreme {
    let tolerances = Tolerances::<13>::complete(&parameters()).expect("all are given");
    let record = record();
    let start = tolerances.effects(&record[0].1);
    let angles: Vec<f64> = record.iter().map(|(angle, _)| *angle).collect();
    let mut rows = record.iter();
    let in_micrometres = |_| {
        let (_, row) = rows.next().expect("a row for each angle");
        let effects = tolerances.effects(row);
        1e3 * figure(&if relative {
            effects.relative_to(&start)
        } else {
            effects
        })
    };
    largest_at(&angles, in_micrometres).expect("all are assembled")
}

#[test]
fn the_published_error_is_the_algebraic_sum() {
    let found = over_cycle(false, |e| e.algebraic_sum()[0].abs());
    near(found.value, 17.577, 1e-3);
    assert_eq!((found.at, found.missing), (51.9, 0));
}

#[test]
fn true_limits_are_larger() {
    near(over_cycle(false, |e| e.worst_case()[0]).value, 91.70, 1e-2);
    near(
        over_cycle(false, Effects::worst_modulus).value,
        111.42,
        1e-2,
    );
    near(
        over_cycle(false, |e| e.root_sum_square()[0]).value,
        29.59,
        1e-2,
    );
    near(
        over_cycle(false, Effects::root_sum_square_modulus).value,
        50.42,
        1e-2,
    );
}

/// Against sums over the record made by another program.
#[test]
fn relative_to_the_start() {
    let found = over_cycle(true, |e| e.worst_case()[0]);
    near(found.value, 41.7, 0.05);
    near(over_cycle(true, Effects::worst_modulus).value, 50.6, 0.05);
    let tolerances = Tolerances::<13>::complete(&parameters()).expect("all are given");
    let start = tolerances.effects(&record()[0].1);
    assert_eq!(start.relative_to(&start).worst_modulus(), 0.0);
}

#[test]
fn tables() {
    let tolerances = Tolerances::<13>::complete(&parameters()).expect("all are given");
    let (_, row) = record()[10];
    let text = tolerances.effects(&row).to_string();
    for word in [
        "algebraic sum",
        "worst case",
        "root sum square",
        "U578",
        "modulus",
        "%",
    ] {
        assert!(text.contains(word), "{text}");
    }
    assert!(tolerances.to_string().starts_with("l12 = 50 +- 0.012 mm\n"));
}
