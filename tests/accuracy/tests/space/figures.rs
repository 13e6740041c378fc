//! Figures known from elsewhere: the reference against them, and the programs.

use crate::rssr::RSSR;
use linkage_accuracy::Reference;

/// Input and both solutions of `psi`, its first and second derivative, in degrees and radians.
const RSSR_FIGURES: [(f64, [[f64; 3]; 2]); 2] = [
    (
        60.0,
        [
            [76.04048544635, 0.3580596926249, 0.745059650552],
            [-67.83038355607, -0.9335941527843, 0.472932088408],
        ],
    ),
    (
        200.0,
        [
            [149.8851105343, 0.2025347350933, -0.479806988609],
            [-98.54348523532, 0.4057311345574, 0.367678291596],
        ],
    ),
];

/// Asserts that an angle and its derivatives are those given, to the digits that are given.
#[track_caller]
fn agree(found: [f64; 3], expected: [f64; 3]) {
    for ((found, expected), digits) in found.into_iter().zip(expected).zip([1e-10, 1e-12, 2e-11]) {
        assert!((found - expected).abs() < digits, "{found} {expected}");
    }
}

#[test]
fn rssr_of_the_reference() {
    for (theta, solutions) in RSSR_FIGURES {
        for expected in solutions {
            let data = [
                1.0,
                5.0,
                3.0,
                0.0,
                4.0,
                1.0,
                0.5,
                50f64.to_radians(),
                0.0,
                f64::to_radians(theta),
            ];
            let start = [(expected[0] + 1.0).to_radians()];
            let mut found = Reference::new(&RSSR, &data, &start).expect("assembles");
            let value = found.value(0).to_degrees();
            let [first, second] = [vec![9], vec![9, 9]].map(|by| found.derivative(&by)[0].to_f64());
            agree([value, first, second], expected);
        }
    }
}
