//! The methods for each of the three questions.

use crate::double_double::DoubleDouble;
use crate::errors::{Part, SIZE};
use crate::methods::{Family, Method, Numbers, Parts, in_place, single, stepping, sweep};
use crate::{Panel, measure};
use linkage::Dual;
use linkage_peers::differences::Differences1;
use linkage_peers::mechanisms::{
    K1, K1AccuracyColumns, K1Assembly, K1MotionColumns, K1PointColumns, dimensions1,
};
use linkage_peers::newton::{self, Newton};
use linkage_peers::num_dual::{Dual2_64, DualSVec64};
use linkage_peers::textbook::{self, Method as By};
use linkage_peers::{c, dual, plain, reference};
use std::ops::Range;
use std::time::Duration;

/// What several methods need.
pub(crate) struct Kernels {
    double: K1Assembly,
    single: K1Assembly<f32>,
    extended: K1Assembly<DoubleDouble>,
    dimensions: [f64; 7],
    c: c::K1,
    plain: plain::K1,
}

impl Kernels {
    pub(crate) fn new(mechanism: &K1) -> Self {
        let dimensions = dimensions1(mechanism);
        Self {
            double: mechanism.assemble().expect("K1 assembles"),
            single: mechanism.cast().assemble().expect("K1 assembles"),
            extended: mechanism.cast().assemble().expect("K1 assembles"),
            dimensions,
            c: c::K1::new(dimensions),
            plain: plain::K1::new(dimensions),
        }
    }
}

/// What methods for derivatives need.
struct ForDerivatives {
    dual: dual::K1,
    differences: Differences1,
}

impl ForDerivatives {
    fn new(mechanism: &K1) -> Self {
        Self {
            dual: dual::K1::new(dimensions1(mechanism)),
            differences: Differences1::new(mechanism).expect("K1 assembles"),
        }
    }
}

fn halves(x: DoubleDouble) -> Parts {
    [x.0.hi(), x.0.lo()]
}

/// Newton's method by angles: the number of iterations, and whether it begins where rates lead to.
const BY_ANGLES: [(&str, usize, bool); 5] = [
    ("Newton, 1 iteration", 1, false),
    ("Newton, 2 iterations", 2, false),
    ("Newton, 3 iterations", 3, false),
    ("Newton, predicted, 1 iteration", 1, true),
    ("Newton, predicted, 2 iterations", 2, true),
];

/// The same by the coupler's vector.
const BY_VECTOR: [(&str, usize, bool); 2] = [
    ("Newton by vectors, predicted, 1", 1, true),
    ("Newton by vectors, predicted, 2", 2, true),
];

const ANGLES: [(&str, By); 2] = [
    ("acos, atan2", By::ArcCosine),
    ("half-angle tangent", By::HalfTangent),
];

/// The methods that have the same functions for every question.
macro_rules! methods {
    ($kernels:ident, $positions:ident, $function:ident, $sweep:ident, $into:ident, $columns:ident, $width:literal) => {{
        let (k, p, ours) = (&$kernels, $positions, Family::Generated);
        let mut methods: Vec<Method<'_, $width>> = vec![
            single(
                "f64",
                ours,
                p,
                |x| k.double.$function(x),
                |r| r.row().numbers(),
            ),
            sweep(
                "f64, sweep",
                ours,
                p,
                |x| x,
                $columns::<f64>::new(),
                |x, columns| k.double.$into(x, columns),
                |columns, i| columns.get(i).row(),
            ),
            single(
                "f32",
                ours,
                p,
                |x| k.single.$function(x as f32),
                |r| r.row().map(f64::from).numbers(),
            ),
            sweep(
                "f32, sweep",
                ours,
                p,
                |x| x as f32,
                $columns::<f32>::new(),
                |x, columns| k.single.$into(x, columns),
                |columns, i| columns.get(i).row().map(f64::from),
            ),
            single(
                "double-double",
                ours,
                p,
                |x| k.extended.$function(DoubleDouble(x.into())),
                |r| r.row().map(halves),
            ),
            in_place("C", Family::Closed, p, |x, row| k.c.$function(x, row)),
            sweep(
                "C, sweep",
                Family::Closed,
                p,
                |x| x,
                c::sweep::Columns::new($width, p.len()),
                |x, columns| k.c.$sweep(x, columns),
                |columns, row| std::array::from_fn(|column| columns.get(row, column)),
            ),
            single(
                "Rust, standard sine",
                Family::Closed,
                p,
                |x| k.plain.$function(&k.plain.place(x)),
                Numbers::numbers,
            ),
        ];
        for (name, method) in ANGLES {
            let textbook = textbook::K1::new(method, k.dimensions);
            let answer = move |x| textbook.$function(x);
            methods.push(single(name, Family::Textbook, p, answer, Numbers::numbers));
        }
        let start = p[0];
        for (name, iterations, predicts) in BY_ANGLES {
            let newton = Newton::<newton::Angles>::new(k.dimensions, iterations, predicts, start);
            methods.push(stepping(name, Family::Newton, p, newton, |n, x| {
                n.$function(x)
            }));
        }
        for (name, iterations, predicts) in BY_VECTOR {
            let newton = Newton::<newton::Vector>::new(k.dimensions, iterations, predicts, start);
            methods.push(stepping(name, Family::Newton, p, newton, |n, x| {
                n.$function(x)
            }));
        }
        methods
    }};
}

/// The methods that have derivatives only; `generic` computes the point in dual numbers.
macro_rules! others {
    ($needs:ident, $positions:ident, $function:ident, $generic:ident) => {{
        let (k, p) = (&$needs, $positions);
        let closed = |x| k.dual.$function(x);
        let steps = |x| k.differences.$function(x);
        [
            single(
                "dual numbers, generated point",
                Family::Dual,
                p,
                $generic,
                |r| dual::$function([r.tracer.x.0, r.tracer.y.0]).numbers(),
            ),
            single(
                "dual numbers, closed form",
                Family::Dual,
                p,
                closed,
                Numbers::numbers,
            ),
            single(
                "differences",
                Family::Differences,
                p,
                steps,
                Numbers::numbers,
            ),
        ]
    }};
}

/// The point with both derivatives.
pub(crate) fn motion(positions: &[f64], time: Duration) -> Panel {
    let k = Kernels::new(&K1::default());
    let needs = ForDerivatives::new(&K1::default());
    let mechanism = K1::default().cast::<Dual<Dual2_64>>();
    let generic = mechanism.assemble().expect("K1 assembles");
    let point = |phi| generic.point(Dual(Dual2_64::from_re(phi).derivative()));
    let mut methods = methods!(
        k,
        positions,
        motion,
        motion_sweep,
        motion_sweep_into,
        K1MotionColumns,
        6
    );
    methods.extend(others!(needs, positions, motion, point));
    let parts = [
        POINT,
        part("first derivative", 2..4, SIZE),
        part("second derivative", 4..6, SIZE),
    ];
    let reference = reference::k1(k.dimensions);
    let exact = positions.iter().map(|&phi| reference.motion(phi).to_vec());
    let exact: Vec<_> = exact.collect();
    measure(
        "The point with both derivatives",
        &parts,
        methods,
        &exact,
        time,
    )
}

/// The point alone, of any mechanism.
pub(crate) fn points<'a>(k: &'a Kernels, positions: &'a [f64]) -> Vec<Method<'a, 2>> {
    methods!(
        k,
        positions,
        point,
        point_sweep,
        point_sweep_into,
        K1PointColumns,
        2
    )
}

/// The point alone.
pub(crate) fn point(positions: &[f64], time: Duration) -> Panel {
    let k = Kernels::new(&K1::default());
    let methods = points(&k, positions);
    let reference = reference::k1(k.dimensions);
    let exact = positions.iter().map(|&phi| reference.point(phi).to_vec());
    let exact: Vec<_> = exact.collect();
    measure("The point alone", &[POINT], methods, &exact, time)
}

/// The point with its sensitivities.
pub(crate) fn accuracy(positions: &[f64], time: Duration) -> Panel {
    let k = Kernels::new(&K1::default());
    let needs = ForDerivatives::new(&K1::default());
    let generic = variable_mechanism(k.dimensions)
        .assemble()
        .expect("K1 assembles");
    let point = |phi| generic.point(Dual(DualSVec64::from_re(phi)));
    let mut methods = methods!(
        k,
        positions,
        accuracy,
        accuracy_sweep,
        accuracy_sweep_into,
        K1AccuracyColumns,
        16
    );
    methods.extend(others!(needs, positions, accuracy, point));
    let parts = [
        POINT,
        part("by a length", 2..14, 1.0),
        part("by the angle", 14..16, SIZE),
    ];
    let reference = reference::k1(k.dimensions);
    let exact: Vec<_> = positions
        .iter()
        .map(|&phi| reference.accuracy(phi))
        .collect();
    measure(
        "The point with 7 sensitivities",
        &parts,
        methods,
        &exact,
        time,
    )
}

/// The mechanism with its dimensions as independent variables.
fn variable_mechanism(dimensions: [f64; 7]) -> K1<Dual<DualSVec64<7>>> {
    let [crank, coupler, rocker, x, y, arm, lift] = dual::variables(dimensions).map(Dual);
    let pivot_d = linkage::Vector2::new(x, y);
    K1 {
        crank,
        coupler,
        rocker,
        pivot_d,
        arm,
        lift,
    }
}

const POINT: Part = part("point", 0..2, SIZE);

const fn part(name: &'static str, range: Range<usize>, size: f64) -> Part {
    Part { name, range, size }
}
