//! The kernels in space: generated code against C, which was derived in another way, and sweeps in C against
//! its single calls.

use linkage_peers::c::space as c;
use linkage_peers::c::sweep::Columns;
use linkage_peers::space::{K3, K4, dimensions3, dimensions4};
use std::f64::consts::TAU;

const POSITIONS: usize = 48;

/// Numbers of some tens: they agree to this.
const LIMIT: f64 = 2e-11;

fn same<const N: usize>(name: &str, rows: impl IntoIterator<Item = [[f64; N]; 2]>) {
    let mut worst = 0.0_f64;
    for (position, [ours, theirs]) in rows.into_iter().enumerate() {
        for (index, (ours, theirs)) in ours.into_iter().zip(theirs).enumerate() {
            let error = (ours - theirs).abs() / theirs.abs().max(100.0) * 100.0;
            worst = worst.max(error);
            assert!(
                error < LIMIT,
                "{name}, position {position}, number {index}: {ours} and {theirs}"
            );
        }
    }
    println!("{name}: {worst:e}");
}

fn column(columns: &Columns, row: usize) -> impl FnMut(usize) -> f64 {
    move |number| columns.get(row, number)
}

macro_rules! check {
    ($linkage:ident $c:ident $function:ident $sweep:ident $count:literal $($inputs:ident)*) => {
        let single = |i: usize| {
            let mut out = [0.0; $count];
            $c.$function($($inputs[i],)* &mut out);
            out
        };
        let ours = |i: usize| <[f64; $count]>::from($linkage.$function($($inputs[i]),*));
        same(stringify!($c $function), (0..POSITIONS).map(|i| [ours(i), single(i)]));
        let mut columns = Columns::new($count, POSITIONS);
        $c.$sweep($(&$inputs,)* &mut columns);
        same(
            stringify!($c $sweep),
            (0..POSITIONS).map(|i| [std::array::from_fn(column(&columns, i)), single(i)]),
        );
    };
}

#[test]
fn k3() {
    let mechanism = K3::default();
    let linkage = mechanism.assemble().expect("K3 assembles");
    let c = c::K3::new(dimensions3(&mechanism));
    let phi: [f64; POSITIONS] = std::array::from_fn(|i| TAU * i as f64 / 24.0 - 1.5);
    check!(linkage c point point_sweep 3 phi);
    check!(linkage c motion motion_sweep 11 phi);
    check!(linkage c accuracy accuracy_sweep 27 phi);
}

#[test]
fn k4() {
    let mechanism = K4::default();
    let linkage = mechanism.assemble().expect("K4 assembles");
    let c = c::K4::new(dimensions4(&mechanism));
    let [x, y, z] = [1, 17, 29].map(|step| {
        std::array::from_fn::<f64, POSITIONS, _>(|i| (i * step % POSITIONS) as f64 / 48.0)
    });
    check!(linkage c point point_sweep 3 x y z);
    check!(linkage c motion motion_sweep 12 x y z);
    check!(linkage c curvature curvature_sweep 39 x y z);
}
