//! All peers against the reference, each to its own accuracy.

use linkage_peers::differences::Differences1;
use linkage_peers::textbook::{self, Method};
use linkage_peers::{c, dual, mechanisms as m, newton, plain, reference};
use std::f64::consts::TAU;

/// Compares numbers of the size of some tens over the cycle.
fn agree<const N: usize>(
    name: &str,
    limit: f64,
    exact: &[Vec<reference::Exact>],
    mut theirs: impl FnMut(f64) -> [f64; N],
) {
    let mut worst = 0.0;
    for (phi, exact) in angles().zip(exact) {
        for (index, (exact, found)) in exact.iter().zip(theirs(phi)).enumerate() {
            let error = exact.distance(found, 0.0);
            worst = f64::max(worst, error);
            let expected = exact.value();
            assert!(
                error < limit,
                "{name}: {index} at {phi}: {expected}, found {found}"
            );
        }
    }
    println!("{name}: {worst:e}");
}

fn angles() -> impl Iterator<Item = f64> {
    (0..48).map(|step| TAU * f64::from(step) / 24.0 - 1.5)
}

fn collect<R: Into<Vec<reference::Exact>>>(f: impl Fn(f64) -> R) -> Vec<Vec<reference::Exact>> {
    angles().map(|phi| f(phi).into()).collect()
}

/// From far off, so with more iterations than elsewhere.
fn newton_agrees<U: newton::Unknowns>(
    dimensions: [f64; 7],
    predicts: bool,
    [points, motions, sensitivities]: [&[Vec<reference::Exact>]; 3],
) {
    let start = || newton::Newton::<U>::new(dimensions, 6, predicts, -1.5);
    let (mut a, mut b, mut c) = (start(), start(), start());
    agree("newton, a", 1e-11, points, |phi| a.point(phi));
    agree("newton, b", 1e-11, motions, |phi| b.motion(phi));
    agree("newton, c", 1e-11, sensitivities, |phi| c.accuracy(phi));
}

#[test]
fn k1() {
    let mechanism = m::K1::default();
    let linkage = mechanism.assemble().expect("K1 assembles");
    let dimensions = m::dimensions1(&mechanism);
    let exact = reference::k1(dimensions);
    let (points, motions, sensitivities) = (
        collect(|phi| exact.point(phi)),
        collect(|phi| exact.motion(phi)),
        collect(|phi| exact.accuracy(phi)),
    );
    macro_rules! check {
        ($name:literal, $limit:expr, $peer:expr) => {
            let peer = $peer;
            agree(concat!($name, ", a"), $limit, &points, |phi| {
                peer.point(phi).into()
            });
            agree(concat!($name, ", b"), $limit, &motions, |phi| {
                peer.motion(phi).into()
            });
            agree(concat!($name, ", c"), $limit, &sensitivities, |phi| {
                peer.accuracy(phi).into()
            });
        };
    }
    check!("generated", 1e-11, linkage);
    check!("dual", 1e-11, dual::K1::new(dimensions));
    check!(
        "arc cosine",
        1e-10,
        textbook::K1::new(Method::ArcCosine, dimensions)
    );
    check!(
        "half tangent",
        1e-10,
        textbook::K1::new(Method::HalfTangent, dimensions)
    );
    let plain = plain::K1::new(dimensions);
    agree("plain Rust, a", 1e-11, &points, |phi| {
        plain.point(&plain.place(phi))
    });
    agree("plain Rust, b", 1e-11, &motions, |phi| {
        plain.motion(&plain.place(phi))
    });
    agree("plain Rust, c", 1e-11, &sensitivities, |phi| {
        plain.accuracy(&plain.place(phi))
    });
    for predicts in [false, true] {
        newton_agrees::<newton::Angles>(dimensions, predicts, [&points, &motions, &sensitivities]);
        newton_agrees::<newton::Vector>(dimensions, predicts, [&points, &motions, &sensitivities]);
    }
    let differences = Differences1::new(&mechanism).expect("all of them assemble");
    agree("differences, b", 1e-5, &motions, |phi| {
        differences.motion(phi)
    });
    agree("differences, c", 1e-7, &sensitivities, |phi| {
        differences.accuracy(phi)
    });
    let c = c::K1::new(dimensions);
    agree("C, a", 1e-11, &points, |phi| {
        into([0.0; 2], |out| c.point(phi, out))
    });
    agree("C, b", 1e-11, &motions, |phi| {
        into([0.0; 6], |out| c.motion(phi, out))
    });
    agree("C, c", 1e-11, &sensitivities, |phi| {
        into([0.0; 16], |out| c.accuracy(phi, out))
    });
}

#[test]
fn k2() {
    let mechanism = m::K2::default();
    let linkage = mechanism.assemble().expect("K2 assembles");
    let dimensions = m::dimensions2(&mechanism);
    let exact = reference::k2(dimensions);
    let (points, motions, sensitivities) = (
        collect(|phi| exact.point(phi)),
        collect(|phi| exact.motion(phi)),
        collect(|phi| exact.accuracy(phi)),
    );
    agree("generated, a", 1e-11, &points, |phi| {
        linkage.point(phi).into()
    });
    agree("generated, b", 1e-11, &motions, |phi| {
        linkage.motion(phi).into()
    });
    agree("generated, c", 1e-11, &sensitivities, |phi| {
        linkage.accuracy(phi).into()
    });
    let dual = dual::K2::new(dimensions);
    agree("dual, a", 1e-11, &points, |phi| dual.point(phi));
    agree("dual, b", 1e-11, &motions, |phi| dual.motion(phi));
    agree("dual, c", 1e-11, &sensitivities, |phi| dual.accuracy(phi));
    let c = c::K2::new(dimensions);
    agree("C, a", 1e-11, &points, |phi| {
        into([0.0; 2], |out| c.point(phi, out))
    });
    agree("C, b", 1e-11, &motions, |phi| {
        into([0.0; 6], |out| c.motion(phi, out))
    });
    agree("C, c", 1e-11, &sensitivities, |phi| {
        into([0.0; 26], |out| c.accuracy(phi, out))
    });
}

/// What a function writes.
fn into<const N: usize>(mut out: [f64; N], write: impl FnOnce(&mut [f64; N])) -> [f64; N] {
    write(&mut out);
    out
}

/// A sweep's columns against single calls.
fn same<const N: usize>(
    sweep: impl FnOnce(&[f64], &mut c::sweep::Columns),
    single: impl Fn(f64, &mut [f64; N]),
) {
    let angles: Vec<f64> = angles().collect();
    let mut columns = c::sweep::Columns::new(N, angles.len());
    sweep(&angles, &mut columns);
    for (row, &phi) in angles.iter().enumerate() {
        let expected = into([0.0; N], |out| single(phi, out));
        for (column, expected) in expected.into_iter().enumerate() {
            let found = columns.get(row, column);
            assert!(
                (found - expected).abs() < 1e-11,
                "{column}: {expected}, {found}"
            );
        }
    }
}

#[test]
fn sweeps_in_c() {
    let one = c::K1::new(m::dimensions1(&m::K1::default()));
    let two = c::K2::new(m::dimensions2(&m::K2::default()));
    same(|x, to| one.point_sweep(x, to), |x, out| one.point(x, out));
    same(|x, to| one.motion_sweep(x, to), |x, out| one.motion(x, out));
    same(
        |x, to| one.accuracy_sweep(x, to),
        |x, out| one.accuracy(x, out),
    );
    same(|x, to| two.point_sweep(x, to), |x, out| two.point(x, out));
    same(|x, to| two.motion_sweep(x, to), |x, out| two.motion(x, out));
    same(
        |x, to| two.accuracy_sweep(x, to),
        |x, out| two.accuracy(x, out),
    );
}
