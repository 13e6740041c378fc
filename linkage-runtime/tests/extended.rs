//! Arguments of sweeps that are computed from others.

use linkage_runtime::Columns;
use linkage_runtime::support::{Arguments, Extended, Inputs, Kernel, States, fill};

/// Twice an argument, and minus its square.
struct Twice;

impl States<f64, 1, 2> for Twice {
    fn fill<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        [x]: &[[f64; B]; 1],
        vectors: usize,
        [twice, minus]: &mut [[f64; B]; 2],
    ) {
        for lane in 0..vectors * V {
            twice[lane] = 2.0 * x[lane];
            minus[lane] = -x[lane] * x[lane];
        }
    }
}

/// The sum of three arguments, and the last one.
struct Sum;

impl Kernel<f64, 3, 2> for Sum {
    const WIDE: bool = true;

    fn evaluate<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        arguments: &impl Arguments<f64, 3>,
        start: usize,
        columns: [&mut [f64]; 2],
    ) {
        let len = columns[0].len();
        let mut row = 0;
        while row < len {
            let first = row.min(len - V);
            let mut block = [[0.0; V]; 3];
            arguments.block::<FUSED, V, V>(start + first, V, &mut block);
            for lane in 0..V {
                columns[0][first + lane] = block.iter().map(|column| column[lane]).sum();
                columns[1][first + lane] = block[2][lane];
            }
            row += V;
        }
    }
}

#[test]
fn rows_become_longer() {
    for len in [0, 1, 7, 8, 9, 31, 32, 33, 41, 1000] {
        let x: Vec<f64> = (0..len).map(f64::from).collect();
        let inner = Inputs {
            title: "sums",
            names: ["x"],
            slices: [&x[..]],
        };
        let extended = Extended {
            inner,
            first: 0,
            states: Twice,
        };
        let mut columns = Columns::new(2, 0);
        fill(&Sum, &extended, &mut columns);
        assert_eq!(columns.len(), x.len());
        for (row, x) in x.iter().enumerate() {
            assert_eq!(columns.get(row, 0), 3.0 * x - x * x);
            assert_eq!(columns.get(row, 1), -x * x);
        }
    }
}
