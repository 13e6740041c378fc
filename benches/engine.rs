//! Sweeps of mechanisms that are compiled at run time against those of the macro, in turn, on one core:
//! `cargo bench -p linkage-benches --bench engine`. The goal is ten times the macro's.
//!
//! Both fill columns that are there, and give the same numbers to the last bit.

use std::hint::black_box;
use std::time::Duration;

use linkage_engine::{Columns, Mechanism, Table, compile};
use linkage_peers::mechanisms as m;
use linkage_peers::timing::{Candidate, interleave, only_tested};

/// The mechanisms as text: the file in which the macro reads them.
const TEXT: &str = include_str!("peers/src/mechanisms.rs");

/// Positions in one sweep.
const POSITIONS: usize = 1024;

/// Positions in a sweep whose columns are not kept near the processor, as those of Python are.
const MANY: usize = 1_000_000;

/// Sweeps in one run.
const REPEATS: usize = 16;

/// The most that the engine may take of the macro's time.
const GOAL: f64 = 10.0;

fn main() {
    let time = Duration::from_millis(if only_tested() { 1 } else { 2500 });
    let all = compile("mechanisms.rs", TEXT).expect("the macro has compiled them");
    let named = |name: &str| -> &Mechanism {
        let mut named = all.iter().filter(|mechanism| mechanism.name() == name);
        named.next().expect("it is in the file")
    };
    let turn = |count: usize| -> Vec<f64> {
        let step = std::f64::consts::TAU / count as f64;
        (0..count).map(|index| index as f64 * step).collect()
    };
    let (phi, many) = (turn(POSITIONS), turn(MANY));
    let (k1, k2) = (m::K1::default(), m::K2::default());
    let (k1, k2) = (
        k1.assemble().expect("K1 assembles"),
        k2.assemble().expect("K2 assembles"),
    );

    macro_rules! kernels {
        ($($kernel:literal $name:literal $linkage:ident $function:ident $sweep:ident $sweep_into:ident;)*) => {$({
            let mechanism = named($name);
            let assembly = mechanism.assemble(&mechanism.dimensions()).expect("it assembles");
            let number = mechanism.function(stringify!($function)).expect("it has the function");
            let (mut columns, mut own) = ($linkage.$sweep(&phi), Columns::default());
            let mut long = $linkage.$sweep(&many);
            assembly.sweep_into(number, &[&phi], &mut own);
            for column in 0..own.heading().columns.len() {
                let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
                assert_eq!(bits(columns.column(column)), bits(own.column(column)), "{} {column}", $kernel);
            }
            let times = interleave(
                vec![
                    Candidate::new("macro", POSITIONS * REPEATS, || {
                        for _ in 0..REPEATS {
                            $linkage.$sweep_into(black_box(&phi), &mut columns);
                            black_box(&columns);
                        }
                    }),
                    Candidate::new("engine", POSITIONS * REPEATS, || {
                        for _ in 0..REPEATS {
                            assembly.sweep_into(number, &[black_box(&phi)], &mut own);
                            black_box(&own);
                        }
                    }),
                    Candidate::new("macro, many", MANY, || {
                        $linkage.$sweep_into(black_box(&many), &mut long);
                        black_box(&long);
                    }),
                ],
                time,
            );
            let [macros, engine, many] = [&times[0], &times[1], &times[2]];
            println!(
                "{}  macro {:.2} ns  engine {:.2} ns  ratio {:.2}  (goal {GOAL})  macro at {MANY:.0e} {:.2} ns",
                $kernel,
                macros.spread(),
                engine.spread(),
                engine.ratio(macros),
                many.spread()
            );
        })*};
    }
    kernels!(
        "K1a" "K1" k1 point point_sweep point_sweep_into;
        "K1b" "K1" k1 motion motion_sweep motion_sweep_into;
        "K1c" "K1" k1 accuracy accuracy_sweep accuracy_sweep_into;
        "K2a" "K2" k2 point point_sweep point_sweep_into;
        "K2b" "K2" k2 motion motion_sweep motion_sweep_into;
        "K2c" "K2" k2 accuracy accuracy_sweep accuracy_sweep_into;
    );
}
