//! Grashof's rule.

use linkage_analysis::summary::{FourBar, SummaryError, grashof};

fn kind(lengths: [f64; 4]) -> FourBar {
    let [frame, input, coupler, output] = lengths;
    grashof(frame, input, coupler, output)
        .expect("lengths")
        .kind
}

#[test]
fn kinds() {
    use FourBar::*;
    for scale in [1e-150, 1.0, 1e150] {
        let of = |lengths: [f64; 4]| kind(lengths.map(|length| scale * length));
        assert_eq!(of([100.0, 40.0, 120.0, 80.0]), CrankRocker);
        assert_eq!(of([100.0, 80.0, 120.0, 40.0]), RockerCrank);
        assert_eq!(of([40.0, 100.0, 80.0, 120.0]), DoubleCrank);
        assert_eq!(of([100.0, 80.0, 40.0, 120.0]), DoubleRocker);
        assert_eq!(of([100.0, 90.0, 120.0, 95.0]), TripleRocker);
        assert_eq!(of([100.0, 40.0, 100.0, 40.0]), ChangePoint);
        assert_eq!(of([40.0, 20.0, 30.0, 10.0]), ChangePoint);
        assert_eq!(of([100.0, 20.0, 30.0, 50.0]), NotClosable);
        assert_eq!(of([100.0, 20.0, 30.0, 40.0]), NotClosable);
    }
}

/// A four-bar's input turns fully if the diagonal, from frame less input to frame plus input, can be closed by the other two.
#[test]
fn against_the_triangle_of_the_diagonal() {
    let turns = |frame: f64, input: f64, a: f64, b: f64| {
        (frame - input).abs() > (a - b).abs() && frame + input < a + b
    };
    for code in 0..9_u32.pow(4) {
        let digit = |place: u32| f64::from(code / 9_u32.pow(place) % 9 + 1);
        let [frame, input, coupler, output] = [0, 1, 2, 3].map(digit);
        let found = (
            turns(frame, input, coupler, output),
            turns(frame, output, coupler, input),
        );
        let known = match kind([frame, input, coupler, output]) {
            FourBar::CrankRocker => (true, false),
            FourBar::RockerCrank => (false, true),
            FourBar::DoubleCrank => (true, true),
            _ => (false, false),
        };
        assert_eq!(found, known, "{frame} {input} {coupler} {output}");
    }
}

#[test]
fn sums_and_rounding() {
    // 0.1 + 0.2 is not 0.3 in binary.
    assert_eq!(kind([0.1, 0.4, 0.2, 0.3]), FourBar::ChangePoint);
    assert_eq!(kind([0.1, 0.4 - 1e-14, 0.2, 0.3]), FourBar::DoubleCrank);
    let found = grashof(100.0, 90.0, 120.0, 95.0).expect("lengths");
    assert_eq!(found.to_string(), "triple rocker: 210 > 195");
    assert_eq!(found.reserve(), -15.0);
    let error = grashof(100.0, 90.0, -1.0, 95.0);
    assert_eq!(
        error,
        Err(SummaryError::Length {
            link: "coupler",
            length: -1.0
        })
    );
    assert!(grashof(f64::NAN, 1.0, 1.0, 1.0).is_err());
}
