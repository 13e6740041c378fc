//! The problems: points, timing, bounds, and the least sums of squares that are known.

use linkage::design::{Design, DesignError, Relation, Targets, Timing};
use std::f64::consts::TAU;

use super::{FourBar, FourBarAssembly};

/// A path problem.
pub(crate) struct Problem {
    pub(crate) name: &'static str,
    pub(crate) points: &'static [[f64; 2]],
    /// The crank's angles at the points, or that they come one after the other.
    pub(crate) timing: Timing,
    /// Bounds of the four lengths.
    pub(crate) lengths: [f64; 2],
    /// Bounds of the coupler point's place on the coupler, from minus to plus.
    pub(crate) arm: f64,
    /// Bounds of the frame's place, from minus to plus; with 0 it is fixed.
    pub(crate) base: f64,
    /// The least sum that is known.
    pub(crate) known: f64,
    /// Starts with which one search finds it from every seed that was tried.
    pub(crate) starts: usize,
    /// Fewer starts, with which the search of the program's seed finds it.
    pub(crate) few: usize,
}

/// A problem of the program.
pub(crate) type FourBarDesign = Design<'static, FourBar, FourBarAssembly, 9>;

impl Problem {
    /// As a design problem.
    pub(crate) fn design(&self) -> Result<FourBarDesign, DesignError> {
        let [low, high] = self.lengths;
        let lengths = ["frame", "crank", "coupler", "rocker"];
        let targets =
            Targets::new("tracer", self.points.iter().copied()).timing(self.timing.clone());
        let mut design = Design::new(
            FourBar::default(),
            FourBar::assemble,
            FourBar::assemblies,
            FourBar::circuits,
        )?
        .hold(Relation::crank_turns(lengths, 0.0))
        .want(targets.computed_by(FourBarAssembly::path_sweep_sets_into))
        .starts(self.starts);
        for name in lengths {
            design = design.vary(name, low, high);
        }
        for name in ["arm.x", "arm.y"] {
            design = design.vary(name, -self.arm, self.arm);
        }
        if self.base > 0.0 {
            for name in ["base.x", "base.y"] {
                design = design.vary(name, -self.base, self.base);
            }
            design = design.vary("tilt", 0.0, TAU);
        }
        Ok(design)
    }
}

/// A length must not be 0: this is the least one where the literature has no bound.
const SHORTEST: f64 = 1e-3;

/// Five problems of the literature (Kunjur and Krishnamurty 1997; Cabrera and others 2002; Acharyya and Mandal 2009).
pub(crate) fn problems() -> [Problem; 5] {
    let degrees =
        |angles: &[f64]| Timing::Given(angles.iter().map(|angle| angle.to_radians()).collect());
    [
        Problem {
            name: "vertical line, 6 points",
            points: &VERTICAL,
            timing: Timing::InOrder,
            lengths: [5.0, 60.0],
            arm: 60.0,
            base: 60.0,
            known: 0.0,
            starts: 256,
            few: 64,
        },
        Problem {
            name: "5 points with their angles",
            points: &TIMED,
            timing: degrees(&[30.0, 45.0, 60.0, 75.0, 90.0]),
            lengths: [SHORTEST, 50.0],
            arm: 50.0,
            base: 0.0,
            known: 7.41575130678e-07,
            starts: 512,
            few: 64,
        },
        Problem {
            name: "18 points every 20 degrees",
            points: &EVERY_20,
            timing: Timing::Evenly(20_f64.to_radians()),
            lengths: [SHORTEST, 50.0],
            arm: 50.0,
            base: 50.0,
            known: 0.00902888463026,
            starts: 8192,
            few: 1024,
        },
        Problem {
            name: "half circle, 6 points",
            points: &HALF_CIRCLE,
            timing: Timing::InOrder,
            lengths: [5.0, 50.0],
            arm: 50.0,
            base: 50.0,
            known: 0.0,
            starts: 256,
            few: 64,
        },
        Problem {
            name: "ellipse, 10 points",
            points: &ELLIPSE,
            timing: Timing::InOrder,
            lengths: [5.0, 80.0],
            arm: 80.0,
            base: 80.0,
            known: 0.000401992054352,
            starts: 512,
            few: 128,
        },
    ]
}

const VERTICAL: [[f64; 2]; 6] = [
    [20.0, 20.0],
    [20.0, 25.0],
    [20.0, 30.0],
    [20.0, 35.0],
    [20.0, 40.0],
    [20.0, 45.0],
];

const TIMED: [[f64; 2]; 5] = [
    [3.0, 3.0],
    [2.759, 3.363],
    [2.372, 3.663],
    [1.89, 3.862],
    [1.355, 3.943],
];

const EVERY_20: [[f64; 2]; 18] = [
    [0.5, 1.1],
    [0.4, 1.1],
    [0.3, 1.1],
    [0.2, 1.0],
    [0.1, 0.9],
    [0.05, 0.75],
    [0.02, 0.6],
    [0.0, 0.5],
    [0.0, 0.4],
    [0.03, 0.3],
    [0.1, 0.25],
    [0.15, 0.2],
    [0.2, 0.3],
    [0.3, 0.4],
    [0.4, 0.5],
    [0.5, 0.7],
    [0.6, 0.9],
    [0.6, 1.0],
];

const HALF_CIRCLE: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [1.9098, 5.8779],
    [6.9098, 9.5106],
    [13.09, 9.5106],
    [18.09, 5.8779],
    [20.0, 0.0],
];

const ELLIPSE: [[f64; 2]; 10] = [
    [20.0, 10.0],
    [17.66, 15.142],
    [11.736, 17.878],
    [5.0, 16.928],
    [0.60307, 12.736],
    [0.60307, 7.2638],
    [5.0, 3.0718],
    [11.736, 2.1215],
    [17.66, 4.8577],
    [20.0, 10.0],
];
