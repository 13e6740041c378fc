use super::super::path_trace::Trace;
use super::super::projective::ProjectivePoint;
use super::ReachedEnd;
use crate::numeric::complex::{Complex, ZERO};

#[test]
fn ends_count_if_roundings_move_them_less_than_they_are_apart() {
    let point = |re: f64| ProjectivePoint {
        x: [Complex::new(re, 0.0), ZERO],
        flipped: [false; 2],
    };
    let traces: [Trace<2>; 0] = [];
    let root = |moved: f64, apart: f64| {
        let found = [(0, 0.0, moved), (1, apart, 0.0)];
        let found = found.map(|(path, re, moved)| ReachedEnd {
            path,
            point: point(re),
            moved,
        });
        found[0].root(&traces, &found)
    };
    let reach = root(1e-5, 1e-3).expect("it is steady").reach;
    assert!(reach > 1e-5 && reach < 1e-3);
    assert!(root(5e-4, 1e-3).is_none());
    // Two paths to the same place, or to places that numbers hardly tell.
    assert!(root(0.0, 0.0).is_none() && root(0.0, 1e-15).is_none());
}
