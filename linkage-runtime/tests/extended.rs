//! Arguments of sweeps that are computed from others.

use linkage_runtime::ResultRow;
use linkage_runtime::support::{
    AssemblyData, Block, FinishedRows, Function, FunctionNames, RunStages, Stage, StageData,
    StageRow, Staged, States, sweep,
};

/// Twice an argument, and minus its square.
struct Twice;

impl States<f64, (), 1, 3> for Twice {
    fn extend<const FUSED: bool>((): &(), [x]: [f64; 1]) -> [f64; 3] {
        [x, 2.0 * x, -x * x]
    }

    fn fill<const FUSED: bool, const V: usize, const B: usize>(
        (): &(),
        arguments: &[[f64; B]],
        vectors: usize,
        states: &mut [[f64; B]],
    ) {
        let ([x], [twice, minus]) = (arguments, states) else {
            panic!("one argument and two states");
        };
        for lane in 0..vectors * V {
            twice[lane] = 2.0 * x[lane];
            minus[lane] = -x[lane] * x[lane];
        }
    }
}

/// Data of an assembly that nothing is prepared for.
#[derive(Clone, Copy)]
struct Nothing;

impl StageData<f64> for Nothing {}

/// The sum of three arguments, and the last one.
struct Sum;

impl Staged<f64, Nothing, 3, 2> for Sum {
    const WIDE: bool = true;
    type Memory<const B: usize> = Block<f64, B, 0>;

    fn run(stages: &mut impl RunStages<f64, Nothing, Self>) {
        stages.stage::<0>();
    }
}

impl Stage<f64, Nothing, 0> for Sum {
    fn row<const FUSED: bool, const ROWS: bool>(_: &Nothing, row: &mut impl StageRow<f64>) {
        let [x, twice, minus] = [0, 1, 2].map(|k| row.number(k));
        row.finish(0, x + twice + minus);
        row.finish(1, minus);
    }

    fn write(rows: &mut impl FinishedRows) {
        rows.write(0);
        rows.write(1);
    }
}

/// The result of the function of the test.
struct Sums([f64; 2]);

impl ResultRow<f64, 2> for Sums {
    fn from_row(row: [f64; 2]) -> Self {
        Self(row)
    }

    fn to_row(&self) -> [f64; 2] {
        self.0
    }
}

impl Function<f64, Nothing, (), 1, 3, 2> for Sums {
    type Called = Sum;
    type Refining = Sum;
    type States = Twice;
    const NAMES: &'static FunctionNames<1> = &FunctionNames {
        function: "sums",
        arguments: ["x"],
    };
}

#[test]
fn rows_become_longer() {
    let data = AssemblyData::new(Nothing, ());
    for len in [0, 1, 7, 8, 9, 31, 32, 33, 41, 1000] {
        let x: Vec<f64> = (0..len).map(f64::from).collect();
        let columns = sweep::<f64, Nothing, (), Sums, 1, 3, 2>(&data, [&x]);
        assert_eq!(columns.len(), x.len());
        for (row, x) in x.iter().enumerate() {
            assert_eq!(columns.get(row).0, [3.0 * x - x * x, -x * x]);
        }
    }
}
