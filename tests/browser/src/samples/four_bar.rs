//! A four-bar with a ternary coupler, which need not turn fully.

use linkage_report::{Report, SummaryRow};
use linkage_runtime::{
    AssemblyMode, Column, Dimensions, FunctionInfo, Group, Heading, Meaning, Operations, Parameter,
    Picture, Structure,
};
use std::f64::consts::{FRAC_PI_6, TAU};

use super::pictures::{FOUR_BAR, drawn};
use super::sheet::{PHI, Sheet, column, shown, slope};

/// Its lengths; pivots at the origin and on the x-axis.
#[derive(Clone, Copy, Debug)]
pub struct FourBar {
    /// Driven.
    pub crank: f64,
    /// Between the moving joints.
    pub coupler: f64,
    /// About the other pivot.
    pub rocker: f64,
    /// Between the pivots.
    pub frame: f64,
    /// From the crank's end to the tracer.
    pub arm: f64,
}

impl FourBar {
    /// A crank-rocker.
    pub const TURNING: Self = Self {
        crank: 50.0,
        coupler: 120.0,
        rocker: 100.01,
        frame: 140.0,
        arm: 70.0,
    };

    /// It comes apart over a part of the turn.
    pub const SWINGING: Self = Self {
        crank: 110.0,
        coupler: 60.0,
        rocker: 75.0,
        frame: 140.0,
        arm: 70.0,
    };

    /// End of the crank, end of the rocker, tracer; NaN where the links do not meet.
    #[must_use]
    pub fn points(&self, phi: f64) -> [[f64; 2]; 3] {
        let a = [self.crank * phi.cos(), self.crank * phi.sin()];
        let d = [self.frame - a[0], -a[1]];
        let length = d[0].hypot(d[1]);
        let cosine = (self.coupler.powi(2) + length.powi(2) - self.rocker.powi(2))
            / (2.0 * self.coupler * length);
        let theta = d[1].atan2(d[0]) + cosine.acos();
        let at =
            |length: f64, angle: f64| [a[0] + length * angle.cos(), a[1] + length * angle.sin()];
        // Where the tracer is, is not known unless the links meet: theta is NaN there.
        [a, at(self.coupler, theta), at(self.arm, theta + FRAC_PI_6)]
    }

    fn motion(&self, phi: f64) -> [f64; 3] {
        let [_, b, tracer] = self.points(phi);
        [tracer[0], tracer[1], b[1].atan2(b[0] - self.frame)]
    }

    fn by_parameter(&self, phi: f64) -> [f64; 10] {
        let values = self.values();
        std::array::from_fn(|i| {
            let (parameter, component) = (i / 2, i % 2);
            let tracer = |value: f64| {
                let mut changed = values;
                changed[parameter] = value;
                let motion = Self::from_values(&changed).motion(phi);
                [motion[component]]
            };
            slope(tracer, values[parameter], 1e-4)[0]
        })
    }
}

const fn parameter(name: &'static str, nominal: f64, tolerance: f64) -> Parameter {
    Parameter {
        name,
        unit: "mm",
        nominal,
        tolerance,
    }
}

impl Dimensions<5> for FourBar {
    const PARAMETERS: &'static [Parameter] = &[
        parameter("crank", 50.0, 0.012),
        parameter("coupler", 120.0, 0.02),
        parameter("rocker", 100.0, 0.02),
        parameter("frame", 140.0, 0.0),
        parameter("arm", 70.0, 0.05),
    ];

    fn from_values(&[crank, coupler, rocker, frame, arm]: &[f64; 5]) -> Self {
        Self {
            crank,
            coupler,
            rocker,
            frame,
            arm,
        }
    }

    fn values(&self) -> [f64; 5] {
        [self.crank, self.coupler, self.rocker, self.frame, self.arm]
    }
}

const fn rate(name: &'static str, unit: &'static str, order: u32, of: usize) -> Column {
    column(
        name,
        unit,
        Meaning::Rate {
            order,
            of: Some(of),
        },
    )
}

const fn by(name: &'static str, parameter: usize, of: usize) -> Column {
    column(
        name,
        "mm/mm",
        Meaning::Sensitivity {
            parameter,
            of: Some(of),
        },
    )
}

const MOTION: Heading = Heading {
    function: "motion",
    arguments: &["phi"],
    columns: &[
        column("tracer.x", "mm", Meaning::Value),
        column("tracer.y", "mm", Meaning::Value),
        column("psi", "rad", Meaning::Value),
        rate("v.x", "mm/rad", 1, 0),
        rate("v.y", "mm/rad", 1, 1),
        rate("omega", "rad/rad", 1, 2),
        by("e[crank].x", 0, 0),
        by("e[crank].y", 0, 1),
        by("e[coupler].x", 1, 0),
        by("e[coupler].y", 1, 1),
        by("e[rocker].x", 2, 0),
        by("e[rocker].y", 2, 1),
        by("e[frame].x", 3, 0),
        by("e[frame].y", 3, 1),
        by("e[arm].x", 4, 0),
        by("e[arm].y", 4, 1),
    ],
    picture: None,
};

static PICTURE: Picture = FOUR_BAR;

static VIEW: Heading = Heading {
    function: "view",
    arguments: &["phi"],
    columns: &[
        shown("picture[pivot_a].x", "mm"),
        shown("picture[pivot_a].y", "mm"),
        shown("picture[pivot_d].x", "mm"),
        shown("picture[pivot_d].y", "mm"),
        shown("picture[a].x", "mm"),
        shown("picture[a].y", "mm"),
        shown("picture[b].x", "mm"),
        shown("picture[b].y", "mm"),
        shown("picture[tracer].x", "mm"),
        shown("picture[tracer].y", "mm"),
    ],
    picture: drawn(&PICTURE),
};

const OPERATIONS: Operations = Operations {
    add: 21,
    mul: 34,
    div: 3,
    sqrt: 1,
    sin_cos: 1,
    atan2: 1,
    other: 0,
};

const STRUCTURE: Structure = Structure {
    mobility: 1,
    groups: &[Group {
        class: 2,
        order: 2,
        kind: "RRR",
        loops: &[1],
        joints: "",
        unknowns: &["theta", "psi"],
        mode: Some(0),
        method: "intersection of two circles, root taken for the smaller one",
    }],
    functions: &[FunctionInfo {
        name: "motion",
        operations: OPERATIONS,
    }],
    prepare: OPERATIONS,
};

/// The report about a four-bar, at whole degrees.
#[must_use]
pub fn four_bar(title: &str, mechanism: FourBar) -> Report {
    let positions: Vec<f64> = PHI.positions(361);
    let motion = Sheet::new(&MOTION, &positions, |phi| row(&mechanism, phi));
    let view = Sheet::new(&VIEW, &positions, |phi| {
        let [a, b, tracer] = mechanism.points(phi);
        [
            0.0,
            0.0,
            mechanism.frame,
            0.0,
            a[0],
            a[1],
            b[0],
            b[1],
            tracer[0],
            tracer[1],
        ]
    });
    Report::new(title, &PHI, &positions)
        .about("A crank, a rocker, and a coupler with a tracer: computed by hand.")
        .note("Sensitivities are differences.")
        .structure(&STRUCTURE)
        .modes(&[AssemblyMode::Plus])
        .dimensions(&mechanism)
        .table(&motion)
        .table(&view)
        .speed(TAU * 10.0, 0.0)
        .trace("tracer")
        .summary([
            SummaryRow::new("psi", "reference", mechanism.motion(1.0)[2], "rad").at_input(1.0),
        ])
        .fact("made by", "a test with <b>letters</b> & signs </script>")
}

fn row(mechanism: &FourBar, phi: f64) -> [f64; 16] {
    let values = mechanism.motion(phi);
    let rates = slope(|phi| mechanism.motion(phi), phi, 1e-5);
    let errors = mechanism.by_parameter(phi);
    let mut all = [0.0; 16];
    all[..3].copy_from_slice(&values);
    all[3..6].copy_from_slice(&rates);
    all[6..].copy_from_slice(&errors);
    all
}
