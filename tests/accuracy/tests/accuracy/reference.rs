//! The reference itself, against figures known from elsewhere.

use linkage_reference::{Big, Plane, Position, Reference, System, Unknown, data};

const FOUR_BAR: System = System {
    name: "four-bar",
    data: data! {
        length "crank" 40.0, "coupler" 120.0, "rocker" 80.0, "frame" 100.0;
        degrees "phi" 40.0;
    },
    parameters: 4,
    unknowns: &[Unknown::angle("theta", 20.0), Unknown::angle("psi", 57.0)],
    residual: |p| {
        let frame = Plane {
            x: p.value("frame").clone(),
            y: Big::zero(),
        };
        let closure = p.polar("crank", "phi") + p.polar("coupler", "theta")
            - p.polar("rocker", "psi")
            - frame;
        vec![closure.x, closure.y]
    },
    gap: |_: &Position| Big::one(),
    margin: Some(|_| linkage_reference::Big::one()),
    ..System::PLAIN
};

fn data() -> Vec<f64> {
    FOUR_BAR.data.iter().map(|datum| datum.default).collect()
}

#[test]
fn both_assembly_modes() {
    let open = Reference::new(&FOUR_BAR, &data(), &[0.35, 1.0]).expect("assembles");
    let crossed = Reference::new(&FOUR_BAR, &data(), &[-1.06, -1.7]).expect("assembles");
    let degrees = [&open, &crossed].map(|r| [0, 1].map(|k| r.value(k).to_degrees()));
    let expected = [[20.297883, 57.324880], [-60.977967, -98.004964]];
    for (found, expected) in degrees.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < 1e-6, "{found}");
    }
    assert!((open.determinant() + crossed.determinant()).abs() < 1e-15);
    assert!(
        (open.determinant().abs() - (57.324880f64 - 20.297883).to_radians().sin()).abs() < 1e-7
    );
}

#[test]
fn sensitivities_of_the_rocker() {
    let mut open = Reference::new(&FOUR_BAR, &data(), &[0.35, 1.0]).expect("assembles");
    let expected = [-0.0195423394, -0.0207575246, 0.0165718082, 0.0194685187];
    for (p, expected) in expected.into_iter().enumerate() {
        let found = open.derivative(&[p])[1].to_f64();
        assert!((found - expected).abs() < 1e-10, "{found}");
    }
}

/// Velocities by the formulas of the four-bar, and Taylor's theorem for the higher derivatives.
#[test]
fn derivatives_by_the_input() {
    let mut here = Reference::new(&FOUR_BAR, &data(), &[0.35, 1.0]).expect("assembles");
    let [theta, psi] = [0, 1].map(|k| here.value(k));
    let rate = 40.0 * (data()[4] - theta).sin() / (80.0 * (psi - theta).sin());
    assert!((here.derivative(&[4])[1].to_f64() - rate).abs() < 1e-15);
    let step = 1e-3;
    let mut moved = data();
    moved[4] += step;
    let there = Reference::new(&FOUR_BAR, &moved, &[0.35, 1.0]).expect("assembles");
    let exact = moved[4] - data()[4];
    let mut series = psi;
    let mut power = 1.0;
    for order in 1..=4 {
        power *= exact / order as f64;
        series += here.derivative(&vec![4; order])[1].to_f64() * power;
    }
    assert!(
        (there.value(1) - series).abs() < 2e-15,
        "{:e}",
        there.value(1) - series
    );
}

/// The same mixed derivative by differences of whole first derivatives over a wide step.
#[test]
fn mixed_derivatives() {
    let mut here = Reference::new(&FOUR_BAR, &data(), &[0.35, 1.0]).expect("assembles");
    let mixed = here.derivative(&[4, 1])[1].to_f64();
    assert_eq!(here.derivative(&[1, 4])[1].to_f64(), mixed);
    let rate = |coupler: f64| {
        let mut data = data();
        data[1] = coupler;
        let mut there = Reference::new(&FOUR_BAR, &data, &[0.35, 1.0]).expect("assembles");
        there.derivative(&[4])[1].to_f64()
    };
    let step = 2f64.powi(-16);
    let difference = (rate(120.0 + step) - rate(120.0 - step)) / (2.0 * step);
    assert!(
        (difference - mixed).abs() < 1e-9 * mixed.abs(),
        "{difference} {mixed}"
    );
}

/// Steps of 1e-36 leave more than 50 digits: the sums of Euler's theorem vanish to that many.
#[test]
fn fifty_digits() {
    let mut here = Reference::new(&FOUR_BAR, &data(), &[0.35, 1.0]).expect("assembles");
    for also in [vec![], vec![4], vec![4, 4]] {
        let mut sum = Big::zero();
        for (p, length) in data()[..4].iter().enumerate() {
            let by: Vec<usize> = also.iter().copied().chain([p]).collect();
            sum = sum + here.derivative(&by)[1].clone() * *length;
        }
        assert!(sum.abs() < Big::from(1e-55), "{:e}", sum.to_f64());
    }
}

#[test]
fn extreme_scales() {
    for scale in [1e-150, 1e150] {
        let mut data = data();
        data[..4].iter_mut().for_each(|length| *length *= scale);
        let mut here = Reference::new(&FOUR_BAR, &data, &[0.35, 1.0]).expect("assembles");
        assert!((here.value(1).to_degrees() - 57.324880).abs() < 1e-6);
        let by_crank = here.derivative(&[0])[1].to_f64() * scale;
        assert!((by_crank + 0.0195423394).abs() < 1e-10);
    }
}
